"""Findings on values of φ, on Q and on error bounds as claims."""

from __future__ import annotations

from collections.abc import Mapping

from subdiv_cli.certificate.claims import Json
from subdiv_cli.certificate.witness import as_integer, as_polynomial, as_rational, as_rationals, as_tuple
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.claims import smoothness, structure
from subdiv_cli.kinds.scalar.claims.proof import Proof
from subdiv_cli.model import Data, Finding
from subdiv_cli.model.closed import rational


def integer_values(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD501: φ and its derivatives at the integers."""
    return [_values(proof, finding, order) for order in range(len(as_tuple(finding.witness["values"])))]


def _values(proof: Proof, finding: Finding, order: int) -> int:
    """The claim that states φ^(order) at the integers.

    For mask 0 itself where its own convergence proves that φ is continuous.
    """
    found, by = finding.witness, proof.found[rules.SMOOTHNESS].witness["by"]
    h = as_polynomial(as_tuple(found["starts"])[order], as_tuple(found["values"])[order])
    own = as_polynomial(as_tuple(found["own_starts"])[order], as_tuple(found["own_values"])[order])
    direct = by == rules.CONVERGENCE.code or not proof.last
    mask = 0 if direct else proof.last
    witness = proof.found[rules.CONVERGENCE].witness if by == rules.CONVERGENCE.code else proof.contractions[-1].witness
    uses = [*proof.contraction(mask, witness), *([] if direct else proof.reductions)]
    length, most = proof.degrees[mask] + 1, len(h["coefficients"])
    many = most if direct else len(own["coefficients"])
    work = length * many + (order + 1) * many + (length + most) ** 2
    return proof.add("values", {"order": order, "values": h}, {} if direct else {"values": own}, uses=uses, work=work)


def stencils(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD502: S converges, and the values of φ and its derivatives at the integers."""
    return [_converges(proof), *integer_values(proof, proof.found[rules.INTEGER_VALUES])]


def _converges(proof: Proof) -> int:
    (number,) = smoothness.convergence(proof, proof.found[rules.CONVERGENCE])
    return number


def quasi_interpolation(proof: Proof, finding: Finding) -> list[int]:
    """The claim of SD503: the operator Q and its stencil."""
    found, values = finding.witness, proof.found[rules.INTEGER_VALUES]
    operator, degree = as_rationals(found["operator"]), as_integer(found["degree"])
    stencil = as_polynomial(found["stencil_start"], found["stencil"])
    statement = {"degree": degree, "operator": [rational(q) for q in operator], "stencil": stencil}
    uses = [_converges(proof), _values(proof, values, 0), proof.sum_rules(0)]
    many = len(as_tuple(as_tuple(values.witness["values"])[0])) + len(stencil["coefficients"])
    return [proof.add("quasi-interpolation", statement, uses=uses, work=(degree + 2) * (many + degree + 2))]


def approximation_order(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD504: the operator Q, and the reproduction degree."""
    return [
        *quasi_interpolation(proof, proof.found[rules.QUASI_INTERPOLATION]),
        *structure.reproduction(proof, proof.found[rules.REPRODUCTION]),
    ]


def interpolatory_order(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD505: no limit is smoother than the sum rules allow."""
    order = as_integer(finding.witness["order"])
    stable = proof.stable(0, proof.found[rules.STABILITY].witness)
    return [proof.add("not-smooth", {"order": order}, uses=[n, proof.sum_rules(0)]) for n in stable]


def error_bound(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD511: the error bound, and the number of levels for the tolerance."""
    bound = _bound(proof, finding.witness)
    statement: Json = {
        "tolerance": rational(as_rational(finding.witness["tolerance"])),
        "levels": as_integer(finding.witness["levels"]),
    }
    return [bound, proof.add("levels", statement, uses=[bound])]


def _bound(proof: Proof, found: Mapping[str, Data]) -> int:
    """The claim ‖S_ν^∞ g - S_ν^k g‖ <= C μ^⌊k/L⌋ ‖Δg‖."""
    p, k, nu, norms = proof.p, proof.orders[0], as_integer(found["nu"]), as_rationals(found["norms"])
    uses = [proof.sum_rules(0), *(proof.norm(0, nu + 1, level, norm) for level, norm in enumerate(norms, 1))]
    first = as_integer(proof.found[rules.SUM_RULES].witness["cofactor_start"]) + (p - 1) * nu
    last = first + proof.degrees[0] - nu * (p - 1)
    statement = {
        "nu": nu,
        "level": len(norms),
        "norm": rational(norms[-1]),
        "constant": rational(as_rational(found["constant"])),
    }
    work = (max(last, p - 1) - min(first, 1 - p) + 1) * (k + 1) * p
    return proof.add("error-bound", statement, uses=uses, work=work)


def hermite_bound(proof: Proof, finding: Finding) -> list[int]:
    """The claim of SD512: the error of the Hermite interpolant."""
    found = finding.witness
    derived = {"nu": found["order"], "norms": found["norms"], "constant": found["derived_constant"]}
    order, level = as_integer(found["order"]), as_integer(found["level"])
    uses = [_bound(proof, derived), proof.norm(0, order, level, as_rational(found["norm"]))]
    statement = {"order": order, "constant": rational(as_rational(found["constant"]))}
    return [proof.add("hermite-bound", statement, uses=uses)]
