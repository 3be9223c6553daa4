"""SD304: the eigen-conditions of the derived schemes.

Theorem (Dyn 1992, Theorem 4.2 and (4.12), for any arity p): where S_ν exists and converges, each refinement matrix A_ε
of S has the simple eigenvalues 1, 1/p, …, 1/p^ν and all others of modulus < p^-ν, because the matrices of S_ν have p^ν
times what is left of the spectrum. Necessary for the convergence of S_ν, and so for C^ν where φ is stable (SD402).
Hypothesis, sum rules of order > ν: checked.

The finding names the largest ν whose condition holds. Its verdict is on ν = 1 (PROVED) where C^1 is in reach at all.

Witness: `nu`, the largest one; `eigenvalues` of each A_ε as text.
"""

from __future__ import annotations

from typing import cast

from subdiv_cli.kinds.kind import ContradictionError, Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.spectra import Spectrum, eigen_condition
from subdiv_cli.kinds.scalar.stages.stage import derived_names, integer
from subdiv_cli.model import Data, Finding, Verdict

RULE = rules.SMOOTHNESS_SPECTRUM

_MOST_LISTED = 6


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    if facts.verdict(rules.EIGEN_CONDITION) is not Verdict.PROVED:
        reason = "the eigen-condition of S itself is not proved"
        return (RULE.skipped("do the derived schemes meet their eigen-conditions?", reason),)
    spectra = numbers.spectra or ()
    largest = _largest_order(spectra, numbers)
    stable = facts.verdict(rules.STABILITY) is Verdict.PROVED
    if (
        stable
        and facts.verdict(rules.SMOOTHNESS) is Verdict.PROVED
        and integer(facts[rules.SMOOTHNESS], "order") > largest
    ):
        raise ContradictionError("a derived scheme converges and fails its eigen-condition")
    eigenvalues = cast("tuple[tuple[str, ...], ...]", facts[rules.EIGEN_CONDITION].witness["eigenvalues"])
    shown = ", ".join(eigenvalues[0][:_MOST_LISTED]) + (", …" if len(spectra[0]) > _MOST_LISTED else "")
    if numbers.order < 2:
        statement = "there is no eigen-condition to meet: sum rules of order 1 only, S_1 cannot converge"
    elif largest == 0:
        statement = f"the eigen-conditions exclude the convergence of S_1: A_0 has the eigenvalues {shown}"
    else:
        statement = f"{derived_names(largest)} {'meet their' if largest > 1 else 'meets its'} eigen-condition"
        statement += f", S_{largest + 1} does not" if largest + 1 < numbers.order else ""
        statement += f"; A_0 has the eigenvalues {shown}"
    witness: dict[str, Data] = {"nu": largest, "eigenvalues": eigenvalues}
    return (RULE.proved(statement, witness) if largest else RULE.refuted(statement, witness),)


def _largest_order(spectra: tuple[Spectrum, ...], numbers: ScalarNumbers) -> int:
    """The largest ν < k with every eigen-condition up to ν; 0 holds already."""
    nu = 0
    while nu + 1 < numbers.order and all(eigen_condition(s, numbers.p, nu + 1) for s in spectra):
        nu += 1
    return nu
