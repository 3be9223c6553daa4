"""SD511: how close the control polygon of level k is to the limit.

Theorem (Dyn 1992, Corollary 3.3, for any arity p): with μ = ‖((1/p)S_1)^L‖∞ < 1 and S - U = e(Δ·), U the linear spline
and E = max_γ Σ_β |e_(γ+pβ)|,

    ‖S^∞ f - f^k‖∞ <= C μ^⌊k/L⌋ ‖Δf‖∞,  C = E L/(1-μ) · max_(j<L) ‖((1/p)S_1)^j‖∞,

f^k being the polygon with the vertices f^k_i at i p^-k, in the mask's own indexing: a shifted mask has another E, and
another polygon. Hypothesis, a norm below 1: checked. L is that with which fewest levels are needed for the tolerance.

Witness: `nu`, 0; `level`, L; `norms` of levels 1 to L, the last one μ; `distance`, E; `constant`, C; `tolerance` and
`levels`, the smallest multiple k of L with C μ^(k/L) <= tolerance.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import Facts, Stage
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.error_bounds import best_bound
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.model import Data, Finding, Verdict

RULE = rules.ERROR_BOUND

_QUESTION = "how close to the limit is the control polygon?"


def stage(tolerance: Fraction) -> Stage:
    """The stage for a tolerance, relative to ‖Δf‖∞."""

    def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
        if facts.verdict(rules.CONVERGENCE) is not Verdict.PROVED:
            return (RULE.skipped(_QUESTION, "S is not proved to converge"),)
        bound = best_bound(numbers, tolerance)
        levels = None if bound is None else bound.levels_for(tolerance)
        if bound is None or levels is None:
            reason = "no norm of (1/p)S_1 below 1 within this effort makes a reasonable bound"
            return (RULE.undecided(_QUESTION, reason),)
        witness: dict[str, Data] = {
            "nu": 0,
            "level": bound.level,
            "norms": bound.norms,
            "distance": bound.distance,
            "constant": bound.constant,
            "tolerance": tolerance,
            "levels": levels,
        }
        exponent = "k" if bound.level == 1 else f"⌊k/{bound.level}⌋"
        statement = (
            f"‖S^∞ f - f^k‖∞ ≤ {number(bound.constant)} ({number(bound.norm)})^{exponent} ‖Δf‖∞; "
            f"{levels} level{'' if levels == 1 else 's'} bring it below {number(tolerance)} ‖Δf‖∞"
        )
        return (RULE.proved(statement, witness),)

    return run
