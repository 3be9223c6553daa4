"""The words for a result: the headline, the smoothness, the exponents, the values of properties."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Any

from subdiv_cli.model import INFINITY, Data, Expectation, Exponent, Judgement, Log, Result, RootLog, Smoothness, Verdict
from subdiv_cli.model.closed import is_brief, rational, spelled
from subdiv_cli.model.findings import CONVERGENCE, SUMS, answering
from subdiv_cli.model.order import enclosure
from subdiv_cli.model.properties import BY_KEY, Property
from subdiv_cli.report.numbers import LONGEST, data, digits, interval

_RADIUS, _STENCIL_RADIUS = r"ρ_\d+(?![\d(])", r"ρ_\d+\(w\)"
_SYMBOLS = {
    r"φ": "φ: the refinable function",
    r"S0?_\d": "S_ν: the scheme of divided differences of order ν",
    r"S0?_\(Δ": "S_(Δ^k): the scheme of differences of order k",
    r"T_\d": "T_ε: the transition matrices",
    _RADIUS: "ρ_k: the joint spectral radius of S on differences of order k",
    r"σ_\d": "σ_j: the joint spectral radius of S on what lies between components and derivatives j",
    _STENCIL_RADIUS: "ρ_k(w): the joint spectral radius of S on differences of φ of order k",
    r"ρ\(": "ρ: the joint spectral radius",
}
"""The symbols that findings use, and what they mean."""
_NO_WORSE = "nothing is worse than in the baseline"


def legend(texts: Iterable[str]) -> str | None:
    """The meaning of the symbols in these texts, in a line; None where there is none of them."""
    text = "\n".join(texts)
    meanings = [meaning for symbol, meaning in _SYMBOLS.items() if re.search(symbol, text)]
    return "; ".join(meanings) if meanings else None


def explained(text: str) -> str:
    """The text with the meaning of a radius ρ_k in it, for those who see this line alone."""
    meanings = [_SYMBOLS[symbol] for symbol in (_RADIUS, _STENCIL_RADIUS) if re.search(symbol, text)]
    return f"{text} ({'; '.join(meanings)})" if meanings else text


def name(result: Result) -> str:
    """The name of the mask, else that of its file; with the parameters that vary in the run."""
    at = (f"{parameter} = {rational(result.parameters[parameter])}" for parameter in result.varied)
    return ", ".join((result.name or result.file, *at))


def place(result: Result) -> str:
    """The file of the mask, with the parameters that vary in the run, in one word: `four_point.toml[w=1/16]`."""
    at = ",".join(f"{parameter}={rational(result.parameters[parameter])}" for parameter in result.varied)
    return f"{result.file}[{at}]" if at else result.file


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
    phrases = []
    if {"lowest", "highest"} <= result.facts.keys():
        phrases.append(f"support {data(result.facts['lowest'])} … {data(result.facts['highest'])}")
    for key, value in result.facts.items():
        if (phrase := _fact(key, value)) is not None:
            phrases.append(phrase)
    centre = result.facts.get("centre")
    return [f"{phrase} about {data(centre)}" if phrase.endswith("symmetric") else phrase for phrase in phrases]


def _fact(key: str, value: Data) -> str | None:
    """A fact of a mask in words; None for one that goes without saying."""
    match key, value:
        case "arity" | "coefficients" | "control_points", int():
            return f"arity {value}" if key == "arity" else _count(value, key[:-1].replace("_", " "))
        case "size", int():
            return f"{value}×{value} matrices"
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
        case "left_support" | "right_support", (int(first), int(last)):
            return f"{key.removesuffix('_support')} mask on {first} … {last}"
        case "spacings", (left, right) if left != right:
            return f"spacings {data(left)}, {data(right)}"
        case "special_rows", tuple() if value:
            return f"special rows {', '.join(map(data, value))}"
        case "determined_by", (int(only),):
            return f"limits near 0 from point {only}"
        case "determined_by", (int(first), *_, int(last)):
            return f"limits near 0 from {_count(len(value), 'point')}, {first} … {last}"
        case (("spacings" | "special_rows"), _):
            return None
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
    """The Hölder exponent of φ in brief, and what it means where it is not positive; None where it is unknown."""
    return _exponent(result.holder, BY_KEY["holder"], brief=True)


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
    finding = answering(result.findings, CONVERGENCE, SUMS)
    if result.convergent is Verdict.REFUTED:
        smooth = _order(result.refinable)
        verdict = f"φ is {smooth}, but this scheme does not converge" if smooth else "does not converge"
        return _with(verdict, (finding.why or finding.statement) if finding else None)
    if result.convergent is Verdict.UNDECIDED:
        return _with("convergence undecided", finding.reason if finding else None)
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


def expected(expectation: Expectation) -> str:
    """An expectation as the file spells it: `smoothness = 1`, `holder >= 1.99`, `holder in 1.99 .. 2.01`.

    Where it takes lines, only the beginning.
    """
    text = expectation.text
    relation = "" if text.startswith((">", "<")) else "in " if ".." in text else "= "
    return f"{expectation.key} {relation}{text if len(text) <= LONGEST else text[: LONGEST // 3] + '…'}"


def expected_briefly(expectation: Expectation) -> str:
    """An expectation as `expected`, but of a closed form not read at a glance its digits: `sobolev = 3.2596…`."""
    number = expectation.lower
    if expectation.upper != number or not isinstance(number, RootLog | Log) or is_brief(expectation.text):
        return expected(expectation)
    low, high = enclosure(number, refined=True)
    return f"{expectation.key} = {digits(float(low), float(high))}"


def actual(result: Result, expectation: Expectation, *, brief: bool = False) -> str | None:
    """The value of the property that an expectation is about; None where the result has none.

    `brief`: a closed form that is not read at a glance is left to its digits.
    """
    if expectation.key == "convergent":
        return _decided(result)
    if expectation.key == "smoothness":
        return smoothness(result) or (_decided(result) if result.convergent is Verdict.REFUTED else None)
    return value(result, BY_KEY[expectation.key], bare=True, brief=brief)


def value(result: Result, row: Property, *, bare: bool = False, brief: bool = False) -> str | None:
    """The value of a property as text; None where nothing is known, or where the verdict is all.

    `bare`: what stands behind the name of the property, a number without its noun, and `stable` for a verdict.
    """
    given: Any = getattr(result, row.key)
    if row.form == "smoothness":
        return smoothness_or_that_of_phi(result)
    if row.form == "exponent":
        return _exponent(given, row, brief=brief)
    if row.form == "verdict":
        return {Verdict.PROVED: row.key, Verdict.REFUTED: f"not {row.key}"}.get(given) if bare else None
    return None if given is None else rational(given) if bare else f"{row.form} {given}"


def _exponent(given: Exponent | None, row: Property, *, brief: bool = False) -> str | None:
    """An exponent as text, of a Hölder exponent with what is known besides; None where it is unknown."""
    shown = None if given is None else interval(given, brief=brief)
    if shown is None or given is None or row.key != "holder":
        return shown
    attained = _attained(given)
    return labelled(f"{shown}, {attained}" if attained else shown, given)


def _attained(exponent: Exponent) -> str | None:
    return {True: "attained", False: "not attained", None: None}[exponent.attained]


def _decided(result: Result) -> str | None:
    """The words on whether the scheme converges, None where that is not known."""
    return convergence(result) if result.convergent in (Verdict.PROVED, Verdict.REFUTED) else None


def actual_unless_proved(result: Result, judgement: Judgement, *, brief: bool = False) -> str | None:
    """The value of a property whose expectation was not proved."""
    return None if judgement.verdict is Verdict.PROVED else actual(result, judgement.expectation, brief=brief)


def judged(result: Result, judgement: Judgement, verdict: str) -> str:
    """A judged expectation as text: `expected smoothness = 3: refuted, found C^2, not C^3`; `verdict` as given."""
    instead = actual_unless_proved(result, judgement, brief=True)
    text = f"expected {expected_briefly(judgement.expectation)}: {verdict}"
    return f"{text}, found {instead}" if instead else text


def verdict_sentence(result: Result, *, allow_undecided: bool = False) -> str:
    """The answer in a line, with the reason for the exit code: `passed: C^1, not C^2; 7 of 7 expectations proved`."""
    if result.status == "invalid":
        return "invalid: the mask was not checked"
    status = f"{result.status} (allowed)" if allow_undecided and result.status == "undecided" else result.status
    return f"{status}: {'; '.join([*_answers(result), _gate(result)])}"


def _answers(result: Result) -> Iterator[str]:
    """The smoothness, or why there is none, and the Hölder exponent in brief."""
    if result.convergent is Verdict.PROVED:
        yield smoothness(result) or "converges"
    else:
        yield {Verdict.REFUTED: "does not converge"}.get(result.convergent, "convergence undecided")
        if result.refinable.order is not None:
            yield f"φ is {_order(result.refinable)}"
    exponent = result.holder or Exponent()
    exact = None if exponent.exact is None else spelled(exponent.exact)
    number = exact if exact is not None and is_brief(exact) else interval(exponent, brief=True)
    if number is not None:
        attained = _attained(exponent)
        yield f"Hölder {labelled(number, exponent)}" + (f" ({attained})" if attained else "")


def _gate(result: Result) -> str:
    """What the exit code follows: the baseline, else the expectations, else convergence."""
    if result.regressions is not None:
        return "worse than in the baseline" if result.regressions else _NO_WORSE
    if not result.expectations:
        return "no expectation stated"
    verdicts = [judged.verdict for judged in result.expectations]
    counts = {verdict: verdicts.count(verdict) for verdict in (Verdict.PROVED, Verdict.REFUTED)}
    counts[Verdict.UNDECIDED] = len(verdicts) - sum(counts.values())
    also = [f"{count} {verdict.value}" for verdict, count in counts.items() if count and verdict is not Verdict.PROVED]
    return ", ".join([f"{counts[Verdict.PROVED]} of {_count(len(verdicts), 'expectation')} proved", *also])


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
