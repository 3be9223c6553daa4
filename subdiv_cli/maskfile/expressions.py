"""Expressions in mask files, and their values at those of parameters: Laurent polynomials over Q."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from subdiv_cli.maskfile import laurent
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.grammar import parse
from subdiv_cli.maskfile.laurent import VARIABLES, BoundedLaurent, TooLargeError, Work, packed
from subdiv_cli.maskfile.nodes import Logarithm, Name, Node, Number, Power, Product, RootOf, Sum
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath, shown, shown_number

_MONOMIALS = {name: BoundedLaurent({packed([0] * i + [1]): 1}) for i, name in enumerate(VARIABLES)}


def names_in(node: Node) -> frozenset[str]:
    """The names that stand in an expression, variables among them."""
    if isinstance(node, Name):
        return frozenset({node.name})
    if isinstance(node, Number):
        return frozenset()
    if isinstance(node, Sum):
        return frozenset().union(*(names_in(term) for _, term in node.terms))
    if isinstance(node, Product):
        return frozenset().union(*(names_in(factor.node) for factor in node.factors))
    assert not isinstance(node, Logarithm | RootOf), "these stand in expectations only"
    return names_in(node.base)


def is_fixed(node: Node) -> bool:
    """Whether an expression is without parameters."""
    return names_in(node) <= _MONOMIALS.keys()


def evaluate(node: Node, values: Mapping[str, Fraction], work: Work) -> BoundedLaurent:
    """The Laurent polynomial of an expression; `values` has every name in it but the variables.

    Raises Fault at the offending subexpression: SD007 or SD011 for a zero divisor, SD008 for a division that is not
    exact, SD010 for sizes. Raises KeyError for a name without a value.
    """
    try:
        if isinstance(node, Number):
            return laurent.constant(node.value)
        if isinstance(node, Name):
            return _MONOMIALS.get(node.name) or laurent.constant(values[node.name])
        if isinstance(node, Sum):
            return laurent.total([(sign, evaluate(term, values, work)) for sign, term in node.terms], work)
        if isinstance(node, Product):
            return _product(node, values, work)
        if isinstance(node, Power):
            return _power(node, values, work)
    except TooLargeError as error:
        raise Fault(
            faults.OUT_OF_BOUNDS, f"the expression is too large: {error}", "use smaller powers and numbers", node.at
        ) from None
    raise AssertionError(f"{type(node).__name__} has no value as a Laurent polynomial")


def _product(node: Product, values: Mapping[str, Fraction], work: Work) -> BoundedLaurent:
    """The value of a product: what multiplies comes first, then what divides; (1+z)^2/(1-z) (1-z) has a value."""
    result = laurent.constant(Fraction(1))
    divisors = []
    for factor in node.factors:
        divides, base = factor.divides, factor.node
        if isinstance(base, Power) and base.exponent < 0:
            divides = not divides
            value = laurent.power(_nonzero(base.base, factor.at, values, work), -base.exponent, work)
        else:
            value = _nonzero(base, factor.at, values, work) if divides else evaluate(base, values, work)
        if not divides:
            result = laurent.times(result, value, work)
        elif (inverse := laurent.inverse(value)) is not None:
            result = laurent.times(result, inverse, work)
        else:
            divisors.append((value, factor.at))
    for divisor, at in divisors:
        result = _quotient(result, divisor, at, work)
    return result


def _power(node: Power, values: Mapping[str, Fraction], work: Work) -> BoundedLaurent:
    if node.exponent >= 0:
        return laurent.power(evaluate(node.base, values, work), node.exponent, work)
    base = _nonzero(node.base, node.at, values, work)
    if (inverse := laurent.inverse(base)) is None:
        return _quotient(laurent.constant(Fraction(1)), base, node.at, work)
    return laurent.power(inverse, -node.exponent, work)


def _quotient(a: BoundedLaurent, divisor: BoundedLaurent, at: int, work: Work) -> BoundedLaurent:
    """The quotient. Raises Fault where there is a remainder."""
    if (result := laurent.quotient(a, divisor, work)) is not None:
        return result
    small, large = laurent.spelled(divisor) or "this divisor", laurent.spelled(a) or "what stands before it"
    help = "divide by numbers, parameters, powers of z and polynomials that leave no remainder"
    raise Fault(faults.BAD_EXPRESSION, f"{small} does not divide {large} exactly", help, at)


def _nonzero(node: Node, at: int, values: Mapping[str, Fraction], work: Work) -> BoundedLaurent:
    """The value of a divisor. Raises Fault for zero."""
    divisor = evaluate(node, values, work)
    if divisor.numerators:
        return divisor
    names = sorted(names_in(node) & values.keys())
    if not names:
        raise Fault(faults.BAD_NUMBER, "division by zero", "write a divisor that is not zero", at)
    given = ", ".join(f"{shown(name)} = {shown_number(values[name])}" for name in names)
    help = f"give it another value: -p {shown(names[0])}=1/16"
    raise Fault(faults.BAD_PARAMETER, f"division by zero where {given}", help, at)


class Expression:
    """An exact number or expression as the file spells it, and its tree; equal to another wherever each stands."""

    __slots__ = ("node", "path", "text")

    def __init__(self, *, text: str, node: Node, path: KeyPath = ()) -> None:
        self.text, self.node, self.path = text, node, path

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Expression) and (self.text, self.node) == (other.text, other.node)

    def __hash__(self) -> int:
        return hash((self.text, self.node))


def number_of(
    expression: Expression, values: Mapping[str, Fraction], problems: Collector, work: Work
) -> Fraction | None:
    """The value of an expression without variables; None where it has none, which is recorded here or was before."""
    if isinstance(expression.node, Number):
        return expression.node.value
    polynomial = polynomial_of(expression, values, problems, work)
    if polynomial is None:
        return None
    value = polynomial.constant()
    assert value is not None, "variables are refused when coefficients are read"
    return value


def polynomial_of(
    expression: Expression, values: Mapping[str, Fraction], problems: Collector, work: Work
) -> BoundedLaurent | None:
    """The Laurent polynomial of a symbol; None where it has no value, as in `number_of`."""
    try:
        return evaluate(expression.node, values, work)
    except Fault as fault:
        problems.add(fault, expression.path)
    except KeyError:  # a parameter without a value, which is reported where it is declared
        pass
    return None


def literal(value: Fraction) -> Expression:
    """The expression of a number as str spells it."""
    return Expression(text=str(value), node=parse(str(value), ()))
