"""Masks that are no files, from `--mask` or standard input: a list of coefficients, or a symbol."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING, NamedTuple

from subdiv_cli.kinds.scalar.text import Coefficients, Symbol
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_ARITY, MAX_EXPONENT, MAX_FILE_BYTES, MAX_MASK_LENGTH, MAX_NESTING
from subdiv_cli.maskfile.entries import fault_of_name
from subdiv_cli.maskfile.expressions import Expression, names_in
from subdiv_cli.maskfile.grammar import Parser, parse
from subdiv_cli.maskfile.mask import Body, MaskFile, check_fixed_mask
from subdiv_cli.maskfile.nodes import Factor, Node, Product, Sum, product_of
from subdiv_cli.maskfile.option import Given
from subdiv_cli.maskfile.pasted import is_list, plain
from subdiv_cli.maskfile.problems import Collector, Fault, Reason, Source, shown

if TYPE_CHECKING:
    from subdiv_cli.kinds.multivariate.text.bodies import Nested

_GROUP = re.compile(r"\(([^()]*)\)")
_SEVERAL = re.compile(r"(?<![A-Za-z0-9_])z[0-9]")
"""The sign of a symbol in several variables: it contains this."""


def from_option(
    text: str,
    *,
    file: str = "--mask",
    start: int | Sequence[int] = 0,
    arity: int = 2,
    names: Collection[str] = (),
) -> MaskFile:
    """The mask of `--mask`: "[-1,0,9,16,9,0,-1]/16", its first index `start`, or a symbol, "(1+z)^2/2".

    Lists may be spelled as `maskfile.pasted` reads them. In several variables lists in lists,
    "[[1,2,1],[2,4,2],[1,2,1]]/4" with an index for each, or a symbol in z1, z2, …; the dilation is then `arity` times
    the identity.

    `file` is the place that problems name. `names`: parameters that -p gives. Those that stand in the mask are
    declared, without a default; `MaskFile.values` refuses a value for another. Raises MaskFileError; positions count
    in the text.
    """
    source = Source(file, text, toml=False)
    problems = Collector(source)
    try:
        if len(text) > MAX_FILE_BYTES:
            raise Fault(faults.OUT_OF_BOUNDS, "the mask is too long", "write it to a file")
        if not 2 <= arity <= MAX_ARITY:
            raise Fault(
                faults.OUT_OF_BOUNDS,
                f"the arity must be between 2 and {MAX_ARITY}, not {shown(str(arity))}",
                "--arity 2",
            )
        for name in names:
            if fault_there := fault_of_name(name):
                raise fault_there
        body = _body(text, (start,) if isinstance(start, int) else tuple(start), arity, names)
        check_fixed_mask(body, problems)
    except Fault as fault:
        problems.add(_on_the_command_line(fault))
    problems.raise_any()
    used = frozenset().union(*(names_in(entry.node) for entry in body.expressions()))
    parameters = {name: None for name in names if name in used}
    kind = "scalar" if isinstance(body, Coefficients | Symbol) else "multivariate"
    return MaskFile(file=file, body=body, kind=kind, parameters=parameters, source=source)


def from_given(text: str, given: Given, *, file: str = "--mask") -> MaskFile:
    """The mask of a text with the words that stand beside it on the command line. Raises MaskFileError."""
    arity = 2 if given.arity is None else given.arity
    return from_option(text, file=file, start=given.start or 0, arity=arity, names=given.names)


def _body(text: str, start: tuple[int, ...], arity: int, names: Collection[str]) -> Body:
    """The body that the text of `--mask` gives. Raises Fault."""
    text = plain(text)
    if not is_list(text):
        if any(start):
            raise Fault(
                faults.DUPLICATE_KEY, "--start and a symbol both say where the mask begins", "leave --start out"
            )
        if _SEVERAL.search(text):
            from subdiv_cli.kinds.multivariate.text.option import symbol

            return symbol(text, arity, names)
        return Symbol(arity=arity, expression=Expression(text=text.strip(), node=parse(text, ("z", *names))))
    entries = _list(text, names)
    flat = tuple(entry for entry in entries if isinstance(entry, Expression))
    if len(flat) < len(entries):
        from subdiv_cli.kinds.multivariate.text.option import grid

        return grid(entries, start if len(start) > 1 or any(start) else (), arity)
    if len(start) > 1:
        raise Fault(
            faults.BAD_SHAPE, f"--start has {len(start)} components, and the mask has one variable", "--start 0"
        )
    if not -MAX_EXPONENT <= start[0] <= MAX_EXPONENT:
        raise Fault(faults.OUT_OF_BOUNDS, f"start must be between -{MAX_EXPONENT} and {MAX_EXPONENT}", "--start 0")
    return Coefficients(arity=arity, start=start[0], entries=flat)


def _on_the_command_line(fault: Fault) -> Fault:
    """The fault in the words of the command line, where its help is about mask files."""
    if fault.reason is not Reason.UNDECLARED:
        return fault
    return Fault(fault.rule, fault.message, f"give it a value: -p {shown(fault.about or 'w')}=1/16", fault.at)


def _list(text: str, names: Collection[str]) -> Nested:
    """The coefficients of a list by the grammar: list = [ factors [ "*" ] ] rows { ("*" | "/") factor } | values.

    The factors go into every coefficient.
    """
    opening = text.find("[")
    if opening < 0:
        return _scaled_rows(_values(Parser(text, names), text, 0, "end"), _Scale())
    front = text[:opening].strip()
    lead = f"{front}1" if front in ("-", "+") else front.removesuffix("*").rstrip()
    before: list[Factor] = []
    if front:
        parser = Parser(lead, names, at=text.index(front))
        before = [Factor(parser.factor(), False, parser.token.at), *_more_factors(parser, "* or / or a list")]
    parser = Parser(text[opening:], names, at=opening)
    rows = _rows(parser, text, 1)
    start = parser.token.at
    behind = _more_factors(parser, "* or / or the end")
    return _scaled_rows(rows, _Scale(f"{lead}*" if front else "", tuple(before), text[start:].strip(), tuple(behind)))


def _more_factors(parser: Parser, expected: str) -> list[Factor]:
    """The factors up to the end by the grammar: { ("*" | "/") factor }."""
    factors = []
    while parser.token.kind in ("*", "/"):
        divides = parser.advance().kind == "/"
        at = parser.token.at
        factors.append(Factor(parser.factor(), divides, at))
    if parser.token.kind != "end":
        raise parser.unexpected(expected)
    return factors


class _Span(NamedTuple):
    """A coefficient and its text."""

    node: Node
    text: str


_Rows = list["_Span | _Rows"]


def _rows(parser: Parser, text: str, depth: int) -> _Rows:
    """The rows by the grammar: rows = "[" values "]"."""
    opening = parser.advance()
    if depth > MAX_NESTING:
        raise Fault(
            faults.OUT_OF_BOUNDS,
            f"lists are nested more than {MAX_NESTING} deep",
            "write [[1, 2], [2, 1]]/2",
            opening.at,
        )
    if parser.token.kind == "]":
        raise Fault(faults.ZERO_MASK, "the mask is empty", "write its coefficients: [1, 2, 1]/2", parser.token.at)
    spans = _values(parser, text, depth, "]")
    if parser.token.kind == "end":
        raise Fault(faults.BAD_EXPRESSION, 'this "[" is never closed', 'add the missing "]"', opening.at)
    parser.advance()
    return spans


def _values(parser: Parser, text: str, depth: int, closing: str) -> _Rows:
    """The values by the grammar: values = (rows | sum) { "," (rows | sum) }; the closing token, or the end, is next."""
    spans: _Rows = []
    first = parser.token.at
    while True:
        start = parser.token.at
        if parser.token.kind == "[":
            spans.append(_rows(parser, text, depth + 1))
        else:
            node = parser.sum()
            spans.append(_Span(node, text[start : parser.token.at].strip()))
        if parser.token.kind in (closing, "end"):
            return spans
        if parser.token.kind != ",":
            raise parser.unexpected(f'a comma or "{closing}"')
        parser.advance()
        if len(spans) > MAX_MASK_LENGTH:
            raise Fault(faults.OUT_OF_BOUNDS, f"more than {MAX_MASK_LENGTH} coefficients", "use a shorter mask", first)


class _Scale(NamedTuple):
    """The factors before and behind a list, with their texts."""

    text_before: str = ""
    before: tuple[Factor, ...] = ()
    text_behind: str = ""
    behind: tuple[Factor, ...] = ()


def _scaled_rows(rows: _Rows, scale: _Scale) -> Nested:
    """The coefficients times the factors round the list, in the lists they stand in."""
    return tuple(_scaled(entry, scale) if isinstance(entry, _Span) else _scaled_rows(entry, scale) for entry in rows)


def _scaled(entry: _Span, scale: _Scale) -> Expression:
    """A coefficient times the factors round the list, as reading its text again gives it."""
    node = entry.node
    text = _ungrouped(entry.text)
    if scale == _Scale():
        return Expression(text=text, node=node)
    if isinstance(node, Sum) and len(node.terms) > 1:
        text = f"({text})"
    factors = node.factors if isinstance(node, Product) else (Factor(node),)
    node = product_of((*scale.before, *factors, *scale.behind), node.at)
    return Expression(text=f"{scale.text_before}{text}{scale.text_behind}", node=node)


def _ungrouped(text: str) -> str:
    """The text of an expression without parentheses round the whole, which may stand for quotation marks."""
    group = _GROUP.fullmatch(text)
    return group[1].strip() if group else text
