"""The certificate of a scheme of matrices, as FORMAT.md says."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

from subdiv_cli.certificate.claims import Claims, Json, Proofs, UnwrittenError, proofs
from subdiv_cli.certificate.radius import Radii, root_fields, spelled
from subdiv_cli.kinds.kind import Analysis, Facts
from subdiv_cli.kinds.matrices import rules
from subdiv_cli.kinds.matrices.text import canonical
from subdiv_cli.kinds.matrices.witnesses import (
    ComponentsProof,
    CurveHolderLowerWitness,
    CurveRadiusProof,
    JointsProof,
)
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.model.closed import rational, rationals
from subdiv_cli.model.findings import proof_of
from subdiv_cli.model.proofs import RadiusProof


def claims_of(analysis: Analysis) -> Proofs:
    """The claims that prove what was found of a scheme of matrices."""
    mask = dict(canonical(analysis.scheme))
    proof = _CurveProof(mask, analysis.findings)
    return proofs(proof.claims, mask, analysis.findings, proof.claims_of)


class _CurveProof:
    """A certificate under construction. Each method returns the number of a claim."""

    def __init__(self, mask: Json, findings: Sequence[Finding]) -> None:
        self.claims = Claims()
        self.facts = Facts(findings)
        self.p, self.n = len(mask["matrices"]), len(mask["matrices"][0])
        self._families: list[None] = [None]
        """The family of the document, and those that claims introduce."""
        self._on: dict[str, int] = {}
        """The numbers of the families on differences of polygons and on V."""

    def claims_of(self, finding: Finding) -> list[int]:
        """The claims that state a decided finding."""
        makers: dict[str, Callable[[Finding], list[int]]] = {
            rules.SIGN_PATTERNS.code: lambda _: [self._patterns()],
            rules.CONVERGENCE.code: lambda _: [self._convergent()],
            rules.WELL_DEFINED.code: lambda _: [self._well_defined()],
            rules.COMPONENTS.code: lambda _: [self._polynomials()],
            rules.DIFFERENCE_RADIUS.code: lambda _: [self._radius()],
            rules.JOINTS.code: lambda _: self._joints(),
            rules.SMOOTHNESS.code: lambda _: [self._smooth()],
            rules.NEXT_SMOOTHNESS.code: lambda _: [self._not_smooth()],
            rules.HOLDER_LOWER.code: lambda _: [self._lower()],
            rules.HOLDER_UPPER.code: lambda _: [self._upper()],
        }
        return makers[finding.code](finding)

    def _patterns(self) -> int:
        witness = self.facts.witness(rules.SIGN_PATTERNS)
        if self.facts.verdict(rules.SIGN_PATTERNS) is Verdict.REFUTED:
            return self._diverges(witness["word"][::-1])
        length, steps = witness["length"], witness["steps"]
        if witness["by"] != "graph":
            work = self.p * self.n**4
            return self.claims.prove(
                "consecutive-columns", {"property": "positive-columns", "length": length}, work=work
            )
        steps *= length  # a pattern may come again on paths of other lengths
        work = (self.p + steps) * self.n**2
        return self.claims.prove("positive-columns", {"length": length}, {"steps": steps}, work=work)

    def _convergent(self) -> int:
        witness = self.facts.witness(rules.CONVERGENCE)
        by_patterns = witness["by"] == rules.SIGN_PATTERNS.code
        if self.facts.verdict(rules.CONVERGENCE) is Verdict.REFUTED:
            word = witness["word"]
            return self._diverges(word[::-1] if by_patterns else word)
        statement: Json = {"property": "convergent", "holds": True}
        if by_patterns:
            return self.claims.prove("columns-converge", statement, uses=[self._patterns()])
        return self.claims.prove("contracts", statement, uses=[self._decay(), self._differences()])

    def _diverges(self, word: Sequence[int]) -> int:
        """The claim that a product B_(w_ℓ) ⋯ B_(w_1) has an eigenvalue of modulus 1 or more on e^⊥."""
        differences = self._differences()
        lower = self._word("polygons", word, Fraction(1), self.n - 1)
        statement = {"property": "convergent", "holds": False}
        return self.claims.prove("expands", statement, uses=[lower, differences])

    def _differences(self) -> int:
        """The claim that introduces the family on e^⊥."""
        number = self._number("polygons")
        statement = {"property": "family", "family": number, "on": "polygons"}
        return self.claims.prove("differences", statement, work=self.p * self.n**2)

    def _decay(self) -> int:
        """The claim on the radius on e^⊥."""
        self._differences()
        proof = proof_of(self.facts[rules.CONVERGENCE], RadiusProof)
        return self._of_family("polygons", proof, self.n - 1)

    def _number(self, on: str) -> int:
        """The number of the family on a space, which is introduced next where it is new."""
        if on not in self._on:
            self._on[on] = len(self._families)
            self._families.append(None)
        return self._on[on]

    def _of_family(self, on: str, proof: RadiusProof, order: int) -> int:
        """The claim on the radius of a family, which is made once: it may introduce families of its own."""
        if (key := f"radius on {on}") not in self._on:
            self._on[key] = Radii(self.claims, self._families, self.p, []).claim(proof, self._on[on], order)
        return self._on[key]

    def _word(self, on: str, word: Sequence[int], bound: Fraction, order: int) -> int:
        number, length = self._on[on], len(word)
        statement = {"property": "radius-lower", "family": number, "length": length, "bound": rational(bound)}
        work = length * order**3 + order**4
        return self.claims.prove("word", statement, {"word": list(word)}, work=work)

    def _well_defined(self) -> int:
        holds, known = self.facts.verdict(rules.WELL_DEFINED), self.facts.witness(rules.WELL_DEFINED)
        statement = {"property": "well-defined", "holds": holds is Verdict.PROVED}
        witness = {"left": rationals(known["left"]), "right": rationals(known["right"])}
        work = 2 * self.p * self.n**2
        return self.claims.prove("meets", statement, witness, [self._convergent()], work)

    def _polynomials(self) -> int:
        if self.facts.verdict(rules.COMPONENTS) is not Verdict.PROVED:
            raise UnwrittenError
        known = self.facts.witness(rules.COMPONENTS)
        d, m = known["degree"], known["dimension"]
        proof = proof_of(self.facts[rules.COMPONENTS], ComponentsProof)
        witness: Json = {"annihilator": rationals(proof["annihilator"]), "polygons": rationals(proof["polygons"])}
        witness |= {"words": spelled(proof["words"]), "level": proof["level"], "weights": rationals(proof["weights"])}
        longest = max(map(len, proof["words"]))
        steps = m * (longest + self.p * (self.n - m + d + 1)) + 2 * len(proof["weights"])
        work = steps * self.n**2 + (m + self.n) ** 3
        statement = {"property": "polynomials", "degree": d, "dimension": m}
        return self.claims.prove("components", statement, witness, [self._well_defined()], work)

    @property
    def _degree(self) -> int:
        return self.facts.witness(rules.COMPONENTS)["degree"]

    @property
    def _space(self) -> str:
        """The family whose radius is that on V: that on e^⊥ where V is all of it."""
        return "polygons" if self._proof["whole"] else "curve"

    @property
    def _proof(self) -> CurveRadiusProof:
        return proof_of(self.facts[rules.DIFFERENCE_RADIUS], CurveRadiusProof)

    @property
    def _order(self) -> int:
        return len(self._proof["basis"])

    def _annihilators(self) -> int:
        """The claim that introduces the family on V."""
        if self._space == "polygons":
            return self._differences()
        size, n = self._order, self.n
        used, number = self._polynomials(), self._number("curve")
        work = size * n * (n + self.p * (n + size)) + n * size**2
        witness = {
            "basis": rationals(self._proof["basis"]),
            "matrices": rationals(self._proof["matrices"]),
        }
        statement = {"property": "family", "family": number, "on": "curve"}
        return self.claims.prove("annihilators", statement, witness, [used], work)

    def _radius(self) -> int:
        """The claim on ρ, the joint spectral radius on V."""
        self._annihilators()
        return self._of_family(self._space, self._proof["radius"], self._order)

    def _bounded(self) -> list[int]:
        """The claims that bound ρ, as rules use them."""
        family = self._annihilators()
        return [self._polynomials(), self._radius(), family]

    def _growing(self, word: Sequence[int], bound: Fraction) -> list[int]:
        """The claims that bound ρ from below by a product."""
        family = self._annihilators()
        return [self._polynomials(), self._word(self._space, word, bound, self._order), family]

    def _derivatives(self, orders: Sequence[int]) -> list[int]:
        """The claims on the derivatives of some orders that were asked."""
        if not orders:
            return []
        decided, fit = self.facts.witness(rules.JOINTS)["orders"], self.facts.verdict(rules.JOINTS)
        proof = proof_of(self.facts[rules.JOINTS], JointsProof)
        made = []
        for order in orders:
            place = decided.index(order)
            fits = fit is Verdict.PROVED or order < decided[-1]
            witness = {"left": rationals(proof["left"][place]), "right": rationals(proof["right"][place])}
            work = 2 * (self.p + self.n) * self.n**2
            made.append(
                self.claims.prove("derivative", {"order": order, "holds": fits}, witness, self._bounded(), work)
            )
        return made

    def _joints(self) -> list[int]:
        orders = self.facts.witness(rules.JOINTS)["orders"]
        return self._derivatives(orders if self.facts.verdict(rules.JOINTS) is Verdict.PROVED else orders[-1:])

    def _polynomial(self) -> int:
        statement = {"property": "polynomial-curve", "degree": self._degree}
        return self.claims.prove("polynomial-curve", statement, uses=[self._polynomials()])

    def _smooth(self) -> int:
        witness = self.facts.witness(rules.SMOOTHNESS)
        by = witness["by"]
        if by == rules.COMPONENTS.code:
            return self._polynomial()
        n = witness["order"]
        statement = {"property": "smooth", "order": n}
        if by == rules.WELL_DEFINED.code:
            return self.claims.prove("continuous", statement, uses=[self._well_defined()])
        last = min(n, self._degree)
        uses = [*self._bounded(), *self._derivatives(range(1, last + 1))]
        return self.claims.prove("smooth", statement, uses=uses, work=1 + last)

    def _not_smooth(self) -> int:
        witness = self.facts.witness(rules.NEXT_SMOOTHNESS)
        n = witness["order"]
        statement = {"property": "not-smooth", "order": n}
        if witness["by"] == rules.JOINTS.code:
            return self.claims.prove("corner", statement, uses=self._derivatives([n]))
        known = self.facts.witness(rules.DIFFERENCE_RADIUS)
        if "root" in known and known["root"]["low"] * self.p ** (n * known["length"]) >= 1:
            return self.claims.prove("not-smooth", statement, uses=self._bounded())
        word = witness["word"]
        uses = self._growing(word, Fraction(1, self.p ** (n * len(word))))
        return self.claims.prove("not-smooth", statement, uses=uses)

    def _lower(self) -> int:
        witness = self.facts.witness(rules.HOLDER_LOWER)
        by = witness["by"]
        if by == rules.COMPONENTS.code:
            return self._polynomial()
        if by == rules.JOINTS.code:
            return self._value(witness["value"])
        if "root" in witness:
            return self._root(witness)
        bound, length = witness["bound"], witness["length"]
        statement = {"length": length, "bound": rational(bound)}
        uses = [*self._bounded(), *self._fitting(bound, length)]
        return self.claims.prove("holder-lower", statement, uses=uses, work=1 + self._degree)

    def _fitting(self, x: Fraction, length: int) -> list[int]:
        """The claims on the derivatives of the orders δ <= d with p^-δ > x^(1/length)."""
        orders = range(1, self._degree + 1)
        return self._derivatives([order for order in orders if x * self.p ** (order * length) < 1])

    def _root(self, witness: CurveHolderLowerWitness) -> int:
        length, root = witness["length"], witness["root"]
        statement = {"length": length, **root_fields(root)}
        uses = [*self._bounded(), *self._fitting(root["low"], length)]
        return self.claims.prove("holder-root", statement, uses=uses, work=1 + self._degree)

    def _value(self, value: int) -> int:
        uses = self._derivatives([value, *range(1, value)])
        return self.claims.prove("holder-value", {"value": value}, uses=uses, work=1 + value)

    def _upper(self) -> int:
        witness, below = self.facts.witness(rules.HOLDER_UPPER), self.facts.witness(rules.HOLDER_LOWER)
        if witness["by"] == rules.JOINTS.code:
            return self._value(witness["value"])
        if "root" in below:
            return self._root(below)
        statement = {"length": witness["length"], "bound": rational(witness["radius"])}
        uses = self._growing(witness["word"], witness["radius"])
        return self.claims.prove("holder-upper", statement, uses=uses)
