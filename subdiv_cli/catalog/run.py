"""The run over many masks: every target gives its results, a bad one its problems, and the rest goes on."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product

from subdiv_cli.catalog.discovery import discover
from subdiv_cli.catalog.files import CertificateDirectory
from subdiv_cli.catalog.ordered import Numbered, Order, in_order
from subdiv_cli.catalog.task import Done, Settings, Task, invalid, perform
from subdiv_cli.kinds.reading import load_path, read_bytes
from subdiv_cli.maskfile import MaskFile, MaskFileError
from subdiv_cli.maskfile.mask import no_such_parameter
from subdiv_cli.maskfile.option import NOTHING_GIVEN, Given
from subdiv_cli.model import DEFAULT_EFFORT, Expectation, Problem, Result

FEWEST = 4
"""The fewest masks for each process that make it worth starting it."""


def _ignore(*_: object) -> None:
    """A callback that does nothing."""


def check_all(
    targets: Sequence[str | MaskFile],
    *,
    overrides: Mapping[str, Sequence[Fraction]] | None = None,
    given: Given = NOTHING_GIVEN,
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
    on_unwritten: Callable[[str, str], None] = _ignore,
) -> Iterator[Result]:
    """The results of all targets, in the order of the targets, each as soon as those before it are done.

    `overrides` has values of parameters, which concern the masks that have these; several values make a result for
    each combination. `given` belongs to a list on standard input.

    `work` and `seconds` are the effort for each question and the time for each mask; `required` is what every mask is
    held to beside its own expectations. `certificates` is a directory for the proofs, made where it is missing;
    `cache` one for results. `jobs` processes work here, or those of the Dask scheduler `cluster`; `shard` (i, n) takes
    every n-th mask from the i-th on. With `sections` the results have their stencils and pictures. `exclude` are
    patterns for what a search of directories leaves out. `on_skipped` hears how many TOML files of the directories are
    no masks, and how many files and directories were left out; `on_total` how many masks there are, `on_done` of each
    when it is done, in whatever order; `on_unwritten` of which file the certificate could not be written, and why.

    Nothing is raised for bad input: its result is `invalid` and holds the problems. An internal error is one too
    (SD099), unless `debug` lets it through. On Ctrl-C what is done comes, then KeyboardInterrupt. Raises OSError where
    there can be no directory for certificates, ClusterError where the cluster cannot be used.
    """
    directory = None if certificates is None else CertificateDirectory(certificates)
    settings = Settings(
        work=work,
        seconds=seconds,
        debug=debug,
        required=tuple(required),
        certificates=directory is not None,
        cache=cache,
        sections=sections,
        given=given._replace(names=tuple(overrides or ())),
    )
    discovery = discover((target for target in targets if isinstance(target, str)), exclude)
    on_skipped(discovery.skipped, discovery.left_out)
    tasks = [_task(entry) for entry in (*discovery.entries, *(each for each in targets if isinstance(each, MaskFile)))]
    if overrides:
        tasks = _varied(tasks, overrides, settings.given)
    if shard is not None:
        tasks = tasks[shard[0] - 1 :: shard[1]]
    on_total(len(tasks))
    for done in _run(tasks, settings, jobs, cluster, on_done):
        result = replace(done.result, seconds=done.seconds)
        if directory is None or done.certificate is None:
            yield result
        else:
            yield _with_certificate(result, done.certificate, directory, on_unwritten)


def _with_certificate(
    result: Result, certificate: str, directory: CertificateDirectory, on_unwritten: Callable[[str, str], None]
) -> Result:
    """The result with the file of its certificate; without, where that cannot be written."""
    try:
        return replace(result, certificate=directory.write(result, certificate))
    except OSError as error:
        on_unwritten(result.file, error.strerror or str(error))
        return result


def _run(
    made: Sequence[Task | Done],
    settings: Settings,
    jobs: int,
    cluster: str | None,
    on_done: Callable[[Done], None],
) -> Iterator[Done]:
    """The results, computed here, in other processes or on a cluster; always in the order in which they are made."""
    tasks = [(number, task) for number, task in enumerate(made) if isinstance(task, Task)]

    def stream(order: Order) -> Iterator[tuple[int, Done]]:
        yield from ((number, done) for number, done in enumerate(made) if isinstance(done, Done))
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


def _varied(
    made: Sequence[Task | Done], overrides: Mapping[str, Sequence[Fraction]], given: Given
) -> list[Task | Done]:
    """The tasks at each combination of the values of their parameters; one mask alone must have them all.

    Of several masks each takes those that it has; that none has one is a problem, which is then the only result.
    """
    known = [_parameters(task, given) if isinstance(task, Task) else None for task in made]
    alone = len(made) == 1
    there = {name for names in known for name in names or ()}
    if (
        not alone
        and any(names is not None for names in known)
        and (strange := [n for n in overrides if n not in there])
    ):
        return [Done(invalid("-p", tuple(no_such_parameter(name, there) for name in strange)))]
    variants: list[Task | Done] = []
    for task, names in zip(made, known, strict=True):
        if isinstance(task, Done):
            variants.append(task)
            continue
        taken = [name for name in overrides if alone or name in (names or ())]
        varied = tuple(name for name in taken if len(overrides[name]) > 1)
        for values in product(*(overrides[name] for name in taken)):
            variants.append(task._replace(overrides=dict(zip(taken, values, strict=True)), varied=varied))
    return variants


def _parameters(task: Task, given: Given) -> Collection[str] | None:
    """The names of the parameters of a mask; None for one that cannot be read, which its task will say."""
    try:
        mask = task.mask
        if mask is None:
            data = load_path(task.file) if task.data is None else task.data
            mask = read_bytes(data, file=task.file, given=given)
        return mask.parameters
    except MaskFileError:
        return None


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
