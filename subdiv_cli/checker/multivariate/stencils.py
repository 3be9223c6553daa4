"""The rules on limit stencils of masks on Z^s, the differences of φ that they give, and what follows. See FORMAT.md.

(T_ε v)(α) = Σ_β a(ε+Mα-β) v(β), m = |det M|, λ = m^(1/s). S converges and M is isotropic wherever something follows: no
rule here asks for stability. ρ is the joint spectral radius of a family that a claim `stencil-family` introduces.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import comb, gcd
from operator import mul
from typing import Any

from subdiv_cli.checker.core import Claim, Statement
from subdiv_cli.checker.multivariate.differences import difference, letters_of, positions_of, require_invariant
from subdiv_cli.checker.multivariate.lattice import Index, Sparse, add, monomials, multiply, over_one
from subdiv_cli.checker.multivariate.masks import SparseMask, mask_of
from subdiv_cli.checker.radius.families import UPPER, bound_of
from subdiv_cli.checker.reading import MAX_ENTRY, MAX_ORDER, require, require_few
from subdiv_cli.checker.roots import fraction_bits
from subdiv_cli.checker.spans import are_independent, depth_of, require_spanned, scaled

LOWER = ("radius-lower", "radius", "bounded")
_MAX_DIFFERENCES = 60
_MAX_NODES = 20_000
_MAX_PAIRS = 1_000_000
"""The most pairs of a term of the mask and an index of the window."""
_ROOT = ("length", "polynomial", "low", "high")
Generator = tuple[Sparse, int]
"""A sequence of numerators, and their denominator."""


def limit_stencil(c: Claim) -> Generator:
    """T_ε w = w and Σ w = 1: if S converges, (w * S^L δ)(i) is φ at M^-L (i + u), (M - 1) u = ε, for all L and i."""
    a, coset = mask_of(c), c.statement["coset"]
    s = a.dilation.dimension
    require(len(coset) == s and all(len(index) == s for index, _ in c.witness["terms"]), f"an index is not of Z^{s}")
    require(len(c.witness["terms"]) > 0, "the stencil is empty")
    w, denominator = over_one(c.witness["terms"])
    longest = max(map(abs, w.values())).bit_length() + denominator.bit_length()
    c.count(len(w) * (len(a.terms) + 1), a.bits + longest + len(w).bit_length())
    require(sum(w.values()) == denominator, "the sum is not 1")
    image = _images(a, {a.dilation.residue(coset): (0, coset)}, w)[0]
    require(image == {index: a.denominator * x for index, x in w.items()}, "the operator does not fix it")
    return w, denominator


def stencil_differences(c: Claim) -> None:
    """The new family is that of the T_ε on a space U of images of the ∇^μ w, |μ| = k, spanned by words on leaves.

    Words of length L applied to the ∇^μ w are, if S converges, all differences of order k of φ with the steps M^-L e_j.
    """
    a, k, witness = mask_of(c), c.statement["order"], c.witness
    w, denominator = c.use("limit-stencil").result
    s, family, leaves = a.dilation.dimension, witness["matrices"], witness["leaves"]
    require(k >= 1, "the order is not positive")
    require_few(k <= _MAX_DIFFERENCES, "the order is too large")
    count = comb(k + s - 1, s - 1)
    require_few(count * len(w) * (k + 1) ** s <= _MAX_PAIRS, "there are too many differences")
    _check_shape(a, witness)
    depth = depth_of(witness["tree"], count, a.dilation.cosets)
    n, width, t = family.order, len(witness["window"]), len(a.terms)
    given = max(map(abs, w.values())).bit_length() + denominator.bit_length() + k
    sums = max((sum(map(fraction_bits, row)) for row in leaves), default=0)
    bits = given + depth * (a.bits + t.bit_length()) + MAX_ENTRY.bit_length() + max(family.bits, sums) + n.bit_length()
    work = len(witness["tree"]) * witness["breadth"] * t + len(leaves) * n * width
    work += n * width * ((a.dilation.cosets + 1) * n + t) + sum(map(len, witness["words"])) * n * n + n**3
    c.count(work, bits)
    positions = positions_of(witness["window"], s)
    require(are_independent(witness["basis"]), "the basis is dependent modulo 2^61 - 1")
    require_invariant(a, witness["cosets"], witness["basis"], positions, family)
    _grown(a, [_lowest(multiply(difference(mu), w), denominator) for mu in monomials(s, k)], witness, positions)
    require_spanned(family, leaves, witness["words"])
    c.introduce(c.statement["family"], family)


def _check_shape(a: SparseMask, witness: dict[str, Any]) -> None:
    """Check that basis, window, matrices, leaves and tree fit each other and are not too large."""
    rows, family, tree, width = witness["basis"], witness["matrices"], witness["tree"], len(witness["window"])
    n = len(rows)
    require(n > 0, "the basis is empty")
    require_few(n <= MAX_ORDER, "the basis has too many rows")
    require(all(len(row) == width for row in rows), "a row of the basis is not as long as the window")
    require_few(width * len(a.terms) <= _MAX_PAIRS, "the window is too large for so many terms")
    fits = len(family.matrices) == a.dilation.cosets and family.order == n
    require(fits, "the matrices are not m, or of another order than the basis")
    require(all(len(row) == n for row in witness["leaves"]), "a leaf has not as many coordinates as the basis has rows")
    require(set(tree) <= {0, 1} and sum(tree) == len(witness["leaves"]), "the tree has not as many leaves")
    require_few(len(tree) <= _MAX_NODES, "the tree has too many nodes")


def _grown(a: SparseMask, generators: list[Generator], witness: dict[str, Any], positions: dict[Index, int]) -> None:
    """Check that the leaves of the tree of images of the generators have these coordinates, and none is broader."""
    letters = letters_of(a.dilation, witness["cosets"])
    columns, waiting, left = list(zip(*witness["basis"], strict=True)), list(generators), iter(witness["leaves"])
    for node, is_leaf in enumerate(witness["tree"]):
        v, denominator = waiting[node]
        require(len(v) <= witness["breadth"], f"node {node} of the tree has more indices")
        if not is_leaf:
            waiting += [_lowest(image, denominator * a.denominator) for image in _images(a, letters, v)]
            continue
        numerators, common = scaled(next(left))
        values = [0] * len(positions)
        for index, x in v.items():
            require(index in positions, f"node {node} of the tree is not 0 outside of the window")
            values[positions[index]] = x
        same = all(
            denominator * sum(map(mul, numerators, column)) == common * x
            for x, column in zip(values, columns, strict=True)
        )
        require(same, f"node {node} of the tree has other coordinates")


def _images(a: SparseMask, letters: dict[Index, tuple[int, Index]], v: Sparse) -> list[Sparse]:
    """The numerators of T_ε v over the mask's denominator for the representatives ε, by the number of each."""
    images: list[Sparse] = [{} for _ in letters]
    for beta, x in v.items():
        for gamma, numerator in a.terms.items():
            at = add(beta, gamma)
            if (letter := letters.get(a.dilation.residue(at))) is not None:
                number, epsilon = letter
                alpha = a.dilation.divided([i - j for i, j in zip(at, epsilon, strict=True)])
                images[number][alpha] = images[number].get(alpha, 0) + x * numerator
    return [{index: x for index, x in image.items() if x} for image in images]


def _lowest(v: Sparse, denominator: int) -> Generator:
    """The sequence over this denominator, both divided by what they have in common."""
    common = gcd(denominator, *v.values())
    return {index: x // common for index, x in v.items()}, denominator // common


def smooth(c: Claim) -> None:
    """φ is C^n: ρ < λ^-n for differences of φ of an order k > n."""
    n = c.statement["order"]
    used, k = _radius(c, UPPER)
    require(k > n, f"the differences are of order {k}")
    require(_scaled(c, bound_of(used), n * used["length"]) < 1, "the radius is not small enough")


def not_smooth(c: Claim) -> None:
    """φ is not C^n: ρ >= λ^-n for differences of φ of an order k > n; or k <= n and ρ > λ^-k."""
    n = c.statement["order"]
    used, k = _radius(c, LOWER)
    x = _scaled(c, _bound_below(used), min(n, k) * used["length"])
    require(x >= 1 if n < k else x > 1, "the radius is not large enough")


def holder_lower(c: Claim) -> None:
    """α >= -log_λ(x)/ℓ: ρ^ℓ <= x, λ^-kℓ <= x. Or α >= k, x = m^-k and ℓ = s: ρ is at most λ^-k."""
    used, k = _radius(c, UPPER)
    length, bound, stated = used["length"], bound_of(used), (c.statement["length"], c.statement["bound"])
    x = _scaled(c, bound, k * length)
    s, m = mask_of(c).dilation.dimension, mask_of(c).dilation.cosets
    same = stated == (length, bound) and x >= 1
    require(same or (x <= 1 and stated == (s, Fraction(1, m**k))), "the radius has another length or bound")


def holder_upper(c: Claim) -> None:
    """α <= -log_λ(y)/ℓ: ρ^ℓ >= y > λ^-kℓ."""
    used, k = _radius(c, LOWER)
    bound = _bound_below(used)
    stated = (c.statement["length"], c.statement["bound"])
    require(stated == (used["length"], bound), "the radius has another length or bound")
    require(_scaled(c, bound, k * used["length"]) > 1, f"the differences do not tell an exponent below {k}")


def holder_root(c: Claim) -> None:
    """α = -log_λ(Λ)/ℓ: ρ^ℓ = Λ > λ^-kℓ."""
    used, k = _radius(c, ("radius", "bounded"), {key: c.statement[key] for key in _ROOT})
    require(_scaled(c, used["low"], k * used["length"]) > 1, "the exponent is not seen to be below k")


def holder_meets(c: Claim) -> None:
    """α = -log_λ(Λ)/ℓ, Λ rational: it is at least that, and at most a number that is the same."""
    c.count(1)
    below, above, s = c.use("holder-lower").statement, c.use("holder-upper").statement, c.statement
    f = s["polynomial"]
    require(len(f) == 2 and Fraction(-f[0], f[1]) == s["low"] == s["high"], "the root is not a rational number")
    require((below["length"], below["bound"]) == (s["length"], s["low"]), "the bound from below is another")
    x, y = below["bound"], above["bound"]
    c.spend(1, fraction_bits(x) * above["length"] + fraction_bits(y) * below["length"])
    require(x ** above["length"] == y ** below["length"], "the bound from above is another")


def _radius(c: Claim, properties: Sequence[str], fields: dict[str, Any] | None = None) -> tuple[Statement, int]:
    """The claim used on ρ, and k; S converges and M is isotropic."""
    c.count(1)
    require(mask_of(c).dilation.is_isotropic(), "the dilation is not seen to be isotropic")
    c.use("convergent", holds=True)
    used = c.use(*properties, **(fields or {})).statement
    return used, c.use("stencil-family", family=used["family"]).statement["order"]


def _bound_below(s: Statement) -> Fraction:
    """The bound y with ρ^length >= y, of a claim that bounds a radius from below."""
    bound: Fraction = s["bound" if s["property"] == "radius-lower" else "low"]
    require(bound > 0, "the bound is not positive")
    return bound


def _scaled(c: Claim, x: Fraction, exponent: int) -> Fraction:
    """The number (x λ^exponent)^s, which is rational and compares with 1 as x λ^exponent does for x >= 0."""
    dilation = mask_of(c).dilation
    s, m = dilation.dimension, dilation.cosets
    c.spend(1, s * fraction_bits(x) + exponent * m.bit_length())
    return Fraction(x**s * m**exponent)
