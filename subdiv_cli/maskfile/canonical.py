"""A mask as certificates embed it: every number exact, in one spelling, so that two masks are the same iff equal."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from subdiv_cli.kinds.scalar.scheme import ScalarScheme

if TYPE_CHECKING:
    from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme


def canonical(scheme: ScalarScheme | MultivariateScheme) -> Mapping[str, Any]:
    """As FORMAT.md says under `mask`. Raises ValueError for a number of more than 4300 digits."""
    if not isinstance(scheme, ScalarScheme):
        return {
            "kind": "multivariate",
            "dilation": [list(row) for row in scheme.dilation],
            "terms": [[list(index), _rational(value)] for index, value in scheme.terms.items()],
        }
    return {
        "kind": "scalar",
        "arity": scheme.arity,
        "start": scheme.start,
        "coefficients": [_rational(c) for c in scheme.coefficients],
    }


def _rational(x: Fraction) -> str:
    return f"{x.numerator}/{x.denominator}" if x.denominator > 1 else str(x.numerator)
