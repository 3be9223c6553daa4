"""Findings on polynomials, smoothness and exponents as claims."""

from __future__ import annotations

from fractions import Fraction
from typing import cast

from subdiv_cli.certificate.claims import Json
from subdiv_cli.certificate.radius import root_fields
from subdiv_cli.certificate.witness import as_integer, as_rational, as_tuple, as_word
from subdiv_cli.kinds.vector import rules
from subdiv_cli.kinds.vector.claims.proof import Map, VectorProof, rationals
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.model.closed import rational


def eigen_sequences(proof: VectorProof, finding: Finding) -> list[int]:
    """The claims of SD702: the order of the eigen-sequences, and the degree of generation."""
    k, r, p, m = as_integer(finding.witness["order"]), proof.dimension, proof.p, proof.size
    uses = [proof.constants()]
    if not r:
        return [proof.claims.prove("eigen-sequences", {"order": k}, uses=uses)]
    found = finding.proof
    sequences = [
        [[rationals(x) for coefficient in as_tuple(y) for x in as_tuple(coefficient)] for y in as_tuple(rows)]
        for rows in as_tuple(found["sequences"])
    ]
    witness: Json = {"sequences": sequences}
    witness |= {key: rationals(found[key]) for key in ("multipliers", "functional")}
    work = (r + 1) * (k + 1) ** 3 * (p * m * m + proof.length) + proof.entries * (k + 1)
    claim = proof.claims.prove("eigen-sequences", {"order": k}, witness, uses, work)
    return [claim, proof.claims.prove("generation", {"degree": k - 1}, uses=[claim])]


def mean_matrix(proof: VectorProof, finding: Finding) -> list[int]:
    """The claim of SD703."""
    statement = {"holds": finding.verdict is Verdict.PROVED}
    work = proof.entries + proof.size**4
    return [proof.claims.prove("mean-matrix", statement, uses=[proof.constants()], work=work)]


def smoothness(proof: VectorProof, finding: Finding) -> list[int]:
    """The claim of SD708: all limits are C^n."""
    n, uses = as_integer(finding.witness["order"]), [proof.convergent()]
    if finding.witness["by"] == rules.CONVERGENCE.code:
        return [proof.claims.prove("continuous", {"property": "smooth", "order": n}, uses=uses)]
    return [proof.claims.prove("smooth", {"order": n}, uses=[*uses, *proof.growth()])]


def next_smoothness(proof: VectorProof, finding: Finding) -> list[int]:
    """The claim of SD709: not all limits are C^n."""
    n, word = as_integer(finding.witness["order"]), as_word(finding.witness)
    found = proof.found[rules.STENCIL_RADIUS]
    k, root = as_integer(found.witness["order"]), cast("Map | None", found.witness.get("root"))
    uses = [proof.convergent()]
    if root is not None:
        x = as_rational(root["low"]) * proof.p ** (min(n, k) * as_integer(found.witness["length"]))
        if x >= 1 if n < k else x > 1:
            return [proof.claims.prove("not-smooth", {"order": n}, uses=[*uses, *proof.growth()])]
    bound = Fraction(1, proof.p ** (n * len(word)))
    if n >= k:
        upper = proof.found[rules.HOLDER_UPPER].witness
        bound = as_rational(upper["radius"])
    below = proof.word(k, cast(Map, found.proof["space"]), word, bound)
    return [proof.claims.prove("not-smooth", {"order": n}, uses=[*uses, *below])]


def holder_lower(proof: VectorProof, finding: Finding) -> list[int]:
    """The claim of SD710: the Hölder exponent from below, or what it is where the radius is known."""
    if "root" in finding.witness:
        return [_exponent(proof)]
    statement: Json = {"length": finding.witness["length"], "bound": rational(as_rational(finding.witness["bound"]))}
    return [proof.claims.prove("holder-lower", statement, uses=[proof.convergent(), *proof.growth()])]


def holder_upper(proof: VectorProof, finding: Finding) -> list[int]:
    """The claim of SD711: the Hölder exponent from above."""
    if "root" in proof.found[rules.HOLDER_LOWER].witness:
        return [_exponent(proof)]
    bound = as_rational(finding.witness["radius"])
    found = proof.found[rules.STENCIL_RADIUS]
    below = proof.word(
        as_integer(found.witness["order"]), cast(Map, found.proof["space"]), as_word(finding.witness), bound
    )
    statement: Json = {"length": finding.witness["length"], "bound": rational(bound)}
    return [proof.claims.prove("holder-upper", statement, uses=[proof.convergent(), *below])]


def _exponent(proof: VectorProof) -> int:
    """The claim that says what α is."""
    found = proof.found[rules.HOLDER_LOWER].witness
    statement = {"length": found["length"], **root_fields(cast(Map, found["root"]))}
    return proof.claims.prove("holder-root", statement, uses=[proof.convergent(), *proof.growth()])


def attained(proof: VectorProof, finding: Finding) -> list[int]:
    """The claim of SD712: the Hölder exponent is attained, or is not."""
    k, space = as_integer(finding.witness["order"]), cast(Map, finding.proof["space"])
    holds = finding.verdict is Verdict.PROVED
    statement = {"property": "attained", "holds": holds}
    if not holds:
        grown = proof.defective(k, space, finding.witness)
        return [proof.claims.prove("not-attained", statement, uses=[*grown, _exponent(proof)])]
    bounded = proof.radius(k, space, cast(Map, finding.proof["radius"]))
    return [proof.claims.prove("attained", statement, uses=[*bounded, _exponent(proof)])]


def derived_schemes(proof: VectorProof, finding: Finding) -> list[int]:
    """The claims of SD713: derived schemes one after the other, the norm of the last one, and what follows."""
    found, m, p = finding.proof, proof.size, proof.p
    keys = ("transformations", "dimensions", "starts", "masks")
    last, before, length = None, proof.length, proof.length
    for n, step in enumerate(zip(*(as_tuple(found[key]) for key in keys), strict=True), 1):
        transformation, r, start, mask = step
        before, length = length, len(as_tuple(mask))
        work = (before + length + p + 2) * 4 * m**3 + (before * m * m + p * m * m) * (as_integer(r) + 1)
        witness: Json = {"transformation": rationals(transformation), "dimension": r, "start": start}
        witness["coefficients"] = rationals(mask)
        last = proof.claims.prove("derived", {"order": n}, witness, [] if last is None else [last], work)
    assert last is not None
    n, level = as_integer(finding.witness["derivations"]), as_integer(finding.witness["level"])
    size = (length - 1) * (p**level - 1) // (p - 1) + 1
    statement: Json = {"order": n, "level": level, "norm": rational(as_rational(finding.witness["norm"]))}
    work = 2 * m**3 * length * size + m * m * size
    norm = proof.claims.prove("derived-norm", statement, uses=[last], work=work)
    order = as_integer(finding.witness["order"])
    return [norm, proof.claims.prove("derived-smooth", {"property": "smooth", "order": order}, uses=[norm])]
