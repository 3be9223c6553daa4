"""Smoother schemes and derived schemes of scalar masks, of any arity p (Dyn & Levin 2002, section 4).

With (Δ f)_i = f_(i+1) - f_i and s(z) = z^(1-p) (1+z+…+z^(p-1)) the mask Ia with (Ia)(z) = s(z) a(z) / p satisfies
Δ S_Ia = (1/p) S_a Δ, since z^-p - 1 = s(z) (z^-1 - 1). So p^n Δ S_Ia^n f = S_a^n Δ f: where S_a converges, limits of
S_Ia are integrals of limits of S_a, and each of these occurs, as Δ is onto: α grows by exactly 1. The mask ∂a with
I ∂a = a is unique, and ∂ Ia = a.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.laurent import Laurent, smoothing_factor
from subdiv_cli.exact.text import valued
from subdiv_cli.kinds.kind import NotSmoothedError, SmoothingStep
from subdiv_cli.kinds.scalar.scheme import ScalarScheme

_SOURCE = "Dyn, Levin 2002, section 4"


def smoother(scheme: ScalarScheme) -> SmoothingStep:
    """The scheme of Ia; its support begins p - 1 lower.

    Hypothesis: a(1) = p. All residue sums of Ia are 1 then, whether or not those of a are. Raises NotSmoothedError
    without it.
    """
    p, symbol = scheme.arity, _symbol(scheme)
    if (total := symbol(1)) != p:
        raise NotSmoothedError(f"the coefficients sum to {valued(total)}, which must be {p}, the arity")
    product = (symbol * smoothing_factor(p)).shift(1 - p).scale(Fraction(1, p))
    return SmoothingStep(_scheme(p, product), 1, f"the smoothing factor of {_SOURCE}", f"times {_factor(p)}/{p}")


def derived(scheme: ScalarScheme) -> SmoothingStep:
    """The scheme of ∂a; its support ends p - 1 lower.

    Hypothesis: all residue sums are 1, so that the smoothing factor divides a(z). Raises NotSmoothedError without it.
    """
    p, symbol = scheme.arity, _symbol(scheme)
    sums = [component(1) for component in symbol.components(p)]
    if any(total != 1 for total in sums):
        listed = ", ".join(map(valued, sums))
        raise NotSmoothedError(f"the sums over the residue classes are {listed}, and must all be 1")
    quotient, remainder = symbol.divide(smoothing_factor(p))
    assert not remainder.poly, "a symbol with residue sums 1 vanishes at the roots of unity"
    return SmoothingStep(
        _scheme(p, quotient.shift(p - 1).scale(p)), -1, f"the derived scheme of {_SOURCE}", f"{p}/{_factor(p)} times"
    )


def _symbol(scheme: ScalarScheme) -> Laurent:
    """The symbol of a mask."""
    return Laurent.from_coefficients(scheme.start, scheme.coefficients)


def _scheme(p: int, symbol: Laurent) -> ScalarScheme:
    """The scheme of a symbol."""
    return ScalarScheme(arity=p, start=symbol.low, coefficients=symbol.coefficients())


def _factor(p: int) -> str:
    """The smoothing factor as text."""
    return {2: "(1+z)", 3: "(1+z+z^2)"}.get(p, f"(1+…+z^{p - 1})")
