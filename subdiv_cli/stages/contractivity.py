"""SD301: for ν = 1, …, k, does (1/p)S_ν contract?

Theorem (Dyn 1992, 3.2 and 3.4, for any arity p): with sum rules of order ν, ‖((1/p)S_ν)^L‖∞ < 1 for some L iff S_(ν-1)
converges uniformly, and then every limit function is C^(ν-1). Hypotheses a(1) = p and the sum rules: checked, they are
what k says. Norms decide upward.

Refuted without norms: the joint spectral radius of (1/p)S_ν is max(1/p, p^(ν-1) ρ) with ρ that of D = S_(Δ^k), the last
difference scheme, so a product Π of ℓ transition matrices of D with an eigenvalue |λ| >= p^(-(ν-1)ℓ) excludes every L.
No stability is needed for either: the finding speaks of S_ν, not of φ.

Witness, proved: `nu`, `level`, `norm` and the `norms` of levels 1 to `level`. Refuted: `nu`, `word` (its matrices are
multiplied from right to left), `eigenvalue` as minimal polynomial (lowest coefficient first) and isolating box.
Undecided: `nu` and the `norms` computed.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.algebraic import AlgebraicNumber
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import certain, eigenvalue, number
from subdiv_cli.model import Data, Finding, Interval, Verdict
from subdiv_cli.quantities.products import Product
from subdiv_cli.quantities.scalar import ScalarNumbers
from subdiv_cli.stages.stage import Facts, power, product_name, scaled, series


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    return tuple(_finding(numbers, nu) for nu in range(1, numbers.order + 1))


def _finding(numbers: ScalarNumbers, nu: int) -> Finding:
    operator, product = scaled(numbers.p, nu), numbers.best_product
    if product is not None and product.compare(Fraction(1, numbers.p ** (nu - 1))) >= 0:
        statement = f"{operator} does not contract: {excess(product, numbers, nu - 1)}"
        return _answer(Verdict.REFUTED, statement, {"nu": nu, **product_witness(product)})
    norms = numbers.norms(nu)
    level = next((level for level, norm in enumerate(norms, 1) if norm < 1), None)
    if level is None:
        lowest = f"the lowest is {number(min(norms))}" if norms else "not one was computed"
        reason = f"the norms up to level {len(norms)} are not below 1 ({lowest}); a higher effort computes more"
        statement = f"does {operator} contract?"
        return _answer(Verdict.UNDECIDED, statement, {"nu": nu, "norms": norms}, reason=reason)
    norms = norms[:level]
    statement = f"{power(operator, level)} = {number(norms[-1])} < 1, so the limit functions are C^{nu - 1}"
    if level > 1:
        rate = certain(ball(norms[-1]) ** (ball(1) / level), 4)
        statement += f" (norms from L = 1: {series(norms, number)}; rate {rate})"
    return _answer(
        Verdict.PROVED,
        statement,
        {"nu": nu, "level": level, "norm": norms[-1], "norms": norms},
        value=interval(norms[-1]),
    )


def _answer(
    answer: Verdict, statement: str, witness: dict[str, Data], reason: str | None = None, value: Interval | None = None
) -> Finding:
    return Finding(
        code="SD301",
        name="contractivity",
        verdict=answer,
        statement=statement,
        source="Dyn 1992, Theorems 3.2 and 3.4",
        reason=reason,
        value=value,
        witness=witness,
    )


def excess(product: Product, numbers: ScalarNumbers, exponent: int) -> str:
    """`the transition matrix T_0 of S_(Δ^4) has an eigenvalue of modulus 1/4 ≥ 1/4 = 2^-2`, for 2^-exponent."""
    p, total = numbers.p, exponent * len(product.word)
    threshold = number(Fraction(1, p**total)) + (f" = {p}^-{total}" if total else "")
    modulus = eigenvalue(product.eigenvalue).strip("|-")
    return f"{product_text(product)} of S_(Δ^{numbers.order}) has an eigenvalue of modulus {modulus} ≥ {threshold}"


def product_text(product: Product) -> str:
    """`the transition matrix T_0` or `the product T_1T_0 of transition matrices`."""
    name = product_name(product.word)
    return f"the transition matrix {name}" if len(product.word) == 1 else f"the product {name} of transition matrices"


def product_witness(product: Product) -> dict[str, Data]:
    """A word and an eigenvalue of its product."""
    return {"word": product.word, **eigenvalue_witness(product.eigenvalue)}


def eigenvalue_witness(x: AlgebraicNumber) -> dict[str, Data]:
    """Minimal polynomial, lowest coefficient first, and the isolating box (real from, to, imaginary from, to)."""
    return {"minimal_polynomial": tuple(int(c) for c in x.minimal_polynomial), "box": x.box()}
