"""Wording that stages share: names of operators and products."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.model.formulas import product

NOT_NORMALISED = "a(1) is not the arity, so there is no refinable function with integral 1"


def no_sum_rule(numbers: ScalarNumbers) -> str:
    """Why there is no difference scheme to ask."""
    return "no sum rule holds" if numbers.is_normalised else NOT_NORMALISED


def scaled(numbers: ScalarNumbers, nu: int) -> str:
    """The operator (1/p) S_ν as text: `½S_1`, `(1/7)S_1`, `½S0_1` for a reduced scheme."""
    return {2: "½", 3: "⅓", 4: "¼", 5: "⅕"}.get(numbers.p, f"(1/{numbers.p})") + f"{numbers.name}_{nu}"


def last_difference(numbers: ScalarNumbers) -> str:
    """The operator D = S_(Δ^k) as text."""
    return f"{numbers.name}_(Δ^{numbers.order})"


def power(operator: str, level: int) -> str:
    """A norm of a power as text: `‖½S_1‖∞` or `‖(½S_1)^3‖∞`."""
    return f"‖{operator}‖∞" if level == 1 else f"‖({operator})^{level}‖∞"


def derived_names(last: int) -> str:
    """The names of the derived schemes: `S_1`, `S_1 and S_2`, `S_1, …, S_4`."""
    return {1: "S_1", 2: "S_1 and S_2"}.get(last, f"S_1, …, S_{last}")


def product_name(word: tuple[int, ...]) -> str:
    """The product T_(w_ℓ) … T_(w_1) of a word as text: `T_1T_0^12`."""
    return product(word, "T")


def series(values: tuple[Fraction, ...], show: Callable[[Fraction], str]) -> str:
    """Values separated by commas, the middle of a long series left out."""
    texts = [show(value) for value in values]
    return ", ".join(texts if len(texts) <= 6 else [*texts[:3], "…", texts[-1]])
