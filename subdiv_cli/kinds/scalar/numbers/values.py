"""Exact values of φ and its derivatives: at the integers, at i/p^m, and of the limit function of any data.

φ^(j) = Σ_α a_α p^j φ^(j)(p·-α), so the values h_i = φ^(j)(i) are an eigenvector: of S_j for 1, up to differences. All
sequences are Laurent polynomials, Σ_i h_i z^i. Indices are the mask's own: a shift of the mask by t moves φ by t/(p-1).
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.kinds.scalar.numbers.operators import refinement_matrices, refinement_window
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.spectra import limit_stencil
from subdiv_cli.kinds.scalar.scheme import ScalarScheme


def limit_weights(numbers: ScalarNumbers, order: int) -> Laurent:
    """The weights w with (S^∞ f)^(order)(ℓ p^-k) = p^(order·k) Σ_β w_β f^k_(ℓ+β), f^k = S^k f (Dyn 4.3, 4.6).

    The left eigenvector v of A_0 of S_order for 1, Σ v = 1, acts on differences of that order: w(z) = (z-1)^order v(z).
    Needs S_order to converge, which makes v unique. Raises ArithmeticError where it is not.
    """
    symbol = numbers.difference(order).scale(numbers.p**order)
    derived = ScalarScheme(arity=numbers.p, start=symbol.low, coefficients=symbol.coefficients())
    v = limit_stencil(refinement_matrices(derived)[0])
    if v is None:
        raise ArithmeticError(f"S_{order} has no unique limit stencil")
    weights = Laurent.from_coefficients(refinement_window(derived)[0], v)
    for _ in range(order):
        weights = weights * Laurent.from_coefficients(0, [-1, 1])
    return weights


def at_integers(numbers: ScalarNumbers, order: int) -> Laurent:
    """The values of φ^(order) at the integers, through φ = Σ g_j φ0(·-j)/g(1) where the mask is unstable.

    φ0 is that of its reduction. Needs φ ∈ C^order, proved for the (reduced) mask by the convergence of its S_order:
    φ(ℓ) = w_(-ℓ) for the data δ.
    """
    values = limit_weights(numbers.reduced, order).reversed()
    for step in numbers.reduction:
        values = values * step.factor.scale(1 / step.factor(1))
    return values


def iterated(a: Laurent, p: int, level: int) -> Laurent:
    """The iterated symbol a^[level](z) = Π_(j<level) a(z^(p^j)), which is S^level δ."""
    total = Laurent.from_coefficients(0, [1])
    for j in range(level):
        total = total * a.inflate(p**j)
    return total


def at_fractions(a: Laurent, p: int, values: Laurent, order: int, level: int, data: Laurent | None = None) -> Laurent:
    """The values of (Σ_α f_α φ(·-α))^(order) at i/p^level, from φ^(order) at the integers; f = δ by default.

    φ(x) = Σ_i a^[level]_i φ(p^level x - i), differentiated `order` times.
    """
    total = iterated(a, p, level) * values.scale(Fraction(p) ** (order * level))
    return total if data is None else total * data.inflate(p**level)


def support(numbers: ScalarNumbers) -> tuple[Fraction, Fraction]:
    """The convex hull of the support of φ: [s/(p-1), (s+n)/(p-1)]."""
    scheme, p = numbers.scheme, numbers.p
    return Fraction(scheme.start, p - 1), Fraction(scheme.start + scheme.degree, p - 1)
