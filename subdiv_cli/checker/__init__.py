"""The independent checker of certificates: standard library only, nothing else of the package, no search.

`certificate/FORMAT.md` specifies what it reads. `reading` is strict input, `core` the order of goal and claims,
`rules` the closed list of rules, which are one function each: in `scalar` those that compute with a mask, in
`conclusions` those that compose claims; of masks on Z^s in `multivariate`, `differences`, `box_splines`, `directional`
and, composing, `surfaces`. `polynomials`, `matrices` and `lattice` do the arithmetic, in integers; `words` is for the
printed line. `python -m subdiv_cli.checker CERT…` runs it.
"""

from __future__ import annotations

from subdiv_cli.checker import core
from subdiv_cli.checker.core import Outcome
from subdiv_cli.checker.reading import MAX_BYTES
from subdiv_cli.checker.rules import MATRICES, MULTIVARIATE, SCALAR

__all__ = ["Outcome", "check_document", "check_file", "check_text"]

_KINDS = {"scalar": SCALAR, "matrices": MATRICES, "multivariate": MULTIVARIATE}


def check_text(text: str) -> Outcome:
    """Check a certificate as it stands in its file. Never raises: whatever goes wrong is not verified."""
    return core.check_text(text, _KINDS)


def check_document(document: object) -> Outcome:
    """Check a certificate that is already parsed, as `json.loads` gives it."""
    return core.check_document(document, _KINDS)


def check_file(name: str) -> tuple[Outcome, str]:
    """Check a certificate's file; its text as well, "" where it is not UTF-8. Raises OSError if it cannot be read."""
    with open(name, "rb") as file:  # noqa: PTH123 (pathlib is slow to load)
        content = file.read(MAX_BYTES + 1)
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError:
        return core.not_verified("document", "not UTF-8"), ""
    if len(content) > MAX_BYTES:
        return core.not_verified("document", "the file is too large"), ""
    return check_text(text), text
