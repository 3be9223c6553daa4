"""Expression trees -> Laurent polynomials over Q, once parameters have values."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from subdiv_cli.maskfile import laurent
from subdiv_cli.maskfile.grammar import Factor, Name, Node, Number, Power, Product, Sum
from subdiv_cli.maskfile.laurent import Laurent, TooLargeError, Work
from subdiv_cli.maskfile.problems import Fault, shown, shown_number

_Z = Laurent({1: 1})


def names_in(node: Node) -> frozenset[str]:
    """The names that an expression speaks of, z among them."""
    if isinstance(node, Name):
        return frozenset({node.name})
    if isinstance(node, Number):
        return frozenset()
    if isinstance(node, Sum):
        return frozenset().union(*(names_in(term) for _, term in node.terms))
    if isinstance(node, Product):
        return frozenset().union(*(names_in(factor.node) for factor in node.factors))
    return names_in(node.base if isinstance(node, Power) else node.argument)


def evaluate(node: Node, values: Mapping[str, Fraction], work: Work) -> Laurent:
    """The Laurent polynomial of an expression; `values` has every name in it but z.

    Raises Fault at the offending subexpression: SD007 or SD011 for a zero divisor, SD008 for a quotient that is no
    Laurent polynomial, SD010 for sizes. Raises KeyError for a name without a value.
    """
    try:
        if isinstance(node, Number):
            return laurent.constant(node.value)
        if isinstance(node, Name):
            return _Z if node.name == "z" else laurent.constant(values[node.name])
        if isinstance(node, Sum):
            return laurent.total([(sign, evaluate(term, values, work)) for sign, term in node.terms], work)
        if isinstance(node, Product):
            return _product(node, values, work)
        if isinstance(node, Power):
            return _power(node, values, work)
    except TooLargeError as error:
        raise Fault(
            "SD010", f"the expression is too large: {error}", "use smaller powers and numbers", node.at
        ) from None
    raise AssertionError(f"{type(node).__name__} has no value as a Laurent polynomial")


def _product(node: Product, values: Mapping[str, Fraction], work: Work) -> Laurent:
    result = evaluate(node.factors[0].node, values, work)
    for factor in node.factors[1:]:
        value = evaluate(factor.node, values, work)
        result = laurent.times(result, _inverse(value, factor, values) if factor.divides else value, work)
    return result


def _power(node: Power, values: Mapping[str, Fraction], work: Work) -> Laurent:
    base = evaluate(node.base, values, work)
    if node.exponent < 0:
        base = _inverse(base, Factor(node.base, True, node.at), values)
    return laurent.power(base, abs(node.exponent), work)


def _inverse(divisor: Laurent, factor: Factor, values: Mapping[str, Fraction]) -> Laurent:
    if (result := laurent.inverse(divisor)) is not None:
        return result
    if divisor.numerators:
        mend = "divide by numbers, parameters and powers of z only"
        raise Fault("SD008", "this divisor makes it no Laurent polynomial", mend, factor.at)
    names = sorted(names_in(factor.node) & values.keys())
    if not names:
        raise Fault("SD007", "division by zero", "write a divisor that is not zero", factor.at)
    given = ", ".join(f"{shown(name)} = {shown_number(values[name])}" for name in names)
    raise Fault(
        "SD011", f"division by zero where {given}", f"give it another value: -p {shown(names[0])}=1/16", factor.at
    )
