"""The text of a family of square matrices: `matrices = [A_0, …, A_(p-1)]`, each a list of rows."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_MATRICES, MAX_MATRIX_ORDER
from subdiv_cli.maskfile.entries import Table, read_number
from subdiv_cli.maskfile.expressions import Expression, literal, number_of
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath
from subdiv_cli.maskfile.spelling import listed, nested
from subdiv_cli.maskfile.values import described
from subdiv_cli.model.closed import rational

_HELP = 'write matrices = [[["1/2", 1], [0, 1]], [[1, 0], [1, "1/2"]]]: a list of matrices, each a list of rows'

Matrix = tuple[tuple[Fraction, ...], ...]


@dataclass(frozen=True, slots=True)
class MatrixFamily:
    """A family of square matrices of one order, by rows; at least one."""

    matrices: tuple[Matrix, ...]

    @property
    def kind(self) -> str:
        """The name of the kind, `matrices`."""
        return "matrices"


class Matrices(NamedTuple):
    """The matrices of a file, all square and of one order."""

    matrices: tuple[tuple[tuple[Expression, ...], ...], ...]

    def expressions(self) -> Iterable[Expression]:
        """The expressions of the body, each of which may have parameters."""
        return (entry for matrix in self.matrices for row in matrix for entry in row)

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> MatrixFamily | None:
        """The family with the values put in; None where something is wrong, which is recorded as SD007 to SD011."""
        matrices = [
            [[number_of(entry, values, problems, work) for entry in row] for row in matrix] for matrix in self.matrices
        ]
        if any(entry is None for matrix in matrices for row in matrix for entry in row):
            return None
        return MatrixFamily(tuple(tuple(tuple(x or Fraction(0) for x in row) for row in matrix) for matrix in matrices))


def read(top: Table, parameters: Collection[str], problems: Collector) -> Matrices | None:
    """The family at the top of a file; None where something is wrong, which is recorded."""
    if "matrices" not in top.data:
        top.missing("matrices", "matrices are missing", _HELP)
        return None
    family = _Reader(parameters, problems).family(top.data["matrices"], ("matrices",))
    return None if family is None else Matrices(family)


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

    def family(self, value: object, path: KeyPath) -> tuple[tuple[tuple[Expression, ...], ...], ...] | None:
        """The matrices; None where there is no list of them. The family is complete where nothing is recorded."""
        matrices = self._list(value, path, "matrices", MAX_MATRICES)
        if matrices is None:
            return None
        read = [self._matrix(matrix, (*path, i)) for i, matrix in enumerate(matrices)]
        orders = {len(matrix) for matrix in read if matrix is not None}
        if len(orders) > 1:
            sizes = " and ".join(map(str, sorted(orders)))
            fault = Fault(faults.WRONG_TYPE, f"the matrices must be of one order, and there are orders {sizes}", _HELP)
            self._problems.add(fault, path)
        return tuple(matrix for matrix in read if matrix is not None)

    def _matrix(self, value: object, path: KeyPath) -> tuple[tuple[Expression, ...], ...] | None:
        """The rows of a square matrix; None where it is none."""
        rows = self._list(value, path, "a matrix", MAX_MATRIX_ORDER)
        if rows is None:
            return None
        expressions = []
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
            expressions.append(tuple(self._entry(x, (*path, i, j)) for j, x in enumerate(entries)))
        return tuple(expressions)

    def _entry(self, value: object, path: KeyPath) -> Expression:
        """The entry; zero where it is wrong."""
        return read_number(value, path, self._names, self._problems, self._work) or literal(Fraction(0))

    def _list(self, value: object, path: KeyPath, what: str, most: int) -> list[object] | None:
        """The value, where it is a list of 1 to `most` entries; else None."""
        if not isinstance(value, list) or not value:
            given = "an empty list" if value == [] else described(value)
            self._problems.add(Fault(faults.WRONG_TYPE, f"{what} must be a list, not {given}", _HELP), path)
            return None
        if len(value) > most:
            self._problems.add(
                Fault(faults.OUT_OF_BOUNDS, f"{what}: {len(value)} entries; the limit is {most}", _HELP), path
            )
            return None
        return value
