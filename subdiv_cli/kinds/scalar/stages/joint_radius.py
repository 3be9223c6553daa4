"""The joint spectral radius of the last difference scheme (SD310), and products of matrices as obstacles to C^n."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from subdiv_cli.exact.text import modulus, number, rounded_up, valued
from subdiv_cli.jsr.products import WordProduct
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.kind import Facts, asking
from subdiv_cli.kinds.radius import enclosed, put_radius, shown
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.rules import JOINT_RADIUS, SOBOLEV
from subdiv_cli.kinds.scalar.stages.wording import last_difference, no_sum_rule, power, product_name
from subdiv_cli.kinds.scalar.witnesses import JointRadiusWitness, ObstacleWitness, ProductWitness
from subdiv_cli.model import Finding


class Obstacle(NamedTuple):
    """What keeps a stable φ from being smoother, in words: a product, the order of the sum rules, or a finding."""

    text: str
    product: WordProduct | None = None
    sum_rule_order: int | None = None
    by: str | None = None
    """The code of that finding."""

    def put_into(self, witness: ObstacleWitness) -> None:
        """Write the obstacle into a witness."""
        if self.sum_rule_order is not None:
            witness["sum_rule_order"] = self.sum_rule_order
        if self.product is not None:
            put_product(witness, self.product)
        if self.by is not None:
            witness["by"] = self.by


def obstacle_to(numbers: ScalarNumbers, m: int) -> Obstacle | None:
    """The obstacle that keeps a stable φ of these numbers from being C^m; None where none is known."""
    return next(obstacles_to(numbers, m), None)


def obstacles_to(numbers: ScalarNumbers, m: int) -> Iterator[Obstacle]:
    """The obstacles that are known, the cheapest one first.

    That is m >= k: α <= k always, because the transition matrices of D satisfy Σ_ε T_ε e = p^(1-k) e. Or a product. Or
    the Sobolev exponent s <= m, as λ >= p^(-2m) for the growth λ of the mean squares: then α <= m.
    """
    if m >= (k := numbers.order):
        yield Obstacle(f"C^{m} needs sum rules of order {m + 1}, but the mask has order {k}", sum_rule_order=k)
    if (of_product := product_obstacle(numbers, m)) is not None:
        yield Obstacle(*of_product)
    if (growth := numbers.growth) is not None and growth.low * numbers.p ** (2 * m) >= 1:
        yield Obstacle(f"its Sobolev exponent is at most {m}", by=SOBOLEV.code)


def who_is_stable(numbers: ScalarNumbers) -> str:
    """The hypothesis of an obstacle, for the scheme of these numbers: on φ itself, or on φ0 after a reduction."""
    return "φ is stable" if numbers.reduced is numbers else "φ0 of the reduced scheme is stable"


def product_obstacle(numbers: ScalarNumbers, m: int) -> tuple[str, WordProduct] | None:
    """A product of ℓ matrices of D = S_(Δ^k) with an eigenvalue |λ| >= p^(-mℓ), compared exactly: then α <= m."""
    product, p = numbers.product, numbers.p
    bound = Fraction(1, p**m)
    if product is None or product.compare(bound) < 0:
        return None
    total = m * len(product.word)
    size = number(Fraction(1, p**total)) if product.compare(bound) == 0 else modulus(product.eigenvalue)
    matrices = f"{product_text(product)} of {last_difference(numbers)}"
    return f"{matrices} has an eigenvalue of modulus {size} ≥ {threshold(p, total)}", product


def threshold(p: int, m: int) -> str:
    """The power p^-m as text: `1`, or `1/4 = 2^-2`."""
    return f"{number(Fraction(1, p**m))} = {p}^-{m}" if m else "1"


def product_text(product: WordProduct) -> str:
    """A product as text: `the transition matrix T_0` or `the product T_1T_0 of transition matrices`."""
    name = product_name(product.word)
    return f"the transition matrix {name}" if len(product.word) == 1 else f"the product {name} of transition matrices"


def put_product(witness: ProductWitness, product: WordProduct) -> None:
    """Write a product into a witness: its word, its matrices multiplied from right to left, and an eigenvalue.

    Of the eigenvalue the minimal polynomial, lowest coefficient first, and the isolating box (real part from, to;
    imaginary part from, to).
    """
    witness["word"] = product.word
    witness["minimal_polynomial"] = tuple(int(c) for c in product.eigenvalue.minimal_polynomial)
    witness["box"] = product.eigenvalue.box()


_JOINT_RADIUS_QUESTION = "what is the joint spectral radius of the last difference scheme?"


@asking((JOINT_RADIUS, _JOINT_RADIUS_QUESTION))
def joint_radius(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD310: the joint spectral radius of D = S_(Δ^k), the last difference scheme.

    ρ = lim ‖D^L‖∞^(1/L) is that of the transition matrices T_0, …, T_(p-1) of D (Dyn 1992, section 4), and with it
    convergence, the order of smoothness and the Hölder exponent are decided: (1/p)S_ν contracts iff max(1/p, p^(ν-1) ρ)
    < 1. A product Π of ℓ matrices has ρ(Π)^(1/ℓ) <= ρ; what bounds ρ from above, and where both meet is the number
    itself, is one of

    * a norm, ρ <= ‖D^L‖∞^(1/L);
    * a symbol >= 0 on |z| = 1 (numbers/positive.py): ρ is the spectral radius of one matrix;
    * an invariant polytope (jsr/closing.py): a convex body that the matrices, divided by x, map into itself: ρ <= x;
    * blocks (jsr/reduce.py): ρ is the largest of those of the diagonal blocks of a common block triangular form.

    No hypothesis beyond k >= 1, checked. For an unstable mask there is one finding for S itself, which decides
    convergence, and one for the reduced mask (SD403), which decides smoothness.

    Witness: `of`, S or S0; `difference_order`, k; `method`; where a product is known `word`; `length` and `bound`, or
    `length` and `root` (polynomial, lowest power first, low, high): ρ^length is at most the bound, or is the root;
    `vertices`, how many a polytope has. `proof`: the whole of it, as certificate/RADIUS.md says.
    """
    each = [numbers] if numbers.reduced is numbers else [numbers, numbers.reduced]
    if findings := tuple(_finding(one) for one in each if one.order >= 1):
        return findings
    return (JOINT_RADIUS.skipped(_JOINT_RADIUS_QUESTION, no_sum_rule(numbers)),)


def _finding(numbers: ScalarNumbers) -> Finding:
    radius = numbers.radius
    if radius is None:
        return JOINT_RADIUS.undecided(_JOINT_RADIUS_QUESTION, "the effort ended before a bound")
    witness: JointRadiusWitness = {"of": numbers.name, "difference_order": numbers.order, "method": radius.method}
    put_radius(witness, radius)
    if radius.vertices is not None:
        witness["vertices"] = radius.vertices
    name = f"ρ({last_difference(numbers)})"
    value = enclosed(radius)
    size = f"≤ {rounded_up(value.upper or 0.0, 12)}" if radius.exact is None else f"= {shown(radius)}"
    return JOINT_RADIUS.proved(f"{name} {size}: {_how(numbers, radius)}", witness, value, proof=radius.proof)


def _how(numbers: ScalarNumbers, radius: Radius) -> str:
    """The method that proves the radius, in words."""
    attains = (
        f", and {product_text(numbers.product)} attains it" if numbers.product is not None and radius.exact else ""
    )
    rule = radius.method
    operator = last_difference(numbers)
    if rule == "norm":
        return f"{power(operator, radius.upper[0])} = {valued(radius.upper[1])}{attains}"
    if rule == "positive-symbol":
        return f"the symbol of {operator} is not negative on |z| = 1{attains}"
    if rule == "blocks":
        return f"it is the largest of the radii of {len(radius.proof['sizes'])} diagonal blocks{attains}"
    if rule in ("common-vector", "ellipsoid"):
        norm = "a weighted norm" if rule == "common-vector" else "the norm of an ellipsoid"
        return f"{norm} bounds the products{attains}"
    body = f"an invariant polytope of {radius.vertices} vertices"
    if radius.exact is None:
        return f"{body} bounds it"
    return f"{body} closes at exactly this radius{attains}"
