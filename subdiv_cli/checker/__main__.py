"""`python -m subdiv_cli.checker CERT…`: a line for each certificate.

Exit code 0: all verified; 1: not all; 2: usage, or a file cannot be read.
"""

from __future__ import annotations

import sys

from subdiv_cli.checker import check_file


def main(names: list[str]) -> int:
    if not names or any(name.startswith("-") for name in names):
        print("usage: python -m subdiv_cli.checker CERT…", file=sys.stderr)
        return 2
    code = 0
    for name in names:
        try:
            outcome, _ = check_file(name)
        except (OSError, ValueError) as error:
            print(f"{name!a}: {error}", file=sys.stderr)
            code = 2
            continue
        shown = name if name.isprintable() else ascii(name)
        print((f"{shown}: " if len(names) > 1 else "") + outcome.line)
        code = max(code, 0 if outcome.verified else 1)
    return code


if __name__ == "__main__":
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
    sys.exit(main(sys.argv[1:]))
