"""Whether the numbers of a result are those that a verified certificate states.

The exponents -log_p(x)/L are compared in closed form, and the doubles beside them with rational enclosures; where the
enclosures do not tell, the answer is no. Loads no flint.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any

from subdiv_cli.maskfile.roots import roots_between
from subdiv_cli.model import ClosedForm, Exponent, Finding, Interval, Result, Root, RootLog, logarithm, unpowered
from subdiv_cli.model.closed import root_log_text, spelled, spelled_terms
from subdiv_cli.model.order import enclosure

Statement = Mapping[str, Any]


def numbers_are_proved(result: Result, statements: Sequence[Statement], p: int) -> bool:
    """Whether claims of the certificate say each exponent and radius of the result, for arity p."""
    found = {finding.code: finding for finding in result.findings}
    about = {code: statements_of(found.get(code), statements) for code in ("SD311", "SD312", "SD321")}
    exponents = (
        (result.holder, (*about["SD311"], *about["SD312"])),
        (result.sobolev, about["SD321"]),
        *((of_finding(found[code]), said) for code, said in about.items() if said),
    )
    if not all(_is_proved(exponent, said, p) for exponent, said in exponents):
        return False
    if result.holder is not None and result.holder.attained is not None:
        holds = {s["holds"] for s in statements if s["property"] == "attained"}
        if holds != {result.holder.attained}:
            return False
    return all(radius_is_proved(finding, statements, p) for finding in result.findings if finding.code == "SD310")


def statements_of(finding: Finding | None, statements: Sequence[Statement]) -> tuple[Statement, ...]:
    """The statements that a finding names."""
    return () if finding is None else tuple(statements[number] for number in finding.claims)


def of_finding(finding: Finding) -> Exponent:
    """What a finding shows of an exponent. Raises ValueError where the exact text is not that of its number."""
    value, closed = finding.value or Interval(), finding.closed
    if value.exact is None:
        closed = None
    elif closed is None or value.exact != spelled(closed):
        raise ValueError("another text than that of the number")
    return Exponent(lower=value.lower, upper=value.upper, exact=closed)


def _is_proved(exponent: Exponent | None, said: Sequence[Statement], p: int) -> bool:
    """Whether statements give the exact exponent, and bounds as good as these."""
    if exponent is None:
        return True
    lower, upper, exact = exponent.lower, exponent.upper, exponent.exact
    if exponent.digits is not None and (exact is None or not _is_cut(exponent.digits, exact)):
        return False
    known = [number for number in (of_statement(statement, p) for statement in said) if number is not None]
    if exact is not None and not any(_same(exact, number) for number in known):
        return False
    ends = [enclosure(number) for number in known]
    below = [low for low, _ in ends] + [low for low, _ in _bounds(said, "holder-lower", "level", "norm", p)]
    above = [high for _, high in ends] + [high for _, high in _bounds(said, "holder-upper", "length", "radius", p)]
    return (lower is None or Fraction(lower) <= max(below)) and (upper is None or min(above) <= Fraction(upper))


def _bounds(
    said: Sequence[Statement], name: str, length: str, number: str, p: int
) -> Iterator[tuple[Fraction, Fraction]]:
    """Enclosures of the bounds of α by statements of a kind."""
    for s in said:
        if s["property"] == name:
            yield enclosure(logarithm(p, 1 / Fraction(s[number]), s[length]))


def of_statement(s: Statement, p: int) -> ClosedForm | None:
    """The exponent that a statement says exactly; a `RootLog` without its text."""
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
    if (found := _BOUNDS.search(text)) is None:
        return False
    f = number.root.coefficients
    polynomial = spelled_terms(reversed(list(enumerate(f))), "x", "*", str)
    if text != root_log_text(number.base, polynomial, found["low"], found["high"], number.divisor):
        return False
    low, high = Fraction(found["low"]), Fraction(found["high"])
    return 0 < low <= number.root.low <= number.root.high <= high and roots_between(f, low, high) == 1


_DECIMALS = re.compile(r"-?\d+\.(?P<places>\d+)…(?:e(?P<power>-?\d{1,6}))?")


def _is_cut(digits: str, exact: ClosedForm) -> bool:
    """Whether these are the first decimals of a number, cut: `2.83007…`."""
    found = _DECIMALS.fullmatch(digits)
    if found is None:
        return False
    unit = Fraction(10) ** (int(found["power"] or 0) - len(found["places"]))
    size = abs(Fraction(digits.replace("…", "")))
    low, high = enclosure(exact, refined=True)
    low, high = (-high, -low) if digits.startswith("-") else (low, high)
    return size <= low <= high < size + unit


def radius_is_proved(finding: Finding, statements: Sequence[Statement], p: int) -> bool:
    """Whether claims on a joint spectral radius bound it as well as the finding says."""
    value = finding.value or Interval()
    below, above = [], []
    for s in statements_of(finding, statements):
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
