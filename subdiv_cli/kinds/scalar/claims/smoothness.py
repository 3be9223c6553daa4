"""Findings on convergence, smoothness and exponents as claims."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import lcm

from subdiv_cli.certificate.claims import Json, polynomial
from subdiv_cli.certificate.radius import root_fields
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.claims import radius
from subdiv_cli.kinds.scalar.claims.proof import Proof
from subdiv_cli.kinds.scalar.claims.structure import eigen_condition, residue_sums
from subdiv_cli.kinds.scalar.witnesses import ConvergenceWitness, HolderLowerWitness, ObstacleWitness, SobolevWitness
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.model.closed import rational
from subdiv_cli.model.findings import proof_of
from subdiv_cli.model.proofs import RadiusProof, upper_bound


def contractivity(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD301: a derived scheme contracts, or a product of transition matrices keeps it from doing so."""
    witness = rules.CONTRACTIVITY.witness_of(finding)
    if finding.verdict is Verdict.PROVED:
        return proof.contraction(proof.last, witness)
    return [proof.obstacle(proof.last, witness["nu"] - 1, witness)]


def convergence(proof: Proof, finding: Finding) -> list[int]:
    """The claim of SD201: S converges uniformly, or does not."""
    witness = rules.CONVERGENCE.witness_of(finding)
    by = witness["by"]
    if finding.verdict is Verdict.PROVED:
        each = _convergent_by(proof, witness)
        return [proof.add("converges", {"holds": True}, uses=uses, name="convergent") for uses in each]
    if by == rules.SMOOTHNESS.code:
        of_phi = proof.facts[rules.SMOOTHNESS]
        reasons = smoothness(proof, of_phi) if of_phi.verdict is Verdict.REFUTED else []
        return [proof.add("diverges", {"holds": False}, uses=[reason], name="convergent") for reason in reasons]
    if by == rules.CONTRACTIVITY.code:
        reason = proof.obstacle(0, 0, witness)
    else:
        makers = {rules.RESIDUE_SUMS.code: residue_sums, rules.EIGEN_CONDITION.code: eigen_condition}
        (reason,) = makers[by](proof, proof.facts[by])
    return [proof.add("diverges", {"holds": False}, uses=[reason], name="convergent")]


def _convergent_by(proof: Proof, witness: ConvergenceWitness) -> list[list[int]]:
    """The claims by which S converges; none where a witness of stability is missing."""
    if witness["by"] != rules.SOBOLEV.code:
        return [proof.contraction(0, witness)]
    return [[mean, stable] for mean in _in_the_mean(proof) for stable in proof.last_stable()]


def smoothness(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD302: φ is C^n, or is not continuous."""
    witness = rules.SMOOTHNESS.witness_of(finding)
    if finding.verdict is Verdict.REFUTED:
        return _not_smooth(proof, 0, witness)
    order, by = witness["order"], witness["by"]
    if by == rules.CONVERGENCE.code:
        converges = proof.facts.witness(rules.CONVERGENCE)
        only = 1 if converges["by"] == rules.SOBOLEV.code else None
        each = [uses[:only] for uses in _convergent_by(proof, converges)]
    elif by == rules.SOBOLEV.code:
        each = [[claim] for claim in _in_the_mean(proof)]
    elif by == rules.JOINT_RADIUS.code:
        mask = 0 if witness["radius_of"] == "S" else proof.last
        each = [[*radius.claims(proof, mask), *(proof.reductions if mask else ())]]
    else:
        each = [[*_contraction(proof, order + 1), *proof.reductions]]
    return [proof.add("smooth", {"order": order}, uses=uses) for uses in each]


def _contraction(proof: Proof, nu: int) -> list[int]:
    """The claims by which the derived scheme of order ν of the last mask contracts, or the next one below."""
    return proof.contraction(proof.last, [each for each in proof.contractions if each["nu"] <= nu][-1])


def _in_the_mean(proof: Proof) -> list[int]:
    """The claims of SD321, where it has the growth of mean squares; none where it is not proved."""
    finding = proof.facts[rules.SOBOLEV]
    return sobolev(proof, finding) if finding.verdict is Verdict.PROVED else []


def next_smoothness(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD303: φ is not C^(n+1)."""
    witness = rules.NEXT_SMOOTHNESS.witness_of(finding)
    return _not_smooth(proof, witness["order"], witness)


def _not_smooth(proof: Proof, order: int, witness: ObstacleWitness) -> list[int]:
    if witness.get("by") == rules.SOBOLEV.code:
        return [proof.add("not-smooth", {"order": order}, uses=[claim]) for claim in _in_the_mean(proof)]
    stable = proof.last_stable()
    obstacle = proof.obstacle(proof.last, order, witness)
    return [proof.add("not-smooth", {"order": order}, uses=[n, obstacle, *proof.reductions]) for n in stable]


def joint_radius(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD310: the joint spectral radius of D, or a bound of it."""
    witness = rules.JOINT_RADIUS.witness_of(finding)
    mask = 0 if witness["of"] == "S" else proof.last
    claims = radius.claims(proof, mask)
    if witness["method"] == "norm" and "root" in witness:
        claims.append(proof.product(mask, *_fitting(witness["word"], witness["length"], witness["bound"])))
    return claims


def holder_lower(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD311: the Hölder exponent from below, or what it is where the radius is known."""
    witness, last = rules.HOLDER_LOWER.witness_of(finding), proof.last
    length = witness["length"]
    if "root" not in witness:
        at_least = {"level": length, "norm": rational(witness["bound"])}
        return [proof.add("holder-lower", at_least, uses=uses) for uses in _decay(proof, witness)]
    root, uses = witness["root"], [*radius.claims(proof, last), proof.sum_rules(last)]
    if radius.of_mask(proof, last)["rule"] != "norm":
        statement = {"length": length, **root_fields(root)}
        return [
            proof.add("holder-root", statement, uses=[*uses, stable, *proof.reductions])
            for stable in proof.last_stable()
        ]
    bound = root["high"]
    statement = {"level": length, "norm": rational(bound)}
    below = proof.add("holder-lower", statement, uses=[*uses, *proof.reductions])
    above = _above(proof, *_fitting(proof.radius(last)[0]["word"], length, bound))
    return [proof.add("holder-exact", statement, uses=[below, n], name="holder") for n in above] or [below]


def _decay(proof: Proof, witness: HolderLowerWitness) -> list[list[int]]:
    """The claims that a bound of a joint spectral radius rests on; none where that on stability is missing."""
    by = witness.get("by")
    if by == rules.SOBOLEV.code:
        return [[claim] for claim in _in_the_mean(proof)]
    if by == rules.CONTRACTIVITY.code:
        mask, claims = proof.last, _contraction(proof, witness["nu"])
    elif by == rules.CONVERGENCE.code:
        mask, claims = 0, proof.contraction(0, proof.facts.witness(rules.CONVERGENCE))
    else:
        mask = 0 if witness["radius_of"] == "S" else proof.last
        claims = radius.claims(proof, mask)
    return [[*claims, proof.sum_rules(mask), *(proof.reductions if mask else ())]]


def _fitting(word: tuple[int, ...], length: int, power: Fraction) -> tuple[tuple[int, ...], Fraction]:
    """The word repeated to a length n that `length` divides, and x^(n/length) for x = `power`."""
    total = lcm(len(word), length)
    return word * (total // len(word)), power ** (total // length)


def holder_upper(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD312: the Hölder exponent from above."""
    witness = rules.HOLDER_UPPER.witness_of(finding)
    by = witness.get("by")
    if by == rules.SOBOLEV.code:
        statement = {"length": witness["length"], "radius": rational(witness["radius"])}
        return [proof.add("holder-upper", statement, uses=[claim]) for claim in _in_the_mean(proof)]
    if "word" in witness:
        if by is None and (exactly := _exactly(proof)) is not None:
            return [exactly]
        return _above(proof, witness["word"], witness["radius"])
    statement = {"length": 1, "radius": rational(Fraction(1, proof.p ** witness["difference_order"]))}
    uses = [proof.sum_rules(proof.last), *proof.reductions]
    return [proof.add("holder-upper", statement, uses=[n, *uses]) for n in proof.last_stable()]


def _above(proof: Proof, word: Sequence[int], radius: Fraction) -> list[int]:
    uses = [proof.product(proof.last, word, radius), *proof.reductions]
    statement = {"length": len(word), "radius": rational(radius)}
    return [proof.add("holder-upper", statement, uses=[n, *uses]) for n in proof.last_stable()]


def attained(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD313: the Hölder exponent is attained, or is not."""
    holder = _exactly(proof)
    if holder is None:
        return []
    witness = rules.HOLDER_ATTAINED.witness_of(finding)
    mask, nu, sum_rules = proof.last, witness["nu"], proof.sum_rules(proof.last)
    statement = {"holds": finding.verdict is Verdict.PROVED}
    if finding.verdict is Verdict.REFUTED:
        family = proof.family(mask, nu)
        uses = [radius.defective(proof, family, witness), family, holder]
        return [
            proof.add("not-attained", statement, uses=[*uses, stable, *proof.reductions], name="attained")
            for stable in proof.last_stable()
        ]
    if witness["by"] == "norm":
        norm = proof.norm(mask, nu, witness["level"], witness["norm"])
        uses = [norm, holder, sum_rules, *proof.reductions]
        return [proof.add("attained-norm", statement, uses=uses, name="attained")]
    if finding.proof:
        bounded, family = radius.claims_of(proof, mask, nu, proof_of(finding, RadiusProof))
        uses = [bounded, holder, family, sum_rules]
    else:
        uses = [*radius.claims(proof, mask), sum_rules]
    return [
        proof.add("attained-bounded", statement, uses=[*uses, stable, *proof.reductions], name="attained")
        for stable in proof.last_stable()
    ]


def _exactly(proof: Proof) -> int | None:
    """The claim that says what α is."""
    if not (claims := holder_lower(proof, proof.facts[rules.HOLDER_LOWER])):
        return None
    name = proof.claims.statement(claims[0])["property"]
    return claims[0] if name in ("holder", "holder-root") else None


def sobolev(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD321: the Sobolev exponent; none where the witness of stability was too costly."""
    witness, p = rules.SOBOLEV.witness_of(finding), proof.p
    if "by" in witness:
        return _between(proof, witness)
    degree = proof.degrees[proof.last] - proof.orders[proof.last] * (p - 1)
    order = degree // (p - 1) + 1
    statement = {
        "polynomial": polynomial(0, witness["polynomial"]),
        "low": rational(witness["low"]),
        "high": rational(witness["high"]),
    }
    hints = {"cofactor": polynomial(0, witness["cofactor"])}
    uses = [proof.sum_rules(proof.last), *proof.reductions]
    work = (degree + 1) ** 2 + 4 * order**3 + 20
    return [proof.add("sobolev", statement, hints, uses=[n, *uses], work=work) for n in proof.last_stable()]


def _between(proof: Proof, witness: SobolevWitness) -> list[int]:
    """The claims that bound the Sobolev exponent by the Hölder exponent; none where one of them cannot be made."""
    least: list[int] = []
    if witness["by"] == rules.HOLDER_LOWER.code:
        below = proof.facts[rules.HOLDER_LOWER]
        lower = next((each for each in (below, *below.otherwise) if _is_bounded_by(each, witness)), below)
        statement: Json = {"length": witness["length"], "bound": rational(witness["bound"])}
        least = [proof.add("sobolev-at-least", statement, uses=[n]) for n in holder_lower(proof, lower)]
        if not least:
            return []
    if "word" in witness:
        word, r = witness["word"], witness["radius"]
        most = {"length": 2 * len(word), "bound": rational(r**2 / proof.p ** len(word))}
        uses = [[above] for above in _above(proof, word, r)]
    else:
        most = {"length": 1, "bound": rational(Fraction(1, proof.p ** witness["sum_rule_order"]))}
        uses = [[n, proof.sum_rules(proof.last), *proof.reductions] for n in proof.last_stable()]
    above = [proof.add("sobolev-at-most", most, uses=each) for each in uses]
    return [*least, *above] if above else []


def _is_bounded_by(lower: Finding, witness: SobolevWitness) -> bool:
    """Whether a finding of SD311 is the one whose bound is used."""
    known = rules.HOLDER_LOWER.witness_of(lower)
    return (known["length"], upper_bound(known)) == (witness["length"], witness["bound"])
