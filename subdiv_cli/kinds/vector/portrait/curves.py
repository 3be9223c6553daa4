"""The limits of a mask of matrices for the unit data e_l δ, and their derivatives, for `plot`."""

from __future__ import annotations

from subdiv_cli.kinds.kind import Certify, NotDrawnError, Options
from subdiv_cli.kinds.vector.numbers.values import limit_curves
from subdiv_cli.kinds.vector.scheme import VectorScheme
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.model.blocks import Drawing
from subdiv_cli.model.findings import CONVERGENCE

_DERIVATIVES = 4
"""The number of derivatives drawn unless more are wanted."""


def functions(scheme: VectorScheme, effort: Effort, options: Options, certify: Certify) -> Drawing:
    """The drawing of the limits up to the proved order of smoothness, or `derivatives`; empty without convergence.

    A limit is F = Σ f_i u_i in the basis u of E_A: the f_i are drawn, a line for each of the data e_l δ. Raises
    NotDrawnError where the mask is too long.
    """
    analysis, result = certify(effort)
    if result.convergent is not Verdict.PROVED or result.smoothness.order is None:
        return Drawing((), result, CONVERGENCE)
    wanted = options.get("derivatives")
    last = int(min(result.smoothness.order, _DERIVATIVES if wanted is None else wanted))
    curves = limit_curves(analysis.numbers, last, options["samples"])
    if not curves:
        raise NotDrawnError("the mask is too long")
    return Drawing(curves, result)
