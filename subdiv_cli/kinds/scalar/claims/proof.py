"""A certificate under construction: its masks, and the claims that several findings share.

Sum rules, norms, products of transition matrices, stability, reduction steps. Mask 0 is the mask of the document;
`last` is the one that decides smoothness: 0, or the last reduced one.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from subdiv_cli.certificate.claims import Claims, Json, polynomial
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.claims import radius
from subdiv_cli.kinds.scalar.witnesses import (
    ContractivityWitness,
    ConvergenceWitness,
    JointRadiusWitness,
    ProductWitness,
    ReductionWitness,
    StabilityWitness,
)
from subdiv_cli.model import DECIDED, Finding, Verdict
from subdiv_cli.model.closed import rational
from subdiv_cli.model.findings import proof_of
from subdiv_cli.model.proofs import RadiusProof


class Proof:
    """A certificate under construction: each method returns the number of a claim, which it makes if there is none yet.

    Where a method returns a list, it is empty where a witness was too costly to compute.
    """

    def __init__(self, p: int, degree: int, findings: Sequence[Finding]) -> None:
        self.p = p
        self.claims = Claims()
        self.facts = Facts(findings)
        self.contractions = [
            rules.CONTRACTIVITY.witness_of(finding)
            for finding in self.facts.all(rules.CONTRACTIVITY)
            if finding.verdict is Verdict.PROVED
        ]
        """The witnesses of the derived schemes that contract."""
        self.degrees = [degree]
        self.reductions: list[int] = []
        self.families: list[None] = []
        """One entry for each family that has a number."""
        self._family_claims: dict[tuple[int, int], int] = {}
        decided = self.facts.verdict(rules.SUM_RULES) in DECIDED
        self.orders = {0: self.facts.witness(rules.SUM_RULES)["order"] if decided else 0}
        if rules.REDUCTION in self.facts:
            self._reduce(self.facts.witness(rules.REDUCTION))
        self.last = len(self.degrees) - 1

    def add(
        self,
        rule: str,
        statement: Json,
        witness: Json | None = None,
        uses: Sequence[int] = (),
        work: int = 1,
        name: str | None = None,
    ) -> int:
        """The number of a claim by a rule; its property has the rule's name unless another is given."""
        return self.claims.add(rule, {"property": name or rule, **statement}, witness or {}, uses, work)

    def sum_rules(self, mask: int) -> int:
        """The claim that this mask has sum rules of its order and no higher one."""
        witness = self.facts.witness(rules.SUM_RULES) if mask == 0 else self.facts.witness(rules.REDUCTION)
        quotient = polynomial(witness["cofactor_start"], witness["cofactor"])
        order = self.orders[mask]
        work = (self.degrees[mask] + 1) * (order + 1) * self.p
        return self.add("sum-rules", {"mask": mask, "order": order}, {"quotient": quotient}, work=work)

    def norm(self, mask: int, nu: int, level: int, norm: Fraction) -> int:
        """The claim ‖((1/p)S_ν)^level‖∞ = norm of this mask."""
        p, degree = self.p, self.degrees[mask] - nu * (self.p - 1)
        size = degree * (p**level - 1) // (p - 1) + 1
        statement = {"mask": mask, "nu": nu, "level": level, "norm": rational(norm)}
        return self.add("norm", statement, uses=[self.sum_rules(mask)], work=(degree + 1) * size)

    def product(self, mask: int, word: Sequence[int], radius: Fraction) -> int:
        """The claim that the product of the word's transition matrices has at least this spectral radius."""
        degree = self.degrees[mask] - self.orders[mask] * (self.p - 1)
        order = max(1, -(-degree // (self.p - 1)))
        statement = {"mask": mask, "word": list(word), "radius": rational(radius)}
        work = len(word) * order**3 + order**4
        return self.add("product", statement, uses=[self.sum_rules(mask)], work=work)

    def family(self, mask: int, nu: int) -> int:
        """The claim that introduces the transition matrices of S_(Δ^ν) of this mask."""
        if (mask, nu) not in self._family_claims:
            order = max(1, -(-(self.degrees[mask] - nu * (self.p - 1)) // (self.p - 1)))
            statement = {"family": len(self.families), "mask": mask, "nu": nu}
            work = self.p * order**2 + order * (self.orders[mask] - nu + 1) * self.p
            self.families.append(None)
            uses = [self.sum_rules(mask)]
            self._family_claims[mask, nu] = self.add("transition", statement, uses=uses, work=work, name="family")
        return self._family_claims[mask, nu]

    def contraction(self, mask: int, witness: ContractivityWitness | ConvergenceWitness) -> list[int]:
        """The claims, in the order in which conclusions use them, by which a derived scheme of this mask contracts."""
        if "radius_of" in witness:
            return radius.claims(self, mask)
        return [self.norm(mask, witness["nu"], witness["level"], witness["norm"])]

    def obstacle(self, mask: int, order: int, witness: ProductWitness) -> int:
        """The claim that keeps a stable φ of this mask from being C^order."""
        if "word" not in witness:
            return self.sum_rules(mask)
        word = witness["word"]
        return self.product(mask, word, self._radius(mask, word, Fraction(1, self.p ** (order * len(word)))))

    def _radius(self, mask: int, word: Sequence[int], least: Fraction) -> Fraction:
        """The radius to claim of a product: the least one that is needed, or a larger one that serves all orders.

        The larger one is that of SD312, if it is of this product and large enough.
        """
        if mask != self.last or self.facts.verdict(rules.HOLDER_UPPER) not in DECIDED:
            return least
        witness = self.facts.witness(rules.HOLDER_UPPER)
        return max(least, witness["radius"]) if witness.get("word") == tuple(word) else least

    def radius(self, mask: int) -> tuple[JointRadiusWitness, RadiusProof]:
        """The witness and the proof that SD310 has for this mask."""
        name = "S" if mask == 0 else "S0"
        proved = (finding for finding in self.facts.all(rules.JOINT_RADIUS) if finding.verdict is Verdict.PROVED)
        return next(
            (witness, proof_of(finding, RadiusProof))
            for finding in proved
            if (witness := rules.JOINT_RADIUS.witness_of(finding))["of"] == name
        )

    def independent(self, mask: int, witness: StabilityWitness) -> list[int]:
        """The claims that the integer translates of φ of this mask are linearly independent."""
        if "cofactors" not in witness or len(witness["gcd"]) > 1:
            return []
        work = 20 * (self.degrees[mask] + 1) ** 2
        return [self.add("independent", {"mask": mask, "holds": True}, {"cofactors": _cofactors(witness)}, work=work)]

    def stable(self, mask: int, witness: StabilityWitness) -> list[int]:
        """The claims that the integer translates of φ of this mask are stable."""
        if "cofactors" not in witness:
            return []
        statement, n = {"mask": mask, "holds": True}, self.degrees[mask] + 1
        if independent := self.independent(mask, witness):
            return [self.add("stable", statement, uses=independent)]
        hints = {"gcd": polynomial(0, witness["gcd"]), "cofactors": _cofactors(witness)}
        return [self.add("stable", statement, hints, work=20 * n**2 + n**3)]

    def last_stable(self) -> list[int]:
        """The claims that the last mask is stable."""
        if not self.last:
            return self.stable(0, self.facts.witness(rules.STABILITY))
        return self.stable(self.last, self.facts.witness(rules.REDUCTION)["stable"])

    def _reduce(self, witness: ReductionWitness) -> None:
        steps = zip(witness["factors"], witness["starts"], witness["masks"], strict=True)
        for number, (factor, start, mask) in enumerate(steps):
            statement = {"from": number, "to": number + 1}
            hints = {"factor": polynomial(0, factor), "mask": polynomial(start, mask)}
            self.reductions.append(self.add("reduction", statement, hints, work=(self.degrees[number] + 1) ** 2))
            self.degrees.append(len(mask) - 1)
        self.orders[len(self.degrees) - 1] = witness["order"]


def _cofactors(witness: StabilityWitness) -> list[Json]:
    """The cofactors of a witness, one polynomial for each polyphase component."""
    pairs = zip(witness["starts"], witness["cofactors"], strict=True)
    return [polynomial(start, coefficients) for start, coefficients in pairs]
