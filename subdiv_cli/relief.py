"""What `plot` and `show` want of a scheme in several variables: φ where it is proved continuous, nets, its parts.

A module of its own, so that `check` does not load what it does not need.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from fractions import Fraction

from subdiv_cli.model import Effort, Result, Verdict
from subdiv_cli.model.anatomy import Net, Surface, SurfaceAnatomy
from subdiv_cli.pipeline import Checked
from subdiv_cli.quantities.directional import factored
from subdiv_cli.quantities.lattice_values import NoValuesError, at_integers
from subdiv_cli.quantities.multivariate import MultivariateNumbers
from subdiv_cli.schemes.multivariate import MultivariateScheme
from subdiv_cli.stages import surfaces
from subdiv_cli.stages.multivariate.analysis import analyse
from subdiv_cli.stages.surfaces import net
from subdiv_cli.surfaces import certified_surface

__all__ = ["NoValuesError", "drawn_surface", "graph_net", "net", "surface_portrait"]

_POINTS = 5_000
"""Of a picture in letters."""


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


def surface_portrait(scheme: MultivariateScheme, effort: Effort) -> tuple[Checked, SurfaceAnatomy]:
    """What `check` finds, and the mask taken apart; no values of a φ that has too many. Raises DisagreementError."""
    analysis = analyse(scheme, effort)
    numbers = analysis.numbers
    checked = certified_surface(scheme, analysis, (), effort)
    values: Mapping[tuple[int, ...], Fraction] = {}
    surface = None
    if _is_continuous(checked.result):
        with suppress(NoValuesError):
            values = at_integers(scheme, numbers.lattice)
            surface = surfaces.surface(numbers, _POINTS)
    factors, quotient = factored(scheme, numbers.lattice)
    return checked, SurfaceAnatomy(
        dilation=scheme.dilation,
        terms=scheme.terms,
        factors=factors,
        quotient=quotient,
        differences=None if numbers.space is None else len(numbers.space.matrices[0].table()),
        centre=surfaces.centre(numbers) if numbers.is_normalised else None,
        values=values,
        surface=surface,
    )


def _is_continuous(result: Result) -> bool:
    return result.convergent is Verdict.PROVED or result.refinable.order is not None


def _continuity(scheme: MultivariateScheme, effort: Effort) -> tuple[Result, MultivariateNumbers | None]:
    """A check, certified, and the numbers of a φ that it proves continuous.

    That takes less than the best exponent: a hundredth and a tenth of the effort are tried first.
    """
    for work in sorted({max(effort.work // share, 1) for share in (100, 10, 1)}):
        part = Effort(work)
        analysis = analyse(scheme, part)
        result = certified_surface(scheme, analysis, (), part).result
        if _is_continuous(result):
            return result, analysis.numbers
        if any(found.code == "SD612" and found.verdict is Verdict.REFUTED for found in result.findings):
            break
    return result, None
