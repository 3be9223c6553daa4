"""Moosmüller & Dyn 2018, Increasing the smoothness of vector and Hermite subdivision schemes, section 5."""

from fractions import Fraction

import pytest
from matrix_masks import (
    HERMITE_CUBIC,
    HERMITE_QUINTIC,
    UNSEEN,
    conjugated,
    de_rham,
    hermite_interpolation,
    merrien,
    product,
    scheme,
    smoothed_jets,
    sum_of,
)

from subdiv_cli.catalog import masks_directory
from subdiv_cli.exact.text import number
from subdiv_cli.kinds.hermite.numbers import HermiteNumbers
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.kinds.smoothing import smoothing_steps
from subdiv_cli.model import Effort, Smoothness, Verdict
from subdiv_cli.model.closed import spelled
from subdiv_cli.pipeline import check, check_steps
from subdiv_cli.report.json import as_data
from subdiv_cli.report.look import Look

DE_RHAM = de_rham(HERMITE_CUBIC)


def answer(mask, arity=2):
    return check(scheme(mask, arity, "hermite"), (), Effort()).result


def finding(result, code):
    (found,) = (each for each in result.findings if each.code == code)
    return found


def shifts(mask, arity=2):
    """The numbers φ_1, φ_2, … of the spectral condition."""
    return HermiteNumbers(scheme(mask, arity, "hermite"), Effort()).jets.shifts[1:]


def entries(mask, row, column):
    """An entry of the symbol, exponent -> coefficient."""
    found = {i: Fraction(a[row][column]) for i, a in mask.items()}
    return {i: x for i, x in found.items() if x}


def z(**powers):
    """A Laurent polynomial in z^-1: d2=x is x z^-2, u1=x is x z."""
    return {(-1 if k[0] == "d" else 1) * int(k[1:]): Fraction(x) for k, x in powers.items()}


def scaled(factor, *factors):
    return {i: x for i, x in product({0: Fraction(factor)}, *factors).items() if x}


def test_example_44():
    """C*(z) coefficient for coefficient."""
    c = smoothed_jets(HERMITE_CUBIC)
    once = z(d1=1, d0=1)
    assert entries(c, 0, 0) == scaled("1/16", once, once, z(d2=-1, d1=1, d0=6, u1=2))
    assert entries(c, 0, 1) == scaled("1/16", z(u1=-1, d0=-1))
    assert entries(c, 1, 0) == scaled("1/16", z(d2=1, d0=-1), z(d4=1, d3=-3, d2=-3, d1=13, d0=6))
    assert entries(c, 1, 1) == scaled("1/16", z(d2=1, d1=-3, d0=3, u1=1))
    assert (min(c), max(c)) == (-6, 1)


def test_example_45():
    """The de Rham transform has the printed mask, and C*(z) coefficient for coefficient."""
    eighths = {i: [[8 * x for x in row] for row in a] for i, a in DE_RHAM.items()}
    assert eighths == {
        -2: [[Fraction(5, 4), Fraction(-3, 8)], [Fraction(9, 2), Fraction(-5, 4)]],
        -1: [[Fraction(27, 4), Fraction(-9, 8)], [Fraction(9, 2), Fraction(3, 4)]],
        0: [[Fraction(27, 4), Fraction(9, 8)], [Fraction(-9, 2), Fraction(3, 4)]],
        1: [[Fraction(5, 4), Fraction(3, 8)], [Fraction(-9, 2), Fraction(-5, 4)]],
    }
    c = smoothed_jets(DE_RHAM)
    assert entries(c, 0, 0) == scaled("1/128", z(d1=1, d0=1), z(d4=-3, d3=-9, d2=25, d1=75, d0=36, u1=4))
    assert entries(c, 0, 1) == scaled("-3/128", z(u1=1, d0=4, d1=1))
    assert entries(c, 1, 0) == scaled("1/128", z(d2=1, d0=-1), z(d5=3, d4=-7, d3=-37, d2=37, d1=128, d0=20, u1=-8))
    assert entries(c, 1, 1) == scaled("1/128", z(d3=3, d2=-7, d1=-21, d0=21, u1=-4))
    assert (min(c), max(c)) == (-7, 1)


@pytest.mark.parametrize(
    ("mask", "alphas", "supports"),
    [
        (HERMITE_CUBIC, (2, 3, 4, 5), (-1, -6, -8, -10)),
        (DE_RHAM, (2.846360099, 3.846360099, 4.846360099), (-2, -7, -9)),
    ],
    ids=["44", "45"],
)
def test_smoothing_gains_one_order_each_time(mask, alphas, supports):
    """Lemma 41: φ falls by 1/2. HC^1, HC^2, HC^3, … as α says; ζ = 1, 14/15, 31/30 and 1, 41/44."""
    phi = Fraction(0) if mask is HERMITE_CUBIC else Fraction(-1, 2)
    zetas = []
    for alpha, low in zip(alphas, supports, strict=True):
        result = answer(mask)
        assert result.convergent is Verdict.PROVED
        assert abs(result.holder.lower - alpha) < 1e-9
        assert result.holder.exact is not None
        order = int(alpha) - (alpha == int(alpha))
        assert result.smoothness == Smoothness(order, True)
        assert (shifts(mask)[0], min(mask), max(mask)) == (phi, low, 1)
        zetas.append(1 + sum(entries(mask, 0, 1).values()) / (2 - sum(entries(mask, 1, 1).values())))
        mask, phi = smoothed_jets(mask), phi - Fraction(1, 2)
    assert zetas[:3] == [1, Fraction(14, 15), Fraction(31, 30)] or zetas == [1, Fraction(41, 44), Fraction(91, 88)]


@pytest.mark.parametrize("mask", [HERMITE_CUBIC, DE_RHAM, merrien("-1/10", "-1/2"), smoothed_jets(DE_RHAM)])
def test_lemma_28(mask):
    """Conditions (1) to (4), with the primes that the scan lost in (3)."""
    at = lambda f, x: sum(c * x**i for i, c in f.items())  # noqa: E731
    slope = lambda f, x: sum(c * i * Fraction(x) ** (i - 1) for i, c in f.items())  # noqa: E731
    a11, a12, a21, a22 = (entries(mask, r, c) for r in (0, 1) for c in (0, 1))
    assert (at(a11, 1), at(a11, -1), at(a21, 1), at(a21, -1)) == (2, 0, 0, 0)
    assert slope(a11, 1) - 2 * at(a12, 1) == 2 * shifts(mask)[0]
    assert slope(a11, -1) + 2 * at(a12, -1) == 0
    assert slope(a21, 1) - 2 * at(a22, 1) == -2
    assert slope(a21, -1) + 2 * at(a22, -1) == 0


MERRIEN = [(-1, "2"), ("1/2", "log2(8/3)"), (0, "2"), ("1/4", "log2(16/5)"), (-2, "2"), ("-5/2", "log2(8/3)")]


@pytest.mark.parametrize(("mu", "alpha"), MERRIEN)
def test_merrien_family_at_1_8(mu, alpha):
    result = answer(merrien("-1/8", mu))
    assert (result.convergent, result.smoothness) == (Verdict.PROVED, Smoothness(1, True))
    assert spelled(result.holder.exact) == alpha
    assert result.facts["interpolatory"]


@pytest.mark.parametrize(("mu", "alpha"), [(1, "1"), (-3, "1"), (2, "log2(4/3)")])
def test_merrien_family_at_1_8_outside(mu, alpha):
    """σ_1 is 1/2 or more: the function component converges, its derivative does not."""
    result = answer(merrien("-1/8", mu))
    assert (result.convergent, result.spectral) == (Verdict.REFUTED, Verdict.PROVED)
    assert spelled(result.holder.exact) == alpha


@pytest.mark.parametrize(
    ("lam", "mu", "alpha"),
    [("-1/10", "-1/2", "1.564819774"), ("-1/16", "-1/2", "1.276321031"), ("-1/4", "-1/2", "1.246275106")],
)
def test_merrien_family_with_algebraic_exponents(lam, mu, alpha):
    result = answer(merrien(lam, mu))
    assert result.convergent is Verdict.PROVED
    assert round(Fraction(result.holder.digits.rstrip("…")), 9) == Fraction(alpha)
    (first,) = as_data(result, Look())["derivatives"]
    assert first["order"] == 1
    assert round(Fraction(first["holder"]["digits"].rstrip("…")), 9) == Fraction(alpha) - 1


@pytest.mark.parametrize(("components", "arity"), [(2, 2), (3, 2), (4, 2), (2, 3)])
def test_interpolation_by_polynomials(components, arity):
    """HC^(d-1), and not C^d: α = d, and jets of all polynomials of degree 2d - 1 with φ = 0."""
    mask = hermite_interpolation(components, arity)
    result = answer(mask, arity)
    assert (result.convergent, result.holder.exact) == (Verdict.PROVED, components)
    assert result.smoothness == Smoothness(components - 1, True)
    assert shifts(mask, arity) == (0,) * (2 * components - 1)
    assert result.generation == 2 * components - 1
    assert result.facts["interpolatory"]
    exponents = [(each["order"], each["holder"]["exact"]) for each in as_data(result, Look())["derivatives"]]
    assert exponents == [(j, str(components - j)) for j in range(1, components)]
    assert hermite_interpolation(3) == {i: [[Fraction(x) for x in r] for r in a] for i, a in HERMITE_QUINTIC.items()}


def test_a_missing_jet_refutes_nothing():
    """φ of (1,1,2,2,1,1)/4 is not stable; with differences of its limit stencil HC^1, α = 2, and no y_1."""
    result = answer(UNSEEN)
    assert (result.convergent, result.spectral) == (Verdict.PROVED, Verdict.REFUTED)
    assert (result.holder.exact, result.smoothness) == (2, Smoothness(1, True))
    assert finding(result, "SD715").value.exact == "1/4"
    assert result.sum_rule_order == 1


def test_constants_of_dimension_2_are_refuted():
    hat = {-1: "1/2", 0: 1, 1: "1/2"}
    result = answer({i: [[x, 0], [0, x]] for i, x in hat.items()})
    assert result.convergent is Verdict.REFUTED
    assert result.holder is None
    assert "E_A is not spanned by (1, 0)" in finding(result, "SD716").statement


def test_constants_with_a_derivative_are_refuted_and_the_function_judged():
    """Data (f, f + f'): the constant (1, 1) is reproduced, whose second component grows like 2^n."""
    result = answer(conjugated(HERMITE_CUBIC, [[1, 0], [-1, 1]], [[1, 0], [1, 1]]))
    assert result.convergent is Verdict.REFUTED
    assert result.holder.exact == 2


def test_a_derivative_that_is_0_is_refuted():
    """c = 0: y_1 = (x, 0) in a scheme whose function component is a quadratic spline."""
    result = answer({i: [[x, 0], [0, x / 4]] for i, x in enumerate(map(Fraction, ("1/4", "3/4", "3/4", "1/4")))})
    assert result.convergent is Verdict.REFUTED
    (hint,) = result.hints
    assert "zero at all levels" in hint


SOME = {
    "44": HERMITE_CUBIC,
    "45": DE_RHAM,
    "Merrien -1/10, -1/2": merrien("-1/10", "-1/2"),
    "Merrien -1/8, 1/4": merrien("-1/8", "1/4"),
}
"""Masks that procedure 40 applies to."""


@pytest.mark.parametrize("mask", SOME.values(), ids=SOME)
def test_procedure_40_is_what_smooth_does(mask):
    """Formula (43), four times over, with its ζ; lemma 41 and corollary 42."""
    phi = shifts(mask)[0]
    for step in smoothing_steps(scheme(mask, kind="hermite"), 4):
        zeta = 1 + sum(entries(mask, 0, 1).values()) / (2 - sum(entries(mask, 1, 1).values()))
        smooth, phi = smoothed_jets(mask), phi - Fraction(1, 2)
        assert step.scheme == scheme(smooth, kind="hermite")
        assert step.details == f"ζ = {number(zeta)}, φ = {number(phi)}"
        assert shifts(smooth)[0] == phi
        assert min(mask) - 5 <= min(smooth)
        assert max(smooth) <= max(mask)
        mask = smooth


@pytest.mark.parametrize(
    ("name", "zetas"),
    [("hermite_cubic", ("1", "14/15", "31/30")), ("de_rham_cubic", ("1", "41/44", "91/88"))],
)
def test_examples_44_and_45_in_the_catalog(name, zetas):
    """The shipped mask is what `smooth` makes of the other one, coefficient for coefficient."""
    one, two = (read_path(masks_directory() / "hermite" / f"{n}.toml").scheme() for n in (name, f"{name}_smoothed"))
    steps = smoothing_steps(one, 3)
    assert steps[0].scheme == two
    assert tuple(step.details.split(",")[0] for step in steps) == tuple(f"ζ = {zeta}" for zeta in zetas)


@pytest.mark.parametrize("mask", SOME.values(), ids=SOME)
def test_the_taylor_scheme(mask):
    """(31) to (34), the Taylor conditions of definition 30, and α - 1 (theorem 34)."""
    (step,) = smoothing_steps(scheme(mask, kind="hermite"), 1, inverse=True)
    assert (step.scheme.kind, step.orders) == ("vector", -1)
    b = dict(enumerate(step.scheme.coefficients, step.scheme.start))
    once, twice = z(d1=1, d0=1), z(d2=1, d0=-1)
    b11, b12, b21, b22 = (entries(b, r, c) for r in (0, 1) for c in (0, 1))
    a11, a12, a21, a22 = (scaled(2, entries(mask, r, c)) for r in (0, 1) for c in (0, 1))
    assert product(twice, b21) == a21
    assert sum_of(b22, scaled(-1, b21)) == a22
    assert product(once, sum_of(b11, b21)) == a11
    assert sum_of(b12, b22, scaled(-1, b11), scaled(-1, b21)) == product(z(d1=1, d0=-1), a12)
    at = lambda f, x: sum(c * x**i for i, c in f.items())  # noqa: E731
    assert (at(b12, 1), at(b12, -1), at(b22, 1), at(b22, -1), at(b11, 1) + at(b21, 1)) == (0, 0, 2, 0, 2)
    before, after = check_steps(scheme(mask, kind="hermite"), [step], Effort())
    assert abs(before.holder.lower - 1 - after.holder.lower) < 1e-12
    assert after.smoothness.order == before.smoothness.order - 1
