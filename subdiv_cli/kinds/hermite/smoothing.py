"""Smoother Hermite schemes, and Taylor schemes, of any arity p.

The source is section 5 of Moosmüller & Dyn 2018, for Taylor schemes of any d Merrien & Sauer 2012. With the operator T
of `taylor.py` the Taylor scheme B = ∂_t A solves T S_A = p^(1-d) S_B T. Where S_A is HC^(d-1), all components of T c
but the last one are o(h^(d-1)): limits of S_B are (0, …, 0, f^(d-1)), and each of these occurs, as T is onto. So the
exponent of S_B is α - (d-1).

Procedure 40 is for d = 2. There T = U Δ_1 with U = ((1, -1), (0, 1)) and Δ_1 = diag(Δ, 1), so that Lemma 33 is a step
of kind vector with one difference: I_t B is the mask A with Δ_1 S_A = (1/p) S_(U^-1 B U) Δ_1. From A the procedure goes
to ∂_t A; by procedure 23 to B, for which E_B is still spanned by (0, 1); by R = ((1, 0), (η, 1)) to R^-1 B R, with η
such that the first column of its value at 1 sums to p (Lemma 38); and by I_t to C. Second components of limits of ∂_t C
are integrals of those of ∂_t A: f' of S_C is the integral of an f' of S_A, and each occurs. So α grows by exactly 1.
"""

from __future__ import annotations

from fractions import Fraction

from flint import fmpq_mat

from subdiv_cli.exact.rationals import to_fraction
from subdiv_cli.exact.text import number
from subdiv_cli.kinds.hermite.numbers import HermiteNumbers
from subdiv_cli.kinds.kind import NotSmoothedError, SmoothingStep
from subdiv_cli.kinds.vector.numbers.derived import Terms
from subdiv_cli.kinds.vector.scheme import VectorScheme
from subdiv_cli.kinds.vector.smoothing import canonical, conjugated, integrated, scheme_of
from subdiv_cli.model import Effort

_SOURCE = "Moosmüller, Dyn 2018"
_U = fmpq_mat([[1, -1], [0, 1]])


def smoother(scheme: VectorScheme) -> SmoothingStep:
    """The scheme of Procedure 40; its support begins at most 2p + 1 lower (Corollary 42).

    Hypotheses: d = 2; the spectral condition of order 2, with any φ; E_B of ∂_t A is spanned by (0, 1), and 1 is a
    simple eigenvalue of its mean, as where limits of ∂_t A have a vanishing first component (Lemma 35); and p is a
    simple eigenvalue of B(1) after procedure 23, for η. Raises NotSmoothedError without.
    """
    p, d = scheme.arity, scheme.size
    if d != 2:
        raise NotSmoothedError(
            f"procedure 40 is for a function with its first derivative, and these jets have {d} components"
        )
    _, taylor = _jets(scheme)
    try:
        transformation, r = canonical(p, taylor)
    except NotSmoothedError as error:
        raise NotSmoothedError(f"of the Taylor scheme {error}") from None
    if r != 1 or transformation[0, 0] != 0:
        raise NotSmoothedError(
            "limits of the Taylor scheme do not have a vanishing first component: E_B is not spanned by (0, 1)"
        )
    smooth = conjugated(integrated(p, conjugated(taylor, transformation), 1), transformation.inv())
    total = sum(smooth.values(), fmpq_mat(2, 2))
    if total[0, 0] == p:
        raise NotSmoothedError(f"after procedure 23 the eigenvalue {p} of B(1) is not simple")
    eta = 1 + total[1, 0] / (total[0, 0] - p)
    imposed = conjugated(smooth, fmpq_mat([[1, 0], [eta, 1]]))
    made = scheme_of(p, integrated(p, conjugated(imposed, _U), 1), "hermite")
    details = f"ζ = {number(to_fraction(eta + 1))}, φ = {number(_jets(made)[0])}"
    return SmoothingStep(made, 1, f"procedure 40 of {_SOURCE}", details)


def derived(scheme: VectorScheme) -> SmoothingStep:
    """The Taylor scheme, of kind vector; of a function alone its limits are derivatives of order d - 1.

    Hypothesis: the spectral condition of order d, with any φ. Raises NotSmoothedError without it.
    """
    phi, taylor = _jets(scheme)
    source = f"the Taylor scheme of {_SOURCE}, section 5"
    return SmoothingStep(scheme_of(scheme.arity, taylor), 1 - scheme.size, source, f"φ = {number(phi)}")


def _jets(scheme: VectorScheme) -> tuple[Fraction, Terms]:
    """The number φ of the spectral condition, and the mask ∂_t A. Raises NotSmoothedError where there are none."""
    numbers = HermiteNumbers(scheme, Effort())
    k, shifts = numbers.jets
    if k < scheme.size:
        eigen = f"S y_{k} = {scheme.arity}^-{k} y_{k}" if k else "S y_0 = y_0"
        raise NotSmoothedError(f"the spectral condition fails: there is no jet y_{k} with {eigen}")
    if numbers.taylor is None:
        raise NotSmoothedError("there is no Taylor scheme")
    return shifts[1], numbers.taylor
