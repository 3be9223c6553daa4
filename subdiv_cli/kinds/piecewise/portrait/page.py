"""A piecewise scheme taken apart, for `show`, and the rules that a report shows. No verdicts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from subdiv_cli.kinds.kind import Analysis
from subdiv_cli.kinds.piecewise.numbers.piecewise import PiecewiseNumbers
from subdiv_cli.kinds.piecewise.numbers.polynomials import Polynomial, eigen_polynomials, operator
from subdiv_cli.kinds.piecewise.portrait.pictures import limits
from subdiv_cli.kinds.piecewise.scheme import PiecewiseScheme
from subdiv_cli.model import Data, Effort, Result, Verdict
from subdiv_cli.model.blocks import Block, Formula, Grid, Matrix, Portrait, Section, Statements, Text, Words
from subdiv_cli.model.blocks import sections as headed
from subdiv_cli.model.closed import rational
from subdiv_cli.model.formulas import combination, laurent
from subdiv_cli.model.formulas import operator as operator_text
from subdiv_cli.model.formulas import polynomial as polynomial_text

_CARD_POINTS = 200
_MOST_SHOWN = 16
"""The most points of a matrix or a row that are written out."""


def sections(scheme: PiecewiseScheme, result: Result) -> tuple[Section, ...]:
    """The limits of unit data near 0 where convergence is proved, and the special rows and those beside them."""
    drawn: tuple[Block, ...] = limits(PiecewiseNumbers(scheme, Effort()), result, _CARD_POINTS)
    picture = drawn or (Text("limits are drawn where convergence is proved.", "quiet"),)
    return Section("", picture), Section("stencils", (_rows(scheme),))


def _rows(scheme: PiecewiseScheme) -> Grid:
    """The weights of old points in the new points at and beside the special ones."""
    special = [i for i, _ in scheme.special]
    shown = range(min([0, *special]) - 2, max([0, *special]) + 3)
    rows = {i: dict(scheme.row(i)) for i in shown}
    old = range(min(j for row in rows.values() for j in row), max(j for row in rows.values() for j in row) + 1)
    named = [(f"c'_{i}" + (" *" if i in special else ""), row) for i, row in rows.items()]
    cells = tuple((name, tuple(rational(row[j]) if j in row else "" for j in old)) for name, row in named)
    return Grid("* special", tuple(f"c_{j}" for j in old), cells)


def portrait(analysis: Analysis, result: Result) -> Portrait:
    """The sections of the page that are not empty, and its data."""
    page = _PiecewisePage(analysis, result)
    parts = {
        "Scheme": page.scheme(),
        "Near 0": page.near_zero(),
        "Polynomials": page.polynomials(),
        "Findings": (Statements(result.findings, full=True),),
    }
    return Portrait(headed(parts), page.data())


class _PiecewisePage:
    """The parts of a page, each computed once; empty where the window near 0 is too large."""

    def __init__(self, analysis: Analysis, result: Result) -> None:
        self.numbers: PiecewiseNumbers = analysis.numbers
        self.result = result
        self.points = () if self.numbers.window is None else self.numbers.closed_set

    def scheme(self) -> Iterator[Block]:
        yield Words("facts")
        for name, mask in (("left", self.numbers.scheme.left), ("right", self.numbers.scheme.right)):
            yield Formula(f"{name} a(z)", laurent(mask.start, mask.coefficients))
        yield _rows(self.numbers.scheme)

    def near_zero(self) -> Iterator[Block]:
        if not self.points or len(self.points) > _MOST_SHOWN:
            return
        yield Text(f"points that determine the limits near 0: {', '.join(map(str, self.points))}")
        rows = self._matrix()
        yield Matrix("A", tuple(tuple(map(rational, row)) for row in rows))
        local = self.numbers.local
        if local is not None:
            factors = [(laurent(0, f), n) for f, n in local.factors]
            yield Formula("det(z - A)", " ".join(f"({f})" + (f"^{n}" if n > 1 else "") for f, n in factors))
        if self.result.convergent is Verdict.PROVED:
            value = self._value()
            yield Formula("F(0)", combination((x, f"c_{i}" if i >= 0 else f"c_({i})") for i, x in value.items()))

    def _matrix(self) -> tuple[tuple[Fraction, ...], ...]:
        """The matrix A on the closed set."""
        rows = [dict(self.numbers.scheme.row(i)) for i in self.points]
        return tuple(tuple(row.get(j, Fraction(0)) for j in self.points) for row in rows)

    def _value(self) -> Mapping[int, Fraction]:
        assert self.numbers.functionals is not None
        return {i: x for i, x in enumerate(self.numbers.functionals.value, self.numbers.functionals.window[0]) if x}

    @property
    def _degree(self) -> int:
        return -1 if self.numbers.functionals is None else len(self.numbers.sequences) - 1

    @property
    def _sides(self) -> Sequence[tuple[str, tuple[Polynomial, ...]]]:
        """The eigen-polynomials of both masks, in the index, as far as the scheme has such sequences."""
        cells = zip(("left", "right"), self.numbers.cells, strict=True)
        return [(name, eigen_polynomials(each.mask, each.spacing)[: self._degree + 1]) for name, each in cells]

    def polynomials(self) -> Iterator[Block]:
        if self._degree < 0:
            return
        for name, sequences in self._sides:
            yield Formula(f"{name} Q f", operator_text(operator(sequences)))
        assert self.numbers.functionals is not None
        window = self.numbers.functionals.window
        near = [i for i in window if abs(i) <= max(map(abs, self.points), default=0) + 1]
        if len(near) <= _MOST_SHOWN:
            rows = [
                (f"Q x^{d}" if d > 1 else ("Q x" if d else "Q 1"), tuple(rational(q[i - window[0]]) for i in near))
                for d, q in enumerate(self.numbers.sequences)
            ]
            yield Grid("i", tuple(map(str, near)), tuple(rows))
        for name, sequences in self._sides:
            texts = ", ".join(polynomial_text(q).replace("x", "i") for q in sequences)
            yield Text(f"{name}, in the index i: {texts}")
        order = "" if self._order is None else f": with Q the order of approximation is {self._order}"
        yield Text(f"S Q = Q σ on π_{self._degree}{order}")

    @property
    def _order(self) -> int | None:
        """The order of approximation with Q, where the scheme is proved to converge (A. Levin 2003, Theorem 2.7)."""
        return self._degree + 1 if self.result.convergent is Verdict.PROVED else None

    def data(self) -> dict[str, Data]:
        """The JSON page: numbers are exact."""
        scheme = self.numbers.scheme
        data: dict[str, Data] = {
            "left": {"start": scheme.left.start, "coefficients": scheme.left.coefficients},
            "right": {"start": scheme.right.start, "coefficients": scheme.right.coefficients},
            "spacing": scheme.spacing,
            "special": tuple(
                {"row": i, "points": tuple(j for j, _ in row), "weights": tuple(x for _, x in row)}
                for i, row in scheme.special
            ),
            "points": self.points,
            "matrix": self._matrix(),
            "degree": self._degree,
            "quasi_interpolation": {name: operator(q) for name, q in self._sides},
            "approximation_order": self._order,
            "sequences": None,
            "value_at_zero": None,
        }
        if self.numbers.functionals is not None and self._degree >= 0:
            data["sequences"] = {"start": self.numbers.functionals.window[0], "values": self.numbers.sequences}
        if self.result.convergent is Verdict.PROVED:
            value = self._value()
            data["value_at_zero"] = {"points": tuple(value), "weights": tuple(value.values())}
        return data
