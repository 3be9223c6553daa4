"""The rule on the Sobolev exponent s of φ, and exact growth rates of the powers of a matrix, for masks on Z^s too.

q is the quotient of the sum-rules claim, n its degree, b(z) = q(z) q(1/z), and N_L = p^-L Σ_i |q^[L]_i|² with
q^[L](z) = Π_(j<L) q(z^(p^j)). For stable φ, s = -log_p(λ)/2 with λ = lim sup N_L^(1/L).

In general N_L >= 0 is the first entry of G^L v. Σ N_L z^(-L-1) = P(z)/g(z) for every polynomial g with g(G) v = 0;
here g = f c with f of the statement and c, the cofactor, of the witness. By Pringsheim's theorem lim sup N_L^(1/L) is a
zero of g, and it is not smaller than any pole. All zeros of f are poles, as f and P have none in common; f increases
from x on, and c is positive there. So the zero of f in [x, y] is a pole and the largest positive zero of g.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import isqrt
from operator import mul

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import Matrix
from subdiv_cli.checker.polynomials import Polynomial, multiply
from subdiv_cli.checker.reading import Rejected, require
from subdiv_cli.checker.roots import fraction_bits
from subdiv_cli.checker.scalar.masks import symbols_of, use_reductions


def sobolev(c: Claim) -> None:
    """s = -log_p(λ)/2, λ the only zero of f in [x, y].

    N_L = (G^L e_0)_0 with G as in `_transfer`. Raises Rejected where the sum rules have no quotient.
    """
    p = c.p
    mask = c.use("stable", holds=True).statement["mask"]
    q = c.use("sum-rules", mask=mask).result
    if q is None:
        raise Rejected("there is no quotient")
    require(symbols_of(c)[mask].length > q.length, "the sum rules are of order 0")
    use_reductions(c, mask)
    order = (q.length - 1) // (p - 1) + 1
    degree = degree_of_annihilator(c)
    require(degree <= order, "the polynomials are of higher degree than the matrix")
    step = 2 * q.bits + p.bit_length() + 2 * order.bit_length()
    count_growth(c, q.length**2 + 4 * order**3 + 20, order, step)
    matrix, first = _transfer(q, p, order), [1] + [0] * (order - 1)
    require_growth(c, lambda v: [sum(map(mul, row, v)) for row in matrix], first, p * q.denominator**2)


def _transfer(q: Polynomial, p: int, order: int) -> Matrix:
    """The order×order numerators of G: b_(pi-j) + b_(pi+j) for j > 0, and b_(pi), over p times the denominator of b.

    G is the matrix of f -> (1/p) Σ_j b_(pi-j) f_j on symmetric sequences over -(order-1), …, order-1, which it maps to
    such.
    """
    numerators = q.numerators
    b = [sum(map(mul, numerators, numerators[t:])) for t in range(len(numerators))]

    def at(t: int) -> int:
        return b[abs(t)] if abs(t) < len(b) else 0

    return [[at(p * i - j) + (at(p * i + j) if j else 0) for j in range(order)] for i in range(order)]


_PRIMES = ((1 << 61) - 1, (1 << 89) - 1)


def degree_of_annihilator(c: Claim) -> int:
    """The degree of g."""
    f, cofactor = c.statement["polynomial"], c.witness["cofactor"]
    require(f.start == 0 and f.length > 1, "the polynomial is constant or vanishes at 0")
    require(cofactor.start >= 0 and cofactor.length > 0, "the cofactor is no polynomial, or zero")
    return int(f.length - 1 + cofactor.start + cofactor.length - 1)


def count_growth(c: Claim, operations: int, degree: int, step: int) -> None:
    """Count operations on entries that grow by `step` bits at each of `degree` steps, and on the polynomials."""
    f, cofactor, x, y = c.statement["polynomial"], c.witness["cofactor"], c.statement["low"], c.statement["high"]
    longest = (degree + 1) * (step + fraction_bits(x) + fraction_bits(y)) + f.bits + cofactor.bits
    c.count(operations, isqrt((512 + step) * (512 + longest)) - 512)  # long times short numbers
    c.spend(4 * degree**2, longest)


def require_growth(c: Claim, image: Callable[[list[int]], list[int]], v: list[int], denominator: int) -> None:
    """Check that lim sup N_L^(1/L) is the only zero of f in [x, y]; `image` gives the numerators of G v."""
    f, cofactor, x, y = c.statement["polynomial"], c.witness["cofactor"], c.statement["low"], c.statement["high"]
    require(0 < x <= y, "the interval is not one of positive numbers")
    _check_zeros(f.numerators, [0] * cofactor.start + list(cofactor.numerators), x, y)
    g = [0] * cofactor.start + list(multiply(f, cofactor).numerators)
    degree = len(g) - 1
    g = [value * denominator ** (degree - i) for i, value in enumerate(g)]  # z replaced by z/denominator
    vectors = [v]
    for _ in range(degree):
        vectors.append(image(vectors[-1]))
    annihilates = not any(sum(map(mul, g, entries)) for entries in zip(*vectors, strict=True))
    require(annihilates, "the polynomials do not annihilate the vector")
    first = [vector[0] for vector in vectors]
    numerator = [sum(g[i] * first[i - 1 - j] for i in range(j + 1, degree + 1)) for j in range(degree)]
    scaled = [value * denominator ** (f.length - 1 - i) for i, value in enumerate(f.numerators)]
    coprime = any(_coprime_modulo(scaled, numerator, prime) for prime in _PRIMES)
    require(coprime, "the polynomial is not seen to have poles for all its zeros")


def _check_zeros(f: Sequence[int], cofactor: Sequence[int], x: Fraction, y: Fraction) -> None:
    """Check that f increases from x on, f(x) <= 0 <= f(y), and the cofactor is positive from x on.

    By Taylor coefficients at x.
    """
    at_f, at_c = _taylor(f, x), _taylor(cofactor, x)
    require(f[-1] > 0 and min(at_f[1:]) >= 0, "the polynomial is not seen to increase from the lower end on")
    require(at_f[0] <= 0 <= _taylor(f, y)[0], "the polynomial has no change of sign in the interval")
    require(at_c[0] > 0 and min(at_c) >= 0, "the cofactor is not seen to be positive from the lower end on")


def _taylor(f: Sequence[int], x: Fraction) -> list[int]:
    """The coefficients of f(x + h), each times a positive number."""
    u, v, n = x.numerator, x.denominator, len(f) - 1
    g = [c * v ** (n - i) for i, c in enumerate(f)]
    for k in range(n):
        for i in range(n - 1, k - 1, -1):
            g[i] += u * g[i + 1]
    return g


def _coprime_modulo(f: Sequence[int], g: Sequence[int], prime: int) -> bool:
    """Whether f and g have no common factor modulo a prime that does not divide the leading coefficient of f.

    Then they have none over Q, as it would be one modulo the prime, of the same degree.
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
