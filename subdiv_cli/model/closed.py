"""Real numbers in closed form, as data: rationals, logarithms of rationals, logarithms of algebraic numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from fractions import Fraction
from typing import Any, NamedTuple, TypeVar

_Number = TypeVar("_Number", int, Fraction)


class Log(NamedTuple):
    """The real number log_base(argument) / divisor, as closed forms print it."""

    base: int
    """The base, at least 2."""
    argument: Fraction
    """The argument, positive."""
    divisor: int = 1
    """The divisor, at least 1."""

    def __str__(self) -> str:
        return f"log{self.base}({self.argument})" + (f"/{self.divisor}" if self.divisor > 1 else "")


class Root(NamedTuple):
    """A real algebraic number: the only real root of a polynomial in [low, high]."""

    coefficients: tuple[int, ...]
    """The coefficients of the polynomial, the lowest power first; degree at least 1."""
    low: Fraction
    high: Fraction


class RootLog(NamedTuple):
    """The real number -log_base(root) / divisor, root > 0."""

    base: int
    root: Root
    divisor: int
    text: str
    """The spelling: `-log2(root(32*x^3+4*x-1, 0.1927, 0.1928))/2`."""

    def __str__(self) -> str:
        return self.text


INFINITY = math.inf
"""The exponent and the order of smoothness of polynomials; there is no other float among closed forms."""
LogForm = Fraction | Log
"""A closed form without roots: `2`, `log2(64/9)`."""
FiniteForm = LogForm | RootLog
ClosedForm = FiniteForm | float
"""An exponent known exactly: `2`, `log2(64/9)`, `log3(11)/2`, `-log2(root(x^2-x-1, 1.6180, 1.6181))`, `infinity`."""

MAX_LOG_BASE = 1024
MAX_LOG_DIVISOR = 256
MAX_LOG_BITS = 1024
"""The most bits of the numbers of a closed form that is read or printed."""
MAX_ROOT_BITS = 3322
"""The most bits of the coefficients of a root's polynomial: a thousand digits."""
MAX_ROOT_DEGREE = 64
_LONGEST_BRIEF = 24
"""The most characters of a closed form that is read at a glance."""


def spelled(x: ClosedForm) -> str | None:
    """A closed form as text that expectations read again; None for one that is beyond the bounds of their grammar."""
    if x == INFINITY:
        return "infinity"
    if isinstance(x, RootLog):
        bits = max(abs(c).bit_length() for c in x.root.coefficients)
        long = bits > MAX_ROOT_BITS or len(x.root.coefficients) > MAX_ROOT_DEGREE + 1 or x.divisor > MAX_LOG_DIVISOR
    else:
        parts = (x.argument if isinstance(x, Log) else x).as_integer_ratio()
        bits = max(abs(part).bit_length() for part in parts)
        long = bits > MAX_LOG_BITS or (isinstance(x, Log) and x.divisor > MAX_LOG_DIVISOR)
    return None if long else str(x)


def is_brief(text: str) -> bool:
    """Whether a closed form is read at a glance, and stands before its digits: `log2(64/9)`, but no `root(…)`."""
    return "root(" not in text and len(text) <= _LONGEST_BRIEF


def root_log_text(base: int, polynomial: str, low: str, high: str, divisor: int) -> str:
    """The logarithm of a root as text: `-log2(root(32*x^3+4*x-1, 0.1927, 0.1928))/2`."""
    return f"-log{base}(root({polynomial}, {low}, {high}))" + (f"/{divisor}" if divisor > 1 else "")


def spelled_terms(
    terms: Iterable[tuple[int, _Number]], variable: str, times: str, show: Callable[[_Number], str]
) -> str:
    """The sum of coefficients with their powers as text, without those that are 0: `81*x^2-27*x+1`."""
    text = ""
    for exponent, c in terms:
        if not c:
            continue
        power = "" if exponent == 0 else variable if exponent == 1 else f"{variable}^{exponent}"
        size = "" if power and abs(c) == 1 else show(abs(c))
        sign = ("-" if c < 0 else "") if not text else "-" if c < 0 else "+"
        text += sign + size + (times if size and power else "") + power
    return text


def logarithm(base: int, argument: Fraction, divisor: int = 1) -> LogForm:
    """The number log_base(argument) / divisor in canonical form, so that equal numbers are equal objects.

    The base is no perfect power, argument and divisor share no root, and a rational value is a Fraction. Raises
    ValueError for base < 2, argument <= 0 or divisor < 1.
    """
    if base < 2 or argument <= 0 or divisor < 1:
        raise ValueError(f"no logarithm: base {base}, argument {argument}, divisor {divisor}")
    if argument == 1:
        return Fraction(0)
    base, divisor = unpowered(base, divisor)
    for d in (d for d in range(divisor, 1, -1) if divisor % d == 0):
        numerator = exact_root(argument.numerator, d)
        denominator = exact_root(argument.denominator, d) if numerator is not None else None
        if numerator is not None and denominator is not None:
            argument, divisor = Fraction(numerator, denominator), divisor // d
            break
    power = max(argument.numerator, argument.denominator)
    exponent = _exact_log(power, base)
    if exponent is not None and min(argument.numerator, argument.denominator) == 1:
        return Fraction(exponent if argument > 1 else -exponent, divisor)
    return Log(base=base, argument=argument, divisor=divisor)


def plus(x: FiniteForm, n: int) -> FiniteForm:
    """The number x + n, n an integer: of a root that of the root times a power of the base, spelled as a sum."""
    if isinstance(x, Fraction):
        return x + n
    scale = Fraction(x.base) ** (-n * x.divisor)
    if isinstance(x, Log):
        return logarithm(x.base, x.argument / scale, x.divisor)
    return RootLog(x.base, multiplied(x.root, scale), x.divisor, f"{x.text}{n:+d}" if n else x.text)


def multiplied(root: Root, factor: Fraction) -> Root:
    """The root times a number that is not zero."""
    n = len(root.coefficients) - 1
    p, q = factor.as_integer_ratio()
    coefficients = [c * q**i * p ** (n - i) for i, c in enumerate(root.coefficients)]
    low, high = sorted((root.low * factor, root.high * factor))
    return Root(tuple(c // math.gcd(*coefficients) for c in coefficients), low, high)


def unpowered(base: int, divisor: int) -> tuple[int, int]:
    """The pair (b, d) with log_base(x)/divisor = log_b(x)/d for all x, b no perfect power."""
    for e in range(base.bit_length(), 1, -1):
        if (root := exact_root(base, e)) is not None:
            return root, divisor * e
    return base, divisor


def exact_root(n: int, d: int) -> int | None:
    """The integer m >= 1 with m^d = n >= 1, by Newton's method from above; None where there is none."""
    root = 1 << -(-n.bit_length() // d)
    while (lower := ((d - 1) * root + n // root ** (d - 1)) // d) < root:
        root = lower
    return root if root**d == n else None


def _exact_log(n: int, base: int) -> int | None:
    """The integer e with base^e = n; None where there is none."""
    e = 0
    while n > 1 and n % base == 0:
        n, e = n // base, e + 1
    return e if n == 1 else None


def rational(x: Fraction | int) -> str:
    """The text `p/q`, or `p` for an integer, of any length: Python itself refuses more than 4300 digits."""
    x = Fraction(x)
    return _integer_text(x.numerator) + ("" if x.denominator == 1 else f"/{_integer_text(x.denominator)}")


Nested = Fraction | int | tuple["Nested", ...]


def rationals(numbers: Nested) -> Any:
    """Nested tuples of rationals as nested lists of their texts, integers too."""
    return [rationals(x) for x in numbers] if isinstance(numbers, tuple) else rational(numbers)


def _integer_text(n: int) -> str:
    if n.bit_length() < 13_000:
        return str(n)
    if n < 0:
        return "-" + _integer_text(-n)
    half = n.bit_length() * 15 // 100
    high, low = divmod(n, 10**half)
    return _integer_text(high) + _integer_text(low).zfill(half)
