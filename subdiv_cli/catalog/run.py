"""The run over many masks: every target gives its results, a bad one its problems, and the rest goes on."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from subdiv_cli.catalog.discovery import discover
from subdiv_cli.catalog.files import CertificateDirectory
from subdiv_cli.catalog.ordered import Numbered, Order, in_order
from subdiv_cli.catalog.task import Done, Settings, Task, invalid, perform
from subdiv_cli.kinds.reading import load_path
from subdiv_cli.maskfile import MaskFile, MaskFileError
from subdiv_cli.model import DEFAULT_EFFORT, Expectation, Problem, Result

FEWEST = 4
"""The fewest masks for each process that make it worth starting it."""


def _ignore(*_: object) -> None:
    """A callback that does nothing."""


def check_all(
    targets: Sequence[str | MaskFile],
    *,
    overrides: Mapping[str, Fraction] | None = None,
    work: int = DEFAULT_EFFORT,
    seconds: float | None = None,
    debug: bool = False,
    exclude: Sequence[str] = (),
    on_skipped: Callable[[int, int], None] = _ignore,
    certificates: str | None = None,
    required: Sequence[Expectation] = (),
    cache: str | None = None,
    jobs: int = 1,
    cluster: str | None = None,
    shard: tuple[int, int] | None = None,
    sections: bool = False,
    on_total: Callable[[int], None] = _ignore,
    on_done: Callable[[Done], None] = _ignore,
) -> Iterator[Result]:
    """The results of all targets, in the order of the targets, each as soon as those before it are done.

    `work` and `seconds` are the effort for each question and the time for each mask; `required` is what every mask is
    held to beside its own expectations. `certificates` is a directory for the proofs, made where it is missing;
    `cache` one for results. `jobs` processes work here, or those of the Dask scheduler `cluster`; `shard` (i, n) takes
    every n-th mask from the i-th on. With `sections` the results have their stencils and pictures. `exclude` are
    patterns for what a search of directories leaves out. `on_skipped` hears how many TOML files of the directories are
    no masks, and how many files and directories were left out; `on_total` how many masks there are, `on_done` of each
    when it is done, in whatever order.

    Nothing is raised for bad input: its result is `invalid` and holds the problems. An internal error is one too
    (SD099), unless `debug` lets it through. On Ctrl-C what is done comes, then KeyboardInterrupt. Raises OSError where
    a certificate cannot be written, ClusterError where the cluster cannot be used.
    """
    directory = None if certificates is None else CertificateDirectory(certificates)
    settings = Settings(
        overrides=dict(overrides or {}),
        work=work,
        seconds=seconds,
        debug=debug,
        required=tuple(required),
        certificates=directory is not None,
        cache=cache,
        sections=sections,
    )
    found = discover((target for target in targets if isinstance(target, str)), exclude)
    on_skipped(found.skipped, found.left_out)
    entries = [*found.entries, *(target for target in targets if isinstance(target, MaskFile))]
    if shard is not None:
        entries = entries[shard[0] - 1 :: shard[1]]
    on_total(len(entries))
    for done in _run(entries, settings, jobs, cluster, on_done):
        result = replace(done.result, seconds=done.seconds)
        if directory is not None and done.certificate is not None:
            result = replace(result, certificate=directory.write(result.file, done.certificate))
        yield result


def _run(
    entries: Sequence[str | Problem | MaskFile],
    settings: Settings,
    jobs: int,
    cluster: str | None,
    on_done: Callable[[Done], None],
) -> Iterator[Done]:
    """The results, computed here, in other processes or on a cluster; always in the order of the entries."""
    made = [(number, _task(entry)) for number, entry in enumerate(entries)]
    tasks = [(number, task) for number, task in made if isinstance(task, Task)]

    def stream(order: Order) -> Iterator[tuple[int, Done]]:
        yield from ((number, done) for number, done in made if isinstance(done, Done))
        yield from _stream(tasks, settings, jobs, cluster)(order)

    return in_order(stream, on_done)


def _task(entry: str | Problem | MaskFile) -> Task | Done:
    """The task of an entry, or its result if there is nothing to do; standard input is read here."""
    if isinstance(entry, Problem):
        return Done(invalid(entry.file or "", (entry,)))
    if isinstance(entry, MaskFile):
        return Task(entry.file, mask=entry)
    if entry != "-":
        return Task(entry)
    try:
        return Task(entry, data=load_path(entry))
    except MaskFileError as error:
        return Done(invalid(entry, error.problems))


def _stream(
    tasks: Numbered, settings: Settings, jobs: int, cluster: str | None
) -> Callable[[Order], Iterator[tuple[int, Done]]]:
    if cluster is not None:
        from subdiv_cli.catalog.cluster import Cluster

        return Cluster(cluster, tasks, settings).stream
    jobs = min(jobs, max(1, len(tasks) // FEWEST))
    bounded = settings.seconds is not None  # a step that looks at no clock can only be ended from outside
    if (jobs > 1 or bounded) and tasks and not settings.debug:
        from subdiv_cli.catalog.pool import Pool

        return Pool(tasks, settings, jobs).stream
    return lambda _: ((number, perform(task, settings)) for number, task in tasks)
