"""Pictures of masks in several variables for `plot`: φ on a plane, its graph as a net, control nets. No verdicts."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

from subdiv_cli.exact.linalg import matrix, solution
from subdiv_cli.kinds.kind import Analysis, Certify, NotDrawnError, Options
from subdiv_cli.kinds.multivariate.numbers.box_spline import iterated
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.numbers.nets import Vertices, diagonal, refined
from subdiv_cli.kinds.multivariate.numbers.values import NoValuesError, at_fractions, at_integers, support_box
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.model import Effort, Result, Verdict
from subdiv_cli.model.blocks import Drawing, Heights, Net
from subdiv_cli.model.findings import SMOOTHNESS, answering
from subdiv_cli.spaces.lattice import Index, Lattice, multiple_of_identity

MOST_POINTS = 50_000
"""The most points of a surface, about."""
_LEVELS = 3
"""The levels of a net, where none are given."""


def surfaces(scheme: MultivariateScheme, effort: Effort, options: Options, certify: Certify) -> Drawing:
    """The drawing of φ, empty where it is not proved continuous. Raises NotDrawnError."""
    result, analysis = _continuity(effort, certify)
    try:
        return Drawing(() if analysis is None else (heights(analysis.numbers),), result, SMOOTHNESS)
    except NoValuesError as error:
        raise NotDrawnError(str(error)) from None


def nets(scheme: MultivariateScheme, effort: Effort, options: Options, certify: Certify) -> Drawing:
    """The drawing of the control net `points` after `levels` of refinement; without points the graph of φ.

    The net is drawn as far as it is determined. No graph where φ is not proved continuous. Raises NotDrawnError.
    """
    if scheme.dimension > 2:
        raise NotDrawnError("an .obj is the net of a mask in two variables")
    levels = _LEVELS if options.get("levels") is None else options["levels"]
    try:
        if options.get("points") is not None:
            return Drawing((_with_faces(net(scheme, options["points"], levels), levels),))
        result, analysis = _continuity(effort, certify)
        return Drawing(() if analysis is None else (graph(analysis.numbers, levels),), result, SMOOTHNESS)
    except NoValuesError as error:
        raise NotDrawnError(str(error)) from None


def _with_faces(made: Net, levels: int) -> Net:
    if next(made.faces(), None) is None:
        raise NotDrawnError(f"the net is too small: it determines no face of level {levels}")
    return made


def is_continuous(result: Result) -> bool:
    """Whether φ is proved continuous."""
    return result.convergent is Verdict.PROVED or result.refinable.order is not None


def _continuity(effort: Effort, certify: Certify) -> tuple[Result, Analysis | None]:
    """A result, and the analysis where it proves φ continuous.

    That takes less than the best exponent: a hundredth and a tenth of the effort are tried first.
    """
    for work in sorted({max(effort.work // share, 1) for share in (100, 10, 1)}):
        analysis, result = certify(Effort(work))
        if is_continuous(result):
            return result, analysis
        decided = answering(result.findings, SMOOTHNESS)
        if decided is not None and decided.verdict is Verdict.REFUTED:
            break
    return result, None


def heights(numbers: MultivariateNumbers, points: int = MOST_POINTS) -> Heights:
    """The values of φ, at most about so many; in more than two variables on a plane near its centre of mass.

    A plane of the grid. Needs φ continuous. Raises NoValuesError.
    """
    scheme = _by_multiples(numbers)
    lattice, sides = Lattice(scheme.dilation), support_box(scheme, Lattice(scheme.dilation))[:2]
    integers = at_integers(numbers.scheme, numbers.lattice)
    if numbers.dimension > 2 and lattice.scalar_power != (1, lattice.dilation[0][0]):
        raise NoValuesError("a slice is drawn only where a power of the dilation is a multiple of the identity")
    finer = lattice.index if numbers.dimension == 2 else lattice.dilation[0][0] ** 2
    area, level = (sides[0][1] - sides[0][0]) * (sides[1][1] - sides[1][0]), 0
    while area * finer ** (level + 1) <= points:
        level += 1
    while True:
        unit = lattice.inverse_power(level)
        tail = tuple(round(x / unit[2][2]) for x in centre(numbers)[2:])
        try:
            values = at_fractions(scheme, lattice, integers, level, tail or None)
        except NoValuesError:
            if not level:
                raise
            level -= 1
            continue
        plane = tuple(x * unit[2][2] for x in tail)
        return Heights(tuple(row[:2] for row in unit[:2]), {alpha[:2]: x for alpha, x in values.items()}, plane)


def _by_multiples(numbers: MultivariateNumbers) -> MultivariateScheme:
    """The scheme S^r with a dilation c I, whose points are a rectangular grid; S itself where no such r is small."""
    if numbers.lattice.scalar_power is None:
        return numbers.scheme
    power, c = numbers.lattice.scalar_power
    terms = iterated(numbers.scheme, numbers.lattice, power)
    if terms is None:
        return numbers.scheme
    return MultivariateScheme(dilation=multiple_of_identity(c, numbers.dimension), terms=terms)


def centre(numbers: MultivariateNumbers) -> tuple[Fraction, ...]:
    """The centre of mass ∫ x φ(x) dx = (M - I)^-1 Σ_γ γ a_γ / m.

    It is the centre of the support of a mask that is symmetric about a point.
    """
    scheme, m = numbers.scheme, numbers.lattice.index
    mean = [sum((gamma[i] * a for gamma, a in scheme.terms.items()), Fraction(0)) / m for i in range(numbers.dimension)]
    rows = [[x - (i == j) for j, x in enumerate(row)] for i, row in enumerate(scheme.dilation)]
    point = solution(matrix(rows), mean)
    assert point is not None, "M is expanding"
    return point


def graph(numbers: MultivariateNumbers, levels: int) -> Net:
    """The points (x, y, φ(x, y)), (x, y) ∈ M^-levels Z^2, of the support and around it. Needs φ continuous.

    Raises NoValuesError.
    """
    integers = at_integers(numbers.scheme, numbers.lattice)
    values = at_fractions(numbers.scheme, numbers.lattice, integers, levels)
    unit = numbers.lattice.inverse_power(levels)
    vertices: dict[Index, tuple[Fraction, ...]] = {}
    for i, j in values:
        for alpha in product((i - 1, i, i + 1), (j - 1, j, j + 1)):
            place = tuple(sum((x * k for x, k in zip(row, alpha, strict=True)), Fraction(0)) for row in unit)
            vertices[alpha] = (*place, values.get(alpha, Fraction(0)))
    return _net(numbers.scheme, vertices, levels, "the graph of φ")


def net(scheme: MultivariateScheme, vertices: Vertices, levels: int) -> Net:
    """The net S^levels of a net on Z^2, as far as it is determined. Raises NoValuesError."""
    return _net(scheme, refined(scheme, Lattice(scheme.dilation), vertices, levels), levels, "a control net")


def _net(scheme: MultivariateScheme, vertices: Vertices, levels: int, what: str) -> Net:
    lattice = Lattice(scheme.dilation)
    turned = lattice.determinant < 0 and levels % 2 == 1
    return Net(vertices, diagonal(scheme, lattice), turned, f"{what} at level {levels}")
