"""The command `subdiv merge`: the JSON reports of the parts of a run, or of several runs, as one."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Iterator

import click

from subdiv_cli.cli.exits import ExitCode
from subdiv_cli.cli.outputs import Output, OutputType, put_report, put_reports
from subdiv_cli.cli.streams import complain, look_of
from subdiv_cli.report import FORMATS
from subdiv_cli.report.look import Look

_EPILOG = """\b
Examples:
  subdiv merge part-*.json -o report.json
  subdiv merge part-*.json --format markdown

\b
The parts that `subdiv check --shard I/N --format json` wrote are put back into the
order of the whole run, which would have given the same bytes. Other reports follow
one another.

\b
Exit codes:
  0    joined
  2    a file is no report, parts are missing or come twice, or two results differ
"""


@click.command("merge", epilog=_EPILOG)
@click.argument("reports", nargs=-1, required=True, metavar="REPORT...", type=click.Path())
@click.option(
    "--format", "form", type=click.Choice(list(FORMATS)), default="json", show_default=True, help="Format on stdout."
)
@click.option(
    "-o", "--output", "outputs", type=OutputType(), multiple=True, metavar="[FORMAT:]FILE",
    help="Write to FILE, and nothing to stdout. Repeatable.",
)  # fmt: skip
@click.option("-v", "--verbose", count=True, help="As in check.")
def command(reports: tuple[str, ...], form: str, outputs: tuple[Output, ...], verbose: int) -> ExitCode:
    """Join JSON reports; any format can be written from them."""
    from subdiv_cli.catalog.reports import ReportError, join, read_report, results_of
    from subdiv_cli.report import streamer
    from subdiv_cli.report.json import document

    try:
        read = [read_report(file) for file in reports]
        results, shard = join(read)
    except ReportError as error:
        return complain([error.problem])
    except ValueError as error:
        raise click.ClickException(str(error)) from None
    missing = tuple(dict.fromkeys(file for report in read for file in report.missing))
    interrupted = any(report.interrupted for report in read)

    def render(form: str, look: Look) -> Iterator[str]:
        """JSON keeps every key, also those that this version does not know."""
        if form != "json":
            return streamer(form)(results_of(results), look)
        counts = Counter(result["status"] for result in results)
        statuses = ("passed", "failed", "undecided", "invalid")
        return document(iter(results), {"files": len(results), **{status: counts[status] for status in statuses}}, look)

    look = look_of(sys.stdout, verbosity=verbose)
    look = look._replace(shard=shard, missing=missing, interrupted=interrupted)
    done = put_reports(render, form, look, outputs) if outputs else put_report(render, form, look)
    return ExitCode.PASSED if done else ExitCode.ERROR
