"""Products of transition matrices as obstacles: what an eigenvalue of one excludes, as text and as witness."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.text import modulus, number
from subdiv_cli.jsr.products import Product
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.stage import last_difference, product_name
from subdiv_cli.model import Data

Obstacle = tuple[str, dict[str, Data]]


def obstacle_to(numbers: ScalarNumbers, m: int) -> Obstacle | None:
    """What keeps a stable φ of these numbers from being C^m; None where nothing is known against it."""
    return sum_rule_obstacle(numbers, m) or product_obstacle(numbers, m)


def who_is_stable(numbers: ScalarNumbers) -> str:
    """The hypothesis of an obstacle, for the scheme of these numbers: on φ itself, or on φ0 after a reduction."""
    return "φ is stable" if numbers.reduced is numbers else "φ0 of the reduced scheme is stable"


def product_obstacle(numbers: ScalarNumbers, m: int) -> Obstacle | None:
    """A product of ℓ matrices of D = S_(Δ^k) with an eigenvalue |λ| >= p^(-mℓ), compared exactly: then α <= m."""
    product, p = numbers.product, numbers.p
    bound = Fraction(1, p**m)
    if product is None or product.compare(bound) < 0:
        return None
    total = m * len(product.word)
    size = number(Fraction(1, p**total)) if product.compare(bound) == 0 else modulus(product.eigenvalue)
    matrices = f"{product_text(product)} of {last_difference(numbers)}"
    return f"{matrices} has an eigenvalue of modulus {size} ≥ {threshold(p, total)}", product_witness(product)


def threshold(p: int, m: int) -> str:
    """p^-m as text: `1`, or `1/4 = 2^-2`."""
    return f"{number(Fraction(1, p**m))} = {p}^-{m}" if m else "1"


def sum_rule_obstacle(numbers: ScalarNumbers, m: int) -> Obstacle | None:
    """m >= k: α <= k always, because the transition matrices of D satisfy Σ_ε T_ε e = p^(1-k) e."""
    k = numbers.order
    return (
        (f"C^{m} needs sum rules of order {m + 1}, but the mask has order {k}", {"sum_rule_order": k})
        if m >= k
        else None
    )


def product_text(product: Product) -> str:
    """`the transition matrix T_0` or `the product T_1T_0 of transition matrices`."""
    name = product_name(product.word)
    return f"the transition matrix {name}" if len(product.word) == 1 else f"the product {name} of transition matrices"


def product_witness(product: Product) -> dict[str, Data]:
    """A word, its matrices multiplied from right to left, and an eigenvalue of the product: its minimal polynomial,

    lowest coefficient first, and its isolating box (real part from, to; imaginary part from, to).
    """
    return {
        "word": product.word,
        "minimal_polynomial": tuple(int(c) for c in product.eigenvalue.minimal_polynomial),
        "box": product.eigenvalue.box(),
    }
