"""The checker's integer arithmetic against floats (numpy) and against naive computations with Fractions."""

import random
from fractions import Fraction
from itertools import product as words
from math import gcd

import numpy as np
import pytest
from flint import fmpz_mat
from hand_made import naive_norm, naive_product

from subdiv_cli.checker import matrices
from subdiv_cli.checker.polynomials import (
    Polynomial,
    add,
    components,
    cyclotomic_divides,
    divides,
    greatest_common_divisor,
    is_cycle,
    iterated_norm,
    multiply,
    over_common_denominator,
    polynomial,
    prime_factors,
    remainder,
    sigma_divides,
    spread,
    sturm_count,
    times,
    times_sigma,
    totients,
    vanishes_on_circle,
)


def random_polynomial(rng, length, size=9):
    return [rng.randint(-size, size) for _ in range(length - 1)] + [rng.choice((-1, 1)) * rng.randint(1, size)]


def convolve(*factors):
    result = [1]
    for f in factors:
        result = [int(c) for c in naive_product(result, f)]
    return result


def laurent(f: Polynomial):
    return {f.start + k: Fraction(c, f.denominator) for k, c in enumerate(f.numerators) if c}


def test_normal_form():
    assert polynomial(3, [0, 0, 2, 4, 0], 6) == Polynomial(5, (1, 2), 3)
    assert polynomial(3, [0, 0], 6) == Polynomial(0, (), 1)
    assert over_common_denominator(-1, [(1, 2), (0, 1), (-2, 3)], 100) == Polynomial(-1, (3, 0, -4), 6)
    assert over_common_denominator(0, [(1, 2**60), (1, 3**60)], 100) is None


def test_laurent_arithmetic_on_random_polynomials():
    rng = random.Random(1)
    for _ in range(200):
        f = polynomial(rng.randint(-5, 5), random_polynomial(rng, rng.randint(1, 7)), rng.randint(1, 9))
        g = polynomial(rng.randint(-5, 5), random_polynomial(rng, rng.randint(1, 7)), rng.randint(1, 9))
        z = Fraction(rng.randint(1, 9), rng.randint(1, 9))
        p = rng.randint(2, 5)

        def value(h, x):
            return sum((c * x**i for i, c in laurent(h).items()), Fraction(0))

        assert value(multiply(f, g), z) == value(f, z) * value(g, z)
        assert value(add(f, g), z) == value(f, z) + value(g, z)
        assert add(f, times(f, -1)) == polynomial(0, [], 1)
        assert value(spread(f, p), z) == value(f, z**p)
        assert value(times(f, 3, 7, 2), z) == value(f, z) * z**2 * Fraction(3, 7)
        assert value(times_sigma(f, p, 3), z) == value(f, z) * sum(z**i for i in range(p)) ** 3
        total = polynomial(0, [], 1)
        for r, component in enumerate(components(f, p)):
            total = add(total, times(spread(component, p), 1, shift=r))
        assert total == f
        assert sigma_divides(times_sigma(f, p, 1), p)
        assert sigma_divides(f, p) == (not remainder(f.numerators, [1] * p))


@pytest.mark.parametrize(("p", "level"), [(2, 1), (2, 5), (3, 3), (4, 2), (5, 1), (2, 3)])
@pytest.mark.parametrize("size", [1, 9, 10**40])
def test_norms_against_fractions(p, level, size):
    rng = random.Random(p * 100 + level)
    for length in range(1, 7):
        numerators = random_polynomial(rng, length, size)
        f = polynomial(rng.randint(-3, 3), numerators, rng.randint(1, 5) * size)
        expected = naive_norm([Fraction(c) for c in f.numerators], p, level)
        assert iterated_norm(f, p, level) == expected


@pytest.mark.parametrize(("p", "length"), [(2, 4), (2, 1), (3, 5), (3, 2), (4, 6)])
def test_transition_matrices_have_the_norms_of_the_scheme(p, length):
    """‖D^L‖∞ is the largest row sum of all products of L matrices."""
    rng = random.Random(length)
    q = polynomial(0, [rng.choice((-1, 1)) * rng.randint(1, 9) for _ in range(length)], 1)
    order = max(1, -(-(length - 1) // (p - 1)))
    family = [matrices.section(q, p, epsilon + (p - 1) * (order - 1), order) for epsilon in range(p)]
    level = 3
    largest = 0
    for word in words(range(p), repeat=level):
        total = family[word[0]]
        for letter in word[1:]:
            total = matrices.multiply(family[letter], total)
        largest = max(largest, *(sum(map(abs, row)) for row in total))
    assert largest == iterated_norm(q, p, level)


def test_characteristic_polynomials_annihilate_and_agree_with_numpy():
    rng = random.Random(7)
    for order in range(9):
        a = [[rng.randint(-9, 9) for _ in range(order)] for _ in range(order)]
        f = matrices.characteristic_polynomial(a)
        assert len(f) == order + 1
        assert f[-1] == 1
        total = [[0] * order for _ in range(order)]
        for c in reversed(f):
            total = matrices.multiply(total, a) if order else total
            total = [[x + c * (i == j) for j, x in enumerate(row)] for i, row in enumerate(total)]
        assert not any(any(row) for row in total)
        if order:
            assert np.allclose(np.poly(np.array(a, dtype=float))[::-1], f, rtol=1e-8, atol=1e-6)


def test_characteristic_polynomials_of_sparse_matrices_agree_with_flint():
    """They fall into blocks, of one coordinate or of cycles, in any order of the coordinates."""
    rng = random.Random(11)
    for order in range(1, 15):
        for density in (0.05, 0.1, 0.2, 0.4):
            a = [[rng.randint(-9, 9) if rng.random() < density else 0 for _ in range(order)] for _ in range(order)]
            assert matrices.characteristic_polynomial(a) == [int(c) for c in fmpz_mat(a).charpoly()]


def test_characteristic_polynomials_of_symmetric_blocks_agree_with_flint():
    """Their own mirror image, whole or in a block."""
    rng = random.Random(13)
    for order in range(1, 12):
        half = [[rng.randint(-9, 9) for _ in range(order)] for _ in range(-(-order // 2))]
        mirrored = [row[::-1] for row in reversed(half)]
        a = half + mirrored[order % 2 :]
        if order % 2:
            middle = order // 2
            a[middle] = [x + y for x, y in zip(a[middle], a[middle][::-1], strict=True)]
        assert a == [row[::-1] for row in reversed(a)]
        assert matrices.characteristic_polynomial(a) == [int(c) for c in fmpz_mat(a).charpoly()]
        bordered = [[5, *[rng.randint(1, 9) for _ in range(order)]], *([0, *row] for row in a)]
        assert matrices.characteristic_polynomial(bordered) == [int(c) for c in fmpz_mat(bordered).charpoly()]


def schur_cohn_fujiwara(f):
    """The matrix of FORMAT.md, term by term, f over the unit disc."""
    n = len(f) - 1
    return [
        [
            sum(f[n - i + k] * f[n - j + k] - f[i - k] * f[j - k] for k in range(1, min(i, j) + 1))
            for j in range(1, n + 1)
        ]
        for i in range(1, n + 1)
    ]


def determinant(matrix):
    rows, result = [[Fraction(x) for x in row] for row in matrix], Fraction(1)
    for k in range(len(rows)):
        pivot = next((i for i in range(k, len(rows)) if rows[i][k]), None)
        if pivot is None:
            return Fraction(0)
        if pivot != k:
            rows[k], rows[pivot], result = rows[pivot], rows[k], -result
        result *= rows[k][k]
        for i in range(k + 1, len(rows)):
            factor = rows[i][k] / rows[k][k]
            rows[i] = [x - factor * y for x, y in zip(rows[i], rows[k], strict=True)]
    return result


def positive_definite(matrix):
    return all(determinant([row[:k] for row in matrix[:k]]) > 0 for k in range(1, len(matrix) + 1))


def test_roots_inside_is_the_criterion_of_the_format_and_agrees_with_numpy():
    rng, seen = random.Random(3), {True: 0, False: 0}
    for _ in range(1500):
        f = random_polynomial(rng, rng.randint(1, 7))
        if rng.random() < 0.5:
            f[-1] = rng.choice((-1, 1)) * (abs(f[-1]) + 20)
        inside = matrices.roots_lie_inside(f, Fraction(1))
        assert inside == positive_definite(schur_cohn_fujiwara(f))
        largest = max(abs(np.roots(f[::-1])), default=0)
        if abs(largest - 1) > 1e-6:
            assert inside == (largest < 1)
        seen[inside] += 1
    assert min(seen.values()) > 300


CIRCLE = [[-1, 1], [1, 1], [1, 0, 1], [1, 1, 1], [1, -1, 1], [5, -6, 5], [5, 8, 5], [1, 1, 1, 1, 1]]


@pytest.mark.parametrize("on_circle", CIRCLE)
def test_a_root_exactly_on_the_circle_is_not_inside(on_circle):
    rng = random.Random(5)
    for _ in range(60):
        f = convolve(on_circle, [rng.randint(-2, 2), 5], [rng.randint(-2, 2), rng.randint(-2, 2), 7])
        f = f if rng.random() < 0.5 else [-c for c in f]
        radius = Fraction(rng.randint(1, 9), rng.randint(1, 9))
        scaled = [c * radius.denominator**i * radius.numerator ** (len(f) - 1 - i) for i, c in enumerate(f)]
        assert not matrices.roots_lie_inside(scaled, radius)
        assert matrices.roots_lie_inside(scaled, radius + Fraction(1, 10**9))
        assert not matrices.roots_lie_inside(scaled, radius - Fraction(1, 10**9))


def test_roots_inside_in_degree_zero_and_at_zero():
    assert matrices.roots_lie_inside([1], Fraction(1, 9))
    assert matrices.roots_lie_inside([0, 0, 0, 1], Fraction(1, 10**9))
    assert not matrices.roots_lie_inside([0, 0, -1, 1], Fraction(1))


def test_remainder_is_a_positive_multiple():
    rng = random.Random(11)
    for _ in range(300):
        f, g = random_polynomial(rng, rng.randint(1, 8)), random_polynomial(rng, rng.randint(1, 5))
        expected = [Fraction(c) for c in f]
        while len(expected) >= len(g):
            factor, shift = expected[-1] / g[-1], len(expected) - len(g)
            for i, c in enumerate(g, shift):
                expected[i] -= factor * c
            expected.pop()
        while expected and not expected[-1]:
            expected.pop()
        got = remainder(f, g)
        assert len(got) == len(expected)
        ratios = {Fraction(x) / y for x, y in zip(got, expected, strict=True) if y}
        assert len(ratios) <= 1
        assert all(r > 0 for r in ratios)


def test_common_divisors():
    rng = random.Random(12)
    for _ in range(200):
        g, f, h = (random_polynomial(rng, rng.randint(1, 4)) for _ in range(3))
        common = greatest_common_divisor(convolve(g, f), convolve(g, h))
        assert not remainder(common, g)
        assert not remainder(convolve(g, f), common)
        assert not remainder(convolve(g, h), common)


def test_divides_with_content_and_powers_of_z():
    g = polynomial(-4, [0, 2, 4, 0], 3)
    f = multiply(g, polynomial(7, [5, -1, 3], 11))
    assert divides(g, [f, polynomial(0, [], 1)])
    assert not divides(g, [f, add(f, polynomial(0, [1], 1))])


def test_sturm_counts_distinct_roots():
    rng = random.Random(13)
    for _ in range(300):
        roots = [rng.choice([-5, -3, -1, 0, 1, 3, 5, 7]) for _ in range(rng.randint(0, 5))]
        f = convolve([rng.choice((-2, 1))], *([-r, 2] for r in roots), *([[1, 0, 1]] if rng.random() < 0.5 else []))
        expected = len({r for r in roots if -4 < r < 4})
        assert sturm_count(f, -2, 2) == expected


def test_zeros_on_the_circle_against_numpy():
    rng, seen = random.Random(14), {True: 0, False: 0}
    for _ in range(1500):
        half = random_polynomial(rng, rng.randint(1, 4))
        sign = rng.choice((1, 1, 1, -1))
        middle = [rng.randint(-9, 9)] if rng.random() < 0.6 else []
        f = [*half[::-1], *middle, *(sign * c for c in half)]
        f = convolve(f, *(rng.choice(CIRCLE) for _ in range(rng.random() < 0.2)), [rng.randint(2, 5), 1])
        g = polynomial(0, f, 1)
        roots = np.roots(f[::-1])
        distance = min(abs(abs(roots) - 1), default=1.0)
        answer = vanishes_on_circle(g)
        if distance > 1e-3:
            assert not answer
        elif distance < 1e-9:
            assert answer
        seen[answer] += 1
    assert min(seen.values()) > 200


@pytest.mark.parametrize("on_circle", CIRCLE)
def test_zeros_exactly_on_the_circle_also_multiple_ones(on_circle):
    for cofactor in ([1], [3, 1], [2, 5, 2], [1, 3], [2, -7, 2, 5]):
        for power in (1, 2, 3):
            assert vanishes_on_circle(polynomial(-2, convolve(cofactor, *[on_circle] * power), 7))
    assert not vanishes_on_circle(polynomial(0, [2, 5, 2], 1))
    assert not vanishes_on_circle(polynomial(0, convolve([2, 5, 2], [2, 5, 2], [3, -10, 3]), 1))
    assert not vanishes_on_circle(polynomial(5, [4], 3))


def cyclotomic(m):
    """Φ_m by division of z^m - 1."""
    f = [-1, *[0] * (m - 1), 1]
    for d in range(1, m):
        if m % d == 0:
            g, quotient = cyclotomic(d), []
            f = list(f)
            while len(f) >= len(g):
                quotient.append(f[-1])
                for i, c in enumerate(g, len(f) - len(g)):
                    f[i] -= quotient[-1] * c
                f.pop()
            f = quotient[::-1]
    return f


def test_cyclotomic_divisibility():
    rng = random.Random(15)
    for m in range(2, 40):
        phi = cyclotomic(m)
        assert len(phi) - 1 == totients(m)[m] == sum(gcd(m, i) == 1 for i in range(m))
        assert prime_factors(m) == [q for q in range(2, m + 1) if m % q == 0 and all(q % r for r in range(2, q))]
        for cofactor in ([1], [2, -1], random_polynomial(rng, 4)):
            f = polynomial(3, convolve(phi, cofactor), 5)
            assert cyclotomic_divides(m, f)
            off = list(f.numerators)
            off[-1] += 1
            assert cyclotomic_divides(m, polynomial(0, off, 1)) == (not remainder(off, phi))
    assert not cyclotomic_divides(3, polynomial(0, [-2, 1], 1))  # zero at the point of the quick test


@pytest.mark.parametrize(("n", "p"), [(3, 2), (5, 2), (7, 2), (9, 2), (15, 2), (2, 3), (4, 3), (5, 4), (7, 6), (5, 6)])
def test_cycles(n, p):
    phi = cyclotomic(n)
    inflated = [0] * (p * (len(phi) - 1) + 1)
    inflated[::p] = phi
    rest = polynomial(0, inflated, 1)
    f = [polynomial(0, cyclotomic(n * d), 1) for d in range(2, p + 1) if p % d == 0]
    quotient = polynomial(0, [1], 1)
    for factor in f:
        quotient = multiply(quotient, factor)
    assert multiply(quotient, polynomial(0, phi, 1)) == rest  # Φ_n(z^p)/Φ_n(z) = Π Φ_(nd)
    assert is_cycle(multiply(quotient, polynomial(0, [2, 1], 1)), n, p)
    assert not is_cycle(polynomial(0, [2, *cyclotomic(n * 2)], 1), n, p)
