"""Kinds of schemes: one folder each, found by name.

`kind` has the protocol; `reading`, `option` and `writing` are the way from text to masks and back, `radius` is how all
of them say a joint spectral radius, `smoothing` leads from schemes to others, step by step. A kind's module is imported
when it is asked for, by the name that a file or a scheme has. A kind that does not declare what is asked of it is
refused in one sentence for all.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from subdiv_cli.kinds.kind import Kind, Scheme

KINDS = {
    "scalar": "subdiv_cli.kinds.scalar",
    "multivariate": "subdiv_cli.kinds.multivariate",
    "matrices": "subdiv_cli.kinds.matrices",
    "vector": "subdiv_cli.kinds.vector",
    "hermite": "subdiv_cli.kinds.hermite",
    "piecewise": "subdiv_cli.kinds.piecewise",
}
"""The module that has each kind as `KIND`, by the name of the kind."""
PLANNED = ("irrational", "surface", "nonstationary")
"""Kinds that a file may name and no module decides yet."""


def kind_named(name: str) -> Kind:
    """The kind with this name. Raises KeyError for one that does not exist."""
    kind: Kind = import_module(KINDS[name]).KIND
    return kind


def kind_of(scheme: Scheme) -> Kind:
    """The kind of a scheme."""
    return kind_named(scheme.kind)


def kinds_that(capability: str) -> tuple[str, ...]:
    """The names of the kinds that declare a capability, a field of `Kind`."""
    return tuple(name for name in KINDS if getattr(kind_named(name), capability) is not None)


_DONE = {"analyse": "checked", "portraits": "taken apart", "drawings": "drawn", "smoothing": "smoothed"}


def lacking(name: str, capability: str) -> str | None:
    """The reason why a kind lacks a capability: `masks of kind matrices cannot be checked yet`; None if it has it."""
    if name in KINDS and getattr(kind_named(name), capability) is not None:
        return None
    return f"masks of kind {name} cannot be {_DONE[capability]} yet"
