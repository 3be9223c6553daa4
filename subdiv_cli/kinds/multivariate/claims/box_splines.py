"""The claims on a box spline, which its directions decide, as FORMAT.md says."""

from __future__ import annotations

from fractions import Fraction
from math import comb, prod
from typing import cast

from subdiv_cli.certificate.claims import Claims, Json
from subdiv_cli.certificate.radius import spelled
from subdiv_cli.certificate.witness import as_integer, as_tuple
from subdiv_cli.model import Data, Finding
from subdiv_cli.model.closed import rational


class BoxSplineClaims:
    """Those of one certificate, by its finding SD603. Each method returns the number of a claim."""

    def __init__(self, claims: Claims, finding: Finding | None, terms: int) -> None:
        self._claims, self._finding, self._terms = claims, finding, terms

    def _found(self, key: str) -> Data:
        assert self._finding is not None
        return self._finding.witness[key]

    @property
    def _directions(self) -> list[list[int]]:
        """Different ones."""
        return [list(cast("tuple[int, ...]", xi)) for xi in as_tuple(self._found("directions"))]

    def spline(self) -> int:
        """φ is the box spline of these directions."""
        counts = [as_integer(n) for n in as_tuple(self._found("multiplicities"))]
        directions = sorted(xi for xi, n in zip(self._directions, counts, strict=True) for _ in range(n))
        c, r, n = as_integer(self._found("scale")), as_integer(self._found("power")), len(directions)
        longest = prod((c - 1) * sum(map(abs, column)) + 1 for column in zip(*directions, strict=True))
        work = n * c * longest + r * self._terms * longest + self._breadth()
        witness = {"power": r, "shift": spelled(self._found("shift"))}
        return self._claims.prove("box-spline", {"directions": directions, "scale": c}, witness, work=work)

    def _breadth(self) -> int:
        different, total = self._directions, sum(as_integer(n) for n in as_tuple(self._found("multiplicities")))
        s = len(different[0])
        return comb(len(different), s - 1) * s * (24 + total)

    def _say(self, rule: str, statement: Json) -> int:
        return self._claims.prove(rule, statement, None, [self.spline()], self._breadth())

    def stable(self, statement: Json) -> int:
        """The statement says whether the directions are unimodular."""
        different = self._directions
        work = 24 * len(different[0]) * comb(len(different), len(different[0]))
        return self._claims.prove("box-stable", statement, None, [self.spline()], work)

    def smooth(self, n: int) -> int:
        """φ is C^n."""
        return self._say("box-smooth", {"property": "smooth", "order": n})

    def not_smooth(self, n: int) -> int:
        """It is not."""
        return self._say("box-not-smooth", {"property": "not-smooth", "order": n})

    def holder(self, value: Fraction) -> int:
        """Its Hölder exponent."""
        return self._say("box-holder", {"property": "holder-value", "value": int(value)})

    def sobolev(self, value: Fraction) -> int:
        """Its Sobolev exponent."""
        return self._say("box-sobolev", {"property": "sobolev-value", "value": rational(value)})
