"""The command `subdiv completion`: the script by which a shell completes commands, options, files and codes."""

from __future__ import annotations

import sys

import click

from subdiv_cli.cli.streams import emit

_EPILOG = """\b
To have it in every shell:
  bash   subdiv completion bash > ~/.local/share/bash-completion/completions/subdiv
  zsh    subdiv completion zsh > "${fpath[1]}/_subdiv"
  fish   subdiv completion fish > ~/.config/fish/completions/subdiv.fish

\b
In this one:
  bash   source <(subdiv completion bash)
  zsh    source <(subdiv completion zsh)
  fish   subdiv completion fish | source
"""


@click.command("completion", epilog=_EPILOG)
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
@click.pass_context
def command(ctx: click.Context, shell: str) -> None:
    """Print the completion script of a SHELL."""
    from click.shell_completion import get_completion_class

    known = get_completion_class(shell)
    assert known is not None, "click knows the three"
    emit(known(ctx.find_root().command, {}, "subdiv", "_SUBDIV_COMPLETE").source() + "\n", sys.stdout)
