"""What `plot` wants of a scheme in several variables: φ where it is proved continuous, and nets.

A module of its own, so that `check` does not load what it does not need.
"""

from __future__ import annotations

from subdiv_cli.model import Effort, Result, Verdict
from subdiv_cli.model.anatomy import Net, Surface
from subdiv_cli.quantities.lattice_values import NoValuesError
from subdiv_cli.quantities.multivariate import MultivariateNumbers
from subdiv_cli.schemes.multivariate import MultivariateScheme
from subdiv_cli.stages import surfaces
from subdiv_cli.stages.multivariate.analysis import analyse
from subdiv_cli.stages.surfaces import net
from subdiv_cli.surfaces import certified_surface

__all__ = ["NoValuesError", "drawn_surface", "graph_net", "net"]


def drawn_surface(scheme: MultivariateScheme, effort: Effort) -> tuple[Result, Surface | None]:
    """The result of a check, and φ; None where it is not proved continuous. Raises NoValuesError."""
    result, numbers = _continuity(scheme, effort)
    return result, None if numbers is None else surfaces.surface(numbers)


def graph_net(scheme: MultivariateScheme, effort: Effort, levels: int) -> tuple[Result, Net | None]:
    """The result of a check, and the net of the graph of φ at M^-levels Z^2; None where it is not proved continuous.

    Raises NoValuesError.
    """
    result, numbers = _continuity(scheme, effort)
    return result, None if numbers is None else surfaces.graph(numbers, levels)


def _continuity(scheme: MultivariateScheme, effort: Effort) -> tuple[Result, MultivariateNumbers | None]:
    """A check, certified, and the numbers of a φ that it proves continuous.

    That takes less than the best exponent: a hundredth and a tenth of the effort are tried first.
    """
    for work in sorted({max(effort.work // share, 1) for share in (100, 10, 1)}):
        part = Effort(work)
        analysis = analyse(scheme, part)
        result = certified_surface(scheme, analysis, (), part).result
        if result.convergent is Verdict.PROVED or result.refinable.order is not None:
            return result, analysis.numbers
        if any(found.code == "SD612" and found.verdict is Verdict.REFUTED for found in result.findings):
            break
    return result, None
