"""Ties of a closed polytope: images that are combinations of vertices exactly, by numbers in Q[Λ].

These numbers are polynomials in Λ with the constant first; what m divides is zero, m(Λ) = 0.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import lcm
from typing import Any

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import RationalFamily
from subdiv_cli.checker.polynomials import remainder
from subdiv_cli.checker.radius.eigenvectors import Vector, common_denominator, nonzero_coordinates
from subdiv_cli.checker.radius.vertices import Tree
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.roots import Enclosure, RealRoot, fraction_bits

Element = Sequence[Fraction]
Smaller = Callable[[dict[str, Any], Sequence[tuple[Fraction, Fraction]], int], bool]
"""A function that decides whether a coordinate of a tie's image is certainly at most that of the combination.

The weights of the combination are enclosed.
"""


def ties_work(c: Claim, family: RationalFamily, root: RealRoot, tree: Tree) -> int:
    """The work n d N², and for each tie N g (g + its weights), g = d + the span of 0 and its e_k + the longest weight.

    With σ besides d² for every product: ℓ, and (1 + its weights) (the span of its e_k) for each tie.
    """
    d, order, sigma = len(root.polynomial) - 1, family.order, "sigma" in c.witness
    work = len(tree.parents) * d * order**2 if c.witness["ties"] else 0
    work += c.statement["length"] * d**2 if sigma else 0
    for tie in c.witness["ties"]:
        exponents, shares = [0, *_exponents(c, tree, tie)], tie["weights"]
        steps = max(exponents) - min(exponents)
        span = d + steps + max((len(share["weight"]) for share in shares), default=0)
        work += order * span * (span + len(shares)) + ((1 + len(shares)) * steps * d**2 if sigma else 0)
    return work


def _exponents(c: Claim, tree: Tree, tie: dict[str, Any]) -> list[int]:
    """The exponents e_k with M_i X_u = Σ c_k Λ^(e_k) X_k where v = X/σ^depth.

    They satisfy depth(u) + 1 - depth(k) = ℓ e_k; with σ for Λ where that is given, and then 1 for ℓ.
    """
    n, exponents = len(tree.parents), []
    length = 1 if "sigma" in c.witness else c.statement["length"]
    require(tie["vertex"] < n, "a tie is of a vertex that is not there")
    require(tree.depths[tie["vertex"]] >= 0, "a tie is of an extra vertex")
    for share in tie["weights"]:
        require(share["vertex"] < (2 * n if c.witness["symmetry"] else n), "a tie is with a vertex that is not there")
        depth = tree.depths[share["vertex"] % n]
        require(depth >= 0, "a tie is with an extra vertex")
        exponent, rest = divmod(tree.depths[tie["vertex"]] + 1 - depth, length)
        require(rest == 0, "a tie has depths that do not differ by a multiple of ℓ")
        exponents.append(exponent)
    return exponents


class ExactTies:
    """The ties of a polytope, checked for polynomials in Λ modulo its m."""

    def __init__(
        self, c: Claim, family: RationalFamily, root: RealRoot, tree: Tree, leaders: list[Vector], at: Enclosure
    ) -> None:
        self._c, self._family, self._tree, self._at, self._m = c, family, tree, at, root.polynomial
        self._exact = _exact(c, family, tree, leaders)
        self._sigma: Element | None = c.witness.get("sigma")
        if self._sigma is not None:
            self._check_sigma(self._sigma, c.statement["length"])

    def _check_sigma(self, sigma: Element, length: int) -> None:
        require(0 < len(sigma) < len(self._m), "σ is no polynomial of a degree below that of m")
        self._spend_powers(length)
        difference = list(power(sigma, length, self._m)) + [Fraction(0)] * 2
        difference[1] -= 1
        require(is_zero(difference, self._m), "the power of σ is not Λ")
        require(self._bounds(sigma)[0] > 0, "σ may be negative")

    def _spend_powers(self, n: int) -> None:
        bits = element_bits(self._sigma or ()) + len(self._m) * max(map(abs, self._m)).bit_length()
        self._c.spend(n * len(self._m) ** 2, n * bits)

    def _bounds(self, x: Element) -> tuple[Fraction, Fraction]:
        self._c.spend(4 * len(x), len(x) * self._at.scale.bit_length() + element_bits(x))
        return bounds(x, self._at)

    def check(self, tie: dict[str, Any], smaller: Smaller | None) -> None:
        """Check that M_i v_u / σ = Σ c_k v_k and Σ |c_k| <= 1.

        With `smaller` c_k >= 0, and the image may be smaller in a coordinate.
        """
        weights = [share["weight"] for share in tie["weights"]]
        ranges = [self._bounds(weight) for weight in weights]
        self._check_sum(weights, ranges)
        unequal = nonzero_coordinates(self._terms(tie, weights), self._m)
        where = f"vertex {tie['vertex']} by letter {tie['letter']}"
        if smaller is None:
            require(not unequal, f"the tie of {where} does not hold")
            return
        require(all(low >= 0 for low, _ in ranges), "a weight of a tie may be negative")
        require(all(smaller(tie, ranges, i) for i in unequal), f"the tie of {where} does not hold")

    def _check_sum(self, weights: Sequence[Element], ranges: Sequence[tuple[Fraction, Fraction]]) -> None:
        """Check that Σ |c_k| - 1 is zero at Λ, or enclosed below."""
        require(all(low >= 0 or high <= 0 for low, high in ranges), "a weight of a tie may have both signs")
        excess = [Fraction(-1)] + [Fraction(0)] * (max(map(len, weights), default=1) - 1)
        for weight, (low, _) in zip(weights, ranges, strict=True):
            for k, x in enumerate(weight):
                excess[k] += x if low >= 0 else -x
        self._c.spend(len(excess) * len(self._m), element_bits(excess))
        few = is_zero(excess, self._m) or self._bounds(excess)[1] <= 0
        require(few, "the weights of a tie are more than 1")

    def _terms(self, tie: dict[str, Any], weights: Sequence[Element]) -> list[tuple[Element, Vector]]:
        """The terms of both sides times a power of Λ, or of σ, where some e_k < 0; the left one with a minus."""
        c, n = self._c, len(self._tree.parents)
        exponents = _exponents(c, self._tree, tie)
        shift = -min([0, *exponents])
        image = self._exact[tie["vertex"]].image(self._family.matrices[tie["letter"]], self._family.denominator)
        terms = [(times([Fraction(-1)], self._power(shift)), image)]
        for share, weight, exponent in zip(tie["weights"], weights, exponents, strict=True):
            k = share["vertex"]
            x = self._exact[k] if k < n else self._exact[k - n].reflected()
            terms.append((times(weight, self._power(exponent + shift)), x))
        c.spend(sum(len(cs) for cs, _ in terms), sum(element_bits(cs) + x.bits for cs, x in terms))
        bits = common_denominator(terms).bit_length() + max(longest_numerator(cs) + x.bits for cs, x in terms)
        longest = max(len(cs) for cs, _ in terms)
        lead = longest * max(map(abs, self._m)).bit_length()
        c.spend(self._family.order * len(self._m) * (sum(len(cs) for cs, _ in terms) + longest), bits + lead)
        return terms

    def _power(self, exponent: int) -> Element:
        if self._sigma is None:
            return [Fraction(0)] * exponent + [Fraction(1)]
        self._spend_powers(exponent)
        return power(self._sigma, exponent, self._m)


def _exact(c: Claim, family: RationalFamily, tree: Tree, leaders: list[Vector]) -> dict[int, Vector]:
    """The exact vectors X_u of the vertices in ties and those they come from, X a leader or M_letter X_parent."""
    n, needed = len(tree.parents), set()
    for tie in c.witness["ties"]:
        needed |= {tie["vertex"], *(share["vertex"] % n for share in tie["weights"])}
    for u in range(n - 1, -1, -1):
        if u in needed and tree.parents[u] >= 0:
            needed.add(tree.parents[u])
    exact: dict[int, Vector] = {}
    for u in sorted(needed):
        if (parent := tree.parents[u]) < 0:
            exact[u] = leaders[u]
        else:
            x = exact[parent]
            c.spend(len(x.powers) * family.order**2, max(family.bits, x.bits))
            exact[u] = x.image(family.matrices[tree.by[u]], family.denominator)
    return exact


def element_bits(x: Element) -> int:
    """The bits of all coefficients of a polynomial in Λ."""
    return sum(map(fraction_bits, x))


def longest_numerator(x: Element) -> int:
    """The bits of the longest numerator of a polynomial in Λ."""
    return max((c.numerator.bit_length() for c in x), default=0)


def times(x: Element, y: Element) -> Element:
    """The product of two polynomials in Λ, not reduced modulo m."""
    product = [Fraction(0)] * (len(x) + len(y) - 1)
    for i, a in enumerate(x):
        for j, b in enumerate(y):
            product[i + j] += a * b
    return product


def power(x: Element, n: int, m: Sequence[int]) -> Element:
    """The power x^n, of a degree below that of m where n >= 1."""
    result: Element = [Fraction(1)]
    for _ in range(n):
        result = _reduced(times(result, x), m)
    return result


def _reduced(x: Element, m: Sequence[int]) -> Element:
    rest = list(x)
    while len(rest) >= len(m):
        top = rest.pop() / m[-1]
        for k, c in enumerate(m[:-1], len(rest) - len(m) + 1):
            rest[k] -= top * c
    return rest


def is_zero(x: Element, m: Sequence[int]) -> bool:
    """Whether m divides x: then it is zero at Λ."""
    common = lcm(*(c.denominator for c in x))
    numerators = [c.numerator * (common // c.denominator) for c in x]
    while numerators and not numerators[-1]:
        numerators.pop()
    return not remainder(numerators, m)


def bounds(x: Element, at: Enclosure) -> tuple[Fraction, Fraction]:
    """The bounds low <= x(Λ) <= high: the value at the lower end a/q, and Λ is at most w/q away.

    |x'| is at most Σ_k k |x_k| ((a + w)/q)^(k-1) between.
    """
    low, high = Fraction(at.low, at.scale), Fraction(at.low + at.width, at.scale)
    value = slope = Fraction(0)
    for k in range(len(x) - 1, -1, -1):
        value = value * low + x[k]
        slope = slope * high + k * abs(x[k]) if k else slope
    error = (high - low) * slope
    return value - error, value + error
