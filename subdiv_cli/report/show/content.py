"""What `subdiv show` says, section by section, before any format sets it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

from subdiv_cli.model import Finding, Result, Verdict
from subdiv_cli.model.blocks import Anatomy, Signal
from subdiv_cli.report import words
from subdiv_cli.report.numbers import interval
from subdiv_cli.report.show.formulas import (
    derivative,
    descending,
    index,
    number,
    operator,
    polynomial,
    symbol,
)

_WIDE = 11
"""Entries beyond which a row is told instead of drawn."""
_LONG = 14
"""Letters of an entry beyond which it is too."""
_LARGEST_MATRIX = 12


class Text(NamedTuple):
    """A sentence."""

    text: str
    role: str = "text"


class Formula(NamedTuple):
    """left = right."""

    left: str
    right: str


class Grid(NamedTuple):
    """A stencil, or several rows on the same nodes, drawn: nodes above, numbers below."""

    corner: str
    nodes: tuple[str, ...]
    rows: tuple[tuple[str, tuple[str, ...]], ...]


class Matrix(NamedTuple):
    """A matrix with its name."""

    name: str
    rows: tuple[tuple[str, ...], ...]


class Drawing(NamedTuple):
    """The picture."""


Block = Text | Formula | Grid | Matrix | Drawing


class Section(NamedTuple):
    """A headed part of the page."""

    title: str
    blocks: tuple[Block, ...]


def sections(result: Result, anatomy: Anatomy) -> Iterator[Section]:
    """Those that have something to say."""
    parts = {
        "Mask": _mask,
        "Symbol": _symbol,
        "Derived schemes": _derived,
        "Refinement matrices": _matrices,
        "Refinable function": _function,
        "Limit stencils": _stencils,
        "Polynomials": _polynomials,
        "Regularity": _regularity,
        "Distance to the limit": _distance,
    }
    for title, part in parts.items():
        if blocks := tuple(part(result, anatomy)):
            yield Section(title, blocks)


def _mask(result: Result, anatomy: Anatomy) -> Iterator[Block]:
    yield Text(", ".join(words.facts(result)))
    yield from _row(anatomy.mask, "i", "a_i")


def _symbol(result: Result, anatomy: Anatomy) -> Iterator[Block]:
    yield Formula("a(z)", symbol(anatomy))
    for factor in anatomy.factors:
        if factor.zeros:
            yield Text(f"zeros of {polynomial(0, factor.coefficients)}: {', '.join(factor.zeros)}")
    for r, component in enumerate(anatomy.components):
        yield Formula(f"a_{r}(z)", polynomial(component.start, component.values))
    yield from _statements(result, "SD102", "SD401", "SD402", "SD403")


def _derived(result: Result, anatomy: Anatomy) -> Iterator[Block]:
    if anatomy.derived:
        yield Text("the symbols of S_1, S_2, …, which act on divided differences")
    for nu, mask in enumerate(anatomy.derived, 1):
        yield Formula(f"a^({nu})(z)", polynomial(mask.start, mask.values))


def _matrices(result: Result, anatomy: Anatomy) -> Iterator[Block]:
    order = len(anatomy.matrices[0]) if anatomy.matrices else 0
    if not order:
        return
    last = anatomy.window + order - 1
    yield Text(f"A_ε[α, β] = a_(ε+α-{result.facts['arity']}β) for α and β from {anatomy.window} to {last}")
    if order <= _LARGEST_MATRIX:
        for epsilon, matrix in enumerate(anatomy.matrices):
            yield Matrix(f"A_{epsilon}", tuple(tuple(map(number, row)) for row in matrix))
    else:
        yield Text(f"of order {order}; --format json has their entries")
    for epsilon, eigenvalues in enumerate(anatomy.eigenvalues):
        yield Text(f"eigenvalues of A_{epsilon}: {', '.join(eigenvalues)}")


def _function(result: Result, anatomy: Anatomy) -> Iterator[Block]:
    if not anatomy.values:
        yield from _statements(result, "SD501", "SD302")
        return
    first, last = anatomy.support
    yield Text(f"φ is supported in [{first}, {last}]; its translates sum to 1")
    if anatomy.curve is not None:
        yield Drawing()
    yield from _table(anatomy.values, lambda order: f"{derivative('φ', order)}(i)")


def _stencils(result: Result, anatomy: Anatomy) -> Iterator[Block]:
    p = result.facts["arity"]
    if anatomy.stencils:
        yield Text(f"the limit and its derivatives at i/{p}^k from the data f of level k")
    for order, stencil in enumerate(anatomy.stencils):
        scale = "" if order == 0 else f"{p}^{'k' if order == 1 else f'({order}k)'} times "
        yield Text(f"{'the limit' if order == 0 else f'derivative of order {order}'}: {scale}".rstrip(" :"))
        yield from _row(stencil, "f", "", nodes=[_datum(stencil.start + j) for j in _places(stencil)])
    if not anatomy.stencils:
        yield from _statements(result, "SD502")


def _datum(by: int) -> str:
    return f"f_({index('i', by)})" if by else "f_i"


def _polynomials(result: Result, anatomy: Anatomy) -> Iterator[Block]:
    yield from _statements(result, "SD103", "SD104", "SD505")
    if anatomy.operator:
        yield Text("moments: " + ", ".join(f"m_{i} = {number(m)}" for i, m in enumerate(anatomy.moments)))
        yield Formula("Q f", operator(anatomy.operator))
    if anatomy.quasi_stencil is not None:
        stencil = anatomy.quasi_stencil
        nodes = [f"f({index('i', stencil.start + j)})" for j in _places(stencil)]
        yield from _row(stencil, "", "Q f(i)", nodes=nodes)
    for i, sequence in enumerate(anatomy.eigen_sequences):
        yield Formula(f"Q {('1' if i == 0 else 'x' if i == 1 else f'x^{i}')}", descending(sequence))
    if anatomy.eigen_sequences:
        p = result.facts["arity"]
        yield Text(f"sampled at the integers, Q x^i is an eigen-sequence of S for {p}^-i")
    yield from _statements(result, "SD504", "SD503" if not anatomy.operator else "")


def _regularity(result: Result, anatomy: Anatomy) -> Iterator[Block]:
    yield from _statements(result, "SD201", "SD302", "SD303")
    if (holder := words.holder(result)) is not None:
        yield Text(f"Hölder exponent {holder} ({_codes(result, 'SD311', 'SD312')})")
    found = next((f for f in result.findings if f.code == "SD321"), None)
    if found is not None and found.value is not None and (sobolev := interval(found.value)) is not None:
        yield Text(f"Sobolev exponent {sobolev} ({found.code})")
    yield from (Text(line, "quiet") for line in words.figures(result, digits=True))


def _distance(result: Result, anatomy: Anatomy) -> Iterator[Block]:
    yield from _statements(result, "SD511", "SD512")


def _codes(result: Result, *codes: str) -> str:
    return ", ".join(code for code in codes if any(f.code == code for f in result.findings))


def _statements(result: Result, *codes: str) -> Iterator[Text]:
    """Findings in a sentence each, verdict and code behind it."""
    for code in codes:
        for found in result.findings:
            if found.code == code:
                yield Text(_sentence(found), words.ROLES[found.verdict])


def _sentence(found: Finding) -> str:
    asks = found.verdict in (Verdict.UNDECIDED, Verdict.SKIPPED)
    why = f" {found.reason}" if asks and found.reason else ""
    return f"{found.statement}{why} ({found.verdict.value}, {found.code})"


def _places(signal: Signal) -> range:
    return range(len(signal.values))


def _row(signal: Signal, corner: str, name: str, nodes: Sequence[str] | None = None) -> Iterator[Block]:
    """One sequence, drawn where it is short enough to be seen at a glance."""
    heads = [str(signal.start + j) for j in _places(signal)] if nodes is None else list(nodes)
    numbers = [number(x) for x in signal.values]
    if len(numbers) <= _WIDE and max(map(len, numbers)) <= _LONG:
        yield Grid(corner, tuple(heads), ((name, tuple(numbers)),))
    else:
        told = (f"{head}: {x}" for head, x, value in zip(heads, numbers, signal.values, strict=True) if value)
        yield Text(f"{name}  ".lstrip() + ", ".join(told))


def _table(signals: Sequence[Signal], name: Callable[[int], str]) -> Iterator[Block]:
    """Several sequences on the same nodes, in one grid where they fit, else each by itself."""
    first = min(signal.start for signal in signals)
    last = max(signal.start + len(signal.values) for signal in signals)
    rows = []
    for order, signal in enumerate(signals):
        padding = [Fraction(0)] * (signal.start - first), [Fraction(0)] * (last - signal.start - len(signal.values))
        numbers = tuple(number(x) for x in (*padding[0], *signal.values, *padding[1]))
        rows.append((name(order), numbers))
    widest = max(len(x) for _, numbers in rows for x in numbers)
    if last - first <= _WIDE and widest <= _LONG:
        yield Grid("i", tuple(map(str, range(first, last))), tuple(rows))
    else:
        for order, signal in enumerate(signals):
            yield from _row(signal, "i", name(order))
