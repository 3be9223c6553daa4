"""Stages on the mask itself: coset sums, sum rules, polynomials and Q (SD601, SD602, SD618, SD619)."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import comb

from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import Facts, asking
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.numbers.polynomials import Point, QuasiInterpolation
from subdiv_cli.kinds.multivariate.rules import CONVERGENCE, COSET_SUMS, QUASI_INTERPOLATION, REPRODUCTION, SUM_RULES
from subdiv_cli.kinds.multivariate.witnesses import (
    CosetSumsWitness,
    MultivariateQuasiInterpolationWitness,
    MultivariateReproductionWitness,
    PlacedNumbers,
)
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.model import findings as questions
from subdiv_cli.model.formulas import near_one, partial_operator
from subdiv_cli.spaces.lattice import Index


@asking()
def coset_sums(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD601: the coset sums.

    Theorem (Dyn 1992, Proposition 6.1; Cavaretta, Dahmen & Micchelli 1991): if S converges uniformly, to a limit that
    is not zero for some data, Σ_β a_(γ+Mβ) = 1 for every coset γ + M Z^s. Necessary, and with it S maps constants to
    themselves. No hypotheses.

    Witness: `cosets`, a representative of each; `sums`.
    """
    sums, count = numbers.sums, numbers.lattice.index
    witness: CosetSumsWitness = {"cosets": numbers.lattice.representatives, "sums": sums}
    if set(sums) == {Fraction(1)}:
        return (COSET_SUMS.proved(f"all {count} coset sums are 1", witness),)
    off = [(gamma, x) for gamma, x in zip(numbers.lattice.representatives, sums, strict=True) if x != 1]
    shown = ", ".join(f"that of {_tuple(gamma)} is {near_one(x)}" for gamma, x in off[:_MOST_COSETS])
    more = f", and {len(off) - _MOST_COSETS} more are not 1" if len(off) > _MOST_COSETS else ""
    return (COSET_SUMS.refuted(f"the {count} coset sums must be 1 each, but {shown}{more}", witness),)


_MOST_COSETS = 4
"""The most cosets that are named with a sum that is not 1."""


@asking((SUM_RULES, "which sum rules hold?"))
def sum_rules(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD602: the order of the sum rules of total degree.

    Definition (Jia 1998; Levin 2003, section 2): sum rules of order k, if for polynomials p of total degree < k the
    sums Σ_β a_(γ+Mβ) p(γ+Mβ) are the same for all cosets, those of p = 1 being 1. Then S maps polynomials of degree < k
    to such, with the same leading part up to the dilation: it generates them (Dyn 1992, 7.6). No hypotheses.

    Witness: `order`, the largest k.
    """
    k = numbers.order
    if not k:
        return (
            SUM_RULES.refuted(
                "no sum rules: the coset sums are not all 1",
                {"order": 0},
                answers={questions.SUM_RULES: 0},
                why="the coset sums are not all 1",
            ),
        )
    generated = {1: "constants", 2: "polynomials of total degree 1"}.get(k, f"polynomials of total degree {k - 1}")
    answers = {questions.SUM_RULES: k, questions.GENERATION: k - 1}
    return (SUM_RULES.proved(f"sum rules of order {k}: {generated} are generated", {"order": k}, answers=answers),)


@asking((REPRODUCTION, "which polynomials are reproduced?"))
def reproduction(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD618: the reproduction degree, the largest r for which S reproduces the polynomials of total degree r.

    Theorem (Levin 2003, section 2; Conti & Hormann 2011 and Charina & Conti 2013 for dilations cI; FORMAT.md for any
    expanding M). Let τ = (1/m) Σ_α a_α α, componentwise, and σ = (M - I)^-1 τ. S maps p(· + σ) to p(M^-1 (· + σ)) on
    Z^s for all p of degree <= r iff the sum rules hold of order r + 1 and Σ_α a_α α^μ = m τ^μ for |μ| <= r; no other σ
    does for r >= 1. In derivatives of the symbol, D^μ a(1, …, 1) = m Π_j τ_j (τ_j - 1) … (τ_j - μ_j + 1). So
    interpolatory masks reproduce what they generate. Hypotheses: none but sum rules, which are checked.

    Witness: `degree`; `shift`, τ; `defect`, a μ of degree r + 1 with another sum where r is below the generation
    degree.
    """
    if not numbers.order:
        return (REPRODUCTION.skipped("which polynomials are reproduced?", "no sum rule holds"),)
    degree, shift, defect = numbers.reproduction
    witness: MultivariateReproductionWitness = {"degree": degree, "shift": shift}
    if defect is None:
        limit = f"it generates degree {degree} only"
    else:
        witness["defect"] = defect
        limit = f"Σ a_α α^μ is not m τ^μ for μ = ({', '.join(map(str, defect))})"
    why = f"with parameter shift τ = ({', '.join(map(number, shift))}), not {degree + 1}: {limit}"
    statement = f"S reproduces the polynomials of total degree {degree} {why}"
    return (REPRODUCTION.proved(statement, witness, answers={questions.REPRODUCTION: degree}, why=why),)


_QUASI_INTERPOLATION_QUESTION = "which data have a given polynomial as limit?"
_MOST_TERMS = 12
"""The most terms of an operator or a stencil that are written out."""


@asking((QUASI_INTERPOLATION, _QUASI_INTERPOLATION_QUESTION))
def quasi_interpolation(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD619: the operator Q with S^∞ Q f = f for all polynomials f of the total degree that S generates.

    Theorem (Levin 2003, Corollary 2.4 and section 2.5 for 2I; FORMAT.md for any expanding M): let S converge, with sum
    rules of order d + 1. There is one Q = Σ q_μ D^μ, |μ| <= d, q_0 = 1, with S Q = Q σ on the polynomials of total
    degree d, σ f = f(M^-1 ·), and it inverts S^∞ there: Q f has the limit f. S^∞ f = Σ m_μ/μ! D^μ f with the moments
    m_μ = Σ_β φ(-β) β^μ, which the refinement equation gives degree by degree, as M is expanding
    (numbers/quasi_interpolation.py). Hypotheses, both checked: S converges (SD611), and the order of the sum rules
    (SD602). Stability is not asked for. The stencil is a combination of samples that is Q on these polynomials, near
    the centre of φ and with its symmetries; on other functions the two differ.

    Witness: `degree`, d; `centre`, c = (q_e1, …, q_es); pairs of an index and a number, none of them zero, for
    `moments`, `operator`, `stencil`, and `centred`, the operator of f -> Q f(· - c).
    """
    if facts.verdict(CONVERGENCE) is not Verdict.PROVED:
        return (QUASI_INTERPOLATION.skipped(_QUASI_INTERPOLATION_QUESTION, "S is not proved to converge"),)
    d, s = numbers.order - 1, numbers.dimension
    if not numbers.effort.allows(comb(d + s, s) ** 2):
        return (
            QUASI_INTERPOLATION.undecided(
                _QUASI_INTERPOLATION_QUESTION, f"degree {d} has too many derivatives for this effort"
            ),
        )
    q = numbers.quasi_interpolation
    witness: MultivariateQuasiInterpolationWitness = {
        "degree": d,
        "centre": q.centre,
        "moments": _pairs(q.moments),
        "operator": _pairs(q.operator),
        "centred": _pairs(q.centred),
        "stencil": _pairs(q.stencil),
    }
    return (QUASI_INTERPOLATION.proved(f"on polynomials of total degree {d} S^∞ Q f = f with {_formula(q)}", witness),)


def _pairs(values: Mapping[Index, Fraction]) -> PlacedNumbers:
    return tuple(sorted(values.items()))


def _formula(q: QuasiInterpolation) -> str:
    """The operator Q as text: `Q f(α) = (f - 1/6 f_xx)(α + (1, 1)), or the weights …`."""
    right = partial_operator(q.centred)
    if len(q.centred) > _MOST_TERMS:
        text = f"Q of {len(q.operator)} derivatives"
    elif not any(q.centre):
        text = f"Q f = {right}"
    else:
        text = f"Q f(α) = {right if len(q.centred) == 1 else f'({right})'}(α + {_tuple(q.centre)})"
    if len(q.stencil) == 1:
        return text
    if len(q.stencil) > _MOST_TERMS:
        return f"{text}, a stencil of {len(q.stencil)} weights"
    places: dict[Fraction, list[Index]] = {}
    for j in sorted(q.stencil, key=lambda j: (-abs(q.stencil[j]), j)):
        places.setdefault(q.stencil[j], []).append(j)
    weights = "; ".join(f"{number(x)} at {', '.join(map(_tuple, places[x]))}" for x in places)
    return f"{text}, a stencil with the weights {weights}"


def _tuple(point: Point | Index) -> str:
    return f"({', '.join(number(Fraction(x)) for x in point)})"
