"""The claims on box splines and on tensor products, as FORMAT.md says."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import comb, prod
from typing import NamedTuple

from subdiv_cli.certificate.claims import Claims, Json, UnwrittenError
from subdiv_cli.certificate.radius import spelled
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.witnesses import (
    BoxSplineWitness,
    MultivariateHolderLowerWitness,
    MultivariateSobolevWitness,
)
from subdiv_cli.model import Finding, Question
from subdiv_cli.model.closed import rational
from subdiv_cli.model.findings import HOLDER_LOWER, HOLDER_UPPER, SOBOLEV


class BoxSplineClaims:
    """The claims of one certificate on box splines, by the witness of SD603. Each method returns the number of one."""

    def __init__(self, claims: Claims, witness: BoxSplineWitness, terms: int) -> None:
        self._claims, self._witness, self._terms = claims, witness, terms

    @property
    def _directions(self) -> list[list[int]]:
        """The different directions, without their multiplicities."""
        return [list(xi) for xi in self._witness["directions"]]

    def spline(self) -> int:
        """The claim that φ is the box spline of these directions."""
        counts = self._witness["multiplicities"]
        directions = sorted(xi for xi, n in zip(self._directions, counts, strict=True) for _ in range(n))
        c, r, n = self._witness["scale"], self._witness["power"], len(directions)
        longest = prod((c - 1) * sum(map(abs, column)) + 1 for column in zip(*directions, strict=True))
        work = n * c * longest + r * self._terms * longest + self._breadth()
        witness = {"power": r, "shift": spelled(self._witness["shift"])}
        return self._claims.prove("box-spline", {"directions": directions, "scale": c}, witness, work=work)

    def _breadth(self) -> int:
        different, total = self._directions, sum(self._witness["multiplicities"])
        s = len(different[0])
        return comb(len(different), s - 1) * s * (24 + total)

    def _say(self, rule: str, statement: Json) -> int:
        return self._claims.prove(rule, statement, None, [self.spline()], self._breadth())

    def stable(self, statement: Json) -> int:
        """The claim on stability; the statement is that the directions are unimodular, or are not."""
        different = self._directions
        work = 24 * len(different[0]) * comb(len(different), len(different[0]))
        return self._claims.prove("box-stable", statement, None, [self.spline()], work)

    def smooth(self, n: int) -> int:
        """The claim that φ is C^n."""
        return self._say("box-smooth", {"property": "smooth", "order": n})

    def not_smooth(self, n: int) -> int:
        """The claim that φ is not C^n."""
        return self._say("box-not-smooth", {"property": "not-smooth", "order": n})

    def holder(self, value: Fraction) -> int:
        """The claim that states the Hölder exponent of φ."""
        return self._say("box-holder", {"property": "holder-value", "value": int(value)})

    def sobolev(self, value: Fraction) -> int:
        """The claim that states the Sobolev exponent of φ."""
        return self._say("box-sobolev", {"property": "sobolev-value", "value": rational(value)})


class PartCertificate(NamedTuple):
    """The certificate of a factor, with its statements by question."""

    variables: tuple[int, ...]
    document: Json
    stated: Mapping[Question, Sequence[Json]]
    """The statements that answer each question."""


class Factors:
    """The claims of one certificate that follow from its factors."""

    def __init__(self, claims: Claims, parts: Sequence[PartCertificate | None], work: int) -> None:
        self._claims, self._work = claims, work
        self._parts = [part for part in parts if part is not None]
        self._complete = len(self._parts) == len(parts)

    def product(self) -> int:
        """The mask is their product. Raises UnwrittenError where one has no certificate."""
        if not self._complete:
            raise UnwrittenError
        documents = list({json.dumps(part.document): part.document for part in self._parts}.values())
        which = [documents.index(part.document) for part in self._parts]
        work = self._work + sum(claim["work"] for document in documents for claim in document["claims"])
        statement = {"parts": [list(part.variables) for part in self._parts]}
        return self._claims.prove("tensor-product", statement, {"which": which, "certificates": documents}, work=work)

    def say(self, rule: str, statement: Json, *more: int) -> list[int]:
        """What all of them or one of them is enough for; nothing where their certificates do not say it."""
        if not self._complete:
            return []
        enough = [any(_is_enough(stated, statement) for stated in part.document["goal"]) for part in self._parts]
        if not (all(enough) if statement.get("holds", statement["property"] == "smooth") else any(enough)):
            return []
        return [self._claims.prove(f"tensor-{rule}", statement, None, [self.product(), *more], len(self._parts))]

    def holder_lower(self, witness: MultivariateHolderLowerWitness) -> list[int]:
        """The claims on the exponent, or on its bound from below, by the factor that the witness names."""
        return self._of_one("of-factor", HOLDER_LOWER, witness["variables"], witness.get("between"))

    def holder_upper(self, finding: Finding, below: Finding) -> list[int]:
        """The claims on the exponent from above: by the exponent itself, where the finding from below states it."""
        variables = rules.HOLDER_UPPER.witness_of(finding)["variables"]
        if below.closed is not None and (witness := rules.HOLDER_LOWER.witness_of(below))["variables"] == variables:
            claims = self.holder_lower(witness)
            properties = [self._claims.statement(number)["statement"]["property"] for number in claims]
            if properties and properties[0] != "holder-lower":
                return claims
        return self._of_one("at-most-factor", HOLDER_UPPER, variables)

    def sobolev(self, witness: MultivariateSobolevWitness) -> list[int]:
        """The claims on the Sobolev exponent, or on its bounds, by the factors that the witness names."""
        claims = []
        if "variables" in witness:
            claims.append(self._of_one("of-factor", SOBOLEV, witness["variables"], witness.get("between")))
        if "variables_above" in witness:
            claims.append(self._of_one("at-most-factor", SOBOLEV, witness["variables_above"]))
        return [number for each in claims for number in each] if all(claims) else []

    def _of_one(
        self, rule: str, question: Question, variables: tuple[int, ...], between: Fraction | None = None
    ) -> list[int]:
        """The claims by one factor's answer to a question; none where a certificate it needs does not state it."""
        stated = {part.variables: part.stated.get(question, ()) for part in self._parts}
        if not self._complete or not stated[variables] or (between is not None and not all(stated.values())):
            return []
        witness = {} if between is None else {"between": rational(between)}
        statement = {"variables": list(variables), "statement": stated[variables][0 if rule == "of-factor" else -1]}
        return [self._claims.prove(rule, statement, witness, [self.product()], len(self._parts))]


def _is_enough(stated: Json, statement: Json) -> bool:
    """Whether a factor's statement implies the other: the same, or more smoothness, or that there is not even less."""
    name = statement["property"]
    if stated["property"] != name:
        return False
    if "holds" in statement:
        return bool(stated["holds"] == statement["holds"] and not stated.get("mask", 0))
    return bool(stated["order"] >= statement["order"] if name == "smooth" else stated["order"] <= statement["order"])
