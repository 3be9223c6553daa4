"""SD619: the operator Q with S^∞ Q f = f for all polynomials f of the total degree that S generates.

Theorem (Levin 2003, Corollary 2.4 and section 2.5 for 2I; MULTIVARIATE.md for any expanding M): let S converge, with
sum rules of order d + 1. There is one Q = Σ q_μ D^μ, |μ| <= d, q_0 = 1, with S Q = Q σ on the polynomials of total
degree d, σ f = f(M^-1 ·), and it inverts S^∞ there: Q f has the limit f. S^∞ f = Σ m_μ/μ! D^μ f with the moments
m_μ = Σ_β φ(-β) β^μ, which the refinement equation gives degree by degree, as M is expanding
(quantities/lattice_quasi_interpolation.py). Hypotheses, both checked: S converges (SD611), and the order of the sum
rules (SD602). Stability is not asked for. The stencil is a combination of samples that is Q on these polynomials,
near the centre of φ and with its symmetries; on other functions the two differ.

Witness: `degree`, d; `centre`, c = (q_e1, …, q_es); pairs of an index and a number, none of them zero, for `moments`,
`operator`, `stencil`, and `centred`, the operator of f -> Q f(· - c).
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import comb

from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.numbers.quasi_interpolation import Point, QuasiInterpolation
from subdiv_cli.kinds.multivariate.scheme import Index
from subdiv_cli.model import Data, Finding, Verdict
from subdiv_cli.model.formulas import partial_operator

RULE = rules.QUASI_INTERPOLATION

_QUESTION = "which data have a given polynomial as limit?"
_MOST_TERMS = 12
"""Of an operator or a stencil that is written out."""


def run(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    if facts.verdict(rules.CONVERGENCE) is not Verdict.PROVED:
        return (RULE.skipped(_QUESTION, "S is not proved to converge"),)
    d, s = numbers.order - 1, numbers.dimension
    if not numbers.effort.allows(comb(d + s, s) ** 2):
        return (RULE.undecided(_QUESTION, f"degree {d} has too many derivatives for this effort"),)
    found = numbers.quasi_interpolation
    witness: dict[str, Data] = {
        "degree": d,
        "centre": found.centre,
        "moments": _pairs(found.moments),
        "operator": _pairs(found.operator),
        "centred": _pairs(found.centred),
        "stencil": _pairs(found.stencil),
    }
    return (RULE.proved(f"on polynomials of total degree {d} S^∞ Q f = f with {_formula(found)}", witness),)


def _pairs(values: Mapping[Index, Fraction]) -> tuple[tuple[Index, Fraction], ...]:
    return tuple(sorted(values.items()))


def _formula(found: QuasiInterpolation) -> str:
    """`Q f(α) = (f - 1/6 f_xx)(α + (1, 1)), or the weights …`."""
    right = partial_operator(found.centred)
    if len(found.centred) > _MOST_TERMS:
        text = f"Q of {len(found.operator)} derivatives"
    elif not any(found.centre):
        text = f"Q f = {right}"
    else:
        text = f"Q f(α) = {right if len(found.centred) == 1 else f'({right})'}(α + {_tuple(found.centre)})"
    if len(found.stencil) == 1:
        return text
    if len(found.stencil) > _MOST_TERMS:
        return f"{text}, a stencil of {len(found.stencil)} weights"
    places: dict[Fraction, list[Index]] = {}
    for j in sorted(found.stencil, key=lambda j: (-abs(found.stencil[j]), j)):
        places.setdefault(found.stencil[j], []).append(j)
    weights = "; ".join(f"{number(x)} at {', '.join(map(_tuple, places[x]))}" for x in places)
    return f"{text}, a stencil with the weights {weights}"


def _tuple(point: Point | Index) -> str:
    return f"({', '.join(number(Fraction(x)) for x in point)})"
