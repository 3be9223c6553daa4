"""The claims on a tensor product: certificates of its factors, and what follows, as MULTIVARIATE.md says."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from subdiv_cli.certificate.claims import Claims, Json, rational
from subdiv_cli.certificate.witness import as_rational
from subdiv_cli.model import Finding


class PartCertificate(NamedTuple):
    """The certificate of a factor."""

    variables: tuple[int, ...]
    document: Json
    said: Mapping[str, Sequence[Json]]
    """The statements of each finding, by its code."""


class Factors:
    """The claims of one certificate that come of its factors. Each method returns the number of a claim."""

    def __init__(self, claims: Claims, parts: Sequence[PartCertificate], work: int) -> None:
        self._claims, self._parts, self._work = claims, parts, work

    def product(self) -> int:
        """The mask is their product."""
        documents = list({json.dumps(part.document): part.document for part in self._parts}.values())
        which = [documents.index(part.document) for part in self._parts]
        work = self._work + sum(claim["work"] for document in documents for claim in document["claims"])
        statement = {"parts": [list(part.variables) for part in self._parts]}
        return self._claims.prove("tensor-product", statement, {"which": which, "certificates": documents}, work=work)

    def say(self, rule: str, statement: Json, *more: int) -> int:
        """What all of them or one of them is enough for."""
        return self._claims.prove(f"tensor-{rule}", statement, None, [self.product(), *more], len(self._parts))

    def holder_lower(self, finding: Finding) -> int:
        """The exponent, or the bound from below, of the factor that the finding names."""
        return self._of_one("of-factor", finding, ("SD311", "SD614"))

    def holder_upper(self, finding: Finding, below: Finding) -> int:
        """By the exponent itself, where that is what the finding from below says."""
        if below.closed is not None and below.witness["variables"] == finding.witness["variables"]:
            return self.holder_lower(below)
        return self._of_one("at-most-factor", finding, ("SD312", "SD615"))

    def sobolev(self, finding: Finding) -> int:
        """As `holder_lower`."""
        return self._of_one("of-factor", finding, ("SD321", "SD617"))

    def _of_one(self, rule: str, finding: Finding, codes: Sequence[str]) -> int:
        part = next(part for part in self._parts if part.variables == finding.witness["variables"])
        said = next(part.said[code] for code in codes if code in part.said)[0]
        between = finding.witness.get("between")
        witness = {} if between is None else {"between": rational(as_rational(between))}
        statement = {"variables": list(part.variables), "statement": said}
        return self._claims.prove(rule, statement, witness, [self.product()], len(self._parts))
