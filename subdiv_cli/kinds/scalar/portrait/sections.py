"""Sections of a report on a scalar mask beside the findings: φ, the stencils, the limit stencil; no flint."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

from subdiv_cli.kinds.scalar.numbers.curve import Signal, curve, integer_values, limit_stencil, rule
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.model import Result, Verdict
from subdiv_cli.model.blocks import Block, Grid, Section, Text
from subdiv_cli.model.closed import rational
from subdiv_cli.model.formulas import datum


def sections(scheme: ScalarScheme, result: Result) -> tuple[Section, ...]:
    """The curve of φ and its limit stencil where convergence is proved, and the stencil of each new point."""
    p = scheme.arity
    values = integer_values(scheme) if result.convergent is Verdict.PROVED else None
    rules = [(f"(S f)_({p}k{f'+{e}' if e else ''})", rule(scheme, e).trimmed()) for e in range(p)]
    picture: Block = Text("φ is drawn where convergence is proved.", "quiet")
    stencils: list[Block] = [aligned("", rules, _node, rational)]
    if values is not None:
        picture = curve(scheme, values)
        stencils.append(aligned("", [("limit at k", limit_stencil(values).trimmed())], _node, rational))
    return Section("", (picture,)), Section("stencils", tuple(stencils))


def _node(offset: int) -> str:
    return datum("k", offset)


def aligned(
    corner: str,
    rows: Sequence[tuple[str, Signal]],
    node: Callable[[int], str],
    spell: Callable[[Fraction], str],
    empty: str = "",
) -> Grid:
    """Sequences on common nodes, each with its name; `empty` stands where one has no value."""
    spans = [range(signal.start, signal.start + len(signal.values)) for _, signal in rows if signal.values]
    nodes = range(min(span[0] for span in spans), max(span[-1] for span in spans) + 1) if spans else range(0)
    numbers = []
    for name, signal in rows:
        before = [empty] * (signal.start - nodes.start) if signal.values else []
        row = [*before, *map(spell, signal.values)]
        numbers.append((name, (*row, *[empty] * (len(nodes) - len(row)))))
    return Grid(corner, tuple(map(node, nodes)), tuple(numbers))
