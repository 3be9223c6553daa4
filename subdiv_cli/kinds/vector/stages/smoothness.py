"""Stages on smoothness and the Hölder exponent of the limits (SD707 to SD713)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import islice

from flint import ctx, fmpq_mat

from subdiv_cli.exact.closed import closed_interval, exponent, worded
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.linalg import rows_of
from subdiv_cli.exact.text import number, rounded_down, rounded_up, valued
from subdiv_cli.jsr.family import Word
from subdiv_cli.jsr.products import WordProduct, lyndon_words, radius_bound
from subdiv_cli.kinds.growth import SequenceGrowth
from subdiv_cli.kinds.kind import Facts, asking
from subdiv_cli.kinds.radius import shown
from subdiv_cli.kinds.scalar.stages.holder import defect
from subdiv_cli.kinds.scalar.stages.joint_radius import threshold
from subdiv_cli.kinds.scalar.stages.wording import product_name
from subdiv_cli.kinds.vector.numbers.derived import Derivation
from subdiv_cli.kinds.vector.numbers.vector import VectorNumbers
from subdiv_cli.kinds.vector.rules import (
    CONVERGENCE,
    DERIVED_SCHEMES,
    HOLDER_ATTAINED,
    HOLDER_LOWER,
    HOLDER_UPPER,
    NEXT_SMOOTHNESS,
    SMOOTHNESS,
    STENCIL_RADIUS,
)
from subdiv_cli.kinds.vector.stages.convergence import TOO_LARGE, radius_finding, space_data
from subdiv_cli.kinds.vector.witnesses import (
    VectorAttainedProof,
    VectorAttainedWitness,
    VectorDerivedProof,
    VectorDerivedWitness,
    VectorHolderLowerWitness,
    VectorHolderUpperWitness,
    VectorNextSmoothnessWitness,
)
from subdiv_cli.model import Finding, Interval, Root, Smoothness, Verdict, logarithm
from subdiv_cli.model import findings as questions
from subdiv_cli.model.proofs import root_data

_DIVERGES = "it is not proved that S converges"
_RADIUS_QUESTION = "how fast do differences of the limits decay?"


@asking((STENCIL_RADIUS, _RADIUS_QUESTION))
def stencil_radius(numbers: VectorNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD707: ρ_k, the joint spectral radius of the T_ε on V_k(w).

    V_k(w) is the smallest space that holds the k-th differences ∇^k w_i of the limit stencils and is mapped into itself
    by the T_ε: their images are the k-th differences of the limits (spaces/stencils.py). On its recurrent part the
    radius is the same. k is the order of the eigen-sequences (SD702), or a larger one where the limits are smoother,
    so that the exponent of the limits is below k. Found and proved as SD310 says. Hypothesis, convergence: checked.

    Witness: `order`, k; `dimension`; `method`; `word` of a product; `length` and `bound`, or `length` and `root`.
    `proof`: `space` and `radius`.
    """
    if facts.verdict(CONVERGENCE) is not Verdict.PROVED:
        return (STENCIL_RADIUS.skipped(_RADIUS_QUESTION, _DIVERGES),)
    if (growth := numbers.growth) is None:
        return (STENCIL_RADIUS.undecided(_RADIUS_QUESTION, TOO_LARGE),)
    return (radius_finding(STENCIL_RADIUS, growth, f"ρ_{growth.order}", space_data(growth.on)),)


_SMOOTHNESS_QUESTION = "how smooth are the limits?"


@asking((SMOOTHNESS, _SMOOTHNESS_QUESTION))
def smoothness(numbers: VectorNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD708: the largest n for which all limits are proved C^n. SD709: they are not all C^(n+1).

    Theorem 3 of spaces/stencils.py: of a scheme that converges, all limits are C^n if ρ_k < p^-n for a k > n; and only
    if, as k-th differences of functions in C^n are o(p^-nL) on the grids of level L. In C^n, n >= k, they are
    O(p^-kL), so that ρ_k > p^-k excludes it. No stability is needed. Hypothesis, convergence (SD705): checked. No
    scheme has limits that are C^∞, since those of e_l δ have compact support: some ρ_k is above p^-k.

    Witness: `order`; `by`, SD707 or, for n = 0, SD705; SD709: `order`, and the `word` of a product.
    """
    if facts.verdict(CONVERGENCE) is not Verdict.PROVED:
        return (SMOOTHNESS.skipped(_SMOOTHNESS_QUESTION, _DIVERGES),)
    growth, p = _known(numbers, facts), numbers.p
    orders = () if growth is None else range(1, growth.order)
    below = [n for n in orders if growth is not None and growth.radius.is_below(Fraction(1, p**n))]
    n = max(below, default=0)
    if growth is None or not n:
        first = _proved(0, "ρ_1 < 1", CONVERGENCE.code)
    else:
        first = _proved(n, f"ρ_{growth.order} < {threshold(p, n)}", STENCIL_RADIUS.code)
    question = f"are all limits C^{n + 1}?"
    if growth is None:
        return (first, NEXT_SMOOTHNESS.undecided(question, facts[STENCIL_RADIUS].reason or TOO_LARGE))
    product, k = growth.product, growth.order
    if product is None or not _excludes(product, p, k, n + 1):
        return (first, NEXT_SMOOTHNESS.undecided(question, "no product is known that excludes it"))
    size = f"≥ {threshold(p, n + 1)}" if n + 1 < k else f"> {threshold(p, k)}"
    why = f"{product_name(product.word)} keeps ρ_{k} {size}"
    witness: VectorNextSmoothnessWitness = {"order": n + 1, "by": STENCIL_RADIUS.code, "word": product.word}
    return (first, NEXT_SMOOTHNESS.refuted(f"not all limits are C^{n + 1}: {why}", witness, why=why))


def _known(numbers: VectorNumbers, facts: Facts) -> SequenceGrowth | None:
    return numbers.growth if facts.verdict(STENCIL_RADIUS) is Verdict.PROVED else None


def _proved(n: int, why: str, by: str) -> Finding:
    answers = {questions.SMOOTHNESS: Smoothness(n)}
    return SMOOTHNESS.proved(f"all limits are C^{n}: {why}", {"order": n, "by": by}, answers=answers, why=why)


def _excludes(product: WordProduct, p: int, k: int, n: int) -> bool:
    """Whether a product keeps ρ_k >= p^-n, n < k, or ρ_k > p^-k."""
    return product.compare(Fraction(1, p**n)) >= 0 if n < k else product.compare(Fraction(1, p**k)) > 0


_BELOW, _ABOVE = "how regular are the limits at least?", "how regular are the limits at most?"


@asking((HOLDER_LOWER, _BELOW), (HOLDER_UPPER, _ABOVE))
def holder(numbers: VectorNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD710: the Hölder exponent of the limits from below. SD711: from above.

    Theorem 3 of spaces/stencils.py: of a scheme that converges α = -log_p ρ_k, the largest number with all limits in
    C^(α-ε) for all ε > 0, as soon as this is below k; otherwise α >= k. A product of ℓ operators with an eigenvalue of
    modulus r > p^-kℓ bounds α <= -log_p(r)/ℓ. No stability is needed. Hypothesis, convergence (SD705): checked.

    Witness: `length`, with `root` where ρ_k^length is known, else with `bound`; from above `word`, `length` and
    `radius`, a rational lower bound of ρ_k^length.
    """
    if facts.verdict(CONVERGENCE) is not Verdict.PROVED:
        return (HOLDER_LOWER.skipped(_BELOW, _DIVERGES), HOLDER_UPPER.skipped(_ABOVE, _DIVERGES))
    if (growth := _known(numbers, facts)) is None:
        reason = facts[STENCIL_RADIUS].reason or TOO_LARGE
        return (HOLDER_LOWER.undecided(_BELOW, reason), HOLDER_UPPER.undecided(_ABOVE, reason))
    return (_lower(numbers, growth), _upper(numbers, growth))


def is_exponent(growth: SequenceGrowth, p: int) -> bool:
    """Whether the radius is known and proved to be above p^-k: then -log_p of it is the exponent."""
    if growth.radius.exact is None:
        return False
    length, root = growth.radius.exact
    return root.low > Fraction(1, p ** (growth.order * length))


def _lower(numbers: VectorNumbers, growth: SequenceGrowth) -> Finding:
    radius, p, k = growth.radius, numbers.p, growth.order
    if radius.exact is not None and is_exponent(growth, p):
        exact, why = exponent(p, *radius.exact), f"ρ_{k} = {shown(radius)}"
        witness: VectorHolderLowerWitness = {"length": radius.exact[0], "root": root_data(radius.exact[1])}
        return HOLDER_LOWER.proved(f"α = {worded(exact)}, as {why}", witness, closed_interval(exact), exact, why=why)
    length, bound = radius.upper
    bound = max(bound, Fraction(1, p ** (k * length)))
    with ctx.workprec(128):
        lower = interval(-ball(bound).log() / ball(p).log() / length).lower
    why = f"from the bound of ρ_{k}"
    statement = f"α ≥ {rounded_down(lower or 0.0)}, {why}"
    return HOLDER_LOWER.proved(statement, {"length": length, "bound": bound}, Interval(lower=lower), why=why)


def _upper(numbers: VectorNumbers, growth: SequenceGrowth) -> Finding:
    product, p, k = growth.product, numbers.p, growth.order
    if product is None or product.compare(Fraction(1, p**k)) <= 0:
        return HOLDER_UPPER.undecided(_ABOVE, f"no product is known that keeps ρ_{k} above {p}^-{k}")
    bound, length = radius_bound(product), len(product.word)
    upper = closed_interval(logarithm(p, 1 / bound, length)).upper
    exact = growth.radius.exact if is_exponent(growth, p) else None
    text = rounded_up(upper or 0.0) if exact is None else worded(exponent(p, *exact))
    why = f"{product_name(product.word)} bounds ρ_{k} from below"
    witness: VectorHolderUpperWitness = {"word": product.word, "length": length, "radius": bound}
    return HOLDER_UPPER.proved(f"α ≤ {text}: {why}", witness, Interval(upper=upper), why=why)


_ATTAINED_QUESTION = "is the Hölder exponent attained?"
_WORDS = 5


@asking((HOLDER_ATTAINED, _ATTAINED_QUESTION))
def holder_attained(numbers: VectorNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD712: whether the Hölder exponent is attained.

    With n the largest integer below α: are the n-th derivatives of all limits Hölder continuous with exponent α - n
    itself (Lipschitz, where α = n + 1)? Theorem 4 of spaces/stencils.py: if α is no integer, iff all products of L
    operators on V_k(w), k > α, are O(p^-αL); if α = m, iff those on V_m(w) are. Hypothesis, α known exactly: checked.

    Proved by what closes the radius at exactly its value, refuted by a product with a Jordan block at an eigenvalue of
    that modulus.

    Witness: `order` of the differences; refuted: `word`, `sign`, `value` and `vector`, as SD313 has them. `proof`: the
    `space` and, where proved, the `radius`.
    """
    lower = facts.find(HOLDER_LOWER)
    exact = lower.closed if lower is not None else None
    growth = _known(numbers, facts)
    if exact is None or growth is None:
        return (HOLDER_ATTAINED.skipped(_ATTAINED_QUESTION, "α is not known exactly"),)
    if isinstance(exact, Fraction) and exact.denominator == 1:
        m = int(exact)
        of = {1: "limits", 2: "derivatives of limits", 3: "second derivatives of limits"}
        what = f"{of.get(m, f'derivatives of order {m - 1} of limits')} are Lipschitz"
        yes, no = f"α = {m} is attained: all {what}", f"α = {m} is not attained: not all {what}"
        return (_attained(numbers, numbers.growth_of(m), Fraction(1, numbers.p**m), yes, no),)
    return (_attained(numbers, growth, None, "α is attained", "α is not attained"),)


def _attained(
    numbers: VectorNumbers, growth: SequenceGrowth | None, radius: Fraction | None, yes: str, no: str
) -> Finding:
    """The finding by the products on a space whose radius is p^-α; `radius` is that where it is rational."""
    unknown = "boundedness of the products at the radius is not decided"
    if growth is None or growth.radius.exact is None:
        return HOLDER_ATTAINED.undecided(_ATTAINED_QUESTION, unknown)
    length, root = growth.radius.exact
    if radius is not None and radius**length != root.low:
        return HOLDER_ATTAINED.undecided(_ATTAINED_QUESTION, unknown)
    k, space = growth.order, space_data(growth.on)
    if radius is None and root.low == root.high and length == 1:
        radius = root.low
    block = None if radius is None else _defect(growth, radius)
    if block is None:
        bounded = numbers.bounded(growth)
        if bounded is None or bounded.exact is None or not _same(bounded.exact, growth.radius.exact):
            return HOLDER_ATTAINED.undecided(_ATTAINED_QUESTION, unknown)
        why = f"all products of L operators on V_{k}(w) are O(ρ_{k}^L)"
        proof: VectorAttainedProof = {"space": space, "radius": bounded.proof}
        return HOLDER_ATTAINED.proved(f"{yes}, as {why}", {"order": k}, proof=proof, why=why)
    word, sign, value, vector = block
    at = f"{'-' if sign < 0 else ''}{number(value)}"
    why = f"{product_name(word)} on V_{k}(w) has a Jordan block at the eigenvalue {at}"
    witness: VectorAttainedWitness = {"order": k, "word": word, "sign": sign, "value": value, "vector": vector}
    refutation: VectorAttainedProof = {"space": space}
    return HOLDER_ATTAINED.refuted(f"{no}: {why}", witness, why=why, proof=refutation)


def _same(one: tuple[int, Root], other: tuple[int, Root]) -> bool:
    """Whether these are one radius: the same root, or rational ones."""
    rational = one[1].low == one[1].high and other[1].low == other[1].high
    return one == other or (rational and one[1].low ** other[0] == other[1].low ** one[0])


def _defect(growth: SequenceGrowth, radius: Fraction) -> tuple[Word, int, Fraction, tuple[Fraction, ...]] | None:
    matrices = growth.on.space.matrices
    for word in _words(growth, len(matrices)):
        if (block := defect(WordProduct.of_word(matrices, word).matrix, radius ** len(word))) is not None:
            return (word, *block)
    return None


def _words(growth: SequenceGrowth, letters: int) -> Iterator[Word]:
    yield from islice(lyndon_words(letters), _WORDS)
    if growth.radius.word is not None:
        yield growth.radius.word


_DERIVATIONS = 6
"""The most derived schemes where it is not known how smooth the limits are."""


_DERIVED_QUESTION = "does a derived scheme contract?"


@asking((DERIVED_SCHEMES, _DERIVED_QUESTION))
def derived_schemes(numbers: VectorNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD713: derived schemes that contract, a second proof of convergence and smoothness.

    Theorems 9 and 11 of Moosmüller & Dyn 2018 (numbers/derived.py has them for any arity): S is C^(n-1) if the n-th
    scheme that is derived from it contracts, ‖((1/p) S_(∂^n A))^L‖∞ < 1 for some L. Every derivation needs a canonical
    transformation: 1 is an eigenvalue of M_A exactly as often as E_A has dimensions, checked each time. No hypothesis
    beyond; it is sufficient, so that SD708 may say more.

    Witness: `derivations`, n; `level` and `norm`; `order`, n - 1. `proof`: `transformations` by rows, the
    `dimensions`, and the derived `masks`, each with its `starts`.
    """
    if not numbers.constants:
        return (DERIVED_SCHEMES.skipped(_DERIVED_QUESTION, "there is no derived scheme: E_A = 0"),)
    if facts.verdict(CONVERGENCE) is Verdict.REFUTED:
        return (DERIVED_SCHEMES.skipped(_DERIVED_QUESTION, "S does not converge"),)
    derivation = numbers.derivation(most_derivations(facts))
    n = derivation.contracting
    if not n:
        reason = NOT_CONTRACTING if derivation.steps else "M_A has no canonical transformation"
        return (DERIVED_SCHEMES.undecided(_DERIVED_QUESTION, reason),)
    why, (level, norm) = contracts(numbers.p, derivation, "A")
    witness: VectorDerivedWitness = {"derivations": n, "level": level, "norm": norm, "order": n - 1}
    proof = derived_masks(derivation)
    return (DERIVED_SCHEMES.proved(f"S is C^{n - 1}, as {why}", witness, proof=proof, why=why),)


NOT_CONTRACTING = "no norm of it is seen to be below 1"


def most_derivations(facts: Facts) -> int:
    """The most derivations that may help: the limits are not C^n if SD709 says so."""
    refuted = facts.verdict(NEXT_SMOOTHNESS) is Verdict.REFUTED
    return facts.witness(NEXT_SMOOTHNESS)["order"] if refuted else _DERIVATIONS


def contracts(p: int, derivation: Derivation, mask: str) -> tuple[str, tuple[int, Fraction]]:
    """The norm of the last scheme that contracts, of those derived from this mask, as text, and itself."""
    n = derivation.contracting
    norm = derivation.steps[n - 1].norm
    assert norm is not None
    operator = f"{p}^-1 S_(∂^{n} {mask})" if n > 1 else f"{p}^-1 S_(∂{mask})"
    size = f"‖{operator}‖∞" if norm[0] == 1 else f"‖({operator})^{norm[0]}‖∞"
    return f"{size} = {valued(norm[1])} < 1", norm


def derived_masks(derivation: Derivation) -> VectorDerivedProof:
    """The derived masks up to the last one that contracts, as certificates need them."""
    steps = derivation.steps[: derivation.contracting]
    return {
        "transformations": tuple(rows_of(step.transformation) for step in steps),
        "dimensions": tuple(step.constants for step in steps),
        "starts": tuple(min(step.terms) for step in steps),
        "masks": tuple(tuple(map(rows_of, dense(step.terms))) for step in steps),
    }


def dense(terms: Mapping[int, fmpq_mat]) -> list[fmpq_mat]:
    """The matrices of a mask from its first index to its last."""
    zero = next(iter(terms.values())) * 0
    return [terms.get(i, zero) for i in range(min(terms), max(terms) + 1)]
