"""Stages on the distance to the limit (SD511, SD512)."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.text import number, valued
from subdiv_cli.kinds.kind import Facts, Stage
from subdiv_cli.kinds.scalar.numbers.error_bounds import ErrorBound, best_bound
from subdiv_cli.kinds.scalar.numbers.error_bounds import hermite_bound as best_hermite_bound
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.rules import CONVERGENCE, ERROR_BOUND, HERMITE_BOUND, SMOOTHNESS
from subdiv_cli.kinds.scalar.witnesses import ErrorBoundWitness, HermiteBoundWitness
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.model.formulas import is_plain

_ERROR_BOUND_QUESTION = "how close to the limit is the control polygon?"


def error_bound(tolerance: Fraction) -> Stage:
    """SD511: how close the control polygon of level k is to the limit.

    Theorem (Dyn 1992, Corollary 3.3, for any arity p): with μ = ‖((1/p)S_1)^L‖∞ < 1 and S - U = e(Δ·), U the linear
    spline and E = max_γ Σ_β |e_(γ+pβ)|,

        ‖S^∞ f - f^k‖∞ <= C μ^⌊k/L⌋ ‖Δf‖∞,  C = E L/(1-μ) · max_(j<L) ‖((1/p)S_1)^j‖∞,

    f^k being the polygon with the vertices f^k_i at i p^-k, in the mask's own indexing: a shifted mask has another E,
    and another polygon. Hypothesis, a norm below 1: checked. L is that with which fewest levels are needed for the
    tolerance.

    Witness: `nu`, 0; `level`, L; `norms` of levels 1 to L, the last one μ; `distance`, E; `constant`, C; `tolerance`
    and `levels`, the smallest multiple k of L with C μ^(k/L) <= tolerance.

    Returns the stage for a tolerance relative to ‖Δf‖∞.
    """

    def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
        if facts.verdict(CONVERGENCE) is not Verdict.PROVED:
            return (ERROR_BOUND.skipped(_ERROR_BOUND_QUESTION, "S is not proved to converge"),)
        bound = best_bound(numbers, tolerance)
        levels = None if bound is None else bound.levels_for(tolerance)
        if bound is None or levels is None:
            reason = "no norm of (1/p)S_1 below 1 within this effort makes a reasonable bound"
            return (ERROR_BOUND.undecided(_ERROR_BOUND_QUESTION, reason),)
        witness: ErrorBoundWitness = {
            "nu": 0,
            "level": bound.level,
            "norms": bound.norms,
            "distance": bound.distance,
            "constant": bound.constant,
            "tolerance": tolerance,
            "levels": levels,
        }
        statement = (
            f"‖S^∞ f - f^k‖∞ ≤ {_geometric(bound)} ‖Δf‖∞; "
            f"{levels} level{'' if levels == 1 else 's'} bring it below {number(tolerance)} ‖Δf‖∞"
        )
        return (ERROR_BOUND.proved(statement, witness),)

    return run


_LARGEST = 10**300
"""The largest constant whose size is told: larger ones are no doubles."""


def _geometric(bound: ErrorBound) -> str:
    """The bound as text: `2 (3/4)^k`; a long one with its size, `5/3 (16295/16384)^⌊k/5⌋ (≈ 1.67 · 0.999^k)`."""
    exponent = "k" if bound.level == 1 else f"⌊k/{bound.level}⌋"
    text = f"{number(bound.constant)} ({number(bound.norm)})^{exponent}"
    plain = bound.level == 1 and is_plain(bound.constant) and is_plain(bound.norm)
    if plain or bound.constant > _LARGEST:
        return text
    rate = float(bound.norm) ** (1 / bound.level)
    return f"{text} (≈ {float(bound.constant):.3g} · {rate:.3g}^k)"


_HERMITE_BOUND_QUESTION = "how close to the limit is its Hermite interpolant?"


def hermite_bound(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD512: how close the Hermite interpolant of the limit at i p^-k is to the limit.

    Theorem (Dyn 1992, Proposition 4.7, for any arity p): let S_ν converge, ν = 2m. The piecewise polynomial Q^k of
    degree ν-1 that has the values and derivatives of S^∞ f up to order m-1 at the points i p^-k satisfies ‖S^∞ f -
    Q^k‖∞ <= H p^-(νk) ‖Δ^ν f‖∞. Here H = B/(2^ν ν!), from the error of Hermite interpolation on an interval of length
    p^-k and ‖(S^∞ f)^(ν)‖∞ = ‖S_ν^∞ Δ^ν f‖∞ <= B ‖Δ^ν f‖∞; B = ‖S_ν^j‖∞ + 2 C μ^⌊j/L⌋ by the bound of SD511 for S_ν.
    The data of Q^k are known exactly (SD502). Hypotheses: S converges (SD201), and a norm of ((1/p)S_(ν+1))^L below 1,
    which makes S_ν converge: checked; ν is the largest even order for which there is one.

    Witness: `order`, ν; `norms` of ((1/p)S_(ν+1))^1, …, ^L; `derived_constant`, C; `level`, j, and `norm`, that of
    ((1/p)S_ν)^j; `constant`, H.
    """
    smooth = facts.verdict(SMOOTHNESS) is Verdict.PROVED and facts.verdict(CONVERGENCE) is Verdict.PROVED
    order = min(facts.witness(SMOOTHNESS)["order"], numbers.order - 1) if smooth else 0
    for nu in range(order - order % 2, 0, -2):
        best = best_hermite_bound(numbers, nu)
        if best is not None:
            break
    else:
        return (HERMITE_BOUND.skipped(_HERMITE_BOUND_QUESTION, "S_2 is not proved to converge"),)
    witness: HermiteBoundWitness = {
        "order": nu,
        "norms": best.bound.norms,
        "derived_constant": best.bound.constant,
        "level": best.level,
        "norm": best.norm,
        "constant": best.constant,
    }
    bound = f"{valued(best.constant)} · {numbers.p}^(-{nu}k) ‖Δ^{nu} f‖∞"
    statement = f"‖S^∞ f - Q^k‖∞ ≤ {bound} for the Hermite interpolant Q^k of degree {nu - 1} at i/{numbers.p}^k"
    return (HERMITE_BOUND.proved(statement, witness),)
