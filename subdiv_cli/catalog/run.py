"""Many masks through the pipeline: every target gives its results, a bad one its problems, and the rest goes on."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from subdiv_cli.catalog.discovery import discover
from subdiv_cli.catalog.files import CertificateDirectory
from subdiv_cli.maskfile import MaskFile, MaskFileError, read_path
from subdiv_cli.model import DEFAULT_EFFORT, Effort, Problem, Result


def check_all(
    targets: Sequence[str | MaskFile],
    *,
    overrides: Mapping[str, Fraction] | None = None,
    work: int = DEFAULT_EFFORT,
    seconds: float | None = None,
    debug: bool = False,
    on_skipped: Callable[[int], None] = lambda _: None,
    certificates: str | None = None,
) -> Iterator[Result]:
    """One result for each mask of the targets, in their order; the masks of a directory in the order of their paths.

    `work` and `seconds` are the effort for each question and the time for each mask; `on_skipped` hears how many TOML
    files of the directories are no masks; `certificates` is a directory for the proofs, made where it is missing.
    Nothing is raised for bad input: its result is `invalid` and holds the problems. An internal error is one too
    (SD099), unless `debug` lets it through. Raises OSError where a certificate cannot be written.
    """
    directory = None if certificates is None else CertificateDirectory(certificates)
    found = discover(target for target in targets if isinstance(target, str))
    on_skipped(found.skipped)
    for entry in (*found.entries, *(target for target in targets if isinstance(target, MaskFile))):
        if isinstance(entry, Problem):
            yield _invalid(entry.file or "", (entry,))
            continue
        try:
            mask = entry if isinstance(entry, MaskFile) else read_path(entry)
        except MaskFileError as error:
            yield _invalid(str(entry), error.problems)
            continue
        yield _check(mask, overrides or {}, Effort(work, seconds), debug, directory)


def _check(
    mask: MaskFile,
    overrides: Mapping[str, Fraction],
    effort: Effort,
    debug: bool,
    certificates: CertificateDirectory | None,
) -> Result:
    from subdiv_cli.pipeline import check  # flint comes with it: a file with errors never loads it

    try:
        parameters, scheme = mask.values(overrides), mask.scheme(overrides)
        checked = check(scheme, mask.expectations, effort)
    except MaskFileError as error:
        return replace(_invalid(mask.file, error.problems), name=mask.name, kind=mask.kind)
    except Exception as error:
        if debug:
            raise
        return _invalid(mask.file, (_internal(mask.file, error),))
    text = checked.certificate_text() if certificates is not None else None
    return replace(
        checked.result,
        file=mask.file,
        name=mask.name,
        kind=mask.kind,
        reference=mask.reference,
        parameters=parameters,
        certificate=certificates.write(mask.file, text) if certificates is not None and text is not None else None,
    )


def _invalid(file: str, problems: tuple[Problem, ...]) -> Result:
    return Result(file=file, status="invalid", problems=problems)


def _internal(file: str, error: Exception) -> Problem:
    return Problem(
        code="SD099",
        message=f"internal error: {type(error).__name__}: {error}",
        help="this is a fault of subdiv and not of the mask: please report it with the mask file and `--debug`",
        file=file,
    )
