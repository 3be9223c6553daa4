"""The certificate of one scalar mask: every finding that is proved or refuted becomes a claim (see FORMAT.md)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from math import lcm
from typing import Any, NamedTuple, cast

from subdiv_cli.certificate.claims import Claims, Json, mask_document, polynomial, rational
from subdiv_cli.model import Data, Finding, Verdict

Rationals = tuple[Fraction, ...]


MOST_WORK = 50_000_000
"""What the checker does for one certificate; a longer one is not written."""


class Certificate(NamedTuple):
    """A document as FORMAT.md has it, and for each finding the numbers of the claims that say the same."""

    document: Json
    claims: tuple[tuple[int, ...], ...]


def certificate(
    arity: int, start: int, coefficients: Sequence[Fraction], findings: Sequence[Finding]
) -> Certificate | None:
    """The proof of the proved and refuted findings on this mask, its goal in their order.

    A finding whose witness was too costly to compute (large Bezout cofactors) has no claims. None where the whole asks
    more of the checker than it does.
    """
    writer = _Writer(arity, len(coefficients) - 1, findings)
    decided = (Verdict.PROVED, Verdict.REFUTED)
    claims = tuple(tuple(writer.claim(finding)) if finding.verdict in decided else () for finding in findings)
    if sum(claim["work"] for claim in writer.claims.made) > MOST_WORK:
        return None
    document = {
        "format": "subdiv-certificate",
        "version": 1,
        "mask": mask_document(arity, start, coefficients),
        "goal": [writer.claims.statement(number) for number in dict.fromkeys(n for numbers in claims for n in numbers)],
        "claims": writer.claims.made,
    }
    return Certificate(document, claims)


class _Writer:
    """Turns findings into claims. `self.last` is the mask that decides smoothness: 0, or the last reduced one."""

    def __init__(self, p: int, degree: int, findings: Sequence[Finding]) -> None:
        self.p = p
        self.claims = Claims()
        self.found = {finding.code: finding for finding in findings}
        self.contractions = [f for f in findings if f.code == "SD301" and f.verdict is Verdict.PROVED]
        self.degrees = [degree]
        self.reductions: list[int] = []
        self.orders = {0: _integer(self.found["SD102"].witness.get("order", 0))}
        if (reduction := self.found.get("SD403")) is not None:
            self._reduce(reduction.witness)
        self.last = len(self.degrees) - 1

    def claim(self, finding: Finding) -> list[int]:
        """The numbers of the claims that say what the finding says; none where its witness is missing."""
        rules: dict[str, Callable[[Finding], list[int]]] = {
            "SD101": self._residue_sums,
            "SD102": lambda _: [self._sum_rules(0)],
            "SD103": self._generation,
            "SD104": self._reproduction,
            "SD105": self._derived,
            "SD201": self._convergence,
            "SD202": self._eigen_condition,
            "SD301": self._contractivity,
            "SD302": self._smoothness,
            "SD303": self._next_smoothness,
            "SD304": self._spectrum,
            "SD311": self._holder_lower,
            "SD312": self._holder_upper,
            "SD401": self._independence,
            "SD402": lambda found: self._stability(found, 0),
            "SD403": lambda _: list(self.reductions),
        }
        return rules[finding.code](finding)

    # structure and sum rules

    def _residue_sums(self, finding: Finding) -> list[int]:
        sums = [rational(s) for s in _rationals(finding.witness["sums"])]
        return [self._add("residue-sums", {"mask": 0, "sums": sums}, work=self.degrees[0] + 1)]

    def _sum_rules(self, mask: int) -> int:
        witness = self.found["SD102" if mask == 0 else "SD403"].witness
        quotient = _polynomial(witness["cofactor_start"], witness["cofactor"])
        order = self.orders[mask]
        work = (self.degrees[mask] + 1) * (order + 1) * self.p
        return self._add("sum-rules", {"mask": mask, "order": order}, {"quotient": quotient}, work=work)

    def _generation(self, finding: Finding) -> list[int]:
        return [self._add("generation", {"degree": self.orders[0] - 1}, uses=[self._sum_rules(0)])]

    def _reproduction(self, finding: Finding) -> list[int]:
        degree = _integer(finding.witness["degree"])
        work = (self.degrees[0] + 1) * (degree + 2) ** 2
        return [self._add("reproduction", {"degree": degree}, uses=[self._sum_rules(0)], work=work)]

    def _derived(self, finding: Finding) -> list[int]:
        if not self.orders[0]:
            return [self._sum_rules(0)]
        start, mask = (_tuple(finding.witness[key])[-1] for key in ("starts", "masks"))
        statement = {"mask": 0, "nu": self.orders[0], "symbol": _polynomial(start, mask)}
        work = (self.degrees[0] + 1) * (self.orders[0] + 1) * self.p
        return [self._sum_rules(0), self._add("derived", statement, uses=[self._sum_rules(0)], work=work)]

    # norms, products and spectra

    def _norm(self, mask: int, nu: int, level: int, norm: Fraction) -> int:
        p, degree = self.p, self.degrees[mask] - nu * (self.p - 1)
        size = degree * (p**level - 1) // (p - 1) + 1
        statement = {"mask": mask, "nu": nu, "level": level, "norm": rational(norm)}
        return self._add("norm", statement, uses=[self._sum_rules(mask)], work=(degree + 1) * size)

    def _product(self, mask: int, word: Sequence[int], radius: Fraction) -> int:
        degree = self.degrees[mask] - self.orders[mask] * (self.p - 1)
        order = max(1, -(-degree // (self.p - 1)))
        statement = {"mask": mask, "word": list(word), "radius": rational(radius)}
        work = len(word) * order**3 + order**4
        return self._add("product", statement, uses=[self._sum_rules(mask)], work=work)

    def _spectral(self, nu: int, holds: bool) -> int:
        order = -(-self.degrees[0] // (self.p - 1)) + 1
        statement = {"nu": nu, "holds": holds}
        return self._add("eigen-condition", statement, uses=[self._sum_rules(0)], work=self.p * order**4)

    def _eigen_condition(self, finding: Finding) -> list[int]:
        return [self._spectral(0, finding.verdict is Verdict.PROVED)]

    def _spectrum(self, finding: Finding) -> list[int]:
        largest, k = _integer(finding.witness["nu"]), self.orders[0]
        if k < 2:
            return [self._sum_rules(0)]
        following = [self._spectral(largest + 1, False)] if largest + 1 < k else []
        return [self._spectral(largest, True), *following] if largest else following

    def _contraction(self, mask: int, witness: Mapping[str, Data]) -> int:
        mu, level = _integer(witness["norm_of"]), _integer(witness["level"])
        return self._norm(mask, mu, level, _rational(witness["norm"]))

    def _obstacle(self, mask: int, order: int, witness: Mapping[str, Data]) -> int:
        """What keeps a stable φ of this mask from being C^order."""
        if "word" not in witness:
            return self._sum_rules(mask)
        word = _word(witness)
        return self._product(mask, word, Fraction(1, self.p ** (order * len(word))))

    def _contractivity(self, finding: Finding) -> list[int]:
        if finding.verdict is Verdict.PROVED:
            return [self._contraction(self.last, finding.witness)]
        return [self._obstacle(self.last, _integer(finding.witness["nu"]) - 1, finding.witness)]

    # convergence and smoothness

    def _convergence(self, finding: Finding) -> list[int]:
        if finding.verdict is Verdict.PROVED:
            return [
                self._add("converges", {"holds": True}, uses=[self._contraction(0, finding.witness)], name="convergent")
            ]
        by = finding.witness["by"]
        if by == "SD301":
            reason = self._obstacle(0, 0, finding.witness)
        else:
            (reason,) = self.claim(self.found[cast(str, by)])
        return [self._add("diverges", {"holds": False}, uses=[reason], name="convergent")]

    def _smoothness(self, finding: Finding) -> list[int]:
        if finding.verdict is Verdict.REFUTED:
            return self._not_smooth(0, finding.witness)
        order = _integer(finding.witness["order"])
        if finding.witness["by"] == "SD201":
            uses = [self._contraction(0, self.found["SD201"].witness)]
        else:
            uses = [self._contraction(self.last, self.contractions[-1].witness), *self.reductions]
        return [self._add("smooth", {"order": order}, uses=uses)]

    def _next_smoothness(self, finding: Finding) -> list[int]:
        return self._not_smooth(_integer(finding.witness["order"]), finding.witness)

    def _not_smooth(self, order: int, witness: Mapping[str, Data]) -> list[int]:
        stable = self._last_stable()
        obstacle = self._obstacle(self.last, order, witness)
        return [self._add("not-smooth", {"order": order}, uses=[n, obstacle, *self.reductions]) for n in stable]

    def _holder_lower(self, finding: Finding) -> list[int]:
        k, level = _integer(finding.witness["difference_order"]), _integer(finding.witness["level"])
        norm = _rational(finding.witness["norm"])
        uses = [self._norm(self.last, k, level, norm * self.p ** ((k - 1) * level)), self._sum_rules(self.last)]
        statement = {"level": level, "norm": rational(norm)}
        below = self._add("holder-lower", statement, uses=[*uses, *self.reductions])
        if "word" not in finding.witness:
            return [below]
        word = _word(finding.witness)
        length = lcm(len(word), level)
        above = self._above(word * (length // len(word)), norm ** (length // level))
        return [self._add("holder-exact", statement, uses=[below, n], name="holder") for n in above] or [below]

    def _holder_upper(self, finding: Finding) -> list[int]:
        if "word" in finding.witness:
            return self._above(_word(finding.witness), _rational(finding.witness["radius"]))
        k = _integer(finding.witness["difference_order"])
        statement = {"length": 1, "radius": rational(Fraction(1, self.p**k))}
        uses = [self._sum_rules(self.last), *self.reductions]
        return [self._add("holder-upper", statement, uses=[n, *uses]) for n in self._last_stable()]

    def _above(self, word: Sequence[int], radius: Fraction) -> list[int]:
        uses = [self._product(self.last, word, radius), *self.reductions]
        statement = {"length": len(word), "radius": rational(radius)}
        return [self._add("holder-upper", statement, uses=[n, *uses]) for n in self._last_stable()]

    # stability and reduction

    def _independence(self, finding: Finding) -> list[int]:
        statement, work = {"mask": 0, "holds": finding.verdict is Verdict.PROVED}, (self.degrees[0] + 1) ** 2
        if finding.verdict is Verdict.PROVED:
            return self._independent(0, self.found["SD402"].witness)
        witness: Json = {"cycle": finding.witness.get("cycle")}
        if "gcd" in finding.witness:
            witness = {"factor": _polynomial(0, finding.witness["gcd"])}
        return [self._add("dependent", statement, witness, work=work, name="independent")]

    def _independent(self, mask: int, witness: Mapping[str, Data]) -> list[int]:
        if "cofactors" not in witness or len(_tuple(witness["gcd"])) > 1:
            return []
        work = 20 * (self.degrees[mask] + 1) ** 2
        return [self._add("independent", {"mask": mask, "holds": True}, {"cofactors": _cofactors(witness)}, work=work)]

    def _stability(self, finding: Finding, mask: int) -> list[int]:
        if finding.verdict is Verdict.PROVED:
            return self._stable(mask, finding.witness)
        witness: Json = {"cycle": finding.witness.get("cycle")}
        if "circle_factor" in finding.witness:
            witness = {"factor": _polynomial(0, finding.witness["circle_factor"])}
        work = (self.degrees[mask] + 1) ** 3
        return [self._add("unstable", {"mask": mask, "holds": False}, witness, work=work, name="stable")]

    def _stable(self, mask: int, witness: Mapping[str, Data]) -> list[int]:
        if "cofactors" not in witness:
            return []
        statement, n = {"mask": mask, "holds": True}, self.degrees[mask] + 1
        if independent := self._independent(mask, witness):
            return [self._add("stable", statement, uses=independent)]
        hints = {"gcd": _polynomial(0, witness["gcd"]), "cofactors": _cofactors(witness)}
        return [self._add("stable", statement, hints, work=20 * n**2 + n**3)]

    def _last_stable(self) -> list[int]:
        if not self.last:
            return self._stable(0, self.found["SD402"].witness)
        return self._stable(self.last, cast(Mapping[str, Data], self.found["SD403"].witness["stable"]))

    def _reduce(self, witness: Mapping[str, Data]) -> None:
        steps = zip(*(_tuple(witness[key]) for key in ("factors", "starts", "masks")), strict=True)
        for number, (factor, start, mask) in enumerate(steps):
            statement = {"from": number, "to": number + 1}
            hints = {"factor": _polynomial(0, factor), "mask": _polynomial(start, mask)}
            self.reductions.append(self._add("reduction", statement, hints, work=(self.degrees[number] + 1) ** 2))
            self.degrees.append(len(_tuple(mask)) - 1)
        self.orders[len(self.degrees) - 1] = _integer(witness["order"])

    def _add(
        self,
        rule: str,
        statement: Json,
        witness: Json | None = None,
        uses: Sequence[int] = (),
        work: int = 1,
        name: str | None = None,
    ) -> int:
        """A claim by a rule; its property has the rule's name unless another is given."""
        return self.claims.add(rule, {"property": name or rule, **statement}, witness or {}, uses, work)


def _integer(x: Data) -> int:
    if not isinstance(x, int):
        raise TypeError(f"a witness has {x!r} for an integer")
    return x


def _rational(x: Data) -> Fraction:
    return x if isinstance(x, Fraction) else Fraction(_integer(x))


def _tuple(x: Data) -> tuple[Data, ...]:
    if not isinstance(x, tuple):
        raise TypeError(f"a witness has {x!r} for a tuple")
    return x


def _rationals(x: Data) -> Rationals:
    return tuple(_rational(c) for c in _tuple(x))


def _word(witness: Mapping[str, Data]) -> tuple[int, ...]:
    return tuple(_integer(letter) for letter in _tuple(witness["word"]))


def _polynomial(start: Data, coefficients: Data) -> Json:
    return polynomial(_integer(start), _rationals(coefficients))


def _cofactors(witness: Mapping[str, Data]) -> list[Any]:
    pairs = zip(_tuple(witness["starts"]), _tuple(witness["cofactors"]), strict=True)
    return [_polynomial(start, coefficients) for start, coefficients in pairs]
