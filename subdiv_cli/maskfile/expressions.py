"""Expressions where a mask file has numbers, and their values once parameters have theirs."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from subdiv_cli.maskfile.evaluate import evaluate
from subdiv_cli.maskfile.grammar import parse
from subdiv_cli.maskfile.laurent import Laurent, Work
from subdiv_cli.maskfile.nodes import Node, Number
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath


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
) -> Laurent | None:
    """The value of a symbol; None as for `number_of`."""
    try:
        return evaluate(expression.node, values, work)
    except Fault as fault:
        problems.add(fault, expression.path)
    except KeyError:  # a parameter without a value, which is reported where it is declared
        pass
    return None


def literal(value: Fraction) -> Expression:
    """A number as str spells it."""
    return Expression(text=str(value), node=parse(str(value), ()))
