"""Surfaces, nets and masks taken apart, for pictures and pages: φ on a plane, its graph, control nets. No verdicts."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from fractions import Fraction
from itertools import product

from subdiv_cli.exact.linalg import matrix, solution
from subdiv_cli.kinds.multivariate.lattice import Lattice
from subdiv_cli.kinds.multivariate.numbers.box_spline import iterated
from subdiv_cli.kinds.multivariate.numbers.directional import factored
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.numbers.nets import Vertices, diagonal, refined
from subdiv_cli.kinds.multivariate.numbers.values import NoValuesError as NoValuesError
from subdiv_cli.kinds.multivariate.numbers.values import at_fractions, at_integers, support_box
from subdiv_cli.kinds.multivariate.scheme import Index, MultivariateScheme, multiple_of_identity
from subdiv_cli.model.blocks import Net, Surface, SurfaceAnatomy

MOST_POINTS = 50_000
"""Of a surface, about."""
_FEWER = 5_000
"""Of one in letters."""


def surface(numbers: MultivariateNumbers, points: int = MOST_POINTS) -> Surface:
    """φ with at most about so many values; in three and more variables on the plane through its centre of mass, or a

    plane of the grid near it. Needs φ continuous. Raises NoValuesError.
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
        return Surface(tuple(row[:2] for row in unit[:2]), {alpha[:2]: x for alpha, x in values.items()}, plane)


def _by_multiples(numbers: MultivariateNumbers) -> MultivariateScheme:
    """S^r with a dilation c I, whose points are a rectangular grid; S itself where it has none that is short."""
    if numbers.lattice.scalar_power is None:
        return numbers.scheme
    power, c = numbers.lattice.scalar_power
    terms = iterated(numbers.scheme, numbers.lattice, power)
    if terms is None:
        return numbers.scheme
    return MultivariateScheme(dilation=multiple_of_identity(c, numbers.dimension), terms=terms)


def centre(numbers: MultivariateNumbers) -> tuple[Fraction, ...]:
    """∫ x φ(x) dx = (M - I)^-1 Σ_γ γ a_γ / m, the centre of the support of a mask that is symmetric about a point."""
    scheme, m = numbers.scheme, numbers.lattice.index
    mean = [sum((gamma[i] * a for gamma, a in scheme.terms.items()), Fraction(0)) / m for i in range(numbers.dimension)]
    rows = [[x - (i == j) for j, x in enumerate(row)] for i, row in enumerate(scheme.dilation)]
    found = solution(matrix(rows), mean)
    assert found is not None, "M is expanding"
    return found


def anatomy(numbers: MultivariateNumbers, *, continuous: bool, inverted: bool) -> SurfaceAnatomy:
    """The mask taken apart, with φ where it is proved continuous and has not too many values, and Q where S^∞ is

    proved to be inverted by it.
    """
    scheme = numbers.scheme
    values: Mapping[Index, Fraction] = {}
    picture = None
    if continuous:
        with suppress(NoValuesError):
            values = at_integers(scheme, numbers.lattice)
            picture = surface(numbers, _FEWER)
    quasi = numbers.quasi_interpolation if inverted else None
    factors, quotient = factored(scheme, numbers.lattice)
    return SurfaceAnatomy(
        dilation=scheme.dilation,
        terms=scheme.terms,
        factors=factors,
        quotient=quotient,
        differences=None if numbers.space is None else numbers.space.basis.nrows(),
        centre=centre(numbers) if numbers.is_normalised else None,
        values=values,
        moments={} if quasi is None else quasi.moments,
        operator={} if quasi is None else quasi.operator,
        centred={} if quasi is None else quasi.centred,
        quasi_stencil={} if quasi is None else quasi.stencil,
        surface=picture,
    )


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
    return _net(numbers.scheme, vertices, levels)


def net(scheme: MultivariateScheme, vertices: Vertices, levels: int) -> Net:
    """S^levels of a net on Z^2, as far as it is determined. Raises NoValuesError."""
    return _net(scheme, refined(scheme, Lattice(scheme.dilation), vertices, levels), levels)


def _net(scheme: MultivariateScheme, vertices: Vertices, levels: int) -> Net:
    lattice = Lattice(scheme.dilation)
    return Net(vertices, diagonal(scheme, lattice), turned=lattice.determinant < 0 and levels % 2 == 1)
