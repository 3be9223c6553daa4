"""SD202: the eigen-condition of a convergent scheme.

Theorem (Dyn 1992, Theorem 4.2): if S converges uniformly, each refinement matrix A_ε has the simple eigenvalue 1 and
all its other eigenvalues inside the unit disc. Necessary only. Hypothesis, residue sums 1 (SD101): checked. Moduli are
compared with 1 exactly, whatever precision that takes.

Witness: `eigenvalues`, for each A_ε its eigenvalues as text with multiplicities; refuted: `matrix`, the first ε that
fails; where the scheme may converge `stencil`, the left eigenvector of A_0 for 1 (the limit stencil, Dyn 4.3), and
`stencil_start`, its first index.
"""

from __future__ import annotations

from subdiv_cli.exact.algebraic import AlgebraicNumber
from subdiv_cli.exact.text import eigenvalue, modulus, number
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.operators import refinement_window
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.spectra import Spectrum, eigen_condition, limit_stencil
from subdiv_cli.model import Data, Finding, Verdict

RULE = rules.EIGEN_CONDITION

_QUESTION = "do the refinement matrices have the simple eigenvalue 1 and all others inside the unit disc?"


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    if facts.verdict(rules.RESIDUE_SUMS) is not Verdict.PROVED:
        return (RULE.skipped(_QUESTION, "the residue sums are not 1"),)
    spectra = numbers.spectra
    if spectra is None:
        return (RULE.undecided(_QUESTION, "the refinement matrices are too large for this effort"),)
    eigenvalues = tuple(_listed(spectrum) for spectrum in spectra)
    witness: dict[str, Data] = {"eigenvalues": eigenvalues}
    failing = [epsilon for epsilon, spectrum in enumerate(spectra) if not eigen_condition(spectrum, numbers.p, 0)]
    if failing:
        culprit = failing[0]
        shown = ", ".join(eigenvalues[culprit][:4])
        statement = f"A_{culprit} has another eigenvalue on or outside the unit circle: {shown}"
        return (RULE.refuted(statement, {**witness, "matrix": culprit}),)
    if (stencil := limit_stencil(numbers.refinement_matrices[0])) is not None:
        witness |= {"stencil_start": refinement_window(numbers.scheme)[0], "stencil": stencil}
    second = max((spectrum[1] for spectrum in spectra if len(spectrum) > 1), key=_size, default=None)
    largest = f"; the next one has modulus {modulus(second[0])}" if second else ""
    shown = f"; limit stencil ({', '.join(map(number, stencil))})" if stencil and len(stencil) <= 6 else ""
    names = "A_0 and A_1 have" if numbers.p == 2 else f"A_0, …, A_{numbers.p - 1} have"
    statement = f"{names} the simple eigenvalue 1 and all others inside the unit disc{largest}{shown}"
    return (RULE.proved(statement, witness),)


def _listed(spectrum: Spectrum) -> tuple[str, ...]:
    """Eigenvalues as text, by falling modulus; a multiple one as `1/4 (2)`, conjugate ones as one pair."""
    upper = [(x, multiplicity) for x, multiplicity in spectrum if not x.region.imag < 0]
    return tuple(eigenvalue(x) + (f" ({multiplicity})" if multiplicity > 1 else "") for x, multiplicity in upper)


def _size(entry: tuple[AlgebraicNumber, int]) -> float:
    return float(entry[0].region.__abs__().mid())
