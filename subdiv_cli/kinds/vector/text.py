"""The text of a mask of matrices: the [mask] table with arity, start and coefficients, m×m matrices; the way back."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.kinds.matrices.text import Expressions, MatrixReader, Shape, literals, numbers_of
from subdiv_cli.kinds.vector.scheme import VectorScheme
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_ARITY, MAX_COMPONENTS, MAX_EXPONENT, MAX_GRID, MAX_VECTOR_LENGTH
from subdiv_cli.maskfile.entries import Table, mask_table
from subdiv_cli.maskfile.expressions import Expression
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.mask import too_precise, zero_mask
from subdiv_cli.maskfile.problems import Collector, Fault
from subdiv_cli.maskfile.spelling import listed, nested
from subdiv_cli.model.closed import rationals

_KEYS = ("arity", "start", "coefficients")
_HELP = 'write coefficients = [[["1/2", 0], [0, 1]], [[1, 0], [0, "1/2"]]]: a list of matrices, each a list of rows'
_SHAPE = Shape(
    "coefficients", MAX_VECTOR_LENGTH, MAX_COMPONENTS, _HELP, "a matrix takes m components to m: m rows of m entries"
)
_LISTED = "a mask of matrices has start and coefficients, a list of matrices"
_ELSEWHERE = {
    "symbol": (f"{_LISTED}; no symbol", "coefficients"),
    "dilation": ("masks of matrices are in one variable: arity = 2", "arity"),
    "terms": (_LISTED, "coefficients"),
    "matrices": ("did you mean coefficients?", "coefficients"),
    "offset": ("did you mean start?", "start"),
} | dict.fromkeys(("kind", "name", "reference", "format"), ("it belongs at the top, above [mask]", ""))


class MatrixCoefficients(NamedTuple):
    """The matrices A_start, A_(start+1), … of a mask, an expression for each entry; at least one."""

    arity: int
    start: int
    matrices: Expressions
    kind: str = "vector"

    def expressions(self) -> Iterable[Expression]:
        """The expressions of the body, each of which may have parameters."""
        return (entry for matrix in self.matrices for row in matrix for entry in row)

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> VectorScheme | None:
        """The scheme with the values put in; None where something is wrong, which is recorded as SD007 to SD011."""
        matrices = numbers_of(self.matrices, values, problems, work)
        if matrices is None:
            return None
        entries = [x for matrix in matrices for row in matrix for x in row]
        fault = too_precise(entries) if any(entries) else zero_mask(values)
        if fault:
            problems.add(fault, ("mask", "coefficients"))
            return None
        return VectorScheme(arity=self.arity, start=self.start, coefficients=matrices, kind=self.kind)


def read(top: Table, parameters: Collection[str], problems: Collector) -> MatrixCoefficients | None:
    """The mask of a file; None where something is wrong, which is recorded."""
    table = mask_table(top)
    if table is None:
        return None
    table.only(_KEYS, _ELSEWHERE)
    arity = table.integer("arity", 2, 2, MAX_ARITY, "write arity = 2, or 3 for a ternary scheme")
    help = "write the index of the first matrix: start = -1"
    start = table.integer("start", None, -MAX_EXPONENT, MAX_EXPONENT, help)
    if "coefficients" not in table.data:
        table.missing("coefficients", "coefficients are missing: a list of m×m matrices", _HELP)
        return None
    path = (*table.path, "coefficients")
    if (flat := _flat(table.data["coefficients"])) is not None:
        problems.add(Fault(faults.BAD_SHAPE, flat, _HELP), path)
        return None
    matrices = MatrixReader(_SHAPE, parameters, problems).matrices(table.data["coefficients"], path)
    if matrices is None or arity is None or start is None:
        return None
    if (count := len(matrices) * len(matrices[0]) ** 2) > MAX_GRID:
        message = f"the matrices have {count} entries, zeros included; the limit is {MAX_GRID}"
        problems.add(Fault(faults.OUT_OF_BOUNDS, message, "use a smaller mask"), path)
        return None
    return MatrixCoefficients(arity=arity, start=start, matrices=matrices)


def _flat(value: object) -> str | None:
    """What is wrong with coefficients that are no list of matrices from the first one on; None where they may be."""
    if not isinstance(value, list) or not value:
        return None
    if not isinstance(value[0], list):
        return 'the first coefficient is no matrix; a flat list of numbers is a mask of kind "scalar"'
    if value[0] and not isinstance(value[0][0], list):
        return "the first coefficient is a row, and not a matrix, which is a list of rows"
    return None


def body_of(scheme: VectorScheme) -> MatrixCoefficients:
    """The literal coefficients of a scheme."""
    return MatrixCoefficients(scheme.arity, scheme.start, literals(scheme.coefficients), scheme.kind)


def spell(body: MatrixCoefficients) -> list[str]:
    """The lines of the [mask] table."""
    lines = ["[mask]", f"arity = {body.arity}", f"start = {body.start}"]
    return [*lines, *listed("coefficients", map(nested, body.matrices))]


def canonical(scheme: VectorScheme) -> Mapping[str, Any]:
    """The mask as certificates embed it, in one spelling, so that two masks are the same iff these are equal."""
    return {
        "kind": scheme.kind,
        "arity": scheme.arity,
        "start": scheme.start,
        "coefficients": rationals(scheme.coefficients),
    }
