"""The rule on polynomials that are generated: S Q = Q σ, solved exactly. See FORMAT.md."""

from __future__ import annotations

from fractions import Fraction
from math import comb, lcm

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.piecewise.masks import SideCells, masks_of
from subdiv_cli.checker.piecewise.spaces import Echelon, Row, Window
from subdiv_cli.checker.reading import require, require_few

_MAX_DEGREE = 100


def generation(c: Claim) -> None:
    """S Q = Q σ on π_m, and on no π_(m+1), for an operator Q that is that of its mask on each side far from 0.

    There are sequences with S q_d = p^-d q_d for d <= m, and none for d = m + 1, or a mask has no polynomial there.
    """
    degree = c.statement["degree"]
    require_few(degree <= _MAX_DEGREE, "the degree is too large")
    masks = masks_of(c)
    window = Window(masks)
    c.count((degree + 2) * window.work(degree), window.bits(degree))
    for d in range(degree + 1):
        require(is_generated(window, d), f"x^{d} is not generated")
    require(not is_generated(window, degree + 1), f"x^{degree + 1} is generated")


def is_generated(window: Window, d: int) -> bool:
    """Whether there is a sequence with S q = p^-d q that is that of the masks where the cells have their data.

    Where cells of both sides need the same data, both masks must agree. With q known at those points, S q - p^-d q = 0
    on the window is linear in the other values.
    """
    p, known = window.masks.arity, dict[int, Fraction]()
    for cells in window.cells:
        polynomial = eigen_polynomial(cells, p, d)
        if polynomial is None:
            return False
        for i in cells.points:
            x = sum((c * i**r for r, c in enumerate(polynomial)), Fraction(0))
            if known.setdefault(i, x) != x:
                return False
    unknown = [i for i in window.points if i not in known]
    rows: list[Row] = []
    for i in window.points:
        weights = dict(window.masks.row(i))
        weights[i] = weights.get(i, Fraction(0)) - Fraction(1, p**d)
        given = sum((x * known[j] for j, x in weights.items() if j in known), Fraction(0))
        entries = [*(weights.get(j, Fraction(0)) for j in unknown), -given]
        common = lcm(*(x.denominator for x in entries))
        rows.append([int(x * common) for x in entries])
    return all(any(row[:-1]) for row in Echelon(rows).basis())


def eigen_polynomial(cells: SideCells, p: int, d: int) -> list[Fraction] | None:
    """The coefficients of q with Σ_j a_(i-pj) q(j) = p^-d q(i) that leads (spacing t)^d; None where there is none.

    With M_l = Σ a_γ γ^l over a residue class, which must be one number for all classes for l <= d, and M_0 = 1:
    coefficient m of S q is Σ_r q_r p^-r C(r, m) (-1)^(r-m) M_(r-m).
    """
    a, sums = cells.mask, list[Fraction]()
    for order in range(d + 1):
        classes = [0] * p
        for gamma, x in enumerate(a.numerators, a.start):
            classes[gamma % p] += x * gamma**order
        if len(set(classes)) > 1:
            return None
        sums.append(Fraction(classes[0], a.denominator))
    if sums[0] != 1:
        return None
    q = [Fraction(0)] * d + [cells.spacing**d]
    for m in range(d - 1, -1, -1):
        rest = [q[r] * comb(r, m) * (-1) ** (r - m) * sums[r - m] / p**r for r in range(m + 1, d + 1)]
        q[m] = sum(rest, Fraction(0)) / (Fraction(1, p**d) - Fraction(1, p**m))
    return q
