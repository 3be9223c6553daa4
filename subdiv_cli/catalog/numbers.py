"""The test whether the numbers of a result are those that a verified certificate states.

Exponents are -log_λ(x)/L with λ^s = m, s times those to the base m, (m, s) = (|det M|, s) or, in one variable, (p, 1);
statements on factors are to the base of the block of M that is theirs. In one variable they are compared in closed
form, otherwise by enclosures to 70 digits; the doubles beside them with rational enclosures. Where the enclosures do
not tell, the answer is no. Loads no flint.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple

from subdiv_cli.maskfile.closed import roots_between
from subdiv_cli.model import (
    INFINITY,
    ClosedForm,
    Exponent,
    Finding,
    Interval,
    Result,
    Root,
    RootLog,
    Rule,
    logarithm,
    unpowered,
)
from subdiv_cli.model.closed import root_log_text, spelled, spelled_terms
from subdiv_cli.model.findings import HOLDER_AT_ZERO, HOLDER_LOWER, HOLDER_UPPER, SOBOLEV, answering
from subdiv_cli.model.order import enclosure

Statement = Mapping[str, Any]
Base = tuple[int, int]
"""The pair (m, s): exponents are to the base λ with λ^s = m."""

_LOWER = {"holder-lower", "sobolev-lower", "sobolev-at-least"}
_UPPER = {"holder-upper", "sobolev-at-most"}


class Stated(NamedTuple):
    """A statement on an exponent, to the base λ with λ^s = m."""

    statement: Statement
    m: int
    s: int
    only_above: bool = False
    """Whether it is about a factor and bounds the exponent of φ only from above."""


def numbers_are_proved(
    result: Result,
    statements: Sequence[Statement],
    rules: Mapping[str, Rule[Any]],
    base: Callable[[Sequence[int] | None], Base],
) -> bool:
    """Whether claims of the certificate state each exponent and radius of the result.

    `base` gives (m, s) of the mask, or of its factor in these variables.
    """
    about: dict[str, tuple[Finding, list[Stated]]] = {}
    for question in (HOLDER_LOWER, HOLDER_UPPER, HOLDER_AT_ZERO, SOBOLEV):
        finding = answering(result.findings, question)
        if finding is not None:
            stated = [_stated(statements[number], base) for number in finding.claims]
            own = [s for s in stated if s.statement["property"].startswith("sobolev") is (question == SOBOLEV)]
            about[question.name] = finding, own
    given = {name: stated for name, (_, stated) in about.items()}
    holder = (*given.get(HOLDER_LOWER.name, ()), *given.get(HOLDER_UPPER.name, ()))
    exponents = (
        (result.holder, holder),
        (result.holder_at_zero, given.get(HOLDER_AT_ZERO.name, ())),
        (result.sobolev, given.get(SOBOLEV.name, ())),
        *((of_finding(finding), stated) for finding, stated in about.values() if stated),
    )
    if not all(_is_proved(exponent, stated) for exponent, stated in exponents):
        return False
    if result.holder is not None and result.holder.attained is not None:
        holds = {s["holds"] for s in statements if s["property"] == "attained"}
        if holds != {result.holder.attained}:
            return False
    m, _ = base(None)
    return all(radius_is_proved(f, statements, m) for f in result.findings if rules[f.code].radius)


def _stated(statement: Statement, base: Callable[[Sequence[int] | None], Base]) -> Stated:
    """The statement with its base: that of a factor is the base of the block of M that is its own.

    A statement on the exponent at 0 is read as one on an exponent.
    """
    name = statement["property"]
    if name.startswith("zero-"):
        exponent = "polynomial-curve" if name == "zero-polynomial" else name.replace("zero", "holder")
        return Stated({**statement, "property": exponent}, *base(None))
    if "variables" not in statement:
        return Stated(statement, *base(None))
    of_block = base(statement["variables"])
    return Stated(statement["statement"], *of_block, only_above=statement["property"] == "at-most-factor")


def of_finding(finding: Finding) -> Exponent:
    """The exponent that a finding shows. Raises ValueError where the exact text is not that of its number."""
    value, closed = finding.value or Interval(), finding.closed
    if value.exact is None:
        closed = None
    elif closed is None or value.exact != spelled(closed):
        raise ValueError("another text than that of the number")
    return Exponent(lower=value.lower, upper=value.upper, exact=closed)


def _is_proved(exponent: Exponent | None, stated: Sequence[Stated]) -> bool:
    """Whether statements give the exact exponent, and bounds as good as these."""
    if exponent is None:
        return True
    lower, upper, exact = exponent.lower, exponent.upper, exponent.exact
    if exponent.digits is not None and (exact is None or not _is_cut(exponent.digits, exact)):
        return False
    known = [(each, number) for each in stated if (number := _exact(each)) is not None]
    if exact == INFINITY:
        return lower is None and upper is None and any(number == INFINITY for _, number in known)
    if exact is not None and not any(_agree(exact, number, each) for each, number in known if not each.only_above):
        return False
    ends = [(each, _times(enclosure(number), each)) for each, number in known]
    below = [low for each, (low, _) in ends if not each.only_above] + [low for low, _ in _bounds(stated, _LOWER)]
    above = [high for _, (_, high) in ends] + [high for _, high in _bounds(stated, _UPPER)]
    return (lower is None or Fraction(lower) <= max(below)) and (upper is None or min(above) <= Fraction(upper))


def _exact(each: Stated) -> ClosedForm | None:
    """The number that a statement has exactly, to the base m; a value is to no base."""
    statement = each.statement
    if statement["property"] == "polynomial-curve":
        return INFINITY
    return Fraction(statement["value"]) if "value" in statement else of_statement(statement, each.m)


def _agree(exact: ClosedForm, number: ClosedForm, each: Stated) -> bool:
    """Whether the exact exponent is s times this number."""
    if each.s == 1:
        return _same(exact, number)
    (low, high), (lower, upper) = enclosure(exact, refined=True), _times(enclosure(number, refined=True), each)
    return low <= upper and lower <= high


def _bounds(stated: Iterable[Stated], names: set[str]) -> list[tuple[Fraction, Fraction]]:
    """The enclosures of the bounds that statements of these kinds give."""
    enclosures = []
    for each in stated:
        statement = each.statement
        if statement["property"] not in names:
            continue
        if statement["property"] == "sobolev-lower":
            closed = of_statement({**statement, "property": "sobolev"}, each.m)
            enclosures += [_times(enclosure(closed), each)] if closed is not None else []
        else:
            bound = next(statement[key] for key in ("bound", "norm", "radius") if key in statement)
            length = statement["level"] if "norm" in statement else statement["length"]
            enclosures.append(_times(enclosure(logarithm(each.m, 1 / Fraction(bound), length)), each))
    return enclosures


def _times(ends: tuple[Fraction, Fraction], each: Stated) -> tuple[Fraction, Fraction]:
    """The enclosure to the base λ; values are not to a base."""
    factor = 1 if "value" in each.statement else each.s
    return factor * ends[0], factor * ends[1]


def of_statement(s: Statement, p: int) -> ClosedForm | None:
    """The exponent that a statement has exactly, a `RootLog` without its text; None where it has none."""
    if s["property"] == "holder":
        return logarithm(p, 1 / Fraction(s["norm"]), s["level"])
    if s["property"] not in ("holder-root", "sobolev"):
        return None
    sobolev = s["property"] == "sobolev"
    length = 2 if sobolev else s["length"]
    polynomial = s["polynomial"]["coefficients"] if sobolev else s["polynomial"]
    if len(polynomial) == 2:
        return logarithm(p, -Fraction(polynomial[1]) / Fraction(polynomial[0]), length)
    base, divisor = unpowered(p, length)
    return RootLog(base, Root(tuple(map(int, polynomial)), Fraction(s["low"]), Fraction(s["high"])), divisor, "")


def _same(exact: ClosedForm, number: ClosedForm) -> bool:
    """Whether these are one number; the text of a root has its polynomial, and encloses it."""
    if not isinstance(exact, RootLog) or not isinstance(number, RootLog):
        return exact == number
    if exact._replace(text="") != number:
        return False
    if spelled(exact) is None:  # then its text is shown nowhere
        return True
    return _is_text(exact.text, number)


_BOUNDS = re.compile(r", (?P<low>[0-9.]{1,2000}), (?P<high>[0-9.]{1,2000})\)\)(?:/[0-9]+)?")


@lru_cache(maxsize=64)
def _is_text(text: str, number: RootLog) -> bool:
    """Whether this is how the number is spelled, with bounds that enclose its root and no other one.

    One text stands in several places of a result.
    """
    if (match := _BOUNDS.search(text)) is None:
        return False
    f = number.root.coefficients
    polynomial = spelled_terms(reversed(list(enumerate(f))), "x", "*", str)
    if text != root_log_text(number.base, polynomial, match["low"], match["high"], number.divisor):
        return False
    low, high = Fraction(match["low"]), Fraction(match["high"])
    return 0 < low <= number.root.low <= number.root.high <= high and roots_between(f, low, high) == 1


_DECIMALS = re.compile(r"-?\d+\.(?P<places>\d+)…(?:e(?P<power>-?\d{1,6}))?")


def _is_cut(digits: str, exact: ClosedForm) -> bool:
    """Whether these are the first decimals of a number, cut: `2.83007…`."""
    match = _DECIMALS.fullmatch(digits)
    if match is None:
        return False
    unit = Fraction(10) ** (int(match["power"] or 0) - len(match["places"]))
    size = abs(Fraction(digits.replace("…", "")))
    low, high = enclosure(exact, refined=True)
    low, high = (-high, -low) if digits.startswith("-") else (low, high)
    return size <= low <= high < size + unit


def radius_is_proved(finding: Finding, statements: Sequence[Statement], p: int) -> bool:
    """Whether claims on a joint spectral radius bound it as well as the finding does."""
    value = finding.value or Interval()
    below, above = [], []
    for s in (statements[number] for number in finding.claims):
        if s["property"] in ("radius", "bounded"):
            below.append((Fraction(s["low"]), s["length"]))
            above.append((Fraction(s["high"]), s["length"]))
        elif s["property"] == "radius-upper":
            above.append((Fraction(s["bound"]), s["length"]))
        elif s["property"] == "norm":  # of (1/p) S_ν, which is p^(ν-1) S_(Δ^ν)
            above.append((Fraction(s["norm"]) / p ** ((s["nu"] - 1) * s["level"]), s["level"]))
        elif s["property"] == "product":
            below.append((Fraction(s["radius"]), len(s["word"])))
    lower, upper = value.lower, value.upper
    if value.exact is not None and not {(Fraction(value.exact), 1)} & set(below) & set(above):
        return False
    return (lower is None or any(Fraction(lower) ** length <= x for x, length in below)) and (
        upper is None or any(x <= Fraction(upper) ** length for x, length in above)
    )
