"""SD611: does S converge uniformly, to a limit that is not zero for some data?

Theorem (Han & Jia 1998, Theorem 4.3, for any expanding M; numbers/difference_space.py for k > 1): S converges
uniformly iff its coset sums are 1 and ρ_k < 1, k any order of its sum rules. No stability is needed. Also proved by
directional difference schemes that contract (SD604), by a positive mask on a box (SD608), by a matrix scheme of
differences that contracts (SD606), or in the mean: ρ_k² is at most m Λ, Λ the growth of the mean squares (SD617),
m = |det M|; that is s > dimension/2 for its bound of s. Tensor products (SD609) converge iff all their factors do.
Hypotheses: the coset sums (SD601).

Witness: `by`, the code of the finding that decides.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.kinds.kind import ContradictionError, Facts
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.stages import tensor_products
from subdiv_cli.kinds.multivariate.stages.rule import growth_proof
from subdiv_cli.kinds.scalar.stages.stage import product_name
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.model import findings as questions

RULE = rules.CONVERGENCE

_QUESTION = "does S converge uniformly?"
_NORMS = {
    rules.DIRECTIONAL_NORMS.code: "the directional differences contract",
    rules.POSITIVE_MASK.code: "the mask is positive on a box",
    rules.MATRIX_NORMS.code: "a matrix scheme of differences contracts",
}
"""What proves it with a few numbers."""


def run(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    sums, found = (facts.find(rule) for rule in (rules.COSET_SUMS, rules.DIFFERENCE_RADIUS))
    norms = next((code for code in _NORMS if code in facts), None)
    if sums is not None and sums.verdict is Verdict.REFUTED:
        return (
            RULE.refuted(
                f"S does not converge uniformly to a non-zero limit: {sums.statement}", {"by": rules.COSET_SUMS.code}
            ),
        )
    if numbers.parts:
        yes, no = "S converges uniformly: its factors do", "S does not converge uniformly: its factor in {} does not"
        return (tensor_products.follows(RULE, _QUESTION, numbers.parts, questions.CONVERGENCE, yes, no),)
    radius, product = (numbers.radius, numbers.product) if found and found.verdict is Verdict.PROVED else (None, None)
    diverges = product is not None and product.compare(Fraction(1)) >= 0
    k = numbers.order
    if norms is not None or (radius is not None and radius.is_below(Fraction(1))):
        if diverges:
            raise ContradictionError(f"S converges and ρ_{k} is at least 1")
        if norms is not None:
            return (RULE.proved(f"S converges uniformly: {_NORMS[norms]}", {"by": norms}),)
        return (
            RULE.proved(
                f"S converges uniformly: the coset sums are 1 and ρ_{k} < 1", {"by": rules.DIFFERENCE_RADIUS.code}
            ),
        )
    if (mean := numbers.mean_decay) is not None and mean < 1:
        statement = (
            f"S converges uniformly: the mean squares of differences of order {k} decay fast enough for ρ_{k} < 1"
        )
        return (RULE.proved(statement, {"by": rules.SOBOLEV.code}, proof=growth_proof(numbers)),)
    if diverges and product is not None:
        statement = f"S does not converge uniformly: {product_name(product.word)} keeps ρ_{k} ≥ 1"
        return (RULE.refuted(statement, {"by": rules.DIFFERENCE_RADIUS.code, "word": product.word}),)
    reason = "no bound of ρ_k below 1 is proved, and no product is known that keeps it above"
    return (RULE.undecided(_QUESTION, (found.reason if found is not None else None) or reason),)
