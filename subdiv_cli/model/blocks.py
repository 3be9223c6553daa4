"""A mask taken apart, and curves: what `show` and `plot` are told, exact plain data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple


class Signal(NamedTuple):
    """A finitely supported sequence: a mask, a stencil, values at the integers."""

    start: int
    values: tuple[Fraction, ...]


class Factor(NamedTuple):
    """An irreducible factor of a symbol over Q, or 1 + z + … + z^(p-1)."""

    coefficients: tuple[int, ...]
    """Lowest power first."""
    multiplicity: int
    smoothing: bool = False
    zeros: tuple[str, ...] = ()
    """As text, digits that are certain; none for a smoothing factor."""


class Curve(NamedTuple):
    """Exact values of a function at (start + i) / arity^level, zero elsewhere on that grid."""

    arity: int
    level: int
    start: int
    values: tuple[Fraction, ...]
    order: int = 0
    """Of the derivative whose values these are."""


class Surface(NamedTuple):
    """Exact values of a function on a plane of R^s at the points U α, α ∈ Z^2; zero where there is none."""

    unit: tuple[tuple[Fraction, ...], ...]
    """The rows of U, the first two coordinates."""
    values: Mapping[tuple[int, ...], Fraction]
    at: tuple[Fraction, ...] = ()
    """The other coordinates, those of the plane."""


class Net(NamedTuple):
    """Control points in space, one for each of some α ∈ Z^2; their neighbours are α ± e_1, α ± e_2."""

    vertices: Mapping[tuple[int, ...], tuple[Fraction, ...]]
    diagonal: tuple[int, int] | None = None
    """(1, 1) or (1, -1): a neighbour as well, so the faces are triangles; None for quadrilaterals."""
    turned: bool = False
    """The refinement has turned Z^2 over."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Anatomy:
    """A scalar mask taken apart; empty tuples and None where the scheme does not have the part."""

    mask: Signal
    constant: Fraction
    """The symbol is constant · z^power · the product of the factors."""
    power: int
    factors: tuple[Factor, ...]
    components: tuple[Signal, ...]
    """Polyphase components."""
    derived: tuple[Signal, ...]
    """The masks of S_1, …, S_k."""
    window: int
    """The first index of the refinement matrices."""
    matrices: tuple[tuple[tuple[Fraction, ...], ...], ...]
    """A_0, …, A_(p-1), by rows."""
    eigenvalues: tuple[tuple[str, ...], ...]
    support: tuple[Fraction, Fraction]
    values: tuple[Signal, ...]
    """φ, φ', … at the integers."""
    stencils: tuple[Signal, ...]
    """The limit and its derivatives from the data of a level."""
    moments: tuple[Fraction, ...]
    operator: tuple[Fraction, ...]
    """q_i of Q = Σ q_i D^i."""
    quasi_stencil: Signal | None
    eigen_sequences: tuple[tuple[Fraction, ...], ...]
    """The coefficients of Q x^i, lowest power first."""
    orders: tuple[int, int] | None
    """Of approximation, with Q and without."""
    curve: Curve | None
    """φ, finely enough for a picture."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SurfaceAnatomy:
    """A mask in several variables taken apart; None and empty where the scheme does not have the part."""

    dilation: tuple[tuple[int, ...], ...]
    terms: Mapping[tuple[int, ...], Fraction]
    factors: Mapping[tuple[int, ...], int]
    """θ -> how often 1 + z^θ + … + z^((c-1)θ) divides the symbol, the dilation being c I."""
    quotient: Mapping[tuple[int, ...], Fraction]
    """What is left of the symbol."""
    differences: int | None
    """The dimension of V_k, k the order of the sum rules."""
    centre: tuple[Fraction, ...] | None
    """∫ x φ(x) dx."""
    values: Mapping[tuple[int, ...], Fraction]
    """φ at the integers."""
    moments: Mapping[tuple[int, ...], Fraction]
    """m_μ = Σ φ(-β) β^μ."""
    operator: Mapping[tuple[int, ...], Fraction]
    """q_μ of Q = Σ q_μ D^μ."""
    centred: Mapping[tuple[int, ...], Fraction]
    """The same of f -> Q f(· - centre)."""
    quasi_stencil: Mapping[tuple[int, ...], Fraction]
    """t with Q f(α) = Σ t_j f(α + j) on polynomials."""
    surface: Surface | None
    """φ, for a picture."""


class Section(NamedTuple):
    """A headed part of a page."""

    title: str
    blocks: tuple[object, ...]


class Portrait(NamedTuple):
    """A mask taken apart."""

    sections: tuple[Section, ...]


class Drawing(NamedTuple):
    """To come."""
