"""Families of square matrices, whose joint spectral radius `subdiv jsr` encloses."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING, Any

from subdiv_cli.kinds.kind import Kind

if TYPE_CHECKING:
    from subdiv_cli.kinds.matrices.text import MatrixFamily
    from subdiv_cli.maskfile.entries import Table
    from subdiv_cli.maskfile.mask import Body
    from subdiv_cli.maskfile.problems import Collector


def _read(top: Table, parameters: Collection[str], problems: Collector) -> Body | None:
    from subdiv_cli.kinds.matrices.text import read_matrices

    return read_matrices(top, parameters, problems)


def _body_of(family: MatrixFamily) -> Body:
    from subdiv_cli.kinds.matrices.text import body_of

    return body_of(family)


def _spell(body: Any) -> list[str]:
    from subdiv_cli.kinds.matrices.text import spell

    return spell(body)


def _canonical(family: MatrixFamily) -> Mapping[str, Any]:
    from subdiv_cli.kinds.matrices.text import canonical

    return canonical(family)


KIND = Kind(
    name="matrices",
    keys=("matrices",),
    read=_read,
    body_of=_body_of,
    spell=_spell,
    canonical=_canonical,
    rules=dict,
)
