"""A mask as certificates embed it: every number exact, in one spelling, so that two masks are the same iff equal."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from subdiv_cli.schemes.scalar import ScalarScheme


def canonical(scheme: ScalarScheme) -> Mapping[str, Any]:
    """As FORMAT.md says under `mask`. Raises ValueError for a number of more than 4300 digits."""
    return {
        "kind": "scalar",
        "arity": scheme.arity,
        "start": scheme.start,
        "coefficients": [_rational(c) for c in scheme.coefficients],
    }


def _rational(x: Fraction) -> str:
    return f"{x.numerator}/{x.denominator}" if x.denominator > 1 else str(x.numerator)
