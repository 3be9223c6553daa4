"""Proofs of joint spectral radii as plain data, as they go from who finds them to certificates (RADIUS.md)."""

# No `from __future__ import annotations` here: it would hide from a TypedDict which of its keys are required.

from fractions import Fraction
from typing import NotRequired, TypedDict

from subdiv_cli.model.closed import Root

Numbers = tuple[Fraction, ...]
Integers = tuple[int, ...]
"""Several integers: a word, or the first indices of several sequences."""


class RootData(TypedDict):
    """A real algebraic number, the only root of a polynomial, the lowest power first, in [low, high]."""

    polynomial: tuple[int, ...]
    low: Fraction
    high: Fraction


def root_data(root: Root) -> RootData:
    """A root as it stands in witnesses and proofs."""
    return {"polynomial": root.coefficients, "low": root.low, "high": root.high}


class PowerData(TypedDict, total=False):
    """What is known of a radius ρ: ρ^length is the root, or at most the bound; a norm that ρ^length attains is both."""

    length: int
    root: RootData
    bound: Fraction


class RadiusWitness(PowerData, total=False):
    """What is known of a joint spectral radius, and a product that attains its lower bound where one is known."""

    word: Integers


def upper_bound(power: PowerData) -> Fraction:
    """The number x with ρ^length <= x: the root from above where it is known, else the bound."""
    return power["root"]["high"] if "root" in power else power["bound"]


class DiscData(TypedDict):
    """A disc that isolates a complex eigenvalue, the zero of an irreducible polynomial."""

    factor: tuple[int, ...]
    center: tuple[Fraction, Fraction]
    distance: Fraction


class LeaderData(TypedDict):
    """A leading product with its eigenvector: `sign` where the eigenvalue is real, a disc around it where it is not."""

    word: tuple[int, ...]
    reflected: bool
    column: int | tuple[int, ...]
    scale: Fraction
    annihilator: tuple[Fraction, ...]
    sign: NotRequired[int]
    factor: NotRequired[tuple[int, ...]]
    center: NotRequired[tuple[Fraction, Fraction]]
    distance: NotRequired[Fraction]


class ShareData(TypedDict):
    """A vertex of a tie with its weight, a number or the coefficients of a polynomial."""

    vertex: int
    weight: Fraction | tuple[Fraction, ...]


class TieData(TypedDict):
    """A tie: the image of a vertex by a letter, as a combination of vertices."""

    vertex: int
    letter: int
    weights: tuple[ShareData, ...]


class RadiusProof(PowerData, total=False):
    """A proof of a radius: a rule of RADIUS.md (or `norm`, of FORMAT.md), what it proves, and the witness of that rule.

    `blocks` has a proof for each of its `parts`, `distinct`, `transposed` and `meeting-bounds` one for their `part`.
    """

    rule: str
    # blocks
    sizes: tuple[int, ...]
    parts: "tuple[RadiusProof, ...]"
    # distinct
    letters: tuple[int, ...]
    part: "RadiusProof"
    # meeting-bounds
    below: "LowerBound"
    # common-vector, ellipsoid
    left: bool
    vector: Numbers
    form: tuple[int, ...]
    words: tuple[tuple[int, ...], ...]
    # positive-symbol
    power: int
    squares: tuple[Fraction, ...]
    rest: tuple[Fraction, ...]
    bounded: bool
    # polytopes; the basis of blocks has the rows of a matrix, that of a polytope the numbers of vertices
    symmetry: int
    bits: int
    vertices: tuple[tuple[int, ...], ...]
    basis: tuple[int, ...] | tuple[tuple[Fraction, ...], ...]
    weight_bits: int
    images: tuple[tuple[int, ...], ...]
    leaders: tuple[LeaderData, ...]
    extras: tuple[tuple[int, ...], ...]
    tree: tuple[int, ...]
    ties: tuple[TieData, ...]
    sigma: tuple[Fraction, ...]


class LowerBound(TypedDict):
    """A product of a family and a number that its spectral radius is at least.

    Where there is a vector, it is what the product, or its transpose (`left`), makes at least so many times as large.
    """

    word: tuple[int, ...]
    bound: Fraction
    sign: NotRequired[int]
    left: NotRequired[bool]
    vector: NotRequired[Numbers]
