"""Findings on convergence, smoothness and exponents as claims."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import lcm
from typing import cast

from subdiv_cli.certificate.claims import Json
from subdiv_cli.certificate.radius import root_fields
from subdiv_cli.certificate.witness import as_integer, as_polynomial, as_rational, as_word
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.claims import radius
from subdiv_cli.kinds.scalar.claims.proof import Proof
from subdiv_cli.kinds.scalar.claims.structure import eigen_condition, residue_sums
from subdiv_cli.model import Data, Finding, Verdict
from subdiv_cli.model.closed import rational


def contractivity(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD301: a derived scheme contracts, or a product of transition matrices keeps it from doing so."""
    if finding.verdict is Verdict.PROVED:
        return proof.contraction(proof.last, finding.witness)
    return [proof.obstacle(proof.last, as_integer(finding.witness["nu"]) - 1, finding.witness)]


def convergence(proof: Proof, finding: Finding) -> list[int]:
    """The claim of SD201: S converges uniformly, or does not."""
    by = finding.witness["by"]
    if finding.verdict is Verdict.PROVED:
        return [
            proof.add("converges", {"holds": True}, uses=uses, name="convergent")
            for uses in _convergent_by(proof, finding)
        ]
    if by == rules.SMOOTHNESS.code:
        reasons = _not_smooth(proof, 0, proof.found[rules.SMOOTHNESS].witness)
        return [proof.add("diverges", {"holds": False}, uses=[reason], name="convergent") for reason in reasons]
    if by == rules.CONTRACTIVITY.code:
        reason = proof.obstacle(0, 0, finding.witness)
    else:
        (reason,) = {rules.RESIDUE_SUMS.code: residue_sums, rules.EIGEN_CONDITION.code: eigen_condition}[str(by)](
            proof, proof.found[str(by)]
        )
    return [proof.add("diverges", {"holds": False}, uses=[reason], name="convergent")]


def _convergent_by(proof: Proof, finding: Finding) -> list[list[int]]:
    """The claims by which S converges; none where a witness of stability is missing."""
    if finding.witness["by"] != rules.SOBOLEV.code:
        return [proof.contraction(0, finding.witness)]
    return [[s, stable] for s in sobolev(proof, proof.found[rules.SOBOLEV]) for stable in proof.last_stable()]


def smoothness(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD302: φ is C^n, or is not continuous."""
    if finding.verdict is Verdict.REFUTED:
        return _not_smooth(proof, 0, finding.witness)
    order, by = as_integer(finding.witness["order"]), finding.witness["by"]
    if by == rules.CONVERGENCE.code:
        found = proof.found[rules.CONVERGENCE]
        each = [
            uses[:1] if found.witness["by"] == rules.SOBOLEV.code else uses for uses in _convergent_by(proof, found)
        ]
    elif by == rules.SOBOLEV.code:
        each = [[claim] for claim in sobolev(proof, proof.found[rules.SOBOLEV])]
    elif by == rules.JOINT_RADIUS.code:
        mask = 0 if finding.witness["radius_of"] == "S" else proof.last
        each = [[*radius.claims(proof, mask), *(proof.reductions if mask else ())]]
    else:
        contracts = next(each for each in proof.contractions if each.witness["nu"] == order + 1)
        each = [[*proof.contraction(proof.last, contracts.witness), *proof.reductions]]
    return [proof.add("smooth", {"order": order}, uses=uses) for uses in each]


def next_smoothness(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD303: φ is not C^(n+1)."""
    return _not_smooth(proof, as_integer(finding.witness["order"]), finding.witness)


def _not_smooth(proof: Proof, order: int, witness: Mapping[str, Data]) -> list[int]:
    if witness.get("by") == rules.SOBOLEV.code:
        mean = sobolev(proof, proof.found[rules.SOBOLEV])
        return [proof.add("not-smooth", {"order": order}, uses=[claim]) for claim in mean]
    stable = proof.last_stable()
    obstacle = proof.obstacle(proof.last, order, witness)
    return [proof.add("not-smooth", {"order": order}, uses=[n, obstacle, *proof.reductions]) for n in stable]


def joint_radius(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD310: the joint spectral radius of D, or a bound of it."""
    mask = 0 if finding.witness["of"] == "S" else proof.last
    claims = radius.claims(proof, mask)
    if finding.proof["rule"] == "norm" and "root" in finding.witness:
        word, length = as_word(finding.witness), as_integer(finding.witness["length"])
        claims.append(proof.product(mask, *_fitting(word, length, as_rational(finding.proof["bound"]))))
    return claims


def holder_lower(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD311: the Hölder exponent from below, or what it is where the radius is known."""
    root = cast("Mapping[str, Data] | None", finding.witness.get("root"))
    if root is None:
        statement = {"level": finding.witness["length"], "norm": rational(as_rational(finding.witness["bound"]))}
        return [proof.add("holder-lower", statement, uses=uses) for uses in _decay(proof, finding)]
    data, length = radius.of_mask(proof, proof.last), as_integer(finding.witness["length"])
    last, uses = proof.last, [*radius.claims(proof, proof.last), proof.sum_rules(proof.last)]
    if data["rule"] != "norm":
        statement = {"length": length, **root_fields(root)}
        return [
            proof.add("holder-root", statement, uses=[*uses, stable, *proof.reductions])
            for stable in proof.last_stable()
        ]
    bound = as_rational(root["high"])
    below = proof.add("holder-lower", {"level": length, "norm": rational(bound)}, uses=[*uses, *proof.reductions])
    word = as_word(proof.radii["S" if last == 0 else "S0"].witness)
    above = _above(proof, *_fitting(word, length, bound))
    statement = {"level": length, "norm": rational(bound)}
    return [proof.add("holder-exact", statement, uses=[below, n], name="holder") for n in above] or [below]


def _decay(proof: Proof, finding: Finding) -> list[list[int]]:
    """The claims that a bound of a joint spectral radius rests on; none where that on stability is missing."""
    found, by = finding.witness, finding.witness.get("by")
    if by == rules.SOBOLEV.code:
        return [[claim] for claim in sobolev(proof, proof.found[rules.SOBOLEV])]
    if by is not None:
        mask = proof.last if by == rules.CONTRACTIVITY.code else 0
        source = proof.found[rules.CONVERGENCE]
        if mask == proof.last and by == rules.CONTRACTIVITY.code:
            source = next(each for each in proof.contractions if each.witness["nu"] == found["nu"])
        claims = proof.contraction(mask, source.witness)
    else:
        mask = 0 if found["radius_of"] == "S" else proof.last
        claims = radius.claims(proof, mask)
    return [[*claims, proof.sum_rules(mask), *(proof.reductions if mask else ())]]


def _fitting(word: tuple[int, ...], length: int, power: Fraction) -> tuple[tuple[int, ...], Fraction]:
    """The word repeated to a length n that `length` divides, and x^(n/length) for x = `power`."""
    total = lcm(len(word), length)
    return word * (total // len(word)), power ** (total // length)


def holder_upper(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD312: the Hölder exponent from above."""
    found = finding.witness
    if found.get("by") == rules.SOBOLEV.code:
        statement = {"length": found["length"], "radius": rational(as_rational(found["radius"]))}
        mean = sobolev(proof, proof.found[rules.SOBOLEV])
        return [proof.add("holder-upper", statement, uses=[claim]) for claim in mean]
    if "word" in found:
        if "by" not in found and (exactly := _exactly(proof)) is not None:
            return [exactly]
        return _above(proof, as_word(found), as_rational(found["radius"]))
    k = as_integer(found["difference_order"])
    statement = {"length": 1, "radius": rational(Fraction(1, proof.p**k))}
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
    mask, nu, rules = proof.last, as_integer(finding.witness["nu"]), proof.sum_rules(proof.last)
    statement = {"holds": finding.verdict is Verdict.PROVED}
    if finding.verdict is Verdict.REFUTED:
        family = proof.family(mask, nu)
        uses = [radius.defective(proof, family, finding.witness), family, holder]
        return [
            proof.add("not-attained", statement, uses=[*uses, stable, *proof.reductions], name="attained")
            for stable in proof.last_stable()
        ]
    if finding.witness["by"] == "norm":
        norm = proof.norm(mask, nu, as_integer(finding.witness["level"]), as_rational(finding.witness["norm"]))
        uses = [norm, holder, rules, *proof.reductions]
        return [proof.add("attained-norm", statement, uses=uses, name="attained")]
    if finding.proof:
        bounded, family = radius.claims_of(proof, mask, nu, finding.proof)
        uses = [bounded, holder, family, rules]
    else:
        uses = [*radius.claims(proof, mask), rules]
    return [
        proof.add("attained-bounded", statement, uses=[*uses, stable, *proof.reductions], name="attained")
        for stable in proof.last_stable()
    ]


def _exactly(proof: Proof) -> int | None:
    """The claim that says what α is."""
    if not (claims := holder_lower(proof, proof.found[rules.HOLDER_LOWER])):
        return None
    name = proof.claims.statement(claims[0])["property"]
    return claims[0] if name in ("holder", "holder-root") else None


def sobolev(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD321: the Sobolev exponent; none where the witness of stability was too costly."""
    found, p = finding.witness, proof.p
    if "by" in found:
        return _between(proof, finding)
    degree = proof.degrees[proof.last] - proof.orders[proof.last] * (p - 1)
    order = degree // (p - 1) + 1
    statement = {
        "polynomial": as_polynomial(0, found["polynomial"]),
        "low": rational(as_rational(found["low"])),
        "high": rational(as_rational(found["high"])),
    }
    hints = {"cofactor": as_polynomial(0, found["cofactor"])}
    uses = [proof.sum_rules(proof.last), *proof.reductions]
    work = (degree + 1) ** 2 + 4 * order**3 + 20
    return [proof.add("sobolev", statement, hints, uses=[n, *uses], work=work) for n in proof.last_stable()]


def _between(proof: Proof, finding: Finding) -> list[int]:
    """The claims that bound the Sobolev exponent by the Hölder exponent; none where one of them cannot be made."""
    found, least = finding.witness, []
    if found["by"] == rules.HOLDER_LOWER.code:
        below = proof.found[rules.HOLDER_LOWER]
        lower = next(each for each in (below, *below.otherwise) if _is_bounded_by(each, found))
        statement: Json = {"length": found["length"], "bound": rational(as_rational(found["bound"]))}
        least = [proof.add("sobolev-at-least", statement, uses=[n]) for n in holder_lower(proof, lower)]
        if not least:
            return []
    if "word" in found:
        word, r = as_word(found), as_rational(found["radius"])
        most = {"length": 2 * len(word), "bound": rational(r**2 / proof.p ** len(word))}
        uses = [[above] for above in _above(proof, word, r)]
    else:
        most = {"length": 1, "bound": rational(Fraction(1, proof.p ** as_integer(found["sum_rule_order"])))}
        uses = [[n, proof.sum_rules(proof.last), *proof.reductions] for n in proof.last_stable()]
    above = [proof.add("sobolev-at-most", most, uses=each) for each in uses]
    return [*least, *above] if above else []


def _is_bounded_by(lower: Finding, found: Mapping[str, Data]) -> bool:
    """Whether a finding of SD311 is the one whose bound is used."""
    root = cast("Mapping[str, Data] | None", lower.witness.get("root"))
    bound = lower.witness.get("bound") if root is None else root["high"]
    return (lower.witness["length"], bound) == (found["length"], found["bound"])
