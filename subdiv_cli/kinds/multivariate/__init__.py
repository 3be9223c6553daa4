"""Scalar masks in several variables, with any expanding integer dilation; arranged as kind scalar is."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from subdiv_cli.kinds.kind import PICTURES, Analysis, Certify, Drawings, Kind, Options, Portraits

if TYPE_CHECKING:
    from subdiv_cli.certificate import Certificate
    from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
    from subdiv_cli.maskfile.entries import Table
    from subdiv_cli.maskfile.mask import Body
    from subdiv_cli.maskfile.points import Net
    from subdiv_cli.maskfile.problems import Collector
    from subdiv_cli.model import Effort, Result, Rule
    from subdiv_cli.model.blocks import Drawing, Portrait, Section


def _read(top: Table, parameters: Collection[str], problems: Collector) -> Body | None:
    from subdiv_cli.kinds.multivariate.text.reading import read_multivariate
    from subdiv_cli.maskfile.entries import mask_table

    table = mask_table(top)
    return None if table is None else read_multivariate(table, parameters, problems)


def _body_of(scheme: MultivariateScheme) -> Body:
    from subdiv_cli.kinds.multivariate.text.writing import body_of

    return body_of(scheme)


def _spell(body: Any) -> list[str]:
    from subdiv_cli.kinds.multivariate.text.writing import spell

    return spell(body)


def _canonical(scheme: MultivariateScheme) -> Mapping[str, Any]:
    from subdiv_cli.kinds.multivariate.text import canonical

    return canonical(scheme)


def _rules() -> Mapping[str, Rule]:
    from subdiv_cli.kinds.multivariate.rules import RULES

    return RULES


def _analyse(scheme: MultivariateScheme, effort: Effort, _: Fraction | None = None) -> Analysis:
    from subdiv_cli.kinds.multivariate.stages import analyse

    return analyse(scheme, effort)


def _certificate(analysis: Analysis) -> Certificate | None:
    from subdiv_cli.kinds.multivariate.claims import certificate

    return certificate(analysis)


def _base(mask: Mapping[str, Any], variables: Sequence[int] | None) -> tuple[int, int]:
    from subdiv_cli.kinds.multivariate.scheme import characteristic_polynomial

    rows = mask["dilation"]
    block = rows if variables is None else [[rows[i][j] for j in variables] for i in variables]
    return abs(characteristic_polynomial(block)[0]), len(block)


def _sections(scheme: MultivariateScheme, result: Result) -> tuple[Section, ...]:
    from subdiv_cli.kinds.multivariate.portrait.stencils import sections

    return sections(scheme, result)


def _portrait(analysis: Analysis, result: Result) -> Portrait:
    from subdiv_cli.kinds.multivariate.portrait.page import portrait

    return portrait(analysis, result)


def _surfaces(scheme: MultivariateScheme, effort: Effort, options: Options, certify: Certify) -> Drawing:
    from subdiv_cli.kinds.multivariate.portrait.pictures import surfaces

    return surfaces(scheme, effort, options, certify)


def _nets(scheme: MultivariateScheme, effort: Effort, options: Options, certify: Certify) -> Drawing:
    from subdiv_cli.kinds.multivariate.portrait.pictures import nets

    return nets(scheme, effort, options, certify)


def _net(file: str) -> Net:
    from subdiv_cli.maskfile.points import read_net

    return read_net(file)


_OF_NETS = frozenset({"points", "levels"})
KIND = Kind(
    name="multivariate",
    read=_read,
    body_of=_body_of,
    spell=_spell,
    canonical=_canonical,
    rules=_rules,
    analyse=_analyse,
    certificate=_certificate,
    base=_base,
    sections=_sections,
    portraits=Portraits(_analyse, _portrait),
    drawings=(
        Drawings("nets", _nets, frozenset({".obj"}), _OF_NETS, points=_net, most=1),
        Drawings("surfaces", _surfaces, frozenset({""}), most=6),
        Drawings("surfaces", _surfaces, PICTURES - {""}, frozenset({"style"}), most=6),
    ),
)
