"""Whether the exponents of a result in several variables are those that a verified certificate states.

They are -log_λ(x)/L with λ^s = |det M|, s times those to the base |det M|. Loads no flint; an exact exponent is
compared with the statement to 70 digits.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.catalog.numbers import Statement, of_finding, of_statement, radius_is_proved, statements_of
from subdiv_cli.checker.matrices import inverse
from subdiv_cli.checker.multivariate.lattice import Index
from subdiv_cli.model import ClosedForm, Exponent, Result, logarithm
from subdiv_cli.model.order import enclosure

_LOWER = {"holder-lower", "sobolev-lower"}
_UPPER = {"holder-upper"}


class _Said(NamedTuple):
    """A statement on an exponent to the base λ, λ^s = m; of a factor only from above, where it is so said."""

    statement: Statement
    m: int
    s: int
    only_above: bool = False


def surface_numbers_are_proved(result: Result, statements: Sequence[Statement], mask: Mapping[str, Any]) -> bool:
    """Whether claims of the certificate say each exponent and radius of the result."""
    rows = [tuple(row) for row in mask["dilation"]]
    found = {finding.code: finding for finding in result.findings}
    about = {
        code: [_said(statement, rows) for statement in statements_of(found.get(code), statements)]
        for code in ("SD614", "SD615", "SD617")
    }
    exponents = (
        (result.holder, (*about["SD614"], *about["SD615"])),
        (result.sobolev, about["SD617"]),
        *((of_finding(found[code]), said) for code, said in about.items() if said),
    )
    if not all(_is_proved(exponent, said) for exponent, said in exponents):
        return False
    m = _index(rows)
    return all(radius_is_proved(finding, statements, m) for finding in result.findings if finding.code == "SD605")


def _said(statement: Statement, rows: Sequence[Index]) -> _Said:
    """Statements of factors are to the base of the block of M that is theirs."""
    if "variables" not in statement:
        return _Said(statement, _index(rows), len(rows))
    variables = statement["variables"]
    block = [tuple(rows[i][j] for j in variables) for i in variables]
    return _Said(statement["statement"], _index(block), len(block), statement["property"] == "at-most-factor")


def _index(rows: Sequence[Index]) -> int:
    """|det M|."""
    found = inverse([list(row) for row in rows])
    return abs(found[1]) if found is not None else 0


def _is_proved(exponent: Exponent | None, said: Sequence[_Said]) -> bool:
    """Whether statements give the exact exponent, and bounds as good as these."""
    if exponent is None:
        return True
    known = [(each, number) for each in said if (number := _exact(each)) is not None]
    sharp = [_times(enclosure(number, refined=True), each) for each, number in known if not each.only_above]
    if exponent.exact is not None:
        low, high = enclosure(exponent.exact, refined=True)
        if not any(low <= upper and lower <= high for lower, upper in sharp):
            return False
    ends = [(each, _times(enclosure(number), each)) for each, number in known]
    below = [low for each, (low, _) in ends if not each.only_above] + [low for low, _ in _bounds(said, _LOWER)]
    above = [high for _, (_, high) in ends] + [high for _, high in _bounds(said, _UPPER)]
    lower, upper = exponent.lower, exponent.upper
    return (lower is None or Fraction(lower) <= max(below)) and (upper is None or min(above) <= Fraction(upper))


def _exact(each: _Said) -> ClosedForm | None:
    """To the base m, where it is no value."""
    statement = each.statement
    return Fraction(statement["value"]) if "value" in statement else of_statement(statement, each.m)


def _bounds(said: Iterable[_Said], names: set[str]) -> list[tuple[Fraction, Fraction]]:
    """Enclosures of the bounds that statements of these kinds give."""
    found = []
    for each in said:
        statement = each.statement
        if statement["property"] not in names:
            continue
        if statement["property"] == "sobolev-lower":
            closed = of_statement({**statement, "property": "sobolev"}, each.m)
            found += [_times(enclosure(closed), each)] if closed is not None else []
        else:
            bound = next(statement[key] for key in ("bound", "norm", "radius") if key in statement)
            length = statement["level"] if "norm" in statement else statement["length"]
            found.append(_times(enclosure(logarithm(each.m, 1 / Fraction(bound), length)), each))
    return found


def _times(ends: tuple[Fraction, Fraction], each: _Said) -> tuple[Fraction, Fraction]:
    """To the base λ; values are not to a base."""
    factor = 1 if "value" in each.statement else each.s
    return factor * ends[0], factor * ends[1]
