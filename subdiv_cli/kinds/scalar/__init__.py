"""Scalar masks in one variable, of any arity.

`scheme` is the mask, `text` its file, `rules` the table of its codes; `numbers` computes, `stages` decide, `claims`
prove to the checker, `portrait` shows. FORMAT.md specifies the claims.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from subdiv_cli.kinds.kind import PICTURES, Analysis, Certify, Drawings, Kind, Options, Portraits

if TYPE_CHECKING:
    from subdiv_cli.certificate import Certificate
    from subdiv_cli.kinds.scalar.scheme import ScalarScheme
    from subdiv_cli.maskfile.entries import Table
    from subdiv_cli.maskfile.mask import Body
    from subdiv_cli.maskfile.points import Points
    from subdiv_cli.maskfile.problems import Collector
    from subdiv_cli.model import Effort, Result, Rule
    from subdiv_cli.model.blocks import Drawing, Portrait, Section


def _read(top: Table, parameters: Collection[str], problems: Collector) -> Body | None:
    from subdiv_cli.kinds.scalar.text import read_scalar
    from subdiv_cli.maskfile.entries import mask_table

    table = mask_table(top)
    return None if table is None else read_scalar(table, parameters, problems)


def _body_of(scheme: ScalarScheme) -> Body:
    from subdiv_cli.kinds.scalar.text import body_of

    return body_of(scheme)


def _spell(body: Any) -> list[str]:
    from subdiv_cli.kinds.scalar.text import spell

    return spell(body)


def _canonical(scheme: ScalarScheme) -> Mapping[str, Any]:
    from subdiv_cli.kinds.scalar.text import canonical

    return canonical(scheme)


def _rules() -> Mapping[str, Rule]:
    from subdiv_cli.kinds.scalar.rules import RULES

    return RULES


def _analyse(scheme: ScalarScheme, effort: Effort, tolerance: Fraction | None = None) -> Analysis:
    from subdiv_cli.kinds.scalar.stages import analyse

    return analyse(scheme, effort, tolerance)


def _certificate(analysis: Analysis) -> Certificate | None:
    from subdiv_cli.kinds.scalar.claims import certificate

    return certificate(analysis)


def _sections(scheme: ScalarScheme, result: Result) -> tuple[Section, ...]:
    from subdiv_cli.kinds.scalar.portrait.sections import sections

    return sections(scheme, result)


def _portrait(analysis: Analysis, result: Result) -> Portrait:
    from subdiv_cli.kinds.scalar.portrait.page import portrait

    return portrait(analysis, result)


def _functions(scheme: ScalarScheme, effort: Effort, options: Options, certify: Certify) -> Drawing:
    from subdiv_cli.kinds.scalar.portrait.curves import functions

    return functions(scheme, effort, options, certify)


def _curves(scheme: ScalarScheme, effort: Effort, options: Options, certify: Certify) -> Drawing:
    from subdiv_cli.kinds.scalar.portrait.curves import curves

    return curves(scheme, effort, options, certify)


def _points(file: str) -> Points:
    from subdiv_cli.maskfile.points import read_points

    return read_points(file)


_OF_CURVES = frozenset({"points", "closed", "levels", "samples"})
KIND = Kind(
    name="scalar",
    read=_read,
    body_of=_body_of,
    spell=_spell,
    canonical=_canonical,
    rules=_rules,
    analyse=_analyse,
    certificate=_certificate,
    base=lambda mask, _: (mask["arity"], 1),
    sections=_sections,
    portraits=Portraits(_analyse, _portrait, frozenset({"tolerance"})),
    drawings=(
        Drawings("curves", _curves, PICTURES, _OF_CURVES, needs=frozenset({"points"}), points=_points),
        Drawings("functions", _functions, PICTURES, frozenset({"derivatives", "samples"})),
    ),
)
