"""The certificate of a mask in several variables, as FORMAT.md says."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import comb
from typing import Any

from subdiv_cli.certificate.claims import Claims, Json, Proofs, UnwrittenError, polynomial, proofs
from subdiv_cli.certificate.radius import Radii, root_fields, spelled
from subdiv_cli.kinds.kind import Analysis, Facts, Part
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.claims.norms import directional_norms, gram_sequence, matrix_norm, pair_norms
from subdiv_cli.kinds.multivariate.claims.products import BoxSplineClaims, Factors, PartCertificate
from subdiv_cli.kinds.multivariate.claims.stencils import StencilClaims
from subdiv_cli.kinds.multivariate.stages.wording import largest_norm
from subdiv_cli.kinds.multivariate.text.writing import canonical
from subdiv_cli.kinds.multivariate.witnesses import (
    DifferenceRadiusProof,
    GrowthProof,
    MultivariateSmoothnessWitness,
    MultivariateSobolevWitness,
    PlacedNumbers,
)
from subdiv_cli.kinds.scalar.claims import claims_of as univariate_claims
from subdiv_cli.model import DECIDED, Finding, Verdict, exact_root
from subdiv_cli.model.closed import rational, rationals
from subdiv_cli.model.findings import proof_of
from subdiv_cli.model.proofs import RootData, upper_bound


def claims_of(analysis: Analysis) -> Proofs:
    """The claims that prove what was found of a mask in several variables, with certificates of its factors inside."""
    parts = [_of_part(part) for part in analysis.parts]
    mask = dict(canonical(analysis.scheme))
    proof = _Proof(mask, analysis.findings, parts)
    return proofs(proof.claims, mask, analysis.findings, proof.claims_of)


def _of_part(part: Part) -> PartCertificate | None:
    """The certificate of a factor, and what it states of each question; None where it would have no claim."""
    make = univariate_claims if part.scheme.kind == "scalar" else claims_of
    written = make(part.analysis).certificate()
    if written is None:
        return None
    claims, findings = written.document["claims"], part.analysis.findings
    stated = {
        question: [claims[number]["statement"] for number in numbers]
        for finding, chosen, numbers in zip(findings, written.findings, written.claims, strict=True)
        for question, _ in finding.answers
        if numbers and chosen is finding
    }
    return PartCertificate(part.variables, written.document, stated)


class _Proof:
    """A certificate under construction. Each method returns the number of a claim."""

    def __init__(self, mask: Json, findings: Sequence[Finding], parts: Sequence[PartCertificate | None]) -> None:
        self.claims = Claims()
        self.facts = Facts(findings)
        self.s = len(mask["dilation"])
        self.terms = len(mask["terms"])
        self.m = len(self.facts.witness(rules.COSET_SUMS)["cosets"])
        self.factors = Factors(self.claims, parts, self.terms * (self.s + 1))
        self._families: list[None] = []
        size = (self.s, self.m, self.terms)
        self.stencils = StencilClaims(self.claims, self.facts, self._families, size, self._convergent)
        self._family: tuple[int, int] | None = None
        self._radius_claim: int | None = None

    def claims_of(self, finding: Finding) -> list[int]:
        """The claims that state a decided finding; none where the certificate of a factor leaves it out."""
        makers: dict[str, Callable[[Finding], list[int]]] = {
            rules.COSET_SUMS.code: lambda _: [self._coset_sums()],
            rules.SUM_RULES.code: self._sum_rules_and_generation,
            rules.BOX_SPLINE.code: lambda _: [self.box.spline()],
            rules.SUBLATTICE.code: lambda _: [self._sublattice()],
            rules.DIRECTIONAL_NORMS.code: self._norms,
            rules.DIFFERENCE_RADIUS.code: lambda _: [self._radius(), self._differences()],
            rules.STENCIL_RADIUS.code: lambda _: self.stencils.bound(),
            rules.MATRIX_NORMS.code: lambda _: [self._matrix_norm()],
            rules.DIRECTIONAL_SMOOTHNESS.code: lambda _: [self._pairs()],
            rules.POSITIVE_MASK.code: lambda _: [self._positive()],
            rules.TENSOR_PRODUCT.code: lambda _: [self.factors.product()],
            rules.CONVERGENCE.code: lambda each: [self._convergent(each)],
            rules.SMOOTHNESS.code: self._smooth,
            rules.NEXT_SMOOTHNESS.code: self._next_smooth,
            rules.HOLDER_LOWER.code: self._lower,
            rules.HOLDER_UPPER.code: self._upper,
            rules.STABILITY.code: self._stability,
            rules.SOBOLEV.code: self._sobolev,
            rules.REPRODUCTION.code: self._reproduction,
            rules.QUASI_INTERPOLATION.code: self._quasi_interpolation,
        }
        return makers[finding.code](finding)

    @property
    def box(self) -> BoxSplineClaims:
        """The claims on the box spline that φ is."""
        return BoxSplineClaims(self.claims, self.facts.witness(rules.BOX_SPLINE), self.terms)

    def _coset_sums(self) -> int:
        holds = self.facts[rules.COSET_SUMS].verdict is Verdict.PROVED
        return self.claims.prove("coset-sums", {"holds": holds}, work=self.terms + self.m)

    @property
    def _order(self) -> int:
        """The order k of the sum rules."""
        return self.facts.witness(rules.SUM_RULES)["order"]

    def _sum_rules(self) -> int:
        k = self._order
        return self.claims.prove("total-sum-rules", {"order": k}, work=(self.terms + self.m) * comb(k + self.s, self.s))

    def _sum_rules_and_generation(self, finding: Finding) -> list[int]:
        k, order = rules.SUM_RULES.witness_of(finding)["order"], self._sum_rules()
        return [order, self.claims.prove("generation", {"degree": k - 1}, uses=[order])] if k else [order]

    def _norms(self, finding: Finding) -> list[int]:
        return directional_norms(self.claims, finding, self._factor())

    def _matrix_norm(self) -> int:
        return matrix_norm(self.claims, self.facts[rules.MATRIX_NORMS], self._sum_rules())

    def _pairs(self, order: int = 1) -> int:
        norms = pair_norms(self.claims, self.facts[rules.DIRECTIONAL_SMOOTHNESS], self._factor())
        statement = {"property": "smooth", "order": order}
        return self.claims.prove("directional-smooth", statement, {}, [self._coset_sums(), *norms], self._basis)

    @property
    def _basis(self) -> int:
        """The work to see that directions are bases of Z^s."""
        return 24 * (self.s + 1)

    def _directional_decay(self, by: str) -> int:
        """The claim on the decay of differences by directional factors, one at a time or in pairs."""
        c = self._factor()
        if by == rules.DIRECTIONAL_SMOOTHNESS.code:
            order, (level, bound) = 2, largest_norm(self.facts.witness(rules.DIRECTIONAL_SMOOTHNESS), c)
            norms = pair_norms(self.claims, self.facts[rules.DIRECTIONAL_SMOOTHNESS], c)
        else:
            order, (level, bound) = 1, largest_norm(self.facts.witness(rules.DIRECTIONAL_NORMS), 1)
            norms = directional_norms(self.claims, self.facts[rules.DIRECTIONAL_NORMS], c)
        statement = {"order": order, "level": level, "norm": rational(bound)}
        return self.claims.prove("directional-decay", statement, {}, [self._coset_sums(), *norms], self._basis)

    def _sublattice(self) -> int:
        witness = self.facts.witness(rules.SUBLATTICE)
        hints = {"functional": spelled(witness["functional"]), "modulus": witness["modulus"]}
        statement = {"property": "convergent", "holds": False}
        return self.claims.prove("sublattice-diverges", statement, hints, work=self.terms * self.s**2)

    def _positive(self) -> int:
        uses, work = [self._coset_sums()], self.terms * self.s
        return self.claims.prove("positive-converges", {"property": "convergent", "holds": True}, uses=uses, work=work)

    def _factor(self) -> int:
        """The factor c of a dilation c I."""
        c = exact_root(self.m, self.s)
        assert c is not None
        return c

    @property
    def _decay_proof(self) -> DifferenceRadiusProof:
        return proof_of(self.facts[rules.DIFFERENCE_RADIUS], DifferenceRadiusProof)

    def _differences(self) -> int:
        """The claim that introduces the transition operators on V_k."""
        return self._introduced()[1]

    def _introduced(self) -> tuple[int, int]:
        """The number of the family of V_k, and that of the claim that introduces it."""
        if self._family is None:
            space = self._decay_proof["space"]
            k, n, w = space["order"], len(space["basis"]), len(space["window"])
            s, m = self.s, self.m
            work = n * w * ((m + 1) * n + self.terms + comb(k + s, s) + comb(k + s - 1, s - 1))
            number = len(self._families)
            self._families.append(None)
            witness = {
                "cosets": spelled(space["cosets"]),
                "window": spelled(space["window"]),
                "basis": spelled(space["basis"]),
                "matrices": rationals(space["matrices"]),
                "generators": rationals(space["generators"]),
            }
            statement = {"property": "family", "family": number, "order": k}
            self._family = number, self.claims.prove("differences", statement, witness, [self._sum_rules()], work)
        return self._family

    def _radius(self) -> int:
        """The claim on ρ_k, the joint spectral radius on V_k: from above, or the number itself."""
        number, _ = self._introduced()
        if self._radius_claim is None:
            radii = Radii(self.claims, self._families, self.m, [])
            proof = self._decay_proof
            self._radius_claim = radii.claim(proof["radius"], number, len(proof["space"]["basis"]))
        return self._radius_claim

    def _word(self, word: Sequence[int], bound: Fraction) -> int:
        number, _ = self._introduced()
        order = len(self._decay_proof["space"]["basis"])
        statement = {"property": "radius-lower", "family": number, "length": len(word), "bound": rational(bound)}
        return self.claims.prove("word", statement, {"word": list(word)}, work=len(word) * order**3 + order**4)

    def _convergent(self, finding: Finding | None = None) -> int:
        """The claim on convergence, by the first finding unless another one is given."""
        finding = finding or self.facts[rules.CONVERGENCE]
        witness = rules.CONVERGENCE.witness_of(finding)
        holds, by = finding.verdict is Verdict.PROVED, witness["by"]
        if by == rules.POSITIVE_MASK.code:
            return self._positive()
        if by == rules.SUBLATTICE.code:
            return self._sublattice()
        rule, uses = "converges" if holds else "diverges", [self._coset_sums()]
        if by == rules.DIRECTIONAL_NORMS.code:
            rule, uses = (
                "directional-converges",
                [self._coset_sums(), *self._norms(self.facts[rules.DIRECTIONAL_NORMS])],
            )
        elif by == rules.TENSOR_PRODUCT.code:
            claims = self.factors.say("converges", {"property": "convergent", "holds": holds})
            if not claims:
                raise UnwrittenError
            return claims[0]
        elif by == rules.BOX_SPLINE.code:
            uses = [self.box.not_smooth(0)]
        elif by in (rules.MATRIX_NORMS.code, rules.SOBOLEV.code, rules.DIRECTIONAL_SMOOTHNESS.code):
            uses = self._decay(finding, by)
        elif by == rules.DIFFERENCE_RADIUS.code:
            uses = [self._radius() if holds else self._word(witness["word"], Fraction(1)), self._differences()]
        return self.claims.prove(rule, {"property": "convergent", "holds": holds}, uses=uses)

    def _stability(self, finding: Finding) -> list[int]:
        if rules.STABILITY.witness_of(finding)["by"] != rules.TENSOR_PRODUCT.code:
            return [self._stable()]
        statement = {"property": "stable", "holds": finding.verdict is Verdict.PROVED}
        return self.factors.say("stable", statement, self._convergent())

    def _stable(self) -> int:
        """The claim on the stability of a φ that is no tensor product."""
        finding = self.facts[rules.STABILITY]
        statement = {"property": "stable", "holds": finding.verdict is Verdict.PROVED}
        if rules.STABILITY.witness_of(finding)["by"] == rules.BOX_SPLINE.code:
            return self.box.stable(statement)
        if finding.proof:
            return gram_sequence(self.claims, finding, statement, self._convergent(), self.terms)
        return self.claims.prove("interpolatory-stable", statement, uses=[self._convergent()], work=self.terms)

    def _smooth(self, finding: Finding) -> list[int]:
        witness = rules.SMOOTHNESS.witness_of(finding)
        n, by = witness["order"], witness["by"]
        if finding.verdict is Verdict.REFUTED:
            return self._not_smooth(finding, witness)
        if by == rules.TENSOR_PRODUCT.code:
            return self.factors.say("smooth", {"property": "smooth", "order": n})
        if by == rules.BOX_SPLINE.code:
            return [self.box.smooth(n)]
        if by == rules.DIRECTIONAL_SMOOTHNESS.code:
            return [self._pairs(n)]
        if by == rules.STENCIL_RADIUS.code:
            return [self.stencils.smooth(n)]
        return [self.claims.prove("smooth", {"order": n}, uses=self._decay(finding, by))]

    def _decay(self, finding: Finding, by: str) -> list[int]:
        """The claims that bound ρ_k from above: by the radius of a family, by norms, or by mean squares."""
        if by == rules.CONVERGENCE.code:
            return [self._convergent()]
        if by == rules.SOBOLEV.code:
            return [self._mean_squares(finding, lower=True)]
        if by == rules.MATRIX_NORMS.code:
            return [self._matrix_norm()]
        if by in (rules.DIRECTIONAL_NORMS.code, rules.DIRECTIONAL_SMOOTHNESS.code):
            return [self._directional_decay(by)]
        return [self._radius(), self._differences()]

    def _next_smooth(self, finding: Finding) -> list[int]:
        return self._not_smooth(finding, rules.NEXT_SMOOTHNESS.witness_of(finding))

    def _not_smooth(self, finding: Finding, witness: MultivariateSmoothnessWitness) -> list[int]:
        n, by = witness["order"], witness["by"]
        statement: Json = {"property": "not-smooth", "order": n}
        if by == rules.TENSOR_PRODUCT.code:
            return self.factors.say("not-smooth", statement)
        if by == rules.BOX_SPLINE.code:
            return [self.box.not_smooth(n)]
        if by == rules.STENCIL_RADIUS.code:
            return [self.stencils.not_smooth(n)]
        if by == rules.SUM_RULES.code:
            return [self.claims.prove("not-smooth", statement, uses=[self._stable(), self._sum_rules()])]
        if by == rules.SOBOLEV.code:
            return [self.claims.prove("not-smooth", statement, uses=[self._mean_squares(finding, lower=False)])]
        below = self._reaching(n)
        return [self.claims.prove("not-smooth", statement, uses=[self._stable(), below, self._differences()])]

    def _reaching(self, n: int) -> int:
        """The claim ρ_k >= λ^-n: by the number itself where that is known and large enough, else by a product."""
        witness = self.facts.witness(rules.DIFFERENCE_RADIUS)
        root = witness.get("root")
        if root is not None and root["low"] ** self.s * self.m ** (n * witness["length"]) >= 1:
            return self._radius()
        word = witness["word"]
        return self._word(word * self.s, Fraction(1, self.m ** (n * len(word))))

    def _lower(self, finding: Finding) -> list[int]:
        witness = rules.HOLDER_LOWER.witness_of(finding)
        if witness["by"] == rules.TENSOR_PRODUCT.code:
            return self.factors.holder_lower(witness)
        if witness["by"] == rules.BOX_SPLINE.code:
            return [self.box.holder(witness["value"])]
        if witness["by"] == rules.STENCIL_RADIUS.code:
            return [self.stencils.holder_lower(witness)]
        if "root" in witness and self.facts.verdict(rules.STABILITY) is Verdict.PROVED:
            return [self._exponent(witness["length"], witness["root"])]
        statement = {"length": witness["length"], "bound": rational(upper_bound(witness))}
        uses = self._decay(finding, witness["by"])
        claim = self.claims.prove("holder-lower", statement, uses=uses)
        if "root" in witness and finding.closed is not None:
            claim = self.stencils.meets(claim, witness)
        return [claim, *([uses[0]] if len(uses) > 1 else [])]

    def _upper(self, finding: Finding) -> list[int]:
        witness, below = rules.HOLDER_UPPER.witness_of(finding), self.facts[rules.HOLDER_LOWER]
        by = witness["by"]
        if by == rules.TENSOR_PRODUCT.code:
            return self.factors.holder_upper(finding, below)
        if by == rules.BOX_SPLINE.code:
            return [self.box.holder(witness["value"])]
        by_radius = by in (rules.DIFFERENCE_RADIUS.code, rules.STENCIL_RADIUS.code)
        if by_radius and below.verdict in DECIDED and below.closed is not None and "root" in below.witness:
            return self._lower(below)[:1]
        return [self._above(finding)]

    def _above(self, finding: Finding) -> int:
        """The claim of a bound from above, by the order of the sum rules, by mean squares, or by a product."""
        witness = rules.HOLDER_UPPER.witness_of(finding)
        if witness["by"] == rules.STENCIL_RADIUS.code:
            return self.stencils.holder_upper(witness)
        statement = {"length": witness["length"], "bound": rational(witness["radius"])}
        if witness["by"] == rules.SUM_RULES.code:
            uses = [self._sum_rules(), self._stable()]
        elif witness["by"] == rules.SOBOLEV.code:
            uses = [self._mean_squares(finding, lower=False)]
        else:
            word = self._word(witness["word"], witness["radius"])
            uses = [word, self._differences(), self._sum_rules(), self._stable()]
        return self.claims.prove("holder-upper", statement, uses=uses)

    def _exponent(self, length: int, root: RootData) -> int:
        uses = [self._radius(), self._differences(), self._sum_rules(), self._stable()]
        return self.claims.prove("holder-root", {"length": length, **root_fields(root)}, uses=uses)

    def _sobolev(self, finding: Finding) -> list[int]:
        witness = rules.SOBOLEV.witness_of(finding)
        if witness["by"] == rules.TENSOR_PRODUCT.code:
            return self.factors.sobolev(witness)
        if witness["by"] == rules.BOX_SPLINE.code:
            return [self.box.sobolev(witness["value"])]
        if witness["by"] == rules.HOLDER_LOWER.code:
            return self._between(witness)
        above = [self._at_most(witness["above"])] if "above" in witness else []
        return [self._mean_squares(finding, lower=not witness["holds"]), *above]

    def _between(self, witness: MultivariateSobolevWitness) -> list[int]:
        """The claims that bound the Sobolev exponent by the Hölder exponent."""
        first = self.facts[rules.HOLDER_LOWER]
        below = (first, *first.otherwise)[witness["below"]]
        lower = rules.HOLDER_LOWER.witness_of(below)
        statement = {"length": lower["length"], "bound": rational(upper_bound(lower))}
        claim = self.claims.prove("sobolev-at-least", statement, uses=self._lower(below)[:1])
        return [claim, *([self._at_most(witness["above"])] if "above" in witness else [])]

    def _at_most(self, place: int) -> int:
        """The claim that bounds the Sobolev exponent from above by the Hölder exponent, in that place."""
        first = self.facts[rules.HOLDER_UPPER]
        above = (first, *first.otherwise)[place]
        upper = rules.HOLDER_UPPER.witness_of(above)
        length, bound = upper["length"], upper["radius"]
        if upper["by"] == rules.SUM_RULES.code:
            uses = [self._sum_rules(), self._stable()]
        else:
            length, bound, uses = 2 * length, bound**2 / self.m**length, [self._above(above)]
        statement = {"length": length, "bound": rational(bound)}
        return self.claims.prove("sobolev-at-most", statement, uses=uses)

    def _mean_squares(self, finding: Finding, *, lower: bool) -> int:
        """The claim on s by the growth of mean squares, or on its bound from below."""
        growth = proof_of(finding, GrowthProof)
        degree, k = len(growth["polynomial"]) + len(growth["cofactor"]) - 2, self._order
        size = growth["pairs"] + 4 * growth["window"]
        of_root: Json = {
            "property": "sobolev-lower" if lower else "sobolev",
            "polynomial": polynomial(0, growth["polynomial"]),
            "low": rational(growth["low"]),
            "high": rational(growth["high"]),
        }
        return self.claims.prove(
            "surface-sobolev",
            of_root,
            {"cofactor": polynomial(0, growth["cofactor"])},
            [self._sum_rules(), *([] if lower else [self._stable()])],
            self.terms**2 + k * (2 * self.s + 1) * (2 * k + 1) ** self.s + (degree + 1) * size,
        )

    def _reproduction(self, finding: Finding) -> list[int]:
        r, k = rules.REPRODUCTION.witness_of(finding)["degree"], self._order
        work = self.terms * comb(min(r + 1, k - 1) + self.s, self.s)
        return [self.claims.prove("reproduction", {"degree": r}, uses=[self._sum_rules()], work=work)]

    def _quasi_interpolation(self, finding: Finding) -> list[int]:
        witness = rules.QUASI_INTERPOLATION.witness_of(finding)
        d, operator, stencil = witness["degree"], _terms(witness["operator"]), _terms(witness["stencil"])
        n = comb(d + self.s, self.s)
        statement = {"property": "quasi-interpolation", "degree": d, "operator": operator, "stencil": stencil}
        work = (self.terms + 2 * len(stencil)) * n + n * n
        uses = [self._convergent(), self._sum_rules()]
        return [self.claims.prove("surface-quasi-interpolation", statement, uses=uses, work=work)]


def _terms(numbers: PlacedNumbers) -> list[Any]:
    """The terms of a mask as plain data: pairs of an index and a number."""
    return [[list(index), rational(x)] for index, x in numbers]
