"""The Gram sequence and the sign of its symbol: known splines, the unimodular rule, floats, masks made unstable."""

from fractions import Fraction

import numpy as np
import pytest
from support import cases, multivariate_scheme, seeded, shipped_answer, shipped_multivariate
from test_multivariate_float import NAMES, subdivided_deltas

from subdiv_cli.checker import check_document
from subdiv_cli.kinds.multivariate.numbers.gram import gram_sequence, positive_tree, torsion_zero
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.pipeline import check
from subdiv_cli.spaces.lattice import Lattice

EFFORT = Effort()
COUNTEREXAMPLES = {name for name in NAMES if "/" in name}
CONVERGENT = sorted(set(NAMES) - COUNTEREXAMPLES)


def gram_of(scheme):
    return gram_sequence(scheme, Lattice(scheme.dilation), EFFORT)


def times(f, g):
    product = {}
    for x, p in f.items():
        for y, q in g.items():
            at = tuple(i + j for i, j in zip(x, y, strict=True))
            product[at] = product.get(at, 0) + p * q
    return {at: x for at, x in product.items() if x}


def made_unstable(scheme, direction, n):
    """The mask of φ + … + φ(· - (n-1)θ), dilation 2I, n odd: times (1 + z^n)/(1 + z), z = z^θ."""
    alternating = {tuple(i * x for x in direction): Fraction((-1) ** i) for i in range(n)}
    return MultivariateScheme(dilation=scheme.dilation, terms=times(scheme.terms, alternating))


def test_the_bilinear_spline():
    """The product of 1/6, 2/3, 1/6."""
    g = gram_of(shipped_multivariate("bilinear"))
    ends = {-1: Fraction(1, 6), 0: Fraction(2, 3), 1: Fraction(1, 6)}
    assert g == {(i, j): ends[i] * ends[j] for i in ends for j in ends}
    assert positive_tree(g, EFFORT) == (-1, 1, -1, -1, -1, 1, -1, -1)


def test_the_symbol_of_loops_spline():
    """Its least value is at 2π(1/3, 1/3): Σ g_α over the class 0 of α_1 + α_2 modulo 3 minus that over another."""
    g = gram_of(shipped_multivariate("loop"))
    zero, one, two = (sum(x for alpha, x in g.items() if sum(alpha) % 3 == i) for i in range(3))
    assert one == two
    assert zero - one == Fraction(43, 2240)
    grid = np.zeros((48, 48))
    for (i, j), x in g.items():
        grid[i % 48, j % 48] += float(x)
    assert np.fft.fft2(grid).real.min() == pytest.approx(43 / 2240)


@pytest.mark.parametrize("name", CONVERGENT)
def test_it_is_that_of_the_subdivided_delta(name):
    """m^-L Σ a^[L]_β a^[L]_(β - M^L α), in floats, for the largest L that is not too large."""
    scheme = shipped_multivariate(name)
    g = gram_of(scheme)
    *_, last = ((n, box) for n, box in enumerate(subdivided_deltas(scheme), 1))
    n, box = last
    moved = np.linalg.matrix_power(np.array(scheme.dilation), n)
    m = Lattice(scheme.dilation).index
    for alpha, exact in list(g.items())[:: max(1, len(g) // 12)]:
        shift = moved @ np.array(alpha)
        here = tuple(slice(max(0, x), min(size, size + x)) for x, size in zip(shift, box.shape, strict=True))
        there = tuple(slice(max(0, -x), min(size, size - x)) for x, size in zip(shift, box.shape, strict=True))
        if all(part.start < part.stop for part in here):
            assert abs((box[here] * box[there]).sum() / m**n - float(exact)) < 0.05, alpha
        else:
            assert abs(float(exact)) < 1e-3


@pytest.mark.parametrize("name", CONVERGENT)
def test_it_agrees_with_the_rules_on_box_splines_and_interpolation(name):
    answer = shipped_answer(name)
    found = MultivariateNumbers(shipped_multivariate(name), EFFORT).gram
    assert found is not None
    assert (found.zero is None) == (answer.stable is Verdict.PROVED)
    assert (found.tree is not None) == (answer.stable is Verdict.PROVED)


@pytest.mark.parametrize("name", ["butterfly", "interpolatory_from_loop", "tensor_four_point"])
@pytest.mark.parametrize(("direction", "n"), [((1, 0), 3), ((0, 1), 5), ((1, 1), 3)])
def test_masks_made_unstable_are_refuted(name, direction, n):
    """φ + φ(· - θ) + …: its symbol is zero where e^(iθ·ω) is a root of unity of order n."""
    scheme = made_unstable(shipped_multivariate(name), direction, n)
    checked = check(scheme, (), Effort(2000))
    assert checked.result.convergent is Verdict.PROVED
    assert checked.result.stable is Verdict.REFUTED
    assert checked.document is not None
    assert check_document(checked.document).verified
    finding = next(f for f in checked.result.findings if f.code == "SD616")
    assert finding.witness.get("order", n) == n  # of a tensor product a factor is refuted
    assert torsion_zero(gram_of(scheme), EFFORT) is not None
    assert positive_tree(gram_of(scheme), EFFORT) is None


def test_random_symbols_are_positive_iff_floats_say_so():
    """|p|² + ε, |p|² with p of random zeros, and what dips below zero."""
    rng = seeded(3)
    for _ in range(cases(60)):
        s = rng.choice([2, 2, 3])
        p = {tuple(rng.randrange(3) for _ in range(s)): Fraction(rng.randint(-5, 5)) for _ in range(5)}
        g = {}
        for x, u in p.items():
            for y, v in p.items():
                at = tuple(i - j for i, j in zip(x, y, strict=True))
                g[at] = g.get(at, 0) + u * v
        zero = (0,) * s
        g[zero] = g.get(zero, 0) + Fraction(rng.randint(-40, 40), 10)
        g = {at: x for at, x in g.items() if x} or {zero: Fraction(1)}
        grid = np.zeros((16,) * s)
        for at, x in g.items():
            grid[tuple(i % 16 for i in at)] += float(x)
        least = np.fft.fftn(grid).real.min()
        tree = positive_tree(g, EFFORT.limited(2000))
        if least < -1e-9:
            assert tree is None
        if tree is not None:
            assert least > 0


def test_what_is_not_seen_to_converge_is_not_decided():
    """The butterfly scheme with a weight that is too large: no φ whose Gram sequence that would be."""
    assert shipped_answer("counterexamples/butterfly_3_4").stable is Verdict.UNDECIDED


def test_a_dilation_that_is_not_isotropic():
    assert shipped_answer("anisotropic_bilinear").stable is Verdict.PROVED


def test_a_mask_near_an_unstable_one_takes_more_boxes():
    """Bilinear times 1 - z + z² with a small error: the least value of the symbol is near 0."""
    factor = {(0, 0): Fraction(1000, 1001), (1, 0): Fraction(-999, 1001), (2, 0): Fraction(1000, 1001)}
    g = gram_of(multivariate_scheme(times(shipped_multivariate("bilinear").terms, factor)))
    tree = positive_tree(g, EFFORT)
    assert tree is not None
    assert 20 < len(tree) < 400
