"""The independent checker of certificates: standard library only, nothing else of the package, no search.

`certificate/FORMAT.md` specifies what it reads. At the top lies what one must trust first. `core`: goal and claims in
order, each by its rule from earlier ones, within its work; it knows no kind. `reading`, `json_text`, `numerals`: strict
input. `polynomials`, `matrices`, `roots`: the arithmetic, in integers. `plain`: masks of plain files.

A kind is a folder with one object, the `RULEBOOK` in its `rules`: what documents of the kind are about, the closed
lists of properties and rules, the words of the printed line, plain files. A rule is one function, and its docstring is
what it proves. `radius` has the rules on joint spectral radii of families of matrices, which all kinds share; `curves`
those of kind `matrices`; `scalar`, `multivariate`, `vector`, `hermite` and `piecewise` those on masks.
`python -m subdiv_cli.checker CERT…` runs it.
"""

from __future__ import annotations

from collections.abc import Callable, MutableMapping
from importlib import import_module
from typing import Any

from subdiv_cli.checker import core
from subdiv_cli.checker.core import MAX_WORK, Outcome, Rulebook
from subdiv_cli.checker.reading import MAX_BYTES

__all__ = ["KINDS", "Outcome", "check_document", "check_file", "check_text"]


class _Kinds(dict[str, Any]):
    """The rulebooks by the names of their kinds; one that is given by its module's name is loaded on first use."""

    def __getitem__(self, name: str) -> Rulebook:
        if type(super().__getitem__(name)) is str:
            self[name] = import_module(super().__getitem__(name)).RULEBOOK
        rulebook: Rulebook = super().__getitem__(name)
        return rulebook


KINDS: MutableMapping[str, Rulebook] = _Kinds(
    scalar="subdiv_cli.checker.scalar.rules",
    matrices="subdiv_cli.checker.curves.rules",
    multivariate="subdiv_cli.checker.multivariate.rules",
    vector="subdiv_cli.checker.vector.rules",
    hermite="subdiv_cli.checker.hermite.rules",
    piecewise="subdiv_cli.checker.piecewise.rules",
)
"""The rulebooks of all kinds of documents. A new kind adds a line; no certificate names a module."""


def check_text(text: str, work: int = MAX_WORK) -> Outcome:
    """Check a certificate as it stands in its file. Never raises: whatever goes wrong is not verified.

    `work` is how much its claims may ask for, in the units that FORMAT.md counts in.
    """
    return core.check_text(text, KINDS, work)


def check_document(document: object, goes_on: Callable[[], bool] = lambda: True) -> Outcome:
    """The outcome for a certificate that is already parsed, as `json.loads` gives it.

    `goes_on` is asked before each claim whether there is time for it; where there is none, that claim fails.
    """
    return core.check_document(document, KINDS, goes_on=goes_on)


def check_file(name: str, work: int = MAX_WORK) -> tuple[Outcome, str]:
    """Check a certificate's file; its text as well, "" where it is not UTF-8. Raises OSError if it cannot be read."""
    with open(name, "rb") as file:  # noqa: PTH123 (pathlib is slow to load)
        content = file.read(MAX_BYTES + 1)
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError:
        return core.not_verified("document", "not UTF-8"), ""
    if len(content) > MAX_BYTES:
        return core.not_verified("document", "the file is too large"), ""
    return check_text(text, work), text
