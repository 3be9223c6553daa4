"""Where a mask stands changes no verdict, no bound and no number of steps."""

from collections import Counter

import pytest
from random_masks import moved, random_multivariate, random_scalar
from support import answer, cases, seeded, shipped_multivariate

from subdiv_cli.kinds.multivariate.numbers.difference_space import difference_space
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.spaces.lattice import Lattice

EFFORT = 1000
OF_THE_PLACE = {"SD202", "SD304"}
"""They speak of the refinement matrices at the mask's own indices, of which only a shift by p - 1 gives the same."""


def said(result, besides=frozenset()):
    """All that a shift must leave alone."""
    whole = {name: getattr(result, name) for name in ("convergent", "smoothness", "refinable", "holder", "sobolev")}
    whole |= {name: getattr(result, name) for name in ("stable", "linearly_independent", "generation", "reproduction")}
    findings = [(f.code, f.verdict, f.value, f.closed) for f in result.findings if f.code not in besides]
    return whole, result.sum_rule_order, result.status, findings


@pytest.mark.parametrize("make", [random_scalar, random_multivariate])
def test_a_shift_changes_no_verdict(make):
    rng, mix = seeded(17), Counter()
    for _ in range(cases(60 if make is random_scalar else 24)):
        mask = make(rng)
        by = tuple(rng.choice((-1, 1)) * rng.choice((1, 2, 3, 50, 997)) for _ in range(2))
        besides = OF_THE_PLACE if mask.kind == "scalar" and by[0] % (mask.arity - 1) else set()
        result = answer(mask, EFFORT)
        assert said(answer(moved(mask, by), EFFORT), besides) == said(result, besides), (mask, by)
        mix[result.convergent] += 1
        mix[result.stable] += 1
        mix[result.holder is not None and result.holder.exact is not None] += 1
    assert mix[Verdict.PROVED] > 12
    assert mix[Verdict.REFUTED] > 5
    assert mix[True] > 3


@pytest.mark.parametrize("name", ["loop", "sqrt3_linear", "quincunx_interpolatory", "box_fcc_cubic"])
def test_the_difference_space_is_the_same_everywhere(name):
    mask = shipped_multivariate(name)
    lattice = Lattice(mask.dilation)
    places = [(t, -t // 2, 7)[: lattice.dimension] for t in (0, 1, -5, 1000)]
    spaces = [difference_space(moved(mask, at), lattice, 2, Effort()) for at in places]
    assert all(space.matrices == spaces[0].matrices for space in spaces)
