"""Closed forms in expectations: numbers, logarithms to one base gathered into one `Log`, roots, and their order.

A logarithm of a root of a polynomial is one `RootLog`; it is divided, and its root multiplied, by numbers;
an integer may be added. Which root
is meant is decided without floats and without floating algebra, by Vincent, Collins & Akritas: the roots of f in (0, 1)
are at most as many as (1+t)^n f(1/(1+t)) has changes of sign (Descartes), and where that is 0 or 1 exactly as many;
otherwise the interval is halved.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.expressions import evaluate
from subdiv_cli.maskfile.grammar import ROOT_FORM, parse
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.nodes import Logarithm, Name, Node, Number, Product, RootOf, Sum
from subdiv_cli.maskfile.problems import Fault, shown_number
from subdiv_cli.model.closed import (
    MAX_LOG_BASE,
    MAX_LOG_BITS,
    MAX_LOG_DIVISOR,
    MAX_ROOT_BITS,
    MAX_ROOT_DEGREE,
    FiniteForm,
    Log,
    Root,
    RootLog,
    logarithm,
    multiplied,
    plus,
    unpowered,
)

_MOST_PIECES = 64
"""The most intervals that are looked at: those around a multiple root would never end."""


def roots_between(coefficients: Sequence[int], low: Fraction, high: Fraction) -> int | None:
    """The number of different roots of a polynomial, lowest power first, in [low, high]; None where it is unclear."""
    if low == high:
        return int(not _shifted(coefficients, low, Fraction(0))[0])
    waiting = [_shifted(coefficients, low, high - low)]
    count = int(not sum(waiting[0]))  # at high
    for _ in range(_MOST_PIECES):
        if not waiting:
            return count
        f = waiting.pop()
        if not f[0]:
            count += 1
            while not f[0]:
                f = f[1:]
        if (changes := _changes(_shifted(f[::-1], Fraction(1), Fraction(1)))) > 1:
            half = [c << (len(f) - 1 - i) for i, c in enumerate(f)]
            waiting += [half, _shifted(half, Fraction(1), Fraction(1))]
        else:
            count += changes
    return None


def _shifted(f: Sequence[int], start: Fraction, length: Fraction) -> list[int]:
    """The polynomial f(start + length t) times a positive integer, by Horner's rule."""
    unit = start.denominator * length.denominator
    a, b = int(start * unit), int(length * unit)
    result, power = [f[-1]], 1
    for c in reversed(f[:-1]):
        power *= unit
        scaled = [a * x for x in result] + [0]
        for i, x in enumerate(result):
            scaled[i + 1] += b * x
        scaled[0] += c * power
        result = scaled
    return result


def _changes(f: Sequence[int]) -> int:
    signs = [c > 0 for c in f if c]
    return sum(x is not y for x, y in pairwise(signs))


def inverse(root: Root) -> Root:
    """The root 1/x for a root x, whose bounds have one sign."""
    ends = sorted((1 / root.low, 1 / root.high))
    return Root(root.coefficients[::-1], ends[0], ends[1])


_GRID = 16
"""The denominator of the grid on which logarithms are enclosed: enough for comparing multiples of their divisor."""
_LOG = f"write log2(64/9) or -log2({ROOT_FORM})"

_Value = FiniteForm | Root


def read_closed_form(text: str, at: int = 0) -> FiniteForm:
    """The exact value of `2`, `1.99`, `log2(64/9)`, `2 - log2(3)`, `-log2(root(x^2-x-1, 1.61, 1.62))/2`. Raises Fault.

    Values without roots come in canonical form.
    """
    value = _value(parse(text, (), logarithms=True, at=at))
    if isinstance(value, Root):
        raise Fault(faults.BAD_EXPECTATION, "a root is no exponent, its logarithm is", f"write -log2({ROOT_FORM})", at)
    return value._replace(text=text.strip()) if isinstance(value, RootLog) else value


def _value(node: Node) -> _Value:
    if isinstance(node, Number):
        return _bounded(node.value, node.at)
    if isinstance(node, Logarithm):
        return _logarithm(node)
    if isinstance(node, RootOf):
        return _root(node)
    if isinstance(node, Sum):
        return _sum(node)
    if isinstance(node, Product):
        return _product(node)
    assert not isinstance(node, Name), "expectations have no names"
    return _power(_rational(_value(node.base), "a power", node.at), node.exponent, node.at)


def _sum(node: Sum) -> _Value:
    result: _Value = Fraction(0)
    for sign, term in node.terms:
        value = _times(_value(term), Fraction(sign), node.at)
        result = _plus(result, value, node.at) if len(node.terms) > 1 else value
    return result


def _product(node: Product) -> _Value:
    result: _Value = Fraction(1)
    for factor in node.factors:
        value = _value(factor.node)
        if factor.divides:
            if isinstance(value, Root):
                value = inverse(value)
            else:
                divisor = _rational(value, "a quotient", factor.at)
                if not divisor:
                    raise Fault(faults.BAD_NUMBER, "division by zero", "write a divisor that is not zero", factor.at)
                value = 1 / divisor
        if isinstance(result, Fraction):
            result = _times(value, result, factor.at)
        else:
            result = _times(result, _rational(value, "a product", factor.at), factor.at)
    return result


def _rational(value: _Value, what: str, at: int) -> Fraction:
    """The value, which must be a number. Raises Fault for another."""
    if isinstance(value, Fraction):
        return value
    name = "roots" if isinstance(value, Root) else "logarithms"
    raise Fault(faults.BAD_EXPECTATION, f"{what} of {name} is no closed form", _LOG, at)


def _root(node: RootOf) -> _Value:
    """The root of a polynomial between two bounds, as a number where the polynomial is of degree 1."""
    low, high = (_rational(_value(end), "a bound", end.at) for end in (node.low, node.high))
    if low > high or low <= 0 <= high:
        help = f"write the smaller one first, both of one sign: {ROOT_FORM}"
        raise Fault(
            faults.BAD_EXPECTATION,
            f"{shown_number(low)} and {shown_number(high)} are no bounds of a root",
            help,
            node.low.at,
        )
    numerators = evaluate(node.polynomial, {}, Work()).numerators
    first, last = min(numerators, default=0), max(numerators, default=0)
    coefficients = tuple(numerators.get(k, 0) for k in range(first, min(last, first + MAX_ROOT_DEGREE) + 1))
    if last - first > MAX_ROOT_DEGREE or max(map(int.bit_length, coefficients)) > MAX_ROOT_BITS:
        message = f"the polynomial of a root is too large; the limit is degree {MAX_ROOT_DEGREE}"
        raise Fault(
            faults.OUT_OF_BOUNDS, message, "write its irreducible factor, the minimal polynomial", node.polynomial.at
        )
    count = roots_between(coefficients, low, high) if len(coefficients) > 1 else 0
    if count != 1:
        what = {0: "no root", None: "more than one root, or a multiple one,"}.get(count, f"{count} roots")
        message = f"the polynomial has {what} between {shown_number(low)} and {shown_number(high)}"
        help = f"write bounds between which it has one simple root: {ROOT_FORM}"
        raise Fault(faults.BAD_EXPECTATION, message, help, node.polynomial.at)
    return Fraction(-coefficients[0], coefficients[1]) if len(coefficients) == 2 else Root(coefficients, low, high)


def _logarithm(node: Logarithm) -> FiniteForm:
    argument = _value(node.argument)
    if not 2 <= node.base <= MAX_LOG_BASE:
        raise Fault(
            faults.BAD_EXPECTATION, f"the base of a logarithm must be 2 to {MAX_LOG_BASE}", "write log2(64/9)", node.at
        )
    if isinstance(argument, Log | RootLog):
        raise Fault(faults.BAD_EXPECTATION, "a logarithm of a logarithm is no closed form", _LOG, node.at)
    if (argument.low if isinstance(argument, Root) else argument) <= 0:
        raise Fault(faults.BAD_EXPECTATION, "the argument of a logarithm must be positive", _LOG, node.at)
    if isinstance(argument, Root):
        base, divisor = unpowered(node.base, 1)
        return RootLog(base, inverse(argument), divisor, "")
    return logarithm(node.base, argument)


def _bounded(value: Fraction, at: int) -> Fraction:
    if max(value.numerator.bit_length(), value.denominator.bit_length()) > MAX_LOG_BITS:
        message = f"the expected number is too long; the limit is {MAX_LOG_BITS} bits"
        raise Fault(faults.OUT_OF_BOUNDS, message, "use a shorter number", at)
    return value


def _power(base: Fraction, exponent: int, at: int) -> Fraction:
    """The power base^exponent, its size bounded before it is computed."""
    if not base and exponent < 0:
        raise Fault(faults.BAD_NUMBER, "division by zero", "write a divisor that is not zero", at)
    bits = max(abs(base.numerator).bit_length(), base.denominator.bit_length()) - 1
    if bits * abs(exponent) > MAX_LOG_BITS:
        message = f"the expected number is too long; the limit is {MAX_LOG_BITS} bits"
        raise Fault(faults.OUT_OF_BOUNDS, message, "use a smaller power", at)
    return _bounded(Fraction(base**exponent), at)


def _times(x: _Value, factor: Fraction, at: int) -> _Value:
    if isinstance(x, Fraction):
        return _bounded(x * factor, at)
    if isinstance(x, Root):
        return multiplied(x, factor) if factor else factor
    divisor = x.divisor * factor.denominator
    if divisor > MAX_LOG_DIVISOR:
        raise Fault(
            faults.OUT_OF_BOUNDS, f"the divisor of a logarithm is beyond {MAX_LOG_DIVISOR}", "use a smaller divisor", at
        )
    if isinstance(x, RootLog):
        if abs(factor.numerator) != 1:
            help = "divide it by integers, and write multiples as a logarithm of another root"
            raise Fault(faults.BAD_EXPECTATION, "a multiple of the logarithm of a root is no closed form", help, at)
        return x._replace(root=x.root if factor > 0 else inverse(x.root), divisor=divisor)
    return logarithm(x.base, _power(x.argument, factor.numerator, at), divisor)


def _plus(x: _Value, y: _Value, at: int) -> _Value:
    if isinstance(x, Fraction) and isinstance(y, Fraction):
        return _bounded(x + y, at)
    if isinstance(x, Fraction):
        x, y = y, x
    if isinstance(x, RootLog) and isinstance(y, Fraction) and y.denominator == 1:
        _power(Fraction(x.base), abs(y.numerator) * x.divisor, at)
        return plus(x, int(y))
    if isinstance(x, Root | RootLog) or isinstance(y, Root | RootLog):
        raise Fault(faults.BAD_EXPECTATION, "a sum with a root in it is no closed form", _LOG, at)
    assert isinstance(x, Log)
    if isinstance(y, Fraction):  # y = log_base(base^numerator) / denominator
        y = Log(base=x.base, argument=_power(Fraction(x.base), y.numerator, at), divisor=y.denominator)
    if x.base != y.base:
        raise Fault(
            faults.BAD_EXPECTATION, "logarithms to different bases cannot be added", "use one base, or an interval", at
        )
    if x.divisor * y.divisor > MAX_LOG_DIVISOR:
        raise Fault(
            faults.OUT_OF_BOUNDS, f"the divisor of a logarithm is beyond {MAX_LOG_DIVISOR}", "use a smaller divisor", at
        )
    argument = _bounded(_power(x.argument, y.divisor, at) * _power(y.argument, x.divisor, at), at)
    return logarithm(x.base, argument, x.divisor * y.divisor)


def certainly_less(x: FiniteForm, y: FiniteForm) -> bool:
    """Whether x < y, where that is seen exactly: both rational, one base, or apart on a grid; False is unknown."""
    if isinstance(x, Fraction) and isinstance(y, Fraction):
        return x < y
    if isinstance(x, Log) and isinstance(y, Log) and x.base == y.base:
        return bool(x.argument**y.divisor < y.argument**x.divisor)
    return _enclosure(x)[1] <= _enclosure(y)[0]


def _enclosure(x: FiniteForm) -> tuple[Fraction, Fraction]:
    """The bounds lower < x < upper for an irrational logarithm; x itself twice for a number."""
    if isinstance(x, Fraction):
        return x, x
    if isinstance(x, RootLog):
        ends = (logarithm(x.base, 1 / end, x.divisor) for end in (x.root.high, x.root.low))
        (least, _), (_, most) = map(_enclosure, ends)
        return least, most
    argument = x.argument**_GRID
    low, high = -1, 1
    while Fraction(x.base) ** low > argument:
        low *= 2
    while Fraction(x.base) ** high < argument:
        high *= 2
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if Fraction(x.base) ** middle < argument else (low, middle)
    return Fraction(low, _GRID * x.divisor), Fraction(high, _GRID * x.divisor)
