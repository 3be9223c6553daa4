"""Stages on the Hölder exponent (SD311 to SD313)."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import islice

from flint import fmpq_mat

from subdiv_cli.exact.closed import closed_interval, exponent, worded
from subdiv_cli.exact.linalg import identity, nullspace
from subdiv_cli.exact.rationals import to_fmpq
from subdiv_cli.exact.text import modulus, number, rounded_down, rounded_up, valued
from subdiv_cli.jsr.family import Family, Word
from subdiv_cli.jsr.products import lyndon_words, radius_bound
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.kind import Facts, asking
from subdiv_cli.kinds.radius import shown
from subdiv_cli.kinds.scalar.numbers.estimate import estimated_exponent
from subdiv_cli.kinds.scalar.numbers.norms import power_norms
from subdiv_cli.kinds.scalar.numbers.operators import transition_matrices
from subdiv_cli.kinds.scalar.numbers.radius import exponent_bound
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.rules import HOLDER_ATTAINED, HOLDER_LOWER, HOLDER_UPPER, JOINT_RADIUS, SOBOLEV
from subdiv_cli.kinds.scalar.stages.decay import Decay, decays, logarithmic
from subdiv_cli.kinds.scalar.stages.joint_radius import product_text, put_product
from subdiv_cli.kinds.scalar.stages.wording import last_difference, no_sum_rule, power, product_name
from subdiv_cli.kinds.scalar.witnesses import HolderLowerWitness, HolderUpperWitness
from subdiv_cli.model import Exponent, Finding, Interval, Verdict
from subdiv_cli.model import findings as questions
from subdiv_cli.model.findings import best_of
from subdiv_cli.model.proofs import root_data

_HOLDER_LOWER_QUESTION = "how regular are the limit functions at least?"


@asking((HOLDER_LOWER, _HOLDER_LOWER_QUESTION))
def holder_lower(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD311: the Hölder exponent from below, the best bound of all that are proved.

    Theorem (Dyn 1992, section 3; Rioul 1992): with D = S_(Δ^k), k the sum-rule order, and ρ its joint spectral radius,
    α = -log_p ρ. If α > 0 all limit functions are in C^(α-ε) for every ε > 0; if α <= 0 it is the exponent of a
    distribution. Hypothesis k >= 1: checked. No stability is needed from below; an unstable mask is reduced first
    (SD403), which can only raise the bound. What is known of ρ is what SD310 proves: ρ^n = Λ, so that α = -log_p(Λ)/n,
    or ρ^n <= x, so that α >= -log_p(x)/n. Also x by the norms of SD301 and, of S itself, SD201; and α >= s - 1/2, s the
    Sobolev exponent (SD321; see decay.py).

    Witness: `difference_order`, k of the (reduced) mask; `radius_of`, S or S0; `length`, n; `bound`, x, or `root`, Λ
    (polynomial, the lowest power first, low, high). Instead of `radius_of`, where another finding gives more, its code
    as `by`, and `nu` where that has one.

    Raises ArithmeticError where the bound of α is no double.
    """
    reduced = numbers.reduced
    if reduced.order == 0:
        return (HOLDER_LOWER.skipped(_HOLDER_LOWER_QUESTION, no_sum_rule(reduced)),)
    exactly = [_exactly(reduced, reduced.radius)] if reduced.radius is not None and reduced.radius.exact else []
    bounds = [*exactly, *(_at_least(decay) for decay in decays(numbers, facts))]
    if not bounds:
        reason = "the effort ended before a bound of the joint spectral radius"
        return (HOLDER_LOWER.undecided(_HOLDER_LOWER_QUESTION, reason),)
    return (best_of(bounds),)


def _exactly(numbers: ScalarNumbers, radius: Radius) -> Finding:
    assert radius.exact is not None
    exact = exponent(numbers.p, *radius.exact)
    witness: HolderLowerWitness = {
        "difference_order": numbers.order,
        "radius_of": numbers.name,
        "length": radius.upper[0],
        "root": root_data(radius.exact[1]),
    }
    why = f"ρ({last_difference(numbers)}) = {shown(radius)}"
    statement = f"α = {worded(exact)}, as {why}"
    return HOLDER_LOWER.proved(statement, witness, closed_interval(exact), exact, why=why)


def _at_least(decay: Decay) -> Finding:
    lower = decay.exponent.lower or 0.0
    witness: HolderLowerWitness = {
        "difference_order": decay.numbers.order,
        "length": decay.length,
        "bound": decay.bound,
    }
    if decay.by is JOINT_RADIUS:
        witness["radius_of"] = decay.numbers.name
    else:
        witness["by"] = decay.by.code
        if decay.by is not SOBOLEV:
            witness["nu"] = decay.nu
    why = f"from the bound of {decay.shown}"
    return HOLDER_LOWER.proved(f"α ≥ {rounded_down(lower)}, {why}", witness, Interval(lower=lower), why=why)


_HOLDER_UPPER_QUESTION = "how regular is φ at most?"


@asking((HOLDER_UPPER, _HOLDER_UPPER_QUESTION))
def holder_upper(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD312: the Hölder exponent from above, the best bound of all that are proved.

    Theorem (Cavaretta, Dahmen & Micchelli 1991; Rioul 1992): for stable φ the exponent α = -log_p JSR(D), D = S_(Δ^k),
    is the best one. For any product of ℓ transition matrices of D with an eigenvalue λ, α <= -(1/ℓ) log_p |λ|; and α <=
    k always, and α <= s, the Sobolev exponent (SD321). Hypotheses: k >= 1, checked; stability: an unstable mask is
    reduced to a stable one first, whose exponent is that of φ (SD403).

    Witness: `difference_order`, k of the (reduced) mask, the product (see obstacles.py) and `radius`, a rational lower
    bound of |λ| from which the bound is computed (|λ| itself where it is rational or where SD311 proves that α is the
    number of this product), with `by`, SD312, where it is claimed without SD311; k alone where it is the better bound;
    `by`, SD321, with `length` 2 and `radius`, a lower bound of its λ, where that is.
    """
    numbers = numbers.reduced
    if numbers.order == 0:
        return (HOLDER_UPPER.skipped(_HOLDER_UPPER_QUESTION, no_sum_rule(numbers)),)
    below = facts[HOLDER_LOWER]
    lower = below.value.lower if below.value is not None and below.closed is None else None
    bounds: list[Finding] = []
    for upper, what, why, witness in sorted(_at_most(numbers), key=lambda bound: bound[0]):
        answer = Exponent(upper=upper, estimate=None if bounds else estimated_exponent(numbers, lower, upper))
        answers = {questions.HOLDER_UPPER: answer}
        bounds.append(HOLDER_UPPER.proved(what + why, witness, Interval(upper=upper), answers=answers, why=why))
    return (best_of(bounds),)


def _at_most(numbers: ScalarNumbers) -> Iterator[tuple[float, str, str, HolderUpperWitness]]:
    """The bounds with what they say, why, and their witnesses; of those that are equal the first one says most."""
    k, p, product = numbers.order, numbers.p, numbers.product
    bound = None if product is None else exponent_bound(product, p)
    if product is not None and bound is not None and bound.upper is not None:
        witness: HolderUpperWitness = {"difference_order": k}
        put_product(witness, product)
        witness["radius"] = radius_bound(product)
        size = modulus(product.eigenvalue)
        why = f"{product_text(product)} of {last_difference(numbers)} has an eigenvalue of modulus {size}"
        rounded = bound.exact or rounded_up(bound.upper)
        yield bound.upper, f"α ≤ {bound.exact or _exact(numbers) or rounded}: ", why, witness
        if numbers.radius is not None and numbers.radius.exact is not None:
            yield bound.upper, f"α ≤ {rounded}: ", why, {**witness, "by": HOLDER_UPPER.code}
    yield float(k), f"α ≤ {k}, ", "the sum-rule order", {"difference_order": k}
    if (growth := numbers.growth) is not None:
        upper = logarithmic(p, 2, growth.low).upper
        assert upper is not None
        mean: HolderUpperWitness = {"difference_order": k, "by": SOBOLEV.code, "length": 2, "radius": growth.low}
        yield upper, f"α ≤ {rounded_up(upper)}, ", "the Sobolev exponent", mean


def _exact(numbers: ScalarNumbers) -> str | None:
    """The bound as a text in closed form, where a product attains a radius that is known; else None."""
    radius = numbers.radius
    return None if radius is None or radius.exact is None else worded(exponent(numbers.p, *radius.exact))


_HOLDER_ATTAINED_QUESTION = "is the Hölder exponent attained?"
_LEVELS = 6
_WORDS = 5
_WORK = 4000


@asking((HOLDER_ATTAINED, _HOLDER_ATTAINED_QUESTION))
def holder_attained(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD313: whether the Hölder exponent is attained.

    With n the largest integer below α: is the n-th derivative of φ Hölder continuous with exponent α - n itself
    (Lipschitz, where α = n + 1), or only with every smaller one? Theorem (Rioul 1992; Dyn 1992, section 3): for stable
    φ and an α that is no integer it is iff all products of L transition matrices of D = S_(Δ^k) have norms <= C
    p^(-αL); for an integer α = m iff those of S_(Δ^m) have, because differences of order m bounded by C h^m mean a
    Lipschitz derivative of order m - 1, while those of higher order mean less. Hypotheses: α known exactly and positive
    (SD311, SD312), φ stable or reduced to a stable one (SD402, SD403): checked.

    Proved by what closes the radius at exactly its value, when α is no integer (a polytope is the unit ball of a norm;
    a norm ‖D^L‖ = ρ^L; simple eigenvalues where the symbol is not negative), or by ‖S_m^L‖∞ <= 1 for some L where α =
    m. Refuted by a product with a Jordan block at an eigenvalue of modulus p^(-αℓ): its powers grow like L p^(-αℓL).

    Witness: `nu`; proved: `by`, `radius` or `norm` with `level` and `norm` of ((1/p)S_ν)^level. Refuted: `word`,
    `sign`, `value` and `vector`: y with (Π - sign·value)² y = 0 and (Π - sign·value) y ≠ 0.
    """
    return (_decide(numbers.reduced, facts),)


def _decide(numbers: ScalarNumbers, facts: Facts) -> Finding:
    lower = facts.all(HOLDER_LOWER)
    exact = lower[0].closed if lower else None
    value = lower[0].value if lower else None
    if exact is None or value is None or facts.verdict(HOLDER_UPPER) is not Verdict.PROVED:
        return HOLDER_ATTAINED.skipped(_HOLDER_ATTAINED_QUESTION, "α is not known exactly")
    if value.upper is None or value.upper <= 0:
        return HOLDER_ATTAINED.skipped(_HOLDER_ATTAINED_QUESTION, "φ is not continuous")
    if isinstance(exact, Fraction) and exact.denominator == 1:
        return _integer(numbers, int(exact))
    return _fractional(numbers)


def _integer(numbers: ScalarNumbers, m: int) -> Finding:
    """The finding for an integer exponent α = m, decided by products of S_(Δ^m)."""
    what = {1: "φ", 2: "φ'", 3: "φ''"}.get(m, f"φ^({m - 1})")
    if (contraction := _contractive_level(numbers, m)) is not None:
        level, norm = contraction
        shown = power(f"{numbers.name}_{m}", level)
        why = f"{what} is Lipschitz, as {shown} = {valued(norm * numbers.p**level)} ≤ 1"
        return HOLDER_ATTAINED.proved(
            f"α = {m} is attained: {why}", {"nu": m, "by": "norm", "level": level, "norm": norm}, why=why
        )
    if (defect := _defect(numbers, m, Fraction(1, numbers.p**m))) is not None:
        return _refuted(f"α = {m} is not attained: ", f"{what} is not Lipschitz: ", numbers, m, defect)
    operator = f"{numbers.name}_(Δ^{m})"
    if (radius := _closed(numbers, m)) is not None:
        body = f"an invariant polytope of {radius.vertices} vertices"
        why = f"{what} is Lipschitz, as {body} bounds the products of {operator}"
        return HOLDER_ATTAINED.proved(
            f"α = {m} is attained: {why}", {"nu": m, "by": "radius"}, proof=radius.proof, why=why
        )
    reason = f"no norm of {numbers.name}_{m} is at most 1, and no short product of {operator} has a Jordan block"
    return HOLDER_ATTAINED.undecided(_HOLDER_ATTAINED_QUESTION, reason)


def _fractional(numbers: ScalarNumbers) -> Finding:
    radius, k = numbers.radius, numbers.order
    assert radius is not None
    assert radius.exact is not None
    operator = f"{numbers.name}_(Δ^{k})"
    if radius.bounded:
        why = f"all products of L transition matrices of {operator} are bounded by C p^(-αL)"
        statement = f"α is attained: {why}"
        if radius.proof["rule"] == "norm":
            level, norm = radius.upper
            scaled = norm * numbers.p ** ((k - 1) * level)
            return HOLDER_ATTAINED.proved(statement, {"nu": k, "by": "norm", "level": level, "norm": scaled}, why=why)
        return HOLDER_ATTAINED.proved(statement, {"nu": k, "by": "radius"}, why=why)
    length, root = radius.exact
    if root.low == root.high and length == 1 and (defect := _defect(numbers, k, root.low)) is not None:
        return _refuted("α is not attained: ", "", numbers, k, defect)
    return HOLDER_ATTAINED.undecided(
        _HOLDER_ATTAINED_QUESTION, f"boundedness of the products of {operator} at the radius is not decided"
    )


def _contractive_level(numbers: ScalarNumbers, m: int) -> tuple[int, Fraction] | None:
    """The pair (L, ‖((1/p)S_m)^L‖) with a norm <= p^-L, m <= k; None where no level has it."""
    if not 1 <= m <= numbers.order:
        return None
    symbol = numbers.difference(m).scale(numbers.p ** (m - 1))
    norms = islice(power_norms(symbol, numbers.p, numbers.effort.limited(_WORK)), _LEVELS)
    levels = ((level, norm) for level, norm in enumerate(norms, 1))
    return next(((level, norm) for level, norm in levels if norm * numbers.p**level <= 1), None)


def _closed(numbers: ScalarNumbers, m: int) -> Radius | None:
    """The radius of S_(Δ^m), where it is p^-m and its products are bounded by a polytope."""
    family = Family(transition_matrices(numbers.difference(m), numbers.p))
    if not 1 <= m <= numbers.order or not numbers.effort.allows(family.order**3):
        return None
    from subdiv_cli.jsr.radius import joint_spectral_radius  # numpy comes with it

    radius = joint_spectral_radius(family, numbers.effort.limited(_WORK))
    if radius is None or radius.exact is None or not radius.bounded:
        return None
    length, root = radius.exact
    return radius if root.low == root.high == Fraction(1, numbers.p ** (m * length)) else None


_Defect = tuple[Word, int, Fraction, tuple[Fraction, ...]]


def _defect(numbers: ScalarNumbers, nu: int, radius: Fraction) -> _Defect | None:
    """The word, sign, value and y of a short product Π of S_(Δ^ν) with a Jordan block at sign·value = ±radius^ℓ."""
    if not 1 <= nu <= numbers.order:
        return None
    family = Family(transition_matrices(numbers.difference(nu), numbers.p))
    if not numbers.effort.allows(_WORDS * family.order**3):
        return None
    for word in _words(numbers):
        if (block := defect(family.product(word), radius ** len(word))) is not None:
            return (word, *block)
    return None


def defect(product: fmpq_mat, value: Fraction) -> tuple[int, Fraction, tuple[Fraction, ...]] | None:
    """The sign, value and y of a Jordan block of a product at the eigenvalue sign·value; None where there is none."""
    for sign in (1, -1):
        if (vector := _generalised(product, sign * value)) is not None:
            return sign, value, vector
    return None


def _words(numbers: ScalarNumbers) -> Iterator[Word]:
    yield from islice(lyndon_words(numbers.p), _WORDS)
    if numbers.radius is not None and numbers.radius.word is not None:
        yield numbers.radius.word


def _generalised(product: fmpq_mat, eigenvalue: Fraction) -> tuple[Fraction, ...] | None:
    """A vector y with (Π - λ)² y = 0 and (Π - λ) y ≠ 0; None where there is none."""
    shifted = product - identity(product.nrows()) * to_fmpq(eigenvalue)
    if shifted.rank() == product.nrows():
        return None
    for y in nullspace(shifted * shifted):
        if any((shifted * fmpq_mat([[to_fmpq(x)] for x in y])).entries()):
            return y
    return None


def _refuted(what: str, why: str, numbers: ScalarNumbers, nu: int, defect: _Defect) -> Finding:
    word, sign, value, vector = defect
    matrix = product_name(word)
    shown = f"{'-' if sign < 0 else ''}{number(value)}"
    why += f"{matrix} of {numbers.name}_(Δ^{nu}) has a Jordan block at the eigenvalue {shown}"
    return HOLDER_ATTAINED.refuted(
        what + why, {"nu": nu, "word": word, "sign": sign, "value": value, "vector": vector}, why=why
    )
