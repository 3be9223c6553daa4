"""Wording that these stages share: on box splines, and exponents to the base λ = |det M|^(1/s)."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import gcd
from typing import cast

from subdiv_cli.certificate.witness import as_integer, as_rational, as_tuple
from subdiv_cli.exact.algebraic import isolated, number_of, power
from subdiv_cli.exact.closed import exponent
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.model import ClosedForm, Data, Finding, Root, unpowered

ANISOTROPIC = "smoothness is decided for isotropic dilations only"


def spanning(count: int) -> str:
    """The words on so many directions of a box spline that may go, whichever they are."""
    return f"its directions span without any {'one' if count == 1 else count} of them"


def not_spanning(count: int) -> str:
    """The words on so many directions of a box spline that are too many."""
    return f"its directions do not span without some {'one' if count == 1 else count} of them"


def multivariate_exponent(m: int, s: int, length: int, root: Root) -> ClosedForm | None:
    """The exponent -log_λ(Λ)/length with λ^s = m: -log_m(Λ^s)/length, the power as small as the number m allows.

    None where the minimal polynomial of the power is too large.
    """
    base, divisor = unpowered(m, length)
    common = gcd(s, divisor)
    if s == common:
        return exponent(base, divisor // common, root)
    raised = power(number_of(root), s // common)
    return None if raised is None else exponent(base, divisor // common, isolated(raised))


def below_bound(finding: Finding) -> Fraction:
    """The bound x of a finding α >= -log_λ(x)/length, or of one that has the number itself."""
    root = cast("Mapping[str, Data] | None", finding.witness.get("root"))
    return as_rational(finding.witness["bound"] if root is None else root["high"])


def largest_norm(finding: Finding, factor: int) -> tuple[int, Fraction]:
    """The pair (L, x) of a finding on directional norms with the largest x^(1/L), each x over factor^L."""
    levels, norms = (as_tuple(finding.witness[key]) for key in ("levels", "norms"))
    pairs = [(as_integer(n), as_rational(x) / factor ** as_integer(n)) for n, x in zip(levels, norms, strict=True)]
    level, largest = pairs[0]
    for n, x in pairs[1:]:
        if x**level > largest**n:
            level, largest = n, x
    return level, largest


def growth_proof(numbers: MultivariateNumbers) -> dict[str, Data]:
    """The numbers by which certificates show the growth Λ of mean squares, where that is known."""
    found = numbers.mean_squares
    assert found is not None
    assert found.growth is not None
    growth = found.growth
    return {
        "polynomial": tuple(int(c) for c in growth.radius.minimal_polynomial),
        "low": growth.low,
        "high": growth.high,
        "cofactor": growth.cofactor_coefficients(),
        "window": found.window,
        "pairs": found.pairs,
    }
