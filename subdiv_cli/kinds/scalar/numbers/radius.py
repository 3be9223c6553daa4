"""Schemes whose symbol is not negative on the circle: their joint spectral radius is that of one matrix.

Let d(z) = d(1/z) have real values >= 0 on |z| = 1 (a shift of the index aside). Then so has d^[L](z) = Π_(j<L)
d(z^(p^j)), hence its coefficient at 0 is the largest in modulus, and ‖S^L‖∞, the largest absolute class sum mod p^L,
is at most a constant times it. With C = [d_(i-pj)], |i|, |j| <= R = ⌊h/(p-1)⌋, 2h the degree, that coefficient is
(C^L)_00, and the rows of C^L are parts of rows of S^L: the joint spectral radius is ρ(C). C maps symmetric sequences
to such, by G = [d_(i-pj) + d_(i+pj)], 0 <= i, j <= R (d_i for j = 0), and (C^L)_00 = (G^L)_00: it is ρ(G). As the
power series Σ_L (G^L)_00 x^L has coefficients >= 0, its radius of convergence 1/ρ(G) is a pole: ρ(G) is an eigenvalue,
the largest real one. Products are bounded by a constant times ρ(G)^L where all eigenvalues of G of that modulus are
simple. Deslauriers-Dubuc schemes, pseudo-splines and B-splines are of this kind.

The joint spectral radius of a difference scheme, by the cheapest way that gives the number itself.

A symbol that is not negative on the circle; a norm that a short product attains; an invariant polytope. Where none of
them closes within the effort, the best bound of polytopes or norms.

Bounds of the Hölder exponent that products of transition matrices give.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import islice

from flint import fmpq, fmpq_mat, fmpq_poly, fmpz_poly

from subdiv_cli.exact.algebraic import AlgebraicNumber, isolated, isolated_roots, roots
from subdiv_cli.exact.closed import closed_interval
from subdiv_cli.exact.enclosures import decide
from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.exact.rationals import to_fraction
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.products import WordProduct, best_product, radius_bound
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.scalar.numbers.norms import power_norms
from subdiv_cli.kinds.scalar.numbers.operators import transition_matrices
from subdiv_cli.model import Effort, Interval, Root, logarithm
from subdiv_cli.model.proofs import RadiusProof, root_data

_LARGEST_ORDER = 40
"""The largest order of G."""


def positive_radius(d: Laurent, p: int) -> Radius | None:
    """The joint spectral radius of the scheme with symbol d, and a proof by rule `positive-symbol`.

    None unless d is its own reverse, of even degree and >= 0 on the circle after the shift.
    """
    c = list(d.poly)
    h, odd = divmod(len(c) - 1, 2)
    reach = h // (p - 1)
    if odd or c != c[::-1] or reach + 1 > _LARGEST_ORDER:
        return None
    square = _as_square(in_two_cosine(c[h:]))
    if square is None:
        return None
    f = _symmetric_matrix(c[h:], p, reach).charpoly()
    spectrum = roots(f)
    largest = _largest_real(spectrum)
    letter = h % (p - 1)
    matrix = transition_matrices(d, p)[letter]
    if largest is None or divmod(matrix.charpoly(), fmpq_poly(largest.minimal_polynomial))[1] != fmpq_poly():
        return None
    root = isolated(largest)
    bounded = _is_bounded(spectrum, largest)
    power, squares, rest = square
    proof: RadiusProof = {
        "rule": "positive-symbol",
        "length": 1,
        "root": root_data(root),
        "bounded": bounded,
        "power": power,
        "squares": squares,
        "rest": rest,
    }
    return Radius((letter,), (1, root), (1, root.high), bounded, proof)


def in_two_cosine(c: Sequence[fmpq]) -> fmpq_poly:
    """The polynomial H with c_0 + Σ_j c_j (z^j + z^-j) = H(z + 1/z): t_0 = 2, t_1 = y, t_j = y t_(j-1) - t_(j-2)."""
    y = fmpq_poly([0, 1])
    before, now, total = fmpq_poly([2]), y, fmpq_poly([c[0]])
    for coefficient in c[1:]:
        total += now * coefficient
        before, now = now, y * now - before
    return total


def _as_square(h: fmpq_poly) -> tuple[int, tuple[Fraction, ...], tuple[Fraction, ...]] | None:
    """The power, squares and rest > 0 with H(y) = (y+2)^power squares(y)² rest(y) on [-2, 2]; None where H < 0."""
    lead, factors = h.numer().factor()
    power, squares, rest = 0, fmpq_poly([1]), fmpq_poly([fmpq(lead, h.denom())])
    for g, multiplicity in factors:
        if g == fmpz_poly([2, 1]):
            power += multiplicity
            continue
        squares *= fmpq_poly(g) ** (multiplicity // 2)
        if multiplicity % 2:
            if _vanishes_between(g):
                return None
            rest *= fmpq_poly(g)
    if rest(fmpq(2)) <= 0:
        return None
    return power, tuple(map(to_fraction, squares)), tuple(map(to_fraction, rest))


def _vanishes_between(g: fmpz_poly) -> bool:
    """Whether an irreducible g, other than y + 2, has a real root in [-2, 2]."""
    if g.degree() == 1:
        return abs(to_fraction(fmpq(-g[0], g[1]))) <= 2

    def ask() -> bool | None:
        real = [z.real for z in isolated_roots(g) if z.imag.is_zero()]
        if any(x > -2 and x < 2 for x in real):
            return True
        return False if all(x < -2 or x > 2 for x in real) else None

    return decide(ask)


def _symmetric_matrix(d: Sequence[fmpq], p: int, reach: int) -> fmpq_mat:
    """The matrix G, (reach+1)×(reach+1), from d_0, …, d_h."""

    def at(k: int) -> fmpq:
        return d[abs(k)] if abs(k) < len(d) else fmpq(0)

    window = range(reach + 1)
    entries = [at(i - p * j) + at(i + p * j) if j else at(i) for i in window for j in window]
    return fmpq_mat(len(window), len(window), entries)


def _largest_real(spectrum: Sequence[tuple[AlgebraicNumber, int]]) -> AlgebraicNumber | None:
    """The largest positive eigenvalue, if balls separate it from the other real ones."""
    real = [number for number, _ in spectrum if number.is_real and number.region.real > 0]
    top = max(real, key=lambda x: float(x.region.real.mid()), default=None)
    return top if all(x is top or (top is not None and x.region.real < top.region.real) for x in real) else None


def _is_bounded(spectrum: Sequence[tuple[AlgebraicNumber, int]], largest: AlgebraicNumber) -> bool:
    """Whether every multiple eigenvalue is certainly smaller in modulus."""
    radius = largest.region.real
    return all(multiplicity == 1 or number.region.__abs__() < radius for number, multiplicity in spectrum)


_FIRST_LEVELS = 4
_FIRST_WORK = 2000
"""The work for short products and norms, before a polytope is tried."""
_LARGE = 1 << 13
"""The bits of a coefficient from which on polytopes are not tried."""


def difference_radius(d: Laurent, p: int, effort: Effort) -> Radius | None:
    """The joint spectral radius of the scheme with symbol d; None where the effort does not suffice for any bound."""
    if (radius := positive_radius(d, p)) is not None:
        return radius
    matrices = transition_matrices(d, p)
    first = effort.limited(_FIRST_WORK)
    if (radius := _by_norms(d, p, best_product(matrices, first), first, _FIRST_LEVELS)) is not None and radius.exact:
        return radius
    numerators, denominator = d.integer_form()
    if max(numerators.height_bits(), denominator.bit_length()) < _LARGE:
        from subdiv_cli.jsr.radius import joint_spectral_radius  # numpy comes with it

        radius = joint_spectral_radius(Family(matrices), effort)
        if radius is not None and radius.exact:
            return radius
    return _better(radius, _by_norms(d, p, _product(matrices, radius, effort), effort, None))


def _product(matrices: Sequence[fmpq_mat], radius: Radius | None, effort: Effort) -> WordProduct | None:
    if radius is not None and radius.word is not None:
        return WordProduct.of_word(matrices, radius.word)
    return best_product(matrices, effort)


def _by_norms(d: Laurent, p: int, product: WordProduct | None, effort: Effort, levels: int | None) -> Radius | None:
    """The best bound ‖S^L‖∞^(1/L), exact where the product attains it."""
    best: tuple[int, Fraction] | None = None
    for level, norm in enumerate(islice(power_norms(d, p, effort), levels), 1):
        if product is not None and product.closes(norm, level):
            return _norm_radius(product, level, norm, exact=True)
        if best is None or float(norm) ** (1 / level) < float(best[1]) ** (1 / best[0]):
            best = level, norm
    return None if best is None else _norm_radius(product, *best, exact=False)


def _norm_radius(product: WordProduct | None, level: int, norm: Fraction, *, exact: bool) -> Radius:
    proof: RadiusProof = {"rule": "norm", "length": level, "bound": norm}
    root = Root((-norm.numerator, norm.denominator), norm, norm)
    if exact:
        proof["root"] = root_data(root)
    word = None if product is None else product.word
    return Radius(word, (level, root) if exact else None, (level, norm), exact, proof)


def _better(a: Radius | None, b: Radius | None) -> Radius | None:
    """The radius with the smaller bound; it keeps the word of the first."""
    if a is None or b is None:
        return a or b
    return a if a.ceiling <= b.ceiling else b._replace(word=a.word or b.word)


def exponent_bound(product: WordProduct, p: int) -> Interval:
    """The upper bound -log_p(r) / ℓ of the Hölder exponent of a stable φ, with r of `radius_bound`.

    `exact` where λ is rational: r is |λ| then, and a little below it otherwise.
    """
    bound = closed_interval(logarithm(p, 1 / radius_bound(product), len(product.word)))
    return bound if product.eigenvalue.rational is not None else bound._replace(exact=None)
