"""SD612: the largest n for which φ, and with it every limit function, is proved C^n. SD613: is C^(n+1) refuted?

Theorems. For isotropic M, λ = |det M|^(1/s) (Jia 1998; Han 2003): sum rules of order k > n and ρ_k < λ^-n give C^n;
stable φ ∈ C^n has sum rules of order > n and ρ_k < λ^-n for every order k > n of its sum rules. Box splines (SD603):
C^n iff n <= d - 2, whatever their stability. Tensor products (SD609): iff all factors are. Hypotheses: M isotropic,
checked (others are skipped); stability (SD616), for refutations that are not of box splines.

In the mean, ρ_k² is at most m Λ, Λ the growth of the mean squares of differences (SD617). Where neither tells, a matrix
scheme of differences (SD606) or quotients by pairs of directional factors (SD607) may.

Witness: `order`; `by`, SD605, SD617, SD606, SD607, SD609 or SD603; SD613: `by`, SD603, SD609, SD602 (the sum rules are
too few) or
SD605 with `word`.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.jsr.products import Product
from subdiv_cli.kinds.kind import Facts, Part
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.stages import tensor_products
from subdiv_cli.kinds.multivariate.stages.rule import ANISOTROPIC, growth_proof, not_spanning, spanning
from subdiv_cli.kinds.scalar.stages.stage import integer, product_name
from subdiv_cli.model import Data, Finding, Smoothness, Verdict, exact_root
from subdiv_cli.model import findings as questions

RULE = rules.SMOOTHNESS
NEXT = rules.NEXT_SMOOTHNESS

_QUESTION = "how smooth is φ?"


def run(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    if not numbers.is_normalised:
        return (RULE.skipped(_QUESTION, "the coefficients do not add up to |det M|, so there is no φ"),)
    if numbers.box is not None:
        return _of_box_spline(numbers.box.depth)
    if numbers.parts:
        return _of_parts(numbers.parts)
    if not numbers.lattice.is_isotropic:
        return (RULE.skipped(_QUESTION, ANISOTROPIC),)
    k = numbers.order
    if (
        numbers.radius is None
        and numbers.mean_decay is None
        and not (rules.MATRIX_NORMS in facts or rules.DIRECTIONAL_SMOOTHNESS in facts)
    ):
        return (RULE.undecided(_QUESTION, "no bound of the decay of differences is known"),)
    proved = [(n, by) for n in range(k) if (by := proved_by(numbers, facts, n)) is not None]
    stably = facts.verdict(rules.STABILITY) is Verdict.PROVED
    if not proved:
        if stably and (obstacle := _obstacle(numbers, 0)) is not None:
            return (RULE.refuted(f"φ is not continuous: φ is stable, and {obstacle}", _witness(numbers, 0)),)
        return (RULE.undecided(_QUESTION, "it is not proved that φ is continuous"),)
    n, by = proved[-1]
    proof = growth_proof(numbers) if by == rules.SOBOLEV.code else None
    first = _proved(n, _reason(numbers, n, by), by, proof)
    obstacle = _obstacle(numbers, n + 1)
    if obstacle is None or not stably:
        why = "it is not proved that φ is stable" if obstacle else "no product is known that excludes it"
        return (first, NEXT.undecided(f"is φ C^{n + 1}?", why))
    statement = f"φ is not C^{n + 1}: φ is stable, and {obstacle}"
    return (first, NEXT.refuted(statement, _witness(numbers, n + 1)))


def _of_box_spline(depth: int) -> tuple[Finding, ...]:
    enough, few = spanning(depth - 1), not_spanning(depth)
    if depth < 2:
        return (RULE.refuted(f"φ is not continuous: {few}", _by(0, rules.BOX_SPLINE.code)),)
    return (
        _proved(depth - 2, enough, rules.BOX_SPLINE.code),
        NEXT.refuted(f"φ is not C^{depth - 1}: {few}", _by(depth - 1, rules.BOX_SPLINE.code)),
    )


def _of_parts(parts: tuple[Part, ...]) -> tuple[Finding, ...]:
    found, part = tensor_products.of_all(parts, questions.SMOOTHNESS)
    if found is Verdict.REFUTED:
        return (
            RULE.refuted(f"φ is not continuous: its factor in {part.name} is not", _by(0, rules.TENSOR_PRODUCT.code)),
        )
    if found is Verdict.UNDECIDED:
        return (RULE.undecided(_QUESTION, f"it is not decided for the factor in {part.name}"),)
    orders = [(_order(part.finding(questions.SMOOTHNESS)), part) for part in parts]
    n = min(order for order, _ in orders)
    first = _proved(n, "its factors are", rules.TENSOR_PRODUCT.code)
    for order, part in orders:
        following = part.find(questions.NEXT_SMOOTHNESS)
        if order == n and following is not None and following.verdict is Verdict.REFUTED:
            statement = f"φ is not C^{n + 1}: its factor in {part.name} is not"
            return (first, NEXT.refuted(statement, _by(n + 1, rules.TENSOR_PRODUCT.code)))
    return (first, NEXT.undecided(f"is φ C^{n + 1}?", "it is not excluded for any factor"))


def _proved(n: int, why: str, by: str, proof: dict[str, Data] | None = None) -> Finding:
    answers = {questions.SMOOTHNESS: Smoothness(n)}
    return RULE.proved(f"φ is C^{n}: {why}", _by(n, by), proof=proof, answers=answers)


def _order(found: Finding) -> int:
    order = found.witness["order"]
    assert isinstance(order, int)
    return order


def _by(order: int, code: str) -> dict[str, int | str]:
    return {"order": order, "by": code}


def _reason(numbers: MultivariateNumbers, n: int, by: str) -> str:
    if by == rules.DIRECTIONAL_SMOOTHNESS.code:
        return "the quotients by two directional factors contract"
    if by == rules.MATRIX_NORMS.code:
        return "a matrix scheme of differences contracts"
    mean = ", by the mean squares of differences" if by == rules.SOBOLEV.code else ""
    return f"ρ_{numbers.order} < {threshold(numbers, n)}{mean}"


def threshold(numbers: MultivariateNumbers, n: int) -> str:
    """λ^-n in words: `1`, `λ^-2, λ = 3`, `λ^-1, λ = √2`."""
    if n == 0:
        return "1"
    m, s = numbers.lattice.index, numbers.dimension
    root = exact_root(m, s)
    return f"λ^-{n}, " + (f"λ = {root}" if root is not None else f"λ = √{m}" if s == 2 else f"λ^{s} = {m}")


def proved_by(numbers: MultivariateNumbers, facts: Facts, n: int) -> str | None:
    """The code of what proves C^n: ρ_k < λ^-n, by x^s m^(n length) < 1 for ρ_k^length <= x; or norms."""
    bounds = {
        rules.DIFFERENCE_RADIUS.code: numbers.radius and numbers.radius.upper,
        rules.SOBOLEV.code: (2, numbers.mean_decay),
    }
    for code, pair in bounds.items():
        if pair is not None and (bound := pair[1]) is not None:
            length = pair[0]
            if bound**numbers.dimension * numbers.lattice.index ** (n * length) < 1:
                return code
    if rules.DIRECTIONAL_SMOOTHNESS in facts and n <= 1:
        return rules.DIRECTIONAL_SMOOTHNESS.code
    return (
        rules.MATRIX_NORMS.code
        if rules.MATRIX_NORMS in facts and n <= integer(facts[rules.MATRIX_NORMS], "smooth")
        else None
    )


def reaches(numbers: MultivariateNumbers, product: Product, n: int) -> bool:
    """Whether the product proves ρ_k >= λ^-n: its s-th power has an eigenvalue of modulus at least m^(-n length)."""
    assert numbers.space is not None
    power = Product.of_word(numbers.space.matrices, product.word * numbers.dimension)
    return power.eigenvalue.compare_modulus(Fraction(1, numbers.lattice.index ** (n * len(product.word)))) >= 0


def _obstacle(numbers: MultivariateNumbers, n: int) -> str | None:
    k, product = numbers.order, numbers.product
    if n >= k:
        return f"C^{n} needs sum rules of order {n + 1}, but the mask has order {k}"
    if product is not None and reaches(numbers, product, n):
        return f"{product_name(product.word)} keeps ρ_{k} ≥ {threshold(numbers, n)}"
    return None


def _witness(numbers: MultivariateNumbers, n: int) -> dict[str, int | str]:
    return _by(n, rules.SUM_RULES.code if n >= numbers.order else rules.DIFFERENCE_RADIUS.code)
