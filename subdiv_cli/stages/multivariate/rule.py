"""What these stages share: their type, and exponents to the base λ = |det M|^(1/s)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import gcd

from flint import fmpq_mat, fmpq_poly

from subdiv_cli.exact.algebraic import isolated, number_of, roots
from subdiv_cli.exact.closed import exponent
from subdiv_cli.model import ClosedForm, Data, Finding, Root, unpowered
from subdiv_cli.quantities.multivariate import MultivariateNumbers

Facts = Mapping[str, tuple[Finding, ...]]
Stage = Callable[[MultivariateNumbers, Facts], tuple[Finding, ...]]

ANISOTROPIC = "smoothness is decided for isotropic dilations only"


def spanning(count: int) -> str:
    """Of the directions of a box spline: so many may go, whichever they are."""
    return f"its directions span without any {'one' if count == 1 else count} of them"


def not_spanning(count: int) -> str:
    """Of the directions of a box spline: so many are too many."""
    return f"its directions do not span without some {'one' if count == 1 else count} of them"


def surface_exponent(m: int, s: int, length: int, root: Root) -> ClosedForm | None:
    """-log_λ(Λ)/length with λ^s = m: -log_m(Λ^s)/length, the power as small as the number m allows.

    None where the minimal polynomial of the power is not found.
    """
    base, divisor = unpowered(m, length)
    common = gcd(s, divisor)
    power = _power(root, s // common)
    return None if power is None else exponent(base, divisor // common, power)


def _power(root: Root, n: int) -> Root | None:
    """Λ^n: a root of the characteristic polynomial of the n-th power of a companion matrix."""
    if n == 1:
        return root
    if root.low == root.high:
        x = root.low**n
        return Root((-x.numerator, x.denominator), x, x)
    f = fmpq_poly(list(root.coefficients))
    d = f.degree()
    companion = fmpq_mat(d, d, [int(i == j + 1) if j < d - 1 else -f[i] / f[d] for i in range(d) for j in range(d)])
    target = number_of(root).enclosure().real ** n
    near = [number for number, _ in roots((companion**n).charpoly()) if number.region.overlaps(target)]
    return isolated(near[0]) if len(near) == 1 and near[0].is_real else None


def growth_proof(numbers: MultivariateNumbers) -> dict[str, Data]:
    """What certificates need to show of the growth Λ of mean squares, where that is known."""
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


def verdict_of(facts: Facts, code: str) -> Finding | None:
    """The only finding with this code."""
    found = facts.get(code, ())
    return found[0] if found else None
