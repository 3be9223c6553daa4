"""SD501: φ and its derivatives at the integers, exactly.

Theorem (Dyn 1992, Theorem 4.2 and Corollaries 4.3, 4.6, for any arity p): where S_j converges, A_0 of S_j has the
simple eigenvalue 1, and φ^(j)(ℓ) for all integers ℓ is read off its left eigenvector v with Σ v = 1
(quantities/values.py). The mask's own indexing is kept: its support {s, …, s+n} makes that of φ [s/(p-1), (s+n)/(p-1)],
and φ vanishes outside. Σ φ(·-i) = 1, because S maps constants to themselves; at the integers the values show it.
Hypothesis, φ ∈ C^j by the convergence of S_j of the mask or, for an unstable one, of the reduced mask (SD302, SD403):
checked. The values of φ then are those of φ0 combined with the factors of the reduction.

Witness: `starts` and `values`, for j = 0, …, n the first index and the values of φ^(j) from there to the last that is
not 0; `own_starts` and `own_values`, those of the reduced mask; `support`.
"""

from __future__ import annotations

from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import ContradictionError, Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.values import at_integers, support
from subdiv_cli.kinds.scalar.stages.stage import integer
from subdiv_cli.model import Data, Finding, Verdict
from subdiv_cli.model.formulas import derivative

RULE = rules.INTEGER_VALUES

_QUESTION = "what are the values of φ at the integers?"
_MOST_SHOWN = 9


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    if facts.verdict(rules.SMOOTHNESS) is not Verdict.PROVED:
        return (RULE.skipped(_QUESTION, "φ is not proved continuous"),)
    reduced = numbers.reduced
    size = -(-reduced.scheme.degree // (numbers.p - 1)) + 2
    if not numbers.effort.allows(size**3 * reduced.weight // 4):
        return (RULE.undecided(_QUESTION, "the refinement matrix is too large for this effort"),)
    orders = range(integer(facts[rules.SMOOTHNESS], "order") + 1)
    values = [at_integers(numbers, order) for order in orders]
    own = [at_integers(numbers.reduced, order) for order in orders]
    if sum(values[0].coefficients()) != 1:
        raise ContradictionError("the translates of φ do not sum to 1")
    first, last = support(numbers)
    witness: dict[str, Data] = {
        "starts": tuple(v.low for v in values),
        "values": tuple(v.coefficients() for v in values),
        "own_starts": tuple(v.low for v in own),
        "own_values": tuple(v.coefficients() for v in own),
        "support": (first, last),
    }
    shown = ", ".join(_line(value, order) for order, value in enumerate(values[:2]))
    where = f"φ is supported in [{first}, {last}] and Σ φ(·-i) = 1"
    return (RULE.proved(f"{shown}, and 0 at all other integers; {where}", witness),)


def _line(values: Laurent, order: int) -> str:
    """`φ(-1, 0, 1) = 1/6, 2/3, 1/6`."""
    c = values.coefficients()
    places = [str(values.low + i) for i in range(len(c))]
    name = derivative("φ", order)
    if len(c) > _MOST_SHOWN:
        return f"{name} has the values {', '.join(map(number, c[:_MOST_SHOWN]))}, … at {places[0]}, …, {places[-1]}"
    return f"{name}({', '.join(places)}) = {', '.join(map(number, c))}"


def unusable(facts: Facts) -> str | None:
    """Why limits cannot be spoken of with the values of φ; None where they can."""
    if facts.verdict(rules.CONVERGENCE) is not Verdict.PROVED:
        return "S is not proved to converge"
    return None if facts.verdict(rules.INTEGER_VALUES) is Verdict.PROVED else "the values of φ are not known"
