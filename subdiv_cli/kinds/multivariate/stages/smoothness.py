"""Stages on convergence, stability and smoothness (SD605, SD611 to SD613, SD616)."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from subdiv_cli.exact.linalg import rows_of
from subdiv_cli.exact.text import rounded_up
from subdiv_cli.jsr.products import WordProduct
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.kind import ContradictionError, Facts, Part, asking
from subdiv_cli.kinds.multivariate.numbers.difference_space import DifferenceSpace
from subdiv_cli.kinds.multivariate.numbers.gram import LEAF, Gram
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.rules import (
    BOX_SPLINE,
    CONVERGENCE,
    COSET_SUMS,
    DIFFERENCE_RADIUS,
    DIRECTIONAL_NORMS,
    DIRECTIONAL_SMOOTHNESS,
    MATRIX_NORMS,
    NEXT_SMOOTHNESS,
    POSITIVE_MASK,
    SMOOTHNESS,
    SOBOLEV,
    STABILITY,
    STENCIL_RADIUS,
    SUBLATTICE,
    SUM_RULES,
    TENSOR_PRODUCT,
)
from subdiv_cli.kinds.multivariate.stages import products, stencils
from subdiv_cli.kinds.multivariate.stages.wording import ANISOTROPIC, growth_proof, not_spanning, spanning, threshold
from subdiv_cli.kinds.multivariate.witnesses import (
    DifferenceRadiusProof,
    DifferenceRadiusWitness,
    GramProof,
    GrowthProof,
    MultivariateConvergenceWitness,
    MultivariateSmoothnessWitness,
    MultivariateStabilityWitness,
    SpaceProof,
)
from subdiv_cli.kinds.radius import enclosed, put_radius, shown
from subdiv_cli.kinds.scalar.stages.wording import product_name
from subdiv_cli.model import Finding, Smoothness, Verdict
from subdiv_cli.model import findings as questions
from subdiv_cli.model.findings import best_of

_DIFFERENCE_RADIUS_QUESTION = "how fast do differences decay?"


@asking((DIFFERENCE_RADIUS, _DIFFERENCE_RADIUS_QUESTION))
def difference_radius(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD605: ρ_k, the joint spectral radius of the transition operators T_ε on V_k, k the order of the sum rules.

    V_k is the smallest space that holds the differences ∇^μ δ, |μ| = k, and is mapped into itself by the T_ε; its basis
    and the matrices are exact (numbers/difference_space.py, with the theorems on ρ_k). It is not the smallest invariant
    window with polynomials divided out: differences that cross windows count. The radius is found and proved as SD310
    says. Hypothesis, k >= 1: checked. Not asked of tensor products (SD609), nor where φ is a box spline (SD603) and
    convergence is proved without it (SD604, SD617).

    Witness: `order`, k; `dimension` of V_k; `method`; `word` of a product, as numbers of coset representatives;
    `length` and `bound`, or `length` and `root`: ρ_k^length is at most the bound, or is the root. `proof`: the space
    and the radius.
    """
    if not numbers.order:
        return (DIFFERENCE_RADIUS.skipped(_DIFFERENCE_RADIUS_QUESTION, "no sum rule holds"),)
    if numbers.parts:
        return (
            DIFFERENCE_RADIUS.skipped(_DIFFERENCE_RADIUS_QUESTION, "φ is a tensor product, and its factors decide"),
        )
    contracts = numbers.contractions is not None or ((mean := numbers.mean_decay) is not None and mean < 1)
    if numbers.box is not None and contracts:
        return (
            DIFFERENCE_RADIUS.skipped(
                _DIFFERENCE_RADIUS_QUESTION, "φ is a box spline, and S is seen to converge without it"
            ),
        )
    space, radius = numbers.space, numbers.radius
    if space is None:
        return (
            DIFFERENCE_RADIUS.undecided(
                _DIFFERENCE_RADIUS_QUESTION, f"the space V_{numbers.order} of differences is too large"
            ),
        )
    if radius is None:
        return (DIFFERENCE_RADIUS.undecided(_DIFFERENCE_RADIUS_QUESTION, "the effort ended before a bound"),)
    witness: DifferenceRadiusWitness = {
        "order": space.order,
        "dimension": space.basis.nrows(),
        "method": radius.proof["rule"],
    }
    put_radius(witness, radius)
    proof: DifferenceRadiusProof = {"space": _space_proof(space), "radius": radius.proof}
    value = enclosed(radius)
    size = f"≤ {rounded_up(value.upper or 0.0, 12)}" if radius.exact is None else f"= {shown(radius)}"
    statement = f"ρ_{space.order} {size} on V_{space.order} of dimension {space.basis.nrows()}{_how(radius)}"
    return (DIFFERENCE_RADIUS.proved(statement, witness, value, proof=proof),)


def _how(radius: Radius) -> str:
    parts = radius.proof.get("sizes")
    by = f": {len(parts)} diagonal blocks" if parts else ""
    attains = f", attained by {product_name(radius.word)}" if radius.exact is not None and radius.word else ""
    return by + attains


def _space_proof(space: DifferenceSpace) -> SpaceProof:
    """The space as certificates have it."""
    return {
        "order": space.order,
        "cosets": space.cosets,
        "window": space.window,
        "basis": tuple(tuple(int(x) for x in row) for row in rows_of(space.basis)),
        "matrices": tuple(rows_of(m) for m in space.matrices),
        "generators": rows_of(space.generators),
    }


_CONVERGENCE_QUESTION = "does S converge uniformly?"
_NORMS = {
    DIRECTIONAL_NORMS.code: "the directional differences contract",
    POSITIVE_MASK.code: "the mask is positive on a box",
    MATRIX_NORMS.code: "a matrix scheme of differences contracts",
    DIRECTIONAL_SMOOTHNESS.code: "the quotients by two directional factors contract",
}
"""The reasons of convergence with a few numbers, by the code of the finding."""


@asking((CONVERGENCE, _CONVERGENCE_QUESTION))
def convergence(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD611: whether S converges uniformly, to a limit that is not zero for some data.

    Theorem (Han & Jia 1998, Theorem 4.3, for any expanding M; numbers/difference_space.py for k > 1): S converges
    uniformly iff its coset sums are 1 and ρ_k < 1, k any order of its sum rules. No stability is needed. Also proved by
    directional difference schemes that contract (SD604), by a positive mask on a box (SD608), by a matrix scheme of
    differences that contracts (SD606), by quotients of two directional factors that contract (SD607), or in the mean:
    ρ_k² is at most m Λ, Λ the growth of the mean squares (SD617), m = |det M|; that is s > dimension/2 for its bound of
    s. It does not where φ is a box spline that is not continuous (SD603), nor where the mask stays in a lattice other
    than Z^s (SD620). Tensor products (SD609) converge iff all their factors do. Hypotheses: the coset sums (SD601).

    Witness: `by`, the code of the finding that decides.

    Raises ContradictionError where S converges and ρ_k is at least 1.
    """
    sums, decay = (facts.find(rule) for rule in (COSET_SUMS, DIFFERENCE_RADIUS))
    if sums is not None and sums.verdict is Verdict.REFUTED:
        statement = f"S does not converge uniformly to a non-zero limit: {sums.statement}"
        return (CONVERGENCE.refuted(statement, {"by": COSET_SUMS.code}, why=sums.statement),)
    if numbers.parts:
        yes, no = "S converges uniformly", "S does not converge uniformly"
        words = yes, no, "its factors do", "its factor in {} does not"
        return (products.follows(CONVERGENCE, _CONVERGENCE_QUESTION, numbers.parts, questions.CONVERGENCE, *words),)
    usable = decay is not None and decay.verdict is Verdict.PROVED
    proofs, obstacles = list(_proofs(numbers, facts, usable)), list(_obstacles(numbers, facts, usable))
    if proofs and obstacles:
        raise ContradictionError(f"S converges and {obstacles[0].why}")
    if several := proofs or obstacles:
        return (best_of(several),)
    reason = "no bound of ρ_k below 1 is proved, and no product is known that keeps it above"
    return (CONVERGENCE.undecided(_CONVERGENCE_QUESTION, (decay.reason if decay is not None else None) or reason),)


def _proofs(numbers: MultivariateNumbers, facts: Facts, usable: bool) -> Iterator[Finding]:
    """The findings that S converges; `usable` says whether the radius may be used."""
    k, radius = numbers.order, numbers.radius if usable else None
    for code, reason in _NORMS.items():
        if code in facts:
            yield _converges(reason, code)
    if numbers.box is not None and any(code in facts for code in _NORMS):
        return  # nothing else asks for the mean squares of box splines
    mean = numbers.mean_decay
    if radius is not None and radius.is_below(Fraction(1)):
        yield _converges(f"the coset sums are 1 and ρ_{k} < 1", DIFFERENCE_RADIUS.code)
    if mean is not None and mean < 1:
        why = f"the mean squares of differences of order {k} decay fast enough for ρ_{k} < 1"
        yield _converges(why, SOBOLEV.code, growth_proof(numbers))


def _obstacles(numbers: MultivariateNumbers, facts: Facts, usable: bool) -> Iterator[Finding]:
    """The findings that S does not converge."""
    product = numbers.product if usable else None
    if product is not None and product.compare(Fraction(1)) >= 0:
        witness: MultivariateConvergenceWitness = {"by": DIFFERENCE_RADIUS.code, "word": product.word}
        yield _diverges(f"{product_name(product.word)} keeps ρ_{numbers.order} ≥ 1", witness)
    for stays in facts.all(SUBLATTICE):
        yield _diverges(stays.statement, {"by": SUBLATTICE.code})
    if numbers.box is not None and numbers.box.depth < 2:
        yield _diverges("φ is a box spline that is not continuous", {"by": BOX_SPLINE.code})


def _converges(why: str, by: str, proof: GrowthProof | None = None) -> Finding:
    return CONVERGENCE.proved(f"S converges uniformly: {why}", {"by": by}, proof=proof, why=why)


def _diverges(why: str, witness: MultivariateConvergenceWitness) -> Finding:
    return CONVERGENCE.refuted(f"S does not converge uniformly: {why}", witness, why=why)


_STABILITY_QUESTION = "are the integer translates of φ stable?"


@asking((STABILITY, _STABILITY_QUESTION))
def stability(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD616: whether the integer translates of φ are stable.

    Theorems. Box splines (SD603): iff the directions are unimodular (Dahmen & Micchelli 1983; Jia 1984; de Boor, Höllig
    & Riemenschneider 1993, II.57). Interpolatory masks, a_(Mα) = δ_α, of schemes that converge (SD611): φ(α) = δ_α, so
    the translates are stable and linearly independent; and shifts of such masks, as the function of a(· + t) is φ(· +
    (M-I)^-1 t). Tensor products (SD609) that converge: iff all factors are. Of all other schemes that converge: iff the
    symbol of the Gram sequence g_α = ∫ φ φ(·-α) has no zero on the torus (Jia & Micchelli 1991; numbers/gram.py).
    Hypothesis of the last three, convergence: checked. Of schemes that do not converge only box splines are decided.

    Witness: `by`, SD603, SD609 or SD611; of a Gram sequence `zero`, k, with `order`, n, where it is zero at 2πk/n, or
    `boxes`, how many show that it is positive. `proof`: the sequence and the tree of the boxes.
    """
    if not numbers.is_normalised:
        return (STABILITY.skipped(_STABILITY_QUESTION, "the coefficients do not add up to |det M|, so there is no φ"),)
    if (box := numbers.box) is not None:
        if box.is_unimodular:
            why = "the directions of the box spline are unimodular"
            return (STABILITY.proved(f"φ is stable: {why}", {"by": BOX_SPLINE.code}, why=why),)
        why = "some directions have a determinant beyond ±1"
        return (STABILITY.refuted(f"φ is not stable: {why}", {"by": BOX_SPLINE.code}, why=why),)
    if facts.verdict(CONVERGENCE) is not Verdict.PROVED:
        return (
            STABILITY.undecided(
                _STABILITY_QUESTION, "φ is no box spline, and it is not proved that the scheme converges"
            ),
        )
    if numbers.parts:
        words = "φ is stable", "φ is not stable", "its factors are", "its factor in {} is not"
        return (products.follows(STABILITY, _STABILITY_QUESTION, numbers.parts, questions.STABILITY, *words),)
    if numbers.is_shifted_interpolatory:
        where = "" if numbers.is_interpolatory else ", a shift of φ aside"
        why = f"φ(0) = 1 and φ(α) = 0 at all other integers{where}"
        return (STABILITY.proved(f"φ is stable: {why}", {"by": CONVERGENCE.code}, why=why),)
    return (_of_gram_sequence(numbers.gram),)


def _of_gram_sequence(gram: Gram | None) -> Finding:
    if gram is None:
        return STABILITY.undecided(_STABILITY_QUESTION, "the Gram sequence of the translates is too long")
    proof: GramProof = {"gram": tuple(gram.sequence.items()), "correlations": gram.correlations}
    if gram.zero is not None:
        k, n = gram.zero
        at = f"2π({', '.join(str(Fraction(x, n)) for x in k)})"
        why = f"Σ ∫φφ(·−α) e^(iα·ω) is zero at ω = {at}"
        witness: MultivariateStabilityWitness = {"by": CONVERGENCE.code, "zero": k, "order": n}
        return STABILITY.refuted(f"φ is not stable: {why}", witness, proof=proof, why=why)
    if gram.tree is None:
        return STABILITY.undecided(
            _STABILITY_QUESTION, "the symbol of the Gram sequence is not seen to be positive or to have a zero"
        )
    boxes = gram.tree.count(LEAF)
    why = f"Σ ∫φφ(·−α) e^(iα·ω) is positive for all ω, on each of {boxes} boxes"
    proof["tree"] = gram.tree
    return STABILITY.proved(f"φ is stable: {why}", {"by": CONVERGENCE.code, "boxes": boxes}, proof=proof, why=why)


_SMOOTHNESS_QUESTION = "how smooth is φ?"


@asking((SMOOTHNESS, _SMOOTHNESS_QUESTION))
def smoothness(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD612: the largest n for which φ, and with it every limit function, is proved C^n. SD613: no C^(n+1).

    Theorems. For isotropic M, λ = |det M|^(1/s) (Jia 1998; Han 2003): sum rules of order k > n and ρ_k < λ^-n give C^n;
    stable φ ∈ C^n has sum rules of order > n and ρ_k < λ^-n for every order k > n of its sum rules. Box splines
    (SD603): C^n iff n <= d - 2, whatever their stability. Tensor products (SD609): iff all factors are. Hypotheses: M
    isotropic, checked (others are skipped); stability (SD616), for refutations that are not of box splines or by SD621.

    Without stability: S converges, and ρ_k(w) < λ^-n, k > n, gives C^n, ρ_k(w) >= λ^-n excludes it (SD621).

    In the mean, ρ_k² is at most m Λ, Λ the growth of the mean squares of differences (SD617). Where neither tells, a
    matrix scheme of differences (SD606) or quotients by pairs of directional factors (SD607) may.

    For any M, φ is C^0 where S converges (SD611).

    Witness: `order`; `by`, SD605, SD617, SD606, SD607, SD609, SD611, SD603 or SD621; SD613: `by`, SD603, SD609, SD602
    (the sum rules are too few), SD605 or SD621 (a product of its `word`) or SD617 (the Sobolev exponent is at most n).
    """
    if not numbers.is_normalised:
        return (
            SMOOTHNESS.skipped(_SMOOTHNESS_QUESTION, "the coefficients do not add up to |det M|, so there is no φ"),
        )
    if numbers.box is not None:
        return _of_box_spline(numbers.box.depth)
    if numbers.parts:
        return _of_parts(numbers.parts)
    converges = facts.verdict(CONVERGENCE) is Verdict.PROVED
    isotropic = numbers.lattice.is_isotropic
    proofs = [_proved(0, "S converges", CONVERGENCE.code)] if converges else []
    if not isotropic:
        if not proofs:
            return (SMOOTHNESS.skipped(_SMOOTHNESS_QUESTION, ANISOTROPIC),)
        return (proofs[0], NEXT_SMOOTHNESS.skipped("is φ C^1?", ANISOTROPIC))
    routes = {by: n for n in range(numbers.order) for by in proved_by(numbers, facts, n)}
    proofs = [
        *(
            _proved(n, _reason(numbers, n, by), by, growth_proof(numbers) if by == SOBOLEV.code else None)
            for by, n in routes.items()
        ),
        *proofs,
    ]
    if (proof := stencils.smooth(numbers, facts)) is not None:
        proofs.append(_proved(*proof, STENCIL_RADIUS.code))
    stably = facts.verdict(STABILITY) is Verdict.PROVED
    if not proofs:
        known = numbers.radius is not None or numbers.mean_decay is not None
        reason = "it is not proved that φ is continuous" if known else "no bound of the decay of differences is known"
        return (SMOOTHNESS.undecided(_SMOOTHNESS_QUESTION, reason),)
    first = best_of(sorted(proofs, key=lambda each: -_order(each)))
    n = _order(first) + 1
    obstacles = [
        _not_smoother(n, f"φ is stable, and {why}", _by(n, by), growth_proof(numbers) if by == SOBOLEV.code else None)
        for why, by in _obstacles_to(numbers, n)
    ]
    by_stencil = stencils.obstacle(numbers, facts, n)
    excluded = obstacles if stably else []
    if by_stencil is not None:
        excluded.append(_not_smoother(n, by_stencil, _by(n, STENCIL_RADIUS.code)))
    if excluded:
        return (first, best_of(excluded))
    why = "it is not proved that φ is stable" if obstacles else "no product is known that excludes it"
    return (first, NEXT_SMOOTHNESS.undecided(f"is φ C^{n}?", why))


def _of_box_spline(depth: int) -> tuple[Finding, ...]:
    enough, few = spanning(depth - 1), not_spanning(depth)
    if depth < 2:
        return (_not_continuous(few, _by(0, BOX_SPLINE.code)),)
    return (
        _proved(depth - 2, enough, BOX_SPLINE.code),
        _not_smoother(depth - 1, few, _by(depth - 1, BOX_SPLINE.code)),
    )


def _of_parts(parts: tuple[Part, ...]) -> tuple[Finding, ...]:
    verdict, part = products.of_all(parts, questions.SMOOTHNESS)
    if verdict is Verdict.REFUTED:
        return (_not_continuous(f"its factor in {part.name} is not", _by(0, TENSOR_PRODUCT.code)),)
    if verdict is Verdict.UNDECIDED:
        return (SMOOTHNESS.undecided(_SMOOTHNESS_QUESTION, f"it is not decided for the factor in {part.name}"),)
    orders = [(_order(part.finding(questions.SMOOTHNESS)), part) for part in parts]
    n = min(order for order, _ in orders)
    first = _proved(n, "its factors are", TENSOR_PRODUCT.code)
    for order, part in orders:
        following = part.find(questions.NEXT_SMOOTHNESS)
        if order == n and following is not None and following.verdict is Verdict.REFUTED:
            return (first, _not_smoother(n + 1, f"its factor in {part.name} is not", _by(n + 1, TENSOR_PRODUCT.code)))
    return (first, NEXT_SMOOTHNESS.undecided(f"is φ C^{n + 1}?", "it is not excluded for any factor"))


def _proved(n: int, why: str, by: str, proof: GrowthProof | None = None) -> Finding:
    answers = {questions.SMOOTHNESS: Smoothness(n)}
    return SMOOTHNESS.proved(f"φ is C^{n}: {why}", _by(n, by), proof=proof, answers=answers, why=why)


def _not_continuous(why: str, witness: MultivariateSmoothnessWitness) -> Finding:
    return SMOOTHNESS.refuted(f"φ is not continuous: {why}", witness, why=why)


def _not_smoother(
    n: int, why: str, witness: MultivariateSmoothnessWitness, proof: GrowthProof | None = None
) -> Finding:
    return NEXT_SMOOTHNESS.refuted(f"φ is not C^{n}: {why}", witness, why=why, proof=proof)


def _order(finding: Finding) -> int:
    """The order of smoothness that a factor is proved to have."""
    answer = dict(finding.answers)[questions.SMOOTHNESS]
    assert isinstance(answer, Smoothness)
    assert isinstance(answer.order, int)
    return answer.order


def _by(order: int, code: str) -> MultivariateSmoothnessWitness:
    return {"order": order, "by": code}


def _reason(numbers: MultivariateNumbers, n: int, by: str) -> str:
    if by == DIRECTIONAL_SMOOTHNESS.code:
        return "the quotients by two directional factors contract"
    if by == MATRIX_NORMS.code:
        return "a matrix scheme of differences contracts"
    mean = ", by the mean squares of differences" if by == SOBOLEV.code else ""
    return f"ρ_{numbers.order} < {threshold(numbers, n)}{mean}"


def proved_by(numbers: MultivariateNumbers, facts: Facts, n: int) -> tuple[str, ...]:
    """The codes of the findings that prove C^n: ρ_k < λ^-n, by x^s m^(n length) < 1 for ρ_k^length <= x; or norms."""
    bounds = {
        DIFFERENCE_RADIUS.code: numbers.radius and numbers.radius.upper,
        SOBOLEV.code: (2, numbers.mean_decay),
    }
    codes = []
    for code, pair in bounds.items():
        if pair is not None and (bound := pair[1]) is not None:
            length = pair[0]
            if bound**numbers.dimension * numbers.lattice.index ** (n * length) < 1:
                codes.append(code)
    if DIRECTIONAL_SMOOTHNESS in facts and n <= 1:
        codes.append(DIRECTIONAL_SMOOTHNESS.code)
    if MATRIX_NORMS in facts and n <= facts.witness(MATRIX_NORMS)["smooth"]:
        codes.append(MATRIX_NORMS.code)
    return tuple(codes)


def reaches(numbers: MultivariateNumbers, product: WordProduct, n: int) -> bool:
    """Whether the product proves ρ_k >= λ^-n: its s-th power has an eigenvalue of modulus at least m^(-n length)."""
    assert numbers.space is not None
    power = WordProduct.of_word(numbers.space.matrices, product.word * numbers.dimension)
    return power.eigenvalue.compare_modulus(Fraction(1, numbers.lattice.index ** (n * len(product.word)))) >= 0


def _obstacles_to(numbers: MultivariateNumbers, n: int) -> Iterator[tuple[str, str]]:
    """What keeps a stable φ from being C^n, in words, with the code of the finding that says it."""
    k, product = numbers.order, numbers.product
    if n >= k:
        yield f"C^{n} needs sum rules of order {n + 1}, but the mask has order {k}", SUM_RULES.code
    elif product is not None and reaches(numbers, product, n):
        yield f"{product_name(product.word)} keeps ρ_{k} ≥ {threshold(numbers, n)}", DIFFERENCE_RADIUS.code
    growth = None if numbers.mean_squares is None else numbers.mean_squares.growth
    if growth is not None and growth.low**numbers.dimension * numbers.lattice.index ** (2 * n) >= 1:
        yield f"its Sobolev exponent is at most {n}", SOBOLEV.code
