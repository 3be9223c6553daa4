"""SD601: the coset sums.

Theorem (Dyn 1992, Proposition 6.1; Cavaretta, Dahmen & Micchelli 1991): if S converges uniformly, to a limit that is
not zero for some data, Σ_β a_(γ+Mβ) = 1 for every coset γ + M Z^s. Necessary, and with it S maps constants to
themselves. No hypotheses.

Witness: `cosets`, a representative of each; `sums`.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.scalar.stages.stage import series
from subdiv_cli.model import Data, Finding

RULE = rules.COSET_SUMS


def run(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    sums, count = numbers.sums, numbers.lattice.index
    witness: dict[str, Data] = {"cosets": numbers.lattice.representatives, "sums": sums}
    if set(sums) == {Fraction(1)}:
        return (RULE.proved(f"all {count} coset sums are 1", witness),)
    return (RULE.refuted(f"the coset sums are {series(sums, number)}, must be 1", witness),)
