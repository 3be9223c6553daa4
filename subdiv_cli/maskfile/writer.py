"""`MaskFile` -> TOML text; reading it again gives an equal mask."""

from __future__ import annotations

import re
from collections.abc import Iterable

from subdiv_cli.kinds.multivariate.scheme import multiple_of_identity
from subdiv_cli.maskfile.bodies import Body, Coefficients, Symbol
from subdiv_cli.maskfile.expressions import Expression
from subdiv_cli.maskfile.mask import MaskFile

_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")
_INTEGER = re.compile(r"0|-?[1-9][0-9]{0,17}")
_SHORT = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t", "\r": "\\r"}
_WIDTH = 100


def write(mask: MaskFile) -> str:
    """The text of a mask file; its comments and layout are not kept, the spelling of every number is."""
    lines = ["format = 1"]
    for key, text in (("name", mask.name), ("reference", mask.reference)):
        if text is not None:
            lines.append(f"{key} = {_quoted(text)}")
    lines.append(f"kind = {_quoted(mask.kind)}")
    if mask.parameters:
        lines += ["", "[parameters]"]
        lines += [
            f"{_key(name)} = {_number(default) if default else _quoted('')}"
            for name, default in mask.parameters.items()
        ]
    lines += ["", "[mask]", *_body(mask.body)]
    if mask.expectations:
        lines += ["", "[expect]"]
        for e in mask.expectations:
            bare = isinstance(e.lower, bool) or (isinstance(e.lower, int) and _INTEGER.fullmatch(e.text))
            lines.append(f"{e.key} = {e.text if bare else _quoted(e.text)}")
    return "\n".join(lines) + "\n"


def _body(body: Body) -> list[str]:
    """The lines of [mask]."""
    if isinstance(body, Coefficients | Symbol):
        return _scalar(body)
    from subdiv_cli.kinds.multivariate.text.bodies import BoxSpline, Grid, LaurentSymbol, Tensor, Terms

    if isinstance(body, Tensor):
        return [line for factor in body.factors for line in ("", "[[mask.tensor]]", *_scalar(factor))][1:]
    assert isinstance(body, BoxSpline | Grid | LaurentSymbol | Terms)
    rows, c = body.dilation, body.dilation[0][0]
    plain = rows == multiple_of_identity(c, len(rows)) and not isinstance(body, LaurentSymbol)
    lines = [f"dilation = {c if plain else _nested(rows)}"]
    if isinstance(body, Grid):
        lines.append(f"start = {_nested(body.start)}")
        return lines + _list("coefficients", map(_nested, body.coefficients))
    if isinstance(body, Terms):
        terms = [f'"{",".join(map(str, index))}" = {_number(value)}' for index, value in body.terms]
        return [*lines, "", "[mask.terms]", *terms]
    if isinstance(body, LaurentSymbol):
        return [*lines, f"symbol = {_quoted(body.expression.text)}"]
    table = f"{{directions = {_nested(body.directions)}, multiplicities = {_nested(body.multiplicities)}}}"
    return [*lines, f"box_spline = {table}"]


def _scalar(body: Coefficients | Symbol) -> list[str]:
    lines = [f"arity = {body.arity}"]
    if isinstance(body, Coefficients):
        return [*lines, f"start = {body.start}", *_list("coefficients", map(_number, body.entries))]
    return [*lines, f"symbol = {_quoted(body.expression.text)}"]


def _nested(value: object) -> str:
    """Numbers in lists in lists."""
    if isinstance(value, tuple):
        return f"[{', '.join(map(_nested, value))}]"
    return _number(value) if isinstance(value, Expression) else str(value)


def _number(expression: Expression) -> str:
    return expression.text if _INTEGER.fullmatch(expression.text) else _quoted(expression.text)


def _list(key: str, items: Iterable[str]) -> list[str]:
    """One line where it fits, else as many as are needed."""
    items = list(items)
    if len(one := f"{key} = [{', '.join(items)}]") <= _WIDTH:
        return [one]
    lines, line = [f"{key} = ["], "   "
    for item in items:
        if len(line) + len(item) + 2 > _WIDTH and line.strip():
            lines.append(line)
            line = "   "
        line += f" {item},"
    return [*lines, line, "]"]


def _key(name: str) -> str:
    return name if _BARE_KEY.fullmatch(name) else _quoted(name)


def _quoted(text: str) -> str:
    return '"' + "".join(_SHORT.get(c) or (c if c >= " " and c != "\x7f" else f"\\u{ord(c):04X}") for c in text) + '"'
