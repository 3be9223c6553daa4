"""A sweep: the answers on one mask at many values of a parameter, and what changes along them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from math import inf
from typing import NamedTuple

from subdiv_cli.model import Exponent, Interval, Result, Verdict
from subdiv_cli.model.closed import rational
from subdiv_cli.model.findings import HOLDER_UPPER, answering, outward
from subdiv_cli.model.properties import Property

WIDE = Fraction(1, 10)
"""The width of an enclosure beyond which an exponent is not decided."""


class Column(NamedTuple):
    """A column of a sweep: a property, or else a norm ‖((1/p) S_ν)^L‖∞ of a scalar mask of arity p."""

    name: str
    """The name on the command line: `holder`, `norm:1:2`."""
    about: Property | None = None
    nu: int = 0
    level: int = 0

    @property
    def title(self) -> str:
        """The name in tables: `Hölder exponent`, `‖(S_1/p)^2‖∞`."""
        if self.about is not None:
            return self.about.title
        quotient = f"S_{self.nu}/p"
        return f"‖{quotient}‖∞" if self.level == 1 else f"‖({quotient})^{self.level}‖∞"


class Row(NamedTuple):
    """The answers at one value of the parameter, without the findings they rest on."""

    value: Fraction
    result: Result
    """The result; where there is no mask at this value it is invalid, and has the problems."""
    norms: Mapping[str, Fraction] = {}
    """The norms by the names of their columns, those that exist and the effort reaches."""
    undecided: tuple[str, ...] = ()
    """The names of the columns that the effort does not decide."""
    product: tuple[int, ...] | None = None
    """The word of a spectrum-maximizing product, where the Hölder exponent is exact and a finding names one."""


class Sweep(NamedTuple):
    """The rows of one mask, in the order in which the values are given."""

    file: str
    name: str | None
    kind: str
    parameter: str
    fixed: Mapping[str, Fraction]
    """The other parameters that are set."""
    columns: tuple[Column, ...]
    rows: tuple[Row, ...]

    @property
    def title(self) -> str:
        """The name of the mask, with the parameters that are set."""
        given = "".join(f", {name} = {rational(value)}" for name, value in self.fixed.items())
        return f"{self.name or self.file}{given}"


def is_undecided(result: Result, row: Property) -> bool:
    """Whether the findings leave a property undecided: a verdict, or an exponent that is hardly enclosed."""
    known = (answering(result.findings, question) for question in (row.question, *row.more))
    if any(finding is not None and finding.verdict is Verdict.UNDECIDED for finding in known):
        return True
    exponent = getattr(result, row.key)
    if not isinstance(exponent, Exponent) or exponent.exact is not None:
        return False
    lower, upper = exponent.lower, exponent.upper
    return lower is None or upper is None or Fraction(upper) - Fraction(lower) > WIDE


def maximizing_product(result: Result) -> tuple[int, ...] | None:
    """The word of the product that attains an exact Hölder exponent, first among its cyclic shifts; None without one.

    A product bounds the exponent from above, and attains the joint spectral radius where the bound is the exponent.
    """
    finding = answering(result.findings, HOLDER_UPPER)
    if finding is None or result.holder is None or result.holder.exact is None:
        return None
    word = finding.witness.get("word")
    if not isinstance(word, tuple):
        return None
    letters = tuple(letter for letter in word if isinstance(letter, int))
    return min((letters[i:] + letters[:i] for i in range(len(letters))), default=None)


def changes(rows: Sequence[Row]) -> Iterator[tuple[Row, Row]]:
    """The neighbours, of those rows that name a product, that name different ones, by rising values."""
    known = sorted((row for row in rows if row.product is not None), key=lambda row: row.value)
    return ((row, other) for row, other in pairwise(known) if row.product != other.product)


def enclosed(x: Fraction) -> Interval:
    """A rational as text and between doubles; without these where it is too large for one."""
    try:
        return Interval(outward(x, -inf), outward(x, inf), rational(x))
    except OverflowError:
        return Interval(exact=rational(x))
