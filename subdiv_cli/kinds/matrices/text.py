"""Families of square matrices, `matrices = [A_0, …, A_(p-1)]`, each a list of rows: what `subdiv jsr` reads."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_MATRICES, MAX_MATRIX_ORDER
from subdiv_cli.maskfile.entries import Table, check_fixed, read_expression, read_parameters, text_at
from subdiv_cli.maskfile.expressions import Expression, number_of
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.mask import parameter_values
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath, Source
from subdiv_cli.maskfile.reader import load_path, text_of
from subdiv_cli.maskfile.toml import load
from subdiv_cli.maskfile.values import described

_KEYS = ("format", "name", "reference", "kind", "parameters", "matrices")
_HELP = 'write matrices = [[["1/2", 1], [0, 1]], [[1, 0], [1, "1/2"]]]: a list of matrices, each a list of rows'

Matrix = tuple[tuple[Fraction, ...], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class MatrixFile:
    """A family as its file spells it."""

    file: str
    matrices: tuple[tuple[tuple[Expression, ...], ...], ...]
    """All square, of one order."""
    parameters: Mapping[str, Expression | None]
    source: Source
    name: str | None = None
    reference: str | None = None

    def family(self, overrides: Mapping[str, Fraction] | None = None) -> tuple[Matrix, ...]:
        """The matrices at the parameters' values. Raises MaskFileError as `MaskFile.scheme` does."""
        problems, work = Collector(self.source), Work()
        values = parameter_values(self.parameters, overrides or {}, problems, work)
        problems.raise_any()
        found = [
            [[number_of(entry, values, problems, work) for entry in row] for row in matrix] for matrix in self.matrices
        ]
        problems.raise_any()
        return tuple(tuple(tuple(x or Fraction(0) for x in row) for row in matrix) for matrix in found)


def read_matrices(path: str | Path) -> MatrixFile:
    """Reads a file with `matrices`; "-" is standard input. Raises MaskFileError with everything that is wrong."""
    return read_matrices_text(text_of(load_path(path), str(path)), file=str(path))


def read_matrices_text(text: str, *, file: str) -> MatrixFile:
    """Reads the text of such a file. Raises MaskFileError and nothing else, whatever the text."""
    source = Source(file, text.removeprefix("\ufeff"))
    problems = Collector(source)
    document = load(source)
    kind = document.get("kind", "matrices")
    if kind != "matrices" or "mask" in document:
        help = "`subdiv check` decides the smoothness of masks; `subdiv jsr` takes matrices = [[[…], …], …]"
        problems.add(
            Fault(faults.KIND_NOT_BUILT, "this is no family of matrices", help),
            ("mask" if "mask" in document else "kind",),
        )
        problems.raise_any()
    top = Table(document, (), problems)
    top.only(_KEYS)
    parameters = read_parameters(top.table("parameters"), problems)
    matrices = None
    if "matrices" in document:
        matrices = _Reader(parameters, problems).family(document["matrices"], ("matrices",))
    else:
        top.missing("matrices", "matrices are missing", _HELP)
    name, reference = text_at(top, "name"), text_at(top, "reference")
    problems.raise_any()
    assert matrices is not None, "missing matrices are a problem"
    return MatrixFile(
        file=file, matrices=matrices, parameters=parameters, source=source, name=name, reference=reference
    )


class _Reader:
    """Lists of lists of lists; what is wrong is recorded."""

    def __init__(self, names: Collection[str], problems: Collector) -> None:
        self._names, self._problems, self._work = names, problems, Work()

    def family(self, value: object, path: KeyPath) -> tuple[tuple[tuple[Expression, ...], ...], ...] | None:
        """The matrices; None where there is no list of them. The family is complete where nothing is recorded."""
        matrices = self._list(value, path, "matrices", MAX_MATRICES)
        if matrices is None:
            return None
        found = [self._matrix(matrix, (*path, i)) for i, matrix in enumerate(matrices)]
        orders = {len(matrix) for matrix in found if matrix is not None}
        if len(orders) > 1:
            sizes = " and ".join(map(str, sorted(orders)))
            fault = Fault(faults.WRONG_TYPE, f"the matrices must be of one order, and there are orders {sizes}", _HELP)
            self._problems.add(fault, path)
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
        try:
            expression = read_expression(value, path, self._names)
            check_fixed(expression, self._work)
        except Fault as fault:
            self._problems.add(fault, path)
            return read_expression(0, path, ())
        return expression

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
