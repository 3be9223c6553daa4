"""The properties of a scheme that results have in short: one table for every format, for baselines and expectations."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, NamedTuple

from subdiv_cli.model import findings as q
from subdiv_cli.model.findings import Question


class Property(NamedTuple):
    """A field of `Result`, which is a key of the JSON report too, and how it is called."""

    key: str
    title: str
    """In tables."""
    phrase: str
    """In sentences."""
    form: Literal["verdict", "smoothness", "exponent", "order", "degree"]
    """What it is: a verdict, a `Smoothness`, an `Exponent`, or an integer that is called so."""
    question: Question
    more: tuple[Question, ...] = ()
    """Questions whose findings stand beside the first one's, as what makes its answer sharp."""
    instead: tuple[Question, ...] = ()
    """Questions whose findings say something about it where nobody asked the first one."""
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
)
"""In the order of tables."""
BY_KEY: Mapping[str, Property] = {row.key: row for row in PROPERTIES}
EXPECTED = tuple(row.key for row in PROPERTIES if row.expected)
"""The keys of [expect]."""
