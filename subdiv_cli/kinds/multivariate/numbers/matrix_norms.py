"""Matrix schemes of differences, for any dilation: ∇^μ S^r = Σ_ν S_(q_μν) ∇^ν, |μ| = |ν| = k.

In symbols (1-z)^μ a^[r](z) = Σ_ν q_μν(z) (1-z^M^r)^ν, a^[r] the mask of S^r: Dyn 1992, Lemma 6.6 and Proposition 6.8
for k = 1, M = 2I. Let γ + M^r β, β in Z^s, be the indices of a coset, and p(y) = Σ_β p_(γ + M^r β) y^β, p the left
side there. The right side is Σ_ν q_ν(y) (1-y)^ν, and there are such q_ν iff p vanishes at y = 1 to order k: for all
cosets, and all μ, if the sum rules hold of order k, as then transition operators map U_k to U_k.

For k > 1 this is the scheme S_k of Dyn's section 7, but for the factor: S_k = λ^k times it for M = λI. It is had in
one step from the sum rules, and (7.3), which says that the S_j for j < k reproduce constants, is not asked for.

The q_ν are not unique. Two choices:

* as in the proof of Lemma 6.6, one variable after the other: p = Σ_(i<k) (1-y_1)^i c_i(y_2, …) + (1-y_1)^k r(y), and
  c_i vanishes at 1 to order k - i.
* with the least sum of all |coefficients|, for each coset and μ: a linear programme. For k = 1 that is the cost of
  moving the positive part of p to the negative part along edges of Z^s, by duality the largest Σ_β p_β f_β for data f
  with differences at most 1: no reduction has a smaller norm, and the norm is that of S_Δ on differences (6.45).

All stay in the smallest box that holds the support of p, which must have sides of at least k.

Norms of matrix schemes of differences, and the search for one that is small enough.

For Q, the reduction of S^r, ‖S_Q^t‖∞ is the largest Σ_ν Σ_β |Q_μν| over μ and the cosets γ + M^(rt) β, of
Q(z) Q(z^(M^r)) … Q(z^(M^(r(t-1)))) (Dyn 1992, Proposition 6.10). It bounds ρ_k^(rt) from above.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import product
from math import lcm, prod
from typing import NamedTuple

from subdiv_cli.exact.linalg import Combination, combinations
from subdiv_cli.kinds.multivariate.numbers.box_spline import iterated, multiplied
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.model import Effort
from subdiv_cli.spaces.lattice import Index, Lattice, box, indices_of_degree, times
from subdiv_cli.spaces.stencils import difference

Terms = dict[Index, Fraction]
Shifted = tuple[Index, Index]
"""The pair of β and ν for y^β (1-y)^ν."""

_LARGEST_WINDOW = 128
_MOST_PARTS = 400


class CosetPart(NamedTuple):
    """A coset of (1-z)^μ a^[r](z): the terms at γ + M^r β, `terms` from β = 0 of its smallest box."""

    row: int
    """The number of μ."""
    origin: Index
    """The index in Z^s where β = 0."""
    terms: Terms


class ReductionProblem(NamedTuple):
    """A division to be done: the parts of all cosets and μ, and a box that holds each of them."""

    order: int
    """The order k of the differences."""
    lattice: Lattice
    """The lattice of M^r."""
    parts: tuple[CosetPart, ...]
    spans: Index

    @property
    def components(self) -> tuple[Index, ...]:
        """All multi-indices ν with |ν| = k in lexicographic order."""
        return tuple(indices_of_degree(self.lattice.dimension, self.order))


class Reduction(NamedTuple):
    """The coefficients of the y^β (1-y)^ν for each part, and their largest sum of absolute values."""

    problem: ReductionProblem
    coefficients: tuple[dict[Shifted, Fraction], ...]

    @property
    def norm(self) -> Fraction:
        """The norm of the matrix scheme (Dyn 1992, 6.47)."""
        return max(sum(map(abs, terms.values()), Fraction(0)) for terms in self.coefficients)

    def entries(self) -> dict[tuple[int, int], Terms]:
        """The Laurent polynomials q_μν that are not zero, by the numbers of μ and ν."""
        components, total = self.problem.components, dict[tuple[int, int], Terms]()
        for part, terms in zip(self.problem.parts, self.coefficients, strict=True):
            for (beta, nu), x in terms.items():
                at = _sum(part.origin, self.problem.lattice.image(beta))
                total.setdefault((part.row, components.index(nu)), {})[at] = x
        return total


def problem(scheme: MultivariateScheme, lattice: Lattice, k: int, power: int) -> ReductionProblem | None:
    """The division for S^power and differences of order k >= 1, at most that of the sum rules; None if too large."""
    symbol = iterated(scheme, lattice, power)
    s, dilation = lattice.dimension, lattice.dilation
    if symbol is None:
        return None
    for _ in range(power - 1):
        dilation = times(lattice.dilation, dilation)
    whole, parts = Lattice(dilation), list[CosetPart]()
    for row, mu in enumerate(indices_of_degree(s, k)):
        cosets: dict[Index, Terms] = {}
        for alpha, x in multiplied(symbol, {beta: Fraction(y) for beta, y in difference(mu).items()}).items():
            cosets.setdefault(whole.coset(alpha), {})[alpha] = x
        parts += [_part(whole, row, terms) for terms in cosets.values()]
    highest = zip(*(map(max, zip(*part.terms, strict=True)) for part in parts), strict=True)
    spans = tuple(max(k, *column) for column in highest)
    if prod(x + 1 for x in spans) > _LARGEST_WINDOW or len(parts) > _MOST_PARTS:
        return None
    return ReductionProblem(k, whole, tuple(parts), spans)


def by_lemma(problem: ReductionProblem) -> Reduction:
    """The reduction of one variable after the other, as in the proof of Lemma 6.6."""
    columns, names, basis, targets = _programme(problem)
    weights = combinations(columns, targets, basis)
    assert weights is not None
    return _named(problem, names, weights)


def least(problem: ReductionProblem) -> Reduction:
    """The reduction of least norm within the box, as far as floats tell; exact, whether or not it is the least."""
    from subdiv_cli.jsr.least import least_combinations  # numpy comes with it

    columns, names, basis, targets = _programme(problem)
    return _named(problem, names, least_combinations(columns, targets, basis))


def _programme(problem: ReductionProblem) -> tuple[list[list[int]], list[Shifted], list[int], list[list[Fraction]]]:
    """The linear programme: columns y^β (1-y)^ν in the box, their names, those of the lemma, and the parts.

    All are taken at indices |β| >= k. A sequence that annihilates π_(k-1) and vanishes there vanishes: values at
    |β| < k, β >= 0, determine π_(k-1).
    """
    k, spans = problem.order, problem.spans
    places = [beta for beta in box((0,) * len(spans), spans) if sum(beta) >= k]
    columns, names = [], []
    for nu in problem.components:
        for beta in box((0,) * len(spans), tuple(n - x for n, x in zip(spans, nu, strict=True))):
            shifted = {_sum(alpha, beta): x for alpha, x in difference(nu).items()}
            columns.append([shifted.get(place, 0) for place in places])
            names.append((beta, nu))
    numbers = {name: i for i, name in enumerate(names)}
    basis = [numbers[name] for name in _basis(k, spans)]
    targets = [[part.terms.get(place, Fraction(0)) for place in places] for part in problem.parts]
    return columns, names, basis, targets


def _basis(k: int, spans: Index) -> list[Shifted]:
    """A basis of the polynomials in the box that vanish at 1 to order k, one variable after the other."""
    if not spans:
        return []
    first, rest = spans[0], spans[1:]
    basis: list[Shifted] = [((0, *beta), (i, *nu)) for i in range(k) for beta, nu in _basis(k - i, rest)]
    whole = product(range(first - k + 1), *(range(n + 1) for n in rest))
    return [*basis, *((beta, (k, *((0,) * len(rest)))) for beta in whole)]


def _named(problem: ReductionProblem, names: Sequence[Shifted], weights: Sequence[Combination]) -> Reduction:
    return Reduction(problem, tuple({names[i]: x for i, x in each.items()} for each in weights))


def _part(lattice: Lattice, row: int, terms: Terms) -> CosetPart:
    first = next(iter(terms))
    places = {}
    for alpha, x in terms.items():
        beta = lattice.preimage(tuple(i - j for i, j in zip(alpha, first, strict=True)))
        assert beta is not None
        places[beta] = x
    lowest = tuple(map(min, zip(*places, strict=True)))
    moved = {tuple(i - j for i, j in zip(beta, lowest, strict=True)): x for beta, x in places.items()}
    return CosetPart(row, _sum(first, lattice.image(lowest)), moved)


def _sum(alpha: Index, beta: Index) -> Index:
    return tuple(i + j for i, j in zip(alpha, beta, strict=True))


HIGHEST_POWER = 3
"""The highest power r of S."""
_MOST_STEPS = 4
"""The most steps t."""
_UNIT = 100
"""Products of two coefficients, or entries of the inverses of bases, that count for one of the effort."""
_FOR_CONVERGENCE = 2_000
"""The share of the effort for the iterates of one reduction."""

Numerators = dict[tuple[int, int], dict[Index, int]]


class MatrixNorm(NamedTuple):
    """A norm ‖S_Q^steps‖∞ = norm, Q a reduction of S^power for differences of this order."""

    order: int
    power: int
    steps: int
    norm: Fraction
    by: str
    """The reduction that is taken: `lemma` or `least`."""
    lemma: Fraction
    """The norm ‖S_Q‖∞ for the reduction of Lemma 6.6."""
    least: Fraction | None
    """The norm ‖S_Q‖∞ for the reduction of least norm, where it was computed."""
    entries: Mapping[tuple[int, int], Terms]
    components: int
    """The number of the multi-indices ν."""
    work: int
    """The products of two coefficients that multiply it all out, and the coefficients of the last product."""

    @property
    def level(self) -> int:
        """The level rt: the norm bounds ρ_k^(rt) from above."""
        return self.power * self.steps


class Iterate(NamedTuple):
    """The norm ‖S_Q^t‖∞ of one iterate, t = 1, 2, and so on."""

    norm: Fraction
    work: int
    """The products of two coefficients so far, and the coefficients now."""


def iterates(reduction: Reduction, effort: Effort) -> Iterator[Iterate]:
    """The norms ‖S_Q^t‖∞ for t = 1, 2, … as far as the effort goes."""
    entries, lattice = reduction.entries(), reduction.problem.lattice
    common = lcm(*(x.denominator for terms in entries.values() for x in terms.values()))
    factor = {at: {alpha: int(x * common) for alpha, x in terms.items()} for at, terms in entries.items()}
    done, denominator, spent, modulus = factor, common, 0, lattice
    while True:
        length = sum(map(len, done.values()))
        yield Iterate(Fraction(_largest_sum(done, modulus), denominator), spent + length)
        factor = {at: {lattice.image(alpha): x for alpha, x in terms.items()} for at, terms in factor.items()}
        spent += sum(len(f) * len(g) for (_, j), f in done.items() for (i, _), g in factor.items() if i == j)
        if not effort.allows(spent // _UNIT):
            return
        done, denominator = _multiplied(done, factor), denominator * common
        columns = zip(*modulus.dilation, strict=True)
        modulus = Lattice(tuple(zip(*(lattice.image(column) for column in columns), strict=True)))


def matrix_norm(
    scheme: MultivariateScheme, lattice: Lattice, order: int, smooth: int, effort: Effort
) -> MatrixNorm | None:
    """A norm with ρ_k <= ‖S_Q^t‖∞^(1/L) < λ^-smooth for k = `order` and a level L = rt; None where none is small.

    The reductions of S: that of the lemma, the one of least norm, iterates of the better one; then those of S^r.
    """
    for power in range(1, HIGHEST_POWER + 1):
        reducible = problem(scheme, lattice, order, power)
        cells = 0 if reducible is None else len(reducible.parts) * _cells(reducible)
        if reducible is None or not effort.allows(cells // _UNIT):
            return None
        first = by_lemma(reducible)
        best, by, second = first, "lemma", None
        if not _is_small(first.norm, lattice, power * smooth):
            second = least(reducible)
            if second.norm < first.norm:
                best, by = second, "least"
        part = effort if smooth else effort.limited(_FOR_CONVERGENCE)
        for steps, iterate in enumerate(iterates(best, part), 1):
            if _is_small(iterate.norm, lattice, power * steps * smooth):
                entries, count = best.entries(), len(reducible.components)
                lowest = None if second is None else second.norm
                work = iterate.work + _identity_work(scheme, lattice, best, power)
                return MatrixNorm(order, power, steps, iterate.norm, by, first.norm, lowest, entries, count, work)
            if steps == (_MOST_STEPS if power == 1 else 1):
                break
    return None


def _identity_work(scheme: MultivariateScheme, lattice: Lattice, reduction: Reduction, power: int) -> int:
    """The products of two coefficients in a^[r], (1-z)^μ a^[r] and Σ_ν q_μν (1-z^M^r)^ν, r the power."""
    problem = reduction.problem
    sizes = [len(iterated(scheme, lattice, i) or {}) for i in range(1, power + 1)]
    corners = [prod(x + 1 for x in nu) for nu in problem.components]
    right = sum(len(terms) * corners[j] for (_, j), terms in reduction.entries().items())
    return sum(size * len(scheme.terms) for size in sizes[:-1]) + sizes[-1] * sum(corners) + right


def _cells(problem: ReductionProblem) -> int:
    size = 1
    for span in problem.spans:
        size *= span + 1
    return size**2


def _is_small(norm: Fraction, lattice: Lattice, exponent: int) -> bool:
    """Whether norm < λ^-exponent, compared by s-th powers."""
    return bool(norm**lattice.dimension * lattice.index**exponent < 1)


def _multiplied(a: Numerators, b: Numerators) -> Numerators:
    """The product of two matrices of Laurent polynomials."""
    total: Numerators = {}
    for (i, j), f in a.items():
        for (k, n), g in b.items():
            if j == k:
                into = total.setdefault((i, n), {})
                for alpha, x in f.items():
                    for beta, y in g.items():
                        at = tuple([p + q for p, q in zip(alpha, beta, strict=True)])
                        into[at] = into.get(at, 0) + x * y
    return {at: {alpha: x for alpha, x in terms.items() if x} for at, terms in total.items()}


def _largest_sum(entries: Numerators, modulus: Lattice) -> int:
    """The largest sum of absolute values in a row over a coset."""
    sums: dict[tuple[int, Index], int] = {}
    for (row, _), terms in entries.items():
        for alpha, x in terms.items():
            key = row, modulus.coset(alpha)
            sums[key] = sums.get(key, 0) + abs(x)
    return max(sums.values())
