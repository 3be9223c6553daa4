"""The Gram sequence g_α = ∫ φ(x) φ(x - α) dx of a scheme that converges, and the sign of its symbol.

With b(z) = a(z) a(1/z) and (G v)(α) = (1/m) Σ_β b(Mα-β) v(β) the sequence is the only finite one with G g = g and
Σ g_α = 1 (FORMAT.md, gram-stable), and φ is stable iff Φ(ω) = Σ_α g_α e^(-iα·ω), the sum of all
|φ^(ω+2πβ)|², has no zero (Jia & Micchelli 1991).

On the arcs ω_j = 2 arctan t_j + π e_j, -1 <= t_j <= 1, e_j = 0 or 1, Φ Π (1 + t_j²)^n_j is a polynomial of degree 2n_j
in t_j: positive on a box where its Bernstein coefficients there are. Boxes are halved until they are. As Φ is even,
t_1 >= 0 is enough.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import product
from math import comb, cos, lcm, pi, prod
from typing import NamedTuple

from flint import fmpq, fmpq_poly, fmpz, fmpz_mat, fmpz_poly

from subdiv_cli.kinds.multivariate.numbers.mean_squares import autocorrelation, correlation_operator
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.model import Effort
from subdiv_cli.spaces.lattice import Index, Lattice

LARGEST_SYSTEM = 600
"""The most unknowns g_α, those of -α left out."""
SMALL_TREE, LARGEST_TREE = 300, 20_000
"""The most boxes, halved ones included: before zeros are sought, and after."""
MOST_POINTS = 150
"""The most points of one order on the torus, where zeros are sought."""
LEAF = -1


class Gram(NamedTuple):
    """The Gram sequence, and whether its symbol is positive or zero somewhere; neither is known where that is hard."""

    sequence: Mapping[Index, Fraction]
    correlations: int
    """The number of terms of b."""
    tree: tuple[int, ...] | None = None
    """The halving of the boxes, in preorder: the variable, or -1 where all coefficients are positive."""
    zero: tuple[Index, int] | None = None
    """A pair (k, n) with Φ(2πk/n) = 0."""


def gram(scheme: MultivariateScheme, lattice: Lattice, effort: Effort) -> Gram | None:
    """The Gram sequence of a scheme that converges, and its sign; None where the system is too large.

    Raises ClockStruckError.
    """
    sequence = gram_sequence(scheme, lattice, effort)
    if sequence is None:
        return None
    terms = len(autocorrelation(scheme))
    if (tree := positive_tree(sequence, effort, SMALL_TREE)) is not None:
        return Gram(sequence, terms, tree)
    if (zero := torsion_zero(sequence, effort)) is not None:
        return Gram(sequence, terms, zero=zero)
    return Gram(sequence, terms, positive_tree(sequence, effort))


def gram_sequence(scheme: MultivariateScheme, lattice: Lattice, effort: Effort) -> dict[Index, Fraction] | None:
    """The sequence g with G g = g and Σ g_α = 1; None where it is too long.

    Raises ZeroDivisionError for several, and ClockStruckError.
    """
    operator = correlation_operator(scheme, lattice, [(0,) * lattice.dimension], effort)
    if operator is None or len(operator.window) > 2 * LARGEST_SYSTEM - 1:
        return None
    unknown: dict[Index, int] = {}
    for alpha in operator.window:
        unknown.setdefault(max(alpha, _minus(alpha)), len(unknown))
    place = [unknown[max(alpha, _minus(alpha))] for alpha in operator.window]
    kept = [alpha in unknown for alpha in operator.window]
    rows = [[0] * len(unknown) for _ in unknown]
    for j, column in zip(place, operator.columns, strict=True):
        for i, numerator in column:
            if kept[i]:
                rows[place[i]][j] += numerator
    for i, row in enumerate(rows):
        row[i] -= operator.denominator * lattice.index
    rows[0] = [place.count(i) for i in range(len(rows))]  # Σ g = 1 for an equation that follows from the others
    effort.look()
    solution = fmpz_mat(rows).solve(fmpz_mat([[int(i == 0)] for i in range(len(rows))]))
    values = [Fraction(int(solution[i, 0].p), int(solution[i, 0].q)) for i in range(len(rows))]
    return {alpha: values[i] for alpha, i in sorted(zip(operator.window, place, strict=True)) if values[i]}


def _minus(alpha: Index) -> Index:
    return tuple(-x for x in alpha)


def torsion_zero(g: Mapping[Index, Fraction], effort: Effort) -> tuple[Index, int] | None:
    """A zero 2πk/n of the symbol, (k, n) with a small n, which floats suggest and which is then decided; else None.

    Raises ClockStruckError.
    """
    s, values = len(next(iter(g))), [(alpha, float(x)) for alpha, x in g.items()]
    for n in (n for n in range(1, MOST_POINTS) if n**s <= MOST_POINTS):
        turns = [cos(2 * pi * i / n) for i in range(n)]
        for k in product(range(n), repeat=s):
            effort.look()
            total = sum(x * turns[_dot(k, alpha) % n] for alpha, x in values)
            if abs(total) < 1e-9 and _vanishes(g, k, n):
                return k, n
    return None


def _dot(x: Sequence[int], y: Sequence[int]) -> int:
    return sum(i * j for i, j in zip(x, y, strict=True))


def _vanishes(g: Mapping[Index, Fraction], k: Index, n: int) -> bool:
    """Whether Σ g_α ζ^(k·α) = 0, ζ a primitive n-th root of unity: its minimal polynomial divides the folded sum."""
    folded = [Fraction(0)] * n
    for alpha, x in g.items():
        folded[_dot(k, alpha) % n] += x
    f = fmpq_poly([fmpq(x.numerator, x.denominator) for x in folded])
    return not f % fmpq_poly(fmpz_poly.cyclotomic(n))


class _Polynomial(NamedTuple):
    """A polynomial on a box, by its Bernstein coefficients in lexicographic order, up to a positive factor."""

    lengths: tuple[int, ...]
    coefficients: list[fmpz]

    def along(self, axis: int, matrix: fmpz_mat) -> list[fmpz]:
        """The coefficients after the matrix is applied to those of one variable."""
        d, width = self.lengths[axis], prod(self.lengths[axis + 1 :])
        blocks = range(0, len(self.coefficients), d * width)
        return [
            x for i in blocks for x in (matrix * fmpz_mat(d, width, self.coefficients[i : i + d * width])).entries()
        ]

    def halves(self, axis: int) -> list[_Polynomial]:
        """The polynomial on the lower and on the upper half of the box, times a power of two (de Casteljau)."""
        n = self.lengths[axis] - 1
        lower = [[comb(i, j) << (n - i) for j in range(n + 1)] for i in range(n + 1)]
        upper = [row[::-1] for row in reversed(lower)]
        return [self._replace(coefficients=self.along(axis, fmpz_mat(rows))) for rows in (lower, upper)]

    def has_corner_without_sign(self) -> bool:
        """Whether the polynomial is not positive at some corner: the coefficients there are its values."""
        ends = product(*({0, n - 1} for n in self.lengths))
        widths = [prod(self.lengths[i + 1 :]) for i in range(len(self.lengths))]
        return any(self.coefficients[_dot(corner, widths)] <= 0 for corner in ends)

    def steepest(self) -> int:
        """The variable along which neighbouring coefficients differ most."""
        return max(range(len(self.lengths)), key=self._step)

    def _step(self, axis: int) -> fmpz:
        d, width = self.lengths[axis], prod(self.lengths[axis + 1 :])
        pairs = zip(self.coefficients, self.coefficients[width:], strict=False)
        return max((abs(y - x) for i, (x, y) in enumerate(pairs) if i // width % d < d - 1), default=fmpz(0))


def positive_tree(g: Mapping[Index, Fraction], effort: Effort, most: int = LARGEST_TREE) -> tuple[int, ...] | None:
    """The halving of boxes that shows the symbol to be positive; None where it is not, or takes too many boxes."""
    tree: list[int] = []
    for start in _arcs(g):
        waiting = [start]
        while waiting:
            polynomial = waiting.pop()
            if min(polynomial.coefficients) > 0:
                tree.append(LEAF)
                continue
            spent = len(tree) * len(polynomial.coefficients) // 4
            if polynomial.has_corner_without_sign() or len(tree) >= most or not effort.allows(spent):
                return None
            axis = polynomial.steepest()
            tree.append(axis)
            waiting += polynomial.halves(axis)[::-1]
    return tuple(tree)


def _arcs(g: Mapping[Index, Fraction]) -> Iterator[_Polynomial]:
    """The polynomial on each choice of the arcs."""
    reach = [max(map(abs, column)) for column in zip(*g, strict=True)]
    common = lcm(*(x.denominator for x in g.values()))
    tables = [_table(n, first=not i) for i, n in enumerate(reach)]
    lengths = tuple(2 * n + 1 for n in reach)
    indices = list(product(*(range(-n, n + 1) for n in reach)))
    for odd in product((0, 1), repeat=len(reach)):
        signs = ((-1) ** (_dot(alpha, odd) % 2) for alpha in indices)
        values = [fmpz(int(sign * common * g.get(alpha, 0))) for alpha, sign in zip(indices, signs, strict=True)]
        real, imaginary = _Polynomial(lengths, values), _Polynomial(lengths, [fmpz(0)] * len(values))
        for axis, (c, s) in enumerate(tables):
            parts = [(real, c, imaginary, s, -1), (real, s, imaginary, c, 1)]
            real, imaginary = (
                _Polynomial(lengths, [p + sign * q for p, q in zip(x.along(axis, a), y.along(axis, b), strict=True)])
                for x, a, y, b, sign in parts
            )
        yield real


def _table(n: int, *, first: bool) -> tuple[fmpz_mat, fmpz_mat]:
    """The matrix whose column α has the Bernstein coefficients of (1 + it)^(n+α) (1 - it)^(n-α) on [-1, 1].

    On [0, 1] for the first variable. Real and imaginary parts, times one integer. t = (u-v)/(u+v) or u/(u+v) for
    0 <= u, v, and 1 ± it is linear in them.
    """
    v, u = ((1, 0), (1, 1)) if first else ((1, -1), (1, 1))
    scale = lcm(*(comb(2 * n, j) for j in range(2 * n + 1)))
    columns = []
    for alpha in range(-n, n + 1):
        f = [(1, 0)]
        for sign in [1] * (n + alpha) + [-1] * (n - alpha):
            by_v, by_u = [[_times(x, (a, sign * b)) for x in f] for a, b in (v, u)]
            f = [(p + r, q + s) for (p, q), (r, s) in zip([*by_v, (0, 0)], [(0, 0), *by_u], strict=True)]
        columns.append([(scale // comb(2 * n, j) * x, scale // comb(2 * n, j) * y) for j, (x, y) in enumerate(f)])
    rows = list(zip(*columns, strict=True))
    return fmpz_mat([[x for x, _ in row] for row in rows]), fmpz_mat([[y for _, y in row] for row in rows])


def _times(x: tuple[int, int], y: tuple[int, int]) -> tuple[int, int]:
    return x[0] * y[0] - x[1] * y[1], x[0] * y[1] + x[1] * y[0]
