"""The task of one mask, from its file to its result, which a run repeats, here or in another process.

Nothing is raised for bad input: its result is `invalid` and holds the problems.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from subdiv_cli.catalog.cache import Cache, Entry, key
from subdiv_cli.kinds import kind_of
from subdiv_cli.kinds.reading import load_path, read_bytes
from subdiv_cli.maskfile import MaskFile, MaskFileError
from subdiv_cli.maskfile.option import Given
from subdiv_cli.maskfile.problems import internal_error
from subdiv_cli.model import DEFAULT_EFFORT, Effort, Expectation, Judgement, Problem, Result, Verdict

if TYPE_CHECKING:
    from subdiv_cli.kinds.kind import Scheme
    from subdiv_cli.model.blocks import Section


class Settings(NamedTuple):
    """The settings that are the same for all masks of a run."""

    work: int = DEFAULT_EFFORT
    seconds: float | None = None
    debug: bool = False
    required: tuple[Expectation, ...] = ()
    """The expectations of every mask besides its own."""
    certificates: bool = False
    """Whether the texts of the certificates are returned."""
    cache: str | None = None
    """The directory of the cache."""
    sections: bool = False
    """Whether stencils and pictures are returned."""
    given: Given = Given()
    """The command line's words on a list on standard input."""


class Task(NamedTuple):
    """A mask to be checked: a file, its bytes where they are already read, or a mask that is no file."""

    file: str
    data: bytes | None = None
    mask: MaskFile | None = None
    overrides: Mapping[str, Fraction] = {}
    """The values of parameters that stand above the defaults."""
    varied: tuple[str, ...] = ()
    """The parameters among them that other tasks of this file have at other values."""


class Done(NamedTuple):
    """The result of a task, with its certificate and its time."""

    result: Result
    certificate: str | None = None
    seconds: float = 0.0
    cached: bool = False
    trouble: str | None = None
    """The reason why the cache could not be written."""


def perform(task: Task, settings: Settings) -> Done:
    """The result of one mask. Raises nothing, but where `debug` is set what an internal error is."""
    start = time.perf_counter()
    try:
        done = _perform(task, settings)
    except MaskFileError as error:
        done = Done(invalid(task.file, error.problems))
    except Exception as error:
        if settings.debug:
            raise
        done = Done(invalid(task.file, (internal_error(error, file=task.file),)))
    return done._replace(seconds=time.perf_counter() - start)


def _perform(task: Task, settings: Settings) -> Done:
    data = load_path(task.file) if task.data is None and task.mask is None else task.data
    mask = task.mask if task.mask is not None else read_bytes(data or b"", file=task.file, given=settings.given)
    try:
        parameters, scheme = mask.values(task.overrides), mask.scheme(task.overrides)
    except MaskFileError as error:
        named = replace(invalid(mask.file, error.problems), name=mask.name, kind=mask.kind)
        return Done(replace(named, parameters=task.overrides, varied=task.varied))
    expectations = (*mask.expectations, *settings.required)
    name = None
    if data is not None and mask.source.toml:
        name = key(data, task.overrides, settings.work, settings.required)
    done = _kept(name, scheme, expectations, settings)
    result = done.result
    return done._replace(
        result=replace(
            mask.labelled(result, parameters),
            varied=task.varied,
            expectations=tuple(_placed(judged, mask) for judged in result.expectations),
            sections=_sections(scheme, result) if settings.sections else (),
        ),
        certificate=done.certificate if settings.certificates else None,
    )


def _sections(scheme: Scheme, result: Result) -> tuple[Section, ...]:
    """The sections that the kind of the scheme makes, if it makes some."""
    make = kind_of(scheme).sections
    return () if make is None else make(scheme, result)


def _kept(name: str | None, scheme: Any, expectations: tuple[Expectation, ...], settings: Settings) -> Done:
    """The result of that name from the cache if it is there; else it is computed, and written to the cache."""
    if settings.cache is None or name is None:
        return _computed(scheme, expectations, settings)
    from subdiv_cli.catalog.trust import every_verdict_has_a_claim, trusted

    cache = Cache(settings.cache)
    entry = cache.find(name)
    if entry is not None and trusted(entry.result, entry.certificate, scheme, expectations):
        return Done(entry.result, entry.certificate, cached=True)
    done = _computed(scheme, expectations, settings)
    if done.certificate is None or done.result.stopped or not every_verdict_has_a_claim(done.result):
        return done
    try:
        cache.keep(name, Entry(done.result, done.certificate))
    except OSError as error:
        return done._replace(trouble=error.strerror or type(error).__name__)
    return done


def _computed(scheme: Any, expectations: tuple[Expectation, ...], settings: Settings) -> Done:
    from subdiv_cli.pipeline import check  # flint comes with it: neither an invalid file nor a cached one loads it

    checked = check(scheme, expectations, Effort(settings.work, settings.seconds))
    wanted = settings.certificates or settings.cache is not None
    return Done(checked.result, checked.certificate_text() if wanted else None)


def _placed(judged: Judgement, mask: MaskFile) -> Judgement:
    """The judgement with the line where it is stated, unless it is proved."""
    if judged.verdict is Verdict.PROVED or judged.expectation not in mask.expectations:
        return judged
    return judged._replace(line=mask.line_of("expect", judged.expectation.key))


def invalid(file: str, problems: tuple[Problem, ...]) -> Result:
    """The result of a mask that could not be checked, with the problems."""
    return Result(file=file, status="invalid", problems=problems)
