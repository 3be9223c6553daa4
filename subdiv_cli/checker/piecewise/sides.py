"""The masks of both sides: each with a certificate of its own, checked by the rules of kind `scalar`."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from subdiv_cli.checker.core import Claim, Statement, read_statement
from subdiv_cli.checker.piecewise.masks import masks_of
from subdiv_cli.checker.reading import Exhausted, Rejected, require
from subdiv_cli.checker.scalar.masks import Symbols


class StatedRate(NamedTuple):
    """The number x with x^length = Λ, low <= Λ <= high; an exponent is -log_p x."""

    length: int
    low: Fraction
    high: Fraction
    polynomial: tuple[int, ...] | None = None
    """The polynomial that has Λ as its only root in [low, high]; None where Λ is a bound."""


class SideStatements(list[Statement]):
    """The statements that the certificate of a mask proves."""

    def says(self, name: str, **fields: object) -> bool:
        """Whether it has a statement of this property with these fields."""
        return any(s["property"] == name and fields.items() <= s.items() for s in self)

    @property
    def smooth(self) -> int:
        """The largest n with φ in C^n, -1 without one."""
        return max((s["order"] for s in self if s["property"] == "smooth"), default=-1)

    @property
    def not_smooth(self) -> int | None:
        """The smallest n with φ not in C^n; None without one."""
        return min((s["order"] for s in self if s["property"] == "not-smooth"), default=None)

    def exact(self) -> list[StatedRate]:
        """The decays whose exponent is that of φ."""
        results = []
        for s in self:
            if s["property"] == "holder":
                x = s["norm"]
                results.append(StatedRate(s["level"], x, x, (-x.numerator, x.denominator)))
            elif s["property"] == "holder-root":
                results.append(StatedRate(s["length"], s["low"], s["high"], s["polynomial"]))
        return results

    def below(self) -> list[StatedRate]:
        """The decays whose exponents bound that of φ from below."""
        bounds = [s for s in self if s["property"] == "holder-lower"]
        return self.exact() + [StatedRate(s["level"], s["norm"], s["norm"]) for s in bounds]

    def above(self) -> list[StatedRate]:
        """The decays whose exponents bound that of φ from above."""
        bounds = [s for s in self if s["property"] == "holder-upper"]
        return self.exact() + [StatedRate(s["length"], s["radius"], s["radius"]) for s in bounds]


def side(c: Claim) -> SideStatements:
    """The certificate verifies, and is about the mask of this side: what it proves is true of that mask.

    Raises Rejected otherwise.
    """
    document, masks, name = c.witness["certificate"], masks_of(c), c.statement["side"]
    c.count(_stated_work(document))
    outcome, rulebook, subject = c.check_inside(document)
    if subject is None or rulebook is None or not outcome.verified:
        raise (Exhausted if outcome.exhausted else Rejected)(f"the certificate: {outcome.line}"[:300])
    if not isinstance(subject.about, Symbols):
        raise Rejected("the certificate is about no scalar mask")
    require(subject.letters == masks.arity, "the mask of the certificate has another arity")
    own = masks.left if name == "left" else masks.right
    require(subject.about[0] == own, "the mask of the certificate is another")
    return SideStatements(read_statement(statement, rulebook) for statement in outcome.statements)


def _stated_work(document: object) -> int:
    """The work that all claims of a certificate state, whether it is one or not."""
    claims = document.get("claims") if type(document) is dict else None
    if type(claims) is not list or any(type(claim) is not dict for claim in claims):
        raise Rejected("the certificate is none")
    works = [claim.get("work") for claim in claims]
    require(all(type(work) is int and work >= 0 for work in works), "the certificate has a claim without its work")
    return sum(works)
