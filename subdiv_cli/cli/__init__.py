"""The command line: one click command per file; options in, a call, an exit code out.

`group` finds the commands, `exits` has the exit codes, `streams` the terminal, pipes and files.
"""

from __future__ import annotations

import click

import subdiv_cli
from subdiv_cli.cli.group import LazyGroup

__all__ = ["main"]


@click.group(
    cls=LazyGroup,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog="Start with: subdiv check FILE. Then: subdiv check --help.",
)
@click.version_option(subdiv_cli.__version__, prog_name="subdiv")
def main() -> None:
    """Decide convergence and smoothness of subdivision schemes from their masks, exactly.

    Every verdict is a theorem with its numbers: proved, refuted, or undecided with the reason.
    """
