"""Stages on values of φ, limit stencils and Q (SD501 to SD505)."""

from __future__ import annotations

from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import ContradictionError, Facts
from subdiv_cli.kinds.scalar.numbers.facts import interpolation_shift
from subdiv_cli.kinds.scalar.numbers.polynomials import eigen_sequence, moments, operator, parameter_shift, stencil
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.values import at_integers, support
from subdiv_cli.kinds.scalar.rules import (
    APPROXIMATION_ORDER,
    CONVERGENCE,
    INTEGER_VALUES,
    INTERPOLATORY_ORDER,
    LIMIT_STENCILS,
    QUASI_INTERPOLATION,
    REPRODUCTION,
    SMOOTHNESS,
)
from subdiv_cli.kinds.scalar.witnesses import IntegerValuesWitness, LimitStencilsWitness, QuasiInterpolationWitness
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.model.formulas import derivative
from subdiv_cli.model.formulas import operator as formula
from subdiv_cli.model.formulas import stencil as combination

_INTEGER_VALUES_QUESTION = "what are the values of φ at the integers?"
_MOST_SHOWN = 9


def integer_values(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD501: φ and its derivatives at the integers, exactly.

    Theorem (Dyn 1992, Theorem 4.2 and Corollaries 4.3, 4.6, for any arity p): where S_j converges, A_0 of S_j has the
    simple eigenvalue 1, and φ^(j)(ℓ) for all integers ℓ is read off its left eigenvector v with Σ v = 1
    (numbers/values.py). The mask's own indexing is kept: its support {s, …, s+n} makes that of φ [s/(p-1),
    (s+n)/(p-1)], and φ vanishes outside. Σ φ(·-i) = 1, because S maps constants to themselves; at the integers the
    values show it. Hypothesis, φ ∈ C^j by the convergence of S_j of the mask or, for an unstable one, of the reduced
    mask (SD302, SD403): checked. The values of φ then are those of φ0 combined with the factors of the reduction.

    Witness: `starts` and `values`, for j = 0, …, n the first index and the values of φ^(j) from there to the last that
    is not 0; `own_starts` and `own_values`, those of the reduced mask; `support`.

    Raises ContradictionError where the values of φ at the integers do not sum to 1.
    """
    if facts.verdict(SMOOTHNESS) is not Verdict.PROVED:
        return (INTEGER_VALUES.skipped(_INTEGER_VALUES_QUESTION, "φ is not proved continuous"),)
    reduced = numbers.reduced
    size = -(-reduced.scheme.degree // (numbers.p - 1)) + 2
    if not numbers.effort.allows(size**3 * reduced.weight // 4):
        return (
            INTEGER_VALUES.undecided(_INTEGER_VALUES_QUESTION, "the refinement matrix is too large for this effort"),
        )
    orders = range(facts.witness(SMOOTHNESS)["order"] + 1)
    values = [at_integers(numbers, order) for order in orders]
    own = [at_integers(numbers.reduced, order) for order in orders]
    if sum(values[0].coefficients()) != 1:
        raise ContradictionError("the translates of φ do not sum to 1")
    first, last = support(numbers)
    witness: IntegerValuesWitness = {
        "starts": tuple(v.low for v in values),
        "values": tuple(v.coefficients() for v in values),
        "own_starts": tuple(v.low for v in own),
        "own_values": tuple(v.coefficients() for v in own),
        "support": (first, last),
    }
    shown = ", ".join(_line(value, order) for order, value in enumerate(values[:2]))
    where = f"φ is supported in [{first}, {last}] and Σ φ(·-i) = 1"
    return (INTEGER_VALUES.proved(f"{shown}, and 0 at all other integers; {where}", witness),)


def _line(values: Laurent, order: int) -> str:
    """The values as a line of text: `φ(-1, 0, 1) = 1/6, 2/3, 1/6`."""
    c = values.coefficients()
    places = [str(values.low + i) for i in range(len(c))]
    name = derivative("φ", order)
    if len(c) > _MOST_SHOWN:
        return f"{name} has the values {', '.join(map(number, c[:_MOST_SHOWN]))}, … at {places[0]}, …, {places[-1]}"
    return f"{name}({', '.join(places)}) = {', '.join(map(number, c))}"


def unusable(facts: Facts) -> str | None:
    """The reason why limits cannot be spoken of with the values of φ; None where they can."""
    if facts.verdict(CONVERGENCE) is not Verdict.PROVED:
        return "S is not proved to converge"
    return None if facts.verdict(INTEGER_VALUES) is Verdict.PROVED else "the values of φ are not known"


_LIMIT_STENCILS_QUESTION = "how is the limit read off the data of a level?"
_MOST_WEIGHTS_OF_LIMIT = 7


def limit_stencils(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD502: limit stencils, the limit and its derivatives at i/p^k from the data of level k.

    Theorem (Dyn 1992, Corollaries 4.3 and 4.6, for any arity p): where S converges, S^∞ f⁰ = Σ f^k_α φ(p^k·-α), so (S^∞
    f⁰)^(j)(i p^-k) = p^(jk) Σ_β w_β f^k_(i+β) with w_β = φ^(j)(-β), for every j with φ ∈ C^j. Hypotheses: S converges
    (SD201), checked; the values of φ^(j): SD501.

    Witness: `starts` and `stencils`, for each j the first index and the weights.
    """
    if (why := unusable(facts)) is not None:
        return (LIMIT_STENCILS.skipped(_LIMIT_STENCILS_QUESTION, why),)
    orders = len(facts.witness(INTEGER_VALUES)["values"])
    stencils = [at_integers(numbers, order).reversed() for order in range(orders)]
    witness: LimitStencilsWitness = {
        "starts": tuple(w.low for w in stencils),
        "stencils": tuple(w.coefficients() for w in stencils),
    }
    p = numbers.p
    statement = f"S^∞ f at i/{p}^k is {_text(stencils[0])} with f = f^k"
    if orders > 1:
        statement += f"; its derivative is {p}^k times {_text(stencils[1])}"
    if orders > 2:
        statement += f"; there are stencils for the derivatives up to order {orders - 1}"
    return (LIMIT_STENCILS.proved(statement, witness),)


def _text(w: Laurent) -> str:
    c = w.coefficients()
    if len(c) > _MOST_WEIGHTS_OF_LIMIT:
        return f"a combination of f_(i{w.low:+d}), …, f_(i{w.low + len(c) - 1:+d})"
    return combination(w.low, c, lambda index: f"f_({index})" if len(index) > 1 else f"f_{index}")


_MOST_WEIGHTS_OF_Q = 9


def quasi_interpolation(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD503: the operator Q with S^∞ Q f = f for all polynomials f that S generates.

    Theorem (Levin 2003, Corollary 2.4 and (15), (16)): let S converge and S π_m = π_m. On π_m S^∞ f = Σ m_i/i! D^i f
    with the moments m_i = Σ_β φ(-β) β^i, and Q = Σ q_i D^i is its inverse: S Q = Q σ, σ f = f(·/p). Q x^i sampled at
    the integers is an eigen-sequence of S for p^-i. m is the generation degree (SD103). Hypothesis, S converges
    (SD201): checked; the values of φ: SD501. As a stencil Q is the shortest combination of samples near the centre of φ
    that is right on π_m, symmetric where the mask is; on other functions the two differ.

    Witness: `degree`, m; `moments`; `operator`, q_0, …, q_m; `stencil_start` and `stencil`; `eigen_sequences`, for i =
    0, …, m the coefficients of Q x^i, lowest power first.
    """
    if (why := unusable(facts)) is not None:
        return (QUASI_INTERPOLATION.skipped("which data have a given polynomial as limit?", why),)
    m, mask = numbers.order - 1, numbers.scheme.coefficients
    moment = moments(at_integers(numbers, 0), m + 1)
    q = operator(moment)
    t = stencil(q, mask == mask[::-1])
    witness: QuasiInterpolationWitness = {
        "degree": m,
        "moments": moment,
        "operator": q,
        "stencil_start": t.low,
        "stencil": t.coefficients(),
        "eigen_sequences": tuple(eigen_sequence(q, i) for i in range(m + 1)),
    }
    statement = f"on polynomials of degree {m} S^∞ Q f = f with Q f = {formula(q)}"
    weights = t.coefficients()
    if len(weights) <= _MOST_WEIGHTS_OF_Q:
        statement += f", Q f(i) = {combination(t.low, weights, lambda index: f'f({index})')}"
    return (QUASI_INTERPOLATION.proved(statement, witness),)


def approximation_order(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD504: how fast smooth functions are approximated on finer and finer grids, with and without Q.

    Theorem (Levin 2003, Theorem 2.7): where S converges and a local, bounded operator Q has S^∞ Q f = f for f ∈ π_m,
    ‖S^∞ Q_h f - f‖∞ = O(h^(m+1)) for every f with a bounded derivative of order m+1, Q_h at the step h. With Q of SD503
    m is the generation degree; with mere samples at i + τ/(p-1), which is such an operator too, it is the reproduction
    degree (SD104). Hypotheses: those of SD503.

    Witness: `with_q` and `without_q`, the orders.
    """
    if facts.verdict(QUASI_INTERPOLATION) is not Verdict.PROVED:
        return (
            APPROXIMATION_ORDER.skipped(
                "to which order are functions approximated?", unusable(facts) or "Q is not known"
            ),
        )
    with_q, without_q = numbers.order, facts.witness(REPRODUCTION)["degree"] + 1
    shift = parameter_shift(numbers.symbol, numbers.p) / (numbers.p - 1)
    where = "the integers" if not shift else f"i {'+' if shift > 0 else '-'} {number(abs(shift))}"
    statement = f"S^∞ Q approximates smooth functions to order {with_q}"
    statement += f", and S^∞ of their samples at {where} to order {without_q}"
    return (APPROXIMATION_ORDER.proved(statement, {"with_q": with_q, "without_q": without_q}),)


def interpolatory_order(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD505: how smooth the limits of an interpolatory scheme can be at most.

    Theorem (Dyn 1992, Theorem 5.1, for any arity p): an interpolatory scheme, a_(pα) = δ_(α,0), has C^ν limits only if
    it reproduces π_ν. With the sum rules of order k and no higher it reproduces π_(k-1) and no more: a polynomial
    sequence that S maps to one interpolates its limit. So no C^k. Hypothesis, the scheme is interpolatory: checked;
    other schemes have no such finding. As the translates of φ are independent, φ(α) = δ_(α,0), this is what SD303 says
    with the sum rules alone.

    Witness: `order`, k.
    """
    k = numbers.order
    if interpolation_shift(numbers.scheme) != 0 or not numbers.is_normalised or numbers.reduced is not numbers or not k:
        return ()
    statement = f"S is interpolatory and reproduces polynomials of degree {k - 1} only, so φ is not C^{k}"
    return (INTERPOLATORY_ORDER.proved(statement, {"order": k}),)
