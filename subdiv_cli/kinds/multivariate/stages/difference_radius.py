"""SD605: ρ_k, the joint spectral radius of the transition operators T_ε on V_k, k the order of the sum rules.

V_k is the smallest space that holds the differences ∇^μ δ, |μ| = k, and is mapped into itself by the T_ε; its basis and
the matrices are exact (numbers/difference_space.py, with the theorems on ρ_k). It is not the smallest invariant
window with polynomials divided out: differences that cross windows count. The radius is found and proved as SD310 says.
Hypothesis, k >= 1: checked. Not asked of tensor products (SD609), nor where φ is a box spline (SD603) and convergence
is proved without it (SD604, SD617).

Witness: `order`, k; `dimension` of V_k; `method`; `word` of a product, as numbers of coset representatives; `length`
and `bound`, or `length` and `root`: ρ_k^length is at most the bound, or is the root. `proof`: the space and the radius.
"""

from __future__ import annotations

from typing import Any

from subdiv_cli.exact.linalg import rows_of
from subdiv_cli.exact.text import rounded_up
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.numbers.difference_space import DifferenceSpace
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.scalar.stages.joint_radius import enclosed, shown
from subdiv_cli.kinds.scalar.stages.stage import product_name
from subdiv_cli.model import Data, Finding

RULE = rules.DIFFERENCE_RADIUS

_QUESTION = "how fast do differences decay?"


def run(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    if not numbers.order:
        return (RULE.skipped(_QUESTION, "no sum rule holds"),)
    if numbers.parts:
        return (RULE.skipped(_QUESTION, "φ is a tensor product, and its factors decide"),)
    contracts = numbers.contractions is not None or ((mean := numbers.mean_decay) is not None and mean < 1)
    if numbers.box is not None and contracts:
        return (RULE.skipped(_QUESTION, "φ is a box spline, and S is seen to converge without it"),)
    space, radius = numbers.space, numbers.radius
    if space is None:
        return (RULE.undecided(_QUESTION, f"the space V_{numbers.order} of differences is too large"),)
    if radius is None:
        ended = "time budget" if numbers.effort.struck else "effort"
        return (RULE.undecided(_QUESTION, f"the {ended} ended before a bound"),)
    witness: dict[str, Data] = {
        "order": space.order,
        "dimension": space.basis.nrows(),
        "method": radius.proof["rule"],
        **({} if radius.word is None else {"word": radius.word}),
        **{key: radius.proof[key] for key in ("length", "root", "bound") if key in radius.proof},
    }
    value = enclosed(radius)
    size = f"≤ {rounded_up(value.upper or 0.0, 12)}" if radius.exact is None else f"= {shown(radius)}"
    statement = f"ρ_{space.order} {size} on V_{space.order} of dimension {space.basis.nrows()}{_how(radius)}"
    return (RULE.proved(statement, witness, value, proof={"space": _data(numbers, space), "radius": radius.proof}),)


def _how(radius: Radius) -> str:
    parts: Any = radius.proof.get("sizes")
    by = f": {len(parts)} diagonal blocks" if parts else ""
    attains = f", attained by {product_name(radius.word)}" if radius.exact is not None and radius.word else ""
    return by + attains


def _data(numbers: MultivariateNumbers, space: DifferenceSpace) -> dict[str, Data]:
    """The space as certificates have it."""
    return {
        "order": space.order,
        "cosets": numbers.lattice.representatives,
        "window": space.window,
        "basis": tuple(tuple(int(x) for x in row) for row in rows_of(space.basis)),
        "matrices": tuple(rows_of(m) for m in space.matrices),
        "generators": rows_of(space.generators),
    }
