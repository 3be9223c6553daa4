"""Norms of matrix schemes of differences, and the search for one that is small enough.

For Q, the reduction of S^r, ‖S_Q^t‖∞ is the largest Σ_ν Σ_β |Q_μν| over μ and the cosets γ + M^(rt) β, of
Q(z) Q(z^(M^r)) … Q(z^(M^(r(t-1)))) (Dyn 1992, Proposition 6.10). It bounds ρ_k^(rt) from above.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from math import lcm, prod
from typing import NamedTuple

from subdiv_cli.kinds.multivariate.lattice import Lattice
from subdiv_cli.kinds.multivariate.numbers.box_spline import iterated
from subdiv_cli.kinds.multivariate.numbers.matrix_schemes import Question, Reduction, Terms, by_lemma, least, question
from subdiv_cli.kinds.multivariate.scheme import Index, MultivariateScheme
from subdiv_cli.model import Effort

HIGHEST_POWER = 3
"""r."""
_MOST_STEPS = 4
"""t."""
_UNIT = 100
"""Products of two coefficients, or entries of the inverses of bases, that count for one of the effort."""
_FOR_CONVERGENCE = 2_000
"""Of the effort, for the iterates of one reduction."""

Numerators = dict[tuple[int, int], dict[Index, int]]


class MatrixNorm(NamedTuple):
    """‖S_Q^steps‖∞ = norm, Q a reduction of S^power for differences of this order."""

    order: int
    power: int
    steps: int
    norm: Fraction
    by: str
    """`lemma` or `least`: which reduction."""
    lemma: Fraction
    """‖S_Q‖∞ for the reduction of Lemma 6.6."""
    least: Fraction | None
    """‖S_Q‖∞ for the one of least norm, where it was asked for."""
    entries: Mapping[tuple[int, int], Terms]
    components: int
    """How many ν there are."""
    work: int
    """Products of two coefficients to multiply it all out, and coefficients of the last product."""

    @property
    def level(self) -> int:
        return self.power * self.steps


class Iterate(NamedTuple):
    """‖S_Q^t‖∞, t = 1, 2, …"""

    norm: Fraction
    work: int
    """Products of two coefficients so far, and coefficients now."""


def iterates(found: Reduction, effort: Effort) -> Iterator[Iterate]:
    """As far as the effort goes."""
    entries, lattice = found.entries(), found.question.lattice
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
    """For k = `order` a level L = rt with ρ_k <= ‖S_Q^t‖∞^(1/L) < λ^-smooth; None where none is found.

    The reductions of S: that of the lemma, the one of least norm, iterates of the better one; then those of S^r.
    """
    for power in range(1, HIGHEST_POWER + 1):
        asked = question(scheme, lattice, order, power)
        cells = 0 if asked is None else len(asked.parts) * _cells(asked)
        if asked is None or not effort.allows(cells // _UNIT):
            return None
        first = by_lemma(asked)
        best, by, second = first, "lemma", None
        if not _is_small(first.norm, lattice, power * smooth):
            second = least(asked)
            if second.norm < first.norm:
                best, by = second, "least"
        part = effort if smooth else effort.limited(_FOR_CONVERGENCE)
        for steps, iterate in enumerate(iterates(best, part), 1):
            if _is_small(iterate.norm, lattice, power * steps * smooth):
                entries, count = best.entries(), len(asked.components)
                lowest = None if second is None else second.norm
                work = iterate.work + _identity_work(scheme, lattice, best, power)
                return MatrixNorm(order, power, steps, iterate.norm, by, first.norm, lowest, entries, count, work)
            if steps == (_MOST_STEPS if power == 1 else 1):
                break
    return None


def _identity_work(scheme: MultivariateScheme, lattice: Lattice, found: Reduction, power: int) -> int:
    """Products of two coefficients in a^[r], (1-z)^μ a^[r] and Σ_ν q_μν (1-z^M^r)^ν, r the power."""
    asked = found.question
    sizes = [len(iterated(scheme, lattice, i) or {}) for i in range(1, power + 1)]
    corners = [prod(x + 1 for x in nu) for nu in asked.components]
    right = sum(len(terms) * corners[j] for (_, j), terms in found.entries().items())
    return sum(size * len(scheme.terms) for size in sizes[:-1]) + sizes[-1] * sum(corners) + right


def _cells(asked: Question) -> int:
    size = 1
    for span in asked.spans:
        size *= span + 1
    return size**2


def _is_small(norm: Fraction, lattice: Lattice, exponent: int) -> bool:
    """norm < λ^-exponent, by s-th powers."""
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
    """Of absolute values in a row over a coset."""
    sums: dict[tuple[int, Index], int] = {}
    for (row, _), terms in entries.items():
        for alpha, x in terms.items():
            key = row, modulus.coset(alpha)
            sums[key] = sums.get(key, 0) + abs(x)
    return max(sums.values())
