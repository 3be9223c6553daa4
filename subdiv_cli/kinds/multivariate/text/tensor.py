"""The key `tensor = [{…}, "four_point.toml"]` of a mask file: scalar masks, inline or in files beside this one."""

from __future__ import annotations

from collections.abc import Collection

from subdiv_cli.kinds.files import mask_in_file
from subdiv_cli.kinds.multivariate.text.bodies import Tensor
from subdiv_cli.kinds.multivariate.text.dilation import Dilation
from subdiv_cli.kinds.scalar.text import Coefficients, Symbol, read_scalar
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_COSETS, MAX_DIMENSION
from subdiv_cli.maskfile.entries import Table
from subdiv_cli.maskfile.problems import Fault, KeyPath
from subdiv_cli.maskfile.values import described

_HELP = 'write tensor = [{symbol = "(1+z)^2/2"}, "four_point.toml"]: a mask or a file for each variable'


def read_tensor(table: Table, dilation: Dilation, parameters: Collection[str]) -> Tensor | None:
    """The body of a tensor product; None where something is wrong, which is recorded."""
    value, path = table.data["tensor"], (*table.path, "tensor")
    fault = None
    if not isinstance(value, list):
        fault = Fault(faults.WRONG_TYPE, f"tensor must be a list of masks, not {described(value)}", _HELP)
    elif not 2 <= len(value) <= MAX_DIMENSION:
        plural = "" if len(value) == 1 else "s"
        message = f"tensor has {len(value)} mask{plural}; there are 2 to {MAX_DIMENSION} variables"
        fault = Fault(faults.BAD_SHAPE, message, _HELP)
    if fault:
        table.problems.add(fault, path)
        return None
    assert isinstance(value, list), "anything else is a fault"
    read = [_factor(factor, (*path, i), table, parameters) for i, factor in enumerate(value)]
    factors = tuple(factor for factor in read if factor is not None)
    if len(factors) < len(read) or not _agree(factors, dilation, table):
        return None
    return Tensor(factors)


def _factor(value: object, path: KeyPath, table: Table, parameters: Collection[str]) -> Coefficients | Symbol | None:
    """The mask that a table or the name of a file gives; None where something is wrong, which is recorded."""
    if isinstance(value, dict):
        return read_scalar(Table(value, path, table.problems), parameters, table.problems)
    fault = Fault(faults.WRONG_TYPE, f"a mask or the name of a file was expected, not {described(value)}", _HELP)
    if isinstance(value, str):
        try:
            return mask_in_file(value, table.problems.file)
        except Fault as wrong:
            fault = wrong
    table.problems.add(fault, path)
    return None


def _agree(factors: tuple[Coefficients | Symbol, ...], dilation: Dilation, table: Table) -> bool:
    """Whether all factors are of one arity, and of the dilation where one is given; recorded otherwise."""
    arities = sorted({factor.arity for factor in factors})
    if len(arities) > 1:
        message = f"the masks of a tensor product must be of one arity, and there are {' and '.join(map(str, arities))}"
        table.problems.add(Fault(faults.BAD_SHAPE, message, "give all the same arity"), (*table.path, "tensor"))
        return False
    if arities[0] ** len(factors) > MAX_COSETS:
        message = f"the dilation has determinant {arities[0] ** len(factors)}; the limit is {MAX_COSETS}"
        table.problems.add(
            Fault(faults.OUT_OF_BOUNDS, message, "use masks of a smaller arity"), (*table.path, "tensor")
        )
        return False
    if dilation.given and dilation.factor != arities[0]:
        if dilation.factor is not None or dilation.rows is not None:
            message = f"the masks of the tensor product are of arity {arities[0]}, which is its dilation"
            table.problems.add(
                Fault(faults.BAD_DILATION, message, f"leave dilation out, or write {arities[0]}"), dilation.path
            )
        return False
    return not dilation.given or dilation.rows is None or dilation.of(len(factors)) is not None
