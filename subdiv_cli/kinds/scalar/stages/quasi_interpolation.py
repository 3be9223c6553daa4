"""SD503: the operator Q with S^∞ Q f = f for all polynomials f that S generates.

Theorem (Levin 2003, Corollary 2.4 and (15), (16)): let S converge and S π_m = π_m. On π_m S^∞ f = Σ m_i/i! D^i f with
the moments m_i = Σ_β φ(-β) β^i, and Q = Σ q_i D^i is its inverse: S Q = Q σ, σ f = f(·/p). Q x^i sampled at the
integers is an eigen-sequence of S for p^-i. m is the generation degree (SD103). Hypothesis, S converges (SD201):
checked; the values of φ: SD501. As a stencil Q is the shortest combination of samples near the centre of φ that is
right on π_m, symmetric where the mask is; on other functions the two differ.

Witness: `degree`, m; `moments`; `operator`, q_0, …, q_m; `stencil_start` and `stencil`; `eigen_sequences`, for i = 0,
…, m the coefficients of Q x^i, lowest power first.
"""

from __future__ import annotations

from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.quasi_interpolation import eigen_sequence, moments, operator, stencil
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.values import at_integers
from subdiv_cli.kinds.scalar.stages.integer_values import unusable
from subdiv_cli.model import Data, Finding
from subdiv_cli.model.formulas import operator as formula
from subdiv_cli.model.formulas import stencil as combination

RULE = rules.QUASI_INTERPOLATION

_MOST_WEIGHTS = 9


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    if (why := unusable(facts)) is not None:
        return (RULE.skipped("which data have a given polynomial as limit?", why),)
    m, mask = numbers.order - 1, numbers.scheme.coefficients
    moment = moments(at_integers(numbers, 0), m + 1)
    q = operator(moment)
    t = stencil(q, mask == mask[::-1])
    witness: dict[str, Data] = {
        "degree": m,
        "moments": moment,
        "operator": q,
        "stencil_start": t.low,
        "stencil": t.coefficients(),
        "eigen_sequences": tuple(eigen_sequence(q, i) for i in range(m + 1)),
    }
    statement = f"on polynomials of degree {m} S^∞ Q f = f with Q f = {formula(q)}"
    weights = t.coefficients()
    if len(weights) <= _MOST_WEIGHTS:
        statement += f", Q f(i) = {combination(t.low, weights, lambda index: f'f({index})')}"
    return (RULE.proved(statement, witness),)
