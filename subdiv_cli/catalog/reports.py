"""JSON reports read again: baselines, and the parts of a run that are to be joined."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from subdiv_cli.catalog.json_reader import JsonReader
from subdiv_cli.catalog.spool import Mapped, Spool
from subdiv_cli.kinds import KINDS, kind_named
from subdiv_cli.maskfile import MaskFileError
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.closed import read_closed_form
from subdiv_cli.maskfile.option import parse_expectation
from subdiv_cli.maskfile.problems import Fault, unreadable
from subdiv_cli.maskfile.properties import TRUTHS
from subdiv_cli.model import (
    INFINITY,
    ClosedForm,
    Expectation,
    Exponent,
    Finding,
    Interval,
    Judgement,
    Problem,
    Result,
    Rule,
    Smoothness,
    Verdict,
)

T = TypeVar("T")

_NEEDED = (
    "file", "status", "convergent", "smoothness", "holder", "sobolev", "stable", "linearly_independent", "generation",
    "reproduction", "sum_rule_order", "expectations", "findings", "errors",
)  # fmt: skip


class ReportError(Exception):
    """Raised for a file that is no report; `problem` says why."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem.message)
        self.problem = problem


class Report(NamedTuple):
    """A report as JSON data."""

    file: str
    results: Sequence[Mapping[str, Any]]
    shard: tuple[int, int] | None = None
    missing: tuple[str, ...] = ()
    interrupted: bool = False


def read_report(file: str) -> Report:
    """The report in a JSON file. Raises ReportError: SD002 for a file that cannot be read, SD020 for no report."""
    try:
        with Path(file).open("rb") as stream:
            data = _read(JsonReader(stream))
    except OSError as error:
        raise ReportError(unreadable(file, error)) from None
    except (ValueError, RecursionError):
        raise _no_report(file, "it is not JSON") from None
    if not isinstance(data, dict) or data.get("format") != "subdiv-report":
        raise _no_report(file, "its format is not subdiv-report")
    if data.get("version") != 1:
        raise _no_report(file, f"this version of subdiv reads version 1, not {str(data.get('version'))[:20]}")
    try:
        results = data["results"]
        for result in results:
            for key in _NEEDED:
                result[key]
            if result["status"] != "invalid":
                _result(result)
        shard = (int(data["shard"]["index"]), int(data["shard"]["count"])) if "shard" in data else None
        missing = tuple(map(str, data.get("missing", ())))
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise _no_report(file, f"something is missing or of the wrong kind: {error}"[:120]) from None
    return Report(file, results, shard, missing, bool(data.get("interrupted", False)))


def _read(reader: JsonReader) -> Any:
    """The JSON of a file, the list of its results spooled. Raises ValueError."""
    if reader.next() != "{":
        return reader.value()
    data: dict[str, Any] = {}
    for key in reader.members():
        if key == "results" and reader.next() == "[":
            data[key] = _spooled(reader.elements())
        else:
            data[key] = reader.value()
    reader.end()
    return data


def _spooled(values: Iterable[T]) -> Spool[T]:
    spool = Spool[T]()
    for value in values:
        spool.append(value)
    return spool


def _no_report(file: str, why: str) -> ReportError:
    return ReportError(faults.NO_REPORT.problem(f"no JSON report: {why}", file=file))


def join(reports: Sequence[Report]) -> tuple[Sequence[Mapping[str, Any]], tuple[int, int] | None]:
    """All results, and the part of a run that they are, None for a whole run.

    The parts of one run are put back into its order; other reports follow one another. A mask that stands in several
    with the same result is there once. Raises ValueError where parts are missing or come twice, or two results of
    one mask differ.
    """

    def result_at(place: tuple[Report, int]) -> Mapping[str, Any]:
        report, number = place
        return report.results[number]

    joined: dict[tuple[Any, ...], tuple[Report, int]] = {}
    for place in _places(reports):
        result = result_at(place)
        key = (result["file"], *sorted(result.get("parameters", {}).items()))
        if (first := joined.setdefault(key, place)) is not place and result_at(first) != result:
            raise ValueError(f"two results for {result['file']} differ")
    return Mapped(result_at, list(joined.values())), reports[0].shard if len(reports) == 1 else None


def _places(reports: Sequence[Report]) -> list[tuple[Report, int]]:
    """The report and the number there of each result; of parts of one run in its order: k is in part k mod n."""
    counts = {report.shard[1] for report in reports if report.shard is not None}
    if not counts or len(reports) == 1:
        return [(report, number) for report in reports for number in range(len(report.results))]
    if len(counts) > 1 or any(report.shard is None for report in reports):
        raise ValueError("these are not the parts of one run")
    (count,) = counts
    parts = {report.shard[0]: report for report in reports if report.shard is not None}
    if len(parts) < len(reports):
        raise ValueError("a part comes twice")
    if absent := [str(i) for i in range(1, count + 1) if i not in parts]:
        raise ValueError(f"of {count} parts, missing: {', '.join(absent[:20])}")
    longest = max(len(report.results) for report in reports)
    numbers = range(1, count + 1)
    return [(parts[i], k) for k in range(longest) for i in numbers if k < len(parts[i].results)]


_SKIPPED = {"verdict": Verdict.SKIPPED.value}
"""The answer to a question that an older report does not have."""


def results_of(data: Iterable[Mapping[str, Any]]) -> Sequence[Result]:
    """The results, as far as a report has them, for other formats. Raises KeyError, TypeError or ValueError."""
    return _spooled(map(_result, data))


def _result(data: Mapping[str, Any]) -> Result:
    rules = kind_named(data["kind"]).rules() if data.get("kind") in KINDS else {}
    return Result(
        file=data["file"],
        status=data["status"],
        name=data.get("name"),
        kind=data.get("kind"),
        parameters={name: Fraction(value) for name, value in data.get("parameters", {}).items()},
        reference=data.get("reference"),
        stopped=data.get("stopped"),
        problems=tuple(_problem(error, data["file"]) for error in data["errors"]),
        facts=_data(data.get("facts", {})),
        hints=tuple(data.get("hints", ())),
        sum_rule_order=data["sum_rule_order"],
        convergent=Verdict(data["convergent"]["verdict"]),
        smoothness=_smoothness(data["smoothness"]),
        refinable=_smoothness(data.get("refinable_function", data["smoothness"])),
        holder=_exponent(data["holder"]),
        sobolev=_exponent(data["sobolev"]),
        stable=Verdict(data["stable"]["verdict"]),
        linearly_independent=Verdict(data["linearly_independent"]["verdict"]),
        generation=data["generation"],
        reproduction=data["reproduction"],
        dimension=data.get("dimension"),
        well_defined=Verdict(data.get("well_defined", _SKIPPED)["verdict"]),
        polynomials=data.get("polynomials"),
        spectral=Verdict(data.get("spectral", _SKIPPED)["verdict"]),
        derivatives=None if data.get("derivatives") is None else len(data["derivatives"]),
        holder_at_zero=_exponent(data.get("holder_at_zero")),
        expectations=tuple(_judgement(judged) for judged in data["expectations"]),
        findings=tuple(_finding(finding, rules) for finding in data["findings"]),
        certificate=data.get("certificate"),
        regressions=_regressions(data),
    )


def _problem(data: Mapping[str, Any], file: str) -> Problem:
    return Problem(
        code=data["code"], message=data["message"], help=data.get("help"), file=file, key=data.get("key"),
        line=data.get("line"), column=data.get("column"),
    )  # fmt: skip


def _regressions(data: Mapping[str, Any]) -> tuple[Problem, ...] | None:
    """The regressions from a baseline, of which a report has the messages alone. None where there was no baseline."""
    messages = data.get("regressions")
    if messages is None:
        return None
    return tuple(faults.BASELINE.problem(message, file=data["file"]) for message in messages)


def _smoothness(data: Mapping[str, Any]) -> Smoothness:
    return Smoothness(order=INFINITY if data["order"] == "infinity" else data["order"], sharp=data["sharp"])


def _exponent(data: Mapping[str, Any] | None) -> Exponent | None:
    if data is None:
        return None
    exact, figures = _closed(data["exact"]), (data.get("digits"), data.get("estimate"))
    return Exponent(data["lower"], data["upper"], exact, data.get("attained"), *figures)


def _closed(text: str | None) -> ClosedForm | None:
    """The closed form of a text in the reports' grammar; None for another, which stays an enclosure."""
    if text is None or text == "infinity":
        return None if text is None else INFINITY
    try:
        return read_closed_form(text)
    except Fault:
        return None


def _judgement(data: Mapping[str, Any]) -> Judgement:
    key, text = data["key"], data["expected"]
    try:
        expectation = parse_expectation(key, text == "true" if key in TRUTHS else text)
    except MaskFileError:
        expectation = Expectation(key=key, text=text, lower=False)
    return Judgement(expectation, Verdict(data["verdict"]), data.get("line"))


def _finding(data: Mapping[str, Any], rules: Mapping[str, Rule[Any]]) -> Finding:
    """A finding; its rule has the questions that it answers, and the answers stand in the result."""
    value, rule = data.get("value"), rules.get(data["code"])
    return Finding(
        code=data["code"], name=data["name"], verdict=Verdict(data["verdict"]), statement=data["statement"],
        source=data["source"], reason=data.get("reason"), why=data.get("why"),
        answers=tuple((question, None) for question in (rule.answers if rule is not None else ())),
        value=None if value is None else Interval(value["lower"], value["upper"], value["exact"]),
        witness=_data(data.get("witness", {})), claims=tuple(data.get("claims", ())),
    )  # fmt: skip


def _data(value: Any) -> Any:
    """Plain data with tuples for lists, as in witnesses; fractions stay the strings that they are printed as."""
    if isinstance(value, list):
        return tuple(map(_data, value))
    return {key: _data(item) for key, item in value.items()} if isinstance(value, dict) else value
