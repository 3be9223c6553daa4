"""Limit stencils in several variables: they agree with every other route, and decide unstable masks as floats see it.

An unstable mask is made of one that other routes decide: with g = 1 + z^ξ, b(z) g(z^M)/2 has the function of
b(z) g(z)/2 plus its shift by ξ, which is exactly as smooth.
"""

import math
from collections import Counter
from dataclasses import replace
from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from random_masks import random_multivariate
from support import answer, cases, findings, multivariate_scheme, seeded, shipped_answer, shipped_multivariate

from subdiv_cli.catalog import masks_directory
from subdiv_cli.kinds.multivariate import KIND
from subdiv_cli.kinds.multivariate.numbers.box_spline import multiplied
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.numbers.stencil_growth import stencil_growth
from subdiv_cli.kinds.multivariate.stages.wording import multivariate_exponent
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.model.order import enclosure
from subdiv_cli.pipeline import DisagreementError, certified
from subdiv_cli.spaces.lattice import Lattice

SLOW = {
    "box_bcc_quintic", "box_fcc_cubic", "box_seven_directions", "tricubic", "kobbelt_sqrt3", "tensor_six_point",
    "box_2222", "velho_zorin",
}  # fmt: skip
"""Spaces in three variables, or large ones."""
NAMES = sorted(
    path.relative_to(masks_directory() / "multivariate").with_suffix("").as_posix()
    for path in (masks_directory() / "multivariate").rglob("*.toml")
    if path.stem not in SLOW
)
UNSTABLE = ["butterfly_doubled", "butterfly_thrice", "sqrt3_averaged"]
WORK = 1500
"""The effort of random masks."""


def by_stencil(scheme, work=20_000):
    """The bounds of the exponent, and the exponent where it is exact, by differences of φ alone."""
    numbers = MultivariateNumbers(scheme, Effort(work))
    lattice = numbers.lattice
    found = stencil_growth(scheme, lattice, max(1, numbers.order), None, Effort(work))
    if found is None or found.word is None:
        return None
    unit, s = math.log2(lattice.index) / lattice.dimension, lattice.dimension
    lower = min(found.order, -found.radius.ceiling / unit)
    upper = -math.log2(found.least) / len(found.word) / unit
    upper = upper if upper < found.order - 1e-9 else math.inf
    exact = found.radius.exact and multivariate_exponent(lattice.index, s, *found.radius.exact)
    return lower, upper, exact if upper < math.inf else None


def agree(one, other):
    """Whether two enclosures of one number have numbers in common."""
    return max(one[0], other[0]) <= min(one[1], other[1]) + 1e-9


def bounds(holder):
    return (
        -math.inf if holder.lower is None else holder.lower,
        math.inf if holder.upper is None else holder.upper,
    )


def same(one, other):
    """Whether two closed forms are one number, to 18 digits where their roots are of different powers."""
    if one == other or isinstance(one, Fraction) or isinstance(other, Fraction):
        return one == other
    (a, b), (c, d) = enclosure(one), enclosure(other)
    return max(a, c) <= min(b, d) and max(b, d) - min(a, c) < Fraction(1, 10**18)


@pytest.mark.parametrize("name", NAMES)
def test_both_routes_agree_on_shipped_masks(name):
    """The exponent of every mask that converges and has an isotropic dilation, whatever decided it."""
    scheme, result = shipped_multivariate(name), shipped_answer(name)
    if result.convergent is not Verdict.PROVED or not Lattice(scheme.dilation).is_isotropic:
        pytest.skip("the theorem does not speak of it")
    lower, upper, exact = by_stencil(scheme)
    assert agree((lower, upper), bounds(result.holder))
    assert upper < math.inf
    if exact is not None and result.holder.exact is not None:
        assert same(exact, result.holder.exact)
    assert lower > result.smoothness.order - 1e-9
    if result.smoothness.sharp:
        assert upper <= result.smoothness.order + 1 + 1e-9


def spread(scheme, xi):
    """The scheme of φ(x) + φ(x - ξ), by b(z) g(z^M)/2 where the mask given is b, and that of b(z) g(z)/2."""
    image = Lattice(scheme.dilation).image(xi)
    half, zero = Fraction(1, 2), (0,) * len(xi)
    return tuple(
        multivariate_scheme(multiplied(scheme.terms, {zero: half, at: half}), scheme.dilation) for at in (image, xi)
    )


PLAIN = [((2, 0), (0, 2)), ((3, 0), (0, 3))]


@pytest.mark.parametrize("part", range(cases(2)))
def test_random_unstable_masks_are_as_smooth_as_what_they_are_made_of(part):
    rng, mix = seeded(part), Counter()
    for _ in range(14):
        unstable, plain = spread(random_multivariate(rng, PLAIN), rng.choice([(1, 0), (0, 1), (1, 1), (1, -1)]))
        one, other = answer(unstable, WORK), answer(plain, WORK)
        if one.convergent is not Verdict.PROVED or other.convergent is not Verdict.PROVED:
            mix["divergent"] += 1
            continue
        assert one.stable is not Verdict.PROVED
        assert agree(bounds(one.holder), bounds(other.holder))
        assert one.smoothness.order == other.smoothness.order or not (one.smoothness.sharp and other.smoothness.sharp)
        mix["by stencils"] += bool(findings(one, "SD621"))
        mix["exact"] += one.holder.exact is not None and one.holder.exact == other.holder.exact
        mix["one was stable"] += other.stable is Verdict.PROVED
    assert min(mix[key] for key in ("by stencils", "exact", "one was stable")) >= 2, mix


@pytest.mark.parametrize("part", range(cases(2)))
def test_both_routes_agree_on_random_masks(part):
    rng, compared = seeded(1000 + part), 0
    for _ in range(8):
        scheme = random_multivariate(rng, PLAIN)
        result = answer(scheme, WORK)
        if result.convergent is Verdict.PROVED and (found := by_stencil(scheme, WORK)) is not None:
            assert agree(found[:2], bounds(result.holder))
            compared += result.holder.upper is not None
    assert compared >= 2


@pytest.mark.parametrize(("name", "value"), [("sqrt3_linear", 1.6075178838763707), ("butterfly", 2)])
def test_a_function_and_its_shift_have_the_exponent_that_stability_gives(name, value):
    """b(z) (1 + z1)/2 is stable, and other routes decide it; b(z) (1 + z^(M e1))/2 has only limit stencils."""
    unstable, stable = (answer(each) for each in spread(shipped_multivariate(name), (1, 0)))
    assert (unstable.stable, stable.stable) == (Verdict.REFUTED, Verdict.PROVED)
    assert findings(unstable, "SD621")
    assert not findings(stable, "SD621")
    assert unstable.holder.exact == stable.holder.exact
    assert stable.holder.lower == pytest.approx(value)
    assert unstable.smoothness == stable.smoothness


@pytest.mark.parametrize("xi", [(1, 0), (1, -1)])
@pytest.mark.parametrize("dilation", [((1, -1), (1, 1)), ((0, 2), (1, 0))])
def test_averages_on_lattices_that_rotate(dilation, xi):
    """The mask 1/m Σ Σ z^(ε+ε') over pairs of representatives: as smooth with g(z^M) as with g(z)."""
    lattice = Lattice(dilation)
    square = dict.fromkeys(lattice.representatives, Fraction(1, lattice.index))
    b = multivariate_scheme({at: lattice.index * x for at, x in multiplied(square, square).items()}, dilation)
    one, other = (answer(each, 300) for each in spread(b, xi))
    assert (one.convergent, other.convergent) == (Verdict.PROVED, Verdict.PROVED)
    assert agree(bounds(one.holder), bounds(other.holder))


def iterated(scheme, levels):
    """S δ, S² δ, … as dictionaries of floats, and w by T_0 applied again and again, without the package's operators."""
    m = np.array(scheme.dilation)
    inverse = np.linalg.inv(m)
    terms = [(np.array(at), float(x)) for at, x in scheme.terms.items()]
    w = {(0,) * len(m): 1.0}
    for _ in range(60):
        image = {}
        for (beta, x), (gamma, a) in product(w.items(), terms):
            at = inverse @ (np.array(beta) + gamma)
            if np.abs(at - np.rint(at)).max() < 1e-6:
                key = tuple(map(int, np.rint(at)))
                image[key] = image.get(key, 0.0) + a * x
        w = {at: x for at, x in image.items() if abs(x) > 1e-14}
    data, found = {(0,) * len(m): 1.0}, []
    for _ in range(levels):
        fine = {}
        for (beta, x), (gamma, a) in product(data.items(), terms):
            at = tuple(map(int, m @ np.array(beta) + gamma))
            fine[at] = fine.get(at, 0.0) + a * x
        data = fine
        found.append(data)
    return w, found


def largest_difference(w, data, k):
    """The largest k-th difference along an axis or a diagonal of the values of φ."""
    corner = np.min([*data], axis=0) + np.min([*w], axis=0) - k
    size = np.max([*data], axis=0) + np.max([*w], axis=0) + k + 1 - corner
    values = np.zeros(size)
    for (at, x), (beta, y) in product(data.items(), w.items()):
        values[tuple(np.array(at) + np.array(beta) - corner)] += x * y
    sizes = []
    for direction in ((1, 0), (0, 1), (1, 1), (1, -1)):
        v = values
        for _ in range(k):
            v = v - np.roll(v, direction, axis=(0, 1))
        sizes.append(np.abs(v).max())
    return max(sizes)


@pytest.mark.parametrize(("name", "levels"), [("butterfly_doubled", (3, 5)), ("sqrt3_averaged", (4, 8))])
def test_differences_of_the_function_decay_as_said(name, levels):
    """Floats of their own: S^n δ, w, and the differences of w * S^n δ between two levels."""
    scheme, result = shipped_multivariate(name), shipped_answer(name)
    w, data = iterated(scheme, levels[1])
    assert sum(w.values()) == pytest.approx(1)
    first, last = (largest_difference(w, data[n - 1], 3) for n in levels)
    rate = -math.log(last / first) / (levels[1] - levels[0]) / math.log(abs(np.linalg.det(scheme.dilation)) ** 0.5)
    assert rate == pytest.approx(result.holder.lower, abs=0.12)


@pytest.mark.parametrize("name", UNSTABLE)
def test_only_stencils_decide_them(name):
    """Unstable; ρ_k alone bounds the exponent from below."""
    result = shipped_answer(name)
    (found,) = findings(result, "SD621")
    assert (result.stable, found.verdict) == (Verdict.REFUTED, Verdict.PROVED)
    assert result.smoothness.sharp
    assert result.holder.exact is not None
    (above,) = findings(result, "SD615")
    assert above.witness["by"] == "SD621"
    assert not above.otherwise


@pytest.mark.parametrize("name", ["butterfly_doubled", "sqrt3_averaged"])
def test_shifts_and_changes_of_variables_change_nothing(name):
    """b(α) = a(Uα) with the dilation U^-1 M U, U of determinant 1, and the mask moved."""
    before, result = shipped_multivariate(name), shipped_answer(name)
    moved = multivariate_scheme({(i - 2, j + 3): x for (i, j), x in before.terms.items()}, before.dilation)
    (a, b), (c, d) = before.dilation
    sheared = ((a - c, a + b - c - d), (c, c + d))  # U = ((1, 1), (0, 1))
    other = multivariate_scheme({(i - j, j): x for (i, j), x in before.terms.items()}, sheared)
    for each in (answer(moved), answer(other)):
        assert each.holder.exact == result.holder.exact
        assert each.smoothness == result.smoothness
        assert each.stable is result.stable


@pytest.mark.parametrize(
    ("terms", "dilation"),
    [
        ({(0, 0): Fraction(1, 2), (3, 0): Fraction(1), (6, 0): Fraction(1, 2)}, ((1, 1), (1, -1))),
        ({(i, j): Fraction(1, 6) for i in range(4) for j in range(6)}, ((2, 0), (0, 3))),
        ({(0, 0): Fraction(1), (1, 0): Fraction(1), (0, 1): Fraction(1), (1, 1): Fraction(1)}, ((2, 0), (0, 2))),
    ],
)
def test_nothing_is_said_where_a_hypothesis_fails(terms, dilation):
    """A mask on a sublattice, which diverges; a dilation that is not isotropic; Haar's mask, which diverges."""
    assert not findings(answer(multivariate_scheme(terms, dilation), WORK), "SD621")


@pytest.mark.parametrize(
    ("code", "key", "wrong"),
    [
        ("SD621", "order", lambda k: k + 1),
        ("SD621", "stencil", lambda w: w[1:]),
        ("SD613", "order", lambda n: n - 1),
        ("SD615", "radius", lambda y: y * 2),
    ],
)
def test_a_wrong_finding_is_not_certified(code, key, wrong):
    analysis = KIND.analyse(shipped_multivariate("sqrt3_averaged"), Effort())
    (finding,) = (each for each in analysis.findings if each.code == code)
    forged = replace(finding, witness={**finding.witness, key: wrong(finding.witness[key])})
    lower = next(each for each in analysis.findings if each.code == "SD614")
    inexact = replace(lower, closed=None, witness={"by": "SD611", "length": 1, "bound": Fraction(1)}, otherwise=())
    swapped = {id(finding): forged} | ({id(lower): inexact} if code == "SD615" else {})
    findings = tuple(swapped.get(id(each), each) for each in analysis.findings)
    with pytest.raises(DisagreementError):
        certified(KIND, analysis._replace(findings=findings), (), Effort())
