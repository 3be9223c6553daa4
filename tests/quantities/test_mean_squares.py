"""The Sobolev exponent and the reproduction degree in several variables, by routes that share nothing with them."""

import json
import math
from fractions import Fraction
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.multivariate.numbers.mean_squares import autocorrelation, mean_squares
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.numbers.polynomials import reproduction, sum_rule_order
from subdiv_cli.kinds.multivariate.rules import STABILITY
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.multivariate.stages.exponents import sobolev
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.pipeline import check
from subdiv_cli.spaces.lattice import Lattice, indices_of_degree

ROOT = Path(__file__).parents[2]
ROWS = json.loads((ROOT / "tests" / "data" / "reference_multivariate.json").read_text(encoding="utf-8"))
MASKS = sorted((ROOT / "masks" / "multivariate").rglob("*.toml"))
STABLE = {"tensor_dd4", "butterfly_1/16", "butterfly_1/32", "quincunx2"}
"""Rows whose φ is stable, by interpolation, and no box spline."""


def scheme_of(row):
    terms = {tuple(map(int, key.split(","))): Fraction(value) for key, value in row["terms"].items()}
    return MultivariateScheme(dilation=tuple(map(tuple, row["dilation"])), terms=terms)


def found(scheme, stable=False):
    """The finding, as if the translates of φ were proved stable or not."""
    numbers = MultivariateNumbers(scheme, Effort())
    facts = Facts([STABILITY.proved("", {})] if stable else [])
    return sobolev(numbers, facts)[0]


def growth(scheme):
    lattice = Lattice(scheme.dilation)
    order = sum_rule_order(scheme, lattice, Effort())
    answer = mean_squares(scheme, lattice, order, Effort(200_000))
    return float(answer.growth.radius.enclosure().real.mid())


def exponent(lam, lattice):
    return -lattice.dimension * math.log(lam, lattice.index) / 2


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["id"])
def test_reference_row(row):
    scheme, s = scheme_of(row), row["truth"]["sobolev_of_limits"]
    finding = found(scheme, stable=row["id"] in STABLE)
    assert finding.verdict is Verdict.PROVED
    if finding.witness["by"] == "SD603":
        assert finding.closed == Fraction(s)
    else:
        assert finding.value.lower == pytest.approx(s, abs=1e-6)
        assert finding.statement.startswith("s = " if row["id"] in STABLE else "s ≥ ")
        assert (finding.value.upper is not None) is (row["id"] in STABLE)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("butterfly_1/16", "-log2(root(2048*x^2-40*x-1, 0.0339244, 0.0339245))/2"),
        ("tensor_dd4", "-log2(root(2048*x^2-40*x-1, 0.0339244, 0.0339245))/2"),
        ("quincunx2", "-log2(root(65536*x^5-24576*x^4-768*x^3+608*x^2-16*x-1, 0.335028, 0.335029))"),
    ],
)
def test_exact_exponents(name, text):
    row = next(row for row in ROWS if row["id"] == name)
    assert str(found(scheme_of(row), stable=True).closed) == text


def subdivided(scheme, levels, data):
    """S^levels of a finite sequence, in floats."""
    for _ in range(levels):
        refined = {}
        for beta, value in data.items():
            moved = [sum(m * b for m, b in zip(line, beta, strict=True)) for line in scheme.dilation]
            for gamma, a in scheme.terms.items():
                alpha = tuple(x + y for x, y in zip(gamma, moved, strict=True))
                refined[alpha] = refined.get(alpha, 0.0) + float(a) * value
        data = refined
    return data


def array(data):
    low = [min(x) for x in zip(*data, strict=True)]
    a = np.zeros([max(x) - y + 1 for x, y in zip(zip(*data, strict=True), low, strict=True)])
    for alpha, value in data.items():
        a[tuple(x - y for x, y in zip(alpha, low, strict=True))] = value
    return a


def squares(a, mu):
    for axis, times in enumerate(mu):
        a = np.diff(np.pad(a, [(times * (i == axis),) * 2 for i in range(a.ndim)]), times, axis)
    return float((a**2).sum())


DECAY = ["butterfly_1/16", "butterfly_1/32", "quincunx2", "bear1", "sqrt3_kobbelt", "courant", "zp"]


@pytest.mark.parametrize("name", DECAY)
def test_differences_of_the_subdivided_delta_grow_at_that_rate(name):
    """m^-L Σ |∇^μ S^L δ|² in floats, the largest over |μ| = k."""
    scheme = scheme_of(next(row for row in ROWS if row["id"] == name))
    lattice = Lattice(scheme.dilation)
    k, m = sum_rule_order(scheme, lattice, Effort()), lattice.index
    levels, between = {2: (12, 6), 3: (5, 2), 4: (5, 2)}[m]
    sizes = []
    for level in (levels - between, levels):
        a = array(subdivided(scheme, level, {(0,) * lattice.dimension: 1.0}))
        sizes.append(max(squares(a, mu) for mu in indices_of_degree(lattice.dimension, k)) / m**level)
    assert (sizes[1] / sizes[0]) ** (1 / between) == pytest.approx(growth(scheme), rel=0.03)


def closed_window(scheme, b, k):
    """The least set with |α|_1 <= k that T does not leave."""
    inverse = np.linalg.inv(np.array(scheme.dilation, dtype=float))
    s = len(scheme.dilation)
    new = {x for x in product(range(-k, k + 1), repeat=s) if sum(map(abs, x)) <= k}
    window = set()
    while new:
        window |= new
        images = np.array([np.add(x, y) for x in new for y in b]) @ inverse.T
        whole = np.abs(images - images.round()).max(axis=1) < 1e-9
        new = {tuple(map(int, x)) for x in images[whole].round()} - window
    return sorted(window)


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["id"])
def test_the_transfer_operator_in_floats(row):
    """Its spectral radius on all sequences over a window that vanish at 1 to order 2k."""
    scheme = scheme_of(row)
    lattice = Lattice(scheme.dilation)
    k, s = sum_rule_order(scheme, lattice, Effort()), lattice.dimension
    b = autocorrelation(scheme)
    window = closed_window(scheme, b, k)
    t = np.zeros((len(window), len(window)))
    for i, x in enumerate(window):
        image = [sum(p * q for p, q in zip(line, x, strict=True)) for line in scheme.dilation]
        t[i] = [float(b.get(tuple(p - q for p, q in zip(image, y, strict=True)), 0)) / lattice.index for y in window]
    scale = max(map(max, window))
    powers = [
        [math.prod((c / scale) ** e for c, e in zip(x, mu, strict=True)) for x in window]
        for degree in range(2 * k)
        for mu in indices_of_degree(s, degree)
    ]
    _, singular, rows = np.linalg.svd(np.array(powers))
    kernel = rows[int((singular > 1e-9 * singular[0]).sum()) :].T
    radius = max(abs(np.linalg.eigvals(kernel.T @ t @ kernel)))
    assert radius == pytest.approx(growth(scheme), rel=1e-6)


def test_the_smallest_window_without_the_generators_is_too_small():
    """On |α_j| <= 1 the bilinear B-spline would have s = 2: of order 4 only products of second differences fit in."""
    row = {"dilation": [[2, 0], [0, 2]], "terms": {f"{i},{j}": f"{(2 - i * i) * (2 - j * j)}/4" for i, j in NINE}}
    scheme = scheme_of(row)
    b = autocorrelation(scheme)
    matrix = [[float(b.get((2 * x[0] - y[0], 2 * x[1] - y[1]), 0)) / 4 for y in NINE] for x in NINE]
    powers = [[x[0] ** i * x[1] ** j for x in NINE] for i in range(4) for j in range(4 - i)]
    kernel = np.linalg.svd(np.array(powers, dtype=float))[2][-1:].T
    assert float((kernel.T @ matrix @ kernel)[0, 0]) == pytest.approx(1 / 16)
    assert growth(scheme) == 1 / 8


NINE = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)]


def test_every_sum_rule_is_needed():
    """With differences of order 1 of the butterfly scheme, k = 4, the growth is that of 1/λ: s >= 1 only."""
    scheme = scheme_of(next(row for row in ROWS if row["id"] == "butterfly_1/16"))
    lattice = Lattice(scheme.dilation)
    for k, s in ((1, 1.0), (2, 2.0), (3, 2.4407654450703506), (4, 2.4407654450703506)):
        rho = float(mean_squares(scheme, lattice, k, Effort()).growth.radius.enclosure().real.mid())
        assert exponent(rho, lattice) == pytest.approx(s)


@pytest.mark.parametrize("name", ["courant", "loop", "tensor2", "box221"])
def test_box_splines_that_are_stable_have_the_exponent_of_their_differences(name):
    scheme = scheme_of(next(row for row in ROWS if row["id"] == name))
    assert exponent(growth(scheme), Lattice(scheme.dilation)) == pytest.approx(float(found(scheme).closed))


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["id"])
def test_the_bounds_of_the_hoelder_exponent(row):
    """s - dimension/2 <= α <= s."""
    scheme = scheme_of(row)
    (low, high), value = row["truth"]["holder_of_limits"], found(scheme).value
    assert low >= value.lower - scheme.dimension / 2 - 1e-6
    if value.upper is not None or not row["truth"]["stable"]:
        assert high <= (value.upper or row["truth"]["sobolev_of_limits"]) + 1e-6


FOLDERS = (ROOT / "masks" / "multivariate", ROOT / "tests" / "data" / "long_masks")
"""The second one has masks that take longer than a catalog should."""


@pytest.mark.parametrize(
    ("name", "order"), [("labsik_greiner", 1), ("sqrt3_linear", 0), ("quincunx_interpolatory_4", 1)]
)
def test_convergence_in_the_mean(name, order, monkeypatch):
    """Without any joint spectral radius: s > dimension/2, so S converges; then interpolation is stable, and s exact."""
    monkeypatch.setattr(MultivariateNumbers, "radius", None)
    monkeypatch.setattr(MultivariateNumbers, "stencil_growth", None)
    mask = read_path(next(file for folder in FOLDERS if (file := folder / f"{name}.toml").exists()))
    result = check(mask.scheme(), mask.expectations, Effort()).result
    assert result.convergent is result.stable is Verdict.PROVED
    assert result.refinable.order == order
    assert result.sobolev.exact is not None
    assert result.holder.lower == pytest.approx(result.sobolev.lower - 1)


small = st.fractions(min_value=-1, max_value=1, max_denominator=4)


@settings(max_examples=25)
@given(st.dictionaries(st.tuples(st.integers(-1, 1), st.integers(-1, 1)), small, min_size=1, max_size=4))
def test_shifts_and_reversal_change_nothing(cofactor):
    """Of (1+z1)(1+z2) times a random cofactor: a(z) z^t, a(1/z), and the coordinates exchanged."""
    terms = {}
    for (i, j), c in cofactor.items():
        for x, y in product((0, 1), repeat=2):
            terms[i + x, j + y] = terms.get((i + x, j + y), Fraction(0)) + c
    total = sum(cofactor.values())
    if not total or not any(terms.values()):
        return
    terms = {index: value / total for index, value in terms.items()}

    def s(changed):
        scheme = MultivariateScheme(dilation=((2, 0), (0, 2)), terms=changed)
        lattice = Lattice(scheme.dilation)
        order = sum_rule_order(scheme, lattice, Effort())
        answer = mean_squares(scheme, lattice, order, Effort())
        polynomial = answer.growth and list(answer.growth.radius.minimal_polynomial)
        return order, polynomial, reproduction(scheme, lattice, order - 1).degree

    assert s(terms) == s({(i + 3, j - 2): value for (i, j), value in terms.items()})
    assert s(terms) == s({(-i, -j): value for (i, j), value in terms.items()})
    assert s(terms) == s({(j, i): value for (i, j), value in terms.items()})


def reproduces(scheme, degree, tau):
    """Whether S p(· + σ) = p(M^-1 (· + σ)) for all monomials of this degree, (M - I) σ = τ, at some indices."""
    m = [[Fraction(x) for x in row] for row in scheme.dilation]
    sigma = solved([[x - (i == j) for j, x in enumerate(row)] for i, row in enumerate(m)], list(tau))
    low, high = scheme.bounds()
    size = max(map(abs, (*low, *high))) + 4
    for mu in indices_of_degree(scheme.dimension, degree):
        for alpha in product(range(-1, 3), repeat=scheme.dimension):
            moved = solved(m, [x + y for x, y in zip(alpha, sigma, strict=True)])
            value = Fraction(0)
            for beta in product(range(-size, size + 1), repeat=scheme.dimension):
                image = [sum(p * q for p, q in zip(row, beta, strict=True)) for row in scheme.dilation]
                if a := scheme.terms.get(tuple(p - q for p, q in zip(alpha, image, strict=True))):
                    value += a * monomial([x + y for x, y in zip(beta, sigma, strict=True)], mu)
            if value != monomial(moved, mu):
                return False
    return True


def monomial(x, mu):
    return math.prod((t**n for t, n in zip(x, mu, strict=True)), start=Fraction(1))


def solved(matrix, right):
    """By Cramer's rule, in order 2."""
    (a, b), (c, d) = matrix
    return [(d * right[0] - b * right[1]) / (a * d - b * c), (a * right[1] - c * right[0]) / (a * d - b * c)]


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["id"])
def test_polynomials_are_subdivided_to_themselves(row):
    scheme = scheme_of(row)
    lattice = Lattice(scheme.dilation)
    found = reproduction(scheme, lattice, sum_rule_order(scheme, lattice, Effort()) - 1)
    for degree in range(found.degree + 1):
        assert reproduces(scheme, degree, found.shift)
    assert not reproduces(scheme, found.degree + 1, found.shift)


@pytest.mark.parametrize("file", MASKS, ids=lambda file: file.stem)
def test_shipped_masks_reproduce_what_they_say(file):
    mask = read_path(file)
    scheme = mask.scheme()
    numbers = MultivariateNumbers(scheme, Effort())
    for expected in mask.expectations:
        if expected.key == "reproduction":
            assert numbers.reproduction.degree == expected.lower
    if numbers.order > 1 and numbers.is_interpolatory:
        assert numbers.reproduction.degree == numbers.order - 1
        assert not any(numbers.reproduction.shift)
