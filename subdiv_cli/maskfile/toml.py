"""TOML text -> plain data through tomllib, and its failures as problems with positions."""

from __future__ import annotations

import re
import tomllib

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_NESTING
from subdiv_cli.maskfile.problems import Fault, MaskFileError, Source, shown_path
from subdiv_cli.maskfile.values import Decimal
from subdiv_cli.model import Problem


def load(source: Source) -> dict[str, object]:
    """The document as plain data; floats stay `Decimal`. Raises MaskFileError: SD001, SD003, SD010 or SD015."""
    text = source.text
    if text.count(".") > MAX_NESTING and any(line.count(".") > MAX_NESTING for line in text.split("\n")):
        _refuse_deep_keys(source)  # tomllib takes quadratic time for a.a.a.a.…
    try:
        return tomllib.loads(text, parse_float=Decimal)
    except RecursionError:
        error: Exception = ValueError(f"values are nested more than {MAX_NESTING} deep")
    except ValueError as failure:
        error = failure
    raise MaskFileError(_problems(source, error))


def _refuse_deep_keys(source: Source) -> None:
    """Raises MaskFileError for nesting beyond the bound, a dotted key's too."""
    from subdiv_cli.maskfile.positions import Positions

    positions = Positions(source)
    fault = positions.scan.stuck
    if fault is not None and fault.rule is faults.OUT_OF_BOUNDS:
        raise MaskFileError([positions.at(fault.at, fault, shown_path(positions.scan.where) or None)])


def _problems(source: Source, error: Exception) -> list[Problem]:
    """Every repeated key, and the first place where the text cannot be read on; in the order of the file."""
    from subdiv_cli.maskfile.positions import Positions, line_and_column

    positions = Positions(source)
    problems = []
    for path, offset in positions.scan.duplicates:
        line = line_and_column(source.text, positions.scan.spots[path].key)[0]
        key = shown_path(path)
        fault = Fault(faults.DUPLICATE_KEY, f"{key} is given twice, first on line {line}")
        problems.append(positions.at(offset, fault, key))
    stuck = positions.scan.stuck
    if stuck is not None:
        problems.append(positions.at(stuck.at, stuck, shown_path(positions.scan.where) or None))
    elif not problems:
        problems.append(_as_tomllib_says(source, error))
    return problems


def _as_tomllib_says(source: Source, error: Exception) -> Problem:
    """The problem in tomllib's own words, where the scanner had nothing to object."""
    message = str(error)
    where = re.search(r" \(at (?:line (\d+), column (\d+)|end of document)\)$", message)
    line = column = text = None
    if where:
        message = message[: where.start()]
        lines = source.text.split("\n")
        line, column = (int(where[1]), int(where[2])) if where[1] else (len(lines), len(lines[-1]) + 1)
        text = lines[line - 1].rstrip("\r")
    if not isinstance(error, tomllib.TOMLDecodeError):
        rule, message = faults.OUT_OF_BOUNDS, message.partition(";")[0]
    else:
        rule = faults.DUPLICATE_KEY if re.match("Cannot|Duplicate", message) else faults.TOML_SYNTAX
    return rule.problem(
        f"this is not valid TOML: {message[:1].lower()}{message[1:]}",
        "compare with https://toml.io/en/v1.0.0",
        file=source.file,
        line=line,
        column=column,
        source=text,
    )
