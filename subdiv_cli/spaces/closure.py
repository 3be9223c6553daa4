"""The smallest space that holds given rational vectors and is mapped into itself by a family of matrices.

What happens to the vectors in the long run happens on its recurrent part, the intersection U of the spaces spanned by
all images under products of length 1, 2, 3, …: on the rest long products are 0. So the vectors are replaced by images
until these are in U, a tree whose leaves generate U; where it has too many nodes they stay, and what is called U is all
that they generate. U is spanned by words applied to them, M_(w_ℓ) ⋯ M_(w_1) g, and
comes with words that do: a bound from below of what the family does to the vectors needs that they span it, one from
above only that it holds them and is invariant.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass

from flint import fmpq_mat, nmod_mat

from subdiv_cli.exact.linalg import reduced
from subdiv_cli.model import Look, no_clock

LARGEST_DIMENSION = 120
LARGEST_TREE = 2000
"""The most nodes of a tree; where more were needed, the vectors themselves generate the space, transients included."""
LONGEST = 1000
"""The most bits of the numbers of a space; those of the masks of papers have 20."""
_PRIMES = (2**61 - 1, 2**62 - 57, 2**59 - 55)
"""Moduli in which words are looked for: one is enough but for rare chances."""

Origin = tuple[int, tuple[int, ...]]
"""A leaf's number and a word w: the vector M_(w_ℓ) ⋯ M_(w_1) g."""
Tree = tuple[bool, ...]
"""The given vectors, and then the images of each that is replaced by them, letter by letter: True for a leaf."""


@dataclass(frozen=True, slots=True, kw_only=True)
class InvariantSpace:
    """The space U in Q^n, a basis b_1, …, b_N of it, N >= 1, and the family in that basis."""

    basis: fmpq_mat
    """The basis as an N×n matrix of integers: row i is b_i."""
    matrices: tuple[fmpq_mat, ...]
    """For each M of the family an N×N matrix: M b_i = Σ_j matrix[j, i] b_j."""
    tree: Tree
    leaves: fmpq_mat
    """The leaves of the tree in order, as rows of N coordinates."""
    origins: tuple[Origin, ...]
    """N words with a leaf each, whose vectors are a basis as well."""

    @property
    def dimension(self) -> int:
        """The dimension N."""
        return self.basis.nrows()


def invariant_space(family: Sequence[fmpq_mat], vectors: fmpq_mat, look: Look = no_clock) -> InvariantSpace | None:
    """The space U of k vectors, rows of n entries, under n×n matrices.

    None where it is larger than LARGEST_DIMENSION, or has no short basis. Tree and words are found modulo a prime:
    what is independent there is independent, and all else is checked exactly. Raises what `look` raises.
    """
    on_rows = [m.transpose() for m in family]
    for prime in _PRIMES:
        search = _Search(on_rows, prime, look)
        tree, leaves = search.tree(on_rows, vectors)
        if (origins := search.words(leaves)) is None:
            return None
        if not origins:
            return _zero(tree, leaves, len(family)) if not any(leaves.entries()) else None
        span = fmpq_mat([_image(on_rows, leaves, origin).tolist()[0] for origin in origins])
        basis = reduced(span)
        if longest(basis) > LONGEST:
            return None
        to_coordinates = basis.transpose() * (basis * basis.transpose()).inv()
        images = [*(basis * m for m in on_rows), leaves]
        coordinates = [image * to_coordinates for image in images]
        if all(x * basis == image for x, image in zip(coordinates, images, strict=True)):
            matrices = tuple(m.transpose() for m in coordinates[:-1])
            return InvariantSpace(basis=basis, matrices=matrices, tree=tree, leaves=coordinates[-1], origins=origins)
    return None


def _zero(tree: Tree, leaves: fmpq_mat, letters: int) -> InvariantSpace:
    none = fmpq_mat(0, 0)
    return InvariantSpace(
        basis=fmpq_mat(0, leaves.ncols()), matrices=(none,) * letters, tree=tree, leaves=fmpq_mat(leaves.nrows(), 0),
        origins=(),
    )  # fmt: skip


class _Search:
    """Spans modulo a prime of numerators of vectors and matrices, which have the spans of these themselves."""

    def __init__(self, on_rows: Sequence[fmpq_mat], prime: int, look: Look) -> None:
        self.letters = [_modulo(m, prime) for m in on_rows]
        self.prime, self.look = prime, look

    def tree(self, on_rows: Sequence[fmpq_mat], vectors: fmpq_mat) -> tuple[Tree, fmpq_mat]:
        """The tree of some vectors, and its leaves as rows."""
        recurrent = self._recurrent(_modulo(vectors, self.prime))
        pivots = [next(j for j, x in enumerate(row) if x) for row in recurrent.table()]
        rows, tree, leaves = deque(fmpq_mat([row]) for row in vectors.tolist()), [], []
        while rows:
            self.look()
            row = rows.popleft()
            tree.append(_holds(recurrent, pivots, _modulo(row, self.prime)))
            if tree[-1]:
                leaves.append(row.tolist()[0])
            elif len(tree) + len(rows) + len(on_rows) > LARGEST_TREE:
                return (True,) * vectors.nrows(), vectors
            else:
                rows += [row * m for m in on_rows]
        return tuple(tree), fmpq_mat(leaves)

    def words(self, leaves: fmpq_mat) -> tuple[Origin, ...] | None:
        """Words whose vectors are a basis of the smallest invariant space of the leaves; None where it is too large."""
        span = new = _modulo(leaves, self.prime)
        names: list[Origin] = [(i, ()) for i in range(new.nrows())]
        independent = _independent_rows(span)
        span, known = _rows(span, independent), [names[i] for i in independent]
        new, names = span, known
        while new.nrows() and len(known) <= LARGEST_DIMENSION:
            self.look()
            images = _stacked(*(new * m for m in self.letters))
            names = [(leaf, (*word, letter)) for letter in range(len(self.letters)) for leaf, word in names]
            independent = [i - len(known) for i in _independent_rows(_stacked(span, images)) if i >= len(known)]
            new, names = _rows(images, independent), [names[i] for i in independent]
            span, known = _stacked(span, new), known + names
        return tuple(known) if len(known) <= LARGEST_DIMENSION else None

    def _recurrent(self, vectors: nmod_mat) -> nmod_mat:
        """The basis of U in echelon form, reduced."""
        space, rank = _row_space(vectors), 0
        while rank != space.nrows() <= LARGEST_DIMENSION:
            self.look()
            rank = space.nrows()
            space = _row_space(_stacked(space, *(space * m for m in self.letters)))
        rank = 0
        while rank != space.nrows():
            self.look()
            rank = space.nrows()
            space = _row_space(_stacked(*(space * m for m in self.letters)))
        return space


def _modulo(a: fmpq_mat, prime: int) -> nmod_mat:
    return nmod_mat(a.numer_denom()[0], prime)


def _stacked(*parts: nmod_mat) -> nmod_mat:
    """The rows of all parts, at least one, as one matrix."""
    entries = [int(x) for part in parts for x in part.entries()]
    return nmod_mat(sum(part.nrows() for part in parts), parts[0].ncols(), entries, parts[0].modulus())


def _rows(a: nmod_mat, numbers: Sequence[int]) -> nmod_mat:
    """The rows with these numbers."""
    table = a.table()
    return nmod_mat(len(numbers), a.ncols(), [int(x) for i in numbers for x in table[i]], a.modulus())


def _independent_rows(a: nmod_mat) -> list[int]:
    """The numbers of the rows that are independent of those before them."""
    echelon, rank = a.transpose().rref()
    return [next(j for j in range(a.nrows()) if echelon[i, j]) for i in range(rank)]


def _holds(space: nmod_mat, pivots: Sequence[int], row: nmod_mat) -> bool:
    """Whether a row is in the span of the rows of a reduced echelon form with these pivots."""
    coordinates = nmod_mat(1, len(pivots), [int(row[0, j]) for j in pivots], row.modulus())
    return bool(coordinates * space == row)


def _row_space(a: nmod_mat) -> nmod_mat:
    """The reduced echelon form of the rows, without rows of zeros."""
    echelon, rank = a.rref()
    return _rows(echelon, range(rank))


def _image(on_rows: Sequence[fmpq_mat], leaves: fmpq_mat, origin: Origin) -> fmpq_mat:
    """The vector of a word applied to a leaf, as a row."""
    leaf, word = origin
    row = fmpq_mat([leaves.tolist()[leaf]])
    for letter in word:
        row *= on_rows[letter]
    return row


def longest(rows: fmpq_mat) -> int:
    """The bits of the longest numerator or denominator."""
    return max(max(abs(int(x.p)).bit_length(), int(x.q).bit_length()) for x in rows.entries())
