"""Masks that stay in a lattice: what S^L δ leaves out, and the index of the lattice by another route."""

from collections import Counter
from fractions import Fraction
from itertools import product

import pytest
from random_masks import random_multivariate
from support import answer, cases, findings, multivariate_scheme, seeded

from subdiv_cli.kinds.multivariate.numbers.box_spline import iterated
from subdiv_cli.kinds.multivariate.numbers.sublattice import sublattice
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.pipeline import check
from subdiv_cli.spaces.lattice import Lattice

QUINCUNX, TWO = ((1, -1), (1, 1)), ((2, 0), (0, 2))


def stretched(mask, factor):
    return multivariate_scheme({tuple(factor * i for i in at): x for at, x in mask.terms.items()}, mask.dilation)


def reached(mask, size):
    """The cosets modulo `size` Z^2 of Γ, by adding differences and their images until nothing is new."""
    lattice, first = Lattice(mask.dilation), min(mask.terms)
    found = {tuple((i - j) % size for i, j in zip(at, first, strict=True)) for at in mask.terms}
    while True:
        more = {tuple(i % size for i in lattice.image(at)) for at in found}
        more |= {tuple((i + j) % size for i, j in zip(a, b, strict=True)) for a, b in product(found | more, repeat=2)}
        if more <= found:
            return found
        found |= more


def test_the_index_by_counting():
    rng, mix = seeded(20), Counter()
    for _ in range(cases(30)):
        mask, factor = random_multivariate(rng, [QUINCUNX, TWO, ((0, 2), (1, 0))]), rng.choice((1, 2, 3))
        stays = sublattice(stretched(mask, factor), Lattice(mask.dilation))
        index = 1 if stays is None else stays.cosets
        mix[index] += 1
        if index is not None:
            assert len(reached(stretched(mask, factor), 6)) * (index if 36 % index == 0 else 0) in (36, 0)
    assert len(mix) > 2
    assert mix[1] > 3


@pytest.mark.parametrize("dilation", [QUINCUNX, TWO, ((5, 23), (-1, -5))])
def test_what_is_left_out(dilation):
    """u·α is the same modulo n at all indices of the mask of S^3; and S diverges."""
    mask = multivariate_scheme({(1, 1): Fraction(1, 2), (1, 4): Fraction(1), (1, 7): Fraction(1, 2)}, dilation)
    lattice = Lattice(dilation)
    stays = sublattice(mask, lattice)
    values = {
        sum(x * i for x, i in zip(stays.functional, at, strict=True)) % stays.modulus
        for at in iterated(mask, lattice, 3)
    }
    assert len(values) == 1
    assert any(x % stays.modulus for x in stays.functional)
    result = answer(mask)
    assert result.convergent is Verdict.REFUTED
    assert findings(result, "SD620")


def test_masks_that_converge_stay_nowhere():
    rng, converge = seeded(21), 0
    for _ in range(cases(15)):
        mask = random_multivariate(rng)
        stays, result = sublattice(mask, Lattice(mask.dilation)), answer(mask, 300)
        if result.convergent is Verdict.PROVED:
            converge += 1
            assert stays is None
    assert converge > 5


@pytest.mark.parametrize(("step", "index", "modulus"), [((102, 1), 10199, 7), ((104, 1), 10607, None)])
def test_of_a_large_index_a_small_factor_is_named(step, index, modulus):
    """10199 = 7·31·47; 10607 is a prime, which certificates have no number for: then nothing is found."""
    doubled = tuple(2 * i for i in step)
    mask = multivariate_scheme({(0, 0): Fraction(1, 2), step: 1, doubled: Fraction(1, 2)}, ((1, 1), (1, -1)))
    stays = sublattice(mask, Lattice(mask.dilation))
    assert (stays and (stays.cosets, stays.modulus)) == (modulus and (index, modulus))
    result = check(mask, (), Effort(200)).result
    assert result.convergent is (Verdict.UNDECIDED if modulus is None else Verdict.REFUTED)
