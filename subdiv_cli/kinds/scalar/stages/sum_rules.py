"""Stages on the mask itself: residue sums, sum rules, polynomials, derived schemes (SD101 to SD105)."""

from __future__ import annotations

from subdiv_cli.exact.text import laurent, number, valued
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar.numbers.polynomials import parameter_shift, reproduction_defects
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.rules import DERIVED_SCHEMES, GENERATION, REPRODUCTION, RESIDUE_SUMS, SUM_RULES
from subdiv_cli.kinds.scalar.stages.wording import NOT_NORMALISED, derived_names
from subdiv_cli.kinds.scalar.witnesses import DerivedSchemesWitness, ReproductionWitness, SumRulesWitness
from subdiv_cli.model import Finding
from subdiv_cli.model import findings as questions
from subdiv_cli.model.formulas import near_one


def residue_sums(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD101: whether S reproduces constants.

    Theorem (Dyn 1992, Proposition 2.1, for any arity p): a scheme that converges uniformly, to a limit that is not zero
    for some data, has Σ_β a_(γ+pβ) = 1 for every residue class γ mod p. No hypothesis. Equivalent: a(1) = p and a(ζ) =
    0 at every other p-th root of unity ζ.

    Witness: `sums`, the p class sums.
    """
    p, sums = numbers.p, numbers.residue_sums
    if all(s == 1 for s in sums):
        return (RESIDUE_SUMS.proved(f"each of the {p} residue classes of the mask sums to 1", {"sums": sums}),)
    listed = ", ".join(f"Σ a_({gamma}+{p}β) = {near_one(s)}" for gamma, s in enumerate(sums))
    return (RESIDUE_SUMS.refuted(f"the residue classes must sum to 1 each, but {listed}", {"sums": sums}),)


_LONGEST_COFACTOR = 7


def sum_rules(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD102: the sum-rule order k, the largest k for which (1+z+…+z^(p-1))^k divides a(z).

    An identity of polynomials: a = (1+…+z^(p-1))^k q, and q leaves a remainder by one more factor. The sum rules speak
    of masks with a(1) = p only: checked.

    Witness: `order`; `cofactor_start` and `cofactor`, the coefficients of q; `remainder`, those of the failing
    division.
    """
    if not numbers.is_normalised:
        return (SUM_RULES.skipped("which sum rules hold?", NOT_NORMALISED),)
    p, k = numbers.p, numbers.order
    cofactor, remainder = numbers.sum_rules[1:]
    witness: SumRulesWitness = {
        "order": k,
        "cofactor_start": cofactor.low,
        "cofactor": cofactor.coefficients(),
        "remainder": remainder.coefficients(),
    }
    answers = {questions.SUM_RULES: k}
    factor = "1+z" if p == 2 else "1+z+z^2" if p == 3 else f"1+…+z^{p - 1}"
    if k == 0:
        why = f"{factor} does not divide a(z)"
        return (SUM_RULES.refuted(f"no sum rule holds: {why}", witness, answers=answers, why=why),)
    short = len(cofactor.coefficients()) <= _LONGEST_COFACTOR
    quotient = laurent(cofactor) if short else f"a polynomial of degree {cofactor.degree}"
    power = f"^{k}" if k > 1 else ""
    why = f"a(z) = ({factor}){power} q(z), q(z) = {quotient}"
    return (SUM_RULES.proved(f"sum rules of order {k}, not {k + 1}: {why}", witness, answers=answers, why=why),)


def generation(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD103: the generation degree, the largest m with S π_m = π_m.

    It is the sum-rule order minus one (Levin 2003, section 2), an identity of the mask: no hypothesis on convergence.
    For an unstable refinable function the integer translates may span more polynomials than that.

    Witness: `degree`, where there is one.
    """
    if not numbers.is_normalised:
        return (GENERATION.skipped("which polynomials are generated?", NOT_NORMALISED),)
    degree = numbers.order - 1
    if degree < 0:
        return (GENERATION.refuted("S does not even generate constants", {}),)
    statement = f"S generates the polynomials of degree {degree} and no higher"
    return (GENERATION.proved(statement, {"degree": degree}, answers={questions.GENERATION: degree}),)


def reproduction(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD104: the reproduction degree, the largest r with S^∞ q = q for all q in π_r sampled at the right parameters.

    Theorem (Conti & Hormann 2011): with τ = a'(1)/p, the scheme reproduces π_r iff it generates π_r and a^(j)(1) =
    p·τ(τ-1)…(τ-j+1) for j = 0, …, r. The samples belong to the parameters i + τ/(p-1). An identity of the mask.

    Witness: `degree`, where there is one; `shift`, τ; `defects`, a^(j)(1) - p·Π_(i<j)(τ-i) for j = 0, …, generation
    degree.
    """
    if not numbers.is_normalised:
        return (REPRODUCTION.skipped("which polynomials are reproduced?", NOT_NORMALISED),)
    p, generation = numbers.p, numbers.order - 1
    tau = parameter_shift(numbers.symbol, p)
    defects = reproduction_defects(numbers.symbol, p, generation)
    degree = next((j for j, defect in enumerate(defects) if defect), len(defects)) - 1
    witness: ReproductionWitness = {"shift": tau, "defects": defects}
    if degree < 0:
        return (REPRODUCTION.refuted("S does not even reproduce constants", witness),)
    witness = {"degree": degree, **witness}
    if degree == generation:
        limit = f"it generates degree {generation} only"
    else:
        limit = f"a^({degree + 1})(1) is off by {valued(defects[degree + 1])}"
    why = f"with parameter shift τ = {number(tau)}, not {degree + 1}: {limit}"
    answers = {questions.REPRODUCTION: degree}
    return (
        REPRODUCTION.proved(
            f"S reproduces the polynomials of degree {degree} {why}", witness, answers=answers, why=why
        ),
    )


_LONGEST_MASK = 6


def derived_schemes(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD105: the derived schemes S_1, …, S_k.

    Theorem (Dyn 1992, Proposition 3.1 and (3.17), for any arity p): with sum rules of order k there are schemes S_ν, ν
    <= k, with d^ν S f = S_ν d^ν f for the divided differences d^ν = p^(νj) Δ^ν at level j; their symbols are p^ν a(z)
    (z^(p-1)/(1+z+…+z^(p-1)))^ν. Division decides which of them exist.

    Witness: `starts` and `masks`, the derived masks for ν = 1, …, k.
    """
    if not numbers.is_normalised:
        return (DERIVED_SCHEMES.skipped("which derived schemes are there?", NOT_NORMALISED),)
    k = numbers.order
    if k == 0:
        return (
            DERIVED_SCHEMES.refuted(
                "there is no derived scheme: the first sum rule fails", {"starts": (), "masks": ()}
            ),
        )
    masks = [numbers.difference(nu).scale(numbers.p**nu) for nu in range(1, k + 1)]
    witness: DerivedSchemesWitness = {
        "starts": tuple(m.low for m in masks),
        "masks": tuple(m.coefficients() for m in masks),
    }
    shown = f"; S_{k} has the symbol {laurent(masks[-1])}" if masks[-1].degree < _LONGEST_MASK else ""
    exist = f"{derived_names(k)} exist{'s' if k == 1 else ''}"
    return (DERIVED_SCHEMES.proved(f"{exist}, S_{k + 1} does not{shown}", witness),)
