"""Findings on values of φ, on Q and on error bounds as claims."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from subdiv_cli.certificate.claims import Json, polynomial
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.claims import smoothness, structure
from subdiv_cli.kinds.scalar.claims.proof import Proof
from subdiv_cli.kinds.scalar.witnesses import IntegerValuesWitness
from subdiv_cli.model import Finding
from subdiv_cli.model.closed import rational


def integer_values(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD501: φ and its derivatives at the integers."""
    witness = rules.INTEGER_VALUES.witness_of(finding)
    return [_values(proof, witness, order) for order in range(len(witness["values"]))]


def _values(proof: Proof, witness: IntegerValuesWitness, order: int) -> int:
    """The claim that states φ^(order) at the integers.

    For mask 0 itself where its own convergence proves that φ is continuous.
    """
    h = polynomial(witness["starts"][order], witness["values"][order])
    own = polynomial(witness["own_starts"][order], witness["own_values"][order])
    converges = proof.facts.witness(rules.SMOOTHNESS)["by"] == rules.CONVERGENCE.code
    direct = converges or not proof.last
    mask = 0 if direct else proof.last
    contraction = proof.facts.witness(rules.CONVERGENCE) if converges else proof.contractions[-1]
    uses = [*proof.contraction(mask, contraction), *([] if direct else proof.reductions)]
    length, most = proof.degrees[mask] + 1, len(h["coefficients"])
    many = most if direct else len(own["coefficients"])
    work = length * many + (order + 1) * many + (length + most) ** 2
    return proof.add("values", {"order": order, "values": h}, {} if direct else {"values": own}, uses=uses, work=work)


def stencils(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD502: S converges, and the values of φ and its derivatives at the integers."""
    return [_converges(proof), *integer_values(proof, proof.facts[rules.INTEGER_VALUES])]


def _converges(proof: Proof) -> int:
    (number,) = smoothness.convergence(proof, proof.facts[rules.CONVERGENCE])
    return number


def quasi_interpolation(proof: Proof, finding: Finding) -> list[int]:
    """The claim of SD503: the operator Q and its stencil."""
    witness, values = rules.QUASI_INTERPOLATION.witness_of(finding), proof.facts.witness(rules.INTEGER_VALUES)
    degree, stencil = witness["degree"], polynomial(witness["stencil_start"], witness["stencil"])
    statement = {"degree": degree, "operator": [rational(q) for q in witness["operator"]], "stencil": stencil}
    uses = [_converges(proof), _values(proof, values, 0), proof.sum_rules(0)]
    many = len(values["values"][0]) + len(stencil["coefficients"])
    return [proof.add("quasi-interpolation", statement, uses=uses, work=(degree + 2) * (many + degree + 2))]


def approximation_order(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD504: the operator Q, and the reproduction degree."""
    return [
        *quasi_interpolation(proof, proof.facts[rules.QUASI_INTERPOLATION]),
        *structure.reproduction(proof, proof.facts[rules.REPRODUCTION]),
    ]


def interpolatory_order(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD505: no limit is smoother than the sum rules allow."""
    order = rules.INTERPOLATORY_ORDER.witness_of(finding)["order"]
    stable = proof.stable(0, proof.facts.witness(rules.STABILITY))
    return [proof.add("not-smooth", {"order": order}, uses=[n, proof.sum_rules(0)]) for n in stable]


def error_bound(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD511: the error bound, and the number of levels for the tolerance."""
    witness = rules.ERROR_BOUND.witness_of(finding)
    bound = _bound(proof, witness["nu"], witness["norms"], witness["constant"])
    statement: Json = {"tolerance": rational(witness["tolerance"]), "levels": witness["levels"]}
    return [bound, proof.add("levels", statement, uses=[bound])]


def _bound(proof: Proof, nu: int, norms: Sequence[Fraction], constant: Fraction) -> int:
    """The claim ‖S_ν^∞ g - S_ν^k g‖ <= C μ^⌊k/L⌋ ‖Δg‖."""
    p, k = proof.p, proof.orders[0]
    uses = [proof.sum_rules(0), *(proof.norm(0, nu + 1, level, norm) for level, norm in enumerate(norms, 1))]
    first = proof.facts.witness(rules.SUM_RULES)["cofactor_start"] + (p - 1) * nu
    last = first + proof.degrees[0] - nu * (p - 1)
    statement = {"nu": nu, "level": len(norms), "norm": rational(norms[-1]), "constant": rational(constant)}
    work = (max(last, p - 1) - min(first, 1 - p) + 1) * (k + 1) * p
    return proof.add("error-bound", statement, uses=uses, work=work)


def hermite_bound(proof: Proof, finding: Finding) -> list[int]:
    """The claim of SD512: the error of the Hermite interpolant."""
    witness = rules.HERMITE_BOUND.witness_of(finding)
    order = witness["order"]
    derived = _bound(proof, order, witness["norms"], witness["derived_constant"])
    uses = [derived, proof.norm(0, order, witness["level"], witness["norm"])]
    statement = {"order": order, "constant": rational(witness["constant"])}
    return [proof.add("hermite-bound", statement, uses=uses)]
