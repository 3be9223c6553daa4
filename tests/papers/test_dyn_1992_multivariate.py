"""N. Dyn, Subdivision schemes in computer-aided geometric design, 1992: sections 6 to 8, schemes in several variables.

The box splines after de Boor, Höllig & Riemenschneider 1993; the window after Levin & Levin 2003, Theorem 7.1.
"""

from fractions import Fraction
from itertools import islice

import numpy as np
import pytest
from support import shipped_answer, shipped_multivariate

from subdiv_cli.exact.closed import closed_interval
from subdiv_cli.kinds.multivariate.numbers.box_spline import divided, multiplied
from subdiv_cli.kinds.multivariate.numbers.directional import norms
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import Effort, Verdict

F = Fraction
BUTTERFLY = shipped_multivariate("butterfly")
BUTTERFLY_NORMS = [F(1), F(7, 8), F(11, 16), F(1, 2), F(11, 32), F(29, 128)]
ENOUGH = Effort(10**9)


def butterfly(w):
    from subdiv_cli.catalog import masks_directory

    return read_path(masks_directory() / "multivariate" / "butterfly.toml").scheme({"w": F(w)})


def quotient(w):
    """r = (1 + z1)(1 - ω q), a shift aside: a = ½ (1 + z2)(1 + z1 z2) r."""
    r = divided(divided(butterfly(w).terms, (0, 1), 2), (1, 1), 2)
    return {alpha: 2 * x for alpha, x in r.items()}


def float_norms(r, last):
    """‖S_r‖∞, …, ‖S_r^last‖∞ by convolution of arrays, another route than the exact one."""
    low = [min(column) for column in zip(*r, strict=True)]
    shape = [max(column) - x + 1 for column, x in zip(zip(*r, strict=True), low, strict=True)]
    mask = np.zeros(shape)
    for alpha, x in r.items():
        mask[tuple(i - j for i, j in zip(alpha, low, strict=True))] = float(x)
    iterated, found = np.ones((1, 1)), []
    for level in range(1, last + 1):
        step = 2 ** (level - 1)
        size = [n + step * (m - 1) for n, m in zip(iterated.shape, shape, strict=True)]
        longer = np.zeros(size)
        for (i, j), x in np.ndenumerate(mask):
            longer[step * i : step * i + iterated.shape[0], step * j : step * j + iterated.shape[1]] += x * iterated
        iterated, p = longer, 2**level
        found.append(max(np.abs(iterated[i::p, j::p]).sum() for i in range(p) for j in range(p)))
    return found


def test_the_factored_butterfly_needs_one_minus_omega_q():
    """The paper prints the factor without the sign; r is (1 + z1) times 1 - ωq, q(1, 1) = 0."""
    r = quotient(F(1, 16))
    assert sum(r.values()) == 2
    assert divided(r, (1, 0), 2) is not None
    tripled = multiplied(multiplied(r, {(0, 0): F(1, 2), (0, 1): F(1, 2)}), {(0, 0): F(1), (1, 1): F(1)})
    assert tripled == dict(BUTTERFLY.terms)


def test_norms_of_the_butterfly_at_one_sixteenth():
    """Section 8: ‖S_r^L‖∞ for L = 1, …, 6."""
    r = quotient(F(1, 16))
    assert list(islice(norms(r, 2, ENOUGH), 3)) == BUTTERFLY_NORMS[:3]
    assert float_norms(r, 6) == [float(x) for x in BUTTERFLY_NORMS]


@pytest.mark.parametrize(("w", "below"), [("0", False), ("1/1000", True), ("83/1000", True), ("1/12", False)])
def test_the_second_norm_is_below_one_up_to_one_twelfth(w, below):
    """‖S_r‖ >= 1 always, and ‖S_r²‖ < 1 exactly for 0 < ω < 1/12."""
    first, second = islice(norms(quotient(w), 2, ENOUGH), 2)
    assert first >= 1
    assert (second < 1) is below


def test_the_sixth_norm_reaches_further():
    assert float_norms(quotient("0.1156"), 6)[-1] < 1 < float_norms(quotient("0.1157"), 6)[-1]


def test_butterfly():
    """C^1 and not C^2, α = 2 exactly: V_4 has dimension 22 from the corner, 30 from the middle, and ρ_4 = 1/4."""
    numbers = MultivariateNumbers(BUTTERFLY, Effort())
    assert numbers.order == 4
    assert numbers.space.basis.nrows() == 22
    assert [m.nrows() for m in numbers.space.matrices] == [22] * 4
    result = shipped_answer("butterfly")
    assert (result.smoothness.order, result.smoothness.sharp) == (1, True)
    assert result.holder.exact == 2
    (found,) = (f for f in result.findings if f.code == "SD605")
    assert found.value.exact == "1/4"


# name: (n, α, order of the sum rules, stable, -log_λ ρ_k)
BOXES = {
    "courant": (0, 1, 2, True, 1),
    "bilinear": (0, 1, 2, True, 1),
    "box_211": (0, 1, 2, True, 1),
    "box_221": (1, 2, 3, True, 2),
    "doo_sabin": (1, 2, 3, True, 2),
    "loop": (2, 3, 4, True, 3),
    "zwart_powell": (1, 2, 2, False, 2),
    "velho_zorin": (4, 5, 4, False, 4),
    "midedge": (1, 2, 2, False, 2),
}


@pytest.mark.parametrize("name", BOXES)
def test_box_splines(name):
    """By the count of directions: C^n and no more, exponent α."""
    n, alpha, order, stable, _ = BOXES[name]
    result = shipped_answer(name)
    assert result.convergent is Verdict.PROVED
    assert (result.smoothness.order, result.smoothness.sharp) == (n, True)
    assert result.holder.exact == alpha
    assert result.sum_rule_order == order
    assert result.stable is (Verdict.PROVED if stable else Verdict.REFUTED)


@pytest.mark.parametrize("name", BOXES)
def test_the_trap(name):
    """The exact route on V_k agrees with the count; on the smallest window it would not.

    There the bilinear spline has the radius 1/4 and "is" C^1; 2-2-1 and the biquadratic spline "are" C^2.
    """
    exponent = BOXES[name][-1]
    numbers = MultivariateNumbers(shipped_multivariate(name), Effort())
    radius = numbers.radius
    length, bound = radius.upper
    m, s = numbers.lattice.index, numbers.dimension
    word = numbers.product.word
    power = numbers.product.of_word(numbers.space.matrices, word * s)
    assert power.eigenvalue.compare_modulus(F(1, m ** (exponent * len(word)))) >= 0
    assert float(bound) ** (s / length) * m**exponent <= 1 + 1e-9


def test_quincunx_interpolation():
    """α = 2 - 2 log2((1 + √5)/2)."""
    value = closed_interval(shipped_answer("quincunx_interpolatory").holder.exact)
    expected = 2 - 2 * np.log2((1 + 5**0.5) / 2)
    assert abs(expected - 0.611516) < 1e-6
    assert value.lower - 1e-12 <= expected <= value.upper + 1e-12
