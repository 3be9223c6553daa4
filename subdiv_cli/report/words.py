"""The words for a result: the headline, the smoothness, the exponents, the values of properties."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from subdiv_cli.model import INFINITY, Data, Expectation, Exponent, Judgement, Result, Smoothness, Verdict
from subdiv_cli.model.closed import rational
from subdiv_cli.model.findings import CONVERGENCE, SUMS, answering
from subdiv_cli.model.properties import BY_KEY, Property
from subdiv_cli.report.numbers import LONGEST, data, interval

MARKS = {Verdict.PROVED: "✓", Verdict.REFUTED: "✗", Verdict.UNDECIDED: "?", Verdict.SKIPPED: "–"}
ROLES = {Verdict.PROVED: "good", Verdict.REFUTED: "bad", Verdict.UNDECIDED: "open", Verdict.SKIPPED: "none"}
_NO_WORSE = "nothing is worse than in the baseline"
STATUS_MARKS = {"passed": "✓", "failed": "✗", "undecided": "?", "invalid": "!"}
STATUS_ROLES = {"passed": "good", "failed": "bad", "undecided": "open", "invalid": "bad"}


def mark(verdict: Verdict) -> str:
    """A verdict as symbol and word: never colour alone."""
    return f"{MARKS[verdict]} {verdict.value}"


def name(result: Result) -> str:
    """The name of the mask, else that of its file."""
    return result.name or result.file


def convergence(result: Result) -> str:
    """The word or two on whether the scheme converges."""
    words = {Verdict.PROVED: "converges", Verdict.REFUTED: "not convergent", Verdict.UNDECIDED: "undecided"}
    return words.get(result.convergent, "not asked")


def smoothness(result: Result) -> str | None:
    """The smoothness of the limit functions as text: `C^1, not C^2`, `C^1 at least`; None without convergence.

    Convergence must be proved.
    """
    return _order(result.smoothness)


def smoothness_or_that_of_phi(result: Result) -> str | None:
    """The smoothness of the limit functions; of a divergent scheme with a smooth φ that of φ: `φ: C^1, not C^2`."""
    shown = smoothness(result)
    return shown if shown or result.refinable.order is None else f"φ: {_order(result.refinable)}"


def _order(smooth: Smoothness) -> str | None:
    if smooth.order is None or smooth.order == INFINITY:
        return None if smooth.order is None else "C^∞"
    return f"C^{smooth.order}, not C^{smooth.order + 1}" if smooth.sharp else f"C^{smooth.order} at least"


def facts(result: Result) -> list[str]:
    """The facts of a mask in words, the most telling ones: `support -3 … 3`, `symmetric about 0`, `dilation 2I`."""
    told = []
    if {"lowest", "highest"} <= result.facts.keys():
        told.append(f"support {data(result.facts['lowest'])} … {data(result.facts['highest'])}")
    for key, value in result.facts.items():
        if (phrase := _fact(key, value)) is not None:
            told.append(phrase)
    centre = result.facts.get("centre")
    return [f"{phrase} about {data(centre)}" if phrase.endswith("symmetric") else phrase for phrase in told]


def _fact(key: str, value: Data) -> str | None:
    """A fact of a mask in words; None for one that goes without saying."""
    match key, value:
        case "arity" | "coefficients" | "control_points", int():
            return f"arity {value}" if key == "arity" else _count(value, key[:-1].replace("_", " "))
        case "support", (int(first), int(last)):
            return f"support {first} … {last}"
        case "gaps", tuple() if value:
            return f"zero at {', '.join(map(data, value))}" if len(value) <= 6 else f"{len(value)} zeros inside"
        case "spacing", int() if value > 1:
            return f"supported on a lattice of spacing {value}"
        case (("symmetry" | "type"), str()):
            return value
        case (("interpolatory" | "nonnegative" | "stochastic"), True):
            return key
        case "dilation", tuple():
            return f"dilation {_matrix(value)}"
        case "isotropic", False:
            return "anisotropic"
        case "symmetries", int() if value > 1:
            return f"{value} symmetries"
        case (
            ("gaps" | "spacing" | "symmetry" | "type" | "interpolatory" | "nonnegative" | "stochastic" | "centre"),
            _,
        ):
            return None
        case (("dimension" | "cosets" | "isotropic" | "lowest" | "highest" | "symmetries"), _):
            return None
    return f"{key}: {data(value)}"


def _matrix(rows: tuple[Data, ...]) -> str:
    """A matrix as text: `2I`, or by rows `[[1,1],[1,-1]]`, as mask files have it."""
    square = [[x for x in row if isinstance(x, int)] for row in rows if isinstance(row, tuple)]
    if square == [[square[0][0] * (i == j) for j in range(len(square))] for i in range(len(square))]:
        return f"{square[0][0]}I"
    return f"[{','.join('[' + ','.join(map(str, row)) + ']' for row in square)}]"


def holder(result: Result) -> str | None:
    """The Hölder exponent of φ as text, and what it means where it is not positive; None where it is unknown."""
    return value(result, BY_KEY["holder"])


def figures(result: Result, *, digits: bool) -> Iterator[str]:
    """The further numbers on exponents: the estimate of one that is only enclosed; many digits of exact ones."""
    holder, sobolev = result.holder, result.sobolev
    if holder is not None and holder.estimate is not None:
        yield f"Hölder exponent ≈ {holder.estimate}, extrapolated from norms: an estimate, which proves nothing"
    for name, exponent in (("Hölder", holder), ("Sobolev", sobolev)):
        if digits and exponent is not None and exponent.digits is not None:
            yield f"{name} exponent {exponent.digits}"


def labelled(shown: str, exponent: Exponent) -> str:
    """The exponent as shown; where it is not positive, with a note that φ is then not continuous."""
    upper = 0.0 if exponent.exact == 0 else exponent.upper
    if upper is None or upper > 0:
        return shown
    return f"{shown}, distributional" if upper < 0 else f"{shown} (φ is not continuous)"


def headline(result: Result) -> str:
    """The verdict in words, in a line."""
    if result.status == "invalid":
        return f"not checked: {errors(result)}"
    if result.convergent is Verdict.PROVED:
        return _convergent(result)
    asked = answering(result.findings, CONVERGENCE, SUMS)
    if result.convergent is Verdict.REFUTED:
        smooth = _order(result.refinable)
        verdict = f"φ is {smooth}, but this scheme does not converge" if smooth else "does not converge"
        return _with(verdict, (asked.why or asked.statement) if asked else None)
    if result.convergent is Verdict.UNDECIDED:
        return _with("convergence undecided", asked.reason if asked else None)
    return "convergence not asked"


def errors(result: Result) -> str:
    """The number of errors in an invalid mask as text: `2 errors`."""
    return _count(len(result.problems), "error")


def _convergent(result: Result) -> str:
    order = result.smoothness.order
    smooth = smoothness(result)
    if smooth and order is not None and not result.smoothness.sharp:
        smooth = f"{smooth}, C^{order + 1} undecided"
    text = f"{smooth or 'convergent'} — convergence proved"
    exponent = holder(result)
    return f"{text}; Hölder exponent {exponent}" if exponent else text


def _with(text: str, why: str | None) -> str:
    return f"{text}: {why}" if why else text


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" + ("" if number == 1 else "s")


def asked(expectation: Expectation) -> str:
    """An expectation as the file spells it: `smoothness = 1`, `holder >= 1.99`, `holder in 1.99 .. 2.01`.

    Where it takes lines, only the beginning.
    """
    text = expectation.text
    relation = "" if text.startswith((">", "<")) else "in " if ".." in text else "= "
    return f"{expectation.key} {relation}{text if len(text) <= LONGEST else text[: LONGEST // 3] + '…'}"


def found(result: Result, expectation: Expectation) -> str | None:
    """The value of the property that an expectation is about; None where the result has none."""
    if expectation.key == "convergent":
        return _decided(result)
    if expectation.key == "smoothness":
        return smoothness(result) or (_decided(result) if result.convergent is Verdict.REFUTED else None)
    return value(result, BY_KEY[expectation.key], bare=True)


def value(result: Result, row: Property, *, bare: bool = False) -> str | None:
    """The value of a property as text; None where nothing is known, or where the verdict is all.

    `bare`: what stands behind the name of the property, a number without its noun, and `stable` for a verdict.
    """
    given: Any = getattr(result, row.key)
    if row.form == "smoothness":
        return smoothness_or_that_of_phi(result)
    if row.form == "exponent":
        shown = None if given is None else interval(given)
        return shown if shown is None or row.key != "holder" else labelled(shown, given)
    if row.form == "verdict":
        return {Verdict.PROVED: row.key, Verdict.REFUTED: f"not {row.key}"}.get(given) if bare else None
    return None if given is None else rational(given) if bare else f"{row.form} {given}"


def _decided(result: Result) -> str | None:
    """The words on whether the scheme converges, None where that is not known."""
    return convergence(result) if result.convergent in (Verdict.PROVED, Verdict.REFUTED) else None


def found_instead(result: Result, judgement: Judgement) -> str | None:
    """The value of a property whose expectation was not proved."""
    return None if judgement.verdict is Verdict.PROVED else found(result, judgement.expectation)


def judged(result: Result, judgement: Judgement, verdict: str) -> str:
    """A judged expectation as text: `expected smoothness = 3: refuted, found C^2, not C^3`; `verdict` as given."""
    instead = found_instead(result, judgement)
    text = f"expected {asked(judgement.expectation)}: {verdict}"
    return f"{text}, found {instead}" if instead else text


def verdict_sentence(result: Result, *, allow_undecided: bool = False) -> str:
    """The sentence that explains the exit code, for one mask."""
    if result.status == "invalid":
        return "invalid: the mask was not checked"
    if result.regressions is not None:
        worse = "; ".join(regression.message for regression in result.regressions)
        why = f"worse than in the baseline: {worse}" if worse else _NO_WORSE
    elif not result.expectations:
        why = {
            "passed": "convergence proved; the mask states no expectation",
            "failed": "convergence refuted; the mask states no expectation",
            "undecided": "convergence neither proved nor refuted; the mask states no expectation",
        }[result.status]
    else:
        why = _judged(result)
    return f"{result.status}: {why}" + (" (allowed)" if allow_undecided and result.status == "undecided" else "")


def _judged(result: Result) -> str:
    total = len(result.expectations)
    proved = sum(judged.verdict is Verdict.PROVED for judged in result.expectations)
    refuted = sum(judged.verdict is Verdict.REFUTED for judged in result.expectations)
    if total == 1:
        return f"the expectation is {'proved' if proved else 'refuted' if refuted else 'neither proved nor refuted'}"
    if proved == total:
        return "both expectations proved" if total == 2 else f"all {total} expectations proved"
    parts = [(proved, "proved"), (refuted, "refuted"), (total - proved - refuted, "undecided")]
    return f"of {_count(total, 'expectation')} " + ", ".join(f"{number} {word}" for number, word in parts if number)


def summary(results: Iterable[Result]) -> dict[str, int]:
    """The number of masks, and the number of each status."""
    counts = {"files": 0, "passed": 0, "failed": 0, "undecided": 0, "invalid": 0}
    for result in results:
        counts["files"] += 1
        counts[result.status] += 1
    return counts


def footer(results: Iterable[Result], *, allow_undecided: bool = False) -> str:
    """The counts as text: `30 masks: 28 passed, 2 failed`."""
    counts = summary(results)
    total = counts.pop("files")
    shown = [f"{number} {status}" for status, number in counts.items() if number]
    if allow_undecided and counts["undecided"]:
        shown[[word.split()[1] for word in shown].index("undecided")] += " (allowed)"
    return f"{_count(total, 'mask')}: " + (", ".join(shown) or "nothing to check")
