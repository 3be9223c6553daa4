"""The key `dilation` of a mask file: an integer c >= 2 for cI, or the rows of an expanding integer matrix."""

from __future__ import annotations

from subdiv_cli.kinds.multivariate.text.integers import integer_list
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_ARITY, MAX_COSETS, MAX_DIMENSION
from subdiv_cli.maskfile.entries import Table
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath
from subdiv_cli.maskfile.values import described
from subdiv_cli.spaces.lattice import IntMatrix, characteristic_polynomial, is_expanding, multiple_of_identity

HELP = "write dilation = 2, or a matrix by rows: dilation = [[1, 1], [1, -1]]"


class Dilation:
    """The dilation that [mask] gives, which may be none; faults are recorded."""

    def __init__(self, table: Table) -> None:
        self.path: KeyPath = (*table.path, "dilation")
        self._problems = table.problems
        self.given = "dilation" in table.data
        self.factor: int | None = None
        """c of cI, also where that is what a matrix comes to."""
        self.rows: IntMatrix | None = None
        """The matrix, where one is given."""
        value = table.data.get("dilation", 2)
        if isinstance(value, list):
            self.rows = _matrix(value, self.path, self._problems)
            self.factor = _factor(self.rows) if self.rows else None
        elif isinstance(value, bool) or not isinstance(value, int):
            fault = Fault(faults.WRONG_TYPE, f"dilation must be an integer or a matrix, not {described(value)}", HELP)
            self._problems.add(fault, self.path)
        elif not 2 <= value <= MAX_ARITY:
            given = str(value) if value.bit_length() < 64 else "a long number"
            fault = Fault(faults.OUT_OF_BOUNDS, f"dilation must be between 2 and {MAX_ARITY}, not {given}", HELP)
            self._problems.add(fault, self.path)
        else:
            self.factor = value

    def of(self, dimension: int) -> IntMatrix | None:
        """The matrix for a mask in so many variables; None where there is none, which is recorded."""
        if self.rows is not None:
            if len(self.rows) == dimension:
                return self.rows
            message = f"the dilation matrix has {len(self.rows)} rows, and the mask has {dimension} variables"
            self._problems.add(Fault(faults.BAD_DILATION, message, "give it a row for each variable"), self.path)
        elif self.factor is not None:
            if self.factor**dimension <= MAX_COSETS:
                return multiple_of_identity(self.factor, dimension)
            self._problems.add(_too_many_cosets(self.factor**dimension), self.path)
        return None


def _matrix(value: list[object], path: KeyPath, problems: Collector) -> IntMatrix | None:
    """The rows of an expanding matrix; None where they are wrong, which is recorded."""
    read = [
        integer_list(row, (*path, i), problems, "a row of the dilation matrix", HELP) for i, row in enumerate(value)
    ]
    rows = tuple(row for row in read if row is not None)
    if len(rows) < len(read):
        return None
    fault = _wrong_shape(rows) or _wrong_eigenvalues(rows)
    if fault:
        problems.add(fault, path)
        return None
    return rows


def _wrong_shape(rows: IntMatrix) -> Fault | None:
    """The fault of rows that make no square matrix of the orders there are; None where they do."""
    n = len(rows)
    if n == 1:
        help = 'one variable is kind = "scalar", with an arity'
        return Fault(faults.BAD_DILATION, "the dilation matrix has one row: the mask has one variable", help)
    if not 2 <= n <= MAX_DIMENSION:
        message = f"the dilation matrix has {n} rows; there are 2 to {MAX_DIMENSION} variables"
        return Fault(faults.BAD_DILATION if n == 0 else faults.OUT_OF_BOUNDS, message, HELP)
    wrong = next((len(row) for row in rows if len(row) != n), None)
    if wrong is not None:
        return Fault(
            faults.BAD_DILATION, f"the dilation matrix is not square: {n} rows, and one of length {wrong}", HELP
        )
    return None


def _wrong_eigenvalues(rows: IntMatrix) -> Fault | None:
    """The fault of a matrix that is not expanding, or too much so; None for one that will do."""
    polynomial = characteristic_polynomial(rows)
    if not is_expanding(rows):
        message = f"the dilation matrix is not expanding: {_spelled(polynomial)} has a zero in |x| <= 1"
        return Fault(faults.BAD_DILATION, message, "all eigenvalues must be larger than 1 in size: [[1, 1], [1, -1]]")
    if abs(polynomial[0]) > MAX_COSETS:
        return _too_many_cosets(abs(polynomial[0]))
    return None


def _too_many_cosets(count: int) -> Fault:
    """The fault of a dilation with so many cosets."""
    return Fault(
        faults.OUT_OF_BOUNDS,
        f"the dilation has determinant {count}; the limit is {MAX_COSETS}",
        "use a smaller dilation",
    )


def _factor(rows: IntMatrix) -> int | None:
    """The factor c of a matrix cI; None for another."""
    c = rows[0][0]
    return c if rows == multiple_of_identity(c, len(rows)) else None


def _spelled(polynomial: list[int]) -> str:
    """The characteristic polynomial det(x - M), as a message shows it: x^2 - 2x + 1."""
    out = ""
    for k in range(len(polynomial) - 1, -1, -1):
        if c := polynomial[k]:
            size = "" if abs(c) == 1 and k else str(abs(c))
            sign = (" - " if c < 0 else " + ") if out else "-" if c < 0 else ""
            out += sign + size + ("" if k == 0 else "x" if k == 1 else f"x^{k}")
    return out
