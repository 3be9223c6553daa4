"""Stability of φ: of interpolatory masks, and by the Gram sequence of its translates. See FORMAT.md.

The translates are stable iff the symbol of the sequence is positive; it may have a zero.

b(z) = a(z) a(1/z), (G g)(α) = (1/m) Σ_β b(Mα-β) g(β). Where S converges uniformly, the only finite g with G g = g and
Σ g_α = 1 is g_α = ∫ φ(x) φ(x - α) dx.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from math import comb, lcm, prod
from operator import add as plus
from operator import mul

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.multivariate.lattice import Index, Sparse, add, multiply, over_one
from subdiv_cli.checker.multivariate.masks import mask_of
from subdiv_cli.checker.polynomials import cyclotomic_divides, polynomial
from subdiv_cli.checker.reading import require, require_few

MAX_SIZE = 100_000
"""The most coefficients of a polynomial on a box."""


def interpolatory_stable(c: Claim) -> None:
    """S converges, and some coset has one coefficient a_t only, and a_t = 1.

    φ_t = φ(· + (M-I)^-1 t) is the function of the mask a(· + t): φ_t(α) = δ_α, so |c_α| <= ‖Σ c_β φ(· - β)‖∞.
    """
    a = mask_of(c)
    c.count(len(a.terms), a.bits)
    c.use("convergent", holds=True)
    alone = (coset[0][1] for coset in a.by_coset() if len(coset) == 1)
    require(a.denominator in alone, "no coset has one coefficient only that is 1")


def gram_stable(c: Claim) -> None:
    """Φ(ω) = Σ g_α e^(-iα·ω) > 0 for all ω: on every box its Bernstein coefficients are positive."""
    g, first = _gram(c)
    reach = [max(map(abs, column)) for column in zip(*g, strict=True)]
    lengths = [2 * n + 1 for n in reach]
    require_few(prod(lengths) <= MAX_SIZE, "the polynomial has too many coefficients")
    tree, size = c.witness["tree"], prod(lengths) * max(lengths)
    c.count(first + (len(tree) + 2 ** len(reach)) * size, 0)
    nodes = iter(tree)
    for odd in product((0, 1), repeat=len(reach)):
        _require_positive(c, _bernstein(c, g, reach, odd), lengths, nodes)
    require(next(nodes, None) is None, "the tree has more boxes")


def gram_unstable(c: Claim) -> None:
    """Φ(2πk/n) = 0: the cyclotomic polynomial of order n divides Σ g_α z^(k·α mod n)."""
    g, first = _gram(c)
    k, n = c.witness["point"], c.witness["order"]
    require(len(k) == mask_of(c).dilation.dimension, "the point has another dimension")
    c.count(first + len(g) + n**2)
    folded = [0] * n
    for alpha, x in g.items():
        folded[sum(i * j for i, j in zip(k, alpha, strict=True)) % n] += x
    require(cyclotomic_divides(n, polynomial(0, folded, 1)), "the symbol is not zero at the point")


def _gram(c: Claim) -> tuple[Sparse, int]:
    """The numerators of g over one denominator, and the work that it takes; S converges."""
    a = mask_of(c)
    c.use("convergent", holds=True)
    g, denominator = over_one(c.witness["gram"])
    require(all(len(alpha) == a.dilation.dimension for alpha in g), "an index of g has another dimension")
    require(all(g.get(_minus(alpha)) == x for alpha, x in g.items()), "g is not even")
    require(sum(g.values()) == denominator, "g does not add up to 1")
    bits = max(map(abs, g.values())).bit_length() + denominator.bit_length()
    c.count(len(a.terms) ** 2, 2 * a.bits)
    b = multiply(a.terms, {_minus(alpha): x for alpha, x in a.terms.items()})
    work = len(a.terms) ** 2 + len(b) * len(g)
    c.count(work, bits + 2 * a.bits)
    image: Sparse = {}
    for beta, x in g.items():
        for gamma, y in b.items():
            at = add(beta, gamma)
            if not any(a.dilation.residue(at)):
                alpha = a.dilation.divided(at)
                image[alpha] = image.get(alpha, 0) + x * y
    scale = a.dilation.cosets * a.denominator**2
    same = {alpha: scale * x for alpha, x in g.items()} == {alpha: x for alpha, x in image.items() if x}
    require(same, "G does not map g to itself")
    return g, work


def _minus(alpha: Index) -> Index:
    return tuple([-x for x in alpha])


def _require_positive(c: Claim, values: list[int], lengths: Sequence[int], nodes: Iterator[int]) -> None:
    """Check positivity by a tree of boxes in preorder: the variable that is halved, or -1 where all is positive."""
    waiting = [values]
    while waiting:
        values, axis = waiting.pop(), next(nodes, len(lengths))
        require(-1 <= axis < len(lengths), "the tree ends early, or halves a variable that is not there")
        if axis == -1:
            require(min(values) > 0, "a coefficient on a box is not positive")
            continue
        c.spend(len(values) * lengths[axis], max(map(abs, values)).bit_length())
        left, right = _halves(values, lengths[axis], prod(lengths[axis + 1 :]))
        waiting += [right, left]


def _bernstein(c: Claim, g: Mapping[Index, int], reach: Sequence[int], odd: Sequence[int]) -> list[int]:
    """The Bernstein coefficients of Φ Π (1 + t_j²)^n_j, up to a factor, in lexicographic order.

    ω_j = 2 arctan t_j + π odd_j, -1 <= t_j <= 1, but 0 <= t_0, as Φ is even: these arcs cover the torus. The last
    variable comes first.
    """
    values = {alpha: [[-x if sum(map(mul, alpha, odd)) % 2 else x], [0]] for alpha, x in g.items()}
    bits = max(map(abs, g.values())).bit_length()
    for j in reversed(range(len(reach))):
        n, whole = reach[j], j > 0
        used = {alpha[j] for alpha in values}
        c.spend(len(used) * (2 * n) ** 2, 8 * n)
        rows = {i: _row(n, i, whole) for i in used}
        sums: dict[Index, list[list[int]]] = {}
        bits += 8 * n + 2
        for alpha, (real, imaginary) in values.items():
            cos, sin = rows[alpha[j]]
            c.spend(len(cos) * len(real), bits)
            pairs = list(zip(real, imaginary, strict=True))
            more = [
                [p * x - q * y for p, q in zip(cos, sin, strict=True) for x, y in pairs],
                [p * y + q * x for p, q in zip(cos, sin, strict=True) for x, y in pairs],
            ]
            total = sums.get(alpha[:j])
            sums[alpha[:j]] = (
                more if total is None else [list(map(plus, x, y)) for x, y in zip(total, more, strict=True)]
            )
        values = sums
    return values[()][0]


def _row(n: int, alpha: int, whole: bool) -> tuple[list[int], list[int]]:
    """The Bernstein coefficients of (1 + it)^(n+α) (1 - it)^(n-α), real and imaginary, times one integer for all α.

    t = (u-v)/(u+v) runs through [-1, 1], or t = u/(u+v) through [0, 1], for u, v >= 0: 1 ± it is linear in u and v.
    """
    real, imaginary = [1], [0]
    for sign in [1] * (n + alpha) + [-1] * (n - alpha):
        by_v, by_u = (1, -sign) if whole else (1, 0), (1, sign)
        pairs = list(zip(real, imaginary, strict=True))
        parts = [[(p * x - q * y, p * y + q * x) for x, y in pairs] for p, q in (by_v, by_u)]
        sums = [(x + z, y + w) for (x, y), (z, w) in zip([*parts[0], (0, 0)], [(0, 0), *parts[1]], strict=True)]
        real, imaginary = [x for x, _ in sums], [y for _, y in sums]
    binomials = [comb(2 * n, j) for j in range(2 * n + 1)]
    scale = lcm(*binomials)
    factors = [scale // d for d in binomials]
    return list(map(mul, real, factors)), list(map(mul, imaginary, factors))


def _halves(values: list[int], length: int, width: int) -> tuple[list[int], list[int]]:
    """The coefficients on both halves of a box, times a power of two (de Casteljau).

    The coefficients of a variable are `width` apart.
    """
    left, right = [], []
    for first in range(0, len(values), length * width):
        row, ends = values[first : first + length * width], []
        for step in range(length - 1, -1, -1):
            left += [x << step for x in row[:width]]
            ends.append([x << step for x in row[-width:]])
            row = list(map(plus, row, row[width:]))
        right += [x for end in reversed(ends) for x in end]
    return left, right
