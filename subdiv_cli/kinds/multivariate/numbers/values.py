"""Exact values of φ in several variables: at Z^s an eigenvector, at M^-n Z^s by refinement, φ = Σ_γ a_γ φ(M· - γ).

φ vanishes outside K = {Σ_(j>=1) M^-j γ_j}, γ_j in the support of the mask.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from itertools import product
from math import ceil, floor, lcm, prod

from subdiv_cli.exact.linalg import eigenvectors, matrix
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.spaces.lattice import Index, Lattice

LARGEST_WINDOW = 500
"""The most integers of the support."""
MOST_PRODUCTS = 2_000_000
"""The most products of a value and a coefficient."""
_LARGEST_BOX = 20_000

Values = Mapping[Index, Fraction]
Tail = Index
"""The coordinates of an index from the third on."""


class NoValuesError(ValueError):
    """Raised for values that are too many or not determined; the message gives the reason."""


def at_integers(scheme: MultivariateScheme, lattice: Lattice) -> dict[Index, Fraction]:
    """The values α -> φ(α) that are not zero: the v with v(α) = Σ_β a_(Mα-β) v(β), Σ_α v(α) = 1.

    Needs φ continuous with integral 1, proved, and Σ_α φ(· - α) = 1: so it is where the coset sums are 1 (its Fourier
    coefficients φ^(2πk), k ≠ 0, have a factor a(exp(-iω)) = 0), and for all box splines (a direction has ξ·k ≠ 0). That
    there is only one v, which convergence implies, is checked. Raises NoValuesError where there are more, and for a
    support that is too large.
    """
    window = integers_of_support(scheme, lattice)
    if len(window) > LARGEST_WINDOW:
        raise NoValuesError(f"the support has {len(window)} integers; the limit is {LARGEST_WINDOW}")
    rows = [
        [scheme.terms.get(tuple(x - b for x, b in zip(image, beta, strict=True)), 0) for beta in window]
        for image in map(lattice.image, window)
    ]
    vectors = eigenvectors(matrix(rows), 1) if window else ()
    total = sum(vectors[0]) if len(vectors) == 1 else 0
    if not total:
        raise NoValuesError("the refinement equation alone does not determine φ at the integers")
    return {alpha: x / total for alpha, x in zip(window, vectors[0], strict=True) if x}


def integers_of_support(scheme: MultivariateScheme, lattice: Lattice) -> list[Index]:
    """The integers of K, and perhaps more: those in a box around it from which x -> Mx - γ leads on in it for ever.

    x ∈ K is M^-1 (γ + y) with y ∈ K, and y = Mx - γ is an integer where x is. Raises NoValuesError.
    """
    sides = [range(ceil(low), floor(high) + 1) for low, high in support_box(scheme, lattice)]
    if prod(map(len, sides)) > _LARGEST_BOX:
        raise NoValuesError("the support is too large")
    alive = set(product(*sides))
    while True:
        images = {alpha: lattice.image(alpha) for alpha in alive}
        staying = {
            alpha
            for alpha, image in images.items()
            if any(tuple(x - g for x, g in zip(image, gamma, strict=True)) in alive for gamma in scheme.terms)
        }
        if len(staying) == len(alive):
            return sorted(alive)
        alive = staying


def support_box(scheme: MultivariateScheme, lattice: Lattice) -> list[tuple[Fraction, Fraction]]:
    """The s intervals that contain the coordinates of K, each less than half larger.

    The sum over j <= J is taken exactly; the rest is M^-J K, and with ‖M^-r‖∞ < 1 the norms of K are at most
    Σ_(j<=r) ‖M^-j‖∞ max |γ| / (1 - ‖M^-r‖∞).
    """
    largest = max(abs(x) for gamma in scheme.terms for x in gamma)
    box = [(Fraction(0), Fraction(0))] * lattice.dimension
    total, radius, power = Fraction(0), None, 0
    while True:
        power += 1
        rows = lattice.inverse_power(power)
        for i, row in enumerate(rows):
            images = [sum(x * g for x, g in zip(row, gamma, strict=True)) for gamma in scheme.terms]
            box[i] = box[i][0] + min(images), box[i][1] + max(images)
        norm = max(sum(map(abs, row)) for row in rows)
        total += norm
        if radius is None and norm < 1:
            radius = total * largest / (1 - norm)
        if radius is not None and norm * radius < Fraction(1, 4):
            return [(low - norm * radius, high + norm * radius) for low, high in box]


def at_fractions(
    scheme: MultivariateScheme, lattice: Lattice, integers: Values, level: int, tail: Tail | None = None
) -> dict[Index, Fraction]:
    """The values α -> φ(M^-level α) that are not zero; with a `tail` only those of the α that end in it.

    M is c I then. Raises NoValuesError beyond MOST_PRODUCTS.
    """
    mask_denominator = lcm(*(x.denominator for x in scheme.terms.values()))
    mask = [(gamma, int(x * mask_denominator)) for gamma, x in scheme.terms.items()]
    denominator = lcm(*(x.denominator for x in integers.values()))
    values = {alpha: int(x * denominator) for alpha, x in integers.items()}
    wanted = None if tail is None else _tails(scheme, lattice, level, tail)
    work = 0
    for j in range(level):
        work += len(values) * len(mask)
        if work > MOST_PRODUCTS:
            raise NoValuesError(f"there are too many values at level {level}")
        values = _refined(mask, values, None if wanted is None else wanted[j + 1])
        mask = [(lattice.image(gamma), a) for gamma, a in mask]
        denominator *= mask_denominator
    return {alpha: Fraction(x, denominator) for alpha, x in values.items() if x and tail in (None, alpha[2:])}


def _refined(mask: list[tuple[Index, int]], values: Mapping[Index, int], wanted: set[Tail] | None) -> dict[Index, int]:
    """The values φ(M^-(j+1) α) = Σ_γ a_γ φ(M^-j (α - M^j γ)), up to denominators; `mask` has M^j γ -> a_γ."""
    finer: dict[Index, int] = {}
    for beta, value in values.items():
        for gamma, a in mask:
            alpha = tuple(b + g for b, g in zip(beta, gamma, strict=True))
            if wanted is None or alpha[2:] in wanted:
                finer[alpha] = finer.get(alpha, 0) + a * value
    return finer


def _tails(scheme: MultivariateScheme, lattice: Lattice, level: int, tail: Tail) -> list[set[Tail]]:
    """The tails that are needed at each level: for α at level j + 1 those of α - c^j γ."""
    c, box = lattice.dilation[0][0], support_box(scheme, lattice)[2:]
    tails = {gamma[2:] for gamma in scheme.terms}
    needed = [{tail}]
    for j in reversed(range(level)):
        unit = c**j
        reached = {tuple(x - unit * g for x, g in zip(t, gamma, strict=True)) for t in needed[0] for gamma in tails}
        inside = {
            t for t in reached if all(low <= Fraction(x, unit) <= high for x, (low, high) in zip(t, box, strict=True))
        }
        needed.insert(0, inside)
    return needed
