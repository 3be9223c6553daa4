"""The trees of expressions."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction


class _Node:
    """A node of a tree, never changed: equal to another of its class with the same content, wherever each stands."""

    __slots__ = ("at",)

    at: int
    """The offset in the text at which it starts."""

    def _content(self) -> tuple[object, ...]:
        return tuple(getattr(self, name) for name in self.__slots__)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Node) and type(self) is type(other) and self._content() == other._content()

    def __hash__(self) -> int:
        return hash((type(self), self._content()))

    def __repr__(self) -> str:
        return f"{type(self).__name__}{self._content()}"


class Number(_Node):
    """A number."""

    __slots__ = ("value",)

    def __init__(self, value: Fraction, at: int = 0) -> None:
        self.value, self.at = value, at


class Name(_Node):
    """A parameter, or the variable z."""

    __slots__ = ("name",)

    def __init__(self, name: str, at: int = 0) -> None:
        self.name, self.at = name, at


class Sum(_Node):
    """A sum of terms with their signs, 1 or -1; a negation is a sum of one term."""

    __slots__ = ("terms",)

    def __init__(self, terms: tuple[tuple[int, Node], ...], at: int = 0) -> None:
        self.terms, self.at = terms, at


class Factor(_Node):
    """A factor of a product, or a divisor."""

    __slots__ = ("divides", "node")

    def __init__(self, node: Node, divides: bool = False, at: int = 0) -> None:
        self.node, self.divides, self.at = node, divides, at


class Product(_Node):
    """A product of factors and divisors."""

    __slots__ = ("factors",)

    def __init__(self, factors: tuple[Factor, ...], at: int = 0) -> None:
        self.factors, self.at = factors, at


class Power(_Node):
    """A power with an integer exponent."""

    __slots__ = ("base", "exponent")

    def __init__(self, base: Node, exponent: int, at: int = 0) -> None:
        self.base, self.exponent, self.at = base, exponent, at


class Logarithm(_Node):
    """A logarithm log_base(argument), in expectations only."""

    __slots__ = ("argument", "base")

    def __init__(self, base: int, argument: Node, at: int = 0) -> None:
        self.base, self.argument, self.at = base, argument, at


class RootOf(_Node):
    """A root of a polynomial in z between two bounds, in expectations only."""

    __slots__ = ("high", "low", "polynomial")

    def __init__(self, polynomial: Node, low: Node, high: Node, at: int = 0) -> None:
        self.polynomial, self.low, self.high, self.at = polynomial, low, high, at


Node = Number | Name | Sum | Product | Power | Logarithm | RootOf

_SHORT = 128
"""The most bits of numbers that are multiplied as they are read."""


def product_of(factors: Sequence[Factor], at: int) -> Node:
    """The product of these factors; a quotient of short numbers, as most coefficients are, is a number at once."""
    numerator = denominator = 1
    for factor in factors:
        if not isinstance(factor.node, Number):
            return Product(tuple(factors), at)
        n, d = factor.node.value.as_integer_ratio()
        if factor.divides:
            n, d = d, n
        numerator, denominator = numerator * n, denominator * d
        if not d or max(numerator.bit_length(), denominator.bit_length()) > _SHORT:
            return Product(tuple(factors), at)
    return Number(Fraction(numerator, denominator), at)
