"""The process around the command line: `python -m subdiv_cli` is `subdiv`."""

from __future__ import annotations

import gc
import os
import sys


def run() -> None:
    """Run the command line and end the process at once.

    In a pre-commit hook start and end cost more than the work. Imports make many objects that live on, so the garbage
    collector is set to look less often; and when all is written there is nothing to tear down.
    """
    gc.set_threshold(50_000)
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:  # closed by the shell, as in `subdiv … >&-`
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: PTH123, SIM115
    from subdiv_cli.cli import main

    code: object = 1
    try:
        main(prog_name="subdiv")
    except SystemExit as end:
        code = end.code
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    except OSError:
        pass  # the reader has gone; the verdict stands
    os._exit(code if isinstance(code, int) else 0 if code is None else 1)


if __name__ == "__main__":
    run()
