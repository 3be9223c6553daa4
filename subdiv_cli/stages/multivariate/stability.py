"""SD616: are the integer translates of φ stable?

Theorems. Box splines (SD603): iff the directions are unimodular (Dahmen & Micchelli 1983; Jia 1984; de Boor, Höllig &
Riemenschneider 1993, II.57). Interpolatory masks, a_(Mα) = δ_α, of schemes that converge (SD611): φ(α) = δ_α, so the
translates are stable and linearly independent. Others are not decided.

Witness: `by`, SD603 or SD611.
"""

from __future__ import annotations

from subdiv_cli.model import Finding, Verdict
from subdiv_cli.quantities.multivariate import MultivariateNumbers
from subdiv_cli.stages.multivariate.rule import Facts
from subdiv_cli.stages.stage import Rule, verdict

RULE = Rule("SD616", "surface-stability", "de Boor, Höllig & Riemenschneider 1993, II.57; Dyn 1992, section 6")

_QUESTION = "are the integer translates of φ stable?"


def run(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    if not numbers.is_normalised:
        return (RULE.skipped(_QUESTION, "the coefficients do not add up to |det M|, so there is no φ"),)
    if (box := numbers.box) is not None:
        if box.is_unimodular:
            statement = "φ is stable: the directions of the box spline are unimodular"
            return (RULE.proved(statement, {"by": "SD603"}),)
        return (RULE.refuted("φ is not stable: some directions have a determinant beyond ±1", {"by": "SD603"}),)
    if numbers.is_interpolatory and verdict(facts, "SD611") is Verdict.PROVED:
        return (RULE.proved("φ is stable: φ(0) = 1 and φ(α) = 0 at all other integers", {"by": "SD611"}),)
    return (RULE.undecided(_QUESTION, "φ is no box spline, and the scheme is not seen to interpolate"),)
