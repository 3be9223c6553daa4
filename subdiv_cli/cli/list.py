"""The command `subdiv list`: the catalog that ships with the package, each mask with what is proved of it."""

from __future__ import annotations

import sys
from collections.abc import Sequence

import click

from subdiv_cli.cli import options
from subdiv_cli.cli.exits import ExitCode, exit_code
from subdiv_cli.cli.progress import Progress
from subdiv_cli.cli.streams import columns, look_of, put, put_pieces
from subdiv_cli.model import Result
from subdiv_cli.report import marks, words
from subdiv_cli.report.look import UNWRAPPED, Look
from subdiv_cli.report.page import Page, paint

_EPILOG = """\b
Examples:
  subdiv list
  subdiv list four-point
  subdiv list b-spline --format json

\b
A WORD is looked for in names, file names and references. What is shown is proved
here and now, or was and is verified again; the first run takes a few seconds.

\b
Exit codes:
  0    done
  1    no mask fits, or an expectation of a shipped mask is refuted
"""
_TITLES = ("mask", "convergence", "smoothness", "Hölder exponent", "stable", "file")


@click.command("list", epilog=_EPILOG)
@click.argument("words_", nargs=-1, metavar="[WORD]...")
@options.text_or_json
@options.jobs
@options.kept
def command(words_: tuple[str, ...], form: str, jobs: int, no_cache: bool, cache_dir: str | None) -> ExitCode:
    """List the masks that ship with subdiv, with what is proved of them."""
    from subdiv_cli.catalog import cache, masks_directory
    from subdiv_cli.catalog.run import check_all

    progress = Progress()
    try:
        directory = str(masks_directory())
        kept = None if no_cache else cache.directory(cache_dir)
        run = check_all([directory], jobs=jobs, cache=kept, on_total=progress.begin, on_done=progress.step)
        results = [result for result in run if _fits(result, words_)]
    except FileNotFoundError as error:
        raise click.ClickException(str(error)) from None
    finally:
        progress.close()
    look = look_of(sys.stdout, width=columns(sys.stdout, elsewhere=UNWRAPPED))
    if form == "json":
        from subdiv_cli.report import streamer

        put_pieces(streamer("json")(results, look), encoding="utf-8")
    else:
        put(_table(results, directory, look))
    return exit_code(result.status for result in results) if results else ExitCode.FAILED


def _fits(result: Result, words_: Sequence[str]) -> bool:
    text = " ".join(filter(None, (result.name, result.file, result.reference))).lower()
    return all(word.lower() in text for word in words_)


def _table(results: Sequence[Result], directory: str, look: Look) -> str:
    page = Page(look)
    page.put(f"in {directory}:", "quiet")
    rows = [
        [
            page.cell(words.name(result)),
            page.cell(words.convergence(result), marks.of_verdict(result.convergent).role),
            page.cell(words.smoothness_or_that_of_phi(result)),
            page.cell(words.holder(result)),
            page.cell(marks.of_verdict(result.stable).text, marks.of_verdict(result.stable).role),
            page.cell(result.file.removeprefix(directory).lstrip("/\\"), "quiet"),
        ]
        for result in results
    ]
    if rows:
        page.table(_TITLES, rows)
    page.put(f"{len(results)} mask{'' if len(results) == 1 else 's'}", "head")
    return paint(page.lines, colour=look.colour)
