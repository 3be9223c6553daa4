"""What a mask file says of its mask, as data: what the forms of every kind can do."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from math import lcm
from typing import Any, Protocol

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_BITS, MAX_DIGITS
from subdiv_cli.maskfile.evaluate import is_fixed
from subdiv_cli.maskfile.expressions import Expression
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.problems import Collector, Fault


class Body(Protocol):
    """What [mask] says, not yet at values of the parameters."""

    def expressions(self) -> Iterable[Expression]:
        """All in it, for what can be evaluated without parameters and for the names that stand in it."""

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> Any | None:
        """The scheme at these values of the parameters; None where something is wrong, which is recorded."""


def check_fixed_mask(body: Body, problems: Collector) -> None:
    """Records what is wrong with the scheme of a mask that does not hang on parameters."""
    if all(is_fixed(entry.node) for entry in body.expressions()):
        body.scheme({}, problems, Work())


def zero_mask(values: Mapping[str, Fraction]) -> Fault:
    """The fault of a mask whose coefficients are all zero at these values of the parameters."""
    help = "at least one coefficient must not be zero" + ("; try other parameters" if values else "")
    return Fault(faults.ZERO_MASK, "all coefficients of the mask are zero", help)


def too_precise(coefficients: Iterable[Fraction]) -> Fault | None:
    """The fault of coefficients with a common denominator that is too long; None where it is not."""
    common = 1
    for c in coefficients:
        common = lcm(common, c.denominator)
        if common.bit_length() > MAX_BITS:
            message = f"the coefficients' common denominator has more than {MAX_DIGITS} digits"
            return Fault(faults.OUT_OF_BOUNDS, message, "use fractions with smaller denominators")
    return None
