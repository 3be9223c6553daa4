"""Scalar masks in several variables, with any expanding integer dilation; arranged as kind scalar is."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from subdiv_cli.kinds.kind import Analysis, Kind

if TYPE_CHECKING:
    from subdiv_cli.certificate import Certificate
    from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
    from subdiv_cli.maskfile.entries import Table
    from subdiv_cli.maskfile.mask import Body
    from subdiv_cli.maskfile.problems import Collector
    from subdiv_cli.model import Effort, Rule


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


def _analyse(scheme: MultivariateScheme, effort: Effort) -> Analysis:
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
)
