"""The claims on limit stencils and the differences of φ (SD621), and on what follows, as FORMAT.md says."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from subdiv_cli.certificate.claims import Claims, Json
from subdiv_cli.certificate.radius import Radii, root_fields, spelled
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.witnesses import (
    MultivariateHolderLowerWitness,
    MultivariateHolderUpperWitness,
    StencilRadiusProof,
)
from subdiv_cli.model.closed import rational, rationals
from subdiv_cli.model.findings import proof_of
from subdiv_cli.model.proofs import RadiusProof, RootData


class StencilClaims:
    """The claims of one certificate that rest on the finding SD621. Each method returns the number of one, or several.

    `families` are those of the certificate, `size` is the dimension s, the index m and the number of terms of the mask,
    and `convergent` makes the claim that S converges.
    """

    def __init__(
        self,
        claims: Claims,
        facts: Facts,
        families: list[None],
        size: tuple[int, int, int],
        convergent: Callable[[], int],
    ) -> None:
        self._claims, self._facts, self._families = claims, facts, families
        self._s, self._m, self._terms = size
        self._convergent = convergent
        self._family: tuple[int, int] | None = None
        self._radius_claim: int | None = None

    @property
    def _proof(self) -> StencilRadiusProof:
        return proof_of(self._facts[rules.STENCIL_RADIUS], StencilRadiusProof)

    def _introduced(self) -> tuple[int, int]:
        """The number of the family, and that of the claim that introduces it."""
        if self._family is None:
            witness, space = self._facts.witness(rules.STENCIL_RADIUS), self._proof["space"]
            w, coset = witness["stencil"], spelled(space["cosets"][0])
            hints: Json = {"terms": [[list(index), rational(x)] for index, x in w]}
            work = len(w) * (self._terms + 1)
            stencil = self._claims.prove("limit-stencil", {"coset": coset}, hints, work=work)
            n, width, words = len(space["basis"]), len(space["window"]), space["words"]
            work = len(space["tree"]) * space["breadth"] * self._terms + sum(space["tree"]) * n * width
            work += n * width * ((self._m + 1) * n + self._terms) + sum(map(len, words)) * n * n + n**3
            hints = {"cosets": spelled(space["cosets"]), "window": spelled(space["window"])}
            hints |= {"basis": spelled(space["basis"]), "matrices": rationals(space["matrices"])}
            hints |= {"tree": list(space["tree"]), "breadth": space["breadth"], "leaves": rationals(space["leaves"])}
            hints["words"] = spelled(words)
            number = len(self._families)
            self._families.append(None)
            statement = {"property": "stencil-family", "family": number, "order": witness["order"]}
            self._family = number, self._claims.prove("stencil-differences", statement, hints, [stencil], work)
        return self._family

    def bound(self) -> list[int]:
        """The claims on ρ_k(w): from above, the number itself or a product that keeps it up; and on its family."""
        if "radius" in self._proof:
            return self._radius(self._proof["radius"])
        witness = self._facts.witness(rules.STENCIL_RADIUS)
        return self._word(witness["word"], witness["least"])

    def _radius(self, proof: RadiusProof) -> list[int]:
        number, space = self._introduced()
        if self._radius_claim is None:
            radii = Radii(self._claims, self._families, self._m, [])
            self._radius_claim = radii.claim(proof, number, len(self._proof["space"]["basis"]))
        return [self._radius_claim, space]

    def _word(self, word: tuple[int, ...], bound: Fraction) -> list[int]:
        """The claims that a product bounds ρ_k(w) from below, and on its family."""
        number, space = self._introduced()
        n, length = len(self._proof["space"]["basis"]), len(word)
        statement = {"property": "radius-lower", "family": number, "length": length, "bound": rational(bound)}
        return [self._claims.prove("word", statement, {"word": list(word)}, work=length * n**3 + n**4), space]

    def smooth(self, n: int) -> int:
        """The claim that φ is C^n."""
        statement = {"property": "smooth", "order": n}
        return self._claims.prove("stencil-smooth", statement, uses=[self._convergent(), *self.bound()])

    def not_smooth(self, n: int) -> int:
        """The claim that φ is not C^n: by ρ_k(w) itself where that is known and large enough, else by a product."""
        witness = self._facts.witness(rules.STENCIL_RADIUS)
        k, word, root = witness["order"], witness["word"], witness.get("root")
        least = min(n, k)
        low, length = (witness.get("least"), len(word)) if root is None else (root["low"], witness["length"])
        if low is not None:
            size = low**self._s * self._m ** (least * length)
            if size > 1 or (size == 1 and n < k):
                return self._not_smooth(n, self.bound())
        if n < k:
            return self._not_smooth(n, self._word(word * self._s, Fraction(1, self._m ** (n * len(word)))))
        return self._not_smooth(n, self._word(word, self._facts.witness(rules.HOLDER_UPPER)["radius"]))

    def _not_smooth(self, n: int, bound: list[int]) -> int:
        statement = {"property": "not-smooth", "order": n}
        return self._claims.prove("stencil-not-smooth", statement, uses=[self._convergent(), *bound])

    def holder_lower(self, witness: MultivariateHolderLowerWitness) -> int:
        """The claim that bounds α from below, or says what it is."""
        if "root" in witness:
            return self._holder_root(witness["length"], witness["root"])
        statement: Json = {"property": "holder-lower", "length": witness["length"], "bound": rational(witness["bound"])}
        return self._claims.prove("stencil-holder-lower", statement, uses=[self._convergent(), *self.bound()])

    def _holder_root(self, length: int, root: RootData) -> int:
        statement = {"property": "holder-root", "length": length, **root_fields(root)}
        return self._claims.prove("stencil-holder-root", statement, uses=[self._convergent(), *self.bound()])

    def meets(self, below: int, witness: MultivariateHolderLowerWitness) -> int:
        """The claim that says what α is, by a claim that bounds it from below and a product that does from above."""
        above = self.holder_upper(rules.HOLDER_UPPER.witness_of(self._facts[rules.HOLDER_UPPER]))
        statement = {"property": "holder-root", "length": witness["length"], **root_fields(witness["root"])}
        return self._claims.prove("holder-meets", statement, uses=[below, above])

    def holder_upper(self, witness: MultivariateHolderUpperWitness) -> int:
        """The claim that bounds α from above by a product."""
        uses = [self._convergent(), *self._word(witness["word"], witness["radius"])]
        statement: Json = {
            "property": "holder-upper",
            "length": witness["length"],
            "bound": rational(witness["radius"]),
        }
        return self._claims.prove("stencil-holder-upper", statement, uses=uses)
