"""What the certificate of a mask states of its limits: the verdicts on a side rest on these statements alone."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple

from subdiv_cli.kinds.kind import Analysis
from subdiv_cli.kinds.scalar.claims import claims_of
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.kinds.scalar.stages import analyse
from subdiv_cli.model import Effort, Root


class DecayRate(NamedTuple):
    """The number x with x^length = Λ, low <= Λ <= high: an exponent is -log_p x."""

    length: int
    low: Fraction
    high: Fraction
    polynomial: tuple[int, ...] | None = None
    """The polynomial of which Λ is the only root in [low, high]; None where Λ is a bound, low = high."""

    def at_most(self, x: Fraction, length: int) -> bool:
        """Whether the number is at most x^(1/length), x >= 0."""
        return self.high**length <= x**self.length

    @property
    def root(self) -> Root:
        """The number Λ, where it is a root."""
        assert self.polynomial is not None
        return Root(self.polynomial, self.low, self.high)

    def is_same(self, other: DecayRate) -> bool:
        """Whether the numbers are one because they are rational and equal, or given in the same way."""
        if self.low == self.high and other.low == other.high:
            return self.low**other.length == other.low**self.length
        return self == other


def rational_rate(x: Fraction) -> DecayRate:
    """The decay of a rational bound."""
    return DecayRate(1, x, x)


class Side:
    """A mask on one side: its own analysis, and what its certificate states."""

    def __init__(self, mask: ScalarScheme, effort: Effort) -> None:
        self.analysis: Analysis = analyse(mask, effort)

    @cached_property
    def certificate(self) -> Mapping[str, Any] | None:
        """The certificate of the mask; None where it would have no claim."""
        written = claims_of(self.analysis).certificate()
        return None if written is None else written.document

    @property
    def _goal(self) -> Iterable[Mapping[str, Any]]:
        return () if self.certificate is None else self.certificate["goal"]

    @cached_property
    def converges(self) -> bool | None:
        """Whether the scheme of the mask converges; None where that is not stated."""
        stated = [statement["holds"] for statement in self._goal if statement["property"] == "convergent"]
        return stated[0] if stated else None

    @cached_property
    def smooth(self) -> int:
        """The largest n with C^n stated, 0 for a scheme that converges."""
        return max((s["order"] for s in self._goal if s["property"] == "smooth"), default=0)

    @cached_property
    def not_smooth(self) -> int | None:
        """The smallest n with C^n excluded; None without one."""
        return min((s["order"] for s in self._goal if s["property"] == "not-smooth"), default=None)

    @cached_property
    def exact(self) -> DecayRate | None:
        """The decay with the exponent of φ; None where it is not stated."""
        return next((decay for name, decay in self._decays if name in ("holder", "holder-root")), None)

    @cached_property
    def below(self) -> DecayRate | None:
        """A decay whose exponent bounds that of φ from below."""
        return self.exact or next((decay for name, decay in self._decays if name == "holder-lower"), None)

    @cached_property
    def above(self) -> DecayRate | None:
        """A decay whose exponent bounds that of φ from above."""
        return self.exact or next((decay for name, decay in self._decays if name == "holder-upper"), None)

    @property
    def _decays(self) -> Iterable[tuple[str, DecayRate]]:
        return ((s["property"], decay) for s in self._goal if (decay := rate_of(s)) is not None)


def rate_of(s: Mapping[str, Any]) -> DecayRate | None:
    """The decay that a statement on a Hölder exponent gives; None for another statement."""
    match s["property"]:
        case "holder" | "holder-lower":
            x = Fraction(s["norm"])
            return DecayRate(s["level"], x, x, (-x.numerator, x.denominator) if s["property"] == "holder" else None)
        case "holder-upper":
            x = Fraction(s["radius"])
            return DecayRate(s["length"], x, x)
        case "holder-root":
            return DecayRate(s["length"], Fraction(s["low"]), Fraction(s["high"]), tuple(map(int, s["polynomial"])))
    return None
