"""Whether the exponents of a result in several variables are those that a verified certificate states.

They are -log_λ(x)/L with λ^s = |det M|, s times those to the base |det M|. Loads no flint; an exact exponent is
compared with the statement to 70 digits.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from subdiv_cli.catalog.numbers import Statement, of_finding, of_statement, radius_is_proved, statements_of
from subdiv_cli.checker.lattice import lattice_mask
from subdiv_cli.model import ClosedForm, Exponent, Result, logarithm
from subdiv_cli.model.order import enclosure

_LOWER = {"holder-lower", "sobolev-lower"}
_UPPER = {"holder-upper"}


def surface_numbers_are_proved(result: Result, statements: Sequence[Statement], mask: Mapping[str, Any]) -> bool:
    """Whether claims of the certificate say each exponent and radius of the result."""
    rows = [tuple(row) for row in mask["dilation"]]
    dilation = lattice_mask(rows, [((0,) * len(rows), Fraction(1))]).dilation
    m, s = dilation.cosets, dilation.dimension
    found = {finding.code: finding for finding in result.findings}
    about = {code: statements_of(found.get(code), statements) for code in ("SD614", "SD615", "SD617")}
    exponents = (
        (result.holder, (*about["SD614"], *about["SD615"])),
        (result.sobolev, about["SD617"]),
        *((of_finding(found[code]), said) for code, said in about.items() if said),
    )
    if not all(_is_proved(exponent, said, m, s) for exponent, said in exponents):
        return False
    return all(radius_is_proved(finding, statements, m) for finding in result.findings if finding.code == "SD605")


def _is_proved(exponent: Exponent | None, said: Sequence[Statement], m: int, s: int) -> bool:
    """Whether statements give the exact exponent, and bounds as good as these."""
    if exponent is None:
        return True
    known = [(_exact(statement, m), _factor(statement, s)) for statement in said]
    ends = [_times(enclosure(number), factor) for number, factor in known if number is not None]
    sharp = [_times(enclosure(number, refined=True), factor) for number, factor in known if number is not None]
    if exponent.exact is not None:
        low, high = enclosure(exponent.exact, refined=True)
        if not any(low <= upper and lower <= high for lower, upper in sharp):
            return False
    below = [low for low, _ in (*ends, *_bounds(said, _LOWER, m, s))]
    above = [high for _, high in (*ends, *_bounds(said, _UPPER, m, s))]
    lower, upper = exponent.lower, exponent.upper
    return (lower is None or Fraction(lower) <= max(below)) and (upper is None or min(above) <= Fraction(upper))


def _exact(statement: Statement, m: int) -> ClosedForm | None:
    if statement["property"] in ("holder-value", "sobolev-value"):
        return Fraction(statement["value"])
    return of_statement(statement, m)


def _factor(statement: Statement, s: int) -> int:
    return 1 if statement["property"] in ("holder-value", "sobolev-value") else s


def _bounds(said: Iterable[Statement], names: set[str], m: int, s: int) -> list[tuple[Fraction, Fraction]]:
    """Enclosures of the bounds that statements of these kinds give."""
    found = []
    for statement in said:
        if statement["property"] not in names:
            continue
        if statement["property"] == "sobolev-lower":
            closed = of_statement({**statement, "property": "sobolev"}, m)
            found += [_times(enclosure(closed), s)] if closed is not None else []
        else:
            closed = logarithm(m, 1 / Fraction(statement["bound"]), statement["length"])
            found.append(_times(enclosure(closed), s))
    return found


def _times(ends: tuple[Fraction, Fraction], factor: int) -> tuple[Fraction, Fraction]:
    return factor * ends[0], factor * ends[1]
