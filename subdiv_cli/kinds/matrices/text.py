"""The text of a family of square matrices: `matrices = [A_0, …, A_(p-1)]`, each a list of rows.

`subdiv jsr` reads any family; as a scheme it has two matrices at least, and their rows sum to 1.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.kinds.matrices.scheme import Matrix as Matrix
from subdiv_cli.kinds.matrices.scheme import MatrixFamily
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_MATRICES, MAX_MATRIX_ORDER
from subdiv_cli.maskfile.entries import Table, read_number
from subdiv_cli.maskfile.expressions import Expression, literal, number_of
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath, shown_number
from subdiv_cli.maskfile.spelling import listed, nested
from subdiv_cli.maskfile.values import described
from subdiv_cli.model.closed import rationals

_HELP = 'write matrices = [[["1/2", 1], [0, 1]], [[1, 0], [1, "1/2"]]]: a list of matrices, each a list of rows'

Expressions = tuple[tuple[tuple[Expression, ...], ...], ...]
"""Matrices by rows."""
_LARGEST_SCHEME = 24
"""The most control points of a piece."""


class Matrices(NamedTuple):
    """The matrices of a file, all square and of one order."""

    matrices: Expressions
    is_scheme: bool = True
    """Whether they must refine polygons; else any family will do."""

    def expressions(self) -> Iterable[Expression]:
        """The expressions of the body, each of which may have parameters."""
        return (entry for matrix in self.matrices for row in matrix for entry in row)

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> MatrixFamily | None:
        """The family with the values put in; None where something is wrong, which is recorded as SD007 to SD011."""
        matrices = numbers_of(self.matrices, values, problems, work)
        if matrices is None:
            return None
        faulty = list(_no_scheme(matrices)) if self.is_scheme else []
        for path, fault in faulty:
            problems.add(fault, ("matrices", *path))
        return None if faulty else MatrixFamily(matrices)


def numbers_of(
    matrices: Expressions, values: Mapping[str, Fraction], problems: Collector, work: Work
) -> tuple[Matrix, ...] | None:
    """The matrices with the values put in; None where something is wrong, which is recorded as SD007 to SD011."""
    numbers = [[[number_of(entry, values, problems, work) for entry in row] for row in matrix] for matrix in matrices]
    if any(entry is None for matrix in numbers for row in matrix for entry in row):
        return None
    return tuple(tuple(tuple(x or Fraction(0) for x in row) for row in matrix) for matrix in numbers)


def _no_scheme(family: tuple[Matrix, ...]) -> Iterator[tuple[tuple[int, ...], Fault]]:
    """What keeps a family from refining polygons, each with its place."""
    jsr = "subdiv jsr takes any family"
    if len(family) < 2:
        message = "there is one matrix: a curve is cut into two pieces at least"
        yield (), Fault(faults.OUT_OF_BOUNDS, message, f"write the matrix of every piece; {jsr}")
    if not 2 <= (order := len(family[0])) <= _LARGEST_SCHEME:
        message = f"the order is {order}: a curve has 2 to {_LARGEST_SCHEME} control points"
        yield (), Fault(faults.OUT_OF_BOUNDS, message, f"row j of a matrix has the weights of control point j; {jsr}")
    for i, matrix in enumerate(family):
        is_transposed = all(sum(column) == 1 for column in zip(*matrix, strict=True))
        mend = "write its columns as rows: the matrix is transposed" if is_transposed else "correct its weights"
        for j, row in enumerate(matrix):
            if (total := sum(row, Fraction(0))) != 1:
                message = f"the row sums to {shown_number(total)}, must be 1: new points are means of old ones"
                yield (i, j), Fault(faults.ROW_SUM, message, f"{mend}; {jsr}")


def read(top: Table, parameters: Collection[str], problems: Collector) -> Matrices | None:
    """The matrices of a scheme at the top of a file; None where something is wrong, which is recorded."""
    family = read_family(top, parameters, problems)
    return None if family is None else family._replace(is_scheme=True)


def read_family(top: Table, parameters: Collection[str], problems: Collector) -> Matrices | None:
    """The matrices at the top of a file, any family; None where something is wrong, which is recorded."""
    if "matrices" not in top.data:
        top.missing("matrices", "matrices are missing", _HELP)
        return None
    family = MatrixReader(_FAMILY, parameters, problems).matrices(top.data["matrices"], ("matrices",))
    return None if family is None else Matrices(family, is_scheme=False)


def body_of(family: MatrixFamily) -> Matrices:
    """The literal entries of a family."""
    return Matrices(literals(family.matrices))


def literals(matrices: Iterable[Matrix]) -> Expressions:
    """Matrices as literal numbers."""
    return tuple(tuple(tuple(map(literal, row)) for row in matrix) for matrix in matrices)


def spell(body: Matrices) -> list[str]:
    """The lines of the file with this family."""
    return listed("matrices", map(nested, body.matrices))


def canonical(family: MatrixFamily) -> Mapping[str, Any]:
    """The family as certificates embed it."""
    return {"kind": family.kind, "matrices": rationals(family.matrices)}


class Shape(NamedTuple):
    """What a list of matrices is called in a file, how long and how large it may be, and how it is written."""

    name: str
    most: int
    """The most matrices."""
    order: int
    """The largest order of a matrix."""
    help: str
    square: str
    """The help where a matrix is not square."""


_FAMILY = Shape("matrices", MAX_MATRICES, MAX_MATRIX_ORDER, _HELP, "a joint spectral radius is of square matrices")


class MatrixReader:
    """A reader of lists of square matrices of one order, each a list of rows; what is wrong is recorded."""

    def __init__(self, shape: Shape, names: Collection[str], problems: Collector) -> None:
        self._shape, self._names, self._problems, self._work = shape, names, problems, Work()

    def matrices(self, value: object, path: KeyPath) -> Expressions | None:
        """The matrices; None where anything about them is wrong."""
        matrices = self._list(value, path, self._shape.name, self._shape.most)
        if matrices is None:
            return None
        read = [self._matrix(matrix, (*path, i)) for i, matrix in enumerate(matrices)]
        orders = [None if matrix is None else len(matrix) for matrix in read]
        first = next((order for order in orders if order is not None), None)
        other = next((i for i, order in enumerate(orders) if order not in (None, first)), None)
        if other is not None:
            sizes = f"{first}×{first}, and this one is {orders[other]}×{orders[other]}"
            message = f"all matrices must be of one size: the first is {sizes}"
            self._problems.add(Fault(faults.BAD_SHAPE, message, self._shape.help), (*path, other))
        right = tuple(matrix for matrix in read if matrix is not None)
        return right if len(right) == len(read) and other is None else None

    def _matrix(self, value: object, path: KeyPath) -> tuple[tuple[Expression, ...], ...] | None:
        """The rows of a square matrix; None where it is none, or an entry is wrong."""
        rows = self._list(value, path, "a matrix", self._shape.order)
        if rows is None:
            return None
        expressions = []
        for i, row in enumerate(rows):
            entries = self._list(row, (*path, i), "a row", self._shape.order)
            if entries is None:
                return None
            if len(entries) != len(rows):
                message = f"the matrix is not square: rows {len(rows)}, entries of this row {len(entries)}"
                self._problems.add(Fault(faults.WRONG_TYPE, message, self._shape.square), (*path, i))
                return None
            expressions.append([self._entry(x, (*path, i, j)) for j, x in enumerate(entries)])
        right = tuple(tuple(x for x in row if x is not None) for row in expressions)
        return right if all(len(row) == len(rows) for row in right) else None

    def _entry(self, value: object, path: KeyPath) -> Expression | None:
        """The entry; None where it is wrong."""
        if isinstance(value, list):
            message = "a number was expected, not a list: a matrix is a list of rows, a row one of numbers"
            self._problems.add(Fault(faults.WRONG_TYPE, message, self._shape.help), path)
            return None
        return read_number(value, path, self._names, self._problems, self._work)

    def _list(self, value: object, path: KeyPath, what: str, most: int) -> list[object] | None:
        """The value, where it is a list of 1 to `most` entries; else None."""
        help = self._shape.help
        if not isinstance(value, list) or not value:
            given = "an empty list" if value == [] else described(value)
            self._problems.add(Fault(faults.WRONG_TYPE, f"{what} must be a list, not {given}", help), path)
            return None
        if len(value) > most:
            message = f"{what}: {len(value)} entries; the limit is {most}"
            self._problems.add(Fault(faults.OUT_OF_BOUNDS, message, help), path)
            return None
        return value
