"""Wording that these stages share: on box splines, and exponents to the base λ = |det M|^(1/s)."""

from __future__ import annotations

from fractions import Fraction
from math import gcd

from subdiv_cli.exact.algebraic import isolated, number_of, power
from subdiv_cli.exact.closed import closed_interval, exponent
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.witnesses import (
    DirectionalNormsWitness,
    DirectionalSmoothnessWitness,
    GrowthProof,
)
from subdiv_cli.model import ClosedForm, Root, exact_root, logarithm, unpowered

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


def largest_norm(witness: DirectionalNormsWitness | DirectionalSmoothnessWitness, factor: int) -> tuple[int, Fraction]:
    """The pair (L, x) of directional norms with the largest x^(1/L), each x over factor^L."""
    pairs = [(n, x / factor**n) for n, x in zip(witness["levels"], witness["norms"], strict=True)]
    level, largest = pairs[0]
    for n, x in pairs[1:]:
        if x**level > largest**n:
            level, largest = n, x
    return level, largest


def growth_proof(numbers: MultivariateNumbers) -> GrowthProof:
    """The numbers by which certificates show the growth Λ of mean squares, where that is known."""
    means = numbers.mean_squares
    assert means is not None
    assert means.growth is not None
    growth = means.growth
    return {
        "polynomial": tuple(int(c) for c in growth.radius.minimal_polynomial),
        "low": growth.low,
        "high": growth.high,
        "cofactor": growth.cofactor_coefficients(),
        "window": means.window,
        "pairs": means.pairs,
    }


def threshold(numbers: MultivariateNumbers, n: int) -> str:
    """The power λ^-n in words: `1`, `λ^-2, λ = 3`, `λ^-1, λ = √2`."""
    if n == 0:
        return "1"
    m, s = numbers.lattice.index, numbers.dimension
    root = exact_root(m, s)
    return f"λ^-{n}, " + (f"λ = {root}" if root is not None else f"λ = √{m}" if s == 2 else f"λ^{s} = {m}")


def exponent_above(m: int, s: int, length: int, bound: Fraction) -> float:
    """The exponent -log_λ(bound)/length, rounded up."""
    base, divisor = unpowered(m, length)
    upper = closed_interval(logarithm(base, (1 / bound) ** s, divisor)).upper
    assert upper is not None
    return upper
