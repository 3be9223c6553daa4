"""Convergence and C^1 by directional factors or by signs of a mask on Z^s, dilation cI; divergence by its places.

See FORMAT.md. Dyn 1992: 6.50 to 6.53 for one factor, Corollary 7.9 for pairs, Theorem 6.4 for positive masks.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, zip_longest
from math import prod
from operator import mul

from subdiv_cli.checker.core import Claim, Statement
from subdiv_cli.checker.multivariate.lattice import Index, Sparse, determinant, geometric, multiply, over_one
from subdiv_cli.checker.multivariate.masks import mask_of
from subdiv_cli.checker.polynomials import iterated_magnitudes, polynomial, slot_bits
from subdiv_cli.checker.reading import require, require_few
from subdiv_cli.checker.roots import fraction_bits
from subdiv_cli.checker.scalar.symbols import MAX_LEVEL, MAX_PACKED, MAX_PRODUCT


def directional_norm(c: Claim) -> None:
    """‖S_d^L‖∞ = x with a(z) = d(z) (1 + z^θ + … + z^((c-1)θ)), by coset sums mod c^L of Π_(i<L) d(z^(c^i)).

    The norm is the largest absolute one. ∇_θ S f = S_d ∇_θ f, because (1 - z^θ) a(z) = d(z) (1 - z^(cθ)).
    """
    quotient_norm(c, (c.statement["direction"],))


def quotient_norm(c: Claim, directions: Sequence[Index]) -> None:
    """‖S_(c^(n-1) d)^L‖∞ is as stated for the mask a(z) = d(z) Π (1 + z^θ + … + z^((c-1)θ)) over n directions θ."""
    a, level, n = mask_of(c), c.statement["level"], len(directions)
    s, factor = a.dilation.dimension, a.dilation.factor
    d, denominator = over_one(c.witness["quotient"])
    require(factor > 1, "the dilation is not a multiple of the identity")
    require(all(len(x) == s and any(x) for x in directions), f"the direction is zero or not one of Z^{s}")
    require(all(len(x) == s for x in d), f"an index of the quotient is not one of Z^{s}")
    require(1 <= level <= MAX_LEVEL, f"the level is not one of 1, …, {MAX_LEVEL}")
    bits = max(map(abs, d.values())).bit_length() + denominator.bit_length()
    c.count(len(d) * sum(factor**i for i in range(1, n + 1)), a.bits + bits)
    product = d
    for theta in directions:
        product = multiply(product, geometric(theta, factor))
    same = product.keys() == a.terms.keys()
    same = same and all(a.denominator * value == denominator * a.terms[x] for x, value in product.items())
    require(same, "the quotient times its directional factors is not the mask")
    largest = factor ** ((n - 1) * level) * largest_class_sum(c, d, factor, level)
    x = c.statement["norm"]
    require(x.numerator * denominator**level == largest * x.denominator, "the norm is another")


def largest_class_sum(c: Claim, d: Sparse, p: int, level: int) -> int:
    """The largest class sum max_γ Σ_β |F_(γ + p^L β)| for F(z) = Π_(i<L) d(z^(p^i)), numerators only.

    An index becomes one integer, its coordinates the digits: the last one counts for 1, those before for the products
    of the widths of the ones after, which the whole F needs. So F becomes a polynomial in one variable.
    """
    low = [min(column) for column in zip(*d, strict=True)]
    spans = [max(column) - least for column, least in zip(zip(*d, strict=True), low, strict=True)]
    widths = [span * (p**level - 1) // (p - 1) + 1 for span in spans]
    length = prod(widths)
    c.count(len(d) * (p + length), 0)
    require_few(length <= MAX_PRODUCT, "the iterated symbol is too long")
    flat: dict[int, int] = {}
    for x, value in d.items():
        position = 0
        for i, least, width in zip(x, low, widths, strict=True):
            position = position * width + i - least
        flat[position] = value
    symbol = polynomial(0, [flat.get(i, 0) for i in range(max(flat) + 1)], 1)
    width = slot_bits(symbol, level)
    c.spend(len(d) * length // 64, width)
    require_few(length * width <= MAX_PACKED, "the numbers are too long")
    before = [0] * (symbol.start * (p**level - 1) // (p - 1))
    return _largest_sum(before + iterated_magnitudes(symbol, p, level), widths, p**level)


def _largest_sum(magnitudes: list[int], widths: list[int], modulus: int) -> int:
    """The largest sum over the indices of a class; magnitudes in lexicographic order, but for zeros at the end."""
    width = widths[-1]
    rows: dict[tuple[int, ...], list[list[int]]] = {}
    for number, first in enumerate(range(0, len(magnitudes), width)):
        key = _residues(number, widths[:-1], modulus)
        rows.setdefault(key, []).append(magnitudes[first : first + width])
    totals = [list(map(sum, zip_longest(*same, fillvalue=0))) for same in rows.values()]
    return max(sum(total[i::modulus]) for total in totals for i in range(min(modulus, len(total))))


def _residues(number: int, widths: list[int], modulus: int) -> tuple[int, ...]:
    digits = []
    for width in reversed(widths):
        number, digit = divmod(number, width)
        digits.append(digit % modulus)
    return tuple(digits)


def directional_converges(c: Claim) -> None:
    """S converges: all ∇_θ S^k f decay for s directions that are a basis of Z^s, and the coset sums are 1."""
    require(all(used["norm"] < 1 for used in _single(c)), "a norm is not below 1")


def pair_norm(c: Claim) -> None:
    """‖S_(cd)^L‖∞ = x with a(z) = d(z) G_θ(z) G_η(z), G_θ(z) = 1 + z^θ + … + z^((c-1)θ): ∇_θ ∇_η S = S_d ∇_θ ∇_η."""
    directions = c.statement["directions"]
    require(len(directions) == 2, "there are not two directions")
    quotient_norm(c, directions)


def directional_smooth(c: Claim) -> None:
    """φ is C^1: all pairs of s+1 directions, any s of determinant ±1, all factors of the mask; norms below 1."""
    require(c.statement["order"] <= 1, "nothing is said of second derivatives")
    require(all(used["norm"] < 1 for used in _pairs(c)), "a norm is not below 1")


def directional_decay(c: Claim) -> None:
    """ρ_k^L <= x, k = 1 by ‖S_d^l‖∞ for s directions that are a basis of Z^s: ρ_1^l is at most the largest of them.

    For k = 2 by the pairs of `directional_smooth`: ρ_2^l is at most the largest ‖S_(cd)^l‖∞ / c^l.
    """
    order, level, x = (c.statement[key] for key in ("order", "level", "norm"))
    factor = mask_of(c).dilation.factor
    require(order in (1, 2), "the order is not 1 or 2")
    require(1 <= level <= MAX_LEVEL, f"the level is not one of 1, …, {MAX_LEVEL}")
    require(x > 0, "the bound is not positive")
    for used in _single(c) if order == 1 else _pairs(c):
        own, norm = used["level"], used["norm"] / factor ** ((order - 1) * used["level"])
        c.spend(1, own * fraction_bits(x) + level * fraction_bits(norm))
        require(norm**level <= x**own, "a norm is not small enough")


def _single(c: Claim) -> list[Statement]:
    """The norms in s directions that are a basis of Z^s; the coset sums are 1."""
    c.count(1)
    s = mask_of(c).dilation.dimension
    c.use("coset-sums", holds=True)
    norms = [c.use("directional-norm").statement for _ in range(s)]
    require(abs(determinant([used["direction"] for used in norms])) == 1, "the directions are not a basis of Z^s")
    return norms


def _pairs(c: Claim) -> list[Statement]:
    """The norms of all pairs of s+1 directions, any s of them a basis of Z^s; the coset sums are 1."""
    s = mask_of(c).dilation.dimension
    c.use("coset-sums", holds=True)
    norms = [c.use("pair-norm").statement for _ in range(s * (s + 1) // 2)]
    pairs = [used["directions"] for used in norms]
    directions = sorted({x for pair in pairs for x in pair})
    require(sorted(map(sorted, pairs)) == [list(x) for x in combinations(directions, 2)], "they are not all pairs")
    require(len(directions) == s + 1, f"there are not {s + 1} directions")
    c.count((s + 1) * 24)
    require(all(abs(determinant(some)) == 1 for some in combinations(directions, s)), "some are not a basis of Z^s")
    return norms


def positive_converges(c: Claim) -> None:
    """S converges: coset sums 1, and the indices with a_α ≠ 0 are a box with all sides >= c, a_α > 0 there."""
    a = mask_of(c)
    c.count(len(a.terms) * a.dilation.dimension)
    c.use("coset-sums", holds=True)
    factor = a.dilation.factor
    require(factor > 1, "the dilation is not a multiple of the identity")
    sides = [max(column) - min(column) for column in zip(*a.terms, strict=True)]
    require(min(sides) >= factor, f"a side of the box is shorter than {factor}")
    require(len(a.terms) == prod(side + 1 for side in sides), "the support is not a whole box")
    require(min(a.terms.values()) > 0, "a coefficient is negative")


def sublattice_diverges(c: Claim) -> None:
    """S diverges: for all α, β with a_α and a_β ≠ 0, u·M^j(α-β) = 0 modulo n for j < s, and u ≠ 0 modulo n.

    So the smallest lattice Γ with MΓ ⊂ Γ that holds the α - β is not Z^s (Cayley & Hamilton: j < s is enough), and
    S^L δ is zero outside of one coset of Γ. See FORMAT.md.
    """
    a = mask_of(c)
    s, u, n = a.dilation.dimension, c.witness["functional"], c.witness["modulus"]
    c.count(len(a.terms) * s**2)
    require(len(u) == s, f"the functional is not one on Z^{s}")
    require(n > 1 and any(x % n for x in u), "the functional is zero modulo n")
    for _ in range(s):
        values = {sum(map(mul, u, alpha)) % n for alpha in a.terms}
        require(len(values) == 1, "the functional does not vanish on the differences")
        u = [sum(x * row[i] for x, row in zip(u, a.dilation.rows, strict=True)) % n for i in range(s)]
