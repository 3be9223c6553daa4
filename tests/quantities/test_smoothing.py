"""Smoothing and derivation of schemes: what the operators do to data, exponents that grow by exactly 1, supports."""

from fractions import Fraction
from math import factorial

import pytest
from flint import fmpq_mat, fmpq_poly
from hypothesis import given
from hypothesis import strategies as st
from matrix_masks import (
    DOUBLE_KNOT_CUBIC,
    HERMITE_CUBIC,
    HERMITE_QUINTIC,
    UNSEEN,
    blocked,
    conjugated,
    de_rham,
    diagonal,
    hermite_interpolation,
    merrien,
    scalar,
    spline,
    times,
)
from matrix_masks import scheme as vector_scheme
from random_masks import random_scalar
from support import b_spline, cases, scheme, seeded

from subdiv_cli.exact.linalg import identity, matrix, rows_of
from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import NotSmoothedError
from subdiv_cli.kinds.smoothing import smoothing_steps
from subdiv_cli.kinds.vector.numbers.derived import constants_and_mean
from subdiv_cli.kinds.vector.smoothing import canonical, integrated, terms_of
from subdiv_cli.model import Effort, Smoothness, Verdict
from subdiv_cli.pipeline import DisagreementError, check, check_steps

small = st.fractions(min_value=-3, max_value=3, max_denominator=6)
data = st.dictionaries(st.integers(-4, 4), small, min_size=1, max_size=5)
masks = st.lists(small, min_size=1, max_size=6)
arities = st.integers(2, 4)


def smoother(mask):
    return smoothing_steps(mask, 1)[0].scheme


def derived(mask):
    return smoothing_steps(mask, 1, inverse=True)[0].scheme


def refined(mask, f):
    """S f for data index -> column of m numbers, straight from the definition."""
    p, found = mask.arity, {}
    for j, column in f.items():
        for i, a in enumerate(mask.coefficients, mask.start):
            rows = a if isinstance(a, tuple) else [[a]]
            new = found.setdefault(i + p * j, [Fraction(0)] * len(column))
            found[i + p * j] = [
                x + sum(r * c for r, c in zip(row, column, strict=True)) for x, row in zip(new, rows, strict=True)
            ]
    return {i: column for i, column in found.items() if any(column)}


def differences(f, projector):
    """Δ P + 1 - P: differences of the part in the image of a projector, and the rest as it is."""
    found = {}
    for i, column in f.items():
        part = [sum(x * c for x, c in zip(row, column, strict=True)) for row in projector]
        for at, new in ((i, [c - 2 * y for c, y in zip(column, part, strict=True)]), (i - 1, part)):
            found[at] = [x + y for x, y in zip(found.get(at, [0] * len(new)), new, strict=True)]
    return {i: column for i, column in found.items() if any(column)}


@given(masks, st.integers(-4, 4), arities, data)
def test_scalar_differences_are_refined_by_the_old_scheme(coefficients, start, p, f):
    """Δ S_Ia f = (1/p) S_a Δ f, indices included, and ∂ Ia = a; the support begins p - 1 lower."""
    coefficients = [*coefficients, p - sum(coefficients)]
    mask = scheme(coefficients, start, p) if any(coefficients) else b_spline(1, p)
    smooth = smoother(mask)
    f = {i: [x] for i, x in f.items()}
    left = differences(refined(smooth, f), [[1]])
    assert {i: [p * x for x in column] for i, column in left.items()} == refined(mask, differences(f, [[1]]))
    assert derived(smooth) == mask
    assert (smooth.start, smooth.start + smooth.degree) == (mask.start - p + 1, mask.start + mask.degree)


@st.composite
def vector_masks(draw):
    """Masks of m×m matrices, m = 1, 2, 3, with E_B of any dimension r >= 1, in any basis."""
    p, m = draw(st.integers(2, 3)), draw(st.integers(1, 3))
    r = draw(st.integers(1, m))
    matrices = draw(
        st.lists(st.lists(st.lists(small, min_size=m, max_size=m), min_size=m, max_size=m), min_size=p, max_size=4)
    )
    for epsilon in range(p):  # the sums over the residue classes fix e_1, …, e_r
        for k in range(m):
            for l in range(r):
                total = sum(a[k][l] for a in matrices[epsilon::p])
                matrices[epsilon][k][l] += int(k == l) - total
    entry = st.integers(-2, 2)
    lower = [[draw(entry) if j < i else int(i == j) for j in range(m)] for i in range(m)]
    upper = [[draw(entry) if j > i else int(i == j) for j in range(m)] for i in range(m)]
    change = times(lower, upper)
    mask = conjugated(dict(enumerate(matrices, draw(st.integers(-3, 3)))), change, rows_of(matrix(change).inv()))
    return vector_scheme(mask, p)


@given(vector_masks(), st.data())
def test_vector_differences_are_refined_by_the_old_scheme(mask, drawn):
    """Δ_R S_A c = (1/p) S_B Δ_R c, with the projector onto E_B along the rest; E_A = E_B, corollaries 25 and 26."""
    try:
        smooth = smoother(mask)
    except NotSmoothedError:
        return
    p, m = mask.arity, mask.size
    transformation, r = canonical(p, terms_of(mask))
    unit = identity(m)
    for i in range(r, m):
        unit[i, i] = 0
    projector = transformation * unit * transformation.inv()
    constants, mean = constants_and_mean(p, terms_of(mask))
    assert projector * mean == mean * projector == projector
    column = st.lists(small, min_size=m, max_size=m)
    c = drawn.draw(st.dictionaries(st.integers(-3, 3), column, min_size=1, max_size=4))
    left = differences(refined(smooth, c), rows_of(projector))
    old = refined(mask, differences(c, rows_of(projector)))
    assert {i: [p * x for x in row] for i, row in left.items()} == old
    assert mask.start - p <= smooth.start
    assert smooth.start + len(smooth.coefficients) <= mask.start + len(mask.coefficients)
    again, new_mean = constants_and_mean(p, terms_of(smooth))
    others, one = mean.charpoly(), fmpq_poly([-1, 1])
    for _ in range(r):
        others = divmod(others, one)[0]
    assert new_mean.charpoly() == one**r * others(fmpq_poly([0, p])) / p ** (m - r)
    if others(p) != 0:
        assert again == constants
        assert smoother(derived(smooth)) == smooth


def rises(mask, steps, effort=4000):
    """Whether exact exponents grow by one for each step; None where one is not exact or S does not converge."""
    before, after = check_steps(mask, steps, Effort(effort))
    if before.convergent is not Verdict.PROVED or before.holder is None or before.holder.exact is None:
        return None
    orders = sum(step.orders for step in steps)
    if after.convergent is not Verdict.PROVED:
        return False
    if after.holder is None or after.holder.exact is None:
        return None
    low, high = before.holder.lower + orders, before.holder.upper + orders
    return low - 1e-12 <= after.holder.lower <= after.holder.upper <= high + 1e-12


def vector_mask(rng):
    """Two random scalar masks or fed ones in another basis, blocks of one, splines with multiple knots."""
    sort = rng.randrange(4)
    if sort == 0:
        a = random_scalar(rng)
        while a.arity != 2:
            a = random_scalar(rng)
        return vector_scheme(blocked(a.coefficients, a.start, rng.choice((2, 3))))
    if sort == 1:
        p, degree = rng.choice((2, 3)), rng.randint(1, 3)
        return vector_scheme(spline(degree, rng.randint(1, degree), p), p)
    a, b = random_scalar(rng), random_scalar(rng)
    while b.arity != a.arity:
        b = random_scalar(rng)
    weight, fed = rng.choice((1, Fraction(1, 2), Fraction(3, 4))), rng.choice((0, Fraction(1, 4)))
    mask = diagonal(scalar(a.coefficients), scalar([weight * x for x in b.coefficients]))
    mask[0][0][1] += fed
    return vector_scheme(conjugated(mask, [[2, 1], [1, 1]], [[1, -1], [-1, 2]]), a.arity)


@pytest.mark.parametrize(("make", "ordinary"), [(random_scalar, 40), (vector_mask, 16)])
def test_the_exponent_grows_by_exactly_one_each_time(make, ordinary):
    """Up to three times over, on random masks; and falls by one for the derived scheme, which converges there."""
    rng, grown = seeded(1), 0
    for _ in range(cases(ordinary)):
        mask = make(rng)
        try:
            steps = smoothing_steps(mask, rng.randint(1, 3))
        except NotSmoothedError:
            continue
        rising = rises(mask, steps)
        assert rising is not False
        grown += bool(rising)
        back = smoothing_steps(steps[0].scheme, 1, inverse=True)
        assert make is vector_mask or back[0].scheme == mask
        if rising and make is vector_mask:
            assert check_steps(mask, [back[0]._replace(orders=0)], Effort(2000))[1].convergent is Verdict.PROVED
    assert grown >= cases(ordinary) // 3


def test_exponents_that_do_not_differ_by_the_orders_gained_are_an_internal_error():
    """Both are exact here: 2 and 3."""
    (step,) = smoothing_steps(b_spline(2), 1)
    assert [result.holder.exact for result in check_steps(b_spline(2), [step], Effort())] == [2, 3]
    for orders in (0, 2, -1):
        with pytest.raises(DisagreementError):
            check_steps(b_spline(2), [step._replace(orders=orders)], Effort())


def test_the_derived_scheme_may_be_rougher_than_derivatives():
    """A quartic spline, α = 4, beside half of Chaikin's scheme, which dies out; S_∂A has Chaikin's limits, α = 2."""
    half = [Fraction(x, 8) for x in (1, 3, 3, 1)]
    mask = vector_scheme(diagonal(scalar(b_spline(4).coefficients), scalar(half)))
    (step,) = smoothing_steps(mask, 1, inverse=True)
    assert not step.exactly
    assert [result.holder.exact for result in check_steps(mask, [step], Effort())] == [4, 2]
    with pytest.raises(DisagreementError):
        check_steps(mask, [step._replace(orders=-3)], Effort())
    (whole,) = smoothing_steps(step.scheme, 1)
    assert [result.holder.exact for result in check_steps(step.scheme, [whole], Effort())] == [2, 3]


def taylor_operator(f):
    """Component i < d - 1: Δ c_i - Σ_(j>i) c_j/(j-i)!; the last one as it is."""
    found = {}
    for at, column in f.items():
        d = len(column)
        here = [
            sum((-column[j] / factorial(j - i) for j in range(i, d)), Fraction(0)) if i < d - 1 else column[i]
            for i in range(d)
        ]
        for index, new in ((at, here), (at - 1, [*column[:-1], 0])):
            found[index] = [x + y for x, y in zip(found.get(index, [0] * d), new, strict=True)]
    return {i: column for i, column in found.items() if any(column)}


JETS = {
    f"{d} components, arity {p}": vector_scheme(hermite_interpolation(d, p), p, "hermite")
    for d, p in ((2, 2), (3, 2), (4, 2), (2, 3), (3, 3), (2, 4))
} | {"de Rham": vector_scheme(de_rham(HERMITE_CUBIC), 2, "hermite"), "sheared": smoothing_steps(
    vector_scheme(hermite_interpolation(2, 3), 3, "hermite"), 2
)[1].scheme}  # fmt: skip


@pytest.mark.parametrize("mask", JETS.values(), ids=JETS)
def test_the_taylor_scheme_refines_what_the_taylor_operator_leaves(mask):
    """T S_A c = p^(1-d) S_B T c on data, indices included, for any number of components."""
    (step,) = smoothing_steps(mask, 1, inverse=True)
    rng, d = seeded(mask.size), mask.size
    assert (step.scheme.kind, step.orders) == ("vector", 1 - d)
    for _ in range(5):
        c = {i: [Fraction(rng.randint(-9, 9), rng.randint(1, 4)) for _ in range(d)] for i in range(-2, 3)}
        left = taylor_operator(refined(mask, c))
        right = refined(step.scheme, taylor_operator(c))
        assert {i: [x * mask.arity ** (d - 1) for x in column] for i, column in left.items()} == right
    before, after = check_steps(mask, [step], Effort())
    assert before.convergent is after.convergent is Verdict.PROVED
    assert after.holder.exact is not None
    assert abs(before.holder.lower - after.holder.lower - (d - 1)) < 1e-12


@pytest.mark.parametrize("arity", [2, 3, 4])
def test_procedure_40_of_any_arity(arity):
    """α grows by exactly 1, φ falls by 1/2, and the support begins at most 2p + 1 lower, three times over."""
    mask = vector_scheme(hermite_interpolation(2, arity), arity, "hermite")
    before = check(mask, (), Effort()).result
    assert (before.holder.exact, before.facts["interpolatory"]) == (2, True)
    for n, step in enumerate(smoothing_steps(mask, 3), 1):
        after = check(step.scheme, (), Effort()).result
        assert (after.convergent, after.holder.exact) == (Verdict.PROVED, 2 + n)
        assert (after.smoothness, after.spectral) == (Smoothness(1 + n, True), Verdict.PROVED)
        assert step.details.endswith(f"φ = {number(Fraction(-n, 2))}")
        assert mask.start - 2 * arity - 1 <= step.scheme.start
        assert step.scheme.start + len(step.scheme.coefficients) <= mask.start + len(mask.coefficients)
        mask = step.scheme


def test_procedure_40_raises_exponents_by_exactly_one_on_random_masks():
    """Merrien's family and de Rham transforms of it, some of them not Hermite convergent."""
    rng, grown, divergent = seeded(2), 0, 0
    for _ in range(cases(10)):
        mask = merrien(Fraction(rng.randint(-16, -4), 80), Fraction(2 * rng.randint(-7, 5) + 1, 8))
        mask = vector_scheme(de_rham(mask) if rng.random() < 0.5 else mask, 2, "hermite")
        rising = rises(mask, smoothing_steps(mask, rng.randint(1, 2)), 2000)
        assert rising is not False
        grown += bool(rising)
        divergent += rising is None
    assert grown >= cases(10) // 2
    assert divergent


HAT = scalar(("1/2", 1, "1/2"), -1)
NOT_SEMISIMPLE = {i: [[x, x], [0, x]] for i, ((x,),) in HAT.items()}
UNSEEN_CONSTANT = diagonal(HAT, scalar((2,)))


@pytest.mark.parametrize(
    ("mask", "inverse", "why"),
    [
        (scheme([1, 1, 1]), False, "the coefficients sum to 3, which must be 2, the arity"),
        (scheme([1, 1, 1], arity=3, over=2), False, "the coefficients sum to 3/2, which must be 3, the arity"),
        (scheme([2]), True, "the sums over the residue classes are 2, 0, and must all be 1"),
        (vector_scheme(diagonal(scalar((2,)), scalar((2,)))), False, "E_A = 0: no constant vector is reproduced"),
        (
            vector_scheme(NOT_SEMISIMPLE), False,
            "the eigenvalue 1 of M_A = (1/2) Σ A_i has the multiplicity 2, which must be the dimension 1 of E_A",
        ),
        (
            vector_scheme(UNSEEN_CONSTANT), True,
            "the eigenvalue 1 of M_A = (1/2) Σ A_i has the multiplicity 2, which must be the dimension 1 of E_A",
        ),
    ],
)  # fmt: skip
def test_hypotheses_are_checked(mask, inverse, why):
    with pytest.raises(NotSmoothedError) as refused:
        smoothing_steps(mask, 1, inverse=inverse)
    assert str(refused.value) == why


@pytest.mark.parametrize(
    ("mask", "inverse", "why"),
    [
        (HERMITE_QUINTIC, False, "procedure 40 is for a function with its first derivative, and these jets have 3"),
        (merrien("-1/8", 1), False, "limits of the Taylor scheme do not have a vanishing first component: E_B is not"),
        (merrien("-1/8", 3), False, "after procedure 23 the eigenvalue 2 of B(1) is not simple"),
        (
            {-1: [[1, 0], [0, 0]], 0: [[1, 0], [0, "1/2"]], 1: [[0, "-1/2"], [0, "1/2"]]}, False,
            "of the Taylor scheme the eigenvalue 1 of M_A = (1/2) Σ A_i has the multiplicity 2, which must be the dim",
        ),
        (UNSEEN, False, "the spectral condition fails: there is no jet y_1 with S y_1 = 2^-1 y_1"),
        (UNSEEN, True, "the spectral condition fails: there is no jet y_1 with S y_1 = 2^-1 y_1"),
        (DOUBLE_KNOT_CUBIC, False, "the spectral condition fails: there is no jet y_0 with S y_0 = y_0"),
    ],
)  # fmt: skip
def test_hypotheses_of_jets_are_checked(mask, inverse, why):
    with pytest.raises(NotSmoothedError) as refused:
        smoothing_steps(vector_scheme(mask, 2, "hermite"), 1, inverse=inverse)
    assert str(refused.value).startswith(why)


def test_a_step_that_fails_is_named():
    with pytest.raises(NotSmoothedError, match="in step 3 the sums over the residue classes are 2, 0, and must all"):
        smoothing_steps(scheme([1, 2, 1], over=2), 5, inverse=True)


def test_a_vector_mask_whose_rows_do_not_sum_to_0_is_not_integrated():
    """Lemma 16 asks for B_12(1) = 0; without it (14) is no Laurent polynomial."""
    with pytest.raises(NotSmoothedError, match="do not sum to 0"):
        integrated(2, {0: fmpq_mat([[1, 1], [0, 1]]), 1: fmpq_mat([[1, 0], [0, 0]])}, 1)
