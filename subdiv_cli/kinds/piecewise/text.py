"""The text of a piecewise scheme: `left` and `right`, masks or files, `spacing`, and `[special]` rows; the way back."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.kinds.files import mask_in_file
from subdiv_cli.kinds.piecewise.scheme import PiecewiseScheme
from subdiv_cli.kinds.scalar.text import Coefficients, Symbol, read_scalar, spelled_entries
from subdiv_cli.kinds.scalar.text import body_of as mask_body_of
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.entries import Table, read_number
from subdiv_cli.maskfile.expressions import Expression, literal, number_of
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath, shown, shown_number
from subdiv_cli.maskfile.spelling import listed, number
from subdiv_cli.maskfile.values import described
from subdiv_cli.model.closed import rational

Mask = Coefficients | Symbol
LARGEST_POINT = 100
"""The largest size of the index of a special row, and of a point that one reads."""
_FARTHEST = 1000
"""The largest size of an index in the support of a mask."""
_SPACING = "write spacing = [1, 2] above the tables: the distances of old points left and right of 0"
_SPECIAL = 'write [special] and rows such as 1 = {"0" = "1/2", "1" = "1/2"}: the weights of old points'
_INDEX = re.compile(r"-?(0|[1-9][0-9]{0,8})")
_TWO_VARIABLES = ("dilation", "terms", "tensor", "box_spline")
_AT_THE_TOP = {"spacing", "special", "shear"}
_ONE = Expression(text="1", node=literal(Fraction(1)).node)


class Sides(NamedTuple):
    """The masks of both sides, the spacings, and the special rows of a file."""

    left: Mask
    right: Mask
    spacing: tuple[Expression, Expression]
    special: tuple[tuple[int, tuple[tuple[int, Expression], ...]], ...]

    def expressions(self) -> Iterable[Expression]:
        """The expressions of the body, each of which may have parameters."""
        yield from self.left.expressions()
        yield from self.right.expressions()
        yield from self.spacing
        for _, row in self.special:
            yield from (weight for _, weight in row)

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> PiecewiseScheme | None:
        """The scheme with the values put in; None where something is wrong, which is recorded as SD007 to SD011."""
        left, right = self.left.scheme(values, problems, work), self.right.scheme(values, problems, work)
        spacing = [number_of(each, values, problems, work) for each in self.spacing]
        rows = [(i, [(j, number_of(x, values, problems, work)) for j, x in row]) for i, row in self.special]
        for place, x in enumerate(spacing):
            if x is not None and x <= 0:
                message = f"a spacing must be positive, not {shown_number(x)}"
                problems.add(Fault(faults.OUT_OF_BOUNDS, message, _SPACING), ("spacing", place))
                return None
        for name, mask in (("left", left), ("right", right)):
            if mask is not None and max(-mask.start, mask.start + mask.degree) > _FARTHEST:
                message = f"the mask reaches beyond index {_FARTHEST}, so that no point near 0 has a rule of its own"
                problems.add(Fault(faults.OUT_OF_BOUNDS, message, "shift the mask towards 0"), (name,))
                return None
        weights = tuple((i, tuple((j, x) for j, x in row if x is not None)) for i, row in rows)
        if left is None or right is None or None in spacing or any(None in dict(row).values() for _, row in rows):
            return None
        return PiecewiseScheme(left, right, (spacing[0] or Fraction(1), spacing[1] or Fraction(1)), weights)


def read(top: Table, parameters: Collection[str], problems: Collector) -> Sides | None:
    """The scheme of a file; None where something is wrong, which is recorded."""
    if "shear" in top.data:
        message = "shear is for two variables, and piecewise schemes are decided in one"
        problems.add(Fault(faults.KIND_NOT_BUILT, message, "write masks in one variable"), ("shear",), of_key=True)
    left, right = (_side(top, name, parameters) for name in ("left", "right"))
    spacing, special = _spacing(top, parameters), _special(top, parameters)
    if left is None or right is None or spacing is None or special is None or "shear" in top.data:
        return None
    if left.arity != right.arity:
        message = f"the masks must be of one arity, and the left one has {left.arity}, the right one {right.arity}"
        problems.add(Fault(faults.BAD_SHAPE, message, "give both the same arity"), ("right",))
        return None
    return Sides(left, right, spacing, special)


def _side(top: Table, name: str, parameters: Collection[str]) -> Mask | None:
    """The mask of a side, from a table or the name of a file; None where something is wrong, which is recorded."""
    problems = top.problems
    help = f'write {name} = "four_point.toml", or [{name}] with start and coefficients'
    if name not in top.data:
        top.missing(name, f"the {name} mask is missing", help)
        return None
    value = top.data[name]
    if isinstance(value, dict):
        if (mark := next((key for key in _TWO_VARIABLES if key in value), None)) is not None:
            message = f"{mark} is for masks in several variables, and piecewise schemes are decided in one"
            fault = Fault(faults.KIND_NOT_BUILT, message, "write start and coefficients")
            problems.add(fault, (name, mark), of_key=True)
            return None
        for key in _AT_THE_TOP & value.keys():
            fault = Fault(faults.UNKNOWN_KEY, f'unknown key "{key}" in [{name}]', "it belongs at the top, above [left]")
            problems.add(fault, (name, key), of_key=True)
        own = {key: entry for key, entry in value.items() if key not in _AT_THE_TOP}
        return read_scalar(Table(own, (name,), problems), parameters, problems)
    fault = Fault(faults.WRONG_TYPE, f"{name} must be a mask or the name of a file, not {described(value)}", help)
    if isinstance(value, str):
        try:
            return mask_in_file(value, problems.file)
        except Fault as wrong:
            fault = wrong
    problems.add(fault, (name,))
    return None


def _spacing(top: Table, parameters: Collection[str]) -> tuple[Expression, Expression] | None:
    """The spacings, 1 where there are none; None where something is wrong, which is recorded."""
    value = top.data.get("spacing", [1, 1])
    if not isinstance(value, list) or len(value) != 2:
        given = f"a list of {len(value)}" if isinstance(value, list) else described(value)
        fault = Fault(faults.WRONG_TYPE, f"spacing must be a list of two numbers, not {given}", _SPACING)
        top.problems.add(fault, ("spacing",))
        return None
    if "spacing" not in top.data:
        return _ONE, _ONE
    left, right = (read_number(x, ("spacing", i), parameters, top.problems, Work()) for i, x in enumerate(value))
    return None if left is None or right is None else (left, right)


def _special(
    top: Table, parameters: Collection[str]
) -> tuple[tuple[int, tuple[tuple[int, Expression], ...]], ...] | None:
    """The special rows, none where there is no table; None where something is wrong, which is recorded."""
    table = top.table("special", _SPECIAL)
    if table is None:
        return None if "special" in top.data else ()
    rows, work, right = [], Work(), True
    for key, value in table.data.items():
        path: KeyPath = ("special", key)
        i = _index(key, path, "a new point", top.problems)
        if not isinstance(value, dict):
            fault = Fault(faults.WRONG_TYPE, f"a row must be a table of weights, not {described(value)}", _SPECIAL)
            top.problems.add(fault, path)
            right = False
            continue
        pairs = [
            (
                _index(j, (*path, j), "an old point", top.problems),
                read_number(x, (*path, j), parameters, top.problems, work),
            )
            for j, x in value.items()
        ]
        row = tuple((j, x) for j, x in pairs if j is not None and x is not None)
        right = right and i is not None and len(row) == len(pairs)
        rows.append((i or 0, row))
    return tuple(rows) if right else None


def _index(key: str, path: KeyPath, what: str, problems: Collector) -> int | None:
    """The index that a key is; None for another key, which is recorded."""
    if "," in key:
        message = f'"{shown(key)}" has several components, and piecewise schemes are decided in one variable'
        problems.add(Fault(faults.KIND_NOT_BUILT, message, _SPECIAL), path, of_key=True)
        return None
    if not _INDEX.fullmatch(key) or key == "-0":
        message = f'there is no point "{shown(key)}": {what} has an integer as its index'
        problems.add(Fault(faults.UNKNOWN_KEY, message, _SPECIAL), path, of_key=True)
        return None
    if abs(int(key)) > LARGEST_POINT:
        message = f"{what} must lie between -{LARGEST_POINT} and {LARGEST_POINT}, not at {key}"
        problems.add(Fault(faults.OUT_OF_BOUNDS, message, "special rules are for points near 0"), path, of_key=True)
        return None
    return int(key)


def body_of(scheme: PiecewiseScheme) -> Sides:
    """The literal numbers of a scheme."""
    rows = tuple((i, tuple((j, literal(x)) for j, x in row)) for i, row in scheme.special)
    left, right = map(literal, scheme.spacing)
    return Sides(mask_body_of(scheme.left), mask_body_of(scheme.right), (left, right), rows)


def spell(body: Sides) -> list[str]:
    """The lines of the file of a scheme: the spacing, and a table for each side and for the special rows."""
    lines = [] if body.spacing == (_ONE, _ONE) else [*listed("spacing", map(number, body.spacing)), ""]
    lines += ["[left]", *spelled_entries(body.left), "", "[right]", *spelled_entries(body.right)]
    if body.special:
        lines += ["", "[special]"]
        for i, row in body.special:
            lines.append(f"{i} = {{{', '.join(f'{j} = {number(x)}' for j, x in row)}}}")
    return lines


def canonical(scheme: PiecewiseScheme) -> Mapping[str, Any]:
    """The scheme as certificates embed it, in one spelling, so that two schemes are the same iff these are equal."""
    sides = {
        name: {"start": mask.start, "coefficients": [rational(c) for c in mask.coefficients]}
        for name, mask in (("left", scheme.left), ("right", scheme.right))
    }
    special = []
    for i, row in scheme.special:
        first, last = (row[0][0], row[-1][0]) if row else (0, -1)
        entries = [rational(dict(row).get(j, Fraction(0))) for j in range(first, last + 1)]
        special.append({"row": i, "start": first, "coefficients": entries})
    spacing = [rational(x) for x in scheme.spacing]
    return {"kind": scheme.kind, "arity": scheme.arity, **sides, "spacing": spacing, "special": special}
