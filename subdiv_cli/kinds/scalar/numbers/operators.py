"""The operators of a scalar scheme: its symbol, its action on data, its difference schemes and transition matrices."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from flint import fmpq, fmpq_mat

from subdiv_cli.exact.laurent import Laurent, smoothing_factor
from subdiv_cli.kinds.scalar.scheme import ScalarScheme


def symbol(scheme: ScalarScheme) -> Laurent:
    """The symbol a(z) = Σ a_α z^α of the scheme."""
    return Laurent.from_coefficients(scheme.start, scheme.coefficients)


def apply(a: Laurent, p: int, data: Mapping[int, Fraction]) -> dict[int, Fraction]:
    """The refined data (S f)_α = Σ_β a_(α-pβ) f_β for finitely supported data f (Dyn 2.1)."""
    refined: dict[int, Fraction] = {}
    for beta, value in data.items():
        for i, c in enumerate(a.coefficients()):
            index = a.low + i + p * beta
            refined[index] = refined.get(index, Fraction(0)) + c * value
    return refined


def difference_symbol(a: Laurent, p: int, nu: int) -> Laurent:
    """The symbol of S_(Δ^ν): Δ^ν S = S_(Δ^ν) Δ^ν with (Δf)_i = f_(i+1) - f_i (Dyn 3.1, 3.17).

    It is a(z) (z^(p-1) / (1+z+…+z^(p-1)))^ν, and p^ν times it is the symbol of the derived scheme S_ν. Raises
    ValueError where ν exceeds the sum-rule order.
    """
    for _ in range(nu):
        a, remainder = a.divide(smoothing_factor(p))
        if remainder.poly:
            raise ValueError(f"no difference scheme of order {nu}")
    return a.shift((p - 1) * nu)


def transition_matrices(d: Laurent, p: int) -> tuple[fmpq_mat, ...]:
    """The p transition matrices T_0, …, T_(p-1), N×N, of the scheme with symbol d, shifted to start at 0 (Dyn 4.2).

    The shift is harmless for norms and spectra. With n = degree(d) and N = max(1, ⌈n/(p-1)⌉): T_ε[i, j] =
    d_(ε+i-pj+(p-1)(N-1)), 0 <= i, j < N. The norm of the L-th power of the scheme is the largest ‖T_(ε_L) … T_(ε_1)‖∞.
    """
    c = list(d.poly)
    size = max(1, -(-(len(c) - 1) // (p - 1)))
    return tuple(_window(c, p, range(size), epsilon + (p - 1) * (size - 1)) for epsilon in range(p))


def refinement_window(scheme: ScalarScheme) -> range:
    """The indices of the refinement matrices, in the mask's own indexing: {⌊1-(s+n)/(p-1)⌋, …, ⌈-s/(p-1)⌉}."""
    s, p = scheme.start, scheme.arity
    return range((p - 1 - s - scheme.degree) // (p - 1), -(s // (p - 1)) + 1)


def refinement_matrices(scheme: ScalarScheme) -> tuple[fmpq_mat, ...]:
    """The p refinement matrices A_ε[α, β] = a_(ε+α-pβ), ε < p, α and β in the refinement window (Dyn 4.1, 4.2)."""
    c = list(symbol(scheme).poly)
    window = refinement_window(scheme)
    return tuple(_window(c, scheme.arity, window, epsilon - scheme.start) for epsilon in range(scheme.arity))


def _window(c: list[fmpq], p: int, window: range, offset: int) -> fmpq_mat:
    """The matrix c_(offset + α - pβ), α and β in the window."""
    entries = [
        c[k] if 0 <= (k := offset + alpha - p * beta) < len(c) else fmpq(0) for alpha in window for beta in window
    ]
    return fmpq_mat(len(window), len(window), entries)
