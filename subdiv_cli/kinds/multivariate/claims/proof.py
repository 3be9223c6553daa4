"""The certificate of a mask in several variables, as FORMAT.md says."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from math import comb
from typing import Any, cast

from subdiv_cli.certificate.claims import Claims, Json, Proofs, UnwrittenError, proofs
from subdiv_cli.certificate.radius import Radii, root_fields, spelled
from subdiv_cli.certificate.witness import as_integer, as_polynomial, as_rational, as_tuple, as_word
from subdiv_cli.kinds.kind import Analysis, Facts, Part
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.claims.norms import directional_norms, gram_sequence, matrix_norm, pair_norms
from subdiv_cli.kinds.multivariate.claims.products import BoxSplineClaims, Factors, PartCertificate
from subdiv_cli.kinds.multivariate.stages.wording import below_bound, largest_norm
from subdiv_cli.kinds.multivariate.text.writing import canonical
from subdiv_cli.kinds.scalar.claims import claims_of as univariate_claims
from subdiv_cli.model import Data, Finding, Verdict, exact_root
from subdiv_cli.model.closed import rational

Map = Mapping[str, Data]


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
        self.found = Facts(findings)
        self.s = len(mask["dilation"])
        self.terms = len(mask["terms"])
        self.m = len(as_tuple(self.found[rules.COSET_SUMS].witness["cosets"]))
        self.factors = Factors(self.claims, parts, self.terms * (self.s + 1))
        self.box = BoxSplineClaims(self.claims, self.found.find(rules.BOX_SPLINE), self.terms)
        self._families: list[None] = []
        self._family: int | None = None
        self._radius_claim: int | None = None

    def claims_of(self, finding: Finding) -> list[int]:
        """The claims that state a decided finding; none where the certificate of a factor leaves it out."""
        if finding.witness.get("by") == rules.TENSOR_PRODUCT.code:
            return self._of_factors(finding)
        makers: dict[str, Callable[[Finding], list[int]]] = {
            rules.COSET_SUMS.code: lambda _: [self._coset_sums()],
            rules.SUM_RULES.code: self._sum_rules_and_generation,
            rules.BOX_SPLINE.code: lambda _: [self.box.spline()],
            rules.SUBLATTICE.code: lambda _: [self._sublattice()],
            rules.DIRECTIONAL_NORMS.code: self._norms,
            rules.DIFFERENCE_RADIUS.code: lambda _: [self._radius(), self._differences()],
            rules.MATRIX_NORMS.code: lambda _: [self._matrix_norm()],
            rules.DIRECTIONAL_SMOOTHNESS.code: lambda _: [self._pairs()],
            rules.POSITIVE_MASK.code: lambda _: [self._positive()],
            rules.TENSOR_PRODUCT.code: lambda _: [self.factors.product()],
            rules.CONVERGENCE.code: lambda found: [self._convergent(found)],
            rules.SMOOTHNESS.code: lambda found: [self._smooth(found)],
            rules.NEXT_SMOOTHNESS.code: lambda found: [self._not_smooth(found)],
            rules.HOLDER_LOWER.code: self._lower,
            rules.HOLDER_UPPER.code: self._upper,
            rules.STABILITY.code: lambda _: [self._stable()],
            rules.SOBOLEV.code: self._sobolev,
            rules.REPRODUCTION.code: lambda found: [self._reproduction(found)],
            rules.QUASI_INTERPOLATION.code: lambda found: [self._quasi_interpolation(found)],
        }
        return makers[finding.code](finding)

    def _of_factors(self, finding: Finding) -> list[int]:
        """The claims of a finding on a tensor product that follow from its factors."""
        code, holds = finding.code, finding.verdict is Verdict.PROVED
        if code in (rules.SMOOTHNESS.code, rules.NEXT_SMOOTHNESS.code):
            smooth = code == rules.SMOOTHNESS.code and holds
            statement = {"property": "smooth" if smooth else "not-smooth", "order": finding.witness["order"]}
            return self.factors.say("smooth" if smooth else "not-smooth", statement)
        if code == rules.HOLDER_LOWER.code:
            return self.factors.holder_lower(finding)
        if code == rules.HOLDER_UPPER.code:
            return self.factors.holder_upper(finding, self.found[rules.HOLDER_LOWER])
        if code == rules.SOBOLEV.code:
            return self.factors.sobolev(finding)
        statement = {"property": "stable", "holds": holds}
        return (
            [self._convergent()]
            if code == rules.CONVERGENCE.code
            else self.factors.say("stable", statement, self._convergent())
        )

    def _coset_sums(self) -> int:
        holds = self.found[rules.COSET_SUMS].verdict is Verdict.PROVED
        return self.claims.prove("coset-sums", {"holds": holds}, work=self.terms + self.m)

    def _sum_rules(self) -> int:
        k = as_integer(self.found[rules.SUM_RULES].witness["order"])
        return self.claims.prove("total-sum-rules", {"order": k}, work=(self.terms + self.m) * comb(k + self.s, self.s))

    def _sum_rules_and_generation(self, finding: Finding) -> list[int]:
        k, rules = as_integer(finding.witness["order"]), self._sum_rules()
        return [rules, self.claims.prove("generation", {"degree": k - 1}, uses=[rules])] if k else [rules]

    def _norms(self, finding: Finding) -> list[int]:
        return directional_norms(self.claims, finding, self._factor())

    def _matrix_norm(self) -> int:
        return matrix_norm(self.claims, self.found[rules.MATRIX_NORMS], self._sum_rules())

    def _pairs(self, order: int = 1) -> int:
        uses = [self._coset_sums(), *pair_norms(self.claims, self.found[rules.DIRECTIONAL_SMOOTHNESS], self._factor())]
        return self.claims.prove("directional-smooth", {"property": "smooth", "order": order}, {}, uses, self._basis)

    @property
    def _basis(self) -> int:
        """The work to see that directions are bases of Z^s."""
        return 24 * (self.s + 1)

    def _directional_decay(self, by: Data) -> int:
        """The claim on the decay of differences by directional factors, one at a time or in pairs."""
        order = 2 if by == rules.DIRECTIONAL_SMOOTHNESS.code else 1
        finding = self.found[rules.DIRECTIONAL_SMOOTHNESS if order == 2 else rules.DIRECTIONAL_NORMS]
        level, bound = largest_norm(finding, self._factor() ** (order - 1))
        norms = pair_norms if order == 2 else directional_norms
        uses = [self._coset_sums(), *norms(self.claims, finding, self._factor())]
        statement = {"order": order, "level": level, "norm": rational(bound)}
        return self.claims.prove("directional-decay", statement, {}, uses, self._basis)

    def _sublattice(self) -> int:
        found = self.found[rules.SUBLATTICE].witness
        witness = {key: spelled(found[key]) for key in ("functional", "modulus")}
        statement = {"property": "convergent", "holds": False}
        return self.claims.prove("sublattice-diverges", statement, witness, work=self.terms * self.s**2)

    def _positive(self) -> int:
        uses, work = [self._coset_sums()], self.terms * self.s
        return self.claims.prove("positive-converges", {"property": "convergent", "holds": True}, uses=uses, work=work)

    def _factor(self) -> int:
        """The factor c of a dilation c I."""
        c = exact_root(self.m, self.s)
        assert c is not None
        return c

    def _differences(self) -> int:
        """The claim that introduces the transition operators on V_k."""
        space = cast(Map, self.found[rules.DIFFERENCE_RADIUS].proof["space"])
        if self._family is None:
            k, n, w = as_integer(space["order"]), len(as_tuple(space["basis"])), len(as_tuple(space["window"]))
            s, m = self.s, self.m
            work = n * w * ((m + 1) * n + self.terms + comb(k + s, s) + comb(k + s - 1, s - 1))
            self._families.append(None)
            witness = {key: spelled(space[key]) for key in ("cosets", "window", "basis")}
            witness |= {key: _rationals(space[key]) for key in ("matrices", "generators")}
            statement = {"property": "family", "family": 0, "order": k}
            self._family = self.claims.prove("differences", statement, witness, [self._sum_rules()], work)
        return self._family

    def _radius(self) -> int:
        """The claim on ρ_k, the joint spectral radius on V_k: from above, or the number itself."""
        if self._radius_claim is None:
            proof = self.found[rules.DIFFERENCE_RADIUS].proof
            self._differences()
            order = len(as_tuple(cast(Map, proof["space"])["basis"]))
            self._radius_claim = Radii(self.claims, self._families, self.m, []).claim(
                cast(Map, proof["radius"]), 0, order
            )
        return self._radius_claim

    def _word(self, word: Sequence[int], bound: Fraction) -> int:
        self._differences()
        order = len(as_tuple(cast(Map, self.found[rules.DIFFERENCE_RADIUS].proof["space"])["basis"]))
        statement = {"property": "radius-lower", "family": 0, "length": len(word), "bound": rational(bound)}
        return self.claims.prove("word", statement, {"word": list(word)}, work=len(word) * order**3 + order**4)

    def _convergent(self, finding: Finding | None = None) -> int:
        """The claim on convergence, by the first finding unless another one is given."""
        found = finding or self.found[rules.CONVERGENCE]
        holds, by = found.verdict is Verdict.PROVED, found.witness["by"]
        if by == rules.POSITIVE_MASK.code:
            return self._positive()
        if by == rules.SUBLATTICE.code:
            return self._sublattice()
        rule, uses = "converges" if holds else "diverges", [self._coset_sums()]
        if by == rules.DIRECTIONAL_NORMS.code:
            rule, uses = (
                "directional-converges",
                [self._coset_sums(), *self._norms(self.found[rules.DIRECTIONAL_NORMS])],
            )
        elif by == rules.TENSOR_PRODUCT.code:
            said = self.factors.say("converges", {"property": "convergent", "holds": holds})
            if not said:
                raise UnwrittenError
            return said[0]
        elif by == rules.BOX_SPLINE.code:
            uses = [self.box.not_smooth(0)]
        elif by in (rules.MATRIX_NORMS.code, rules.SOBOLEV.code, rules.DIRECTIONAL_SMOOTHNESS.code):
            uses = self._decay(found)
        elif by == rules.DIFFERENCE_RADIUS.code:
            word = () if holds else as_word(found.witness)
            uses = [self._radius() if holds else self._word(word, Fraction(1)), self._differences()]
        return self.claims.prove(rule, {"property": "convergent", "holds": holds}, uses=uses)

    def _stable(self) -> int:
        found = self.found[rules.STABILITY]
        statement = {"property": "stable", "holds": found.verdict is Verdict.PROVED}
        if found.witness["by"] == rules.BOX_SPLINE.code:
            return self.box.stable(statement)
        if found.proof:
            return gram_sequence(self.claims, found, statement, self._convergent(), self.terms)
        return self.claims.prove("interpolatory-stable", statement, uses=[self._convergent()], work=self.terms)

    def _smooth(self, finding: Finding) -> int:
        if finding.verdict is Verdict.REFUTED:
            return self._not_smooth(finding)
        n = as_integer(finding.witness["order"])
        if finding.witness["by"] == rules.BOX_SPLINE.code:
            return self.box.smooth(n)
        if finding.witness["by"] == rules.DIRECTIONAL_SMOOTHNESS.code:
            return self._pairs(n)
        return self.claims.prove("smooth", {"order": n}, uses=self._decay(finding))

    def _decay(self, finding: Finding) -> list[int]:
        """The claims that bound ρ_k from above: by the radius of a family, by norms, or by mean squares."""
        by = finding.witness["by"]
        if by == rules.CONVERGENCE.code:
            return [self._convergent()]
        if by == rules.SOBOLEV.code:
            return [self._mean_squares(finding, lower=True)]
        if by == rules.MATRIX_NORMS.code:
            return [self._matrix_norm()]
        if by in (rules.DIRECTIONAL_NORMS.code, rules.DIRECTIONAL_SMOOTHNESS.code):
            return [self._directional_decay(by)]
        return [self._radius(), self._differences()]

    def _not_smooth(self, finding: Finding) -> int:
        n, by = as_integer(finding.witness["order"]), finding.witness["by"]
        statement: Json = {"property": "not-smooth", "order": n}
        if by == rules.BOX_SPLINE.code:
            return self.box.not_smooth(n)
        if by == rules.SUM_RULES.code:
            return self.claims.prove("not-smooth", statement, uses=[self._stable(), self._sum_rules()])
        if by == rules.SOBOLEV.code:
            return self.claims.prove("not-smooth", statement, uses=[self._mean_squares(finding, lower=False)])
        below = self._reaching(n)
        return self.claims.prove("not-smooth", statement, uses=[self._stable(), below, self._differences()])

    def _reaching(self, n: int) -> int:
        """The claim ρ_k >= λ^-n: by the number itself where that is known and large enough, else by a product."""
        found = self.found[rules.DIFFERENCE_RADIUS].witness
        root = cast("Map | None", found.get("root"))
        if root is not None and as_rational(root["low"]) ** self.s * self.m ** (n * as_integer(found["length"])) >= 1:
            return self._radius()
        word = as_word(found)
        return self._word(word * self.s, Fraction(1, self.m ** (n * len(word))))

    def _lower(self, finding: Finding) -> list[int]:
        found = finding.witness
        if found["by"] == rules.BOX_SPLINE.code:
            return [self.box.holder(as_rational(found["value"]))]
        root = cast("Map | None", found.get("root"))
        if root is not None and self.found[rules.STABILITY].verdict is Verdict.PROVED:
            return [self._exponent(finding, root)]
        statement = {"length": found["length"], "bound": rational(below_bound(finding))}
        uses = self._decay(finding)
        return [self.claims.prove("holder-lower", statement, uses=uses), *([uses[0]] if len(uses) > 1 else [])]

    def _upper(self, finding: Finding) -> list[int]:
        found = finding.witness
        if found["by"] == rules.BOX_SPLINE.code:
            return [self.box.holder(as_rational(found["value"]))]
        below = self.found[rules.HOLDER_LOWER]
        root = cast("Map | None", below.witness.get("root"))
        if root is not None and found["by"] == rules.DIFFERENCE_RADIUS.code:
            return [self._exponent(below, root)]
        return [self._above(finding)]

    def _above(self, finding: Finding) -> int:
        """The claim of a bound from above, by the order of the sum rules, by mean squares, or by a product."""
        found = finding.witness
        bound = as_rational(found["radius"])
        statement = {"length": found["length"], "bound": rational(bound)}
        if found["by"] == rules.SUM_RULES.code:
            uses = [self._sum_rules(), self._stable()]
        elif found["by"] == rules.SOBOLEV.code:
            uses = [self._mean_squares(finding, lower=False)]
        else:
            below = self._word(as_word(found), bound)
            uses = [below, self._differences(), self._sum_rules(), self._stable()]
        return self.claims.prove("holder-upper", statement, uses=uses)

    def _exponent(self, finding: Finding, root: Map) -> int:
        statement = {"length": finding.witness["length"], **root_fields(root)}
        uses = [self._radius(), self._differences(), self._sum_rules(), self._stable()]
        return self.claims.prove("holder-root", statement, uses=uses)

    def _sobolev(self, finding: Finding) -> list[int]:
        found = finding.witness
        if found["by"] == rules.BOX_SPLINE.code:
            return [self.box.sobolev(as_rational(found["value"]))]
        if found["by"] == rules.HOLDER_LOWER.code:
            return self._between(finding)
        return [self._mean_squares(finding, lower=not found["holds"])]

    def _between(self, finding: Finding) -> list[int]:
        """The claims that bound the Sobolev exponent by the Hölder exponent."""
        found, lower = finding.witness, self.found[rules.HOLDER_LOWER]
        at = found["below"]
        below = (lower, *lower.otherwise)[as_integer(at)]
        statement = {"length": below.witness["length"], "bound": rational(below_bound(below))}
        claims = [self.claims.prove("sobolev-at-least", statement, uses=self._lower(below)[:1])]
        if "above" not in found:
            return claims
        upper = self.found[rules.HOLDER_UPPER]
        above = (upper, *upper.otherwise)[as_integer(found["above"])]
        length, bound = as_integer(above.witness["length"]), as_rational(above.witness["radius"])
        uses = [self._above(above)]
        if above.witness["by"] == rules.SUM_RULES.code:
            uses = [self._sum_rules(), self._stable()]
        else:
            length, bound = 2 * length, bound**2 / self.m**length
        statement = {"length": length, "bound": rational(bound)}
        return [*claims, self.claims.prove("sobolev-at-most", statement, uses=uses)]

    def _mean_squares(self, finding: Finding, *, lower: bool) -> int:
        """The claim on s by the growth of mean squares, or on its bound from below."""
        found = finding.proof
        f, cofactor = as_tuple(found["polynomial"]), as_tuple(found["cofactor"])
        degree, k = len(f) + len(cofactor) - 2, as_integer(self.found[rules.SUM_RULES].witness["order"])
        size = as_integer(found["pairs"]) + 4 * as_integer(found["window"])
        of_root: Json = {
            "property": "sobolev-lower" if lower else "sobolev",
            "polynomial": as_polynomial(0, f),
            "low": rational(as_rational(found["low"])),
            "high": rational(as_rational(found["high"])),
        }
        return self.claims.prove(
            "surface-sobolev",
            of_root,
            {"cofactor": as_polynomial(0, cofactor)},
            [self._sum_rules(), *([] if lower else [self._stable()])],
            self.terms**2 + k * (2 * self.s + 1) * (2 * k + 1) ** self.s + (degree + 1) * size,
        )

    def _reproduction(self, finding: Finding) -> int:
        r, k = as_integer(finding.witness["degree"]), as_integer(self.found[rules.SUM_RULES].witness["order"])
        work = self.terms * comb(min(r + 1, k - 1) + self.s, self.s)
        return self.claims.prove("reproduction", {"degree": r}, uses=[self._sum_rules()], work=work)

    def _quasi_interpolation(self, finding: Finding) -> int:
        found, d = finding.witness, as_integer(finding.witness["degree"])
        n = comb(d + self.s, self.s)
        statement: Json = {"property": "quasi-interpolation", "degree": d}
        statement |= {key: _terms(found[key]) for key in ("operator", "stencil")}
        work = (self.terms + 2 * len(as_tuple(found["stencil"]))) * n + n * n
        uses = [self._convergent(), self._sum_rules()]
        return self.claims.prove("surface-quasi-interpolation", statement, uses=uses, work=work)


def _terms(data: Data) -> list[Any]:
    """The terms of a mask as plain data: pairs of an index and a number."""
    return [[spelled(as_tuple(pair)[0]), rational(as_rational(as_tuple(pair)[1]))] for pair in as_tuple(data)]


def _rationals(data: Data) -> Any:
    """Nested tuples of numbers, each as `p/q`, integers too."""
    return [_rationals(x) for x in data] if isinstance(data, tuple) else rational(as_rational(data))
