"""What [mask] says, as data: the forms of a scalar mask, and what the forms of every kind can do."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from math import lcm
from typing import TYPE_CHECKING, NamedTuple, Protocol

from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_BITS, MAX_DIGITS, MAX_EXPONENT, MAX_MASK_LENGTH
from subdiv_cli.maskfile.evaluate import is_fixed
from subdiv_cli.maskfile.expressions import Expression, number_of, polynomial_of
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath

if TYPE_CHECKING:
    from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme

    Scheme = ScalarScheme | MultivariateScheme


class Body(Protocol):
    """What [mask] says, not yet at values of the parameters."""

    def expressions(self) -> Iterable[Expression]:
        """All the expressions in it."""

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> Scheme | None:
        """The scheme at these values of the parameters; None where something is wrong, which is recorded."""


class Coefficients(NamedTuple):
    """a_start, a_(start+1), …, one expression without z each; at least one."""

    arity: int
    start: int
    entries: tuple[Expression, ...]

    def expressions(self) -> Iterable[Expression]:
        return self.entries

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> ScalarScheme | None:
        """The scheme at these values; what is wrong with a number, or with the mask, is recorded."""
        numbers = [number_of(entry, values, problems, work) for entry in self.entries]
        if None in numbers:
            return None
        found = {k: value for k, value in enumerate(numbers, self.start) if value}
        return _scheme(self.arity, found, self.entries[0].path[:-1], values, problems)


class Symbol(NamedTuple):
    """a(z) = Σ a_k z^k as one expression in z."""

    arity: int
    expression: Expression

    def expressions(self) -> Iterable[Expression]:
        return (self.expression,)

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> ScalarScheme | None:
        """The scheme at these values; what is wrong with a number, or with the mask, is recorded."""
        polynomial = polynomial_of(self.expression, values, problems, work)
        if polynomial is None:
            return None
        return _scheme(self.arity, polynomial.coefficients, self.expression.path, values, problems)


def check_fixed_mask(body: Body, problems: Collector) -> None:
    """Records what is wrong with the scheme of a mask that does not hang on parameters."""
    if all(is_fixed(entry.node) for entry in body.expressions()):
        body.scheme({}, problems, Work())


def _scheme(
    arity: int, coefficients: Mapping[int, Fraction], path: KeyPath, values: Mapping[str, Fraction], problems: Collector
) -> ScalarScheme | None:
    """The scheme of coefficients by their exponents; None where they make none, which is recorded."""
    fault = zero_mask(values) if not coefficients else _too_long(coefficients) or too_precise(coefficients.values())
    if fault:
        problems.add(fault, path)
        return None
    start = min(coefficients)
    dense = tuple(coefficients.get(k, Fraction(0)) for k in range(start, max(coefficients) + 1))
    return ScalarScheme(arity=arity, start=start, coefficients=dense)


def zero_mask(values: Mapping[str, Fraction]) -> Fault:
    """The fault of a mask whose coefficients are all zero at these values of the parameters."""
    help = "at least one coefficient must not be zero" + ("; try other parameters" if values else "")
    return Fault(faults.ZERO_MASK, "all coefficients of the mask are zero", help)


def _too_long(coefficients: Mapping[int, Fraction]) -> Fault | None:
    """The fault of coefficients that reach too far; None where they do not."""
    first, last = min(coefficients), max(coefficients)
    if last - first >= MAX_MASK_LENGTH:
        message = f"the mask has {last - first + 1} coefficients; the limit is {MAX_MASK_LENGTH}"
        return Fault(faults.OUT_OF_BOUNDS, message, "use a shorter mask")
    if max(-first, last) > 2 * MAX_EXPONENT:
        return Fault(faults.OUT_OF_BOUNDS, f"an index beyond {2 * MAX_EXPONENT}", "shift the mask towards 0")
    return None


def too_precise(coefficients: Iterable[Fraction]) -> Fault | None:
    """The fault of coefficients with a common denominator that is too long; None where it is not."""
    common = 1
    for c in coefficients:
        common = lcm(common, c.denominator)
        if common.bit_length() > MAX_BITS:
            message = f"the coefficients' common denominator has more than {MAX_DIGITS} digits"
            return Fault(faults.OUT_OF_BOUNDS, message, "use fractions with smaller denominators")
    return None
