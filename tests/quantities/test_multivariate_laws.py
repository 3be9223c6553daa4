"""Laws of schemes in several variables: what must not change, and what must change in a known way."""

import random
from fractions import Fraction
from itertools import combinations, product

import numpy as np
import pytest
from support import answer, b_spline, four_point, multivariate_scheme, scheme, shipped_answer, shipped_multivariate

from subdiv_cli.exact.closed import closed_interval
from subdiv_cli.kinds.multivariate.numbers.box_spline import box_spline, iterated
from subdiv_cli.kinds.multivariate.numbers.difference_space import difference_space
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.spaces.lattice import Lattice

F = Fraction
DE_RHAM = scheme([1, 4, 4, 1], start=-1, over=5)


def said(result):
    """What a change of coordinates must leave alone."""
    holder = result.holder
    return {
        "convergent": result.convergent,
        "smoothness": result.smoothness,
        "refinable": result.refinable,
        "stable": result.stable,
        "order": result.sum_rule_order,
        "generation": result.generation,
        "holder": None if holder is None else (holder.exact is None, holder.lower and round(holder.lower, 9)),
    }


def times(matrix, alpha):
    return tuple(sum(x * y for x, y in zip(row, alpha, strict=True)) for row in matrix)


def product_of(a, b):
    return tuple(tuple(sum(x * y for x, y in zip(row, col, strict=True)) for col in zip(*b, strict=True)) for row in a)


def inverse(u):
    (a, b), (c, d) = u
    det = a * d - b * c
    return ((d * det, -b * det), (-c * det, a * det))


def tensor(first, second):
    """The product of two masks in one variable, of one arity."""
    terms = {
        (first.start + i, second.start + j): x * y
        for (i, x), (j, y) in product(enumerate(first.coefficients), enumerate(second.coefficients))
        if x * y
    }
    return multivariate_scheme(terms, ((first.arity, 0), (0, first.arity)))


@pytest.mark.parametrize("u", [((1, 1), (0, 1)), ((0, 1), (1, 0)), ((2, 1), (1, 1)), ((1, 0), (0, -1))])
@pytest.mark.parametrize(
    "name", ["courant", "zwart_powell", "box_221", "quincunx_linear", "counterexamples/box_21_discontinuous", "bear"]
)
def test_a_change_of_variables_changes_no_verdict(name, u):
    """b(α) = a(Uα) with the dilation U^-1 M U has the function φ(U ·)."""
    before = shipped_multivariate(name)
    back = inverse(u)
    after = multivariate_scheme(
        {times(back, alpha): x for alpha, x in before.terms.items()}, product_of(product_of(back, before.dilation), u)
    )
    assert all(before.terms[times(u, alpha)] == x for alpha, x in after.terms.items())
    assert said(answer(after)) == said(shipped_answer(name))


@pytest.mark.parametrize("name", ["courant", "zwart_powell", "quincunx_linear", "counterexamples/haar", "bear"])
def test_shifts_and_reflections_change_nothing(name):
    before = shipped_multivariate(name)
    shifted = multivariate_scheme({(i + 3, j - 5): x for (i, j), x in before.terms.items()}, before.dilation)
    reflected = multivariate_scheme({(-i, -j): x for (i, j), x in before.terms.items()}, before.dilation)
    assert said(answer(shifted)) == said(answer(reflected)) == said(shipped_answer(name))


def test_a_shift_of_an_interpolatory_mask_changes_no_verdict():
    """Only the mask as it stands is seen to interpolate; the Gram sequence tells after a shift."""
    before = shipped_multivariate("sqrt3_linear")
    result, shifted = (
        shipped_answer("sqrt3_linear"),
        answer(multivariate_scheme({(i + 1, j): x for (i, j), x in before.terms.items()}, before.dilation)),
    )
    assert said(shifted) == said(result)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        (b_spline(1), b_spline(2)),
        (b_spline(3), b_spline(2)),
        (b_spline(2, arity=3), b_spline(1, arity=3)),
        (four_point("1/32"), b_spline(1)),
        (four_point("-1/4"), b_spline(1)),
        (DE_RHAM, b_spline(1)),
        (DE_RHAM, b_spline(0)),
    ],
)
def test_tensor_products_have_the_smaller_exponent(first, second):
    both = answer(tensor(first, second))
    exponents = [answer(one).holder for one in (first, second)]
    smaller = min(exponents, key=lambda holder: holder.lower)
    if smaller.upper == 0:
        assert both.convergent is Verdict.REFUTED
        return
    assert both.convergent is Verdict.PROVED
    assert abs(both.holder.lower - smaller.lower) < 1e-9
    if both.stable is Verdict.PROVED:
        assert closed_interval(both.holder.exact) == closed_interval(smaller.exact)
    assert both.sum_rule_order == min(answer(one).sum_rule_order for one in (first, second))


def depth(directions, s):
    """The least number of directions whose removal leaves a set that does not span, by trying all."""
    for count in range(len(directions) + 1):
        for kept in combinations(directions, len(directions) - count):
            if not kept or np.linalg.matrix_rank(np.array(kept)) < s:
                return count
    raise AssertionError


def box_mask(directions, s, c=2):
    terms = {(0,) * s: F(c) ** (s - len(directions))}
    for xi in directions:
        longer = {}
        for alpha, x in terms.items():
            for i in range(c):
                index = tuple(a + i * t for a, t in zip(alpha, xi, strict=True))
                longer[index] = longer.get(index, F(0)) + x
        terms = longer
    return multivariate_scheme(terms, tuple(tuple(c * (i == j) for j in range(s)) for i in range(s)))


def random_directions():
    chosen = random.Random(1993)
    for s, c in [(2, 2)] * 12 + [(2, 3)] * 4 + [(3, 2)] * 8:
        axes = [tuple(int(i == j) for j in range(s)) for i in range(s)]
        others = [d for d in product((-1, 0, 1), repeat=s) if d > (0,) * s]
        yield s, c, [*axes, *(chosen.choice(others) for _ in range(chosen.randint(0, 3)))], chosen.choice(others)


def test_another_direction_raises_the_smoothness_as_the_rule_says():
    """d grows by one where the direction lies off every hyperplane that leaves the fewest outside, else it stays."""
    grown, unstable = [], []
    for s, c, directions, another in random_directions():
        found = []
        for some in (directions, [*directions, another]):
            mask = box_mask(some, s, c)
            box = box_spline(mask, Lattice(mask.dilation), Effort())
            assert sorted(box.directions) == sorted(some)
            assert box.depth == depth(some, s)
            determinants = {abs(round(np.linalg.det(np.array(few)))) for few in combinations(some, s)}
            assert box.is_unimodular is (max(determinants) <= 1)
            unstable.append(not box.is_unimodular)
            found.append(box.depth)
        grown.append(found[1] - found[0])
    assert set(grown) == {0, 1}
    assert any(unstable)
    assert not all(unstable)


@pytest.mark.parametrize("name", ["courant", "zwart_powell", "quincunx_linear", "box_221", "counterexamples/haar"])
def test_two_steps_at_once_have_the_same_function(name):
    """S² has the dilation M² and the same φ."""
    once = shipped_multivariate(name)
    twice = multivariate_scheme(iterated(once, Lattice(once.dilation), 2), product_of(once.dilation, once.dilation))
    assert said(answer(twice)) == said(shipped_answer(name))


def test_an_interpolatory_mask_in_two_steps():
    once = shipped_multivariate("sqrt3_linear")
    twice = multivariate_scheme(iterated(once, Lattice(once.dilation), 2), product_of(once.dilation, once.dilation))
    assert twice.dilation == ((3, 0), (0, 3))
    assert said(answer(twice)) == said(shipped_answer("sqrt3_linear"))


@pytest.mark.parametrize("dilation", [((2, 1), (0, 3)), ((2, 1), (0, 2)), ((3, 1), (1, 2))])
def test_anisotropic_dilations_have_no_exponent(dilation):
    """Neither eigenvalues 2 and 3, nor a Jordan block, nor two irrational eigenvalues of different size.

    That S converges is decided, and then φ is continuous.
    """
    lattice = Lattice(dilation)
    assert not lattice.is_isotropic
    constant = {alpha: F(1) for alpha in lattice.representatives}
    averaged = {}
    for (i, j), x in constant.items():
        for k, l in product((0, 1), repeat=2):
            averaged[i + k, j + l] = averaged.get((i + k, j + l), F(0)) + x / 4
    result = answer(multivariate_scheme(averaged, dilation))
    assert result.sum_rule_order >= 1
    assert result.convergent is Verdict.PROVED
    assert result.smoothness == result.refinable == (0, False)
    assert result.holder is None
    verdicts = {f.code: f.verdict for f in result.findings}
    assert verdicts["SD612"] is Verdict.PROVED
    assert {verdicts[code] for code in ("SD613", "SD614", "SD615")} == {Verdict.SKIPPED}


def test_differences_with_long_entries_take_no_minutes():
    """36 rows with long entries before they are made short; the Hermite normal form alone took 94 seconds."""
    near = {(1, 0), (-1, 0), (1, 1), (-1, 1), (2, 1), (0, 1), (2, 2), (0, 2)}
    far = {(1, 2), (-1, 2), (1, 3), (-1, 3), (2, 3), (0, 3), (2, 4), (0, 4)}
    mask = multivariate_scheme(
        dict.fromkeys(near, Fraction(9, 32)) | dict.fromkeys(far, Fraction(-1, 32)), ((0, -2), (1, 0))
    )
    space = difference_space(mask, Lattice(mask.dilation), 1, Effort())
    assert space is not None
    assert len(space.basis.tolist()) == 36
    assert max(abs(int(x.p)) for x in space.basis.entries()) < 10**4


def test_coefficients_of_fifty_digits_are_given_up_at_once():
    """Their differences have no short basis, and looking for one would take minutes."""
    c = F(10**49 + 9, 3 * 10**49 + 7)
    factors = [{(0, 0): F(1), d: F(1)} for d in [(1, 0), (1, 0), (0, 1), (0, 1), (1, 1)]] + [{(0, 0): 1 - c, (1, 1): c}]
    terms = {(0, 0): F(1, 16)}
    for factor in factors:
        product_so_far, terms = terms, {}
        for ((i, j), x), ((k, l), y) in product(product_so_far.items(), factor.items()):
            terms[i + k, j + l] = terms.get((i + k, j + l), F(0)) + x * y
    mask = multivariate_scheme(terms, ((1, 1), (1, -1)))
    assert difference_space(mask, Lattice(mask.dilation), 2, Effort()) is None
