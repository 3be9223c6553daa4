"""Blocks: exact data that kinds hand to readers, which formats and pictures set as they can; standard library only.

A portrait and the section of a report are headed blocks; a drawing is blocks without words around them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Literal, NamedTuple

from subdiv_cli.model.formulas import derivative

if TYPE_CHECKING:
    from subdiv_cli.model import Result
    from subdiv_cli.model.findings import Data, Finding, Question

Place = tuple[int, ...]
"""An index of Z^2."""


class Text(NamedTuple):
    """A text: a sentence, or less."""

    text: str
    role: str = "text"
    """The role: `quiet` for what is of less weight; formats have further ones, for verdicts."""


class Words(NamedTuple):
    """The words of the result itself: on its facts, or on its exponents."""

    about: Literal["facts", "exponents"]


class Statements(NamedTuple):
    """A list of findings: a sentence each, or `full`, where there is room, with their reasons and sources."""

    findings: tuple[Finding, ...]
    full: bool = False


class Formula(NamedTuple):
    """An equation: left = right."""

    left: str
    right: str


class Matrix(NamedTuple):
    """A matrix with its name."""

    name: str
    rows: tuple[tuple[str, ...], ...]


class Grid(NamedTuple):
    """A grid of rows of numbers on the same nodes: a stencil, a mask, values at the integers."""

    corner: str
    nodes: tuple[str, ...]
    rows: tuple[tuple[str, tuple[str, ...]], ...]
    """The rows: a name and a number for each node; an empty text where the row has none."""


class Plane(NamedTuple):
    """A plane of numbers at some places of Z^2: the first coordinate goes to the right, the second upwards."""

    title: str
    cells: Mapping[Place, str]


class Planes(NamedTuple):
    """A group of planes that stand beside each other where there is room."""

    planes: tuple[Plane, ...]


class Curve(NamedTuple):
    """A function by exact values at (start + i) / arity^level; zero elsewhere on that grid, and outside the support."""

    arity: int
    level: int
    start: int
    values: tuple[Fraction, ...]
    support: tuple[Fraction, Fraction]
    order: int = 0
    """The order of the derivative whose values these are."""
    name: str = "φ"
    """The name of the function."""
    label: str = ""
    """What tells it from others of that name, its data or its own name; nothing where it is the only one."""

    @property
    def title(self) -> str:
        """The name of this curve alone: `φ''`, the component `ψ_1`, `f' for the data e_1`."""
        if self.label.startswith(f"{self.name}_"):
            return self.label
        name = derivative(self.name, self.order)
        return f"{name} for the data {self.label}" if self.label else name


class Polygon(NamedTuple):
    """A polygon in the plane: control points joined, or a curve that is sampled finely."""

    x: tuple[Fraction, ...]
    y: tuple[Fraction, ...]
    closed: bool = False
    control: str | None = None
    """The name of a control polygon; None for a curve."""


class Heights(NamedTuple):
    """A function on a plane of R^s by exact values at the points U α, α ∈ Z^2; zero where there is none."""

    unit: tuple[tuple[Fraction, ...], ...]
    """The rows of U, the first two coordinates."""
    values: Mapping[Place, Fraction]
    at: tuple[Fraction, ...] = ()
    """The other coordinates, those of the plane."""


class Net(NamedTuple):
    """A net of points in space, one for each of some α ∈ Z^2; their neighbours are α ± e_1, α ± e_2."""

    vertices: Mapping[Place, tuple[Fraction, ...]]
    diagonal: tuple[int, int] | None = None
    """The third direction, (1, 1) or (1, -1), of neighbours, so that faces are triangles; None for quadrilaterals."""
    turned: bool = False
    """Whether the refinement has turned Z^2 over."""
    title: str = ""

    def faces(self) -> Iterator[tuple[Place, ...]]:
        """The faces with all their vertices in the net, counterclockwise in Z^2."""
        for i, j in sorted(self.vertices):
            a, b, c, d = (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)
            halves = {None: ((a, b, c, d),), (1, 1): ((a, b, c), (a, c, d)), (1, -1): ((a, b, d), (b, c, d))}
            yield from (face for face in halves[self.diagonal] if all(place in self.vertices for place in face))


Picture = Curve | Polygon | Heights | Net
Block = Text | Words | Statements | Formula | Matrix | Grid | Planes | Picture


class Section(NamedTuple):
    """A section: blocks under a heading; an empty title is none."""

    title: str
    blocks: tuple[Block, ...]


class Portrait(NamedTuple):
    """A mask taken apart, for `show`."""

    sections: tuple[Section, ...]
    data: Mapping[str, Data]
    """The same as exact data, for JSON."""


class Drawing(NamedTuple):
    """The blocks that `plot` draws of a mask."""

    blocks: tuple[Picture, ...]
    result: Result | None = None
    """The result of the mask; None where that did not matter."""
    question: Question | None = None
    """The question that would have to be proved, where there are no blocks."""


def sections(parts: Mapping[str, Iterable[Block]]) -> tuple[Section, ...]:
    """The sections of those headed parts that have blocks."""
    made = ((title, tuple(blocks)) for title, blocks in parts.items())
    return tuple(Section(title, blocks) for title, blocks in made if blocks)
