"""A scheme of matrices taken apart, for `show`: spectra, the ends of the curve, the chain of spaces. No verdicts."""

from __future__ import annotations

from collections.abc import Iterator

from flint import fmpq_mat, fmpz_poly

from subdiv_cli.kinds.kind import Analysis
from subdiv_cli.kinds.matrices.numbers.curve import Jet, RefinedCurve
from subdiv_cli.kinds.matrices.numbers.matrices import MatrixNumbers
from subdiv_cli.kinds.matrices.portrait.pictures import matrices
from subdiv_cli.kinds.matrices.stages.smoothness import jets
from subdiv_cli.model import Data, Result, Verdict
from subdiv_cli.model.blocks import Block, Formula, Matrix, Portrait, Statements, Text, Words, sections
from subdiv_cli.model.closed import rational
from subdiv_cli.model.formulas import brief, derivative, laurent, point

_MOST_SHOWN = 6
"""The most matrices U_i, and their largest order."""


def portrait(analysis: Analysis, result: Result) -> Portrait:
    """The sections of the page that are not empty, and its data."""
    page = _Page(analysis, result)
    parts = {
        "Scheme": page.scheme(),
        "Spectra": page.spectra(),
        "Curve": page.ends(),
        "Chain of invariant spaces": page.chain(),
        "Polynomial components": page.components(),
        "Findings": (Statements(result.findings, full=True),),
    }
    return Portrait(sections(parts), page.data())


class _Page:
    """The parts of a page, each computed once; empty where there is no curve."""

    def __init__(self, analysis: Analysis, result: Result) -> None:
        self.numbers: MatrixNumbers = analysis.numbers
        self.result = result
        self.curve: RefinedCurve | None = self.numbers.curve if result.well_defined is Verdict.PROVED else None
        self.jets: tuple[Jet, ...] = () if self.curve is None else jets(self.numbers)

    def scheme(self) -> Iterator[Block]:
        yield Words("facts")
        yield from matrices(self.numbers.scheme)

    def spectra(self) -> Iterator[Block]:
        if self.numbers.p <= _MOST_SHOWN:
            for i, b in enumerate(self.numbers.operators):
                yield Formula(f"det(z - A_{i})", _factored(b))

    def ends(self) -> Iterator[Block]:
        if self.curve is None:
            return
        left, right = self.numbers.ends
        yield Formula("ψ(0) = f_0", point(left, brief))
        yield Formula(f"ψ(1) = f_{self.numbers.p - 1}", point(right, brief))
        for jet in self.jets:
            name = derivative("ψ", jet.order)
            yield Formula(f"{name}(0)", point(jet.left, brief))
            yield Formula(f"{name}(1)", point(jet.right, brief))
            what = "fit at the joints" if jet.joint is None else f"do not fit at x = {jet.joint}/{self.numbers.p}"
            yield Text(f"derivatives of order {jet.order} {what}")

    @property
    def dimensions(self) -> tuple[int, ...]:
        """The dimensions of S^(0), …, S^(d+1) = V."""
        if self.curve is None:
            return ()
        m, d = self.curve.span.dimension, self.curve.components.degree
        return tuple(range(m, m - d - 2, -1))

    def chain(self) -> Iterator[Block]:
        if self.curve is None:
            return
        names = [f"S^({i})" for i in range(len(self.dimensions))]
        yield Text(f"{', '.join(names)}, each in the one before, of dimensions {', '.join(map(str, self.dimensions))}")
        what = "annihilates the polynomial components" if self.dimensions[-1] else "is 0: the curve is a polynomial"
        yield Text(f"{names[-1]} {what}")

    def components(self) -> Iterator[Block]:
        if self.curve is None:
            return
        polygons = self.curve.components.polygons
        rows = tuple(tuple(brief(x) for x in u) for u in polygons)
        yield Matrix("u", rows)
        powers = ("1", "x", *(f"x^{j}" for j in range(2, len(polygons))))[: len(polygons)]
        yield Text(f"the rows are polygons with the curves {', '.join(powers)}")
        if max(len(polygons), self.numbers.p) <= _MOST_SHOWN and len(polygons) > 1:
            for i, u in enumerate(self.curve.components.fixed_points()):
                yield Matrix(f"U_{i}", tuple(tuple(map(rational, row)) for row in u))

    def data(self) -> dict[str, Data]:
        """The JSON page: numbers are exact."""
        data: dict[str, Data] = {
            "matrices": self.numbers.scheme.matrices,
            "spectra": tuple(_factored(b) for b in self.numbers.operators),
            "ends": None,
            "derivatives": (),
            "chain": self.dimensions,
            "polynomials": None,
        }
        if self.curve is not None:
            left, right = self.numbers.ends
            data["ends"] = {"left": left, "right": right}
            data["derivatives"] = tuple(
                {"order": jet.order, "left": jet.left, "right": jet.right, "joint": jet.joint} for jet in self.jets
            )
            known = self.curve.components
            data["polynomials"] = {"polygons": known.polygons, "fixed_points": known.fixed_points()}
        return data


def _factored(b: fmpq_mat) -> str:
    """The characteristic polynomial in factors, `(-1 + z) (-1 + 2 z)^2`, up to a constant."""
    factors = b.charpoly().numer().factor()[1]
    text = [(laurent(0, [int(c) for c in f.coeffs()]), n) for f, n in sorted(factors, key=_by_degree)]
    return " ".join((name if name == "z" else f"({name})") + (f"^{n}" if n > 1 else "") for name, n in text)


def _by_degree(factor: tuple[fmpz_poly, int]) -> tuple[int, list[int]]:
    return factor[0].degree(), [int(c) for c in factor[0].coeffs()]
