"""SD313: is the Hölder exponent attained?

With n the largest integer below α: is the n-th derivative of φ Hölder continuous with exponent α - n itself
(Lipschitz, where α = n + 1), or only with every smaller one? Theorem (Rioul 1992; Dyn 1992, section 3): for stable φ
and an α that is no integer it is iff all products of L transition matrices of D = S_(Δ^k) have norms <= C p^(-αL);
for an integer α = m iff those of S_(Δ^m) have, because differences of order m bounded by C h^m mean a Lipschitz
derivative of order m - 1, while those of higher order mean less. Hypotheses: α known exactly and positive (SD311,
SD312), φ stable or reduced to a stable one (SD402, SD403): checked.

Proved by what closes the radius at exactly its value, when α is no integer (a polytope is the unit ball of a norm; a
norm ‖D^L‖ = ρ^L; simple eigenvalues where the symbol is not negative), or by ‖S_m^L‖∞ <= 1 for some L where α = m.
Refuted by a product with a Jordan block at an eigenvalue of modulus p^(-αℓ): its powers grow like L p^(-αℓL).

Witness: `nu`; proved: `by`, `radius` or `norm` with `level` and `norm` of ((1/p)S_ν)^level. Refuted: `word`, `sign`,
`value` and `vector`: y with (Π - sign·value)² y = 0 and (Π - sign·value) y ≠ 0.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import islice

from flint import fmpq_mat

from subdiv_cli.exact.linalg import identity, nullspace
from subdiv_cli.exact.rationals import to_fmpq
from subdiv_cli.exact.text import number
from subdiv_cli.jsr.family import Family, Word
from subdiv_cli.jsr.products import lyndon_words
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.norms import power_norms
from subdiv_cli.kinds.scalar.numbers.operators import transition_matrices
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.stage import power, product_name
from subdiv_cli.model import Data, Finding, Verdict

RULE = rules.HOLDER_ATTAINED

_QUESTION = "is the Hölder exponent attained?"
_LEVELS = 6
_WORDS = 5
_WORK = 4000


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    return (_decide(numbers.reduced, facts),)


def _decide(numbers: ScalarNumbers, facts: Facts) -> Finding:
    lower = facts.all(rules.HOLDER_LOWER)
    exact = lower[0].closed if lower else None
    value = lower[0].value if lower else None
    if exact is None or value is None or facts.verdict(rules.HOLDER_UPPER) is not Verdict.PROVED:
        return RULE.skipped(_QUESTION, "α is not known exactly")
    if value.upper is None or value.upper <= 0:
        return RULE.skipped(_QUESTION, "φ is not continuous")
    if isinstance(exact, Fraction) and exact.denominator == 1:
        return _integer(numbers, int(exact))
    return _fractional(numbers)


def _integer(numbers: ScalarNumbers, m: int) -> Finding:
    """α = m: products of S_(Δ^m)."""
    what = {1: "φ", 2: "φ'", 3: "φ''"}.get(m, f"φ^({m - 1})")
    if (found := _contractive_level(numbers, m)) is not None:
        level, norm = found
        shown = power(f"{numbers.name}_{m}", level)
        statement = f"α = {m} is attained: {what} is Lipschitz, as {shown} = {number(norm * numbers.p**level)} ≤ 1"
        return RULE.proved(statement, {"nu": m, "by": "norm", "level": level, "norm": norm})
    if (defect := _defect(numbers, m, Fraction(1, numbers.p**m))) is not None:
        return _refuted(f"α = {m} is not attained: {what} is not Lipschitz", numbers, m, defect)
    operator = f"{numbers.name}_(Δ^{m})"
    if (radius := _closed(numbers, m)) is not None:
        body = f"an invariant polytope of {radius.vertices} vertices"
        statement = f"α = {m} is attained: {what} is Lipschitz, as {body} bounds the products of {operator}"
        return RULE.proved(statement, {"nu": m, "by": "radius"}, proof=radius.proof)
    reason = f"no norm of {numbers.name}_{m} is at most 1, and no short product of {operator} has a Jordan block"
    return RULE.undecided(_QUESTION, reason)


def _fractional(numbers: ScalarNumbers) -> Finding:
    radius, k = numbers.radius, numbers.order
    assert radius is not None
    assert radius.exact is not None
    operator = f"{numbers.name}_(Δ^{k})"
    if radius.bounded:
        statement = f"α is attained: all products of L transition matrices of {operator} are bounded by C p^(-αL)"
        if radius.proof["rule"] == "norm":
            level, norm = radius.upper
            scaled = norm * numbers.p ** ((k - 1) * level)
            return RULE.proved(statement, {"nu": k, "by": "norm", "level": level, "norm": scaled})
        return RULE.proved(statement, {"nu": k, "by": "radius"})
    length, root = radius.exact
    if root.low == root.high and length == 1 and (found := _defect(numbers, k, root.low)) is not None:
        return _refuted("α is not attained", numbers, k, found)
    return RULE.undecided(_QUESTION, f"boundedness of the products of {operator} at the radius is not decided")


def _contractive_level(numbers: ScalarNumbers, m: int) -> tuple[int, Fraction] | None:
    """(L, ‖((1/p)S_m)^L‖) with a norm <= p^-L, m <= k."""
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
    """(word, sign, value, y): a short product Π of S_(Δ^ν) with a Jordan block at sign·value, value = radius^ℓ."""
    if not 1 <= nu <= numbers.order:
        return None
    family = Family(transition_matrices(numbers.difference(nu), numbers.p))
    if not numbers.effort.allows(_WORDS * family.order**3):
        return None
    for word in _words(numbers):
        product, value = family.product(word), radius ** len(word)
        for sign in (1, -1):
            if (vector := _generalised(product, sign * value)) is not None:
                return word, sign, value, vector
    return None


def _words(numbers: ScalarNumbers) -> Iterator[Word]:
    yield from islice(lyndon_words(numbers.p), _WORDS)
    if numbers.radius is not None and numbers.radius.word is not None:
        yield numbers.radius.word


def _generalised(product: fmpq_mat, eigenvalue: Fraction) -> tuple[Fraction, ...] | None:
    """y with (Π - λ)² y = 0 and (Π - λ) y ≠ 0."""
    shifted = product - identity(product.nrows()) * to_fmpq(eigenvalue)
    if shifted.rank() == product.nrows():
        return None
    for y in nullspace(shifted * shifted):
        if any((shifted * fmpq_mat([[to_fmpq(x)] for x in y])).entries()):
            return y
    return None


def _refuted(statement: str, numbers: ScalarNumbers, nu: int, found: _Defect) -> Finding:
    word, sign, value, vector = found
    matrix = product_name(word)
    shown = f"{'-' if sign < 0 else ''}{number(value)}"
    reason = f"{matrix} of {numbers.name}_(Δ^{nu}) has a Jordan block at the eigenvalue {shown}"
    witness: dict[str, Data] = {"nu": nu, "word": word, "sign": sign, "value": value, "vector": vector}
    return RULE.refuted(f"{statement}: {reason}", witness)
