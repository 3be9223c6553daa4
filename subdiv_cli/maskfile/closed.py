"""Closed forms in expectations: numbers and logarithms to one base, gathered into one `Log`, and their order."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.maskfile.bounds import MAX_LOG_BASE, MAX_LOG_BITS, MAX_LOG_DIVISOR
from subdiv_cli.maskfile.grammar import Logarithm, Name, Node, Number, Product, Sum, parse
from subdiv_cli.maskfile.problems import Fault
from subdiv_cli.model import Log, LogForm, logarithm

_GRID = 16
"""Logarithms are enclosed to 1/16 of their divisor: enough for every comparison with a multiple of that."""


def read_closed_form(text: str, at: int = 0) -> LogForm:
    """`2`, `1.99`, `log2(64/9)`, `log3(11)/2`, `2 - log2(3)`, exactly and in canonical form. Raises Fault."""
    return _value(parse(text, (), logarithms=True, at=at))


def _value(node: Node) -> LogForm:
    if isinstance(node, Number):
        return _bounded(node.value, node.at)
    if isinstance(node, Logarithm):
        return _logarithm(node)
    if isinstance(node, Sum):
        result: LogForm = Fraction(0)
        for sign, term in node.terms:
            result = _plus(result, _times(_value(term), Fraction(sign), node.at), node.at)
        return result
    if isinstance(node, Product):
        return _product(node)
    assert not isinstance(node, Name), "expectations have no names"
    base = _value(node.base)
    if not isinstance(base, Fraction):
        raise Fault("SD012", "a power of a logarithm is no closed form", "write it as log2(64/9)", node.at)
    return _power(base, node.exponent, node.at)


def _product(node: Product) -> LogForm:
    result: LogForm = Fraction(1)
    for factor in node.factors:
        value = _value(factor.node)
        if factor.divides:
            if not isinstance(value, Fraction):
                mend = "logarithms are added and multiplied by numbers; write log2(9)/log2(3) as a number"
                raise Fault("SD012", "a quotient by a logarithm is no closed form", mend, factor.at)
            if not value:
                raise Fault("SD007", "division by zero", "write a divisor that is not zero", factor.at)
            value = 1 / value
        if isinstance(result, Fraction):
            result = _times(value, result, factor.at)
        elif isinstance(value, Fraction):
            result = _times(result, value, factor.at)
        else:
            raise Fault("SD012", "a product of logarithms is no closed form", "write it as log2(64/9)", factor.at)
    return result


def _logarithm(node: Logarithm) -> LogForm:
    argument = _value(node.argument)
    if not 2 <= node.base <= MAX_LOG_BASE:
        raise Fault("SD012", f"the base of a logarithm must be 2 to {MAX_LOG_BASE}", "write log2(64/9)", node.at)
    if not isinstance(argument, Fraction):
        raise Fault("SD012", "a logarithm of a logarithm is no closed form", "write log2(64/9)", node.at)
    if argument <= 0:
        raise Fault("SD012", "the argument of a logarithm must be positive", "write log2(64/9)", node.at)
    return logarithm(node.base, argument)


def _bounded(value: Fraction, at: int) -> Fraction:
    if max(value.numerator.bit_length(), value.denominator.bit_length()) > MAX_LOG_BITS:
        message = f"the expected number is too long; the limit is {MAX_LOG_BITS} bits"
        raise Fault("SD010", message, "use a shorter number", at)
    return value


def _power(base: Fraction, exponent: int, at: int) -> Fraction:
    """base^exponent, its size bounded before it is computed."""
    if not base and exponent < 0:
        raise Fault("SD007", "division by zero", "write a divisor that is not zero", at)
    bits = max(abs(base.numerator).bit_length(), base.denominator.bit_length()) - 1
    if bits * abs(exponent) > MAX_LOG_BITS:
        message = f"the expected number is too long; the limit is {MAX_LOG_BITS} bits"
        raise Fault("SD010", message, "use a smaller power", at)
    return _bounded(Fraction(base**exponent), at)


def _times(x: LogForm, factor: Fraction, at: int) -> LogForm:
    if isinstance(x, Fraction):
        return _bounded(x * factor, at)
    divisor = x.divisor * factor.denominator
    if divisor > MAX_LOG_DIVISOR:
        raise Fault("SD010", f"the divisor of a logarithm is beyond {MAX_LOG_DIVISOR}", "use a smaller divisor", at)
    return logarithm(x.base, _power(x.argument, factor.numerator, at), divisor)


def _plus(x: LogForm, y: LogForm, at: int) -> LogForm:
    if isinstance(x, Fraction) and isinstance(y, Fraction):
        return _bounded(x + y, at)
    if isinstance(x, Fraction):
        x, y = y, x
    assert isinstance(x, Log)
    if isinstance(y, Fraction):  # y = log_base(base^numerator) / denominator
        y = Log(base=x.base, argument=_power(Fraction(x.base), y.numerator, at), divisor=y.denominator)
    if x.base != y.base:
        raise Fault("SD012", "logarithms to different bases cannot be added", "use one base, or an interval", at)
    if x.divisor * y.divisor > MAX_LOG_DIVISOR:
        raise Fault("SD010", f"the divisor of a logarithm is beyond {MAX_LOG_DIVISOR}", "use a smaller divisor", at)
    argument = _bounded(_power(x.argument, y.divisor, at) * _power(y.argument, x.divisor, at), at)
    return logarithm(x.base, argument, x.divisor * y.divisor)


def certainly_less(x: LogForm, y: LogForm) -> bool:
    """Whether x < y, where that is seen exactly: both rational, one base, or apart on a grid; False is unknown."""
    if isinstance(x, Fraction) and isinstance(y, Fraction):
        return x < y
    if isinstance(x, Log) and isinstance(y, Log) and x.base == y.base:
        return bool(x.argument**y.divisor < y.argument**x.divisor)
    return _enclosure(x)[1] <= _enclosure(y)[0]


def _enclosure(x: LogForm) -> tuple[Fraction, Fraction]:
    """lower < x < upper for an irrational logarithm; x itself twice for a number."""
    if isinstance(x, Fraction):
        return x, x
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
