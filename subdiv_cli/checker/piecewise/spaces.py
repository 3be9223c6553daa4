"""The spaces of rows near 0, computed exactly, and the rules that introduce A on them as families of one matrix.

A row v on the window acts on data by v·c; A is S on the window, and v A acts on S c. All is Gaussian elimination.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from math import comb, gcd, lcm

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import RationalFamily
from subdiv_cli.checker.piecewise.masks import SideCells, TwoMasks, masks_of
from subdiv_cli.checker.reading import MAX_ORDER, Rejected, require, require_few

MAX_ORDER_OF_SPACES = 200
Row = list[int]
"""A row of rationals up to a factor > 0: spaces do not depend on it."""
Step = Callable[[Row], Row]


class Echelon:
    """A space of rows by rows with different leading places."""

    def __init__(self, rows: Iterable[Row] = ()) -> None:
        self.rows: dict[int, Row] = {}
        """The rows by their leading places."""
        for row in rows:
            self.add(row)

    def add(self, row: Row) -> Row | None:
        """The row that was added to hold this one too; None where the space has it."""
        for place in range(len(row)):
            if row[place] and (own := self.rows.get(place)) is not None:
                x, y = row[place], own[place]
                row = primitive([y * a - x * b for a, b in zip(row, own, strict=True)])
        if not any(row):
            return None
        leading = next(j for j, x in enumerate(row) if x)
        self.rows[leading] = primitive(row)
        return self.rows[leading]

    def basis(self) -> list[Row]:
        """The rows by their leading places."""
        return [self.rows[place] for place in sorted(self.rows)]


def primitive(row: Row) -> Row:
    """The row of integers without a common factor."""
    common = gcd(*row)
    return row if common < 2 else [x // common for x in row]


def spanned(rows: Iterable[Row], steps: Sequence[Step]) -> Echelon:
    """The smallest space that holds the rows and is mapped into itself by the steps."""
    space, waiting = Echelon(), list(rows)
    while waiting:
        added = space.add(waiting.pop())
        if added is not None:
            waiting += [step(added) for step in steps]
    return space


class Window:
    """The window of a piecewise mask, and A on its rows."""

    def __init__(self, masks: TwoMasks) -> None:
        self.masks, self.cells, self.points = masks, masks.cells(), masks.window()
        self.first = self.points[0]
        rows = [masks.row(i) for i in self.points]
        self.denominator = lcm(*(x.denominator for row in rows for x in row.values()))
        """The common denominator of the entries of A."""
        self._rows = [{j - self.first: int(x * self.denominator) for j, x in row.items()} for row in rows]

    def step(self, v: Row) -> Row:
        """The row v A times the denominator."""
        image = [0] * len(v)
        for x, row in zip(v, self._rows, strict=True):
            if x:
                for j, weight in row.items():
                    image[j] += x * weight
        return image

    def work(self, k: int) -> int:
        """The operations that the spaces of order k take, at most nearly."""
        p, size = self.masks.arity, len(self.points) + k
        cells = sum(p * (each.high - each.low + 1 + k) ** 3 for each in self.cells)
        rows = sum(len(each.numbers) * (each.high - each.low + 1 + k) for each in self.cells)
        return cells + (rows + 3 * size) * size**2

    def bits(self, k: int) -> int:
        """The bits that numbers of spaces of order k have, at most nearly."""
        return self.masks.bits * (len(self.points) + k)

    def attractor(self) -> tuple[int, ...]:
        """The points that all are computed from after enough steps."""
        points, inputs = set[int](), set(self.points)
        while inputs != points:
            points = inputs
            inputs = {j for i in points for j in self.masks.row(i)}
        return tuple(sorted(points))

    def all_rows(self) -> list[Row]:
        """The recurrent part of all rows."""
        size = len(self.points)
        return self.recurrent([[int(i == j) for j in range(size)] for i in range(size)])

    def differences(self) -> list[Row]:
        """The recurrent part of the rows that sum to 0; all rows of S must sum to 1."""
        size = len(self.points)
        return self.recurrent([[(i == j) - (i + 1 == j) for j in range(size)] for i in range(size - 1)])

    def annihilating(self, k: int) -> list[Row]:
        """The recurrent part of 𝓕_k: rows (1, x, …, x^(k-1), F(x)) that begin with zeros, k > 0."""
        p = self.masks.arity
        shrink = [self.denominator * p ** (k - 1 - d) for d in range(k)]

        def step(row: Row) -> Row:
            powers = [x * y for x, y in zip(row[:k], shrink, strict=True)]
            return primitive(powers + [x * p ** (k - 1) for x in self.step(row[k:])])

        rows = [row for cells in self.cells for row in self._of_cells(cells, k)]
        return self.recurrent([row[k:] for row in spanned(rows, [step]).basis() if not any(row[:k])])

    def _of_cells(self, cells: SideCells, k: int) -> Iterable[Row]:
        u, v = cells.spacing.numerator, cells.spacing.denominator
        for row in _of_one_cell(cells, self.masks.arity, k):
            for j in cells.numbers:
                placed, place = [0] * len(self.points), j + cells.low - self.first
                placed[place : place + len(row) - k] = [x * v ** (k - 1) for x in row[k:]]
                yield [u**d * v ** (k - 1 - d) * x for d, x in enumerate(_moved(row[:k], j))] + placed

    def recurrent(self, rows: list[Row]) -> list[Row]:
        """What is left of a space, which A maps into itself, after enough steps."""
        basis = Echelon(rows).basis()
        while len(smaller := Echelon(map(self.step, basis)).basis()) < len(basis):
            basis = smaller
        return smaller

    def family(self, basis: list[Row]) -> RationalFamily:
        """A on a space that it maps into itself, as a family of one matrix: row i has the coordinates of b_i A.

        Raises Rejected where it does not. The basis has different leading places, rising.
        """
        entries = []
        for row in basis:
            left, coordinates = [Fraction(x, self.denominator) for x in self.step(row)], list[Fraction]()
            for own in basis:
                place = next(j for j, x in enumerate(own) if x)
                coordinates.append(left[place] / own[place])
                if coordinates[-1]:
                    left = [a - coordinates[-1] * b for a, b in zip(left, own, strict=True)]
            require(not any(left), "the space is not invariant")
            entries.append(coordinates)
        common = lcm(*(x.denominator for row in entries for x in row))
        numerators = [[x.numerator * (common // x.denominator) for x in row] for row in entries]
        return matrices.family([numerators], common)


def _moved(powers: Row, by: int) -> Row:
    """The row (1, t + by, …) from (1, t, …)."""
    return [sum(comb(d, r) * by ** (d - r) * powers[r] for r in range(d + 1)) for d in range(len(powers))]


def _of_one_cell(cells: SideCells, p: int, k: int) -> list[Row]:
    """A basis of the rows (1, t, …, t^(k-1), F(t)) for t in [0, 1]: images of the one of 0 under t -> (t + ε)/p."""

    def step_of(epsilon: int) -> Step:
        def step(row: Row) -> Row:
            powers = [cells.mask.denominator * p ** (k - 1 - d) * x for d, x in enumerate(_moved(row[:k], epsilon))]
            return primitive(powers + [x * p ** (k - 1) for x in _on_cell(cells, p, epsilon, row[k:])])

        return step

    stencil = _stencil(cells, p)
    start = [sum(stencil) * (d == 0) for d in range(k)] + stencil
    return spanned([start], [step_of(epsilon) for epsilon in range(p)]).basis()


def _on_cell(cells: SideCells, p: int, epsilon: int, v: Row) -> Row:
    """The row F((t + ε)/p) of a cell from F(t), times the denominator of the mask: entries Σ_i v_i a_(i+ε-pj)."""
    a, places = cells.mask, range(cells.low, cells.high + 1)
    return [sum(x * a.at(i + epsilon - p * j) for i, x in zip(places, v, strict=True) if x) for j in places]


def _stencil(cells: SideCells, p: int) -> Row:
    """The row F(0) of the cell [0, 1] up to a factor: fixed, of sum > 0. Raises Rejected unless there is just one."""
    size, d = cells.high - cells.low + 1, cells.mask.denominator
    units = [[int(i == j) for j in range(size)] for i in range(size)]
    changes = [[x - d * y for x, y in zip(_on_cell(cells, p, 0, unit), unit, strict=True)] for unit in units]
    tagged = [change + unit for change, unit in zip(changes, units, strict=True)]
    kernel = [row[size:] for row in Echelon(tagged).basis() if not any(row[:size])]
    require(len(kernel) == 1, "the fixed rows are not of dimension 1")
    total = sum(kernel[0])
    require(total != 0, "the fixed row sums to 0")
    return kernel[0] if total > 0 else [-x for x in kernel[0]]


def require_sums(masks: TwoMasks) -> None:
    """Raise Rejected unless all rows of S sum to 1, those of both masks too."""
    for i, row in masks.special.items():
        require(sum(row.values()) == 1, f"special row {i} does not sum to 1")
    for mask in (masks.left, masks.right):
        sums = [0] * masks.arity
        for i, x in enumerate(mask.numerators, mask.start):
            sums[i % masks.arity] += x
        require(all(x == mask.denominator for x in sums), "a mask has a residue class that does not sum to 1")


def space_of(c: Claim, k: int) -> tuple[Window, list[Row]]:
    """The recurrent part of the space of order k: of the rows that sum to 0 for k = 0, else of 𝓕_k.

    The limit of a scheme that converges is F_c(x) = F(x)·c, so the claim that it does is used for k > 0.
    """
    masks = masks_of(c)
    require_few(k <= MAX_ORDER_OF_SPACES, "the order is too large")
    window = Window(masks)
    c.count(window.work(k), window.bits(k))
    if k:
        c.use("convergent", holds=True)
        return window, window.annihilating(k)
    require_sums(masks)
    return window, window.differences()


def functionals(c: Claim) -> None:
    """The new family is A on the recurrent part of the rows that sum to 0 (order 0), or of 𝓕_k (order k > 0).

    𝓕_k is spanned by all combinations Σ μ_i F(x_i) near 0 with Σ μ_i x_i^d = 0 for d < k, and by no others.
    """
    window, basis = space_of(c, c.statement["order"])
    require(len(basis) > 0, "the space is 0")
    require_few(len(basis) <= MAX_ORDER, "the space is too large")
    c.introduce(c.statement["family"], window.family(basis))


def vanishing(c: Claim) -> None:
    """The recurrent part of the space of this order is 0: A is nilpotent there."""
    _, basis = space_of(c, c.statement["order"])
    require(not basis, "the space is not 0")


def value_at_zero(c: Claim) -> None:
    """F_c(0) = v·c: S converges, and v A = v with Σ v = 1 determines v on the window. Raises Rejected otherwise."""
    masks = masks_of(c)
    window = Window(masks)
    c.count(window.work(0), window.bits(0))
    c.use("convergent", holds=True)
    start, weights = c.statement["start"], c.statement["weights"]
    given = {i: x for i, x in enumerate(weights, start) if x}
    if any(i not in window.points for i in given):
        raise Rejected("a weight is outside of the window")
    common = lcm(*(x.denominator for x in weights))
    v = [int(given.get(i, Fraction(0)) * common) for i in window.points]
    require(sum(v) == common, "the weights do not sum to 1")
    require(window.step(v) == [window.denominator * x for x in v], "the row is not fixed")
