"""The command group: it knows its commands by name and imports one when it is called, so that `--help` is quick.

It also makes sure that an exit code means what `exits` says: click's own is 1 for an uncaught exception.
"""

from __future__ import annotations

import errno
import sys
from collections.abc import Sequence
from contextlib import suppress
from importlib import import_module
from io import TextIOWrapper
from typing import Any, NoReturn

import click

from subdiv_cli.cli.exits import ExitCode

COMMANDS = {
    "check": ("subdiv_cli.cli.check", "Check masks: convergence, smoothness, expectations."),
    "show": ("subdiv_cli.cli.show", "Take a mask apart: symbol, matrices, stencils, Q, error bounds."),
    "plot": ("subdiv_cli.cli.plot", "Draw the refinable function, its derivatives, and curves."),
    "sweep": ("subdiv_cli.cli.sweep", "A table or picture of exponents and norms along a family."),
    "smooth": ("subdiv_cli.cli.smooth", "Write a smoother scheme, or the derived one: a new mask file."),
    "blend": ("subdiv_cli.cli.blend", "Join two masks by special rules that keep polynomials."),
    "jsr": ("subdiv_cli.cli.jsr", "Joint spectral radius of matrices, with proof."),
    "list": ("subdiv_cli.cli.list", "The masks that ship with subdiv, and what is proved of them."),
    "merge": ("subdiv_cli.cli.merge", "Join the JSON reports of the parts of a run."),
    "verify": ("subdiv_cli.cli.verify", "Check certificates independently."),
    "explain": ("subdiv_cli.cli.explain", "Explain a finding code: what it means, why, its source."),
    "clean": ("subdiv_cli.cli.clean", "Remove the results kept of earlier runs."),
    "completion": ("subdiv_cli.cli.completion", "Print the completion script of a shell."),
}
"""The module that has each command as `command`, and its summary in a line."""


class LazyGroup(click.Group):
    """A group whose commands are modules, imported on use."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """The commands in the order of use."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command of this name, imported; None for an unknown one, which click then reports."""
        if cmd_name not in COMMANDS:
            return None
        command: click.Command = import_module(COMMANDS[cmd_name][0]).command
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """The command of a line, as click resolves it, with near names for an unknown one.

        Click itself looks only at commands it has imported.
        """
        name = args[0]
        if name not in COMMANDS and not name.startswith("-") and not ctx.resilient_parsing:
            ctx.fail(_no_command(name))
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the commands without importing them."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, summary) for name, (_, summary) in COMMANDS.items()])

    def main(self, args: Sequence[str] | None = None, *positional: Any, **extra: Any) -> NoReturn:
        """Run, and exit with an ExitCode whatever happens."""
        args = list(sys.argv[1:] if args is None else args)
        for stream in (sys.stdout, sys.stderr):
            if isinstance(stream, TextIOWrapper):
                stream.reconfigure(errors="backslashreplace")  # click prints names as they are given
        extra["standalone_mode"] = False
        try:
            code = super().main(args, *positional, **extra)
        except click.Abort:
            code = ExitCode.INTERRUPTED
        except click.ClickException as error:
            with suppress(OSError):  # stderr may be full too
                error.show()
            code = ExitCode.ERROR
        except BrokenPipeError:
            code = ExitCode.PASSED
        except Exception as error:
            if not _unwritten(error):
                _report(error, debug="--debug" in args)
            code = ExitCode.ERROR
        sys.exit(int(code) if isinstance(code, int) else ExitCode.PASSED)


def _no_command(name: str) -> str:
    """The message for a word that is no command: its command was forgotten, or the command is misspelt."""
    from pathlib import Path

    if name.endswith(".toml") or Path(name).exists():
        from shlex import quote

        return f"no command {name!r}: did you mean `subdiv check {quote(name)}`?"
    from difflib import get_close_matches

    near = get_close_matches(name, COMMANDS, n=1, cutoff=0.5)
    help = f"did you mean {near[0]!r}?" if near else f"there are {', '.join(COMMANDS)}."
    return f"no command {name!r}: {help}"


def _unwritten(error: Exception) -> bool:
    """Whether stdout was full while click wrote to it, `--help` for instance; that is then reported."""
    if not isinstance(error, OSError) or error.errno not in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG):
        return False
    from subdiv_cli.cli.streams import UnwritableError, abandon

    abandon(sys.stdout)
    UnwritableError(error).show()
    return True


def _report(error: Exception, *, debug: bool) -> None:
    """Report that this is our mistake, not the reader's."""
    from subdiv_cli.cli.streams import emit, look_of
    from subdiv_cli.maskfile.problems import internal_error
    from subdiv_cli.report.problems import render

    if debug:
        from traceback import format_exception

        emit("".join(format_exception(error)), sys.stderr)
    emit(render([internal_error(error)], look_of(sys.stderr)), sys.stderr)
