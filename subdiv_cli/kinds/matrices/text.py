"""The text of a family of square matrices: `matrices = [A_0, …, A_(p-1)]`, each a list of rows.

`subdiv jsr` reads any family; as a scheme it has two matrices at least, and their rows sum to 1.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.kinds.matrices.scheme import Matrix, MatrixFamily
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_MATRICES, MAX_MATRIX_ORDER
from subdiv_cli.maskfile.entries import Table, read_number
from subdiv_cli.maskfile.expressions import Expression, literal, number_of
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath, shown_number
from subdiv_cli.maskfile.spelling import listed, nested
from subdiv_cli.maskfile.values import described
from subdiv_cli.model.closed import rational

_HELP = 'write matrices = [[["1/2", 1], [0, 1]], [[1, 0], [1, "1/2"]]]: a list of matrices, each a list of rows'

_LARGEST_SCHEME = 24
"""The most control points of a piece."""


class Matrices(NamedTuple):
    """The matrices of a file, all square and of one order."""

    matrices: tuple[tuple[tuple[Expression, ...], ...], ...]
    is_scheme: bool = True
    """Whether they must refine polygons; else any family will do."""

    def expressions(self) -> Iterable[Expression]:
        return (entry for matrix in self.matrices for row in matrix for entry in row)

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> MatrixFamily | None:
        """The family with the values put in; None where something is wrong, which is recorded as SD007 to SD011."""
        found = [
            [[number_of(entry, values, problems, work) for entry in row] for row in matrix] for matrix in self.matrices
        ]
        if any(entry is None for matrix in found for row in matrix for entry in row):
            return None
        family = tuple(tuple(tuple(x or Fraction(0) for x in row) for row in matrix) for matrix in found)
        faulty = list(_no_scheme(family)) if self.is_scheme else []
        for path, fault in faulty:
            problems.add(fault, ("matrices", *path))
        return None if faulty else MatrixFamily(family)


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
    found = _Reader(parameters, problems).family(top.data["matrices"], ("matrices",))
    return None if found is None else Matrices(found, is_scheme=False)


def body_of(family: MatrixFamily) -> Matrices:
    """The literal entries of a family."""
    return Matrices(tuple(tuple(tuple(map(literal, row)) for row in matrix) for matrix in family.matrices))


def spell(body: Matrices) -> list[str]:
    """The lines of the file with this family."""
    return listed("matrices", map(nested, body.matrices))


def canonical(family: MatrixFamily) -> Mapping[str, Any]:
    """The family as certificates embed it."""
    rows = [[[rational(x) for x in row] for row in matrix] for matrix in family.matrices]
    return {"kind": family.kind, "matrices": rows}


class _Reader:
    """A reader of lists of lists of lists; what is wrong is recorded."""

    def __init__(self, names: Collection[str], problems: Collector) -> None:
        self._names, self._problems, self._work = names, problems, Work()
        self._complete = True

    def family(self, value: object, path: KeyPath) -> tuple[tuple[tuple[Expression, ...], ...], ...] | None:
        """The matrices; None where something is wrong with them."""
        matrices = self._list(value, path, "matrices", MAX_MATRICES)
        if matrices is None:
            return None
        found = [self._matrix(matrix, (*path, i)) for i, matrix in enumerate(matrices)]
        orders = {len(matrix) for matrix in found if matrix is not None}
        if len(orders) > 1:
            sizes = " and ".join(map(str, sorted(orders)))
            fault = Fault(faults.WRONG_TYPE, f"the matrices must be of one order, and there are orders {sizes}", _HELP)
            self._problems.add(fault, path)
        if len(orders) > 1 or None in found or not self._complete:
            return None
        return tuple(matrix for matrix in found if matrix is not None)

    def _matrix(self, value: object, path: KeyPath) -> tuple[tuple[Expression, ...], ...] | None:
        """The rows of a square matrix; None where it is none."""
        rows = self._list(value, path, "a matrix", MAX_MATRIX_ORDER)
        if rows is None:
            return None
        found = []
        for i, row in enumerate(rows):
            entries = self._list(row, (*path, i), "a row", MAX_MATRIX_ORDER)
            if entries is None:
                return None
            if len(entries) != len(rows):
                message = f"the matrix is not square: rows {len(rows)}, entries of this row {len(entries)}"
                self._problems.add(
                    Fault(faults.WRONG_TYPE, message, "a joint spectral radius is of square matrices"), (*path, i)
                )
                return None
            found.append(tuple(self._entry(x, (*path, i, j)) for j, x in enumerate(entries)))
        return tuple(found)

    def _entry(self, value: object, path: KeyPath) -> Expression:
        """The entry; zero where it is wrong."""
        found = read_number(value, path, self._names, self._problems, self._work)
        self._complete &= found is not None
        return found or literal(Fraction(0))

    def _list(self, value: object, path: KeyPath, what: str, most: int) -> list[object] | None:
        """The value, where it is a list of 1 to `most` entries; else None."""
        if not isinstance(value, list) or not value:
            said = "an empty list" if value == [] else described(value)
            self._problems.add(Fault(faults.WRONG_TYPE, f"{what} must be a list, not {said}", _HELP), path)
            return None
        if len(value) > most:
            self._problems.add(
                Fault(faults.OUT_OF_BOUNDS, f"{what}: {len(value)} entries; the limit is {most}", _HELP), path
            )
            return None
        return value
