"""The certificate of a piecewise scheme, as FORMAT.md says."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from fractions import Fraction

from subdiv_cli.certificate.claims import Claims, Json, Proofs, UnwrittenError, proofs
from subdiv_cli.certificate.radius import root_fields
from subdiv_cli.kinds.kind import Analysis, Facts
from subdiv_cli.kinds.piecewise import rules
from subdiv_cli.kinds.piecewise.numbers.piecewise import FunctionalGrowth, PiecewiseNumbers
from subdiv_cli.kinds.piecewise.text import canonical
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.model.closed import rational, rationals


def claims_of(analysis: Analysis) -> Proofs:
    """The claims that prove what was found of a piecewise scheme, with certificates of both masks inside."""
    proof = _PiecewiseProof(analysis.numbers, analysis.findings)
    return proofs(proof.claims, dict(canonical(analysis.scheme)), analysis.findings, proof.claims_of)


class _PiecewiseProof:
    """A certificate under construction. Each method returns the number of a claim, or the numbers of several."""

    def __init__(self, numbers: PiecewiseNumbers, findings: Sequence[Finding]) -> None:
        self.claims = Claims()
        self.numbers, self.facts = numbers, Facts(findings)
        self._families = 0
        self._growths: dict[tuple[int, str, str], list[int]] = {}

    def claims_of(self, finding: Finding) -> list[int]:
        """The claims that state a decided finding."""
        makers: dict[str, Callable[[Finding], list[int]]] = {
            rules.SIDE.code: lambda each: [self._side(rules.SIDE.witness_of(each)["side"])],
            rules.LOCAL_SPECTRUM.code: lambda _: [self._local_spectrum()],
            rules.CONVERGENCE.code: lambda _: [self._convergent()],
            rules.GENERATION.code: lambda _: [self._generation()],
            rules.VALUE_AT_ZERO.code: lambda _: [self._value()],
            rules.AT_ZERO.code: lambda _: self._at_zero(),
            rules.SMOOTHNESS.code: lambda _: [self._smooth()],
            rules.NEXT_SMOOTHNESS.code: lambda _: [self._not_smooth()],
            rules.HOLDER_LOWER.code: lambda _: [self._lower()],
            rules.HOLDER_UPPER.code: lambda _: [self._upper()],
        }
        return makers[finding.code](finding)

    def _side(self, name: str) -> int:
        """The claim that the certificate of a mask verifies. Raises UnwrittenError where it has none."""
        certificate = dict(self.numbers.sides)[name].certificate
        if certificate is None:
            raise UnwrittenError
        work = sum(claim["work"] for claim in certificate["claims"])
        return self.claims.prove("side", {"side": name}, {"certificate": dict(certificate)}, work=work)

    @property
    def _sides(self) -> list[int]:
        return [self._side("left"), self._side("right")]

    def _work(self, k: int) -> int:
        """What the spaces of order k take."""
        assert self.numbers.window is not None
        p, size = self.numbers.p, len(self.numbers.window) + k
        widths = [(each.high - each.low + 1 + k, len(each.numbers)) for each in self.numbers.cells]
        rows = sum(count * width for width, count in widths)
        return sum(p * width**3 for width, _ in widths) + (rows + 3 * size) * size**2

    def _local_spectrum(self) -> int:
        witness = self.facts.witness(rules.LOCAL_SPECTRUM)
        statement: Json = {
            "points": list(witness["points"]),
            "factors": [[rational(Fraction(x)) for x in f] for f in witness["factors"]],
        }
        return self.claims.prove("local-spectrum", statement, work=self._work(0))

    def _convergent(self) -> int:
        witness = self.facts.witness(rules.CONVERGENCE)
        masks = (self.numbers.scheme.left, self.numbers.scheme.right)
        if self.facts.verdict(rules.CONVERGENCE) is Verdict.PROVED:
            decay = self.numbers.decay
            assert decay is not None
            uses = [*self._sides, *self._bound(decay, "upper")]
            work = len(self.numbers.scheme.special) + sum(mask.degree + 1 for mask in masks)
            statement = {"property": "convergent", "holds": True}
            return self.claims.prove("converges", statement, uses=uses, work=work)
        statement = {"property": "convergent", "holds": False}
        if witness["by"] == "row":
            work = 1 + sum(len(row) for _, row in self.numbers.scheme.special)
            return self.claims.prove("row-diverges", statement, {"row": witness["row"]}, work=work)
        if witness["by"] == "side":
            return self.claims.prove("side-diverges", statement, uses=[self._side(witness["side"])])
        decay = self.numbers.decay
        assert decay is not None
        return self.claims.prove("expands", statement, uses=self._bound(decay, "lower", Fraction(1)))

    def _bound(self, growth: FunctionalGrowth, end: str, at: Fraction | None = None) -> list[int]:
        """The claims that bound a spectral radius from above or below, as rules use them.

        Where the radius is not known exactly, from below by the number given.
        """
        key = growth.order, end, str(at)
        if key not in self._growths:
            self._growths[key] = self._bounds(growth, end, at)
        return self._growths[key]

    def _bounds(self, growth: FunctionalGrowth, end: str, at: Fraction | None) -> list[int]:
        k, spectrum = growth.order, growth.spectrum
        uses = [self._convergent()] if k else []
        if spectrum is None:
            return [self.claims.prove("vanishing", {"order": k}, None, uses, self._work(k))]
        family = self._family(k, uses)
        number = self.claims.statement(family)["family"]
        order = growth.dimension
        if (exact := spectrum.exact) is not None and (at is None or exact.root.low >= at**exact.length):
            factors = [[rational(Fraction(x)) for x in f] for f, n in spectrum.factors for _ in range(n)]
            root = {"polynomial": exact.root.coefficients, "low": exact.root.low, "high": exact.root.high}
            statement = {"property": "radius", "family": number, "length": exact.length, **root_fields(root)}  # type: ignore[arg-type]
            witness = {"factors": factors, "inner": rational(exact.inner)}
            return [self.claims.prove("eigenvalues", statement, witness, work=order**4), family]
        low, high = spectrum.enclosure
        statement = {"family": number, "length": 1}
        if end == "upper":
            statement |= {"property": "radius-upper", "bound": rational(high)}
            return [self.claims.prove("inside", statement, work=order**4), family]
        statement |= {"property": "radius-lower", "bound": rational(low if at is None else at)}
        return [self.claims.prove("word", statement, {"word": [0]}, work=order**3 + order**4), family]

    def _family(self, k: int, uses: Sequence[int]) -> int:
        """The claim that introduces A on the space of order k."""
        key = k, "family", json.dumps(list(uses))
        if key not in self._growths:
            statement = {"property": "family", "family": self._families, "order": k}
            self._families += 1
            self._growths[key] = [self.claims.prove("functionals", statement, None, uses, self._work(k))]
        return self._growths[key][0]

    def _generation(self) -> int:
        degree = self.facts.witness(rules.GENERATION)["degree"]
        return self.claims.prove("generation", {"degree": degree}, work=(degree + 2) * self._work(degree))

    def _value(self) -> int:
        witness = self.facts.witness(rules.VALUE_AT_ZERO)
        statement: Json = {"start": witness["start"], "weights": rationals(witness["weights"])}
        return self.claims.prove("value-at-zero", statement, None, [self._convergent()], self._work(0))

    def _at_zero(self) -> list[int]:
        witness, growth, uses = self.facts.witness(rules.AT_ZERO), self.numbers.growth, [self._convergent()]
        if growth.spectrum is None:
            return [self.claims.prove("zero-polynomial", {}, uses=[*uses, *self._bound(growth, "upper")])]
        if "root" in witness:
            statement: Json = {"length": witness["length"], **root_fields(witness["root"])}
            return [self.claims.prove("zero-root", statement, uses=[*uses, *self._bound(growth, "upper")])]
        bound: Json = {"length": witness["length"], "bound": rational(witness["bound"])}
        made = [self.claims.prove("zero-lower", bound, uses=[*uses, *self._bound(growth, "upper")])]
        if "below" in witness:
            statement = {"property": "zero-upper", "length": 1, "bound": rational(witness["below"])}
            made.append(self.claims.prove("zero-above", statement, uses=[*uses, *self._bound(growth, "lower")]))
        return made

    def _smooth(self) -> int:
        n, uses = self.facts.witness(rules.SMOOTHNESS)["order"], [self._convergent()]
        statement = {"property": "smooth", "order": n}
        if not n:
            return self.claims.prove("continuous", statement, uses=uses)
        uses += [*self._sides, *self._bound(self.numbers.growth, "upper")]
        return self.claims.prove("smooth", statement, uses=uses)

    def _not_smooth(self) -> int:
        witness, uses, growth = self.facts.witness(rules.NEXT_SMOOTHNESS), [self._convergent()], self.numbers.growth
        n, by = witness["order"], witness["by"]
        statement = {"property": "not-smooth", "order": n}
        if by != "zero":
            return self.claims.prove("side-not-smooth", statement, uses=[*uses, self._side(by)])
        at = Fraction(1, self.numbers.p**n) if n < growth.order else None
        return self.claims.prove("zero-not-smooth", statement, uses=[*uses, *self._bound(growth, "lower", at)])

    def _lower(self) -> int:
        witness = self.facts.witness(rules.HOLDER_LOWER)
        uses = [self._convergent(), *self._sides, *self._bound(self.numbers.growth, "upper")]
        if "root" in witness:
            statement: Json = {"length": witness["length"], **root_fields(witness["root"])}
            return self.claims.prove("holder-root", statement, {"by": witness["by"]}, uses)
        bound: Json = {"length": witness["length"], "bound": rational(witness["bound"])}
        return self.claims.prove("holder-lower", bound, uses=uses)

    def _upper(self) -> int:
        witness, by = self.facts.witness(rules.HOLDER_UPPER), self.facts.witness(rules.HOLDER_UPPER)["by"]
        if "root" in witness:
            return self._lower()
        bound: Json = {"property": "holder-upper", "length": witness["length"], "bound": rational(witness["bound"])}
        uses = [self._convergent()]
        if by != "zero":
            return self.claims.prove("side-above", bound, uses=[*uses, self._side(by)])
        return self.claims.prove("zero-above", bound, uses=[*uses, *self._bound(self.numbers.growth, "lower")])
