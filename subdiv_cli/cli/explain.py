"""The command `subdiv explain`: the page of a finding code, of a kind of scheme, or of a subject."""

from __future__ import annotations

import sys

import click

from subdiv_cli.cli.completers import complete_page
from subdiv_cli.cli.streams import columns, emit, has_colour, speaks_mathematics
from subdiv_cli.report.look import UNWRAPPED

_EPILOG = """\b
Examples:
  subdiv explain
  subdiv explain SD301
  subdiv explain contractivity
  subdiv explain multivariate
  subdiv explain formats

\b
Exit codes:
  0    the page or the list is printed
  2    there is no such page
"""

_LEAST = 20
"""The columns that a summary needs to be of use."""


@click.command("explain", epilog=_EPILOG)
@click.argument("name", required=False, metavar="[CODE | KIND | SUBJECT]", shell_complete=complete_page)
def command(name: str | None) -> None:
    """Explain a finding, a kind of scheme, or a subject.

    Of a finding, by its CODE as in a report, SD201, or its name, convergence: what it means, why it matters, how to
    mend it, its source. Of a KIND, such as multivariate: its files, and what is decided. Without a name the pages are
    listed.
    """
    from subdiv_cli.explain import UnknownPageError, page

    if name is None:
        _print(_list())
        return
    try:
        text = page(name)
    except UnknownPageError as error:
        raise click.UsageError(str(error)) from None
    if has_colour(sys.stdout) and speaks_mathematics(sys.stdout):
        _print(_rendered(text))
    else:
        emit(_fitting(text), sys.stdout)


def _list() -> str:
    """The text with a line for each page: its name and the beginning of its text; those of codes come last."""
    from subdiv_cli.explain import codes, subjects, title

    return _lines({name: name for name in subjects()}) + "\n" + _lines({c: f"{c}  {title(c)}" for c in codes()})


def _lines(pages: dict[str, str]) -> str:
    """A line for each of these pages, by what it begins with, as wide as stdout."""
    from subdiv_cli.explain import page
    from subdiv_cli.report.letters import letters, width
    from subdiv_cli.report.page import wrap

    unicode = speaks_mathematics(sys.stdout)
    dots = " …" if unicode else " ..."
    longest = max(map(width, pages.values()), default=0)
    lines = []
    for name, shown in pages.items():
        lead = f"{shown}{' ' * (longest - width(shown))}  "
        _, _, text = page(name).partition("\n\n")
        summary = letters(" ".join(text.partition("\n\n")[0].split()), unicode)
        room = _room() - width(lead)
        if room < _LEAST:
            summary = ""
        elif width(summary) > room:
            summary = wrap(summary, room - len(dots))[0].rstrip(" ,;:") + dots
        lines.append(f"{lead}{summary}".rstrip() + "\n")
    return "".join(lines)


def _room() -> int:
    """The columns of stdout; in a pipe and in a file nothing is cut or wrapped."""
    return columns(sys.stdout, elsewhere=UNWRAPPED)


def _print(text: str) -> None:
    from subdiv_cli.report.letters import letters

    unicode = speaks_mathematics(sys.stdout)
    emit(text if unicode else "\n".join(letters(line, unicode) for line in text.split("\n")), sys.stdout)


def _fitting(text: str) -> str:
    """The page in the letters and the width of stdout: paragraphs that are wider are wrapped, examples are not."""
    from subdiv_cli.report.letters import letters, width
    from subdiv_cli.report.page import wrap

    room, unicode, blocks, example = _room(), speaks_mathematics(sys.stdout), [], False
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
