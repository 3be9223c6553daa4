"""The rule on the Sobolev exponent s of φ. See FORMAT.md.

q is the quotient of the sum-rules claim, n its degree, b(z) = q(z) q(1/z), and N_L = p^-L Σ_i |q^[L]_i|² with
q^[L](z) = Π_(j<L) q(z^(p^j)). For stable φ, s = -log_p(λ)/2 with λ = lim sup N_L^(1/L).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import isqrt
from operator import mul

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import Matrix
from subdiv_cli.checker.polynomials import Polynomial, multiply
from subdiv_cli.checker.reading import Rejected, require

_PRIMES = ((1 << 61) - 1, (1 << 89) - 1)


def sobolev(c: Claim) -> None:
    """s = -log_p(λ)/2, λ the only zero of f in [x, y].

    N_L = (G^L e_0)_0 with G as in `_transfer`, so Σ N_L z^(-L-1) = P(z)/g(z) for every g with g(G) e_0 = 0; here
    g = f c. The N_L are positive, so by Pringsheim's theorem lim sup N_L^(1/L) is a zero of g, and it is not smaller
    than any pole. All zeros of f are poles, as f and P have none in common; f increases from x on, and c is positive
    there. So the zero of f in [x, y] is a pole and the largest positive zero of g.
    """
    f, x, y = c.statement["polynomial"], c.statement["low"], c.statement["high"]
    cofactor, p = c.witness["cofactor"], c.p
    mask = c.use("stable", holds=True).statement["mask"]
    q = c.use("sum-rules", mask=mask).result
    if q is None:
        raise Rejected("there is no quotient")
    require(c.masks[mask].length > q.length, "the sum rules are of order 0")
    c.use_reductions(mask)
    order = (q.length - 1) // (p - 1) + 1
    require(f.start == 0 and f.length > 1, "the polynomial is constant or vanishes at 0")
    require(cofactor.start >= 0 and cofactor.length > 0, "the cofactor is no polynomial, or zero")
    degree = f.length - 1 + cofactor.start + cofactor.length - 1
    require(degree <= order, "the polynomials are of higher degree than the matrix")
    step = 2 * q.bits + p.bit_length() + 2 * order.bit_length()
    longest = (order + 1) * (step + _bits(x) + _bits(y)) + f.bits + cofactor.bits
    c.count(q.length**2 + 4 * order**3 + 20, isqrt((512 + step) * (512 + longest)) - 512)  # long times short numbers
    c.count(4 * order**2, longest)
    require(0 < x <= y, "the interval is not one of positive numbers")
    _check_zeros(f.numerators, [0] * cofactor.start + list(cofactor.numerators), x, y)
    _check_growth(q, f, cofactor, p, order)


def _check_zeros(f: Sequence[int], cofactor: Sequence[int], x: Fraction, y: Fraction) -> None:
    """f increases from x on, f(x) <= 0 <= f(y), and the cofactor is positive from x on, by Taylor coefficients at x."""
    at_f, at_c = _taylor(f, x), _taylor(cofactor, x)
    require(f[-1] > 0 and min(at_f[1:]) >= 0, "the polynomial is not seen to increase from the lower end on")
    require(at_f[0] <= 0 <= _taylor(f, y)[0], "the polynomial has no change of sign in the interval")
    require(at_c[0] > 0 and min(at_c) >= 0, "the cofactor is not seen to be positive from the lower end on")


def _check_growth(q: Polynomial, f: Polynomial, cofactor: Polynomial, p: int, order: int) -> None:
    """(f c)(G) e_0 = 0, and f has no zero in common with P: in integers, z replaced by z/D, D the denominator of G."""
    matrix, denominator = _transfer(q, p, order), p * q.denominator**2
    g = [0] * cofactor.start + list(multiply(f, cofactor).numerators)
    degree = len(g) - 1
    g = [x * denominator ** (degree - i) for i, x in enumerate(g)]
    vectors = [[1] + [0] * (order - 1)]
    for _ in range(degree):
        vectors.append([sum(map(mul, row, vectors[-1])) for row in matrix])
    annihilates = not any(sum(map(mul, g, entries)) for entries in zip(*vectors, strict=True))
    require(annihilates, "the polynomials do not annihilate e_0")
    first = [vector[0] for vector in vectors]
    numerator = [sum(g[i] * first[i - 1 - j] for i in range(j + 1, degree + 1)) for j in range(degree)]
    scaled = [x * denominator ** (f.length - 1 - i) for i, x in enumerate(f.numerators)]
    coprime = any(_coprime_modulo(scaled, numerator, prime) for prime in _PRIMES)
    require(coprime, "the polynomial is not seen to have poles for all its zeros")


def _transfer(q: Polynomial, p: int, order: int) -> Matrix:
    """The numerators of G: b_(pi-j) + b_(pi+j) for j > 0, and b_(pi), over p times the denominator of b.

    That of f -> (1/p) Σ_j b_(pi-j) f_j on symmetric sequences over -(order-1), …, order-1, which it maps to such.
    """
    numerators = q.numerators
    b = [sum(map(mul, numerators, numerators[t:])) for t in range(len(numerators))]

    def at(t: int) -> int:
        return b[abs(t)] if abs(t) < len(b) else 0

    return [[at(p * i - j) + (at(p * i + j) if j else 0) for j in range(order)] for i in range(order)]


def _taylor(f: Sequence[int], x: Fraction) -> list[int]:
    """The coefficients of f(x + h), each times a positive number."""
    u, v, n = x.numerator, x.denominator, len(f) - 1
    g = [c * v ** (n - i) for i, c in enumerate(f)]
    for k in range(n):
        for i in range(n - 1, k - 1, -1):
            g[i] += u * g[i + 1]
    return g


def _coprime_modulo(f: Sequence[int], g: Sequence[int], prime: int) -> bool:
    """Whether f and g have no common factor modulo a prime that does not divide the leading coefficient of f: then

    they have none over Q, as it would be one modulo the prime, of the same degree.
    """
    a, b = [c % prime for c in f], [c % prime for c in g]
    if not a[-1]:
        return False
    while True:
        while b and not b[-1]:
            b.pop()
        if not b:
            return len(a) == 1
        inverse = pow(b[-1], -1, prime)
        while len(a) >= len(b):
            top, shift = a[-1] * inverse % prime, len(a) - len(b)
            for i, c in enumerate(b, shift):
                a[i] = (a[i] - top * c) % prime
            while a and not a[-1]:
                a.pop()
        a, b = b, a


def _bits(x: Fraction) -> int:
    return x.numerator.bit_length() + x.denominator.bit_length()
