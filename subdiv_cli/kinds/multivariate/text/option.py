"""Masks in several variables from the command line: lists in lists, or a symbol in z1, z2, …; the dilation is pI."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from math import prod

from subdiv_cli.kinds.multivariate.text.bodies import CoefficientGrid, LaurentSymbol, Nested
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_COSETS, MAX_DIMENSION, MAX_GRID, MAX_INDEX
from subdiv_cli.maskfile.expressions import Expression, names_in
from subdiv_cli.maskfile.grammar import parse
from subdiv_cli.maskfile.laurent import VARIABLES
from subdiv_cli.maskfile.problems import Fault
from subdiv_cli.spaces.lattice import IntMatrix, multiple_of_identity


def symbol(text: str, arity: int, names: Collection[str]) -> LaurentSymbol:
    """The symbol's body. Raises Fault."""
    node = parse(text, (*VARIABLES[1:], *names))
    dimension = max((VARIABLES.index(name) for name in names_in(node) & frozenset(VARIABLES)), default=0)
    if dimension < 2:
        raise Fault(faults.BAD_SHAPE, "z2 is not in the symbol: it has one variable", "write z for z1, or a mask file")
    return LaurentSymbol(dilation=_dilation(arity, dimension), expression=Expression(text=text.strip(), node=node))


def grid(entries: Nested, start: Sequence[int], arity: int) -> CoefficientGrid:
    """The body of coefficients, their lists as long as the first ones; no `start` is zero. Raises Fault."""
    shape = _shape(entries)
    if start and len(start) != len(shape):
        plural = "" if len(start) == 1 else "s"
        message = f"--start has {len(start)} component{plural}, and the lists are nested {len(shape)} deep"
        raise Fault(faults.BAD_SHAPE, message, f"--start {','.join('0' * len(shape))}")
    if prod(shape) > MAX_GRID:
        raise Fault(
            faults.OUT_OF_BOUNDS, f"more than {MAX_GRID} coefficients, zeros included", "write terms in a mask file"
        )
    if any(abs(k) > MAX_INDEX for k in start):
        raise Fault(faults.OUT_OF_BOUNDS, f"start is beyond {MAX_INDEX}", f"--start {','.join('0' * len(shape))}")
    return CoefficientGrid(
        dilation=_dilation(arity, len(shape)), start=tuple(start) or (0,) * len(shape), coefficients=entries
    )


def _dilation(arity: int, dimension: int) -> IntMatrix:
    """The arity times the identity. Raises Fault where that is too much."""
    if arity**dimension > MAX_COSETS:
        message = f"the dilation has determinant {arity**dimension}; the limit is {MAX_COSETS}"
        raise Fault(faults.OUT_OF_BOUNDS, message, "use a smaller arity")
    return multiple_of_identity(arity, dimension)


def _shape(entries: Nested) -> tuple[int, ...]:
    """The lengths of nested lists, the same everywhere. Raises Fault."""
    shapes = {() if isinstance(entry, Expression) else _shape(entry) for entry in entries}
    if len(shapes) > 1:
        raise Fault(
            faults.BAD_SHAPE,
            "the lists are of different lengths or depths",
            "write zeros where there is no coefficient",
        )
    shape = (len(entries), *shapes.pop())
    if len(shape) > MAX_DIMENSION:
        message = f"lists are nested {len(shape)} deep; there are at most {MAX_DIMENSION} variables"
        raise Fault(faults.OUT_OF_BOUNDS, message, "write [[1, 2], [2, 1]]/2")
    return shape
