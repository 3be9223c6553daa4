"""A certificate under construction: the claims that several findings share."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from subdiv_cli.certificate.claims import Claims, Json
from subdiv_cli.certificate.radius import Radii
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar.witnesses import JordanBlockWitness
from subdiv_cli.kinds.vector import rules
from subdiv_cli.kinds.vector.witnesses import SequenceRadiusProof, SequenceRadiusWitness, SequenceSpaceData
from subdiv_cli.model import Finding, Rule, Verdict
from subdiv_cli.model.closed import rational, rationals
from subdiv_cli.model.findings import proof_of
from subdiv_cli.model.proofs import RadiusProof


class VectorProof:
    """A certificate under construction: each method returns the numbers of claims, made if there are none yet."""

    def __init__(self, mask: Json, findings: Sequence[Finding]) -> None:
        self.claims = Claims()
        self.facts = Facts(findings)
        self.p: int = mask["arity"]
        self.length = len(mask["coefficients"])
        self.size = len(mask["coefficients"][0])
        self._families: list[None] = []
        self._spaces: dict[int, int] = {}
        self._radii: dict[int, list[tuple[RadiusProof, int]]] = {}
        """The claims on radii by those that introduce their spaces, each with the proof that it is made of."""

    @property
    def entries(self) -> int:
        """The number of entries of all matrices."""
        return self.length * self.size**2

    @property
    def dimension(self) -> int:
        """The dimension r of E_A."""
        return self.facts.witness(rules.CONSTANTS)["dimension"]

    def constants(self) -> int:
        """The claim on E_A."""
        witness = self.facts.witness(rules.CONSTANTS)
        r = witness["dimension"]
        work = (self.entries + self.p * self.size**2) * (r + 1)
        return self.claims.prove("constants", {"dimension": r}, {"basis": rationals(witness["basis"])}, work=work)

    def decay(self) -> list[int]:
        """The claims on the radius of sequences that die out, and on their space."""
        return self._radius(rules.DECAY_RADIUS)

    def growth(self) -> list[int]:
        """The claims on the radius of differences of limit stencils, and on their space."""
        return self._radius(rules.STENCIL_RADIUS)

    def _radius(self, rule: Rule[SequenceRadiusWitness]) -> list[int]:
        proof = proof_of(self.facts[rule], SequenceRadiusProof)
        return self.radius(self.facts.witness(rule)["order"], proof["space"], proof["radius"])

    def radius(self, order: int, space: SequenceSpaceData, radius: RadiusProof) -> list[int]:
        """The claims on a radius, and on the space of this order."""
        return self.radius_on(self.space(order, space), space, radius)

    def radius_on(self, introduced: int, space: SequenceSpaceData, radius: RadiusProof) -> list[int]:
        """The claims on a radius, and the one that introduces its space."""
        known = self._radii.setdefault(introduced, [])
        claim = next((claim for proof, claim in known if proof == radius), None)
        if claim is None:
            number, n = self._number(introduced), len(space["basis"])
            claim = Radii(self.claims, self._families, self.p, []).claim(radius, number, n)
            known.append((radius, claim))
        return [claim, introduced]

    def _number(self, introduced: int) -> int:
        number: int = self.claims.statement(introduced)["family"]
        return number

    def space(self, order: int, space: SequenceSpaceData) -> int:
        """The claim that introduces the operators on an invariant space: of order 0 that of what dies out."""
        if order in self._spaces:
            return self._spaces[order]
        statement = {"property": "family", "family": self.new_family(), "order": order}
        if order:
            witness, work = self.spanned(space, order + 2 + self.stencil_width())
            claim = self.claims.prove("stencil-differences", statement, witness, [self.stencils()], work)
        else:
            witness, work = self._invariant(space, 2)
            witness["orthogonal"] = rationals(space["orthogonal"])
            work += len(space["basis"]) * self.size**2
            claim = self.claims.prove("decay", statement, witness, [self.constants()], work)
        self._spaces[order] = claim
        return claim

    def new_family(self) -> int:
        """The number of a new family."""
        self._families.append(None)
        return len(self._families) - 1

    def spanned(self, space: SequenceSpaceData, given: int) -> tuple[Json, int]:
        """The witness of an invariant space that words span, and its work; the generators have `given` indices."""
        witness, work = self._invariant(space, given)
        words, n = [list(word) for word in space["words"]], len(space["basis"])
        return {**witness, "words": words}, work + sum(map(len, words)) * n * n + n**3

    def _invariant(self, space: SequenceSpaceData, given: int) -> tuple[Json, int]:
        """The witness of an invariant space, and its work."""
        basis, tree = space["basis"], space["tree"]
        n, width = len(basis), len(basis[0])
        work = len(tree) * (max(self.length, given) + 2) * self.entries + sum(tree) * n * width
        work += n * width * (n * (self.p + 1) + self.entries // self.size)
        witness: Json = {"start": space["start"], "tree": list(tree), "basis": rationals(basis)}
        witness |= {"matrices": rationals(space["matrices"]), "leaves": rationals(space["leaves"])}
        return witness, work

    def stencil_width(self) -> int:
        """The number of indices of the limit stencils."""
        return len(self.facts.witness(rules.LIMIT_STENCILS)["rows"][0]) // self.size

    def word(self, order: int, space: SequenceSpaceData, word: Sequence[int], bound: Fraction) -> list[int]:
        """The claims that a product bounds the radius on a space from below, and on that space."""
        return self.word_on(self.space(order, space), space, word, bound)

    def word_on(self, introduced: int, space: SequenceSpaceData, word: Sequence[int], bound: Fraction) -> list[int]:
        """The claims that a product bounds the radius from below, and the one that introduces its space."""
        n = len(space["basis"])
        statement = {
            "property": "radius-lower",
            "family": self._number(introduced),
            "length": len(word),
            "bound": rational(bound),
        }
        work = len(word) * n**3 + n**4
        return [self.claims.prove("word", statement, {"word": list(word)}, work=work), introduced]

    def defective(self, order: int, space: SequenceSpaceData, witness: JordanBlockWitness) -> list[int]:
        """The claims that a product on a space has a Jordan block, and on that space."""
        introduced, n, word = self.space(order, space), len(space["basis"]), list(witness["word"])
        statement: Json = {"property": "defective", "family": self._number(introduced), "length": len(word)}
        statement["value"] = rationals(witness["value"])
        hints = {"word": word, "sign": witness["sign"], "vector": rationals(witness["vector"])}
        return [self.claims.prove("defective", statement, hints, work=len(word) * n**3 + 2 * n**2), introduced]

    def convergent(self) -> int:
        """The claim that S converges, or that it does not."""
        witness, holds = self.facts.witness(rules.CONVERGENCE), self.facts.verdict(rules.CONVERGENCE) is Verdict.PROVED
        statement: Json = {"property": "convergent", "holds": holds}
        if holds:
            return self.claims.prove("converges", statement, uses=self.decay())
        if witness["by"] == rules.CONSTANTS.code:
            return self.claims.prove("diverges", statement, uses=[self.constants()])
        if witness["by"] == rules.LIMIT_STENCILS.code:
            rows = witness["fixed"]
            hints = {"start": witness["start"], "rows": rationals(rows)}
            work = self._fixed(len(rows), len(rows[0]))
            return self.claims.prove("fixed-diverges", statement, hints, [self.constants()], work)
        space = proof_of(self.facts[rules.DECAY_RADIUS], SequenceRadiusProof)["space"]
        return self.claims.prove("diverges", statement, uses=self.word(0, space, witness["word"], Fraction(1)))

    def stencils(self) -> int:
        """The claim on the limit stencils."""
        witness = self.facts.witness(rules.LIMIT_STENCILS)
        rows = witness["rows"]
        hints = {"start": witness["start"], "rows": rationals(rows)}
        work = self._fixed(len(rows), len(rows[0]))
        return self.claims.prove("limit-stencils", {"count": len(rows)}, hints, [self.constants()], work)

    def _fixed(self, count: int, length: int) -> int:
        return count * (length // self.size + 1) * self.entries + (count + self.size) ** 2 * length
