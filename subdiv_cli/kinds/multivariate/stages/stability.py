"""SD616: are the integer translates of φ stable?

Theorems. Box splines (SD603): iff the directions are unimodular (Dahmen & Micchelli 1983; Jia 1984; de Boor, Höllig &
Riemenschneider 1993, II.57). Interpolatory masks, a_(Mα) = δ_α, of schemes that converge (SD611): φ(α) = δ_α, so the
translates are stable and linearly independent. Tensor products (SD609) that converge: iff all factors are. Of all other
schemes that converge: iff the symbol of the Gram sequence g_α = ∫ φ φ(·-α) has no zero on the torus (Jia & Micchelli
1991; numbers/gram.py). Hypothesis of the last three, convergence: checked. Of schemes that do not converge only box
splines are decided.

Witness: `by`, SD603, SD609 or SD611; of a Gram sequence `zero`, k, with `order`, n, where it is zero at 2πk/n, or
`boxes`, how many show that it is positive. `proof`: the sequence and the tree of the boxes.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.numbers.gram import LEAF, Gram
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.stages import tensor_products
from subdiv_cli.model import Data, Finding, Verdict
from subdiv_cli.model import findings as questions

RULE = rules.STABILITY

_QUESTION = "are the integer translates of φ stable?"


def run(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    if not numbers.is_normalised:
        return (RULE.skipped(_QUESTION, "the coefficients do not add up to |det M|, so there is no φ"),)
    if (box := numbers.box) is not None:
        if box.is_unimodular:
            statement = "φ is stable: the directions of the box spline are unimodular"
            return (RULE.proved(statement, {"by": rules.BOX_SPLINE.code}),)
        return (
            RULE.refuted(
                "φ is not stable: some directions have a determinant beyond ±1", {"by": rules.BOX_SPLINE.code}
            ),
        )
    if facts.verdict(rules.CONVERGENCE) is not Verdict.PROVED:
        return (RULE.undecided(_QUESTION, "φ is no box spline, and it is not proved that the scheme converges"),)
    if numbers.parts:
        yes, no = "φ is stable: its factors are", "φ is not stable: its factor in {} is not"
        return (tensor_products.follows(RULE, _QUESTION, numbers.parts, questions.STABILITY, yes, no),)
    if numbers.is_interpolatory:
        return (
            RULE.proved("φ is stable: φ(0) = 1 and φ(α) = 0 at all other integers", {"by": rules.CONVERGENCE.code}),
        )
    return (_of_gram_sequence(numbers.gram),)


def _of_gram_sequence(found: Gram | None) -> Finding:
    if found is None:
        return RULE.undecided(_QUESTION, "the Gram sequence of the translates is too long")
    proof: dict[str, Data] = {"gram": tuple(found.sequence.items()), "correlations": found.correlations}
    if found.zero is not None:
        k, n = found.zero
        at = f"2π({', '.join(str(Fraction(x, n)) for x in k)})"
        statement = f"φ is not stable: Σ ∫φφ(·−α) e^(iα·ω) is zero at ω = {at}"
        return replace(RULE.refuted(statement, {"by": rules.CONVERGENCE.code, "zero": k, "order": n}), proof=proof)
    if found.tree is None:
        return RULE.undecided(_QUESTION, "the symbol of the Gram sequence is not seen to be positive or to have a zero")
    boxes = found.tree.count(LEAF)
    statement = f"φ is stable: Σ ∫φφ(·−α) e^(iα·ω) is positive for all ω, on each of {boxes} boxes"
    proof |= {"tree": found.tree}
    return RULE.proved(statement, {"by": rules.CONVERGENCE.code, "boxes": boxes}, proof=proof)
