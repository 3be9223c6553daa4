"""Rules on joint spectral radii by ellipsoids and weighted sums, and by vectors that products make larger.

Where a bound from below and one from above meet, they are the radius.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from math import isqrt, lcm
from operator import mul

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import Matrix, RationalFamily
from subdiv_cli.checker.radius.polytopes import IN_ONE_NORM, require_nonnegative
from subdiv_cli.checker.reading import Rejected, require
from subdiv_cli.checker.roots import fraction_bits, isolated_root

_PLACES = 160
"""The bits to which the entries of a form are cut where that leaves it positive."""


def common_vector(c: Claim) -> str:
    """JSR <= x: M_i u <= x u for a u > 0 and all M_i >= 0, so max |y_i|/u_i is a norm in which they are at most x.

    Or u' M_i <= x u' in every coordinate, with the norm Σ u_i |y_i|.
    """
    family, x, u = c.family(), c.statement["bound"], c.witness["vector"]
    require(c.statement["length"] == 1 and x > 0, "the length is not 1, or the bound is not positive")
    require(len(u) == family.order and min(u) > 0, "the vector is of another order, or not positive")
    require_nonnegative(family)
    entries, bits = _integers(u)
    c.count(len(family.matrices) * family.order**2, family.bits + bits + fraction_bits(x))
    for number, matrix in enumerate(family.matrices):
        image = matrices.apply(matrices.transpose(matrix) if c.witness["left"] else matrix, entries)
        fits = (y * x.denominator <= x.numerator * family.denominator * e for y, e in zip(image, entries, strict=True))
        require(all(fits), f"matrix {number} makes the vector larger")
    return IN_ONE_NORM


def ellipsoid(c: Claim) -> str:
    """JSR² <= x: with ‖y‖² = y'Py, P positive definite, x^|w| P - Π'PΠ >= 0 for the products Π of some words w.

    Every long word begins with one of these, so the norms of its products are bounded by powers of √x.
    """
    family, x, flat, words = c.family(), c.statement["bound"], c.witness["form"], c.witness["words"]
    n = family.order
    require(c.statement["length"] == 2 and x > 0, "the length is not 2, or the bound is not positive")
    require(len(flat) == n * (n + 1) // 2, "the form has not N(N + 1)/2 entries")
    require(_is_complete(words, len(family.matrices)), "the words are not the ends of all words, each in one way")
    longest = max(map(len, words))
    size = max(map(abs, flat)).bit_length()
    bits = longest * (2 * family.bits + 2 * n.bit_length() + fraction_bits(x)) + size
    c.count((5 * len(words) + 1) * n**3, bits)
    p = [[flat[max(i, j) * (max(i, j) + 1) // 2 + min(i, j)] for j in range(n)] for i in range(n)]
    require(_is_positive(c, p, strictly=True), "the form is not positive definite")
    for word, (product, denominator) in zip(words, _products(family, words), strict=True):
        image = matrices.multiply(matrices.transpose(product), matrices.multiply(p, product))
        left, right = x.numerator ** len(word) * denominator**2, x.denominator ** len(word)
        pairs = zip(p, image, strict=True)
        rest = [[left * a - right * b for a, b in zip(*rows, strict=True)] for rows in pairs]
        require(_is_positive(c, rest, strictly=False), f"the product of {', '.join(map(str, word))} has a larger norm")
    return IN_ONE_NORM


def _is_complete(words: Sequence[Sequence[int]], letters: int) -> bool:
    """Whether the words, in alphabetical order, are the ends of a complete tree: every long word begins with one."""
    if not words or any(not word or max(word) >= letters for word in words):
        return False
    if any(tuple(a) >= tuple(b) or tuple(b[: len(a)]) == tuple(a) for a, b in pairwise(words)):
        return False
    deepest = max(map(len, words))
    ends = sum(letters ** (deepest - len(word)) for word in words)
    return bool(ends == letters**deepest)


def _products(family: RationalFamily, words: Sequence[Sequence[int]]) -> Iterator[tuple[Matrix, int]]:
    """The products of the words with their denominators; what a word shares with the one before is not done again."""
    path: list[Matrix] = []
    before: Sequence[int] = ()
    for word in words:
        shared = next((k for k, (a, b) in enumerate(zip(before, word, strict=False)) if a != b), 0)
        del path[shared:]
        for letter in word[shared:]:
            matrix = family.matrices[letter]
            path.append(matrices.multiply(matrix, path[-1]) if path else matrix)
        yield path[-1], family.denominator ** len(word)
        before = word


def _is_positive(c: Claim, form: Matrix, *, strictly: bool) -> bool:
    """Whether an N×N symmetric form is positive semidefinite, or definite; first with entries of one length.

    With Q = 2^s (C + R), 0 <= R_ij < 1, the eigenvalues of R are at least -N: C - N > 0 is enough.
    """
    n, longest = len(form), max(abs(x) for row in form for x in row).bit_length()
    cut = longest - _PLACES
    c.spend(n**3, _PLACES)
    if _has_root([[x >> cut if cut > 0 else x << -cut for x in row] for row in form]):
        return True
    c.spend(n**3, n * longest)
    return _pivots(form, strictly)


def _has_root(form: Matrix) -> bool:
    """Whether C - N is positive definite for an N×N form C as Cholesky's G shows in integers, all rounded down.

    With B = C - N(2g + 3), g^2 the largest entry on the diagonal, and 0 <= (B - GG')_ij <= 2g: B >= -2gN.
    """
    off, rows = len(form) * (2 * isqrt(max(0, *(row[i] for i, row in enumerate(form)))) + 3), list[list[int]]()
    for i, row in enumerate(form):
        g: list[int] = []
        for j, above in enumerate(rows):
            g.append((row[j] - sum(map(mul, g, above))) // above[j])
        if (rest := row[i] - off - sum(map(mul, g, g))) <= 0:
            return False
        rows.append([*g, isqrt(rest)])
    return True


def _pivots(form: Matrix, strictly: bool) -> bool:
    """Whether no pivot of a symmetric form is negative, and none zero unless its row is; or all are positive.

    LDL' without fractions (Bareiss): after step k all entries are minors of order k + 1.
    """
    rest, before = [list(row) for row in form], 1
    while rest:
        top, *below = rest
        pivot = top[0]
        if pivot < 0 or (pivot == 0 and (strictly or any(top))):
            return False
        if pivot == 0:
            rest = [row[1:] for row in below]
            continue
        rest = [[(pivot * x - row[0] * y) // before for x, y in zip(row[1:], top[1:], strict=True)] for row in below]
        before = pivot
    return True


def growing_vector(c: Claim) -> None:
    """JSR^ℓ >= x: a product Π of ℓ matrices, or its transpose, has Π v = ±x v ≠ 0, or is >= 0 with Π v >= x v >= 0."""
    family, x, w = c.family(), c.statement["bound"], c.witness
    word, v, sign = w["word"], w["vector"], w["sign"]
    require(x > 0 and sign != 0, "the bound is not positive, or the sign is not 1 or -1")
    require(len(word) == c.statement["length"], "the word is of another length")
    require(max(word) < len(family.matrices), "a letter is not there")
    require(len(v) == family.order and any(v), "the vector is of another order, or zero")
    entries, bits = _integers(v)
    size = len(word) * (family.bits + family.order.bit_length()) + bits + fraction_bits(x)
    c.count(len(word) * family.order**2, size)
    image = entries
    for letter in reversed(word) if w["left"] else word:
        matrix = family.matrices[letter]
        image = matrices.apply(matrices.transpose(matrix) if w["left"] else matrix, image)
    left = [y * x.denominator for y in image]
    right = [sign * x.numerator * family.denominator ** len(word) * e for e in entries]
    if left != right:
        require(sign == 1 and min(v) >= 0, "the vector is not an eigenvector, nor is it positive")
        require_nonnegative(family)
        require(all(a >= b for a, b in zip(left, right, strict=True)), "the product does not make the vector so large")


def meeting_bounds(c: Claim) -> None:
    """JSR^ℓ = Λ, a rational number: JSR^a >= y and JSR^b <= x with y^ℓ >= Λ^a and x^ℓ <= Λ^b.

    Products are bounded by powers of it where the bound from above is that of a norm. Raises Rejected where a bound is
    another one, or the root is irrational.
    """
    c.count(1)
    s, exact = c.statement, isolated_root(c).rational
    if exact is None:
        raise Rejected("the root is not of degree 1")
    lower, upper = c.use("radius-lower", family=s["family"]), c.use("radius-upper", family=s["family"])
    low, high = lower.statement, upper.statement
    bits = [fraction_bits(y) for y in (exact, low["bound"], high["bound"])]
    c.spend(4, max(bits) * max(s["length"], low["length"], high["length"]))
    require(low["bound"] > 0 and low["bound"] ** s["length"] >= exact ** low["length"], "the lower bound is smaller")
    require(high["bound"] ** s["length"] <= exact ** high["length"], "the upper bound is larger")
    require(s["property"] == "radius" or upper.result is IN_ONE_NORM, "the upper bound is not by one norm")


def _integers(v: Sequence[Fraction]) -> tuple[list[int], int]:
    """A multiple of the vector with integer entries, and the bits of the longest one."""
    common = lcm(*(x.denominator for x in v))
    entries = [x.numerator * (common // x.denominator) for x in v]
    return entries, max(map(abs, entries)).bit_length()
