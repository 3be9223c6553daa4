"""The forms of a multivariate mask as data, and the scheme of each at the values of the parameters."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from itertools import product
from math import prod
from typing import NamedTuple

from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.scalar.text import Coefficients, Symbol
from subdiv_cli.maskfile import laurent
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_INDEX, MAX_MASK_LENGTH
from subdiv_cli.maskfile.expressions import Expression, number_of, polynomial_of
from subdiv_cli.maskfile.laurent import BoundedLaurent, TooLargeError, Work, packed
from subdiv_cli.maskfile.mask import too_precise, zero_mask
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath
from subdiv_cli.spaces.lattice import Index, IntMatrix, multiple_of_identity

Nested = tuple["Expression | Nested", ...]


class CoefficientGrid(NamedTuple):
    """The coefficients as nested lists: coefficients[i][j]… = a_(start + (i, j, …)), as deep as there are variables.

    All lists of one depth are as long.
    """

    dilation: IntMatrix
    start: Index
    coefficients: Nested

    def expressions(self) -> Iterable[Expression]:
        """The expressions of the body, each of which may have parameters."""
        return (entry for _, entry in self._entries())

    def _entries(self) -> Iterator[tuple[Index, Expression]]:
        return _walk(self.coefficients, self.start)

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> MultivariateScheme | None:
        """The scheme at these values; what is wrong with a number, or with the mask, is recorded."""
        return _numbers(self.dilation, self._entries(), ("mask", "coefficients"), values, problems, work)


class Terms(NamedTuple):
    """The coefficients as a table: index -> a_index; the indices are different, at least one."""

    dilation: IntMatrix
    terms: tuple[tuple[Index, Expression], ...]

    def expressions(self) -> Iterable[Expression]:
        """The expressions of the body, each of which may have parameters."""
        return (entry for _, entry in self.terms)

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> MultivariateScheme | None:
        """The scheme at these values; what is wrong with a number, or with the mask, is recorded."""
        return _numbers(self.dilation, self.terms, ("mask", "terms"), values, problems, work)


class LaurentSymbol(NamedTuple):
    """The symbol a(z1, z2, …) as one expression."""

    dilation: IntMatrix
    expression: Expression

    def expressions(self) -> Iterable[Expression]:
        """The expressions of the body, each of which may have parameters."""
        return (self.expression,)

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> MultivariateScheme | None:
        """The scheme at these values; what is wrong with a number, or with the mask, is recorded."""
        polynomial = polynomial_of(self.expression, values, problems, work)
        if polynomial is None:
            return None
        terms = polynomial.terms(len(self.dilation))
        return _scheme(self.dilation, terms, self.expression.path, values, problems)


class BoxSplineMask(NamedTuple):
    """The box spline of the directions ξ: c^(s-n) Π_ξ (1 + z^ξ + … + z^((c-1)ξ))^m, n = Σ m, with the dilation cI.

    Dyn 1992, 6.54 for c = 2; de Boor, Höllig, Riemenschneider 1993, chapter VII.
    """

    dilation: IntMatrix
    """The matrix c times the identity."""
    directions: tuple[Index, ...]
    """The directions, which span R^s."""
    multiplicities: tuple[int, ...]

    def expressions(self) -> Iterable[Expression]:
        """The expressions of the body, each of which may have parameters."""
        return ()

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> MultivariateScheme | None:
        """The scheme; a box spline that is too large is recorded."""
        path = ("mask", "box_spline")
        s, c = len(self.dilation), self.dilation[0][0]
        symbol = laurent.constant(Fraction(c**s, c ** sum(self.multiplicities)))
        try:
            for direction, multiplicity in zip(self.directions, self.multiplicities, strict=True):
                factor = BoundedLaurent({packed((0, *(j * x for x in direction))): 1 for j in range(c)})
                symbol = laurent.times(symbol, laurent.power(factor, multiplicity, work), work)
        except TooLargeError as error:
            problems.add(
                Fault(faults.OUT_OF_BOUNDS, f"the box spline is too large: {error}", "use smaller multiplicities"), path
            )
            return None
        return _scheme(self.dilation, symbol.terms(s), path, values, problems)


class Tensor(NamedTuple):
    """The tensor product a_(i, j, …) = a_i b_j … of at least two scalar masks of one arity."""

    factors: tuple[Coefficients | Symbol, ...]

    def expressions(self) -> Iterable[Expression]:
        """The expressions of the body, each of which may have parameters."""
        return (entry for factor in self.factors for entry in factor.expressions())

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> MultivariateScheme | None:
        """The scheme at these values; what is wrong with a number, or with the mask, is recorded."""
        path = ("mask", "tensor")
        schemes = [factor.scheme(values, problems, work) for factor in self.factors]
        factors = [
            [(k, value) for k, value in enumerate(scheme.coefficients, scheme.start) if value]
            for scheme in schemes
            if scheme is not None
        ]
        if len(factors) < len(schemes):
            return None
        if (count := prod(map(len, factors))) > MAX_MASK_LENGTH:
            problems.add(_too_many(count), path)
            return None
        terms = {
            tuple(k for k, _ in pick): prod((value for _, value in pick), start=Fraction(1))
            for pick in product(*factors)
        }
        dilation = multiple_of_identity(self.factors[0].arity, len(self.factors))
        return _scheme(dilation, terms, path, values, problems)


def _walk(entries: Nested, start: Index, above: Index = ()) -> Iterator[tuple[Index, Expression]]:
    """Every coefficient with its index, from nested lists of them."""
    for k, entry in enumerate(entries, start[len(above)]):
        index = (*above, k)
        if isinstance(entry, Expression):
            yield index, entry
        else:
            yield from _walk(entry, start, index)


def _numbers(
    dilation: IntMatrix,
    entries: Iterable[tuple[Index, Expression]],
    path: KeyPath,
    values: Mapping[str, Fraction],
    problems: Collector,
    work: Work,
) -> MultivariateScheme | None:
    """The scheme of coefficients given one by one; None where one is wrong, which is recorded."""
    numbers = [(index, number_of(entry, values, problems, work)) for index, entry in entries]
    terms = {index: value for index, value in numbers if value is not None}
    return _scheme(dilation, terms, path, values, problems) if len(terms) == len(numbers) else None


def _scheme(
    dilation: IntMatrix,
    terms: Mapping[Index, Fraction],
    path: KeyPath,
    values: Mapping[str, Fraction],
    problems: Collector,
) -> MultivariateScheme | None:
    """The scheme of coefficients by their indices; None where they make none, which is recorded."""
    terms = {index: value for index, value in terms.items() if value}
    fault = _wrong_size(terms) if terms else zero_mask(values)
    if fault:
        problems.add(fault, path)
        return None
    return MultivariateScheme(dilation=dilation, terms=terms)


def _wrong_size(terms: Mapping[Index, Fraction]) -> Fault | None:
    """The fault of coefficients that are too many, too far out or too precise; None where they are not."""
    if len(terms) > MAX_MASK_LENGTH:
        return _too_many(len(terms))
    if max(max(map(abs, index)) for index in terms) > MAX_INDEX:
        return Fault(faults.OUT_OF_BOUNDS, f"an index beyond {MAX_INDEX}", "shift the mask towards 0")
    return too_precise(terms.values())


def _too_many(count: int) -> Fault:
    """The fault of a mask with so many coefficients."""
    message = f"the mask has {count} coefficients that are not zero; the limit is {MAX_MASK_LENGTH}"
    return Fault(faults.OUT_OF_BOUNDS, message, "use a smaller mask")
