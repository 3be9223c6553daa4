"""Stages on the sides, on what S does near 0, and on polynomials (SD820 to SD823, SD829)."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.algebraic import AlgebraicNumber
from subdiv_cli.exact.closed import exponent, worded
from subdiv_cli.exact.text import eigenvalue, number
from subdiv_cli.exact.text import modulus as modulus_text
from subdiv_cli.kinds.kind import Facts, asking
from subdiv_cli.kinds.piecewise.numbers.piecewise import PiecewiseNumbers
from subdiv_cli.kinds.piecewise.numbers.polynomials import operator
from subdiv_cli.kinds.piecewise.numbers.sides import Side
from subdiv_cli.kinds.piecewise.rules import CONVERGENCE, GENERATION, LOCAL_SPECTRUM, SIDE, VALUE_AT_ZERO
from subdiv_cli.kinds.piecewise.witnesses import PiecewiseConvergenceWitness, PiecewiseGenerationWitness
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.model import findings as questions
from subdiv_cli.model.formulas import combination
from subdiv_cli.model.formulas import operator as operator_text

TOO_LARGE = "the window near 0 is too large for this effort"
DIVERGES = "it is not proved that S converges"


@asking((SIDE, "what is known of both masks?"))
def sides(numbers: PiecewiseNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD820, for each side: what kind scalar proves of its mask, with a certificate of its own.

    Far from 0 on its side the limits are those of the mask, for data that may be any: so S converges only if the scheme
    of the mask does, and limits are no smoother there than its φ. Hypothesis: the certificate verifies.

    Witness: `side`, `left` or `right`.
    """
    results = []
    for name, side in numbers.sides:
        if side.certificate is None:
            results.append(SIDE.undecided(f"what is known of the {name} mask?", "nothing is proved of it"))
        else:
            results.append(SIDE.proved(f"the {name} mask {_known(side, numbers.p)}", {"side": name}))
    return tuple(results)


def _known(side: Side, p: int) -> str:
    """What is stated of a mask: `converges, is C^1 and not C^2, α = 2`."""
    if side.converges is None:
        return "is not seen to converge"
    if not side.converges:
        return "does not converge"
    beyond = "" if side.not_smooth is None else f" and not C^{side.not_smooth}"
    exact = "" if side.exact is None else f", α = {worded(exponent(p, side.exact.length, side.exact.root))}"
    return f"converges, with limits in C^{side.smooth}{beyond}{exact}"


_SPECTRUM_QUESTION = "which eigenvalues has S near 0?"


@asking((LOCAL_SPECTRUM, _SPECTRUM_QUESTION))
def local_spectrum(numbers: PiecewiseNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD822: the eigenvalues, not 0, of A, which is S on the points from which all points near 0 are computed.

    The set is the smallest one that every point is computed from after enough steps: iterate X ↦ the points that those
    of X are computed from (numbers/functionals.py). Any larger window has the same eigenvalues, and 0. Necessary and
    sufficient statements are those of SD823 to SD828: an eigenvalue may be seen by no limit.

    Witness: `points` of the set; `factors` of the characteristic polynomial, z left out, the constant first.
    """
    if numbers.window is None:
        return (LOCAL_SPECTRUM.undecided(_SPECTRUM_QUESTION, TOO_LARGE),)
    local, points = numbers.local, numbers.closed_set
    if local is None:
        return (LOCAL_SPECTRUM.proved("all eigenvalues near 0 are 0", {"points": points, "factors": ()}),)
    factors = tuple(f for f, n in local.factors for _ in range(n))
    listed = ", ".join(eigenvalue(x) + ("" if n == 1 else f" ({n} times)") for x, n in local.roots if not _below(x))
    closed = f"{{{points[0]}, …, {points[-1]}}}" if len(points) == points[-1] - points[0] + 1 else f"{points}"
    return (LOCAL_SPECTRUM.proved(f"{listed} on {closed}", {"points": points, "factors": factors}),)


def _below(x: AlgebraicNumber) -> bool:
    """Whether a complex eigenvalue is the lower one of its pair."""
    return not x.is_real and bool(x.region.imag < 0)


_CONVERGENCE_QUESTION = "does S converge?"


@asking((CONVERGENCE, _CONVERGENCE_QUESTION))
def convergence(numbers: PiecewiseNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD823: whether S converges, to limits that are not all 0 at 0.

    Theorem 1 of numbers/functionals.py: iff the schemes of both masks converge (SD820), all special rows sum to 1, and
    the rows v on the window with Σ v = 0 die out under A: ρ_0 < 1. All hypotheses are decided, each refutes alone.

    Witness: `by`, `row` with its number and `total`; `side` with its name; or `radius`.
    """
    if numbers.wrong_row is not None:
        i, total = numbers.wrong_row
        why = f"special row {i} sums to {number(total)}, must be 1"
        return (_diverges({"by": "row", "row": i, "total": total}, why),)
    for name, side in numbers.sides:
        if side.converges is False:
            return (_diverges({"by": "side", "side": name}, f"the {name} mask does not converge"),)
    decay = numbers.decay
    if decay is None:
        return (CONVERGENCE.undecided(_CONVERGENCE_QUESTION, TOO_LARGE),)
    witness: PiecewiseConvergenceWitness = {"by": "radius", "dimension": decay.dimension}
    if not decay.is_below(Fraction(1)):
        assert decay.spectrum is not None
        size = modulus_text(decay.spectrum.roots[0][0])
        return (_diverges(witness, f"differences near 0 have the eigenvalue of modulus {size}"),)
    if None in (numbers.left.converges, numbers.right.converges):
        return (CONVERGENCE.undecided(_CONVERGENCE_QUESTION, "it is not known of both masks"),)
    rate = "are 0 after a few steps"
    if decay.spectrum is not None:
        rate = f"decay like {modulus_text(decay.spectrum.roots[0][0])}^n"
    why = f"both masks converge, and near 0 differences {rate}"
    return (CONVERGENCE.proved(f"S converges: {why}", witness, why=why),)


def _diverges(witness: PiecewiseConvergenceWitness, why: str) -> Finding:
    return CONVERGENCE.refuted(f"S does not converge: {why}", witness, why=why)


_GENERATION_QUESTION = "which polynomials are generated?"


@asking((GENERATION, _GENERATION_QUESTION))
def generation(numbers: PiecewiseNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD821: the largest m with S Q = Q σ on π_m for an operator Q that on each side, far from 0, is that of its mask.

    Theorem (A. Levin 2003, Lemma 3.2, Corollary 3.3; numbers/polynomials.py): then S^∞ Q f = f on π_m if S converges,
    and S^∞ Q f is, for a local bounded extension of Q, an approximation of order m + 1. The equations are solved
    exactly, with all values of Q x^d near 0 open. Sufficient for smoothness in no case, and not necessary.

    Witness: `degree`; `left` and `right`, the coefficients of Q = Σ c_d D^d on both sides; the values `sequences` of
    Q 1, …, Q x^m from point `start` on.
    """
    if numbers.functionals is None:
        return (GENERATION.undecided(_GENERATION_QUESTION, TOO_LARGE),)
    sequences = numbers.sequences
    if not sequences:
        return (GENERATION.skipped(_GENERATION_QUESTION, "constants are not generated"),)
    degree = len(sequences) - 1
    left, right = (operator(polynomials[: degree + 1]) for polynomials in numbers.polynomials)
    witness: PiecewiseGenerationWitness = {
        "degree": degree,
        "left": left,
        "right": right,
        "start": numbers.functionals.window[0],
        "sequences": sequences,
    }
    same = "on both sides" if left == right else f"on the left, {operator_text(right)} on the right"
    statement = f"S Q = Q σ on π_{degree}, Q f = {operator_text(left)} {same}; not on π_{degree + 1}"
    return (GENERATION.proved(statement, witness, answers={questions.GENERATION: degree}),)


_VALUE_QUESTION = "which value has the limit at 0?"


@asking((VALUE_AT_ZERO, _VALUE_QUESTION))
def value_at_zero(numbers: PiecewiseNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD829: the value F(0) of the limit in terms of the data: the row v with v A = v and Σ v = 1.

    Theorem 1 of numbers/functionals.py: A^n -> e v^T. Hypothesis, convergence (SD823): checked.

    Witness: `start` and `weights`, v.
    """
    if facts.verdict(CONVERGENCE) is not Verdict.PROVED:
        return (VALUE_AT_ZERO.skipped(_VALUE_QUESTION, DIVERGES),)
    assert numbers.functionals is not None
    first = numbers.functionals.window[0]
    seen = {i: x for i, x in enumerate(numbers.functionals.value, first) if x}
    weights = tuple(seen.get(i, Fraction(0)) for i in range(min(seen), max(seen) + 1))
    text = combination((x, f"c_{i}" if i >= 0 else f"c_({i})") for i, x in seen.items())
    return (VALUE_AT_ZERO.proved(f"F(0) = {text}", {"start": min(seen), "weights": weights}),)
