"""The rules on Taylor schemes: T S_A = p^-(d-1) S_B T, T what Taylor's formula leaves of jets. See FORMAT.md."""

from __future__ import annotations

from fractions import Fraction
from math import factorial

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import Matrix, multiply
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.vector.derived import derived_from
from subdiv_cli.checker.vector.masks import MatrixMask, mask_of, matrix_mask
from subdiv_cli.checker.vector.sequences import check_constants


def taylor(c: Claim) -> MatrixMask:
    """T S_A = p^-(d-1) S_B T for a mask B whose constants are the multiples of e_(d-1); those of A are those of e_0.

    (T c)_j(i) = c_j(i+1) - Σ_(l>=j) c_l(i)/(l-j)! for j < d-1, and c_(d-1)(i). Raises Rejected where it is not so.
    """
    a, b = mask_of(c), matrix_mask(mask_of(c).arity, c.witness["start"], c.witness["coefficients"])
    d, p = a.size, a.arity
    require(b.size == d, "the sizes do not fit")
    length = len(a.matrices) + len(b.matrices) + p + 2
    c.count(length * 4 * d**3 + 2 * (b.entries + p * d * d), a.bits + b.bits + d * (d.bit_length() + p.bit_length()))
    (u,) = c.use("constants", dimension=1).result
    require(u[0] != 0 and not any(u[1:]), "E_A is not spanned by e_0")
    check_constants(b, 1, [[Fraction(int(i == d - 1)) for i in range(d)]])
    ahead, here = _taylor_operator(d)
    zero = [[0] * d for _ in range(d)]
    masks = [dict(enumerate(mask.matrices, mask.start)) for mask in (a, b)]
    left, right = p ** (d - 1) * b.denominator, a.denominator
    for i in range(min(a.start - 1, b.start - p), max(a.start + len(a.matrices), b.start + len(b.matrices)) + 1):
        x, after = (masks[0].get(i + shift, zero) for shift in (0, 1))
        y, ahead_of = (masks[1].get(i + shift, zero) for shift in (0, p))
        image = _combined(left, multiply(ahead, after), multiply(here, x))
        same = image == _combined(right, multiply(ahead_of, ahead), multiply(y, here))
        require(same, f"the Taylor mask is another at the index {i}")
    return b


def _taylor_operator(d: int) -> tuple[Matrix, Matrix]:
    """Integer matrices U and V with (d-1)! T c(i) = U c(i+1) - V c(i)."""
    unit = factorial(d - 1)
    ahead = [[unit * (k == l and k < d - 1) for l in range(d)] for k in range(d)]
    here = [[unit // factorial(l - k) if l >= k else 0 for l in range(d)] for k in range(d)]
    here[d - 1][d - 1] = -unit
    return ahead, here


def _combined(factor: int, a: Matrix, b: Matrix) -> Matrix:
    return [[factor * (x - y) for x, y in zip(row, other, strict=True)] for row, other in zip(a, b, strict=True)]


def taylor_derived(c: Claim) -> MatrixMask:
    """Δ_r S_Ā = (1/p) S_B Δ_r: B is derived n times from the Taylor mask, as `derived` says it of the document's."""
    n = c.statement["order"]
    require(n >= 1, "the order is not positive")
    return derived_from(c, c.use("taylor").result if n == 1 else c.use("derived", order=n - 1).result)


def taylor_converges(c: Claim) -> None:
    """D^-n S^n c tends to f and its derivatives: a scheme that is derived from the Taylor scheme contracts."""
    c.count(1)
    require(c.statement["order"] == mask_of(c).size - 1, "the order is not that of the last derivative")
    require(c.use("derived-norm").statement["norm"] < 1, "the norm is not below 1")


def taylor_smooth(c: Claim) -> None:
    """All limits are C^(d+n-2): the n-th scheme that is derived from the Taylor scheme contracts."""
    c.count(1)
    used, d = c.use("derived-norm").statement, mask_of(c).size
    require(used["order"] + d == c.statement["order"] + 2, f"the norm is that of derived scheme {used['order']}")
    require(used["norm"] < 1, "the norm is not below 1")
