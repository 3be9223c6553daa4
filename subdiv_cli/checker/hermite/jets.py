"""The rules on schemes whose data are jets: c^n = D^-n S^n c, D = diag(1, 1/p, …, p^-(d-1)). See FORMAT.md."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import factorial
from operator import mul
from typing import Any

from subdiv_cli.checker.core import Claim, Subject
from subdiv_cli.checker.radius.families import UPPER, bound_of
from subdiv_cli.checker.reading import require, require_few
from subdiv_cli.checker.roots import fraction_bits
from subdiv_cli.checker.spans import require_spanned
from subdiv_cli.checker.vector.conclusions import LOWER, bound_below, scaled
from subdiv_cli.checker.vector.masks import MatrixMask, lowest_terms, mask_of, nonzero
from subdiv_cli.checker.vector.masks import subject as mask_subject
from subdiv_cli.checker.vector.spaces import difference, invariant_space

_MAX_DEGREE = 100


def subject(parts: dict[str, Any]) -> Subject:
    """The mask of a document, from its parts. Raises Rejected where it is none, or has one component alone."""
    mask = mask_subject(parts)
    require(mask.about.size >= 2, "jets have two components at least")
    return mask


def spectral(c: Claim) -> None:
    """For degrees below k, and not for k, jets y_j = (f_j, f_j', …) of f_j = x^j/j! + … have S y_j = p^-j y_j.

    f_j = Σ_l φ_l x^(j-l)/(j-l)!, φ_0 = 1, as derivatives of eigen-sequences are such. In E_j(a) = Σ_β A_(ε+pβ) y_j(a-β)
    - p^-j y_j(ε+pa) the derivative is E_(j-1), so that E_j = 0 iff E_j(0) = 0; φ_j adds (1 - p^-j) φ_j e_0 to it.
    """
    a, k, shifts = mask_of(c), c.statement["order"], c.witness["shifts"]
    require_few(k <= _MAX_DEGREE, "the order is too large")
    require(c.statement["holds"] is (k >= a.size), f"{k} degrees and {a.size} components do not go with that verdict")
    require(len(shifts) == max(k, 1), "there is not one number for each degree")
    require(shifts[0] == 1, "the first number is not 1")
    index = max(abs(a.start), abs(a.start + len(a.matrices))).bit_length() + a.arity.bit_length()
    bits = a.bits + sum(map(fraction_bits, shifts)) + (k + 1) * (index + k.bit_length() + 1)
    c.count((k + 1) * (a.entries + a.arity * a.size) * (k + 1), bits)
    for j in range(k):
        require(not any(map(any, _residuals(a, shifts, j))), f"the jet of degree {j} is no eigen-sequence")
    residuals = _residuals(a, shifts, k)
    if k == 0:
        require(any(map(any, residuals)), "e_0 is reproduced as a constant")
        return
    same = all(row == residuals[0] for row in residuals) and not any(residuals[0][1:])
    require(not same, f"there is an eigen-sequence of degree {k}")


def _residuals(a: MatrixMask, shifts: Sequence[Fraction], j: int) -> list[list[Fraction]]:
    """E_j(0) for each ε, φ_j = 0 where it is not among the shifts."""
    p, d = a.arity, a.size
    residuals = [[-Fraction(1, p**j) * x for x in _jet(shifts, j, epsilon, d)] for epsilon in range(p)]
    for i, rows in enumerate(a.matrices, a.start):
        beta, epsilon = divmod(i, p)
        y = _jet(shifts, j, -beta, d)
        image = [sum(map(mul, row, y), Fraction(0)) / a.denominator for row in rows]
        residuals[epsilon] = [x + z for x, z in zip(residuals[epsilon], image, strict=True)]
    return residuals


def _jet(shifts: Sequence[Fraction], j: int, x: int, d: int) -> list[Fraction]:
    """The values of f_j, f_j', …, f_j^(d-1) at an integer."""
    known = [*shifts[: j + 1], *([Fraction(0)] * (j + 1 - len(shifts)))]
    return [
        sum(
            (phi * x ** (j - i - l) / factorial(j - i - l) for l, phi in enumerate(known[: max(j - i + 1, 0)])),
            Fraction(0),
        )
        for i in range(d)
    ]


def jet(c: Claim) -> None:
    """The new family is that of the T_ε on a space of images of e_j δ - ∇^j w and ∇^(j+1) w, spanned by such words.

    E_A is spanned by e_0, and w is the limit stencil if S converges: theorem 5 asks for the radius on this space.
    """
    a, j = mask_of(c), c.statement["component"]
    constants = c.use("constants").result
    require(constants == [tuple(Fraction(int(i == 0)) for i in range(a.size))], "the basis of E_A is not e_0")
    (w,), denominator = c.use("limit-stencils").result
    require(1 <= j < a.size, "there is no such derivative")
    between = {alpha: [-x for x in values] for alpha, values in difference(w, j).items()}
    unit = between.setdefault(0, [0] * a.size)
    between[0] = [x + denominator * (i == j) for i, x in enumerate(unit)]
    generators = [lowest_terms(nonzero(between), denominator), lowest_terms(difference(w, j + 1), denominator)]
    invariant_space(c, a, generators)
    require_spanned(c.witness["matrices"], c.witness["leaves"], c.witness["words"])


def hermite_converges(c: Claim) -> None:
    """The components of D^-n S^n c tend to f and its derivatives, f in C^(d-1): the radius of each j is below p^-j."""
    d = mask_of(c).size
    c.count(d)
    require(c.statement["order"] == d - 1, "the order is not that of the last derivative")
    c.use("convergent", holds=True)
    for j in range(1, d):
        used = c.use(*UPPER).statement
        c.use("jet", family=used["family"], component=j)
        require(scaled(c, bound_of(used), j * used["length"]) < 1, f"the radius of derivative {j} is not small enough")


def hermite_diverges(c: Claim) -> None:
    """They do not: E_A is not spanned by e_0, S diverges, or a radius is at least p^-j."""
    d = mask_of(c).size
    c.count(d)
    require(c.statement["order"] == d - 1, "the order is not that of the last derivative")
    proved = c.use("constants", "convergent", *LOWER)
    used = proved.statement
    if used["property"] == "constants":
        constants = proved.result
        require(len(constants) != 1 or any(constants[0][1:]), "E_A is spanned by e_0")
        return
    if used["property"] == "convergent":
        require(used["holds"] is False, "S converges")
        return
    j = c.use("jet", family=used["family"]).statement["component"]
    require(scaled(c, bound_below(used), j * used["length"]) >= 1, "the radius is not large enough")
