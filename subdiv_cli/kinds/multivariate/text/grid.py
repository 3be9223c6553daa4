"""The keys `start` with nested `coefficients`, and `terms`, of a mask file: a number for each index."""

from __future__ import annotations

from collections.abc import Collection

from subdiv_cli.kinds.multivariate.text.bodies import CoefficientGrid, Nested, Terms
from subdiv_cli.kinds.multivariate.text.dilation import Dilation
from subdiv_cli.kinds.multivariate.text.integers import index_of_key, integer_list
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_DIMENSION, MAX_GRID, MAX_MASK_LENGTH
from subdiv_cli.maskfile.entries import Table, read_number
from subdiv_cli.maskfile.expressions import Expression
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath
from subdiv_cli.maskfile.values import described
from subdiv_cli.spaces.lattice import Index

_NESTED = 'write a list of rows: coefficients = [["1/4", "1/2"], ["1/2", 1]]'


def read_grid(table: Table, dilation: Dilation, parameters: Collection[str]) -> CoefficientGrid | None:
    """The body that `start` and `coefficients` give; None where something is wrong, which is recorded."""
    problems = table.problems
    path = (*table.path, "coefficients")
    shape = _shape(table.data["coefficients"], path, problems)
    if shape is None:
        return None
    matrix = dilation.of(len(shape))
    start = _start(table, len(shape))
    if start is not None and len(start) != len(shape):
        plural = "" if len(start) == 1 else "s"
        message = f"start has {len(start)} component{plural}, and coefficients are nested {len(shape)} deep"
        problems.add(Fault(faults.BAD_SHAPE, message, "give both one for each variable"), (*table.path, "start"))
        start = None
    entries = _Rows(shape, parameters, problems).read(table.data["coefficients"], path)
    if matrix is None or start is None or entries is None:
        return None
    return CoefficientGrid(dilation=matrix, start=start, coefficients=entries)


def _start(table: Table, dimension: int) -> Index | None:
    """The index of the first coefficient, zero where it is left out; None where it is wrong, which is recorded."""
    help = "write the index of the first coefficient, start = [-1, -1], or leave it out: it only shifts the limit"
    given = table.data.get("start", [0] * dimension)
    return integer_list(given, (*table.path, "start"), table.problems, "start", help)


def _shape(value: object, path: KeyPath, problems: Collector) -> tuple[int, ...] | None:
    """The lengths of the lists on the way to the first number; None where they are wrong, which is recorded."""
    shape: list[int] = []
    first = value
    while isinstance(first, list) and first:
        shape.append(len(first))
        first = first[0]
    fault = None
    if isinstance(first, list):
        fault = Fault(faults.ZERO_MASK, "the mask is empty" if not shape else "the first row is empty", _NESTED)
    elif not shape:
        fault = Fault(faults.WRONG_TYPE, f"coefficients must be a list of lists, not {described(value)}", _NESTED)
    elif len(shape) == 1:
        help = f'{_NESTED}; a mask in one variable is of kind "scalar"'
        fault = Fault(faults.BAD_SHAPE, "coefficients are one flat list, and there are at least two variables", help)
    elif len(shape) > MAX_DIMENSION:
        message = f"coefficients are nested {len(shape)} deep; there are 2 to {MAX_DIMENSION} variables"
        fault = Fault(faults.OUT_OF_BOUNDS, message, _NESTED)
    if fault:
        problems.add(fault, path)
        return None
    return tuple(shape)


class _Rows:
    """A reader of lists of lists of the lengths that the first ones have; what is wrong is recorded."""

    def __init__(self, shape: tuple[int, ...], parameters: Collection[str], problems: Collector) -> None:
        self._shape, self._parameters, self._problems = shape, parameters, problems
        self._work = Work()
        self._left = MAX_GRID

    def read(self, value: object, path: KeyPath, depth: int = 0) -> Nested | None:
        """The coefficients in the list at `path`; None where one is wrong."""
        expected = self._shape[depth]
        fault = None
        if not isinstance(value, list):
            fault = Fault(faults.BAD_SHAPE, f"a list of {expected} was expected, not {described(value)}", _NESTED)
        elif len(value) != expected:
            message = f"a list of {expected} was expected, as the first one is; this has {len(value)}"
            fault = Fault(faults.BAD_SHAPE, message, "write zeros where there is no coefficient")
        if fault:
            self._problems.add(fault, path)
            return None
        assert isinstance(value, list), "anything else is a fault"
        last = depth == len(self._shape) - 1
        read = [
            self._entry(entry, (*path, i)) if last else self.read(entry, (*path, i), depth + 1)
            for i, entry in enumerate(value)
        ]
        entries = tuple(entry for entry in read if entry is not None)
        return entries if len(entries) == len(read) else None

    def _entry(self, value: object, path: KeyPath) -> Expression | None:
        """The coefficient at `path`; None where it is wrong, or one too many."""
        self._left -= 1
        if self._left < 0:
            if self._left == -1:
                help = "give those that are not zero: terms = {…}"
                self._problems.add(
                    Fault(faults.OUT_OF_BOUNDS, f"more than {MAX_GRID} coefficients, zeros included", help), path
                )
            return None
        if isinstance(value, list):
            message = f"coefficients are nested deeper here than at the first one, {len(self._shape)} deep"
            self._problems.add(Fault(faults.BAD_SHAPE, message, _NESTED), path)
            return None
        return read_number(value, path, self._parameters, self._problems, self._work)


def read_terms(table: Table, dilation: Dilation, parameters: Collection[str]) -> Terms | None:
    """The body that `terms` gives; None where something is wrong, which is recorded."""
    problems, path = table.problems, (*table.path, "terms")
    inner = table.table("terms", 'write terms = {"0,0" = 1, "1,0" = "1/2"}')
    if inner is None:
        return None
    fault = None
    if not inner.data:
        fault = Fault(
            faults.ZERO_MASK, "the mask is empty", 'write its coefficients: terms = {"0,0" = 1, "1,0" = "1/2"}'
        )
    elif len(inner.data) > MAX_GRID:
        fault = Fault(
            faults.OUT_OF_BOUNDS,
            f"terms: {len(inner.data)} entries; the limit is {MAX_MASK_LENGTH}",
            "use a smaller mask",
        )
    if fault:
        problems.add(fault, path)
        return None
    entries: dict[Index, Expression | None] = {}
    work = Work()
    for key, value in inner.data.items():
        entry = read_number(value, (*path, key), parameters, problems, work)
        try:
            index = index_of_key(key)
            _fits(index, entries)
        except Fault as wrong:
            problems.add(wrong, (*path, key), of_key=True)
            continue
        entries[index] = entry
    matrix = dilation.of(len(next(iter(entries)))) if entries else None
    terms = tuple((index, entry) for index, entry in entries.items() if entry is not None)
    return Terms(dilation=matrix, terms=terms) if matrix is not None and len(terms) == len(inner.data) else None


def _fits(index: Index, entries: dict[Index, Expression | None]) -> None:
    """Raises Fault for an index of another length than the first (SD023), and for one that was there (SD015)."""
    if entries and len(index) != len(first := next(iter(entries))):
        message = f"an index with {len(index)} components, and the first one has {len(first)}"
        raise Fault(faults.BAD_SHAPE, message, "give each index one for each variable")
    if index in entries:
        raise Fault(faults.DUPLICATE_KEY, f"the index {','.join(map(str, index))} is given twice")
