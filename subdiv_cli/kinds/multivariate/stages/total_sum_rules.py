"""SD602: the order of the sum rules of total degree.

Definition (Jia 1998; Levin 2003, section 2): sum rules of order k, if for polynomials p of total degree < k the sums
Σ_β a_(γ+Mβ) p(γ+Mβ) are the same for all cosets, those of p = 1 being 1. Then S maps polynomials of degree < k to such,
with the same leading part up to the dilation: it generates them (Dyn 1992, 7.6). No hypotheses.

Witness: `order`, the largest k.
"""

from __future__ import annotations

from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.model import Finding
from subdiv_cli.model import findings as questions

RULE = rules.SUM_RULES


def run(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    k = numbers.order
    if not k:
        return (
            RULE.refuted("no sum rules: the coset sums are not all 1", {"order": 0}, answers={questions.SUM_RULES: 0}),
        )
    generated = {1: "constants", 2: "polynomials of total degree 1"}.get(k, f"polynomials of total degree {k - 1}")
    answers = {questions.SUM_RULES: k, questions.GENERATION: k - 1}
    return (RULE.proved(f"sum rules of order {k}: {generated} are generated", {"order": k}, answers=answers),)
