"""`python -m subdiv_cli` is `subdiv`."""

from __future__ import annotations

from subdiv_cli.cli import main

if __name__ == "__main__":
    main(prog_name="subdiv")
