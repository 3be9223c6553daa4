"""A certificate under construction: its masks, and the claims that several findings share.

Sum rules, norms, products of transition matrices, stability, reduction steps. Mask 0 is the mask of the document;
`last` is the one that decides smoothness: 0, or the last reduced one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import cast

from subdiv_cli.certificate.claims import Claims, Json
from subdiv_cli.certificate.witness import as_cofactors, as_integer, as_polynomial, as_rational, as_tuple, as_word
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.claims import radius
from subdiv_cli.model import Data, Finding, Verdict
from subdiv_cli.model.closed import rational


class Proof:
    """A certificate under construction: each method returns the number of a claim, which it makes if there is none yet.

    Where a method returns a list, it is empty where a witness was too costly to compute.
    """

    def __init__(self, p: int, degree: int, findings: Sequence[Finding]) -> None:
        self.p = p
        self.claims = Claims()
        self.found = Facts(findings)
        self.contractions = [f for f in self.found.all(rules.CONTRACTIVITY) if f.verdict is Verdict.PROVED]
        self.degrees = [degree]
        self.reductions: list[int] = []
        self.radii = {
            f.witness["of"]: f for f in findings if f.code == rules.JOINT_RADIUS.code and f.verdict is Verdict.PROVED
        }
        self.families: list[None] = []
        """One entry for each family that has a number."""
        self._family_claims: dict[tuple[int, int], int] = {}
        self.orders = {0: as_integer(self.found[rules.SUM_RULES].witness.get("order", 0))}
        if (reduction := self.found.find(rules.REDUCTION)) is not None:
            self._reduce(reduction.witness)
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
        witness = self.found[rules.SUM_RULES if mask == 0 else rules.REDUCTION].witness
        quotient = as_polynomial(witness["cofactor_start"], witness["cofactor"])
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

    def contraction(self, mask: int, witness: Mapping[str, Data]) -> list[int]:
        """The claims, in the order in which conclusions use them, by which a derived scheme of this mask contracts."""
        if "radius_of" in witness:
            return radius.claims(self, mask)
        nu, level = as_integer(witness["nu"]), as_integer(witness["level"])
        return [self.norm(mask, nu, level, as_rational(witness["norm"]))]

    def obstacle(self, mask: int, order: int, witness: Mapping[str, Data]) -> int:
        """The claim that keeps a stable φ of this mask from being C^order."""
        if "word" not in witness:
            return self.sum_rules(mask)
        word = as_word(witness)
        return self.product(mask, word, self._radius(mask, word, Fraction(1, self.p ** (order * len(word)))))

    def _radius(self, mask: int, word: Sequence[int], least: Fraction) -> Fraction:
        """The radius to claim of a product: the least one that is needed, or a larger one that serves all orders.

        The larger one is that of SD312, if it is of this product and large enough.
        """
        witness = (
            self.found[rules.HOLDER_UPPER].witness if rules.HOLDER_UPPER in self.found and mask == self.last else {}
        )
        if "radius" not in witness or as_word(witness) != tuple(word):
            return least
        return max(least, as_rational(witness["radius"]))

    def independent(self, mask: int, witness: Mapping[str, Data]) -> list[int]:
        """The claims that the integer translates of φ of this mask are linearly independent."""
        if "cofactors" not in witness or len(as_tuple(witness["gcd"])) > 1:
            return []
        work = 20 * (self.degrees[mask] + 1) ** 2
        return [self.add("independent", {"mask": mask, "holds": True}, {"cofactors": as_cofactors(witness)}, work=work)]

    def stable(self, mask: int, witness: Mapping[str, Data]) -> list[int]:
        """The claims that the integer translates of φ of this mask are stable."""
        if "cofactors" not in witness:
            return []
        statement, n = {"mask": mask, "holds": True}, self.degrees[mask] + 1
        if independent := self.independent(mask, witness):
            return [self.add("stable", statement, uses=independent)]
        hints = {"gcd": as_polynomial(0, witness["gcd"]), "cofactors": as_cofactors(witness)}
        return [self.add("stable", statement, hints, work=20 * n**2 + n**3)]

    def last_stable(self) -> list[int]:
        """The claims that the last mask is stable."""
        if not self.last:
            return self.stable(0, self.found[rules.STABILITY].witness)
        return self.stable(self.last, cast(Mapping[str, Data], self.found[rules.REDUCTION].witness["stable"]))

    def _reduce(self, witness: Mapping[str, Data]) -> None:
        steps = zip(*(as_tuple(witness[key]) for key in ("factors", "starts", "masks")), strict=True)
        for number, (factor, start, mask) in enumerate(steps):
            statement = {"from": number, "to": number + 1}
            hints = {"factor": as_polynomial(0, factor), "mask": as_polynomial(start, mask)}
            self.reductions.append(self.add("reduction", statement, hints, work=(self.degrees[number] + 1) ** 2))
            self.degrees.append(len(as_tuple(mask)) - 1)
        self.orders[len(self.degrees) - 1] = as_integer(witness["order"])
