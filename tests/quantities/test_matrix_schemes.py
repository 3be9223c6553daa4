"""Matrix schemes of differences: the identity on data, norms by another route, and no contradiction to ρ_k."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction
from itertools import product

import pytest
from support import answer, cases, findings, multivariate_scheme, seeded, shipped_multivariate

from subdiv_cli.kinds.multivariate.numbers.box_spline import multiplied
from subdiv_cli.kinds.multivariate.numbers.matrix_norms import by_lemma, iterates, least, matrix_norm, problem
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.model import Effort, Verdict

TWO = ((2, 0), (0, 2))
QUINCUNX = ((1, 1), (1, -1))
BEAR = ((1, -2), (1, 0))
UNEQUAL = ((2, 0), (0, 3))
ENOUGH = Effort(10**6)


def numbers_of(name):
    return MultivariateNumbers(shipped_multivariate(name), Effort())


def refined(terms, matrix, data):
    """S f of finite data, terms of a mask of dilation M."""
    image = {}
    for (alpha, x), (beta, y) in product(terms.items(), data.items()):
        at = tuple(a + sum(m * b for m, b in zip(row, beta, strict=True)) for a, row in zip(alpha, matrix, strict=True))
        image[at] = image.get(at, 0) + x * y
    return {at: value for at, value in image.items() if value}


def differences_of(data, mu):
    """∇^μ f."""
    for j, times in enumerate(mu):
        for _ in range(times):
            moved = {(*at[:j], at[j] + 1, *at[j + 1 :]): x for at, x in data.items()}
            data = {at: data.get(at, 0) - moved.get(at, 0) for at in {**data, **moved}}
    return {at: x for at, x in data.items() if x}


def added(parts):
    total = {}
    for part in parts:
        for at, x in part.items():
            total[at] = total.get(at, 0) + x
    return {at: x for at, x in total.items() if x}


@pytest.mark.parametrize("reduce", [by_lemma, least])
@pytest.mark.parametrize(
    ("name", "k", "power"),
    [
        ("butterfly", 1, 1),
        ("butterfly", 3, 1),
        ("bear", 1, 2),
        ("bear", 2, 1),
        ("kobbelt_sqrt3", 2, 2),
        ("anisotropic_bilinear", 2, 1),
        ("trilinear", 1, 1),
        ("courant_ternary", 1, 1),
    ],
)
def test_differences_of_refined_data_come_from_differences(reduce, name, k, power):
    """∇^μ S^r f = Σ_ν S_(q_μν) ∇^ν f for random data."""
    numbers = numbers_of(name)
    asked = problem(numbers.scheme, numbers.lattice, k, power)
    entries, rng = reduce(asked).entries(), random.Random(7)
    places = product(range(3), repeat=numbers.dimension)
    data = {at: Fraction(rng.randint(-9, 9)) for at in places}
    finer = data
    for _ in range(power):
        finer = refined(numbers.scheme.terms, numbers.scheme.dilation, finer)
    for i, mu in enumerate(asked.components):
        parts = [
            refined(entries.get((i, j), {}), asked.lattice.dilation, differences_of(data, nu))
            for j, nu in enumerate(asked.components)
        ]
        assert added(parts) == differences_of(finer, mu)


def first_norms(name, k, reduce, count):
    numbers = numbers_of(name)
    found = iterates(reduce(problem(numbers.scheme, numbers.lattice, k, 1)), ENOUGH)
    return [next(found).norm for _ in range(count)]


def test_the_quincunx_by_hand():
    """FORMAT.md: 1, 1, 27/32."""
    assert first_norms("quincunx_interpolatory", 1, least, 3) == [1, 1, Fraction(27, 32)]
    assert first_norms("quincunx_interpolatory", 1, by_lemma, 2) == [Fraction(3, 2), Fraction(17, 8)]


def test_directional_factors_give_a_diagonal_scheme():
    """Dyn 1992, (6.50), (6.51): for Courant's hat both reductions are diagonal, ‖S_Δ^L‖∞ = 2^-L."""
    for reduce in (by_lemma, least):
        assert first_norms("courant", 1, reduce, 4) == [Fraction(1, 2**n) for n in range(1, 5)]


def test_the_butterfly_has_norm_seven_eighths_on_differences():
    assert first_norms("butterfly", 1, least, 1) == [Fraction(7, 8)]
    assert first_norms("butterfly", 1, by_lemma, 1) == [Fraction(21, 8)]


def test_the_butterfly_is_smooth_by_third_differences():
    """‖S_(Δ^3)^3‖∞ < 2^-3, and no level below: C^1. By second differences, (½S_2)^L, more than four are needed."""
    numbers = numbers_of("butterfly")
    found = matrix_norm(numbers.scheme, numbers.lattice, 3, 1, Effort())
    assert (found.power, found.steps, found.by) == (1, 3, "least")
    assert found.norm < Fraction(1, 8)
    second = first_norms("butterfly", 2, least, 3)
    assert all(norm * 2**level > 1 for level, norm in enumerate(second, 1))


def test_least_is_least_on_a_line_of_data():
    """By duality a norm is at least Σ p_β f_β, |f_β - f_(β+e_i)| <= 1; here f = ±β_1 ± β_2, cut off at 0 and 1, …"""
    for name in ("butterfly", "bear", "quincunx_interpolatory", "loop", "zwart_powell", "kobbelt_sqrt3"):
        numbers = numbers_of(name)
        asked = problem(numbers.scheme, numbers.lattice, 1, 1)
        best = least(asked).norm
        for part in asked.parts:
            for x, y, cut in product((-1, 0, 1), (-1, 0, 1), range(-4, 5)):
                for shape in (abs, lambda t: max(t, 0), lambda t: t):
                    assert sum(p * shape(x * i + y * j - cut) for (i, j), p in part.terms.items()) <= best


def random_mask(rng):
    """Directional factors, a random cofactor with value 1 at (1, 1), and sometimes g(z^M)/g(z) to make φ unstable."""
    dilation, factors = rng.choice(
        [
            (TWO, [(1, 0), (0, 1)]),
            (TWO, [(1, 0), (0, 1), (1, 1)]),
            (TWO, [(1, 0), (0, 1), (1, 1)] * 2),
            (QUINCUNX, [(1, 0)]),
            (QUINCUNX, [(1, 0), (1, 0)]),
        ]
    )
    terms = {(0, 0): Fraction(1)}
    for x in factors:
        terms = multiplied(terms, {(0, 0): Fraction(1, 2), x: Fraction(1, 2)})
    cofactor = {(0, 0): Fraction(1)}
    for _ in range(rng.randint(0, 3)):
        at, x = (rng.randint(-1, 1), rng.randint(-1, 1)), Fraction(rng.randint(-3, 3), rng.choice([2, 4, 8]))
        for place, sign in ((at, 1), ((0, 0), -1)):
            cofactor[place] = cofactor.get(place, Fraction(0)) + sign * x
    if rng.random() < 0.25:  # (1 + z^2) in place of (1 + z): a gap
        cofactor = multiplied(cofactor, {(0, 0): Fraction(1, 2), (2, 0): Fraction(1, 2)})
        terms = multiplied(terms, {(0, 0): Fraction(1)})
    scale = 4 if dilation == TWO else 2
    return multivariate_scheme({at: scale * x for at, x in multiplied(terms, cofactor).items()}, dilation)


def test_norms_never_contradict_the_radius():
    """On random masks: no norm lies below a product of transition operators, and no verdict contradicts."""
    rng, mix = seeded(1992), Counter()
    for _ in range(cases(60)):
        numbers = MultivariateNumbers(random_mask(rng), Effort(300))
        if numbers.space is None or numbers.product is None:
            continue
        radius = numbers.product.eigenvalue
        for n in range(numbers.order):
            found = numbers.matrix_norm(n + 1, n)
            mix[n, found is not None] += 1
            if found is not None:
                power = numbers.product.of_word(numbers.space.matrices, numbers.product.word * found.level)
                threshold = found.norm ** len(numbers.product.word)
                assert power.eigenvalue.compare_modulus(threshold) <= 0
        if radius.compare_modulus(Fraction(1)) >= 0:
            mix["diverges"] += 1
            assert numbers.matrix_norm(1, 0) is None
    assert min(mix[0, True], mix[0, False], mix["diverges"]) >= 10
    assert min(mix[1, True], mix[1, False]) >= 2


def test_all_convergent_masks_of_the_catalog_in_two_variables_contract():
    """Sufficient only; but the least norms of S, S^2 and S^3 are enough for each of these."""
    for name in ("bear", "kobbelt_sqrt3", "midedge", "quincunx_linear", "sqrt3_linear", "velho_zorin"):
        numbers = numbers_of(name)
        assert numbers.matrix_norm(1, 0) is not None
    for name in ("haar", "quincunx_haar", "butterfly_3_4", "tensor_divergent", "box_21_discontinuous"):
        assert numbers_of(f"counterexamples/{name}").matrix_norm(1, 0) is None


def test_the_norm_proves_what_the_radius_does_not():
    """With hardly any effort no radius is bounded; the second differences of Kobbelt's scheme still contract."""
    for work in (200, 1000, 4000):
        result = answer(shipped_multivariate("kobbelt_sqrt3"), work)
        assert result.convergent is Verdict.PROVED
    (found,) = findings(answer(shipped_multivariate("bear")), "SD606")
    assert found.witness["norm"] == Fraction(15, 16)
    assert (found.witness["by"], found.witness["level"]) == ("lemma", 4)
    assert "by Lemma 6.6, 3/2 (by least norm: 3/2)" in found.statement
