"""A mask of matrices taken apart, for `show`, and the sections of its reports. No verdicts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from flint import fmpq_mat

from subdiv_cli.exact.algebraic import roots
from subdiv_cli.exact.linalg import Vector, rows_of
from subdiv_cli.exact.rationals import to_fraction
from subdiv_cli.exact.text import eigenvalue, number
from subdiv_cli.kinds.kind import Analysis
from subdiv_cli.kinds.vector.numbers.derived import canonical_transformation
from subdiv_cli.kinds.vector.numbers.values import Stencils, limit_curves, stencils
from subdiv_cli.kinds.vector.numbers.vector import VectorNumbers
from subdiv_cli.kinds.vector.scheme import VectorScheme
from subdiv_cli.model import Data, Effort, Result, Verdict
from subdiv_cli.model.blocks import Block, Curve, Formula, Grid, Matrix, Portrait, Section, Statements, Text, Words
from subdiv_cli.model.blocks import sections as headed
from subdiv_cli.model.closed import rational
from subdiv_cli.model.formulas import brief, combination, laurent, point, shifted

_POINTS = 240
"""The least number of points of a curve."""
_LONGEST = 12
"""The most matrices, or components, that are written out."""


def sections(scheme: VectorScheme, result: Result) -> tuple[Section, ...]:
    """The curves of the limits and their stencil where convergence is proved, and the rule of each new point."""
    numbers = VectorNumbers(scheme, Effort())
    stencil = stencils(numbers) if result.convergent is Verdict.PROVED else None
    picture: tuple[Block, ...] = (Text("limits are drawn where convergence is proved.", "quiet"),)
    grids = [_rule(numbers, epsilon) for epsilon in range(numbers.p)]
    if stencil is not None:
        picture = _curves(numbers)
        grids.append(_limit(stencil))
    return Section("", picture), Section("stencils", tuple(grids))


def _curves(numbers: VectorNumbers) -> tuple[Curve, ...]:
    """The curves of the limits, where they are few."""
    few = numbers.size * len(numbers.constants) <= _LONGEST
    return limit_curves(numbers, 0, _POINTS) if few else ()


def _rule(numbers: VectorNumbers, epsilon: int) -> Grid:
    """The matrices by which a new point of a class is made of old ones, row by row of the new vector."""
    p, start, count = numbers.p, numbers.scheme.start, len(numbers.matrices)
    last = start + count - 1
    offsets = range(-((last - epsilon) // p), (epsilon - start) // p + 1)
    rows = []
    for row in range(numbers.size):
        cells = [point(numbers.scheme.coefficients[epsilon - p * j - start][row]) for j in offsets]
        rows.append((f"(S c)_({p}k{f'+{epsilon}' if epsilon else ''}),{row + numbers.scheme.first}", tuple(cells)))
    return Grid("", tuple(f"c_({shifted('k', j)})" if j else "c_k" for j in offsets), tuple(rows))


def _limit(stencils: Stencils) -> Grid:
    """The stencils that give the coordinates of the limit at an integer."""
    rows = []
    used = [i for w in stencils.each for i, row in enumerate(w.tolist()) if any(row)]
    span = range(max(used), min(used) - 1, -1)
    for number_, w in enumerate(stencils.each, 1):
        cells = tuple(point(map(to_fraction, w.tolist()[i])) for i in span)
        rows.append(("limit at k" if len(stencils.each) == 1 else f"limit at k, u_{number_}", cells))
    offsets = [-(stencils.start + i) for i in span]
    return Grid("", tuple(f"c_({shifted('k', j)})" if j else "c_k" for j in offsets), tuple(rows))


def portrait(analysis: Analysis, result: Result) -> Portrait:
    """The sections of the page that are not empty, and its data."""
    page = _VectorPage(analysis, result)
    parts = {
        "Mask": page.mask(),
        "Constants": page.constants(),
        "Polynomials": page.polynomials(),
        "Limits": page.limits(),
        "Findings": (Statements(result.findings, full=True),),
    }
    return Portrait(headed(parts), page.data())


class _VectorPage:
    """The parts of a page, each computed once; None and empty where the scheme does not have it."""

    def __init__(self, analysis: Analysis, result: Result) -> None:
        self.numbers: VectorNumbers = analysis.numbers
        self.result = result
        self.sums = self._sums()
        terms = dict(enumerate(self.numbers.matrices, self.numbers.scheme.start))
        self.canonical = canonical_transformation(self.numbers.p, terms)
        self.stencils: Stencils | None = None
        self.curves: tuple[Curve, ...] = ()
        if result.convergent is Verdict.PROVED:
            self.stencils = stencils(self.numbers)
            self.curves = _curves(self.numbers)

    def _sums(self) -> tuple[fmpq_mat, ...]:
        """The A^ε of the mask where it stands, ε = 0 … p-1."""
        numbers = self.numbers
        sums = [numbers.matrices[0] * 0 for _ in range(numbers.p)]
        for i, a in enumerate(numbers.matrices, numbers.scheme.start):
            sums[i % numbers.p] += a
        return tuple(sums)

    def mask(self) -> Iterator[Block]:
        """The blocks of the facts and of the symbol, entry by entry."""
        numbers = self.numbers
        yield Words("facts")
        if numbers.size <= _LONGEST:
            yield Matrix("A(z)", tuple(tuple(row) for row in self._symbol()))

    def _symbol(self) -> list[list[str]]:
        scheme, m = self.numbers.scheme, self.numbers.size
        if len(scheme.coefficients) > 2 * _LONGEST:
            return [[f"{len(scheme.coefficients)} terms"] * m for _ in range(m)]
        return [
            [laurent(scheme.start, [a[k][l] for a in scheme.coefficients], brief) for l in range(m)] for k in range(m)
        ]

    def constants(self) -> Iterator[Block]:
        """The blocks of E_A, the A^ε, M_A with its spectrum, and the canonical transformation."""
        numbers = self.numbers
        if numbers.size > _LONGEST:
            return
        for epsilon, a in enumerate(self.sums):
            yield Matrix(f"A^{epsilon}", _spelled(rows_of(a)))
        if numbers.constants:
            yield Text(f"E_A is spanned by {', '.join(point(u) for u in numbers.constants)}")
        else:
            yield Text("E_A = 0")
        spectrum = [f"{eigenvalue(x)}{f' ({n} times)' if n > 1 else ''}" for x, n in roots(numbers.mean.charpoly())]
        yield Matrix("M_A", _spelled(rows_of(numbers.mean)))
        yield Text(f"eigenvalues of M_A: {', '.join(spectrum)}")
        if self.canonical is not None and self.canonical[1] < numbers.size:
            yield Matrix("canonical R", _spelled(rows_of(self.canonical[0])))

    def polynomials(self) -> Iterator[Block]:
        """The blocks of the eigen-sequences, of each degree one for each vector of the basis of E_A."""
        sequences = self.numbers.sequences
        for j, several in enumerate(sequences.each if sequences is not None else ()):
            for y in several:
                yield Formula(f"y_{j}(i), S y = {_power(self.numbers.p, j)}", _polynomial(y))

    def limits(self) -> Iterator[Block]:
        """The blocks of the limits at the integers, and of their curves."""
        for curve in self.curves:
            yield Text(f"{curve.name}, for the data {curve.label or 'δ'} at 0")
            yield curve
        if self.stencils is not None:
            yield _limit(self.stencils)
            basis = [point(u) for u in self.numbers.constants]
            several = " + ".join(f"f_{i} {u}" for i, u in enumerate(basis, 1)) if len(basis) > 1 else f"f {basis[0]}"
            yield Formula("F", several)

    def data(self) -> dict[str, Data]:
        """The JSON page: numbers are exact."""
        numbers, sequences = self.numbers, self.numbers.sequences
        return {
            "mask": {
                "arity": numbers.p,
                "start": numbers.scheme.start,
                "coefficients": numbers.scheme.coefficients,
            },
            "sums": tuple(map(rows_of, self.sums)),
            "constants": numbers.constants,
            "mean": rows_of(numbers.mean),
            "canonical_transformation": None if self.canonical is None else rows_of(self.canonical[0]),
            "eigen_sequences": () if sequences is None else sequences.each,
            "limit_stencils": None
            if self.stencils is None
            else {"start": self.stencils.start, "stencils": tuple(map(rows_of, self.stencils.each))},
        }


def _power(p: int, j: int) -> str:
    return "y" if j == 0 else f"{rational(Fraction(1, p**j))} y"


def _polynomial(y: Sequence[Vector]) -> str:
    """A polynomial sequence as text, the highest power first: `(1, 1) i^2 + (0, 1)`."""
    powers = ("", "i", *(f"i^{n}" for n in range(2, len(y))))
    terms = [(Fraction(1), f"{point(c, number)} {name}".strip()) for c, name in zip(y, powers, strict=False) if any(c)]
    return combination(reversed(terms))


def _spelled(rows: Sequence[Vector]) -> tuple[tuple[str, ...], ...]:
    return tuple(tuple(map(number, row)) for row in rows)
