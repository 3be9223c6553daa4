"""SD401: are the integer translates of the refinable function φ linearly independent?

Theorem (Jia & Wang 1993 for p = 2, Zhou 1996 for any arity): for a finite mask with a(1) = p, so that the refinable
distribution φ with ∫φ = 1 exists, the translates are linearly independent iff (i) the polyphase components
a_0, …, a_(p-1) have no common zero in C∖{0}, and (ii) there is no cycle. For a rational mask a cycle is an n > 1
coprime to p for which Φ_n(z^p)/Φ_n(z) divides a(z). Hypothesis a(1) = p: checked.

Witness, proved: `largest_n`, up to which cycles were looked for (the degree of the factor rules out larger ones); the
Bezout cofactors of the components are in SD402.
Refuted: `gcd`, or `cycle`, the n.
"""

from __future__ import annotations

from subdiv_cli.exact.text import laurent
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.stage import NOT_NORMALISED
from subdiv_cli.model import Finding

RULE = rules.INDEPENDENCE


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    return (_decide(numbers),)


def _decide(numbers: ScalarNumbers) -> Finding:
    p = numbers.p
    if not numbers.is_normalised:
        return RULE.skipped("are the integer translates of φ linearly independent?", NOT_NORMALISED)
    g = numbers.polyphase_gcd
    dependent = "the translates of φ are linearly dependent"
    if g.degree > 0:
        statement = f"{dependent}: {laurent(g)} divides all polyphase components"
        return RULE.refuted(statement, {"gcd": g.coefficients()})
    if (n := numbers.cycle) is not None:
        statement = f"{dependent}: Φ_{n}(z^{p})/Φ_{n}(z) divides a(z), a cycle of roots of unity of order {n}"
        return RULE.refuted(statement, {"cycle": n})
    largest = 10 * (numbers.scheme.degree // (p - 1))
    statement = "the translates of φ are linearly independent: the polyphase components are coprime and a(z) has no "
    return RULE.proved(statement + "cycle of roots of unity", {"largest_n": largest})
