"""SD402: are the integer translates of φ stable?

That is, the Fourier transform of φ has no 2π-periodic zero on the real line; for a bounded φ this means
c‖f‖∞ <= ‖Σ f_α φ(·-α)‖∞ for some c > 0 and all bounded f. For a φ that is a distribution it is the former.

Theorem (Jia & Wang 1993 for p = 2, Zhou 1996 for any arity): stable iff (i) the polyphase components have no common
zero on |z| = 1, and (ii) there is no cycle (SD401). Linear independence implies it. Hypothesis a(1) = p: checked.
A common zero on the circle is decided exactly: an irreducible factor of the gcd has one only if it is reciprocal, and
then its roots are told apart from their mirror images.

Witness, proved: `gcd` of the polyphase components, `starts` and `cofactors` (see below). Refuted: `circle_factor`,
lowest coefficient first, or `cycle`.
"""

from __future__ import annotations

from flint import fmpq_poly

from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.exact.text import laurent
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.model import Data, Finding, Verdict
from subdiv_cli.model.findings import Witness

RULE = rules.STABILITY


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    return (_decide(numbers, facts),)


def _decide(numbers: ScalarNumbers, facts: Facts) -> Finding:
    independent = facts.verdict(rules.INDEPENDENCE)
    if independent is Verdict.SKIPPED:
        return RULE.skipped("are the integer translates of φ stable?", facts[rules.INDEPENDENCE].reason or "")
    if independent is Verdict.PROVED:
        return RULE.proved("φ is stable: its integer translates are linearly independent", stability_witness(numbers))
    g = numbers.polyphase_gcd
    if numbers.circle_factors:
        factor = numbers.circle_factors[0]
        shown = laurent(Laurent(0, fmpq_poly(factor)))
        statement = f"φ is not stable: the polyphase components share zeros of {shown} on |z| = 1"
        return RULE.refuted(statement, {"circle_factor": tuple(int(c) for c in factor)})
    if (n := numbers.cycle) is not None:
        return RULE.refuted(f"φ is not stable: a(z) has a cycle of roots of unity of order {n}", {"cycle": n})
    statement = f"φ is stable: the common factor {laurent(g)} of the polyphase components has no zero on |z| = 1"
    return RULE.proved(f"{statement}, and a(z) has no cycle", stability_witness(numbers))


def stability_witness(numbers: ScalarNumbers) -> Witness:
    """`gcd` of the polyphase components, monic, and `starts` and `cofactors`: Laurent polynomials u_r, Σ u_r a_r = gcd.

    The latter are left out where they cost more than the effort.
    """
    witness: dict[str, Data] = {"gcd": numbers.polyphase_gcd.coefficients()}
    if (cofactors := numbers.bezout_cofactors) is not None:
        witness["starts"] = tuple(u.low for u in cofactors)
        witness["cofactors"] = tuple(u.coefficients() for u in cofactors)
    return witness
