"""A mask in several variables taken apart, for `show`: its symbol, stencils, the values of φ, and Q. No verdicts."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

from subdiv_cli.kinds.kind import Analysis
from subdiv_cli.kinds.multivariate.numbers.directional import factored
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.numbers.values import NoValuesError, at_integers
from subdiv_cli.kinds.multivariate.portrait.pictures import centre, heights, is_continuous
from subdiv_cli.kinds.multivariate.portrait.stencils import (
    Values,
    quasi_blocks,
    quasi_witness,
    stencil_blocks,
    stencils,
    value_blocks,
)
from subdiv_cli.model import Data, Result
from subdiv_cli.model.blocks import Block, Formula, Heights, Portrait, Statements, Text, Words, sections
from subdiv_cli.model.formulas import brief, combination, partial_operator, point, power, rising
from subdiv_cli.spaces.lattice import Index

_POINTS = 5_000
"""The number of points of φ, when it is drawn in letters."""
_LONGEST = 40
"""The most terms of a quotient that are written out."""
_MOST_MOMENTS = 12


def portrait(analysis: Analysis, result: Result) -> Portrait:
    """The sections of the page that are not empty, and its data."""
    page = _MultivariatePage(analysis, result)
    parts = {
        "Mask": page.mask(),
        "Stencils": stencil_blocks(page.scheme.terms, page.numbers.lattice),
        "Refinable function": page.refinable_function(),
        "Polynomials": page.polynomials(),
        "Findings": (Statements(result.findings, full=True),),
    }
    return Portrait(sections(parts), page.data())


class _MultivariatePage:
    """The parts of a page, each computed once; None and empty where the scheme does not have it."""

    def __init__(self, analysis: Analysis, result: Result) -> None:
        self.numbers: MultivariateNumbers = analysis.numbers
        self.result = result
        self.scheme = self.numbers.scheme
        self.factors, self.quotient = factored(self.scheme, self.numbers.lattice)
        self.differences = None if self.numbers.space is None else self.numbers.space.basis.nrows()
        self.centre = centre(self.numbers) if self.numbers.is_normalised else None
        quasi = quasi_witness(result.findings)
        self.moments = dict(quasi["moments"]) if quasi else {}
        self.operator = dict(quasi["operator"]) if quasi else {}
        self.centred = dict(quasi["centred"]) if quasi else {}
        self.quasi_stencil = dict(quasi["stencil"]) if quasi else {}
        self.values: Values = {}
        self.heights: Heights | None = None
        if is_continuous(result):
            with suppress(NoValuesError):
                self.values = at_integers(self.scheme, self.numbers.lattice)
                self.heights = heights(self.numbers, _POINTS)

    @property
    def symbol(self) -> str:
        """The symbol as text: `1/16 (1 + z1)^2 (1 + z1 z2)^2`; a quotient in brackets, a long one by its length."""
        c, terms = self.scheme.dilation[0][0], [(value, _monomial(index)) for index, value in self.quotient.items()]
        product = " ".join(_factor(theta, c) + (f"^{n}" if n > 1 else "") for theta, n in self.factors.items())
        if len(terms) == 1:
            ((value, monomial),) = terms
            return combination([(value, " ".join(filter(None, (monomial, product))))], brief)
        rest = f"{len(terms)} terms" if len(terms) > _LONGEST else combination(terms, brief)
        return f"{product} ({rest})" if product else rest

    def mask(self) -> Iterator[Block]:
        yield Words("facts")
        yield Formula("a(z)", self.symbol)
        k = self.result.sum_rule_order
        if self.differences is not None and k is not None:
            yield Text(f"V_{k}, the space of the differences of order {k}, has dimension {self.differences}")

    def refinable_function(self) -> Iterator[Block]:
        if not self.values:
            return
        if self.heights is not None:
            yield self.heights
        if self.centre is not None:
            yield Text(f"centre of mass {point(self.centre)}")
        yield from value_blocks("φ at the integers", self.values)

    def polynomials(self) -> Iterator[Block]:
        """The blocks of the moments and of Q."""
        if not self.operator or self.centre is None:
            return
        yield Text(f"S^∞ Q f = f on polynomials of total degree {self.result.generation}")
        if 1 < len(self.moments) <= _MOST_MOMENTS:
            shown = (f"m_({','.join(map(str, mu))}) = {brief(self.moments[mu])}" for mu in rising(self.moments))
            yield Text(f"moments: {', '.join(shown)}")
        if any(self.centre):
            yield Formula("Q f(α)", f"g(α + {point(self.centre)})")
        yield Formula("g" if any(self.centre) else "Q f", partial_operator(self.centred, brief))
        yield from quasi_blocks(self.quasi_stencil)

    def data(self) -> dict[str, Data]:
        """The JSON page: numbers are exact, functions on Z^s are pairs of an index and a number."""
        k, quasi = self.result.sum_rule_order, (self.moments, self.operator, self.quasi_stencil)
        cosets = stencils(self.scheme.terms, self.numbers.lattice)
        return {
            "mask": {"dilation": self.scheme.dilation, "terms": _terms(self.scheme.terms)},
            "symbol": {
                "text": self.symbol,
                "factors": tuple({"direction": theta, "multiplicity": n} for theta, n in self.factors.items()),
                "quotient": _terms(self.quotient),
            },
            "cosets": tuple({"coset": s.coset, "at": s.at, "stencil": _terms(s.weights)} for s in cosets),
            "difference_space": None if self.differences is None else {"order": k, "dimension": self.differences},
            "centre": self.centre,
            "values": _terms(self.values) if self.values else None,
            "quasi_interpolation": {
                "degree": self.result.generation,
                **dict(zip(("moments", "operator", "stencil"), map(_terms, quasi), strict=True)),
            }
            if self.operator
            else None,
        }


def _terms(values: Values) -> tuple[Data, ...]:
    """The pairs of an index and a number, by rising index."""
    return tuple(sorted(values.items()))


def _factor(theta: Index, c: int) -> str:
    terms = [_monomial(tuple(i * x for x in theta)) for i in range(1, c)]
    return f"(1 + {' + '.join(terms if c < 5 else [terms[0], '…', terms[-1]])})"


def _monomial(index: Index) -> str:
    return " ".join(filter(None, (power(f"z{i}", x) for i, x in enumerate(index, 1))))
