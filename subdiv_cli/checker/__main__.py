"""The command `python -m subdiv_cli.checker CERT… [--mask FILE]`: a line for each certificate.

With --mask each must be about the mask of a plain file, one whose coefficients are literal numbers. Exit code 0: all
verified; 1: not all; 2: usage, or a file cannot be read.
"""

from __future__ import annotations

import sys

from subdiv_cli.checker import check_file
from subdiv_cli.checker.plain import PlainMask, certified_mask, plain_mask

USAGE = "usage: python -m subdiv_cli.checker CERT… [--mask FILE]"


def main(names: list[str]) -> int:
    """The exit code of the command with these arguments; the lines are printed."""
    names, file = _split(names)
    if not names or any(name.startswith("-") for name in names):
        print(USAGE, file=sys.stderr)
        return 2
    asked: PlainMask | None = None
    if file is not None and (asked := _read(file)) is None:
        return 2
    code = 0
    for name in names:
        try:
            outcome, text = check_file(name)
        except (OSError, ValueError) as error:
            print(f"{name!a}: {error}", file=sys.stderr)
            code = 2
            continue
        line, verified = outcome.line, outcome.verified
        if verified and asked is not None:
            verified = certified_mask(text) == asked
            line += f" (the mask of {file})"
            line = line if verified else f"NOT VERIFIED mask: the certificate is about another mask than {file}"
        shown = name if name.isprintable() else ascii(name)
        print((f"{shown}: " if len(names) > 1 else "") + line)
        code = max(code, 0 if verified else 1)
    return code


def _split(names: list[str]) -> tuple[list[str], str | None]:
    """The names of the certificates, and the file of --mask, None without it."""
    if "--mask" not in names[:-1]:
        return names, None
    at = names.index("--mask")
    return names[:at] + names[at + 2 :], names[at + 1]


def _read(file: str) -> PlainMask | None:
    try:
        with open(file, encoding="utf-8-sig") as stream:  # noqa: PTH123 (pathlib is slow to load)
            found = plain_mask(stream.read())
    except (OSError, ValueError) as error:
        print(f"{file!a}: {error}", file=sys.stderr)
        return None
    if found is None:
        print(f"{file!a}: no plain mask file; `subdiv verify --mask` expands parameters and symbols", file=sys.stderr)
    return found


if __name__ == "__main__":
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
    sys.exit(main(sys.argv[1:]))
