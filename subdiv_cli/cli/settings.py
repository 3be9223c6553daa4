"""The table `[tool.subdiv]` in pyproject.toml: defaults for `check`, beneath environment and command line.

The nearest pyproject.toml that has the table counts, and it alone: from the directory that all named targets have in
common upwards.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import click
from click.core import ParameterSource

from subdiv_cli.model import Problem

MOST_BYTES = 4 << 20
_PATHS = ("baseline", "cache-dir", "paths", "exclude")
"""The keys whose values are relative to the directory of the file, patterns only where they have a slash."""


class Key(NamedTuple):
    """A key of the table: the option it is a default for, the types its value may have, and how to write it."""

    parameter: str
    types: tuple[type, ...]
    help: str


KEYS = {
    "paths": Key("targets", (list,), 'write paths = ["masks"]'),
    "exclude": Key("exclude", (list,), 'write exclude = ["drafts", "masks/**/*_old.toml"]'),
    "format": Key("form", (str,), 'write format = "concise"'),
    "select": Key("select", (list,), 'write select = ["SD3"]'),
    "ignore": Key("ignore", (list,), 'write ignore = ["SD301"]'),
    "require": Key("require", (list,), 'write require = ["C1", "holder>=1.5"]'),
    "baseline": Key("baseline", (str,), 'write baseline = "report.json"'),
    "allow-undecided": Key("allow_undecided", (bool,), "write allow-undecided = true"),
    "effort": Key("effort", (int,), "write effort = 20000"),
    "budget": Key("budget", (int, float), "write budget = 10"),
    "jobs": Key("jobs", (int, str), 'write jobs = 2 or jobs = "auto"'),
    "cache": Key("no_cache", (bool,), "write cache = false"),
    "cache-dir": Key("cache_dir", (str,), 'write cache-dir = ".subdiv_cache"'),
    "dask": Key("dask", (str,), 'write dask = "tcp://scheduler:8786"'),
}


class SettingsError(Exception):
    """Raised for a table that cannot be used; `problem` says why."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem.message)
        self.problem = problem


def with_settings(ctx: click.Context, given: Mapping[str, Any]) -> dict[str, Any]:
    """The parameters of a command, those from the table that neither command line nor environment gives.

    Raises SettingsError.
    """
    values = dict(given)
    settings = find(given["targets"])
    if settings is None:
        return values
    file, text, table = settings
    parameters = {parameter.name: parameter for parameter in ctx.command.params}
    for key, value in table.items():
        converted = _checked(file, text, key, value)
        name = KEYS[key].parameter
        if ctx.get_parameter_source(name) is not ParameterSource.DEFAULT or (key == "paths" and _names_masks(given)):
            continue
        try:
            values[name] = parameters[name].process_value(ctx, converted)
        except click.BadParameter as error:
            raise _wrong_key(file, text, key, error.message, KEYS[key].help) from None
    return values


def _names_masks(given: Mapping[str, Any]) -> bool:
    """Whether the command line names masks by other means than files."""
    return given["mask"] is not None or given["files_from"] is not None


def find(targets: Sequence[str]) -> tuple[Path, str, Mapping[str, Any]] | None:
    """The nearest pyproject.toml with the table: the file, its text, the table. Raises SettingsError."""
    for directory in _upwards(targets):
        file = directory / "pyproject.toml"
        try:
            with file.open("rb") as stream:
                data = stream.read(MOST_BYTES)
        except (OSError, ValueError):
            continue
        if b"subdiv" not in data:
            continue
        if (table := _table(file, data)) is not None:
            return file, data.decode("utf-8"), table
    return None


def _upwards(targets: Sequence[str]) -> Iterator[Path]:
    here = Path.cwd()
    try:
        named = [Path(os.path.abspath(target)) for target in targets if target != "-"]  # noqa: PTH100 (links stay)
        start = Path(os.path.commonpath([p if p.is_dir() else p.parent for p in named])) if named else here
    except (OSError, ValueError):  # a null character, or two drives
        start = here
    yield from (start, *start.parents)


def _table(file: Path, data: bytes) -> Mapping[str, Any] | None:
    from tomllib import TOMLDecodeError, loads

    from subdiv_cli.maskfile import rules as faults

    try:
        document = loads(data.decode("utf-8"))
    except (TOMLDecodeError, UnicodeDecodeError, RecursionError, ValueError) as error:
        raise SettingsError(faults.SETTINGS.problem(f"not valid TOML: {error}"[:200], file=str(file))) from None
    tool = document.get("tool")
    table = tool.get("subdiv") if isinstance(tool, dict) else None
    if table is None or isinstance(table, dict):
        return table
    raise SettingsError(faults.SETTINGS.problem("tool.subdiv must be a table", file=str(file), key="tool.subdiv"))


def _checked(file: Path, text: str, key: str, value: object) -> Any:
    """The value as the option takes it."""
    known = KEYS.get(key)
    if known is None:
        from subdiv_cli.maskfile.problems import near

        guess = near(key, KEYS)
        help = f"did you mean {guess}?" if guess else f"there are: {', '.join(KEYS)}"
        raise _wrong_key(file, text, key, f'there is no setting "{key[:40]}"', help)
    if not isinstance(value, known.types) or (isinstance(value, bool) and bool not in known.types):
        raise _wrong_key(file, text, key, f"{key} cannot be {type(value).__name__}", known.help)
    if isinstance(value, list):
        if not all(isinstance(item, str) for item in value):
            raise _wrong_key(file, text, key, f"{key} must be a list of strings", known.help)
        return tuple(_placed(file, key, item) for item in value)
    if key == "cache":
        return not value
    return _placed(file, key, value)


def _placed(file: Path, key: str, value: Any) -> Any:
    """The value, from the working directory where it is a path."""
    if key not in _PATHS or (key == "exclude" and "/" not in value.rstrip("/")):
        return value
    place = str(file.parent / value)
    return place if key != "paths" else os.path.relpath(place)


def _wrong_key(file: Path, text: str, key: str, message: str, help: str) -> SettingsError:
    """The error of a key of the table, at the place where it stands."""
    from subdiv_cli.maskfile import rules as faults
    from subdiv_cli.maskfile.positions import line_and_column, scan

    spot = scan(text).spots.get(("tool", "subdiv", key))
    line, column, source = (None, None, None) if spot is None else line_and_column(text, spot.key)
    where = f"tool.subdiv.{key[:40]}"
    return SettingsError(
        faults.SETTINGS.problem(message, help, file=str(file), key=where, line=line, column=column, source=source)
    )
