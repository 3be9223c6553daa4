"""The options of `check`, in the sections in which its help shows them, and those that other commands share."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, TypeVar

import click

from subdiv_cli.cli.completers import complete_code, complete_parameter, complete_property
from subdiv_cli.cli.outputs import Output, OutputType
from subdiv_cli.cli.values import INDEX, JOBS, SECONDS, SHARD, WHOLE
from subdiv_cli.model import DEFAULT_EFFORT
from subdiv_cli.report import FORMATS

F = TypeVar("F", bound=Callable[..., Any])


class CheckOptions(NamedTuple):
    """The options of the command line, under their names."""

    targets: tuple[str, ...]
    parameters: tuple[str, ...]
    files_from: str | None
    exclude: tuple[str, ...]
    mask: str | None
    start: tuple[int, ...] | None
    arity: int | None
    form: str
    outputs: tuple[Output, ...]
    verbose: int
    quiet: bool
    select: tuple[str, ...]
    ignore: tuple[str, ...]
    statistics: bool
    certificates: str | None
    require: tuple[str, ...]
    baseline: str | None
    allow_undecided: bool
    exit_zero: bool
    maxfail: int | None
    effort: int
    budget: float | None
    jobs: int
    shard: tuple[int, int] | None
    dask: str | None
    no_cache: bool
    cache_dir: str | None
    debug: bool

    @property
    def verbosity(self) -> int:
        """The verbosity: -1 for -q, else how often -v is given."""
        return -1 if self.quiet else self.verbose


class Option(click.Option):
    """An option that knows the section of the help it belongs to."""

    def __init__(self, *args: Any, section: str, **attributes: Any) -> None:
        super().__init__(*args, **attributes)
        self.section = section


class SectionedCommand(click.Command):
    """A command whose help has its options in sections."""

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the options of each section."""
        sections: dict[str, list[tuple[str, str]]] = {}
        for parameter in self.get_params(ctx):
            if isinstance(parameter, click.Option) and (record := parameter.get_help_record(ctx)) is not None:
                sections.setdefault(getattr(parameter, "section", "Other options"), []).append(record)
        for section, records in sections.items():
            with formatter.section(section):
                formatter.write_dl(records)


def option(section: str, *names: str, **attributes: Any) -> Callable[[F], F]:
    """A decorator for an option in a section; with `variable` as an environment variable, shown in the help."""
    variable = attributes.pop("variable", None)
    more = {} if variable is None else {"envvar": f"SUBDIV_{variable}", "show_envvar": True}
    return click.option(*names, cls=Option, section=section, **attributes, **more)


def all_of(*decorators: Callable[[F], F]) -> Callable[[F], F]:
    """A decorator for several options, in the order in which the help shows them."""

    def decorate(f: F) -> F:
        for decorator in reversed(decorators):
            f = decorator(f)
        return f

    return decorate


def parameter(help: str) -> Callable[[F], F]:
    """A decorator for the option -p NAME=VALUE."""
    return option(
        "Masks", "-p", "--parameter", "parameters", multiple=True, metavar="NAME=VALUE",
        shell_complete=complete_parameter, help=help,
    )  # fmt: skip


def effort(help: str, **more: Any) -> Callable[[F], F]:
    """A decorator for the option --effort N."""
    return option(
        "Run", "--effort", type=WHOLE, default=DEFAULT_EFFORT, show_default=True, metavar="N", help=help, **more
    )


debug = option("Run", "--debug", is_flag=True, help="Show the traceback of an internal error.")
outputs = option(
    "Report", "-o", "--output", "outputs", type=OutputType(), multiple=True, metavar="[FORMAT:]FILE",
    help="Write the report to FILE as well, whole or not at all; FORMAT is told by the suffix (.json, .jsonl, .xml, "
    ".sarif, .md, .html), else it is --format. Repeatable.",
)  # fmt: skip
jobs = option(
    "Run", "-j", "--jobs", type=JOBS, default="auto", show_default=True, metavar="N", variable="JOBS",
    help="Processes to work in; auto is one for each core, few for few masks.",
)  # fmt: skip
kept = all_of(
    option("Run", "--no-cache", is_flag=True, variable="NO_CACHE", help="Neither use nor keep earlier results."),
    option(
        "Run", "--cache-dir", metavar="DIR", type=click.Path(file_okay=False), variable="CACHE_DIR",
        help="Keep results in DIR instead of the user's cache directory.",
    ),
)  # fmt: skip
text_or_json = click.option(
    "--format", "form", type=click.Choice(["text", "json"]), default="text", show_default=True, help="Format on stdout."
)
named = all_of(
    parameter("Set a parameter of the masks that have it: w=1/20. Repeatable; several values give each combination."),
    option(
        "Masks", "--mask", metavar="MASK",
        help="Take this mask instead of a file: a list, [1, 3, 3, 1]/4, as NumPy, MATLAB, JSON or CSV print it "
        "too, or a symbol, (1+z)^3/4. Standard input, -, may have one as well.",
    ),
    option(
        "Masks", "--start", type=INDEX, metavar="INDEX",
        help="Index of the first coefficient of --mask, in several variables -1,-1; it only shifts the limit.  "
        "[default: 0]",
    ),
    option("Masks", "--arity", type=int, metavar="P", help="Arity of --mask.  [default: 2]"),
)  # fmt: skip
"""The options that name masks beside files; `belongs_to_mask` refuses those that do not go together."""


def belongs_to_mask(
    mask: str | None, start: tuple[int, ...] | None, arity: int | None, files: Sequence[str] = ()
) -> None:
    """Raise a usage error for options about a mask that is not there; standard input may have one."""
    if mask is None and "-" not in files and (start is not None or arity is not None):
        name = "--start" if start is not None else "--arity"
        raise click.UsageError(f"{name} belongs to --mask; a file says it itself, under [mask]")


check_options = all_of(
    click.argument("targets", nargs=-1, type=click.Path(), metavar="[FILE | DIR | -]..."),
    option(
        "Masks", "--files-from", metavar="FILE", type=click.Path(dir_okay=False, allow_dash=True),
        help="Read names of files and directories from FILE, one a line (or NUL between); - is stdin.",
    ),
    option(
        "Masks", "--exclude", multiple=True, metavar="PATTERN", variable="EXCLUDE",
        help='Leave out files and directories of a DIR: by name, "*_old.toml", or by path, "masks/drafts/**". '
        "Repeatable.",
    ),
    named,
    option(
        "Report", "--format", "form", type=click.Choice(list(FORMATS)), default="text", show_default=True,
        variable="FORMAT", help="Format of the report on stdout.",
    ),
    outputs,
    option("Report", "-v", "--verbose", count=True, help="Every finding with its theorem; -vv with the witnesses."),
    option("Report", "-q", "--quiet", is_flag=True, help="Show only what did not pass."),
    option(
        "Report", "--select", multiple=True, metavar="CODE", shell_complete=complete_code,
        help="Show only findings with this code, or beginning of codes: SD3. Repeatable.",
    ),
    option(
        "Report", "--ignore", multiple=True, metavar="CODE", shell_complete=complete_code,
        help="Do not show findings with this code. Neither changes the exit code. Repeatable.",
    ),
    option(
        "Report", "--statistics", is_flag=True,
        help="On stdout, instead of the report, how many masks did not pass for which reason; as text or JSON.",
    ),
    option(
        "Report", "--certificate", "certificates", metavar="DIR", type=click.Path(file_okay=False),
        help="Write the proof of each mask's verdicts into DIR, for `subdiv verify`.",
    ),
    option(
        "Gate", "--require", multiple=True, metavar="PROPERTY", shell_complete=complete_property, variable="REQUIRE",
        help='Hold every mask to this as well: C1, "holder>=1.5", stable. Repeatable.',
    ),
    option(
        "Gate", "--baseline", metavar="REPORT", type=click.Path(dir_okay=False), variable="BASELINE",
        help="A JSON report: a mask fails if a verdict is worse than there; masks that are new, by what they expect.",
    ),
    option(
        "Gate", "--allow-undecided", is_flag=True, variable="ALLOW_UNDECIDED",
        help="Undecided is not a failure: exit 0 for it.",
    ),
    option("Gate", "--exit-zero", is_flag=True, help="Exit 0 also where something is refuted or undecided."),
    option("Gate", "--maxfail", type=WHOLE, metavar="N", help="Stop after N masks that did not pass."),
    effort("Work one question may cost. What is found depends on it alone.", variable="EFFORT"),
    option(
        "Run", "--budget", type=SECONDS, metavar="SECONDS", variable="BUDGET",
        help="Stop a mask after so long, with what is decided and checked by then; results then depend on the machine. "
        "Where a step does not end, its process is killed after twice as long and 5 s more, and nothing is decided.",
    ),
    jobs,
    option(
        "Run", "--shard", type=SHARD, metavar="I/N",
        help="Check part I of N only, for a matrix of CI jobs; `subdiv merge` joins their JSON reports.",
    ),
    option(
        "Run", "--dask", metavar="ADDRESS", variable="DASK",
        help="Work on a Dask cluster, tcp://host:8786 (needs the extra dask).",
    ),
    kept,
    debug,
)  # fmt: skip
"""All options of `check`."""
