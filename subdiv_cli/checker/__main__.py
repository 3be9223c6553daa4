"""`python -m subdiv_cli.checker CERT… [--mask FILE] [--work N]`: a line for each certificate.

With --mask each must be about the mask of a plain file, one whose coefficients are literal numbers; --work is how much
work the claims of each may ask for. Exit code 0: all verified; 1: not all; 2: usage, or a file cannot be read.
"""

from __future__ import annotations

import sys

from subdiv_cli.checker import check_file
from subdiv_cli.checker.core import MAX_WORK
from subdiv_cli.checker.plain import PlainMask, certified_mask, plain_mask

USAGE = "usage: python -m subdiv_cli.checker CERT… [--mask FILE] [--work N]"


def main(names: list[str]) -> int:
    names, file = _option(names, "--mask")
    names, most = _option(names, "--work")
    work = MAX_WORK if most is None else int(most) if most.isascii() and most.isdecimal() and len(most) < 16 else 0
    if not names or not work or any(name.startswith("-") for name in names):
        print(USAGE, file=sys.stderr)
        return 2
    subject: PlainMask | None = None
    if file is not None and (subject := _read(file)) is None:
        return 2
    code = 0
    for name in names:
        try:
            outcome, text = check_file(name, work)
        except (OSError, ValueError) as error:
            print(f"{name!a}: {error}", file=sys.stderr)
            code = 2
            continue
        line, verified = outcome.line, outcome.verified
        if verified and subject is not None:
            verified = certified_mask(text) == subject
            line += f" (the mask of {file})"
            line = line if verified else f"NOT VERIFIED mask: the certificate is about another mask than {file}"
        shown = name if name.isprintable() else ascii(name)
        print((f"{shown}: " if len(names) > 1 else "") + line)
        code = max(code, 0 if verified else 1)
    return code


def _option(names: list[str], option: str) -> tuple[list[str], str | None]:
    """The other arguments, and the value of an option."""
    if option not in names[:-1]:
        return names, None
    at = names.index(option)
    return names[:at] + names[at + 2 :], names[at + 1]


def _read(file: str) -> PlainMask | None:
    try:
        with open(file, encoding="utf-8-sig") as stream:  # noqa: PTH123 (pathlib is slow to load)
            mask = plain_mask(stream.read())
    except (OSError, ValueError) as error:
        print(f"{file!a}: {error}", file=sys.stderr)
        return None
    if mask is None:
        print(f"{file!a}: no plain mask file; `subdiv verify --mask` expands parameters and symbols", file=sys.stderr)
    return mask


if __name__ == "__main__":
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
    sys.exit(main(sys.argv[1:]))
