"""What `plot` and `show` want of a scheme in several variables: φ where it is proved continuous, nets, its parts.

A module of its own, so that `check` does not load what it does not need.
"""

from __future__ import annotations

from subdiv_cli.kinds.kind import Analysis
from subdiv_cli.kinds.multivariate import KIND, rules
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.multivariate.stages import analyse, surfaces
from subdiv_cli.kinds.multivariate.stages.surfaces import NoValuesError, net
from subdiv_cli.model import Effort, Result, Verdict
from subdiv_cli.model.blocks import Net, Surface, SurfaceAnatomy
from subdiv_cli.pipeline import Checked, certified

__all__ = ["NoValuesError", "drawn_surface", "graph_net", "net", "surface_portrait"]


def drawn_surface(scheme: MultivariateScheme, effort: Effort) -> tuple[Result, Surface | None]:
    """The result of a check, and φ; None where it is not proved continuous. Raises NoValuesError."""
    result, analysis = _continuity(scheme, effort)
    return result, None if analysis is None else surfaces.surface(analysis.numbers)


def graph_net(scheme: MultivariateScheme, effort: Effort, levels: int) -> tuple[Result, Net | None]:
    """The result of a check, and the net of the graph of φ at M^-levels Z^2; None where it is not proved continuous.

    Raises NoValuesError.
    """
    result, analysis = _continuity(scheme, effort)
    return result, None if analysis is None else surfaces.graph(analysis.numbers, levels)


def surface_portrait(scheme: MultivariateScheme, effort: Effort) -> tuple[Checked, SurfaceAnatomy]:
    """What `check` finds, and the mask taken apart. Raises DisagreementError."""
    analysis = analyse(scheme, effort)
    checked = certified(KIND, analysis, (), effort)
    inverted = any(
        found.code == rules.QUASI_INTERPOLATION.code and found.verdict is Verdict.PROVED
        for found in checked.result.findings
    )
    continuous = _is_continuous(checked.result)
    return checked, surfaces.anatomy(analysis.numbers, continuous=continuous, inverted=inverted)


def _is_continuous(result: Result) -> bool:
    return result.convergent is Verdict.PROVED or result.refinable.order is not None


def _continuity(scheme: MultivariateScheme, effort: Effort) -> tuple[Result, Analysis | None]:
    """A check, certified, and the analysis where it proves φ continuous.

    That takes less than the best exponent: a hundredth and a tenth of the effort are tried first.
    """
    for work in sorted({max(effort.work // share, 1) for share in (100, 10, 1)}):
        part = Effort(work)
        analysis = analyse(scheme, part)
        result = certified(KIND, analysis, (), part).result
        if _is_continuous(result):
            return result, analysis
        if any(found.code == rules.SMOOTHNESS.code and found.verdict is Verdict.REFUTED for found in result.findings):
            break
    return result, None
