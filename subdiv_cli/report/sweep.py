"""A sweep as a table for people, as CSV and as JSON (sweep_schema.json): a row for each value of the parameter."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator
from io import StringIO
from typing import Any

import subdiv_cli
from subdiv_cli.model import INFINITY, Exponent, Interval, Problem, Smoothness, Verdict
from subdiv_cli.model.closed import spelled
from subdiv_cli.model.formulas import number, product, valued
from subdiv_cli.model.sweep import Column, Row, Sweep, changes, enclosed
from subdiv_cli.report import marks, words
from subdiv_cli.report.json import as_error, as_value, of_property, plain, valid
from subdiv_cli.report.look import Look
from subdiv_cli.report.numbers import finite, interval
from subdiv_cli.report.page import Cell, Page, paint

_MOST_ERRORS = 10
"""The most rows without a mask of which the reason stands below the table."""
_CHANGED = " *"


def table(sweep: Sweep, look: Look) -> str:
    """The rows in columns, and below them where the maximizing product changes, and where there is no mask."""
    page = Page(look)
    page.put(f"{sweep.title}: {_count(len(sweep.rows), 'value')} of {sweep.parameter}", "head")
    names_products = _names_products(sweep)
    changed = {other.value for _, other in changes(sweep.rows)}
    lines = []
    for row in sweep.rows:
        cells = [_cell(page, row, column) for column in sweep.columns]
        if names_products:
            word = "" if row.product is None else product(row.product, "T")
            cells.append(page.cell(word + _CHANGED if row.value in changed else word))
        lines.append([page.cell(number(row.value)), *cells])
    titles = [column.title for column in sweep.columns]
    page.table([sweep.parameter, *titles, *(["product"] if names_products else [])], lines)
    if changed:
        page.put(
            f"(*: the product that attains the exponent is another one than at the next smaller {sweep.parameter})"
        )
    errors = [(row.value, problem) for row in sweep.rows for problem in row.result.problems[:1]]
    for value, problem in errors[:_MOST_ERRORS]:
        page.put(f"{sweep.parameter} = {number(value)}: {_sentence(problem)}", "bad", hanging=2)
    if len(errors) > _MOST_ERRORS:
        page.put(f"… and {len(errors) - _MOST_ERRORS} more without a mask", "quiet")
    return paint(page.lines, colour=look.colour)


def _names_products(sweep: Sweep) -> bool:
    """Whether the rows have a column for products: beside Hölder exponents, where one is known."""
    wanted = any(column.name == "holder" for column in sweep.columns)
    return wanted and any(row.product is not None for row in sweep.rows)


def _cell(page: Page, row: Row, column: Column) -> Cell:
    """The cell of a column; a verdict has its colour, and a dash stands for no answer."""
    if row.result.status == "invalid":
        return page.cell("!", "bad")
    if column.about is None:
        text = valued(row.norms[column.name]) if column.name in row.norms else None
    else:
        given: Any = getattr(row.result, column.about.key)
        if isinstance(given, Verdict):
            return page.cell(marks.of_verdict(given).text, marks.of_verdict(given).role)
        if isinstance(given, Exponent):
            text = interval(given, brief=True)
        else:
            text = words.value(row.result, column.about, bare=True)
    if text is not None:
        return page.cell(text)
    return page.cell(*("?", "open") if column.name in row.undecided else ("–", "none"))


def as_csv(sweep: Sweep) -> str:
    """The rows as CSV: numbers exactly, and between doubles in columns of their own; what is unknown is empty."""
    lines = [_csv_row(sweep, row) for row in sweep.rows]
    names = list(dict.fromkeys(name for line in lines for name in line))
    text = StringIO()
    writer = csv.DictWriter(text, names, lineterminator="\n")
    writer.writeheader()
    writer.writerows(lines)
    return valid(text.getvalue())


def _csv_row(sweep: Sweep, row: Row) -> dict[str, Any]:
    """A row by the names of its columns, which are the same in all rows."""
    line = _enclosed(sweep.parameter, enclosed(row.value))
    for column in sweep.columns:
        line |= _csv_cells(row, column)
    if any(column.name == "holder" for column in sweep.columns):
        line["product"] = None if row.product is None else " ".join(map(str, row.product))
    return {**line, "error": "; ".join(dict.fromkeys(map(_sentence, row.result.problems))) or None}


def _csv_cells(row: Row, column: Column) -> dict[str, Any]:
    if column.about is None:
        known = row.norms.get(column.name)
        return _enclosed(column.name, Interval() if known is None else enclosed(known))
    given: Any = getattr(row.result, column.about.key)
    if isinstance(given, Verdict):
        return {column.name: None if row.result.status == "invalid" else given.value}
    if isinstance(given, Smoothness):
        order = "infinity" if given.order == INFINITY else given.order
        return {column.name: order, f"{column.name}_sharp": str(given.sharp).lower()}
    if column.about.form != "exponent":
        return {column.name: given}
    exponent = given or Exponent()
    exact = None if exponent.exact is None else spelled(exponent.exact)
    return _enclosed(column.name, Interval(exponent.lower, exponent.upper, exact))


def _enclosed(name: str, value: Interval) -> dict[str, Any]:
    return {name: value.exact, f"{name}_lower": finite(value.lower), f"{name}_upper": finite(value.upper)}


def as_json(sweep: Sweep) -> str:
    """The rows as JSON, version 1: keys are added, never changed."""
    report = {
        "format": "subdiv-sweep",
        "version": 1,
        "tool": {"name": "subdiv", "version": subdiv_cli.__version__},
        "file": sweep.file,
        "name": sweep.name,
        "kind": sweep.kind,
        "parameter": sweep.parameter,
        "fixed": plain(sweep.fixed),
        "columns": [column.name for column in sweep.columns],
        "rows": [dict(_json_row(sweep, row)) for row in sweep.rows],
    }
    return valid(json.dumps(report, ensure_ascii=False, indent=2, allow_nan=False)) + "\n"


def _json_row(sweep: Sweep, row: Row) -> Iterator[tuple[str, Any]]:
    yield "value", as_value(enclosed(row.value))
    for column in sweep.columns:
        if row.result.status == "invalid":
            yield column.name, None
        elif column.about is not None:
            yield column.name, of_property(row.result, column.about)
        else:
            known = row.norms.get(column.name)
            yield column.name, None if known is None else as_value(enclosed(known))
    if any(column.name == "holder" for column in sweep.columns):
        yield "product", None if row.product is None else list(row.product)
    yield "undecided", list(row.undecided)
    yield "errors", [as_error(problem) for problem in row.result.problems]


def summary(sweep: Sweep) -> str | None:
    """What keeps the rows from being complete, in a line: `2 of 9 values make no mask, 1 is undecided`; else None."""
    errors = sum(row.result.status == "invalid" for row in sweep.rows)
    undecided = sum(bool(row.undecided) for row in sweep.rows)
    parts = [f"no mask at {errors}"] if errors else []
    parts += [f"undecided at {undecided}"] if undecided else []
    return f"{' and '.join(parts)} of {_count(len(sweep.rows), 'value')}" if parts else None


def _sentence(problem: Problem) -> str:
    return f"{problem.code} {problem.message}"


def _count(count: int, noun: str) -> str:
    return f"{count} {noun}{'' if count == 1 else 's'}"
