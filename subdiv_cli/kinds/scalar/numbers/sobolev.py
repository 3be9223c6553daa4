"""The mean-square growth of a difference scheme: what the Sobolev exponent is made of.

With D(z) the symbol of D = S_(Δ^k), N_L = p^-L Σ_i |D^[L]_i|² for the iterate D^[L](z) = Π_(j<L) D(z^(p^j)). These are
the entries (G^L e_0)_0 for the transfer matrix G of the autocorrelation b(z) = D(z) D(1/z): on sequences f over
{-K, …, K}, K = ⌊n/(p-1)⌋ and n the degree of D, (G f)_i = (1/p) Σ_j b_(pi-j) f_j, and on the symmetric ones among them,
which e_0 is,

    G[i][j] = (b_(pi-j) + b_(pi+j))/p for j > 0,  G[i][0] = b_(pi)/p,  0 <= i, j <= K.

G maps non-negative trigonometric polynomials to such, and e_0, the constant 1, is an inner point of their cone. So the
spectral radius λ of G is an eigenvalue, and N_L grows like λ^L: no other eigenvalue matters, and none that is only
reached from other vectors. A face of the cone is given by zeros on |z| = 1; G maps one to itself only if each of these
has all its p-th roots among them or among the zeros of D. For a stable mask divided by all its smoothing factors there
are no such sets, so G is irreducible and λ is a simple eigenvalue.
"""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from flint import arb, fmpq, fmpq_mat, fmpq_poly, fmpz_poly

from subdiv_cli.exact.algebraic import AlgebraicNumber, isolated_roots
from subdiv_cli.exact.enclosures import ball, bounds, decide
from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.exact.rationals import to_fmpq

_DIGITS = 20
"""The digits of the first rational enclosure of λ."""


class Growth(NamedTuple):
    """The spectral radius λ = ρ(G), with its proof: f c annihilates e_0 under G, f(λ) = 0, c > 0 from `low` on."""

    radius: AlgebraicNumber
    """The number λ; its minimal polynomial is f."""
    cofactor: fmpq_poly
    """The monic polynomial c."""
    low: Fraction
    high: Fraction
    """The upper bound of low <= λ <= high.

    All Taylor coefficients of f at `low` beyond the first and all of c are non-negative.
    """

    def ball(self) -> arb:
        """A ball around λ, as wide as the bounds."""
        return ball(self.low).union(ball(self.high))

    def cofactor_coefficients(self) -> tuple[Fraction, ...]:
        """The coefficients of c, lowest power first."""
        c = Laurent(0, self.cofactor)
        return (Fraction(0),) * c.low + c.coefficients()


def transfer_order(degree: int, p: int) -> int:
    """The order K+1 of G for D of this degree."""
    return degree // (p - 1) + 1


def transfer_matrix(d: Laurent, p: int) -> fmpq_mat:
    """The (K+1)×(K+1) transfer matrix G for the symbol d of D."""
    n, b = d.degree, list((d * d.reversed()).poly)  # b_t at place t + n
    order = transfer_order(n, p)

    def at(t: int) -> fmpq:
        return b[t + n] if -n <= t <= n else fmpq(0)

    entries = [at(p * i - j) + (at(p * i + j) if j else fmpq(0)) for i in range(order) for j in range(order)]
    return fmpq_mat(order, order, entries) / p


def mean_square_growth(d: Laurent, p: int) -> Growth:
    """The exact growth λ for the symbol d ≠ 0 of D = S_(Δ^k), k the sum-rule order of a stable mask.

    Raises ArithmeticError where λ is no simple eigenvalue: the mask is not stable then.
    """
    growth = simple_growth(transfer_matrix(d, p).charpoly())
    if growth is None:
        raise ArithmeticError("the mean-square growth of a stable mask is a simple eigenvalue")
    return growth


def simple_growth(annihilator: fmpq_poly) -> Growth | None:
    """The largest real zero of a polynomial, all of whose zeros lie in the disc up to it; None where it is multiple."""
    factors = annihilator.numer().factor()[1]
    top, root = _largest_real_root([f for f, _ in factors])
    f, multiplicity = factors[top]
    if multiplicity > 1:
        return None
    cofactor = annihilator / fmpq_poly(f) * f.leading_coefficient()
    return Growth(root, cofactor, *_enclosure(root, f, cofactor))


def _largest_real_root(factors: list[fmpz_poly]) -> tuple[int, AlgebraicNumber]:
    """The largest real zero of irreducible polynomials, none a multiple of another, and which of them has it."""
    if len(factors) == 1 and factors[0].degree() == 1:
        return 0, AlgebraicNumber(factors[0], isolated_roots(factors[0])[0])

    def ask() -> tuple[int, AlgebraicNumber] | None:
        tops = []
        for i, f in enumerate(factors):
            real = [z for z in isolated_roots(f) if z.imag.is_zero()]
            if real:
                tops.append((i, max(real, key=lambda z: float(z.real.mid()))))
        best = max(tops, key=lambda pair: float(pair[1].real.mid()))
        others: list[arb] = [z.real for i, z in tops if i != best[0]]
        if all(x < best[1].real for x in others):
            return best[0], AlgebraicNumber(factors[best[0]], best[1])
        return None

    return decide(ask)


def _enclosure(root: AlgebraicNumber, f: fmpz_poly, cofactor: fmpq_poly) -> tuple[Fraction, Fraction]:
    """The bounds (low, high) of λ as `Growth` has them.

    All zeros lie in the disc |z| <= λ, those of derivatives in their hull (Gauss and Lucas), and λ is a simple zero
    of f and none of c: so every `low` close enough to λ will do.
    """
    if (exact := root.rational) is not None:
        return exact, exact

    digits = _DIGITS

    def ask() -> tuple[Fraction, Fraction] | None:
        nonlocal digits
        left, right = bounds(root.enclosure().real)
        if left <= 0:
            return None
        unit = Fraction(10) ** -(digits + (left.denominator.bit_length() - left.numerator.bit_length()) * 3 // 10)
        digits *= 2
        low, high = left // unit * unit, -(-right // unit) * unit
        at_f, at_c = taylor(fmpq_poly(f), low), taylor(cofactor, low)
        fits = min(at_f[1:]) >= 0 and at_f[0] <= 0 and min(at_c) >= 0 and at_c[0] > 0
        return (low, high) if fits else None

    return decide(ask)


def taylor(f: fmpq_poly, x: Fraction) -> list[fmpq]:
    """The coefficients of f(x + h), lowest power of h first."""
    return list(f(fmpq_poly([to_fmpq(x), 1])))
