"""Laws of subdivision operators on random masks and data: the algebra the theorems rest on."""

from fractions import Fraction
from itertools import product as words

from hypothesis import assume, given
from hypothesis import strategies as st
from support import answer, scheme

from subdiv_cli.exact.laurent import Laurent, smoothing_factor
from subdiv_cli.exact.linalg import infinity_norm
from subdiv_cli.kinds.scalar.numbers.norms import power_norms
from subdiv_cli.kinds.scalar.numbers.operators import (
    apply,
    difference_symbol,
    refinement_matrices,
    refinement_window,
    symbol,
    transition_matrices,
)
from subdiv_cli.kinds.scalar.numbers.polynomials import parameter_shift, reproduction_defects, sum_rules
from subdiv_cli.kinds.scalar.numbers.spectra import spectrum
from subdiv_cli.model import Effort

small = st.fractions(min_value=-3, max_value=3, max_denominator=6)
data = st.dictionaries(st.integers(-5, 5), small, max_size=6)
arities = st.integers(2, 5)


@st.composite
def symbols_with_sum_rules(draw, order=None, longest=4, arities=arities):
    """(a, p, k): a(1) = p and at least k sum rules, from an arbitrary cofactor."""
    p, k = draw(arities), draw(st.integers(1, 3)) if order is None else order
    q = Laurent.from_coefficients(draw(st.integers(-4, 4)), draw(st.lists(small, min_size=1, max_size=longest)))
    if q.degree < 0 or not q(1):
        q = Laurent.from_coefficients(0, [1])
    for _ in range(k):
        q = q * smoothing_factor(p)
    return q.scale(Fraction(p) / q(1)), p, k


def difference(f):
    """(Δf)_i = f_(i+1) - f_i."""
    g = {}
    for i, value in f.items():
        g[i] = g.get(i, 0) - value
        g[i - 1] = g.get(i - 1, 0) + value
    return {i: value for i, value in g.items() if value}


def drop_zeros(f):
    return {i: value for i, value in f.items() if value}


@given(symbols_with_sum_rules(), data)
def test_differences_commute_with_the_difference_schemes(mask, f):
    """Δ^k S f = S_(Δ^k) Δ^k f, indices included (Dyn 3.1, 3.17)."""
    a, p, k = mask
    left, right = apply(a, p, f), f
    for _ in range(k):
        left, right = difference(left), difference(right)
    assert drop_zeros(left) == drop_zeros(apply(difference_symbol(a, p, k), p, right))


@given(symbols_with_sum_rules(), st.integers(0, 2), data)
def test_refinement_matrices_refine(mask, level, f):
    """F_(pℓ+ε) = A_ε F_ℓ for the window of the mask's own indexing (Dyn 4.3), at any ℓ."""
    a, p, _ = mask
    s = scheme(a.coefficients(), start=a.low, arity=p)
    window, refined = refinement_window(s), apply(a, p, f)
    at = level - 1
    before = [f.get(at + alpha, Fraction(0)) for alpha in window]
    for epsilon, matrix in enumerate(refinement_matrices(s)):
        rows = [[Fraction(int(x.p), int(x.q)) for x in row] for row in matrix.table()]
        after = [sum(entry * value for entry, value in zip(row, before, strict=True)) for row in rows]
        assert after == [refined.get(p * at + epsilon + alpha, Fraction(0)) for alpha in window]


@given(symbols_with_sum_rules(longest=3), st.integers(1, 3))
def test_the_norm_of_a_power_is_the_largest_norm_of_a_product(mask, level):
    a, p, k = mask
    d = difference_symbol(a, p, k)
    matrices = transition_matrices(d, p)
    norms = list(zip(range(level), power_norms(d, p, Effort()), strict=False))
    largest = Fraction(0)
    for word in words(matrices, repeat=level):
        total = word[0]
        for matrix in word[1:]:
            total = matrix * total
        largest = max(largest, infinity_norm(total))
    assert norms[-1][1] == largest


@given(symbols_with_sum_rules(longest=3), st.integers(1, 3))
def test_the_norm_of_a_power_is_what_data_shows(mask, level):
    """‖S^L‖∞ is attained on signs: the class sums of |S^L δ|, computed by applying S to δ."""
    a, p, _ = mask
    f = {0: Fraction(1)}
    for _ in range(level):
        f = apply(a, p, f)
    classes = {}
    for i, value in f.items():
        classes[i % p**level] = classes.get(i % p**level, 0) + abs(value)
    norms = list(zip(range(level), power_norms(a, p, Effort()), strict=False))
    assert norms[-1][1] == max(classes.values())


@given(symbols_with_sum_rules(longest=3, arities=st.just(2)))
def test_eigenvalues_of_a_0_are_powers_and_those_of_the_difference_scheme(mask):
    """(4.12): 1, 1/p, …, 1/p^(k-1) and the spectrum of one transition matrix of D, up to zeros; p = 2."""
    a, p, _ = mask
    k = sum_rules(a, p)[0]
    s = scheme(a.coefficients(), start=a.low, arity=p)
    d = difference_symbol(a, p, k)
    assume(d.degree > 0)  # else the window of D is larger than needed

    def moduli(pairs):
        return sorted(round(float(x.region.__abs__().mid()), 6) for x, m in pairs for _ in range(m) if x.rational != 0)

    expected = moduli(spectrum(transition_matrices(d, p)[0])) + [round(0.5**j, 6) for j in range(k)]
    assert moduli(spectrum(refinement_matrices(s)[0])) == sorted(expected)


def test_shift_and_reversal_change_nothing():
    base = scheme([-1, 0, 9, 16, 9, 0, -1], start=-3, over=16)
    lopsided = scheme(["1/4", "2/3", "3/4", "1/3"], start=-2)
    ternary = scheme([-4, -7, 0, 34, 76, 99, 76, 34, 0, -7, -4], start=-5, arity=3, over=99)
    for mask in (base, lopsided, ternary):
        expected = verdicts(answer(mask))
        for start in (-100, -1, 0, 7):
            assert verdicts(answer(scheme(mask.coefficients, start=start, arity=mask.arity))) == expected
        reversed_mask = scheme(mask.coefficients[::-1], start=-mask.start - mask.degree, arity=mask.arity)
        assert verdicts(answer(reversed_mask)) == expected


def verdicts(result):
    holder = result.holder
    return (
        result.convergent,
        result.smoothness,
        result.stable,
        result.linearly_independent,
        result.sum_rule_order,
        result.generation,
        result.reproduction,
        holder and holder.lower,
        holder and holder.exact,
        holder and round(holder.upper, 12),
    )


def test_one_more_smoothing_factor_raises_the_order_by_one():
    for mask in (
        scheme([-1, 0, 9, 16, 9, 0, -1], over=16),
        scheme([1, 4, 4, 1], over=5),
        scheme([-2, -3, 0, 16, 34, 45, 34, 16, 0, -3, -2], arity=3, over=45),
    ):
        before = answer(mask)
        smoothed = symbol(mask) * smoothing_factor(mask.arity).scale(Fraction(1, mask.arity))
        after = answer(scheme(smoothed.coefficients(), arity=mask.arity))
        assert after.smoothness.order == before.smoothness.order + 1
        assert after.sum_rule_order == before.sum_rule_order + 1
        assert after.smoothness.sharp == before.smoothness.sharp
        assert (
            after.holder.upper - before.holder.upper == 1 or abs(after.holder.upper - before.holder.upper - 1) < 1e-12
        )


@given(symbols_with_sum_rules(order=3, longest=2))
def test_reproduction_is_what_sampling_shows(mask):
    """S maps q at the parameters i + τ/(p-1) to q at (i + τ/(p-1))/p iff the defects up to its degree vanish."""
    a, p, _ = mask
    shift = parameter_shift(a, p) / (p - 1)
    defects = reproduction_defects(a, p, 2)
    first = a.low
    reach = range(first - a.degree - 3 * p, first + a.degree + 3 * p)
    for degree in range(3):
        refined = apply(a, p, {i: (i + shift) ** degree for i in reach})
        middle = range(p * reach[0] + a.low + a.degree + p, p * reach[-1] + a.low - p)
        exact = all(refined[i] == ((i + shift) / p) ** degree for i in middle)
        assert exact == all(d == 0 for d in defects[: degree + 1])
        if not exact:
            break
