"""The command `subdiv check`: masks in, a report out, an exit code that says what was proved."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Any

import click

from subdiv_cli.cli import masks
from subdiv_cli.cli.exits import ExitCode, exit_code
from subdiv_cli.cli.options import CheckOptions, SectionedCommand, check_options
from subdiv_cli.cli.outputs import put_report, put_reports, put_statistics
from subdiv_cli.cli.running import Run, tell_missing
from subdiv_cli.cli.settings import SettingsError, with_settings
from subdiv_cli.cli.streams import complain, emit, look_of
from subdiv_cli.report import streamer
from subdiv_cli.report.look import Look

_EPILOG = """\b
Examples:
  subdiv check four-point.toml
  subdiv check four-point.toml -p w=1/20
  subdiv check four-point.toml -p w=1/16 -p w=1/8
  subdiv check masks/ -q
  subdiv check masks/ --jobs 2 --format github -o junit.xml -o json:report.json
  subdiv check masks/ --require C1 --require "holder>=1.5"
  subdiv check masks/ --baseline report.json
  subdiv check masks/ --exclude drafts --exclude "masks/**/*_old.toml"
  subdiv check masks/ --statistics
  subdiv check masks/ --shard 1/4 --format json > part-1.json
  git diff --name-only main -- "*.toml" | subdiv check --files-from -
  subdiv check masks/ --certificate proofs/ && subdiv verify proofs/
  subdiv check --mask "[-1, 0, 9, 16, 9, 0, -1]/16" --start -3
  subdiv check --mask "[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]" -p w=1/16
  generate | subdiv check - --allow-undecided

\b
Exit codes:
  0    every expectation proved (convergence, where a mask states none)
  1    an expectation refuted, or something worse than in the baseline
  2    not checked: usage, an unreadable or invalid mask, an internal error
  3    nothing refuted, something undecided, or left out of a --certificate (0 with
       --allow-undecided)
  130  interrupted; the masks checked so far are reported
  Of several, 2 beats 1 beats 3, and 130 beats all. --exit-zero makes 1 and 3 a 0.

\b
The report is on stdout. Progress is on stderr, and so are the errors of invalid
masks in the text format; the other formats have them in the report.

\b
Options have defaults in [tool.subdiv] of the nearest pyproject.toml: format,
select, ignore, require, baseline, allow-undecided, effort, budget, jobs, cache,
cache-dir, dask, exclude. Environment variables stand above those, the command line above
all. Where no FILE is named, paths has those to be checked. NO_COLOR and COLUMNS are honoured.
"""

_MOST_REASONS = 10
"""The most certificates of which is said why they could not be written."""


@click.command("check", cls=SectionedCommand, epilog=_EPILOG)
@check_options
@click.pass_context
def command(ctx: click.Context, /, **given: Any) -> ExitCode:
    """Check subdivision masks: convergence, order of smoothness, exponents, and what each file expects.

    A FILE is a TOML mask file; a DIR is searched for them, but for what git ignores or --exclude has a pattern for; a
    pattern such as "masks/**/*.toml" names those that match; - reads one mask from stdin.
    """
    try:
        options = CheckOptions(**with_settings(ctx, given))
    except SettingsError as error:
        return complain([error.problem])
    masks.usage(options)
    values = masks.overrides(options.parameters)
    arguments = {**_settings(options), "overrides": values, "required": masks.required(options.require)}
    look = _look(options)
    run = Run(options, look)
    run.go(masks.targets(options, values), arguments)
    return _close(run, look)


def _settings(options: CheckOptions) -> dict[str, Any]:
    """The arguments of the run for the catalog."""
    from subdiv_cli.catalog.cache import directory

    arguments: dict[str, Any] = {
        "work": options.effort,
        "seconds": options.budget,
        "debug": options.debug,
        "jobs": options.jobs,
        "cache": None if options.no_cache else directory(options.cache_dir),
    }
    optional: dict[str, Any] = {
        "certificates": options.certificates,
        "shard": options.shard,
        "cluster": options.dask,
        "exclude": options.exclude or None,
    }
    if options.mask is None and (options.start is not None or options.arity is not None):
        from subdiv_cli.maskfile.option import Given

        optional["given"] = Given(options.start, options.arity)
    return arguments | {key: value for key, value in optional.items() if value is not None}


def _look(options: CheckOptions) -> Look:
    from subdiv_cli.explain import codes

    known = codes()
    for code in (*options.select, *options.ignore):
        if not any(one.startswith(code.upper()) for one in known):
            raise click.UsageError(f"no finding code begins with {code!r}; `subdiv explain` lists them")
    return look_of(sys.stdout, verbosity=options.verbosity, allow_undecided=options.allow_undecided)._replace(
        select=tuple(code.upper() for code in options.select),
        ignore=tuple(code.upper() for code in options.ignore),
        shard=options.shard,
    )


def _close(run: Run, look: Look) -> ExitCode:
    """The exit code, after the report is written."""
    options = run.options
    missing = run.missing()
    look = look._replace(missing=missing, interrupted=run.interrupted or run.ended)

    def render(form: str, look: Look) -> Iterator[str]:
        return streamer(form)(run.results, look)

    if options.form == "text" and not options.statistics:  # the errors on stderr, and first
        complain(run.problems)
    if options.statistics:
        printed = put_statistics(run.results, options.form, look)
    elif options.form == "jsonl":
        printed = run.printed
    else:
        printed = put_report(render, options.form, look._replace(problems=False))
    written = put_reports(render, options.form, look, options.outputs)
    tell_missing(missing)
    for file, reason in list(run.unwritten.items())[:_MOST_REASONS]:
        emit(f"error: the certificate of {file} cannot be written: {reason}\n", sys.stderr)
    for sentence in run.unproved:
        emit(f"warning: {sentence}\n", sys.stderr)
    count = len(run.results)
    if run.interrupted:
        emit(f"interrupted: {count} mask{'' if count == 1 else 's'} checked until then\n", sys.stderr)
    statuses = (result.status for result in run.results)
    code = exit_code(statuses, allow_undecided=options.allow_undecided, interrupted=run.interrupted)
    if run.unproved and code is ExitCode.PASSED and not options.allow_undecided:
        code = ExitCode.UNDECIDED
    if options.exit_zero and code in (ExitCode.FAILED, ExitCode.UNDECIDED):
        code = ExitCode.PASSED
    done = printed and written and not run.unwritten
    return code if done or run.interrupted else ExitCode.ERROR
