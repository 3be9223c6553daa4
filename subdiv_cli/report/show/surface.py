"""What `subdiv show` says of a mask in several variables, section by section, for the formats that set sections.

`text` has the same with grids beside each other (`lattice.py`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from subdiv_cli.model import Finding, Result, Verdict
from subdiv_cli.model.blocks import SurfaceAnatomy
from subdiv_cli.report import words
from subdiv_cli.report.lattice import MOST_COSETS, QUASI_TITLE, planes, scaled_by, stencils, titled
from subdiv_cli.report.numbers import exact
from subdiv_cli.report.show.content import Block, Drawing, Formula, Grid, Section, Text
from subdiv_cli.report.show.formulas import combination, number, partial, power

Index = tuple[int, ...]

_WIDE = 16
"""Columns beyond which a grid is told instead of drawn."""
_LONGEST = 40
"""Terms of a quotient that are written out."""
_MOST_MOMENTS = 12


def sections(result: Result, anatomy: SurfaceAnatomy) -> Iterator[Section]:
    """Those that have something to say."""
    parts = {
        "Mask": _mask,
        "Stencils": _stencils,
        "Refinable function": _function,
        "Polynomials": _polynomials,
        "Findings": _findings,
    }
    for title, part in parts.items():
        if blocks := tuple(part(result, anatomy)):
            yield Section(title, blocks)


def _mask(result: Result, anatomy: SurfaceAnatomy) -> Iterator[Block]:
    yield Text(", ".join(words.facts(result)))
    yield Formula("a(z)", symbol(anatomy))
    if anatomy.differences is not None:
        yield Text(differences(result, anatomy))


def differences(result: Result, anatomy: SurfaceAnatomy) -> str:
    k = result.sum_rule_order
    return f"V_{k}, the space of the differences of order {k}, has dimension {anatomy.differences}"


def _stencils(result: Result, anatomy: SurfaceAnatomy) -> Iterator[Block]:
    found = list(stencils(anatomy.terms, anatomy.dilation))
    for stencil in found[:MOST_COSETS]:
        yield Text(titled(stencil))
        yield from _grids(stencil.weights)
    if (more := len(found) - MOST_COSETS) > 0:
        yield Text(f"and {more} more coset{'' if more == 1 else 's'}")


def _function(result: Result, anatomy: SurfaceAnatomy) -> Iterator[Block]:
    if not anatomy.values:
        return
    if anatomy.surface is not None:
        yield Drawing()
    if anatomy.centre is not None:
        yield Text(f"centre of mass {_tuple(anatomy.centre)}")
    yield Text(f"φ at the integers{scaled_by(anatomy.values)}")
    yield from _grids(anatomy.values)


def _polynomials(result: Result, anatomy: SurfaceAnatomy) -> Iterator[Block]:
    yield from inversion(anatomy)
    if len(anatomy.quasi_stencil) > 1:
        yield Text(f"on polynomials of degree {result.generation} {QUASI_TITLE}{scaled_by(anatomy.quasi_stencil)}")
        yield from _grids(anatomy.quasi_stencil)


def inversion(anatomy: SurfaceAnatomy) -> Iterator[Text | Formula]:
    """The moments and Q."""
    if not anatomy.operator or anatomy.centre is None:
        return
    if 1 < len(anatomy.moments) <= _MOST_MOMENTS:
        shown = (f"m_({','.join(map(str, mu))}) = {number(m)}" for mu, m in _rising(anatomy.moments))
        yield Text(f"moments: {', '.join(shown)}")
    right = combination((x, partial("f", mu)) for mu, x in _rising(anatomy.centred))
    if any(anatomy.centre):
        yield Formula("Q f(α)", f"g(α + {_tuple(anatomy.centre)})")
        yield Formula("g", right)
    else:
        yield Formula("Q f", right)


def _findings(result: Result, anatomy: SurfaceAnatomy) -> Iterator[Block]:
    yield from (Text(_sentence(found), words.ROLES[found.verdict]) for found in result.findings)


def _sentence(found: Finding) -> str:
    asks = found.verdict in (Verdict.UNDECIDED, Verdict.SKIPPED)
    why = f" {found.reason}" if asks and found.reason else ""
    return f"{found.statement}{why} ({found.verdict.value}, {found.code})"


def _grids(weights: Mapping[Index, Fraction]) -> Iterator[Block]:
    """The first coordinate to the right, the second upwards."""
    for title, cells in planes(weights):
        if title:
            yield Text(title)
        if not cells:
            continue
        low, high = [min(k) for k in zip(*cells, strict=True)], [max(k) for k in zip(*cells, strict=True)]
        columns = range(low[0], high[0] + 1)
        if len(columns) > _WIDE:
            yield Text(", ".join(f"{_tuple(index)}: {cells[index]}" for index in sorted(cells)))
            continue
        rows = ((str(y), tuple(cells.get((x, y), "·") for x in columns)) for y in range(high[1], low[1] - 1, -1))
        yield Grid("", tuple(map(str, columns)), tuple(rows))


def _rising(q: Mapping[Index, Fraction]) -> list[tuple[Index, Fraction]]:
    """By total degree, the first variable first."""
    return sorted(q.items(), key=lambda term: (sum(term[0]), [-n for n in term[0]]))


def symbol(anatomy: SurfaceAnatomy) -> str:
    """`1/16 (1 + z1)^2 (1 + z2)^2 (1 + z1 z2)^2`; a quotient of several terms in brackets, a long one by its length."""
    c = anatomy.dilation[0][0]
    product = " ".join(_factor(theta, c) + (f"^{n}" if n > 1 else "") for theta, n in anatomy.factors.items())
    if len(anatomy.quotient) == 1:
        ((index, value),) = anatomy.quotient.items()
        return combination([(value, " ".join(filter(None, (_monomial(index), product))))])
    if len(anatomy.quotient) > _LONGEST:
        rest = f"{len(anatomy.quotient)} terms"
    else:
        rest = combination((value, _monomial(index)) for index, value in anatomy.quotient.items())
    return f"{product} ({rest})" if product else rest


def _factor(theta: Index, c: int) -> str:
    terms = [_monomial(tuple(i * x for x in theta)) for i in range(1, c)]
    return f"(1 + {' + '.join(terms if c < 5 else [terms[0], '…', terms[-1]])})"


def _monomial(index: Index) -> str:
    return " ".join(filter(None, (power(f"z{i}", x) for i, x in enumerate(index, 1))))


def _tuple(entries: tuple[Fraction | int, ...]) -> str:
    return f"({', '.join(map(exact, entries))})"
