"""Q in several variables: the numbers of the paper, data Q p whose refinement is Q of p(M^-1 .), symmetric stencils."""

import time
from fractions import Fraction
from itertools import product
from math import comb, factorial, prod

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support import answer, findings, multivariate_scheme, shipped_answer, shipped_multivariate

from subdiv_cli.catalog import masks_directory
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.numbers.polynomials import expansion, inverse, quasi_interpolation
from subdiv_cli.kinds.multivariate.numbers.symmetries import symmetries
from subdiv_cli.kinds.multivariate.numbers.values import at_integers
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.scalar.numbers.polynomials import moments, operator
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.values import at_integers as at_integers_of_curves
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.spaces.lattice import Lattice, indices_of_degree

F = Fraction
MASKS = masks_directory() / "multivariate"
NAMES = sorted(str(file.relative_to(MASKS).with_suffix("")) for file in MASKS.rglob("*.toml"))
GENERATING = [name for name in NAMES if MultivariateNumbers(shipped_multivariate(name), Effort()).order]


def numbers(name):
    return MultivariateNumbers(shipped_multivariate(name), Effort())


def centred(scheme):
    """The same mask with its support about 0."""
    low, high = scheme.bounds()
    shift = [-(a + b) // 2 for a, b in zip(low, high, strict=True)]
    terms = {tuple(x + t for x, t in zip(alpha, shift, strict=True)): v for alpha, v in scheme.terms.items()}
    return multivariate_scheme(terms, scheme.dilation)


def about_zero(name):
    scheme = centred(shipped_multivariate(name))
    found = MultivariateNumbers(scheme, Effort())
    return quasi_interpolation(scheme, found.lattice, found.order - 1, symmetries(scheme))


HEXAGON = [(1, 0), (0, 1), (1, 1), (-1, 0), (0, -1), (-1, -1)]


def test_loop():
    """Levin 2003, (20) and the end of section 2.6."""
    found = about_zero("loop")
    assert found.degree == 3
    assert found.operator == found.centred == {(0, 0): 1, (2, 0): F(-1, 6), (1, 1): F(-1, 6), (0, 2): F(-1, 6)}
    assert found.stencil == {(0, 0): F(3, 2)} | dict.fromkeys(HEXAGON, F(-1, 12))
    assert found.moments == {(0, 0): 1, (2, 0): F(1, 3), (1, 1): F(1, 6), (0, 2): F(1, 3)}
    scheme = centred(shipped_multivariate("loop"))
    values = at_integers(scheme, Lattice(scheme.dilation))
    assert values == {(0, 0): F(1, 2)} | dict.fromkeys(HEXAGON, F(1, 12))


def test_the_ternary_loop_scheme_has_the_same_function():
    assert about_zero("loop_ternary").stencil == about_zero("loop").stencil


@pytest.mark.parametrize(("name", "s"), [("catmull_clark", 2), ("tricubic", 3)])
def test_tensor_products(name, s):
    """Of the cubic B-spline, 1 - D²/6 in each variable: the product, up to total degree 3."""
    found = about_zero(name)
    units = [tuple(int(i == j) for j in range(s)) for i in range(s)]
    assert found.operator == {(0,) * s: 1} | {tuple(2 * x for x in unit): F(-1, 6) for unit in units}
    around = [tuple(sign * x for x in unit) for unit in units for sign in (1, -1)]
    assert found.stencil == {(0,) * s: 1 + F(s, 3)} | dict.fromkeys(around, F(-1, 6))


def test_in_each_variable_q_is_that_of_the_factor():
    """Of the tensor product of the cubic B-spline and the four-point scheme, and of Doo and Sabin's."""
    assert about_zero("tensor_cubic_four_point").stencil == {(0, 0): F(4, 3), (1, 0): F(-1, 6), (-1, 0): F(-1, 6)}
    chaikin = ScalarScheme(arity=2, start=-1, coefficients=(F(1, 4), F(3, 4), F(3, 4), F(1, 4)))
    curve = ScalarNumbers(chaikin, Effort())
    q = operator(moments(at_integers_of_curves(curve, 0), 3))
    terms = {
        (i - 1, j - 1): x * y for i, x in enumerate(chaikin.coefficients) for j, y in enumerate(chaikin.coefficients)
    }
    scheme = multivariate_scheme(terms)
    found = quasi_interpolation(scheme, Lattice(scheme.dilation), 2, symmetries(scheme))
    assert found.operator == {(i, j): q[i] * q[j] for i, j in product(range(3), repeat=2) if i + j <= 2 and q[i] * q[j]}
    assert found.centre == (F(1, 2), F(1, 2))


@pytest.mark.parametrize("name", [name for name in GENERATING if "/" not in name])
def test_the_moments_are_those_of_the_values_at_the_integers(name):
    """Another route: phi at the integers, as an eigenvector."""
    found, scheme = numbers(name), shipped_multivariate(name)
    values = at_integers(scheme, found.lattice)
    for degree in range(found.order):
        for mu in indices_of_degree(found.dimension, degree):
            moment = sum(x * prod((-b) ** n for b, n in zip(beta, mu, strict=True)) for beta, x in values.items())
            assert found.quasi_interpolation.moments.get(mu, 0) == moment


def polynomials(s, degree):
    powers = [mu for j in range(degree + 1) for mu in indices_of_degree(s, j)]
    return st.lists(st.integers(-9, 9), min_size=len(powers), max_size=len(powers)).map(
        lambda c: dict(zip(powers, c, strict=True))
    )


def value(p, x):
    return sum(c * prod(map(pow, x, mu)) for mu, c in p.items())


def derivative(p, mu):
    found = {}
    for nu, c in p.items():
        if all(a >= b for a, b in zip(nu, mu, strict=True)):
            falling = prod(factorial(a) // factorial(a - b) for a, b in zip(nu, mu, strict=True))
            found[tuple(a - b for a, b in zip(nu, mu, strict=True))] = c * falling
    return found


@pytest.mark.parametrize("name", GENERATING)
@settings(max_examples=4)
@given(st.data())
def test_data_of_a_polynomial_are_refined_to_those_of_the_same_polynomial(name, data):
    """S Q p = Q p(M^-1 .) on Z^s, and Q p is also what the stencil takes, whatever converges."""
    scheme, found = shipped_multivariate(name), numbers(name)
    q, s, lattice = found.quasi_interpolation, found.dimension, found.lattice
    p = data.draw(polynomials(s, q.degree))
    turned = [(x, derivative(p, mu)) for mu, x in q.operator.items()]
    back = lattice.inverse_power(1)

    def apart(x):
        return tuple(sum(a * b for a, b in zip(row, x, strict=True)) for row in back)

    def sampled(f, x):
        return sum(t * f(tuple(a + b for a, b in zip(x, j, strict=True))) for j, t in q.stencil.items())

    def operated(x):
        return sum(c * value(dp, x) for c, dp in turned)

    for _ in range(3):
        alpha = data.draw(st.tuples(*[st.integers(-6, 6)] * s))
        assert operated(alpha) == sampled(lambda x: value(p, x), alpha)
        refined = sum(
            a * operated(beta)
            for gamma, a in scheme.terms.items()
            if (beta := lattice.preimage(tuple(x - y for x, y in zip(alpha, gamma, strict=True)))) is not None
        )
        assert refined == sampled(lambda x: value(p, apart(x)), alpha)


def kept(weights, g, centre):
    return {
        tuple(
            c + sum(x * (y - d) for x, y, d in zip(row, j, centre, strict=True))
            for row, c in zip(g, centre, strict=True)
        ): t
        for j, t in weights.items()
    }


@pytest.mark.parametrize("name", [name for name in GENERATING if name not in ("bear", "quincunx_linear")])
def test_the_stencil_has_the_symmetries_of_the_mask_that_keep_the_lattice(name):
    """About the centre; with an anisotropic dilation phi has fewer symmetries than the mask."""
    scheme, found = shipped_multivariate(name), numbers(name).quasi_interpolation
    for g in symmetries(scheme):
        moved = kept(found.stencil, g, found.centre)
        if all(x.denominator == 1 for j in moved for x in map(F, j)) and name != "anisotropic_bilinear":
            assert moved == found.stencil, g


def test_a_mask_on_a_line_has_infinitely_many_symmetries_and_its_function_has_not():
    assert len(symmetries(shipped_multivariate("bear"))) > 2
    assert numbers("bear").quasi_interpolation.stencil == {(-1, -1): F(1, 2), (0, 0): F(1, 2)}


@settings(max_examples=30)
@given(st.dictionaries(st.tuples(st.integers(0, 2), st.integers(0, 2)), st.fractions(max_denominator=9), max_size=9))
def test_series_are_inverted(h):
    h = {mu: x for mu, x in h.items() if x} | {(0, 0): F(1)}
    q = inverse(h, 2, 4)
    for mu in (mu for j in range(5) for mu in indices_of_degree(2, j)):
        terms = product(range(mu[0] + 1), range(mu[1] + 1))
        assert sum(q.get(nu, 0) * h.get((mu[0] - nu[0], mu[1] - nu[1]), 0) for nu in terms) == (mu == (0, 0))


@pytest.mark.parametrize("dilation", [((2, 0), (0, 3)), ((0, -2), (1, 1)), ((2, 1), (0, 2)), ((1, -2), (1, 0))])
def test_any_expanding_dilation(dilation):
    """h(M^T w) = H(w) h(w), with numbers, up to the degree."""
    scheme = multivariate_scheme(
        {(0, 0): F(3, 2), (1, 0): F(1, 2), (0, 1): F(1), (2, -1): F(1, 3), (1, 1): F(-1, 4)}, dilation
    )
    lattice = Lattice(dilation)
    total = sum(scheme.terms.values())
    scheme = MultivariateScheme(
        dilation=dilation, terms={alpha: x * lattice.index / total for alpha, x in scheme.terms.items()}
    )
    h, (u, v) = expansion(scheme, lattice, 4), (F(2, 7), F(-3, 5))
    (a, b), (c, d) = dilation
    turned = (a * u + c * v, b * u + d * v)
    symbol = [
        sum(x * (-(i * u + j * v)) ** n for (i, j), x in scheme.terms.items()) / (lattice.index * factorial(n))
        for n in range(5)
    ]

    def part(x, y, degree):
        return sum(z * x**i * y**j for (i, j), z in h.items() if i + j == degree)

    for n in range(5):
        assert part(*turned, n) == sum(symbol[n - i] * part(u, v, i) for i in range(n + 1))


def test_what_is_said():
    (found,) = findings(answer(centred(shipped_multivariate("loop"))), "SD619")
    assert found.verdict is Verdict.PROVED
    assert found.statement == (
        "on polynomials of total degree 3 S^∞ Q f = f with Q f = f - 1/6 f_xx - 1/6 f_xy - 1/6 f_yy, a stencil with "
        "the weights 3/2 at (0, 0); -1/12 at (-1, -1), (-1, 0), (0, -1), (0, 1), (1, 0), (1, 1)"
    )
    assert found.claims
    (found,) = findings(shipped_answer("loop"), "SD619")
    assert "Q f(α) = (f - 1/6 f_xx - 1/6 f_xy - 1/6 f_yy)(α + (2, 2)), a stencil" in found.statement
    (found,) = findings(shipped_answer("butterfly"), "SD619")
    assert found.statement == "on polynomials of total degree 3 S^∞ Q f = f with Q f = f"


def test_without_convergence_nothing_is_said():
    for name in ("counterexamples/haar", "counterexamples/loop_slip"):
        (found,) = findings(shipped_answer(name), "SD619")
        assert (found.verdict, found.reason) == (Verdict.SKIPPED, "S is not proved to converge")


def test_so_many_derivatives_are_too_many():
    """A box spline of high order under a small effort."""
    terms = {(i, j): F(comb(13, i) * comb(13, j), 4**12) for i, j in product(range(14), repeat=2)}
    result = answer(multivariate_scheme(terms), 2_000)
    (found,) = findings(result, "SD619")
    assert result.convergent is Verdict.PROVED
    assert (found.verdict, found.reason) == (Verdict.UNDECIDED, "degree 12 has too many derivatives for this effort")


def test_it_is_cheap():
    """A few milliseconds; the bound has room for a slow machine."""
    found = numbers("tricubic")
    assert found.order == 4
    assert found.symmetries
    start = time.perf_counter()
    assert found.quasi_interpolation.degree == 3
    assert time.perf_counter() - start < 1
