"""The command `subdiv explain`: the page of a finding code."""

from __future__ import annotations

import sys

import click

from subdiv_cli.cli.completers import complete_code
from subdiv_cli.cli.streams import columns, emit, has_colour, speaks_mathematics

_EPILOG = """\b
Examples:
  subdiv explain
  subdiv explain SD301
  subdiv explain contractivity
  subdiv explain hermite

\b
Exit codes:
  0    the page or the list is printed
  2    there is no such code
"""

_LEAST = 20
"""The columns that a summary needs to be of use."""


@click.command("explain", epilog=_EPILOG)
@click.argument("code", required=False, shell_complete=complete_code)
def command(code: str | None) -> None:
    """Explain a finding CODE: what it means, why it matters, how to mend it, its source.

    CODE is as in a report, SD201, or its name, convergence; or a kind of masks, hermite, of which the page says what
    stands in a file. Without CODE the codes are listed.
    """
    from subdiv_cli.explain import UnknownCodeError, page

    if code is None:
        _print(_list())
        return
    try:
        text = page(code)
    except UnknownCodeError as error:
        raise click.UsageError(str(error)) from None
    if has_colour(sys.stdout) and speaks_mathematics(sys.stdout):
        _print(_rendered(text))
    else:
        emit(_fitting(text), sys.stdout)


def _list() -> str:
    """The text with a line for each code: its name and the beginning of its page."""
    from subdiv_cli.explain import codes, kinds, page, title
    from subdiv_cli.report.letters import letters, width
    from subdiv_cli.report.page import wrap

    unicode = speaks_mathematics(sys.stdout)
    dots = " …" if unicode else " ..."
    known = {code: title(code) for code in codes()} | dict.fromkeys(kinds(), "")
    longest = max(map(width, known.values()), default=0)
    lines = []
    for code, name in known.items():
        lead = f"{code}  {name}{' ' * (longest + 5 - width(code + name))}  "
        _, _, text = page(code).partition("\n\n")
        summary = letters(" ".join(text.partition("\n\n")[0].split()), unicode)
        room = columns(sys.stdout) - width(lead)
        if room < _LEAST:
            summary = ""
        elif width(summary) > room:
            summary = wrap(summary, room - len(dots))[0].rstrip(" ,;:") + dots
        lines.append(f"{lead}{summary}".rstrip() + "\n")
    return "".join(lines)


def _print(text: str) -> None:
    from subdiv_cli.report.letters import letters

    unicode = speaks_mathematics(sys.stdout)
    emit(text if unicode else "\n".join(letters(line, unicode) for line in text.split("\n")), sys.stdout)


def _fitting(text: str) -> str:
    """The page in the letters and the width of stdout: paragraphs that are wider are wrapped, examples are not."""
    from subdiv_cli.report.letters import letters, width
    from subdiv_cli.report.page import wrap

    room, unicode, blocks, example = columns(sys.stdout), speaks_mathematics(sys.stdout), [], False
    for block in text.split("\n\n"):
        lines = [letters(line, unicode) for line in block.split("\n")]
        if not example and not block.startswith("```") and any(width(line) > room for line in lines):
            items = "\n".join(lines).replace("\n- ", "\0- ").split("\0")
            lines = [line for item in items for line in wrap(" ".join(item.split()), room)]
        example ^= block.count("```") % 2 == 1
        blocks.append("\n".join(lines))
    return "\n\n".join(blocks)


def _rendered(text: str) -> str:
    """The page as a terminal shows it best."""
    from io import StringIO

    from rich.console import Console
    from rich.markdown import Markdown

    buffer = StringIO()
    Console(file=buffer, force_terminal=True, width=min(columns(sys.stdout), 100)).print(Markdown(text))
    return buffer.getvalue()
