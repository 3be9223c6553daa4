"""The short properties of a scheme in results: one table for every format, for baselines and expectations."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, NamedTuple

from subdiv_cli.model import findings as q
from subdiv_cli.model.findings import Question


class Property(NamedTuple):
    """A field of `Result`, which is a key of the JSON report too, and its names."""

    key: str
    title: str
    """The name in tables."""
    phrase: str
    """The name in sentences."""
    form: Literal["verdict", "smoothness", "exponent", "order", "degree", "dimension"]
    """The type: a verdict, a `Smoothness`, an `Exponent`, or an integer with this name."""
    question: Question
    more: tuple[Question, ...] = ()
    """Questions whose findings stand beside the first one's, as what makes its answer sharp."""
    instead: tuple[Question, ...] = ()
    """Questions whose findings stand in for the first one's where that has no finding."""
    expected: bool = True
    """Whether [expect] may hold a mask to it."""


PROPERTIES = (
    Property("convergent", "convergence", "convergence", "verdict", q.CONVERGENCE, instead=(q.SUMS,)),
    Property(
        "smoothness", "smoothness", "the order of smoothness", "smoothness", q.SMOOTHNESS, more=(q.NEXT_SMOOTHNESS,)
    ),
    Property("holder", "Hölder exponent", "the Hölder exponent", "exponent", q.HOLDER_LOWER, more=(q.HOLDER_UPPER,)),
    Property("sobolev", "Sobolev (L2)", "the Sobolev exponent", "exponent", q.SOBOLEV),
    Property("stable", "stability", "stability", "verdict", q.STABILITY),
    Property("linearly_independent", "independence", "linear independence", "verdict", q.INDEPENDENCE, expected=False),
    Property("sum_rule_order", "sum rules", "the sum-rule order", "order", q.SUM_RULES, expected=False),
    Property("generation", "generation", "the generation degree", "degree", q.GENERATION),
    Property("reproduction", "reproduction", "the reproduction degree", "degree", q.REPRODUCTION),
    Property("dimension", "constants", "the dimension of the space of constants", "dimension", q.DIMENSION),
    Property("well_defined", "well defined", "whether there is one curve", "verdict", q.WELL_DEFINED),
    Property("polynomials", "polynomials", "the degree of polynomial components", "degree", q.POLYNOMIALS),
    Property("spectral", "spectral condition", "the spectral condition", "verdict", q.SPECTRAL),
    Property("holder_at_zero", "exponent at 0", "the exponent at 0", "exponent", q.HOLDER_AT_ZERO),
)
"""The properties in the order of tables."""
BY_KEY: Mapping[str, Property] = {row.key: row for row in PROPERTIES}
EXPECTED = tuple(row.key for row in PROPERTIES if row.expected)
"""The keys of [expect]."""
