"""The text of a scalar mask: the [mask] table with arity, and start with coefficients, or symbol; the way back."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_ARITY, MAX_EXPONENT, MAX_MASK_LENGTH
from subdiv_cli.maskfile.entries import Table, mask_table, read_number, read_symbol
from subdiv_cli.maskfile.expressions import Expression, literal, number_of, polynomial_of
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.mask import too_precise, zero_mask
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath
from subdiv_cli.maskfile.spelling import listed, number, quoted
from subdiv_cli.maskfile.values import described
from subdiv_cli.model.closed import rational

_KEYS = ("arity", "start", "coefficients", "symbol")
_MULTIVARIATE = 'it is for kind = "multivariate"; a scalar mask has start and coefficients, or symbol'
_COEFFICIENTS = ("did you mean coefficients?", "coefficients")
_ELSEWHERE = {
    "dilation": ("a scalar mask has an arity: arity = 2", "arity"),
    "offset": ("did you mean start?", "start"),
    "mask": _COEFFICIENTS,
    "coef": _COEFFICIENTS,
    "coefs": _COEFFICIENTS,
    "terms": (_MULTIVARIATE, "coefficients"),
    "box_spline": (_MULTIVARIATE, "coefficients"),
    "tensor": (_MULTIVARIATE, "coefficients"),
} | dict.fromkeys(("kind", "name", "reference", "format"), ("it belongs at the top, above [mask]", ""))


class Coefficients(NamedTuple):
    """The coefficients a_start, a_(start+1), … of a mask, one expression without z each; at least one."""

    arity: int
    start: int
    entries: tuple[Expression, ...]

    def expressions(self) -> Iterable[Expression]:
        """The expressions of the body, each of which may have parameters."""
        return self.entries

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> ScalarScheme | None:
        """The scheme with the values put in; None where something is wrong, which is recorded as SD007 to SD011."""
        numbers = [number_of(entry, values, problems, work) for entry in self.entries]
        if None in numbers:
            return None
        coefficients = {k: value for k, value in enumerate(numbers, self.start) if value}
        return _scheme(self.arity, coefficients, self.entries[0].path[:-1], values, problems)


class Symbol(NamedTuple):
    """The symbol a(z) = Σ a_k z^k of a mask as one expression in z."""

    arity: int
    expression: Expression

    def expressions(self) -> Iterable[Expression]:
        """The expressions of the body, each of which may have parameters."""
        return (self.expression,)

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> ScalarScheme | None:
        """The scheme with the values put in; None where something is wrong, which is recorded as SD007 to SD011."""
        polynomial = polynomial_of(self.expression, values, problems, work)
        if polynomial is None:
            return None
        return _scheme(self.arity, polynomial.coefficients, self.expression.path, values, problems)


def read(top: Table, parameters: Collection[str], problems: Collector) -> Coefficients | Symbol | None:
    """The mask of a file; None where something is wrong, which is recorded."""
    table = mask_table(top)
    if table is None or ("kind" not in top.data and _is_multivariate(table)):
        return None
    return read_scalar(table, parameters, problems)


def _is_multivariate(table: Table) -> bool:
    """Whether the keys of a file without kind are those of a mask in several variables, which is recorded."""
    nested = table.data.get("coefficients")
    mark = next((key for key in ("dilation", "terms", "box_spline", "tensor") if key in table.data), None)
    if mark is None and not (isinstance(nested, list) and nested and all(isinstance(row, list) for row in nested)):
        return False
    keys = "coefficients in lists in lists are" if mark is None else f"{mark} is"
    help = 'write kind = "multivariate" at the top, above [mask]'
    if mark == "dilation" and "arity" not in table.data:
        help += "; a mask in one variable has an arity: arity = 2"
    fault = Fault(faults.MISSING_KEY, f'kind = "multivariate" is missing: {keys} for masks in several variables', help)
    table.problems.add(fault, (*table.path, mark or "coefficients"), of_key=True)
    return True


def read_scalar(table: Table, parameters: Collection[str], problems: Collector) -> Coefficients | Symbol | None:
    """The body of a scalar mask; None where something is wrong, which is recorded."""
    table.only(_KEYS, _ELSEWHERE)
    help = "write arity = 2, or 3 for a ternary scheme"
    arity = table.integer("arity", 2, 2, MAX_ARITY, help)
    if "symbol" in table.data:
        return _symbol(table, arity, parameters)
    help = "write the index of the first coefficient, start = -3, or leave it out: it only shifts the limit"
    start = table.integer("start", 0, -MAX_EXPONENT, MAX_EXPONENT, help)
    if "coefficients" not in table.data:
        help = 'write coefficients = ["1/2", 1, "1/2"], or symbol = "z^-1 (1+z)^2 / 2"'
        table.missing("coefficients", "coefficients are missing, and there is no symbol", help)
        return None
    entries = _coefficients(table, parameters)
    if arity is None or start is None or entries is None:
        return None
    return Coefficients(arity=arity, start=start, entries=entries)


def _symbol(table: Table, arity: int | None, parameters: Collection[str]) -> Symbol | None:
    """The body that `symbol` gives; None where something is wrong, which is recorded."""
    for other in ("coefficients", "start"):
        if other in table.data:
            help = f"keep one of the two: {other}, or the exponents of symbol"
            table.problems.add(
                Fault(faults.DUPLICATE_KEY, f"{other} and symbol both give the mask", help),
                (*table.path, other),
                of_key=True,
            )
    expression = read_symbol(table, {*parameters, "z"}, 'write an expression in z: symbol = "(1+z)^2 / 2"')
    return None if arity is None or expression is None else Symbol(arity=arity, expression=expression)


def _coefficients(table: Table, parameters: Collection[str]) -> tuple[Expression, ...] | None:
    """The entries of `coefficients`; None where something is wrong, which is recorded."""
    path = (*table.path, "coefficients")
    values = table.data["coefficients"]
    fault = None
    if not isinstance(values, list):
        help = 'write a list: coefficients = ["1/2", 1, "1/2"]'
        fault = Fault(faults.WRONG_TYPE, f"coefficients must be a list, not {described(values)}", help)
    elif not values:
        fault = Fault(faults.ZERO_MASK, "the mask is empty", 'write its coefficients: ["1/2", 1, "1/2"]')
    elif len(values) > MAX_MASK_LENGTH:
        message = f"the mask has {len(values)} coefficients; the limit is {MAX_MASK_LENGTH}"
        fault = Fault(faults.OUT_OF_BOUNDS, message, "use a shorter mask")
    if fault:
        table.problems.add(fault, path)
        return None
    assert isinstance(values, list), "anything else is a fault"
    work = Work()
    read = [read_number(value, (*path, i), parameters, table.problems, work) for i, value in enumerate(values)]
    entries = tuple(entry for entry in read if entry is not None)
    return entries if len(entries) == len(values) else None


def _scheme(
    arity: int, coefficients: Mapping[int, Fraction], path: KeyPath, values: Mapping[str, Fraction], problems: Collector
) -> ScalarScheme | None:
    fault = zero_mask(values) if not coefficients else _too_long(coefficients) or too_precise(coefficients.values())
    if fault:
        problems.add(fault, path)
        return None
    start = min(coefficients)
    dense = tuple(coefficients.get(k, Fraction(0)) for k in range(start, max(coefficients) + 1))
    return ScalarScheme(arity=arity, start=start, coefficients=dense)


def _too_long(coefficients: Mapping[int, Fraction]) -> Fault | None:
    first, last = min(coefficients), max(coefficients)
    if last - first >= MAX_MASK_LENGTH:
        message = f"the mask has {last - first + 1} coefficients; the limit is {MAX_MASK_LENGTH}"
        return Fault(faults.OUT_OF_BOUNDS, message, "use a shorter mask")
    if max(-first, last) > 2 * MAX_EXPONENT:
        return Fault(faults.OUT_OF_BOUNDS, f"an index beyond {2 * MAX_EXPONENT}", "shift the mask towards 0")
    return None


def body_of(scheme: ScalarScheme) -> Coefficients:
    """The literal coefficients of a scheme."""
    return Coefficients(scheme.arity, scheme.start, tuple(map(literal, scheme.coefficients)))


def spell(body: Coefficients | Symbol) -> list[str]:
    """The lines of the [mask] table."""
    return ["[mask]", *spelled_entries(body)]


def spelled_entries(body: Coefficients | Symbol) -> list[str]:
    """The lines for the keys of [mask], or of a factor of a tensor product."""
    lines = [f"arity = {body.arity}"]
    if isinstance(body, Coefficients):
        return [*lines, f"start = {body.start}", *listed("coefficients", map(number, body.entries))]
    return [*lines, f"symbol = {quoted(body.expression.text)}"]


def canonical(scheme: ScalarScheme) -> Mapping[str, Any]:
    """The mask as certificates embed it, in one spelling, so that two masks are the same iff these are equal."""
    return {
        "kind": scheme.kind,
        "arity": scheme.arity,
        "start": scheme.start,
        "coefficients": [rational(c) for c in scheme.coefficients],
    }
