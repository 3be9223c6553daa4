"""The Gram sequence g_α = ∫ φ(x) φ(x - α) dx of a scheme that converges, and the sign of its symbol.

With b(z) = a(z) a(1/z) and (G v)(α) = (1/m) Σ_β b(Mα-β) v(β) the sequence is the only finite one with G g = g and
Σ g_α = 1 (certificate/MULTIVARIATE.md, gram-stable), and φ is stable iff Φ(ω) = Σ_α g_α e^(-iα·ω), the sum of all
|φ^(ω+2πβ)|², has no zero (Jia & Micchelli 1991).

On the arcs ω_j = 2 arctan t_j + π e_j, -1 <= t_j <= 1, e_j = 0 or 1, Φ Π (1 + t_j²)^n_j is a polynomial of degree 2n_j
in t_j: positive on a box where its Bernstein coefficients there are. Boxes are halved until they are. As Φ is even,
t_1 >= 0 is enough.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import product
from math import comb, lcm
from typing import TYPE_CHECKING, Any, NamedTuple

from flint import fmpz_mat

from subdiv_cli.model import Effort
from subdiv_cli.quantities.mean_squares import autocorrelation, correlation_operator
from subdiv_cli.schemes.lattice import Lattice
from subdiv_cli.schemes.multivariate import Index, MultivariateScheme

if TYPE_CHECKING:
    import numpy as np

    Array = np.ndarray[Any, np.dtype[np.object_]]

LARGEST_SYSTEM = 600
"""Unknowns g_α, those of -α left out."""
LARGEST_TREE = 20_000
"""Boxes, halved ones included."""
ORDERS = range(1, 13)
"""Of the points of finite order on the torus that are tried for zeros."""
LEAF = -1


class Gram(NamedTuple):
    """The sequence, and what its symbol is seen to be: positive, or zero somewhere; neither where that is hard."""

    sequence: Mapping[Index, Fraction]
    correlations: int
    """Terms of b."""
    tree: tuple[int, ...] | None = None
    """How the boxes are halved, in preorder: the variable, or -1 where all coefficients are positive."""
    zero: tuple[Index, int] | None = None
    """(k, n) with Φ(2πk/n) = 0."""


def gram(scheme: MultivariateScheme, lattice: Lattice, effort: Effort) -> Gram | None:
    """Of a scheme that converges; None where the system is too large."""
    sequence = gram_sequence(scheme, lattice)
    if sequence is None:
        return None
    terms = len(autocorrelation(scheme))
    if (zero := torsion_zero(sequence)) is not None:
        return Gram(sequence, terms, zero=zero)
    return Gram(sequence, terms, positive_tree(sequence, effort))


def gram_sequence(scheme: MultivariateScheme, lattice: Lattice) -> dict[Index, Fraction] | None:
    """The g with G g = g and Σ g_α = 1; None where it is too long. Raises ZeroDivisionError where there are several."""
    operator = correlation_operator(scheme, lattice, [(0,) * lattice.dimension])
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
    solution = fmpz_mat(rows).solve(fmpz_mat([[int(i == 0)] for i in range(len(rows))]))
    values = [Fraction(int(solution[i, 0].p), int(solution[i, 0].q)) for i in range(len(rows))]
    return {alpha: values[i] for alpha, i in sorted(zip(operator.window, place, strict=True)) if values[i]}


def _minus(alpha: Index) -> Index:
    return tuple(-x for x in alpha)


def torsion_zero(g: Mapping[Index, Fraction]) -> tuple[Index, int] | None:
    """A zero (k, n) of the symbol, 2πk/n with n in ORDERS: floats tell which point it may be, then it is computed."""
    import numpy as np

    s = len(next(iter(g)))
    indices, values = np.array(list(g), dtype=np.int64), np.array([float(x) for x in g.values()])
    for n in ORDERS:
        points = np.array(list(product(range(n), repeat=s)), dtype=np.int64)
        turns = (points @ indices.T) % n
        small = np.abs(np.cos(2 * np.pi * turns / n) @ values) < 1e-9
        for point in points[small]:
            k = tuple(int(x) for x in point)
            if _vanishes(g, k, n):
                return k, n
    return None


def _vanishes(g: Mapping[Index, Fraction], k: Index, n: int) -> bool:
    """Whether Σ g_α ζ^(k·α) = 0, ζ a primitive n-th root of unity: its minimal polynomial divides the folded sum."""
    from flint import fmpq, fmpq_poly, fmpz_poly

    folded = [Fraction(0)] * n
    for alpha, x in g.items():
        folded[sum(i * j for i, j in zip(k, alpha, strict=True)) % n] += x
    f = fmpq_poly([fmpq(x.numerator, x.denominator) for x in folded])
    return not f % fmpq_poly(fmpz_poly.cyclotomic(n))


def positive_tree(g: Mapping[Index, Fraction], effort: Effort) -> tuple[int, ...] | None:
    """Boxes on which the symbol is seen to be positive; None where it is not, or takes too many of them."""
    tree: list[int] = []
    for start in _arcs(g):
        waiting = [start]
        while waiting:
            values = waiting.pop()
            if (values > 0).all():
                tree.append(LEAF)
                continue
            corners = values[tuple(slice(None, None, max(1, n - 1)) for n in values.shape)]
            spent = len(tree) * values.size // 4
            if (corners <= 0).any() or len(tree) >= LARGEST_TREE or not effort.allows(spent):
                return None
            axis = _steepest(values)
            tree.append(axis)
            waiting += _halves(values, axis)[::-1]
    return tuple(tree)


def _arcs(g: Mapping[Index, Fraction]) -> Iterator[Array]:
    """The Bernstein coefficients, as integers up to a factor, for each choice of the arcs."""
    import numpy as np

    reach = [max(map(abs, column)) for column in zip(*g, strict=True)]
    common = lcm(*(x.denominator for x in g.values()))
    tables = [_table(n, first=not i) for i, n in enumerate(reach)]
    for turned in product((0, 1), repeat=len(reach)):
        real = np.zeros([2 * n + 1 for n in reach], dtype=object)
        for alpha, x in g.items():
            odd = sum(i * e for i, e in zip(alpha, turned, strict=True)) % 2
            real[tuple(i + n for i, n in zip(alpha, reach, strict=True))] = int(x * common) * (-1) ** odd
        imaginary = np.zeros_like(real)
        for cos, sin in tables:  # each takes the first axis and becomes the last one
            real, imaginary = (
                np.tensordot(real, cos, (0, 0)) - np.tensordot(imaginary, sin, (0, 0)),
                np.tensordot(real, sin, (0, 0)) + np.tensordot(imaginary, cos, (0, 0)),
            )
        yield real


def _table(n: int, *, first: bool) -> tuple[Array, Array]:
    """For α = -n, …, n the Bernstein coefficients of (1 + it)^(n+α) (1 - it)^(n-α) on [-1, 1], the first one on [0, 1].

    Real and imaginary parts, times one integer. t = (u-v)/(u+v) or u/(u+v) for 0 <= u, v, and 1 ± it is linear in them.
    """
    import numpy as np

    v, u = ((1, 0), (1, 1)) if first else ((1, -1), (1, 1))
    scale = lcm(*(comb(2 * n, j) for j in range(2 * n + 1)))
    real, imaginary = np.zeros((2 * n + 1, 2 * n + 1), dtype=object), np.zeros((2 * n + 1, 2 * n + 1), dtype=object)
    for alpha in range(-n, n + 1):
        f = [(1, 0)]
        for sign in [1] * (n + alpha) + [-1] * (n - alpha):
            by_v, by_u = [[_times(x, (a, sign * b)) for x in f] for a, b in (v, u)]
            f = [(p + r, q + s) for (p, q), (r, s) in zip([*by_v, (0, 0)], [(0, 0), *by_u], strict=True)]
        for j, (x, y) in enumerate(f):
            factor = scale // comb(2 * n, j)
            real[alpha + n, j], imaginary[alpha + n, j] = factor * x, factor * y
    return real, imaginary


def _times(x: tuple[int, int], y: tuple[int, int]) -> tuple[int, int]:
    return x[0] * y[0] - x[1] * y[1], x[0] * y[1] + x[1] * y[0]


def _steepest(values: Array) -> int:
    """The axis along which neighbouring coefficients differ most."""
    import numpy as np

    steps = [abs(np.diff(values, axis=axis)).max() if n > 1 else 0 for axis, n in enumerate(values.shape)]
    return steps.index(max(steps))


def _halves(values: Array, axis: int) -> list[Array]:
    """The coefficients on both halves, times a power of two (de Casteljau)."""
    import numpy as np

    row, n = np.moveaxis(values, axis, 0), values.shape[axis] - 1
    left, right = [], []
    for step in range(n + 1):
        left.append(row[0] << (n - step))
        right.append(row[-1] << (n - step))
        row = row[1:] + row[:-1]
    return [np.moveaxis(np.stack(half), 0, axis) for half in (left, right[::-1])]
