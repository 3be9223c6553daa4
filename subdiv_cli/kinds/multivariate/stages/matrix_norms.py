"""SD606: a matrix scheme of differences that contracts.

Theorem (Dyn 1992, Theorems 6.9 and 7.5 with Propositions 6.8 and 6.10; here for any expanding M): let the sum rules
hold of order k >= 1, and ∇^μ S^r = Σ_ν S_(q_μν) ∇^ν, |μ| = |ν| = k, with the norm ‖S_Q^t‖∞ = x. Then ρ_k^(rt) <= x. So
S converges uniformly if x < 1, and for isotropic M, λ = |det M|^(1/s), φ is C^n if n < k and x < λ^(-nrt).
For M = 2I and k = n + 1 that is ‖(½S_(n+1))^t‖∞ < 1, S_(n+1) = 2^(n+1) S_Q. Hypotheses: the sum rules (SD602), M
isotropic for n >= 1; checked. Q is constructed (numbers/matrix_schemes.py). Sufficient only, for one Q and level.

There is a finding only where some Q contracts within the effort, and φ is neither a box spline (SD603) nor
a tensor product (SD609). Convergence is asked
where directional norms (SD604) do not prove it; C^n where ρ_k (SD605) and mean squares (SD617) do not tell.

Witness: `order` k, `smooth` n, `power` r, `steps` t, `level` rt, `norm` x; `by`: `lemma` (6.6) or `least`, the
reduction; `lemma_norm`, `least_norm`, ‖S_Q‖∞ of both, as far as they were asked for. `proof`: Q, and the work to
multiply it out.
"""

from __future__ import annotations

from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.numbers.matrix_norms import MatrixNorm
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.stages.smoothness import proved_by, reaches, threshold
from subdiv_cli.model import Data, Finding

RULE = rules.MATRIX_NORMS

_MORE_ORDERS = 2
"""Orders of differences above n + 1 that are tried for C^n."""


def run(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    if not numbers.order or numbers.box is not None or numbers.parts:
        return ()
    best = None
    if numbers.contractions is None and not _excluded(numbers, 0):
        best = _found(numbers, 0, [1])
    if numbers.lattice.is_isotropic:
        for n in range(1, numbers.order):
            if proved_by(numbers, facts, n) is None:
                orders = range(n + 1, min(numbers.order, n + 1 + _MORE_ORDERS) + 1)
                smoother = None if _excluded(numbers, n) else _found(numbers, n, orders)
                if smoother is None:
                    break
                best = smoother
    return () if best is None else (_finding(numbers, *best),)


def _excluded(numbers: MultivariateNumbers, n: int) -> bool:
    return numbers.product is not None and reaches(numbers, numbers.product, n)


def _found(numbers: MultivariateNumbers, n: int, orders: range | list[int]) -> tuple[int, MatrixNorm] | None:
    norms = (numbers.matrix_norm(k, n) for k in orders)
    return next(((n, found) for found in norms if found is not None), None)


def _finding(numbers: MultivariateNumbers, n: int, found: MatrixNorm) -> Finding:
    k, components = found.order, range(found.components)
    witness: dict[str, Data] = {
        "order": k,
        "smooth": n,
        "power": found.power,
        "steps": found.steps,
        "level": found.level,
        "norm": found.norm,
        "by": found.by,
        "lemma_norm": found.lemma,
        **({} if found.least is None else {"least_norm": found.least}),
    }
    entries = [sorted(found.entries.get((i, j), {}).items()) for i in components for j in components]
    proof: dict[str, Data] = {"entries": tuple(tuple(terms) for terms in entries), "work": found.work}
    scheme = "S_Δ" if k == 1 else f"S_(Δ^{k})"
    power = f"^{found.level}" if found.level > 1 else ""
    bound = threshold(numbers, n * found.level)
    statement = f"a matrix scheme of differences contracts: ‖{scheme}{power}‖∞ = {number(found.norm)} < {bound}"
    return RULE.proved(f"{statement}; {_how(found)}", witness, proof=proof)


def _how(found: MatrixNorm) -> str:
    """Which reduction is taken, and what ‖S_Q‖∞ is for it and the other."""
    of = f" of S^{found.power}" if found.power > 1 else ""
    names = {"lemma": "Lemma 6.6", "least": "least norm"}
    norms = {"lemma": found.lemma, "least": found.least}
    other = {"lemma": "least", "least": "lemma"}[found.by]
    taken = f"the reduction{of} by {names[found.by]}, {number(norms[found.by] or found.lemma)}"
    second = norms[other]
    return taken if second is None else f"{taken} (by {names[other]}: {number(second)})"
