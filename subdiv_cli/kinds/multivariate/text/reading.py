"""The [mask] table of kind multivariate: a dilation, and one of the forms that give the coefficients."""

from __future__ import annotations

from collections.abc import Collection

from subdiv_cli.kinds.multivariate.text.bodies import LaurentSymbol
from subdiv_cli.kinds.multivariate.text.box_spline import read_box_spline
from subdiv_cli.kinds.multivariate.text.dilation import Dilation
from subdiv_cli.kinds.multivariate.text.grid import read_grid, read_terms
from subdiv_cli.kinds.multivariate.text.tensor import read_tensor
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.entries import Table, mask_table, read_symbol
from subdiv_cli.maskfile.expressions import names_in
from subdiv_cli.maskfile.laurent import VARIABLES
from subdiv_cli.maskfile.mask import Body
from subdiv_cli.maskfile.problems import Collector, Fault

FORMS = ("coefficients", "terms", "symbol", "box_spline", "tensor")
"""The keys that give a mask: one of these."""
_KEYS = ("dilation", "start", *FORMS)
_DILATION = "a multivariate mask has a dilation: dilation = 2, or a matrix [[1, 1], [1, -1]]"
_BOX = "it belongs to box_spline = {directions = [[1,0],[0,1],[1,1]], multiplicities = [2,2,2]}"
_ELSEWHERE = {
    "arity": (_DILATION, "dilation"),
    "matrix": (_DILATION, "dilation"),
    "offset": ("did you mean start?", "start"),
    "mask": ("did you mean coefficients?", "coefficients"),
    "directions": (_BOX, "coefficients"),
    "multiplicities": (_BOX, "coefficients"),
} | dict.fromkeys(("kind", "name", "reference", "format"), ("it belongs at the top, above [mask]", ""))


def read(top: Table, parameters: Collection[str], problems: Collector) -> Body | None:
    """The mask of a file; None where something is wrong, which is recorded."""
    table = mask_table(top)
    if table is None:
        return None
    table.only(_KEYS, _ELSEWHERE)
    dilation = Dilation(table)
    given = [key for key in table.data if key in FORMS]
    if not given:
        help = f'give one of {", ".join(FORMS)}: symbol = "(1+z1) (1+z2) (1+z1*z2) / 2"'
        table.missing("coefficients", "nothing gives the coefficients of the mask", help, instead=FORMS)
        return None
    form = given[0]
    for other in given[1:] + (["start"] if "start" in table.data and form != "coefficients" else []):
        fault = Fault(faults.DUPLICATE_KEY, f"{form} and {other} both give the mask")
        problems.add(fault, (*table.path, other), of_key=True)
    if form == "coefficients":
        return read_grid(table, dilation, parameters)
    if form == "terms":
        return read_terms(table, dilation, parameters)
    if form == "symbol":
        return _symbol(table, dilation, parameters)
    if form == "box_spline":
        return read_box_spline(table, dilation)
    return read_tensor(table, dilation, parameters)


def _symbol(table: Table, dilation: Dilation, parameters: Collection[str]) -> LaurentSymbol | None:
    """The body that `symbol` gives; None where something is wrong, which is recorded."""
    help = 'write an expression in z1, z2, …: symbol = "(1+z1) (1+z2) (1+z1*z2) / 2"'
    variables = VARIABLES[1 : None if dilation.rows is None else len(dilation.rows) + 1]
    expression = read_symbol(table, {*parameters, *variables}, help)
    if expression is None:
        return None
    used = names_in(expression.node) & frozenset(variables)
    dimension = max((VARIABLES.index(name) for name in used), default=0) if dilation.rows is None else len(variables)
    if dimension < 2:
        message = "the symbol does not say how many variables there are: z2 is not in it"
        help = "give the dilation as a matrix, [[2, 0], [0, 2]]; one variable is z, in a scalar mask"
        table.problems.add(Fault(faults.BAD_SHAPE, message, help), (*table.path, "symbol"))
        return None
    matrix = dilation.of(dimension)
    return None if matrix is None else LaurentSymbol(dilation=matrix, expression=expression)
