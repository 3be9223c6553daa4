"""SD603: is φ a box spline?

Theorem: see numbers/box_spline.py. The factorisation is of the mask of S itself, or of a power S^r whose dilation is
a multiple of I; it is exact, and the directions are found without a search. Hypothesis, the coset sums add up
to |det M|: checked. There is a finding only where φ is one.

Witness: `directions` with `multiplicities`; `power`, r; `scale`, c with M^r = c I; `shift`; `depth`, the least number
of directions whose removal leaves a set that does not span; `unimodular`, whether all determinants are -1, 0 or 1.
"""

from __future__ import annotations

from collections.abc import Mapping

from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.scheme import Index
from subdiv_cli.model import Data, Finding

RULE = rules.BOX_SPLINE


def run(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    box = numbers.box
    if box is None:
        return ()
    count = box.multiplicities
    of = "" if box.power == 1 else f"; recognised in S^{box.power}, whose dilation is {box.scale}I"
    statement = f"φ is the box spline of {len(box.directions)} directions: {_listed(count)}{of}"
    witness: dict[str, Data] = {
        "directions": tuple(count),
        "multiplicities": tuple(count.values()),
        "power": box.power,
        "scale": box.scale,
        "shift": box.shift,
        "depth": box.depth,
        "unimodular": box.is_unimodular,
    }
    return (RULE.proved(statement, witness),)


def _listed(count: Mapping[Index, int]) -> str:
    """`(0, 1), (1, 0), each twice`, or `(0, 1), (1, 0) 3 times`."""
    times = {n: "twice" if n == 2 else f"{n} times" for n in count.values()}
    if len(times) == 1 and 1 not in times and len(count) > 1:
        return f"{', '.join(map(str, count))}, each {times[min(times)]}"
    return ", ".join(f"{xi}" + (f" {times[n]}" if n > 1 else "") for xi, n in count.items())
