"""The certificate of one scalar mask: every finding that is proved or refuted becomes a claim (see FORMAT.md)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from subdiv_cli.certificate.claims import Claims, Json, mask_document, matrices_document, rational
from subdiv_cli.certificate.radius import Radii
from subdiv_cli.certificate.witness import as_rational, as_word
from subdiv_cli.kinds.scalar.claims import smoothness, sobolev, structure, values
from subdiv_cli.kinds.scalar.claims.proof import Proof
from subdiv_cli.model import Finding, Verdict

if TYPE_CHECKING:
    from subdiv_cli.model.family import FamilyRadius

MOST_WORK = 50_000_000
"""What the checker does for one certificate; a longer one is not written."""

CLAIMS: Mapping[str, Callable[[Proof, Finding], list[int]]] = {
    "SD101": structure.residue_sums,
    "SD102": lambda proof, _: [proof.sum_rules(0)],
    "SD103": structure.generation,
    "SD104": structure.reproduction,
    "SD105": structure.derived,
    "SD201": smoothness.convergence,
    "SD202": structure.eigen_condition,
    "SD301": smoothness.contractivity,
    "SD302": smoothness.smoothness,
    "SD303": smoothness.next_smoothness,
    "SD304": structure.smoothness_spectrum,
    "SD310": smoothness.joint_radius,
    "SD311": smoothness.holder_lower,
    "SD312": smoothness.holder_upper,
    "SD313": smoothness.attained,
    "SD321": sobolev.sobolev,
    "SD401": structure.independence,
    "SD402": structure.stability,
    "SD403": lambda proof, _: list(proof.reductions),
    "SD501": values.integer_values,
    "SD502": values.stencils,
    "SD503": values.quasi_interpolation,
    "SD504": values.approximation_order,
    "SD505": values.interpolatory_order,
    "SD511": values.error_bound,
    "SD512": values.hermite_bound,
}
"""The numbers of the claims that say what a decided finding says, by code; none where its witness is missing."""


class Certificate(NamedTuple):
    """A document as FORMAT.md has it, and for each finding the numbers of the claims that say the same."""

    document: Json
    claims: tuple[tuple[int, ...], ...]


def certificate(
    arity: int, start: int, coefficients: Sequence[Fraction], findings: Sequence[Finding]
) -> Certificate | None:
    """The proof of the proved and refuted findings on this mask, its goal in their order.

    A finding whose witness was too costly to compute (large Bezout cofactors) has no claims. None where the whole asks
    more of the checker than it does.
    """
    proof = Proof(arity, len(coefficients) - 1, findings)
    decided = (Verdict.PROVED, Verdict.REFUTED)
    claims = tuple(tuple(CLAIMS[found.code](proof, found)) if found.verdict in decided else () for found in findings)
    if sum(claim["work"] for claim in proof.claims.made) > MOST_WORK:
        return None
    document = {
        "format": "subdiv-certificate",
        "version": 1,
        "mask": mask_document(arity, start, coefficients),
        "goal": [proof.claims.statement(number) for number in dict.fromkeys(n for numbers in claims for n in numbers)],
        "claims": proof.claims.made,
    }
    return Certificate(document, claims)


def family_certificate(matrices: Sequence[Sequence[Sequence[Fraction]]], radius: FamilyRadius) -> Json | None:
    """The proof of the bounds of a joint spectral radius; None where there are none."""
    if not radius.proof:
        return None
    claims = Claims()
    upper = Radii(claims, [None], radius.letters, []).claim(radius.proof, 0, radius.order)
    goal = [claims.statement(upper)]
    if radius.below:
        word, order = as_word(radius.below), radius.order
        statement = {"family": 0, "length": len(word), "bound": rational(as_rational(radius.below["bound"]))}
        work = len(word) * order**3 + order**4
        lower = claims.add("word", {"property": "radius-lower", **statement}, {"word": list(word)}, [], work)
        goal.append(claims.statement(lower))
    if sum(claim["work"] for claim in claims.made) > MOST_WORK:
        return None
    return {
        "format": "subdiv-certificate",
        "version": 1,
        "mask": matrices_document(matrices),
        "goal": goal,
        "claims": claims.made,
    }
