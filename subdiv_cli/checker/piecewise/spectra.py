"""The eigenvalues of one matrix: rules on its spectral radius that compute its characteristic polynomial."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import reduce
from math import gcd

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import RationalFamily, roots_lie_inside
from subdiv_cli.checker.piecewise.masks import masks_of
from subdiv_cli.checker.piecewise.spaces import Window
from subdiv_cli.checker.reading import require, require_few
from subdiv_cli.checker.roots import fraction_bits, isolated_root

Integers = Sequence[int]


def polynomial_of(c: Claim, family: RationalFamily) -> list[int]:
    """The characteristic polynomial of the matrix, a multiple of it with integers without common factor, z left out."""
    require(len(family.matrices) == 1, "the family has not one matrix")
    order = family.order
    c.count(order**4, (order + 1) * (family.bits + order.bit_length()))
    f = matrices.characteristic_polynomial(family.matrices[0])
    scaled = [x * family.denominator**i for i, x in enumerate(f)]
    while scaled and not scaled[0]:
        scaled.pop(0)
    return _primitive(scaled)


def _primitive(f: Integers) -> list[int]:
    common = gcd(*f) * (1 if f[-1] > 0 else -1)
    return [x // common for x in f]


def _product(factors: Sequence[Integers]) -> list[int]:
    def times(f: Integers, g: Integers) -> list[int]:
        total = [0] * (len(f) + len(g) - 1)
        for i, x in enumerate(f):
            for j, y in enumerate(g):
                total[i + j] += x * y
        return total

    return _primitive(reduce(times, factors, [1]))


def _require_factors(f: Integers, factors: Sequence[Integers]) -> None:
    require(all(len(g) >= 2 and g[-1] != 0 for g in factors), "a factor is constant, or has no leading coefficient")
    require(sum(len(g) - 1 for g in factors) == len(f) - 1, "the factors are of another degree")
    require(_product(factors) == f, "the product of the factors is not the characteristic polynomial")


def eigenvalues(c: Claim) -> None:
    """ρ^ℓ = Λ for the spectral radius ρ of one matrix, from factors of its characteristic polynomial.

    A factor whose roots have one modulus by its coefficients, of degree 1, or of degree 2 with complex roots or roots
    ± r, has |λ|^ℓ = Λ; or, for ℓ = 1, it is the polynomial of Λ, or that of -Λ, and all of its roots but one lie in
    |z| < r, where r^ℓ < Λ. All roots of the others lie in |z| < r, and one factor is not of those.
    """
    factors, r, length = c.witness["factors"], c.witness["inner"], c.statement["length"]
    f = polynomial_of(c, c.family())
    _require_factors(f, factors)
    root = isolated_root(c)
    bits = sum(max(map(abs, g)).bit_length() for g in factors)
    c.spend(sum(len(g) ** 2 for g in factors), (len(f) + 1) * (bits + fraction_bits(r)))
    require(r >= 0 and r**length < root.low, "the inner radius is not below the root")
    reached, mirrored = False, [x * (-1) ** i for i, x in enumerate(root.polynomial)]
    own = (_primitive(root.polynomial), _primitive(mirrored))
    for number, g in enumerate(factors):
        square = _square(g)
        if square is not None and root.rational is not None and square**length == root.rational**2:
            reached = True
        elif root.rational is None and length == 1 and _primitive(g) in own:
            require(_roots_inside(g, r) == len(g) - 2, f"factor {number} has not one root outside the inner radius")
            reached = True
        else:
            require(roots_lie_inside(g, r), f"factor {number} has a root that is not inside the inner radius")
    require(reached, "no factor has roots of this modulus")


def _square(g: Integers) -> Fraction | None:
    """The number |λ|² of all roots, where the coefficients say that they have one modulus; None elsewhere."""
    if len(g) == 2:
        return Fraction(g[0], g[1]) ** 2
    if len(g) == 3 and (g[1] == 0 or g[1] ** 2 < 4 * g[0] * g[2]):
        return Fraction(abs(g[0]), abs(g[2]))
    return None


def _roots_inside(f: Integers, radius: Fraction) -> int:
    """The number of zeros of f in |z| < radius (Schur & Cohn). Raises Rejected where a step does not tell.

    For g(z) = f(radius z) of degree n with its reverse g*: where |g_0| < |g_n|, g has as many zeros inside as
    g_n g - g_0 g* = z h, one more than h; where |g_0| > |g_n|, as many as g_0 g - g_n g*, of lower degree (Rouché).
    """
    u, v, n, inside = radius.numerator, radius.denominator, len(f) - 1, 0
    g = [c * u**i * v ** (n - i) for i, c in enumerate(f)]
    while len(g) > 1:
        low, top = g[0], g[-1]
        require(abs(low) != abs(top), "the inner radius does not tell how many roots lie inside")
        if abs(low) < abs(top):
            inside += 1
            g = [top * x - low * y for x, y in zip(g[1:], g[-2::-1], strict=True)]
        else:
            g = [low * x - top * y for x, y in zip(g, g[::-1], strict=True)]
            while len(g) > 1 and not g[-1]:
                g.pop()
        common = gcd(*g)
        g = [x // common for x in g]
    return inside


def inside(c: Claim) -> None:
    """ρ < x for the spectral radius of one matrix: all roots of its characteristic polynomial lie in |z| < x."""
    bound = c.statement["bound"]
    require(c.statement["length"] == 1 and bound > 0, "the length is not 1, or the bound is not positive")
    f = polynomial_of(c, c.family())
    c.spend(len(f) ** 2, len(f) * fraction_bits(bound))
    require(roots_lie_inside(f, bound), "an eigenvalue is not smaller")


def local_spectrum(c: Claim) -> None:
    """The eigenvalues of A but 0 are the roots of the factors; all points come from the stated ones in the long run."""
    window, factors = Window(masks_of(c)), c.statement["factors"]
    c.count(window.work(0), window.bits(0))
    require(window.attractor() == c.statement["points"], "the closed set is another")
    basis = window.all_rows()
    require_few(len(basis) <= 120, "there are too many eigenvalues")
    if not basis:
        require(not factors, "all eigenvalues are 0")
        return
    family = window.family(basis)
    order = family.order
    c.spend(order**4, (order + 1) * (family.bits + order.bit_length()))
    f = matrices.characteristic_polynomial(family.matrices[0])
    _require_factors(_primitive([x * family.denominator**i for i, x in enumerate(f)]), factors)
