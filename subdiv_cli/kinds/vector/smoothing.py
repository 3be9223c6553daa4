"""Smoother schemes and derived schemes of vector masks, of any arity p (Moosmüller & Dyn 2018, section 4).

Let the first r columns of an invertible R span E_A, r its dimension, and Δ_R = R diag(Δ I, I) R^-1, Δ I of r
components. Procedure 23 goes from B to the mask A with Δ_R S_A = (1/p) S_B Δ_R, where R is canonical for B: its other
columns span the invariant space of M_B = (1/p) Σ B_i for the eigenvalues other than 1. In the coordinates of R

    A(z) = (1/p) diag(1/(z^-1 - 1), 1) B(z) diag(z^-p - 1, 1),

which is a Laurent polynomial since B_12(1) = 0; it does not depend on which canonical R is taken, as a constant
block-diagonal matrix commutes with diag(Δ I, I). Where S_B converges, p^n Δ_R S_A^n c = S_B^n Δ_R c, so limits of S_A,
which have values in E_A = E_B, are integrals of limits of S_B, and each of these occurs, as Δ_R is onto: α grows by
exactly 1.

∂A of `derived` solves the same equation for B, with R canonical for A. Where S_∂A converges, its limits are, in these
coordinates, the derivatives of those of S_A and m - r other components, in E_∂A. So its exponent is at most α - 1; it
is α - 1 where E_∂A has the dimension r, since derivatives of limits have values in no smaller space: the others are
combinations of them then. It may be less where E_∂A is larger: what dies out under S_A need not under S_∂A. Where
Procedure 23 applies to ∂A, it leads back to A iff E_∂A = E_A. The other way round ∂ leads from A = I B to B where one R
is canonical for both; else to the mask W(z) B(z) W(z^p)^-1 with a unimodular W, whose limits are those of B.
"""

from __future__ import annotations

from flint import fmpq_mat, fmpq_poly

from subdiv_cli.exact.linalg import identity, matrix, rows_of
from subdiv_cli.exact.rationals import to_fmpq
from subdiv_cli.kinds.kind import NotSmoothedError, SmoothingStep
from subdiv_cli.kinds.vector.numbers import derived as derivation
from subdiv_cli.kinds.vector.numbers.derived import Terms
from subdiv_cli.kinds.vector.scheme import VectorScheme

_SOURCE = "Moosmüller, Dyn 2018"


def smoother(scheme: VectorScheme) -> SmoothingStep:
    """The scheme of Procedure 23; its support begins at most p lower (Corollary 25).

    Hypotheses: E_B ≠ 0, and 1 is an eigenvalue of M_B with the multiplicity dim E_B, so that it is semisimple and its
    eigenspace is E_B: what Theorem 19 and Corollary 20 say of schemes that converge. Raises NotSmoothedError without.
    """
    p, terms = scheme.arity, terms_of(scheme)
    transformation, r = canonical(p, terms)
    moved = conjugated(terms, transformation)
    smooth = conjugated(integrated(p, moved, r), transformation.inv())
    return SmoothingStep(scheme_of(p, smooth), 1, f"procedure 23 of {_SOURCE}", f"dim E_B = {r}")


def derived(scheme: VectorScheme) -> SmoothingStep:
    """The derived scheme with respect to Δ_R; its support ends at most p lower.

    Hypotheses as for `smoother`, of A: E_A ≠ 0 is what ∂A needs (Lemma 15), the rest makes R canonical. Raises
    NotSmoothedError without.
    """
    p, terms = scheme.arity, terms_of(scheme)
    transformation, r = canonical(p, terms)
    back = conjugated(derivation.derived(p, terms, transformation, r), transformation.inv())
    exactly = len(derivation.constants_and_mean(p, back)[0]) == r
    source = f"the derived scheme of {_SOURCE}, section 4"
    return SmoothingStep(scheme_of(p, back), -1, source, f"dim E_A = {r}", exactly)


def canonical(p: int, terms: Terms) -> tuple[fmpq_mat, int]:
    """A canonical transformation of a mask and the dimension of E_A. Raises NotSmoothedError where there is none."""
    if (transformation := derivation.canonical_transformation(p, terms)) is not None:
        return transformation
    constants, mean = derivation.constants_and_mean(p, terms)
    if not constants:
        raise NotSmoothedError("E_A = 0: no constant vector is reproduced")
    multiplicity, f = 0, mean.charpoly()
    while f(1) == 0:
        f, multiplicity = divmod(f, fmpq_poly([-1, 1]))[0], multiplicity + 1
    raise NotSmoothedError(
        f"the eigenvalue 1 of M_A = (1/{p}) Σ A_i has the multiplicity {multiplicity}, which must be the dimension "
        f"{len(constants)} of E_A"
    )


def integrated(p: int, terms: Terms, r: int) -> dict[int, fmpq_mat]:
    """The mask A with Δ_r S_A = (1/p) S_B Δ_r, Δ_r = diag(Δ I, I) with r differences.

    Hypothesis: B_12(1) = 0, the last columns of the sum of the first r rows. Raises NotSmoothedError without it.
    """
    m = next(iter(terms.values())).nrows()
    zero, low, high = identity(m) * 0, min(terms) - p, max(terms)
    integral: dict[int, fmpq_mat] = {}
    above = [[to_fmpq(0)] * m for _ in range(m)]
    for i in range(high, low - 1, -1):
        here, later = terms.get(i, zero).tolist(), terms.get(i + p, zero).tolist()
        rows = [[later[k][l] - here[k][l] if l < r else here[k][l] for l in range(m)] for k in range(m)]
        above = [[above[k][l] - rows[k][l] if k < r else rows[k][l] for l in range(m)] for k in range(m)]
        integral[i] = fmpq_mat(above) / p
    if any(x for row in above[:r] for x in row):
        raise NotSmoothedError("the matrices do not sum to 0 in the rows of E_B and the columns beside it")
    return nonzero(integral)


def terms_of(scheme: VectorScheme) -> dict[int, fmpq_mat]:
    """The matrices of a scheme by their indices."""
    return dict(enumerate(map(matrix, scheme.coefficients), scheme.start))


def scheme_of(p: int, terms: Terms, kind: str = "vector") -> VectorScheme:
    """The scheme of matrices by their indices, not all zero, of kind vector or one on top of it."""
    zero = identity(next(iter(terms.values())).nrows()) * 0
    matrices = tuple(rows_of(terms.get(i, zero)) for i in range(min(terms), max(terms) + 1))
    return VectorScheme(arity=p, start=min(terms), coefficients=matrices, kind=kind)


def conjugated(terms: Terms, transformation: fmpq_mat) -> dict[int, fmpq_mat]:
    """The mask R^-1 A_i R."""
    inverse = transformation.inv()
    return {i: inverse * a * transformation for i, a in terms.items()}


def nonzero(terms: Terms) -> dict[int, fmpq_mat]:
    """The matrices that are not zero, by rising index."""
    return {i: a for i, a in sorted(terms.items()) if any(a.entries())}
