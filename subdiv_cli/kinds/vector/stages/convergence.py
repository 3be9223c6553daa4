"""Stages on the space of constants, polynomials and convergence (SD701 to SD706)."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.algebraic import roots
from subdiv_cli.exact.linalg import Vector, matrix, nullspace, rows_of
from subdiv_cli.exact.rationals import to_fraction
from subdiv_cli.exact.text import modulus, number, rounded_up
from subdiv_cli.kinds.growth import SequenceGrowth
from subdiv_cli.kinds.kind import ContradictionError, Facts, asking
from subdiv_cli.kinds.radius import enclosed, put_radius, shown
from subdiv_cli.kinds.scalar.stages.wording import product_name
from subdiv_cli.kinds.vector.numbers.vector import VectorNumbers
from subdiv_cli.kinds.vector.rules import (
    CONSTANTS,
    CONVERGENCE,
    DECAY_RADIUS,
    EIGEN_SEQUENCES,
    LIMIT_STENCILS,
    MEAN_MATRIX,
)
from subdiv_cli.kinds.vector.witnesses import (
    ConstantsWitness,
    EigenSequencesProof,
    SequenceRadiusProof,
    SequenceRadiusWitness,
    SequenceSpaceData,
    VectorConvergenceWitness,
)
from subdiv_cli.model import Finding, Rule, Verdict
from subdiv_cli.model import findings as questions
from subdiv_cli.spaces.stencils import SequenceSpace, VectorSequence

NO_CONSTANTS = "no vector is reproduced as constant data: E_A = 0"
TOO_LARGE = "the space of sequences is too large: more than 400 coordinates, or a dimension above 120"


def constants(numbers: VectorNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD701: the dimension r of E_A = {u : A^ε u = u for every ε}, A^ε the sums over the residue classes.

    Constant data u are reproduced iff u is in E_A. Limits of a scheme that converges have values in E_A, which is then
    not 0 (spaces/stencils.py, theorem 1). No hypothesis.

    Witness: `dimension`, r; `basis`, r vectors; `size`, m.
    """
    basis, m = numbers.constants, numbers.size
    r = len(basis)
    witness: ConstantsWitness = {"dimension": r, "basis": basis, "size": m}
    statement = f"E_A has dimension {r} of {m}" + (f", spanned by {_vectors(basis)}" if r else "")
    return (CONSTANTS.proved(statement, witness, answers={questions.DIMENSION: r}),)


def _vectors(basis: tuple[Vector, ...]) -> str:
    shown = ["(" + ", ".join(map(number, u)) + ")" for u in basis[:4]]
    return ", ".join(shown) + (", …" if len(basis) > 4 else "")


def eigen_sequences(numbers: VectorNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD702: the largest k for which there are eigen-sequences S y = p^-j y of every exact degree j < k.

    Polynomial sequences y with a leading coefficient that is any vector of E_A; those of a lower degree do not count.
    Then S maps the vector polynomials that they and their shifts span to such polynomials: k - 1 is the degree of
    generation. For scalar masks k is the order of the sum rules. No hypothesis; no bound of the smoothness follows
    where the limits are not stable.

    Witness: `order`, k. `proof`: `sequences`, for every degree and every vector of the basis of E_A the coefficients of
    1, i, i^2, …; `multipliers` of the equations of degree k, and the `functional` that they say is 0 at all leading
    coefficients, and that is not 0 on E_A (numbers/eigen_sequences.py).
    """
    sequences = numbers.sequences
    if sequences is None:
        statement = f"there is no polynomial eigen-sequence: {NO_CONSTANTS}"
        answers = {questions.SUM_RULES: 0, questions.GENERATION: None}
        return (EIGEN_SEQUENCES.proved(statement, {"order": 0}, answers=answers),)
    k = sequences.order
    several = f"degrees 0 to {k - 1}" if k > 1 else "degree 0"
    statement = f"eigen-sequences S y = p^-j y of {several} lead in all of E_A, those of degree {k} do not"
    proof: EigenSequencesProof = {
        "sequences": sequences.each,
        "multipliers": sequences.multipliers,
        "functional": sequences.functional,
    }
    answers = {questions.SUM_RULES: k, questions.GENERATION: k - 1}
    return (EIGEN_SEQUENCES.proved(statement, {"order": k}, proof=proof, answers=answers),)


_MEAN_QUESTION = "has M_A the spectrum of a convergent scheme?"


def mean_matrix(numbers: VectorNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD703: the spectrum of M_A = (1/p) Σ A_i, the mean of the A^ε.

    Theorem 19 and Corollary 20 of Moosmüller & Dyn 2018, for any p: if S converges, the eigenspace of M_A for 1 is E_A,
    1 has no other generalised eigenvectors, and all other eigenvalues lie inside the unit circle. That is so iff
    det(x - M_A) = (x-1)^r g(x), r = dim E_A, with all zeros of g in |x| < 1. Where it fails S diverges: the products of
    operators that SD704 finds say so too. Hypothesis, E_A ≠ 0: checked.

    Witness: `dimension`, r; refuted: `multiplicity` of 1, or none where another eigenvalue is too large.
    """
    r = len(numbers.constants)
    if not r:
        return (MEAN_MATRIX.skipped(_MEAN_QUESTION, NO_CONSTANTS),)
    g = numbers.mean_cofactor
    if g is None:
        statement = f"M_A has the eigenvalue 1 more often than {r} time{'' if r == 1 else 's'}, the dimension of E_A"
        return (MEAN_MATRIX.refuted(statement, {"dimension": r}),)
    largest = roots(g)[0][0] if g.degree() > 0 else None
    if largest is not None and largest.compare_modulus(Fraction(1)) >= 0:
        statement = f"M_A has an eigenvalue of modulus {modulus(largest)} ≥ 1 beside those on E_A"
        return (MEAN_MATRIX.refuted(statement, {"dimension": r}),)
    rest = f", others of modulus at most {modulus(largest)}" if largest is not None else " alone"
    return (MEAN_MATRIX.proved(f"M_A has the eigenvalue 1 on E_A{rest}", {"dimension": r}),)


_DECAY_QUESTION = "how fast do the sequences die out that must?"


@asking((DECAY_RADIUS, _DECAY_QUESTION))
def decay_radius(numbers: VectorNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD704: ρ_1, the joint spectral radius of the transition operators T_ε on V_1 = {v : Σ v(α) orthogonal to E_A}.

    (T_ε v)(α) = Σ_β A_(ε+pα-β)^T v(β); the radius is that on the smallest space that holds the differences e_l ∇δ and
    the sequences x δ, x in a basis of the complement of E_A, and is mapped into itself: all of V_1 are finite
    combinations of shifts of these (spaces/stencils.py). Found and proved as SD310 says. Hypothesis, E_A ≠ 0: checked.
    Not asked where T_0 has more fixed sequences than E_A dimensions, which refutes convergence by itself.

    Witness: `dimension` of the space; `method`; `word` of a product; `length` and `bound`, or `length` and `root`.
    `proof`: `space` and `radius`.
    """
    if not numbers.constants:
        return (DECAY_RADIUS.skipped(_DECAY_QUESTION, NO_CONSTANTS),)
    if _surplus(numbers):
        return (DECAY_RADIUS.skipped(_DECAY_QUESTION, "T_0 fixes more sequences than converge"),)
    if (growth := numbers.decay) is None:
        return (DECAY_RADIUS.undecided(_DECAY_QUESTION, TOO_LARGE),)
    space = space_data(growth.on)
    space["orthogonal"] = nullspace(matrix(numbers.constants))
    return (radius_finding(DECAY_RADIUS, growth, "ρ_1", space),)


def _surplus(numbers: VectorNumbers) -> bool:
    """Whether the kernel of T_0 - 1 has a higher dimension than E_A."""
    return numbers.fixed is not None and len(numbers.fixed) > len(numbers.constants)


def radius_finding(
    rule: Rule[SequenceRadiusWitness], growth: SequenceGrowth, name: str, space: SequenceSpaceData
) -> Finding:
    """The finding of a joint spectral radius on an invariant space of sequences."""
    radius, dimension = growth.radius, growth.on.space.dimension
    witness: SequenceRadiusWitness = {"order": growth.order, "dimension": dimension, "method": radius.method}
    put_radius(witness, radius)
    value = enclosed(radius)
    size = f"≤ {rounded_up(value.upper or 0.0, 12)}" if radius.exact is None else f"= {shown(radius)}"
    attains = f", attained by {product_name(radius.word)}" if radius.exact is not None and radius.word else ""
    statement = f"{name} {size} on a space of dimension {dimension}{attains}"
    proof: SequenceRadiusProof = {"space": space, "radius": radius.proof}
    return rule.proved(statement, witness, value, proof=proof)


def space_data(on: SequenceSpace) -> SequenceSpaceData:
    """An invariant space as certificates have it: sequences on an interval of indices that begins at `start`."""
    indices = [i for (i,) in on.window]
    start, count, space = indices[0], indices[-1] - indices[0] + 1, on.space
    m = space.basis.ncols() // len(indices)
    basis = []
    for row in rows_of(space.basis):
        wide = [0] * (m * count)
        for place, i in enumerate(indices):
            wide[m * (i - start) : m * (i - start + 1)] = [int(x) for x in row[m * place : m * place + m]]
        basis.append(tuple(wide))
    return {
        "start": start,
        "basis": tuple(basis),
        "matrices": tuple(rows_of(a) for a in space.matrices),
        "tree": tuple(map(int, space.tree)),
        "leaves": rows_of(space.leaves),
        "words": tuple((leaf, *word) for leaf, word in space.origins),
    }


_CONVERGENCE_QUESTION = "does S converge uniformly?"


@asking((CONVERGENCE, _CONVERGENCE_QUESTION))
def convergence(numbers: VectorNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD705: whether S converges uniformly, to a limit that is not 0 for some data.

    Theorems 1 and 2 of spaces/stencils.py (Micchelli & Sauer 1998): S converges iff E_A ≠ 0 and ρ_1 < 1, for any arity,
    without stability; limits have values in E_A. If S converges, the kernel of T_0 - 1 has the dimension of E_A. No
    further hypothesis.

    Witness: `by`, SD701 (E_A = 0), SD704, with the `word` of a product that keeps ρ_1 >= 1 where refuted, or SD706:
    more `fixed` sequences than dim E_A, with the `start` of their rows.

    Raises ContradictionError where S converges and ρ_1 is at least 1.
    """
    if not numbers.constants:
        statement = f"S does not converge to a non-zero limit: {NO_CONSTANTS}"
        return (CONVERGENCE.refuted(statement, {"by": CONSTANTS.code}, why=NO_CONSTANTS),)
    r = len(numbers.constants)
    if _surplus(numbers):
        assert numbers.fixed is not None
        start, rows = sequence_rows(numbers.fixed[: r + 1], numbers.size)
        why = f"T_0 fixes {len(numbers.fixed)} sequences, and E_A has dimension {r}"
        witness: VectorConvergenceWitness = {"by": LIMIT_STENCILS.code, "start": start, "fixed": rows}
        return (CONVERGENCE.refuted(f"S does not converge uniformly: {why}", witness, why=why),)
    growth = numbers.decay if facts.verdict(DECAY_RADIUS) is Verdict.PROVED else None
    if growth is None:
        return (CONVERGENCE.undecided(_CONVERGENCE_QUESTION, facts[DECAY_RADIUS].reason or TOO_LARGE),)
    diverges = growth.product is not None and growth.product.compare(Fraction(1)) >= 0
    if growth.radius.is_below(Fraction(1)):
        if diverges:
            raise ContradictionError("S converges and ρ_1 is at least 1")
        to = (
            ""
            if r == numbers.size
            else f", to limits in the {r}-dimensional space E_A (degenerate: {r} < {numbers.size})"
        )
        why = "ρ_1 < 1"
        return (CONVERGENCE.proved(f"S converges uniformly{to}: {why}", {"by": DECAY_RADIUS.code}, why=why),)
    if diverges and growth.product is not None:
        why = f"{product_name(growth.product.word)} keeps ρ_1 ≥ 1"
        witness = {"by": DECAY_RADIUS.code, "word": growth.product.word}
        return (CONVERGENCE.refuted(f"S does not converge uniformly: {why}", witness, why=why),)
    reason = "no bound of ρ_1 below 1 is proved, and no product is known that keeps it above"
    return (CONVERGENCE.undecided(_CONVERGENCE_QUESTION, reason),)


def sequence_rows(sequences: tuple[VectorSequence, ...], m: int) -> tuple[int, tuple[Vector, ...]]:
    """Sequences on one interval: its first index, and a row of m entries an index for each."""
    indices = [i for w in sequences for (i,) in w]
    first, last = min(indices), max(indices)
    zero = [Fraction(0)] * m
    rows = []
    for w in sequences:
        values = [[to_fraction(x) for x in w[(i,)]] if (i,) in w else zero for i in range(first, last + 1)]
        rows.append(tuple(x for value in values for x in value))
    return first, tuple(rows)


_STENCILS_QUESTION = "what are the limit stencils?"


@asking((LIMIT_STENCILS, _STENCILS_QUESTION))
def limit_stencils(numbers: VectorNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD706: the limit stencils w_1, …, w_r, by which limits of a scheme that converges are computed exactly.

    Theorem 2 of spaces/stencils.py: the kernel of T_0 - 1 has a basis with Σ w_i · u_j = δ_ij, u the basis of E_A, and
    the limit at a point of a grid is Σ_i (w_i * S^n c) u_i. T_0 is that of the mask moved to begin at 0; the limits of
    that are those of the mask, moved by start/(p-1). Hypothesis, convergence (SD705): checked.

    Witness: `start`, and `rows`, the entries of each w_i.

    Raises ContradictionError where there are not as many as the theorem says.
    """
    if facts.verdict(CONVERGENCE) is not Verdict.PROVED:
        return (LIMIT_STENCILS.skipped(_STENCILS_QUESTION, "it is not proved that S converges"),)
    if numbers.stencils is None:
        raise ContradictionError("S converges and has not as many limit stencils as constants")
    r, m = len(numbers.stencils), numbers.size
    start, rows = sequence_rows(numbers.stencils, m)
    last = start + len(rows[0]) // m - 1
    where = f"the index {start}" if start == last else f"the indices {start} … {last}"
    statement = f"limits have {'a stencil' if r == 1 else f'{r} stencils'} on {where}"
    return (LIMIT_STENCILS.proved(statement, {"start": start, "rows": rows}),)
