"""Stages that prove convergence or smoothness by norms (SD604, SD606 to SD608), or exclude it by the places (SD620)."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from subdiv_cli.exact.text import sized, valued
from subdiv_cli.kinds.kind import Facts, asking
from subdiv_cli.kinds.multivariate.numbers.directional import Contraction, PairContraction
from subdiv_cli.kinds.multivariate.numbers.matrix_norms import MatrixNorm
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.rules import (
    DIRECTIONAL_NORMS,
    DIRECTIONAL_SMOOTHNESS,
    MATRIX_NORMS,
    POSITIVE_MASK,
    SUBLATTICE,
)
from subdiv_cli.kinds.multivariate.stages.smoothness import proved_by, reaches
from subdiv_cli.kinds.multivariate.stages.wording import threshold
from subdiv_cli.kinds.multivariate.witnesses import (
    DirectionalNormsWitness,
    DirectionalSmoothnessWitness,
    MatrixNormsProof,
    MatrixNormsWitness,
    QuotientsProof,
    SublatticeWitness,
)
from subdiv_cli.model import Finding


def _quotients(contractions: Sequence[Contraction | PairContraction]) -> QuotientsProof:
    """What a certificate of contractions needs besides their norms."""
    return {"quotients": tuple(tuple(sorted(c.quotient.items())) for c in contractions)}


@asking()
def directional_norms(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD604: directional difference schemes that contract.

    Theorem (Dyn 1992, remark after Proposition 6.10, for any dilation c I): let a(z) = d_i(z) (1 + z^θ_i + … +
    z^((c-1)θ_i)) for s directions with det(θ_1, …, θ_s) = ±1, and let the coset sums be 1. Then Δ_θ_i S = S_(d_i)
    Δ_θ_i, and if ‖S_(d_i)^L‖∞ < 1 for each i and some L, S converges uniformly. Hypotheses: all checked. Sufficient
    only.

    There is a finding only where the mask has such factors and they all contract within the effort, and where it is no
    tensor product (SD609).

    Witness: `directions`, `levels`, `norms`.
    """
    contractions = None if numbers.parts else numbers.contractions
    if contractions is None:
        return ()
    parts = [
        f"‖S_({', '.join(map(str, c.direction))})" + (f"^{c.level}" if c.level > 1 else "") + f"‖∞ = {valued(c.norm)}"
        for c in contractions
    ]
    statement = f"the difference schemes in {len(contractions)} directions contract: {', '.join(parts)}"
    witness: DirectionalNormsWitness = {
        "directions": tuple(c.direction for c in contractions),
        "levels": tuple(c.level for c in contractions),
        "norms": tuple(c.norm for c in contractions),
    }
    return (DIRECTIONAL_NORMS.proved(statement, witness, proof=_quotients(contractions)),)


@asking()
def stays_in_sublattice(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD620: the mask stays in a lattice that is not Z^s.

    Theorem (numbers/sublattice.py): let Γ be the smallest lattice with MΓ ⊂ Γ that holds the differences of the indices
    with coefficients. If Γ is not Z^s, S^L δ is zero outside of one coset of Γ for each L, and S does not converge
    uniformly to a limit that is not zero for some data. No hypothesis: any expanding M, any sums. There is a finding
    only where Γ is not Z^s, and φ is no tensor product (SD609).

    Witness: `index` of Γ in Z^s, None where Γ spans no more than a hyperplane; `functional`, u, and `modulus`, n: u·x =
    0 modulo n on Γ, and not on Z^s.
    """
    stays = None if numbers.parts else numbers.sublattice
    if stays is None:
        return ()
    u = ", ".join(map(str, stays.functional))
    statement = f"for every L, ({u})·α is one number modulo {stays.modulus} for all α with S^L δ ≠ 0 there"
    witness: SublatticeWitness = {
        "index": stays.cosets,
        "functional": stays.functional,
        "modulus": stays.modulus,
    }
    return (SUBLATTICE.proved(statement, witness),)


@asking()
def positive_mask(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD608: a positive mask on a box.

    Theorem (Dyn 1992, Theorem 6.4, for M = cI): let the coset sums be 1, let the support be all indices of a box Π[l_i,
    u_i], the coefficients there positive, and u_i - l_i >= c for each i. Then S converges uniformly. Hypotheses: all
    checked. Dyn asks for l < 0 < u with c = 2: a shift of the mask by e shifts S^k f by (c^k - 1)/(c - 1) e, its limit
    by e/(c - 1), so only the sides of the box matter, and u_i - l_i >= 2 allows such a shift. With a side c - 1 nothing
    is said: Haar's mask, all ones on c indices, is positive.

    Witness: `lowest`, `highest`, the corners.
    """
    if set(numbers.sums) != {Fraction(1)} or not numbers.is_positive_on_a_box:
        return ()
    lowest, highest = numbers.scheme.bounds()
    size = " by ".join(str(high - low + 1) for low, high in zip(lowest, highest, strict=True))
    statement = f"S converges uniformly: the mask is positive on a full box, {size} coefficients"
    return (POSITIVE_MASK.proved(statement, {"lowest": lowest, "highest": highest}),)


@asking()
def directional_smoothness(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD607: C^1 by directional factors.

    Theorem (Dyn 1992, Corollary 7.9, for M = cI): let the coset sums be 1, a(z) = q(z) Π_(i<=s+1) G_i(z), G_i(z) = 1 +
    z^θ_i + … + z^((c-1)θ_i), any s of the directions with determinant ±1. If the schemes of all a_ij = c a/(G_i G_j), i
    < j, contract, ‖S_(a_ij)^L‖∞ < 1 for some L each, S converges uniformly and φ is C^1. Hypotheses: all checked.
    Sufficient.

    Why: ∇_i ∇_j S = (1/c) S_(a_ij) ∇_i ∇_j, and the (1-z^θ_i)(1-z^θ_j), i < j, generate all polynomials that vanish at
    1 to order 2: any s+1 such directions are ±θ_1 ± … ± θ_s = 0 with one more, so u_i² is among the products modulo
    order 3, and elsewhere some product is not 0. So ρ_2 < 1/c, and the sum rules are of order 2.

    There is a finding only where the mask has such factors and all quotients contract within the effort, and φ is
    neither a box spline (SD603) nor a tensor product (SD609).

    Witness: `directions`, pairs; `levels`, `norms`. `proof`: `quotients`, a/(G_i G_j).
    """
    contractions = None if numbers.box is not None or numbers.parts else numbers.pair_contractions
    if contractions is None:
        return ()
    parts = [
        f"‖S_({', '.join(map(str, first))})({', '.join(map(str, second))})"
        + (f"^{c.level}" if c.level > 1 else "")
        + f"‖∞ = {valued(c.norm)}"
        for c in contractions
        for first, second in [c.directions]
    ]
    statement = (
        f"φ is C^1: the schemes of {len(parts)} quotients by two directional factors contract: {', '.join(parts)}"
    )
    witness: DirectionalSmoothnessWitness = {
        "directions": tuple(c.directions for c in contractions),
        "levels": tuple(c.level for c in contractions),
        "norms": tuple(c.norm for c in contractions),
    }
    return (DIRECTIONAL_SMOOTHNESS.proved(statement, witness, proof=_quotients(contractions)),)


_MORE_ORDERS = 2
"""The orders of differences above n + 1 that are tried for C^n."""


@asking()
def matrix_norms(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD606: a matrix scheme of differences that contracts.

    Theorem (Dyn 1992, Theorems 6.9 and 7.5 with Propositions 6.8 and 6.10; here for any expanding M): let the sum rules
    hold of order k >= 1, and ∇^μ S^r = Σ_ν S_(q_μν) ∇^ν, |μ| = |ν| = k, with the norm ‖S_Q^t‖∞ = x. Then ρ_k^(rt) <= x.
    So S converges uniformly if x < 1, and for isotropic M, λ = |det M|^(1/s), φ is C^n if n < k and x < λ^(-nrt). For M
    = 2I and k = n + 1 that is ‖(½S_(n+1))^t‖∞ < 1, S_(n+1) = 2^(n+1) S_Q. Hypotheses: the sum rules (SD602), M
    isotropic for n >= 1; checked. Q is constructed (numbers/matrix_schemes.py). Sufficient only, for one Q and level.

    There is a finding only where some Q contracts within the effort, and φ is neither a box spline (SD603) nor a tensor
    product (SD609). Convergence is asked where directional norms (SD604) do not prove it; C^n where ρ_k (SD605) and
    mean squares (SD617) do not tell.

    Witness: `order` k, `smooth` n, `power` r, `steps` t, `level` rt, `norm` x; `by`: `lemma` (6.6) or `least`, the
    reduction; `lemma_norm`, `least_norm`, ‖S_Q‖∞ of both, as far as they were asked for. `proof`: Q, and the work to
    multiply it out.
    """
    if not numbers.order or numbers.box is not None or numbers.parts:
        return ()
    best = None
    if numbers.contractions is None and not _excluded(numbers, 0):
        best = _norm(numbers, 0, [1])
    if numbers.lattice.is_isotropic:
        for n in range(1, numbers.order):
            if not proved_by(numbers, facts, n):
                orders = range(n + 1, min(numbers.order, n + 1 + _MORE_ORDERS) + 1)
                smoother = None if _excluded(numbers, n) else _norm(numbers, n, orders)
                if smoother is None:
                    break
                best = smoother
    return () if best is None else (_finding(numbers, *best),)


def _excluded(numbers: MultivariateNumbers, n: int) -> bool:
    return numbers.product is not None and reaches(numbers, numbers.product, n)


def _norm(numbers: MultivariateNumbers, n: int, orders: range | list[int]) -> tuple[int, MatrixNorm] | None:
    norms = (numbers.matrix_norm(k, n) for k in orders)
    return next(((n, norm) for norm in norms if norm is not None), None)


def _finding(numbers: MultivariateNumbers, n: int, norm: MatrixNorm) -> Finding:
    k, components = norm.order, range(norm.components)
    witness: MatrixNormsWitness = {
        "order": k,
        "smooth": n,
        "power": norm.power,
        "steps": norm.steps,
        "level": norm.level,
        "norm": norm.norm,
        "by": norm.by,
        "lemma_norm": norm.lemma,
    }
    if norm.least is not None:
        witness["least_norm"] = norm.least
    entries = [sorted(norm.entries.get((i, j), {}).items()) for i in components for j in components]
    proof: MatrixNormsProof = {"entries": tuple(tuple(terms) for terms in entries), "work": norm.work}
    scheme = "S_Δ" if k == 1 else f"S_(Δ^{k})"
    power = f"^{norm.level}" if norm.level > 1 else ""
    bound = threshold(numbers, n * norm.level)
    statement = f"a matrix scheme of differences contracts: ‖{scheme}{power}‖∞ = {valued(norm.norm)} < {bound}"
    return MATRIX_NORMS.proved(f"{statement}; {_how(norm)}", witness, proof=proof)


def _how(norm: MatrixNorm) -> str:
    """The reduction that is taken, as text, and ‖S_Q‖∞ for it and the other."""
    of = f" of S^{norm.power}" if norm.power > 1 else ""
    names = {"lemma": "Lemma 6.6", "least": "least norm"}
    norms = {"lemma": norm.lemma, "least": norm.least}
    other = {"lemma": "least", "least": "lemma"}[norm.by]
    taken = f"the reduction{of} by {names[norm.by]}, {sized(norms[norm.by] or norm.lemma)}"
    second = norms[other]
    return taken if second is None else f"{taken} (by {names[other]}: {sized(second)})"
