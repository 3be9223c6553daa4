"""Scalar masks in one variable, of any arity.

`scheme` is the mask, `text` its file, `rules` the table of its codes; `numbers` computes, `stages` decide, `claims`
prove to the checker, `portrait` shows. FORMAT.md specifies the claims.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from subdiv_cli.kinds.kind import Analysis, Kind

if TYPE_CHECKING:
    from subdiv_cli.certificate import Certificate
    from subdiv_cli.kinds.scalar.scheme import ScalarScheme
    from subdiv_cli.maskfile.entries import Table
    from subdiv_cli.maskfile.mask import Body
    from subdiv_cli.maskfile.problems import Collector
    from subdiv_cli.model import Effort, Rule


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
)
