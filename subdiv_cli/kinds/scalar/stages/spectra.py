"""Stages on the eigenvalues of refinement matrices (SD202, SD304)."""

from __future__ import annotations

from subdiv_cli.exact.algebraic import AlgebraicNumber
from subdiv_cli.exact.text import eigenvalue, modulus, number
from subdiv_cli.kinds.kind import ContradictionError, Facts, asking
from subdiv_cli.kinds.scalar.numbers.operators import refinement_window
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.spectra import Spectrum, eigen_condition, limit_stencil
from subdiv_cli.kinds.scalar.rules import EIGEN_CONDITION, RESIDUE_SUMS, SMOOTHNESS, SMOOTHNESS_SPECTRUM, STABILITY
from subdiv_cli.kinds.scalar.stages.wording import derived_names
from subdiv_cli.kinds.scalar.witnesses import EigenConditionWitness, SmoothnessSpectrumWitness
from subdiv_cli.model import Finding, Verdict

_EIGEN_CONDITION_QUESTION = (
    "do the refinement matrices have the simple eigenvalue 1 and all others inside the unit disc?"
)


@asking((EIGEN_CONDITION, _EIGEN_CONDITION_QUESTION))
def of_scheme(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD202: the eigen-condition of a convergent scheme.

    Theorem (Dyn 1992, Theorem 4.2): if S converges uniformly, each refinement matrix A_ε has the simple eigenvalue 1
    and all its other eigenvalues inside the unit disc. Necessary only. Hypothesis, residue sums 1 (SD101): checked.
    Moduli are compared with 1 exactly, whatever precision that takes.

    Witness: `eigenvalues`, for each A_ε its eigenvalues as text with multiplicities; refuted: `matrix`, the first ε
    that fails; where the scheme may converge `stencil`, the left eigenvector of A_0 for 1 (the limit stencil, Dyn 4.3),
    and `stencil_start`, its first index.
    """
    if facts.verdict(RESIDUE_SUMS) is not Verdict.PROVED:
        return (EIGEN_CONDITION.skipped(_EIGEN_CONDITION_QUESTION, "the residue sums are not 1"),)
    spectra = numbers.spectra
    if spectra is None:
        return (
            EIGEN_CONDITION.undecided(
                _EIGEN_CONDITION_QUESTION, "the refinement matrices are too large for this effort"
            ),
        )
    eigenvalues = tuple(_listed(spectrum) for spectrum in spectra)
    witness: EigenConditionWitness = {"eigenvalues": eigenvalues}
    failing = [epsilon for epsilon, spectrum in enumerate(spectra) if not eigen_condition(spectrum, numbers.p, 0)]
    if failing:
        culprit = failing[0]
        shown = ", ".join(eigenvalues[culprit][:4])
        statement = f"A_{culprit} has another eigenvalue on or outside the unit circle: {shown}"
        return (EIGEN_CONDITION.refuted(statement, {**witness, "matrix": culprit}),)
    if (stencil := limit_stencil(numbers.refinement_matrices[0])) is not None:
        witness = {**witness, "stencil_start": refinement_window(numbers.scheme)[0], "stencil": stencil}
    second = max((spectrum[1] for spectrum in spectra if len(spectrum) > 1), key=_size, default=None)
    largest = f"; the next one has modulus {modulus(second[0])}" if second else ""
    shown = f"; limit stencil ({', '.join(map(number, stencil))})" if stencil and len(stencil) <= 6 else ""
    names = "A_0 and A_1 have" if numbers.p == 2 else f"A_0, …, A_{numbers.p - 1} have"
    statement = f"{names} the simple eigenvalue 1 and all others inside the unit disc{largest}{shown}"
    return (EIGEN_CONDITION.proved(statement, witness),)


def _listed(spectrum: Spectrum) -> tuple[str, ...]:
    """Eigenvalues as text, by falling modulus; a multiple one as `1/4 (2)`, conjugate ones as one pair."""
    upper = [(x, multiplicity) for x, multiplicity in spectrum if not x.region.imag < 0]
    return tuple(eigenvalue(x) + (f" ({multiplicity})" if multiplicity > 1 else "") for x, multiplicity in upper)


def _size(entry: tuple[AlgebraicNumber, int]) -> float:
    return float(entry[0].region.__abs__().mid())


_MOST_LISTED = 6
_SMOOTHNESS_SPECTRUM_QUESTION = "do the derived schemes meet their eigen-conditions?"


@asking((SMOOTHNESS_SPECTRUM, _SMOOTHNESS_SPECTRUM_QUESTION))
def of_derived_schemes(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD304: the eigen-conditions of the derived schemes.

    Theorem (Dyn 1992, Theorem 4.2 and (4.12), for any arity p): where S_ν exists and converges, each refinement matrix
    A_ε of S has the simple eigenvalues 1, 1/p, …, 1/p^ν and all others of modulus < p^-ν, because the matrices of S_ν
    have p^ν times what is left of the spectrum. Necessary for the convergence of S_ν, and so for C^ν where φ is stable
    (SD402). Hypothesis, sum rules of order > ν: checked.

    The finding names the largest ν whose condition holds. Its verdict is on ν = 1 (PROVED) where C^1 is in reach at
    all.

    Witness: `nu`, the largest one; `eigenvalues` of each A_ε as text.

    Raises ContradictionError where a derived scheme converges and fails its eigen-condition.
    """
    if facts.verdict(EIGEN_CONDITION) is not Verdict.PROVED:
        reason = "the eigen-condition of S itself is not proved"
        return (SMOOTHNESS_SPECTRUM.skipped(_SMOOTHNESS_SPECTRUM_QUESTION, reason),)
    spectra = numbers.spectra or ()
    largest = _largest_order(spectra, numbers)
    stable = facts.verdict(STABILITY) is Verdict.PROVED
    if stable and facts.verdict(SMOOTHNESS) is Verdict.PROVED and facts.witness(SMOOTHNESS)["order"] > largest:
        raise ContradictionError("a derived scheme converges and fails its eigen-condition")
    eigenvalues = facts.witness(EIGEN_CONDITION)["eigenvalues"]
    shown = ", ".join(eigenvalues[0][:_MOST_LISTED]) + (", …" if len(spectra[0]) > _MOST_LISTED else "")
    if numbers.order < 2:
        statement = "there is no eigen-condition to meet: sum rules of order 1 only, S_1 cannot converge"
    elif largest == 0:
        statement = f"the eigen-conditions exclude the convergence of S_1: A_0 has the eigenvalues {shown}"
    else:
        statement = f"{derived_names(largest)} {'meet their' if largest > 1 else 'meets its'} eigen-condition"
        statement += f", S_{largest + 1} does not" if largest + 1 < numbers.order else ""
        statement += f"; A_0 has the eigenvalues {shown}"
    witness: SmoothnessSpectrumWitness = {"nu": largest, "eigenvalues": eigenvalues}
    return (
        SMOOTHNESS_SPECTRUM.proved(statement, witness) if largest else SMOOTHNESS_SPECTRUM.refuted(statement, witness),
    )


def _largest_order(spectra: tuple[Spectrum, ...], numbers: ScalarNumbers) -> int:
    """The largest ν < k with every eigen-condition up to ν; 0 holds already."""
    nu = 0
    while nu + 1 < numbers.order and all(eigen_condition(s, numbers.p, nu + 1) for s in spectra):
        nu += 1
    return nu
