"""A scalar mask taken apart, for `show`: the findings of the stages, and what they leave out. No verdicts.

The symbol is factored over Q with the smoothing factors pulled out first; the zeros of the other factors are printed
with digits that are certain.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple

from flint import acb, fmpz_poly

from subdiv_cli.exact.algebraic import AlgebraicNumber, isolated_roots
from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.exact.linalg import rows_of
from subdiv_cli.exact.text import certain, number
from subdiv_cli.kinds.kind import Analysis
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.curve import Signal
from subdiv_cli.kinds.scalar.numbers.operators import refinement_window
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.values import at_fractions, support
from subdiv_cli.kinds.scalar.portrait.sections import aligned
from subdiv_cli.kinds.scalar.witnesses import (
    ApproximationOrderWitness,
    ErrorBoundWitness,
    HermiteBoundWitness,
    QuasiInterpolationWitness,
)
from subdiv_cli.model import DECIDED, Data, Result, Rule
from subdiv_cli.model.blocks import Block, Curve, Formula, Matrix, Portrait, Statements, Text, Words, sections
from subdiv_cli.model.findings import Form
from subdiv_cli.model.formulas import (
    brief,
    combination,
    datum,
    derivative,
    laurent,
    operator,
    polynomial,
    power,
    shifted,
)

_POINTS = 240
"""The least number of points of the curve."""
_MOST_ZEROS = 60
"""The largest degree of a factor whose zeros are listed."""
_LARGEST_MATRIX = 12


class SymbolFactor(NamedTuple):
    """An irreducible factor of a symbol over Q, or 1 + z + … + z^(p-1)."""

    coefficients: tuple[int, ...]
    """The coefficients, lowest power first."""
    multiplicity: int
    smoothing: bool = False
    zeros: tuple[str, ...] = ()
    """The zeros as text, digits that are certain; none for a smoothing factor."""

    @property
    def text(self) -> str:
        """The factor with its multiplicity as text: `(1 + z)^4`; a long smoothing factor as `(1 + z + … + z^6)`."""
        if self.smoothing and len(self.coefficients) > 4:
            inside = f"1 + z + … + z^{len(self.coefficients) - 1}"
        else:
            inside = laurent(0, self.coefficients, brief)
        return f"({inside})" + (f"^{self.multiplicity}" if self.multiplicity > 1 else "")

    def data(self) -> dict[str, Data]:
        """The factor as plain data for JSON."""
        return self._asdict()


def portrait(analysis: Analysis, result: Result) -> Portrait:
    """The sections of the page that are not empty, and its data."""
    page = _ScalarPage(analysis, result)
    parts = {
        "Mask": page.mask(),
        "Symbol": page.symbol(),
        "Derived schemes": page.derived_schemes(),
        "Refinement matrices": page.refinement_matrices(),
        "Refinable function": page.refinable_function(),
        "Limit stencils": page.limit_stencils(),
        "Polynomials": page.polynomials(),
        "Regularity": page.regularity(),
        "Distance to the limit": page.statements(rules.ERROR_BOUND, rules.HERMITE_BOUND),
    }
    return Portrait(sections(parts), page.data())


class _ScalarPage:
    """The parts of a page, each computed once; empty tuples and None where the scheme does not have it."""

    def __init__(self, analysis: Analysis, result: Result) -> None:
        self.numbers: ScalarNumbers = analysis.numbers
        self.result = result
        self.p = self.numbers.p
        self.window = refinement_window(self.numbers.scheme)
        self.own = Signal(self.numbers.scheme.start, self.numbers.scheme.coefficients)
        self.components = [Signal(a.low, a.coefficients()) for a in self.numbers.symbol.components(self.p)]
        derived = self._witness(rules.DERIVED_SCHEMES)
        self.derived = _signals(derived["starts"], derived["masks"]) if derived else []
        values = self._witness(rules.INTEGER_VALUES)
        self.values = _signals(values["starts"], values["values"]) if values else []
        limits = self._witness(rules.LIMIT_STENCILS)
        self.stencils = _signals(limits["starts"], limits["stencils"]) if limits else []
        self.quasi = self._witness(rules.QUASI_INTERPOLATION)

    def _witness(self, rule: Rule[Form]) -> Form | None:
        """The witness of the last decided finding of a rule, None where there is none."""
        decided = [each for each in self.result.findings if each.code == rule.code and each.verdict in DECIDED]
        return rule.witness_of(decided[-1]) if decided else None

    # sections

    def statements(self, *of: Rule[Any]) -> Iterator[Block]:
        """The block with the findings of these rules, if there are any."""
        findings = tuple(f for rule in of for f in self.result.findings if f.code == rule.code)
        if findings:
            yield Statements(findings)

    def mask(self) -> Iterator[Block]:
        yield Words("facts")
        yield aligned("i", [("a_i", self.own)], str, brief)

    def symbol(self) -> Iterator[Block]:
        yield Formula("a(z)", self.product)
        for factor in self.factors:
            if factor.zeros:
                yield Text(f"zeros of {laurent(0, factor.coefficients, brief)}: {', '.join(factor.zeros)}")
        for r, component in enumerate(self.components):
            yield Formula(f"a_{r}(z)", laurent(*component, brief))
        yield from self.statements(rules.SUM_RULES, rules.INDEPENDENCE, rules.STABILITY, rules.REDUCTION)

    def derived_schemes(self) -> Iterator[Block]:
        if self.derived:
            yield Text("the symbols of S_1, S_2, …, which act on divided differences")
        for nu, mask in enumerate(self.derived, 1):
            yield Formula(f"a^({nu})(z)", laurent(*mask, brief))

    def refinement_matrices(self) -> Iterator[Block]:
        if not self.matrices:
            return
        first, order = self.window.start, len(self.window)
        yield Text(f"A_ε[α, β] = a_(ε+α-{self.p}β) for α and β from {first} to {first + order - 1}")
        if order <= _LARGEST_MATRIX:
            for epsilon, matrix in enumerate(self.matrices):
                yield Matrix(f"A_{epsilon}", tuple(tuple(map(brief, row)) for row in matrix))
        else:
            yield Text(f"of order {order}; --format json has their entries")
        for epsilon, eigenvalues in enumerate(self.eigenvalues):
            yield Text(f"eigenvalues of A_{epsilon}: {', '.join(eigenvalues)}")

    def refinable_function(self) -> Iterator[Block]:
        if self.curve is None:
            yield from self.statements(rules.INTEGER_VALUES, rules.SMOOTHNESS)
            return
        first, last = self.curve.support
        yield Text(f"φ is supported in [{first}, {last}]; its translates sum to 1")
        yield self.curve
        rows = [(f"{derivative('φ', order)}(i)", values) for order, values in enumerate(self.values)]
        yield aligned("i", rows, str, brief, "0")

    def limit_stencils(self) -> Iterator[Block]:
        if self.stencils:
            yield Text(f"the limit and its derivatives at i/{self.p}^k from the data f of level k")
        else:
            yield from self.statements(rules.LIMIT_STENCILS)
        for order, stencil in enumerate(self.stencils):
            scale = f"{self.p}^{'k' if order == 1 else f'({order}k)'} times"
            yield Text(f"derivative of order {order}: {scale}" if order else "the limit")
            yield aligned("f", [("", stencil)], lambda by: datum("i", by), brief)

    def polynomials(self) -> Iterator[Block]:
        yield from self.statements(rules.GENERATION, rules.REPRODUCTION, rules.INTERPOLATORY_ORDER)
        if (quasi := self.quasi) is None:
            yield from self.statements(rules.APPROXIMATION_ORDER, rules.QUASI_INTERPOLATION)
            return
        yield Text("moments: " + ", ".join(f"m_{i} = {brief(m)}" for i, m in enumerate(quasi["moments"])))
        yield Formula("Q f", operator(quasi["operator"], brief))
        yield aligned("", [("Q f(i)", _quasi_stencil(quasi))], lambda by: f"f({shifted('i', by)})", brief)
        for i, sequence in enumerate(quasi["eigen_sequences"]):
            yield Formula(f"Q {power('x', i) or '1'}", polynomial(sequence, brief))
        yield Text(f"sampled at the integers, Q x^i is an eigen-sequence of S for {self.p}^-i")
        yield from self.statements(rules.APPROXIMATION_ORDER)

    def regularity(self) -> Iterator[Block]:
        yield from self.statements(rules.CONVERGENCE, rules.SMOOTHNESS, rules.NEXT_SMOOTHNESS)
        yield Words("exponents")

    # what the stages leave unsaid

    @property
    def eigenvalues(self) -> tuple[tuple[str, ...], ...]:
        witness = self._witness(rules.EIGEN_CONDITION)
        return witness["eigenvalues"] if witness else ()

    @cached_property
    def matrices(self) -> tuple[tuple[tuple[Fraction, ...], ...], ...]:
        """The refinement matrices A_0, …, A_(p-1) by rows, none where they are large or the window is empty."""
        order = len(self.window)
        if not order or not self.numbers.effort.allows(self.p * order**2):
            return ()
        return tuple(rows_of(matrix) for matrix in self.numbers.refinement_matrices)

    @property
    def factors(self) -> tuple[SymbolFactor, ...]:
        return self._factored[2]

    @property
    def product(self) -> str:
        """The factored symbol as text: `-1/16 z^-3 (1 + z)^4 (1 - 4 z + z^2)`."""
        constant, low, factors = self._factored
        parts = [power("z", low), *(factor.text for factor in factors)]
        return combination([(constant, " ".join(filter(None, parts)))], brief)

    @cached_property
    def _factored(self) -> tuple[Fraction, int, tuple[SymbolFactor, ...]]:
        """The factorisation (c, s, factors) with a(z) = c z^s Π factors^multiplicity."""
        numbers = self.numbers
        order, cofactor, _ = numbers.sum_rules
        factors = [SymbolFactor((1,) * numbers.p, order, smoothing=True)] if order else []
        numerators, denominator = cofactor.integer_form()
        if not numbers.effort.allows(cofactor.degree**2 * numbers.weight):
            whole = tuple(int(c) for c in numerators)
            return (
                Fraction(1, denominator),
                cofactor.low,
                (*factors, *([SymbolFactor(whole, 1)] if len(whole) > 1 else [])),
            )
        content, others = numerators.factor()
        factors += [SymbolFactor(tuple(int(c) for c in f), m, zeros=_zeros(f)) for f, m in others]
        return Fraction(int(content), denominator), cofactor.low, tuple(factors)

    @cached_property
    def curve(self) -> Curve | None:
        """The curve of φ at i/p^m, the smallest m that makes enough points; None where the values are not known."""
        if not self.values:
            return None
        p, level = self.p, 0
        while self.numbers.scheme.degree * p**level < _POINTS * (p - 1):
            level += 1
        fine = at_fractions(self.numbers.symbol, p, Laurent.from_coefficients(*self.values[0]), 0, level)
        return Curve(p, level, fine.low, fine.coefficients(), support(self.numbers))

    # data

    def data(self) -> dict[str, Data]:
        """The JSON page: numbers are exact, sequences have the index of their first value."""
        orders, bound = self._witness(rules.APPROXIMATION_ORDER), self._witness(rules.ERROR_BOUND)
        hermite, curve = self._witness(rules.HERMITE_BOUND), self.curve
        return {
            "mask": _signal(self.own),
            "symbol": {
                "text": self.product,
                "constant": self._factored[0],
                "power": self._factored[1],
                "factors": tuple(factor.data() for factor in self.factors),
            },
            "polyphase": tuple(map(_signal, self.components)),
            "derived": tuple({"nu": nu} | _signal(mask) for nu, mask in enumerate(self.derived, 1)),
            "refinement_matrices": {
                "first_index": self.window.start,
                "matrices": self.matrices,
                "eigenvalues": self.eigenvalues,
            },
            "support": support(self.numbers),
            "values": _by_order(self.values),
            "stencils": _by_order(self.stencils),
            "quasi_interpolation": None if self.quasi is None else _quasi_interpolation(self.quasi),
            "approximation_order": None if orders is None else _approximation_order(orders),
            "error_bound": None if bound is None else _error_bound(bound),
            "hermite_bound": None if hermite is None else _hermite_bound(hermite),
            "curve": None if curve is None else {key: getattr(curve, key) for key in _OF_CURVES},
        }


_OF_CURVES = ("arity", "level", "start", "values")


def _signal(signal: Signal) -> dict[str, Data]:
    return signal._asdict()


def _by_order(signals: Sequence[Signal]) -> tuple[Data, ...]:
    return tuple({"order": order} | _signal(signal) for order, signal in enumerate(signals))


def _signals(starts: Sequence[int], values: Sequence[tuple[Fraction, ...]]) -> list[Signal]:
    return [Signal(*pair) for pair in zip(starts, values, strict=True)]


def _quasi_stencil(quasi: QuasiInterpolationWitness) -> Signal:
    return Signal(quasi["stencil_start"], quasi["stencil"])


def _quasi_interpolation(quasi: QuasiInterpolationWitness) -> dict[str, Data]:
    return {
        "degree": quasi["degree"],
        "moments": quasi["moments"],
        "operator": quasi["operator"],
        "stencil": _signal(_quasi_stencil(quasi)),
        "eigen_sequences": quasi["eigen_sequences"],
    }


def _approximation_order(orders: ApproximationOrderWitness) -> dict[str, Data]:
    return {"with_q": orders["with_q"], "without_q": orders["without_q"]}


def _error_bound(bound: ErrorBoundWitness) -> dict[str, Data]:
    return {
        "constant": bound["constant"],
        "norms": bound["norms"],
        "level": bound["level"],
        "distance": bound["distance"],
        "tolerance": bound["tolerance"],
        "levels": bound["levels"],
    }


def _hermite_bound(bound: HermiteBoundWitness) -> dict[str, Data]:
    return {"order": bound["order"], "constant": bound["constant"]}


def _zeros(f: fmpz_poly) -> tuple[str, ...]:
    """The zeros as text: real ones by size, then pairs `x ± yi`."""
    if f.degree() > _MOST_ZEROS:
        return ()
    balls = isolated_roots(f)
    zeros = [AlgebraicNumber(f, z) for z in balls]
    real = sorted((x for x in zeros if x.is_real), key=lambda x: float(x.region.real.mid()))
    upper = [x for x in zeros if not x.is_real and x.region.imag > 0]
    return (*map(_real, real), *(_pair(x, balls) for x in upper))


def _real(x: AlgebraicNumber) -> str:
    exact = x.rational
    return number(exact) if exact is not None else certain(lambda: x.enclosure().real, 6)


def _pair(x: AlgebraicNumber, balls: list[acb]) -> str:
    """A pair of complex zeros as text; its real part exactly where f is quadratic, or where it is 0.

    A zero of an even polynomial that alone is near its mirror image -z̄, which is a zero too, is this image.
    """
    f = x.minimal_polynomial
    even = not any(int(c) for c in list(f)[1::2])
    mirror = -x.region.conjugate()
    if f.degree() == 2:
        part = Fraction(-int(f[1]), 2 * int(f[2]))
        real = number(part) if part else ""
    elif even and [z.overlaps(x.region) for z in balls if z.overlaps(mirror)] == [True]:
        real = ""
    else:
        real = certain(lambda: x.enclosure().real, 6)
    return f"{real} ± {certain(lambda: x.enclosure().imag, 6)}i".strip()
