"""Masks -> TOML text; reading it again gives an equal mask."""

from __future__ import annotations

from subdiv_cli.kinds import kind_named, kind_of
from subdiv_cli.kinds.kind import Scheme
from subdiv_cli.maskfile.mask import MaskFile
from subdiv_cli.maskfile.spelling import INTEGER, key_of, number, quoted
from subdiv_cli.model import Expectation


def write(mask: MaskFile) -> str:
    """The text of a mask file; its comments and layout are not kept, the spelling of every number is."""
    lines = ["format = 1"]
    for key, text in (("name", mask.name), ("reference", mask.reference)):
        if text is not None:
            lines.append(f"{key} = {quoted(text)}")
    lines.append(f"kind = {quoted(mask.kind)}")
    if mask.parameters:
        lines += ["", "[parameters]"]
        lines += [
            f"{key_of(name)} = {number(default) if default else quoted('')}"
            for name, default in mask.parameters.items()
        ]
    lines += ["", *kind_named(mask.kind).spell(mask.body)]
    if mask.expectations:
        lines += ["", "[expect]"]
        for e in mask.expectations:
            bare = isinstance(e.lower, bool) or (isinstance(e.lower, int) and INTEGER.fullmatch(e.text))
            lines.append(f"{e.key} = {e.text if bare else quoted(e.text)}")
    return "\n".join(lines) + "\n"


def from_scheme(
    scheme: Scheme,
    *,
    file: str = "-",
    name: str | None = None,
    reference: str | None = None,
    expectations: tuple[Expectation, ...] = (),
) -> MaskFile:
    """The file of a scheme with literal coefficients, for `write`."""
    body = kind_of(scheme).body_of(scheme)
    return MaskFile(file=file, body=body, name=name, reference=reference, kind=scheme.kind, expectations=expectations)
