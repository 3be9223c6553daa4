"""The functionals that determine the limits of a piecewise scheme near 0: convergence and smoothness decided there.

S is a scheme of arity p with a mask on each side of 0 and finitely many special rows; x is the geometric parameter, in
which old point i lies at i h, h the spacing of its side. S converges if for all data c there is a continuous F_c with
S^n c(i) - F_c(p^-n x_i) -> 0, uniformly on bounded sets, and F_c(0) ≠ 0 for some c. A cell of a side is [j, j+1] h, so
far from 0 that no special row and no row of the other side is ever used for the limit in it: there F_c is Σ c_i
φ(x/h - i), φ of the side's mask. The window W holds the data that the limit in the cells J <= j < pJ of both sides
needs, all points between, and all that its points are computed from; A is S on W, and rows v act on data by v·c.

Theorem 1 (convergence). S converges iff both masks do, all rows of S sum to 1, and A has the spectral radius ρ_0 < 1 on
{v on W : Σ v = 0}.

  Only if: data far from 0 on one side have the limits of its mask there, and these are not all 0, as F_c is continuous
  and F_c(0) ≠ 0 for some c. A point i has p^-n x_i -> 0, so that (S^n c)(i) -> F_c(0) for every i; in one more step
  this is Σ (row i) times that, and the row sums to 1. So A^n -> e v^T, and v' A^n -> (v'·e) v^T = 0 where Σ v' = 0.
  If: constants stay, so F_c = 1 for c = 1. A difference S^n c(i+1) - S^n c(i) is traced back by the rule of the side as
  long as its points stay in cells, by m levels say; it is then a combination of differences near W at level n - m, of
  size C q^m with q < 1, as the mask converges. All points near W have their ancestors in W after a fixed number of
  levels, where differences are O(q'^(n-m)) for a q' < 1: differences are O(max(q, q')^n n), uniformly.

Theorem 2 (exponent at 0). Let S converge, I be the union of [0, pJh] and its counterpart on the left, F(x) the row v on
W with v·c = F_c(x), and 𝓕_k the space of the combinations Σ μ_i F(x_i), x_i in I, with Σ μ_i x_i^d = 0 for d < k. Then
𝓕_k A ⊂ 𝓕_k, as F(x) A = F(x/p). With ρ_k the spectral radius of A on 𝓕_k: all limits are polynomials of degree < k plus
O(|x|^β) at 0 for each β < min(k, -log_p ρ_k), and, if k > -log_p ρ_k, not for a larger β < k.

  The space E of the limits on I is the dual of 𝓕_0, D f = f(·/p) on E the dual of A, and E/(E ∩ π_(k-1)) the dual of
  𝓕_k. Where ρ_k < q, E is the sum of D-invariant spaces P ⊂ π_(k-1) and R, ‖D^m r‖ = O(q^m) in the maximum norm for r
  in R: so r = O(|x|^β), p^-β = q; of P a polynomial of degree < β is left, and the rest is O(|x|^β) as well.
  Conversely, μ in 𝓕_k has μ A^m c = Σ μ_i F_c(p^-m x_i) = O(p^-mβ) if F_c is a polynomial of degree < k plus
  O(|x|^β), so that ρ_k <= p^-β.

Theorem 3 (smoothness). Let S converge. All limits are C^n iff those of both masks are and ρ_k < p^-n for a k > n, and
then for every k > n. They are in C^β for all β < α = min(α_left, α_right, -log_p ρ_k) and not all for a larger one, as
soon as this is below k, and for all β < k if it is not.

  In a cell the limits are those of the mask, of data that may be any; near x ≠ 0 they are such limits at some level.
  Let both masks be C^n and ρ_k < p^-n: in theorem 2 r is C^n on the outer part [Jh, pJh], with norms bounded by that of
  r, as E is of finite dimension; so r^(j)(x) = O(|x|^(β-j)), j <= n < β, on the smaller copies of it: r is C^n with
  derivatives 0 at 0. For C^β likewise, by the sum over the copies. Conversely, if F_c is C^n, μ A^m c = o(p^-mn) for μ
  in 𝓕_k, k > n, so that ρ_k < p^-n; and in C^β, β < k, it is O(p^-mβ). For f in C^k it is O(p^-mk): ρ_k > p^-k
  excludes C^k.

No eigenfunction has to be seen not to vanish: what no limit shows is in no functional. 𝓕_k is computed exactly: the
rows (F(x), 1, x, …, x^(k-1)) of one cell are spanned by the images of the one at its left end under x -> (x + ε)/p;
those of all cells and their images under A ⊕ diag(1, p^-1, …) span all of them; those that end in zeros are 𝓕_k.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cached_property
from math import comb
from typing import NamedTuple

from flint import fmpq, fmpq_mat

from subdiv_cli.exact.linalg import eigenvectors
from subdiv_cli.exact.rationals import to_fmpq
from subdiv_cli.kinds.piecewise.scheme import PiecewiseScheme
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.model import Look, no_clock

LARGEST_WINDOW = 400
"""The most points of a window."""


class Cells(NamedTuple):
    """The cells of a side that generate all others: the limit in cell j needs the data j + low, …, j + high."""

    mask: ScalarScheme
    spacing: Fraction
    low: int
    high: int
    numbers: range
    """The numbers j of the cells, J <= j < pJ on the right, -pJ <= j < -J on the left."""

    @property
    def points(self) -> range:
        """The indices of the data that they need."""
        return range(min(self.numbers) + self.low, max(self.numbers) + self.high + 1)


class RowSpace(NamedTuple):
    """A space of rows on the window, mapped into itself by A."""

    basis: fmpq_mat
    """The basis in reduced echelon form."""
    matrix: fmpq_mat
    """The matrix M with basis A = M basis."""

    @property
    def dimension(self) -> int:
        """The dimension."""
        return self.basis.nrows()


def cells_of(scheme: PiecewiseScheme) -> tuple[Cells, Cells]:
    """The cells of both sides, the left one first.

    A point i that the limit at t needs at some level has t - e/(p-1) <= i <= t - s/(p-1) for a mask on [s, e], and i
    between t and that bound where it was computed from more points; all but the data themselves are points of S.
    """
    p, special = scheme.arity, [i for i, _ in scheme.special]
    results = []
    for is_left, mask in ((True, scheme.left), (False, scheme.right)):
        s, e = mask.start, mask.start + mask.degree
        if is_left:
            first = min([0, *special]) - 1  # all rows up to this one are those of the mask: p(1-j) + … <= first
            farthest = max(1, -(-(-first + max(0, -(s // (p - 1)))) // p))
            numbers = range(-p * farthest, -farthest)
        else:
            first = max([-1, *special]) + 1
            farthest = max(1, -(-(first + max(0, -(-e // (p - 1)))) // p))
            numbers = range(farthest, p * farthest)
        spacing = scheme.spacing[0 if is_left else 1]
        results.append(Cells(mask, spacing, -(e // (p - 1)), 1 + (-s) // (p - 1), numbers))
    return results[0], results[1]


def window_of(scheme: PiecewiseScheme, cells: Iterable[Cells]) -> range | None:
    """The window W, an interval; None where it has more than LARGEST_WINDOW points."""
    points = [i for each in cells for i in (each.points[0], each.points[-1])]
    low, high = min(0, *points), max(0, *points)
    while high - low < LARGEST_WINDOW:
        inputs = [j for i in range(low, high + 1) for j, _ in scheme.row(i)]
        if low <= min(inputs, default=low) and max(inputs, default=high) <= high:
            return range(low, high + 1)
        low, high = min(low, *inputs), max(high, *inputs)
    return None


def attractor(scheme: PiecewiseScheme, window: range) -> tuple[int, ...]:
    """The points that all others are computed from in the long run: the smallest closed set that determines limits."""
    points, inputs = set[int](), set(window)
    while inputs != points:
        points = inputs
        inputs = {j for i in points for j, _ in scheme.row(i)}
    return tuple(sorted(points))


class Functionals:
    """The spaces of theorems 1 to 3 for one scheme, whose window is not too large; rows lie on the window.

    What takes long looks at the clock, and raises what `look` raises.
    """

    def __init__(self, scheme: PiecewiseScheme, cells: Sequence[Cells], window: range, look: Look = no_clock) -> None:
        self.scheme, self.cells, self.window, self._look = scheme, cells, window, look

    @cached_property
    def refinement(self) -> fmpq_mat:
        """The matrix A: entry (i, j) is the weight of old point j in new point i, both on the window."""
        size, first = len(self.window), self.window[0]
        a = fmpq_mat(size, size)
        for i in self.window:
            for j, weight in self.scheme.row(i):
                a[i - first, j - first] = to_fmpq(weight)
        return a

    @cached_property
    def all_rows(self) -> RowSpace:
        """The recurrent part of all rows: what A does to data in the long run."""
        size = len(self.window)
        return self._recurrent(fmpq_mat(size, size, [int(i == j) for i in range(size) for j in range(size)]))

    @cached_property
    def differences(self) -> RowSpace:
        """The recurrent part of {v : Σ v = 0}; all rows of S must sum to 1."""
        size = len(self.window)
        return self._recurrent(
            fmpq_mat(size - 1, size, [(i == j) - (i + 1 == j) for i in range(size - 1) for j in range(size)])
        )

    @cached_property
    def value(self) -> tuple[Fraction, ...]:
        """The row v with F_c(0) = v·c, of a scheme that converges: v A = v, Σ v = 1."""
        (fixed,) = eigenvectors(self.refinement.transpose(), 1)
        total = sum(fixed, Fraction(0))
        return tuple(x / total for x in fixed)

    def annihilating(self, k: int) -> RowSpace:
        """The recurrent part of 𝓕_k, k >= 0, of a scheme that converges."""
        size, p = len(self.window), self.scheme.arity
        shrink = fmpq_mat(k, k, [fmpq(1, p**d) if d == r else 0 for r in range(k) for d in range(k)]) if k else None
        rows = [row for cells in self.cells for row in self._of_cells(cells, k)]
        # the powers of x come first: rows that begin with zeros are those of 𝓕_k, also in echelon form
        step = _blocks(shrink, self.refinement)
        span = spanned(fmpq_mat(rows), [step], self._look)
        kept = [row[k:] for row in span.tolist() if not any(row[:k])]
        return self._recurrent(fmpq_mat(kept) if kept else fmpq_mat(0, size))

    def _of_cells(self, cells: Cells, k: int) -> list[list[fmpq]]:
        """The rows (1, x, …, x^(k-1), F(x)) of all cells of a side."""
        rows, width, first = cell_rows(cells, k, self._look), cells.high - cells.low + 1, self.window[0]
        results = []
        for j in cells.numbers:
            place = j + cells.low - first
            to_x = _substitution(cells.spacing, j, k)
            for row in rows.tolist():
                powers = (fmpq_mat([row[:k]]) * to_x).tolist()[0] if k else []
                after = len(self.window) - place - width
                results.append([*powers, *([fmpq(0)] * place), *row[k:], *([fmpq(0)] * after)])
        return results

    def _recurrent(self, rows: fmpq_mat) -> RowSpace:
        """What is left of a space of rows, which A maps into itself, after enough steps, and A on it."""
        basis, before = echelon(rows), -1
        while basis.nrows() != before:
            self._look()
            before = basis.nrows()
            basis = echelon(basis * self.refinement) if before else basis
        pivots = _pivots(basis)
        image = (basis * self.refinement).tolist() if pivots else []
        n = len(pivots)
        return RowSpace(basis, fmpq_mat(n, n, [row[j] for row in image for j in pivots]))


def stencil(cells: Cells) -> fmpq_mat | None:
    """The row F(0) of the cell [0, 1] of a side alone, its limit stencil; None where it is not determined."""
    fixed = eigenvectors(_cell_matrix(cells, 0).transpose(), 1)
    if len(fixed) != 1 or not (total := sum(fixed[0], Fraction(0))):
        return None
    return fmpq_mat([[to_fmpq(x / total) for x in fixed[0]]])


def cell_rows(cells: Cells, k: int, look: Look = no_clock) -> fmpq_mat:
    """A basis of the rows (1, t, …, t^(k-1), F(t)) for t in the cell [0, 1] of a side that converges.

    Raises ArithmeticError where it has no limit stencil.
    """
    first = stencil(cells)
    if first is None:
        raise ArithmeticError("a side has no limit stencil")
    start = fmpq_mat([[fmpq(int(d == 0)) for d in range(k)] + first.tolist()[0]])
    p = cells.mask.arity
    steps = [
        _blocks(_substitution(Fraction(1, p), Fraction(e, p), k, scaled=False) if k else None, _cell_matrix(cells, e))
        for e in range(p)
    ]
    return spanned(start, steps, look)


def _cell_matrix(cells: Cells, epsilon: int) -> fmpq_mat:
    """The matrix that takes the row F(t) to F((t + ε)/p), both for the cell [0, 1]."""
    mask, size = cells.mask, range(cells.low, cells.high + 1)
    entries = []
    for i in size:
        for j in size:
            at = i + epsilon - mask.arity * j - mask.start
            entries.append(to_fmpq(mask.coefficients[at]) if 0 <= at <= mask.degree else fmpq(0))
    return fmpq_mat(len(size), len(size), entries)


def _substitution(factor: Fraction, shift: Fraction | int, k: int, scaled: bool = True) -> fmpq_mat:
    """The k×k matrix that takes the row (1, t, …) to that of factor (t + shift), or of factor t + shift."""
    inner, outer = (Fraction(1), factor) if scaled else (factor, Fraction(1))
    entries = [
        to_fmpq(outer**d * comb(d, r) * inner**r * Fraction(shift) ** (d - r)) if r <= d else fmpq(0)
        for r in range(k)
        for d in range(k)
    ]
    return fmpq_mat(k, k, entries)


def _blocks(first: fmpq_mat | None, second: fmpq_mat) -> fmpq_mat:
    """The block diagonal matrix of two square ones, the first of which may be missing."""
    k = first.nrows() if first is not None else 0
    size = k + second.nrows()
    total = fmpq_mat(size, size)
    for part, at in ((first, 0), (second, k)):
        if part is not None:
            for i, row in enumerate(part.tolist()):
                for j, x in enumerate(row):
                    total[at + i, at + j] = x
    return total


def echelon(rows: fmpq_mat) -> fmpq_mat:
    """The span of rows by its reduced echelon form, without rows of zeros."""
    if not rows.nrows():
        return rows
    form, rank = rows.rref()
    return fmpq_mat(form.tolist()[:rank]) if rank else fmpq_mat(0, rows.ncols())


def spanned(rows: fmpq_mat, steps: Sequence[fmpq_mat], look: Look = no_clock) -> fmpq_mat:
    """The smallest space that holds the rows and is mapped into itself by matrices on the right, in echelon form."""
    space, before = echelon(rows), -1
    while space.nrows() != before:
        look()
        before = space.nrows()
        images = [row for step in steps for row in (space * step).tolist()]
        space = echelon(fmpq_mat([*space.tolist(), *images]))
    return space


def _pivots(form: fmpq_mat) -> list[int]:
    return [next(j for j, x in enumerate(row) if x) for row in form.tolist()]
