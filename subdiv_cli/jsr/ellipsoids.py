"""Ellipsoidal norms ‖y‖² = y'Py in which matrices, or the products of some words, are small; and what they prove.

P is sought in floats: first one in which all products together grow alike in all directions, then by small steps that
make the largest norm smaller. With a number x a little above the radius ρ, words are followed until their products have
norms <= x^ℓ: these words are the ends of a tree, every long word is a sequence of them, and ρ <= x. The nearer x is to
ρ, the larger the tree. That is the rule `ellipsoid` of certificate/RADIUS.md. Where some P has M'PM <= ρ²P for all
matrices, ρ is known exactly.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from math import lcm

import numpy as np
from flint import arb, arb_mat, ctx, fmpq, fmpq_mat

from subdiv_cli.exact.linalg import nullspace
from subdiv_cli.exact.rationals import to_fmpq
from subdiv_cli.jsr.arrays import Array
from subdiv_cli.jsr.family import Candidate, Family, Word
from subdiv_cli.jsr.products import WordProduct
from subdiv_cli.jsr.result import Radius, meeting
from subdiv_cli.model import Effort, exact_root
from subdiv_cli.model.proofs import LowerBound, RadiusProof

_SWEEPS, _REGULAR = 60, 1e-9
_STEPS = 200
_NEARLY = 0.97
"""Singular values beyond this share of the largest one are made smaller together."""
_SHRINKS = 40
_DEEPEST = 60
"""The letters of the longest word of a tree."""
_MOST_WORDS = 1000
_MOST_ENTRIES = 4000
"""The most entries of all products of a length whose norms are made small together."""
_WORK_A_WORD = 12
"""The entries of a matrix that a word may have, for each unit of work."""
_SHORT_BITS = 30
"""The most bits of the bound."""
_MOST_SPENT = 500_000_000
"""What a checker may spend, in operations on numbers of 512 bits."""
_ENTRY_BITS = 39
_ROOM = 1e-7
_PLACES = 192
_SMALL_ORDER = 12
"""The order up to which forms are sought by linear equations."""
_DENOMINATOR = 10_000
_HUGE = 1e12
"""Matrices so much larger than their radius are none that floats know."""


def coordinates(scaled: Array) -> Array:
    """An N×N matrix C, in floats, such that C M C^-1 have small 2-norms for p matrices M, of radius about 1.

    P = C'C is nearly a fixed point of P -> Σ M'PM up to a factor.
    """
    n = scaled.shape[1]
    form = np.eye(n)
    with np.errstate(all="ignore"):
        for _ in range(_SWEEPS):
            image = (scaled.transpose(0, 2, 1) @ form @ scaled).sum(axis=0) + _REGULAR * np.eye(n)
            form = (form + image * (n / np.trace(image))) / 2
    try:
        return np.asarray(np.linalg.cholesky(form).T) if np.isfinite(form).all() else np.eye(n)
    except np.linalg.LinAlgError:
        return np.eye(n)


def _improved(scaled: Array, start: Array, effort: Effort) -> Array:
    """Coordinates C in which the largest 2-norm of the p matrices is smaller than in those of the start.

    Each step makes vectors longer that a matrix of about the largest norm stretches most, and their images shorter.
    """
    turned, best = start, (np.inf, start)
    for step in range(_STEPS):
        if not effort.allows(0):
            break
        images = turned @ scaled @ np.linalg.inv(turned)
        left, sizes, right = np.linalg.svd(images)
        largest = float(sizes.max())
        if not np.isfinite(largest):
            break
        if largest < best[0]:
            best = largest, turned
        change = np.zeros(turned.shape)
        for u, s, v in zip(left, sizes, right, strict=True):
            if near := int((s > _NEARLY * largest).sum()):
                change += (v[:near].T @ v[:near] - u[:, :near] @ u[:, :near].T) / near
        values, vectors = np.linalg.eigh(change * (0.15 / (1 + step / 20)))
        turned = (vectors * np.exp(values / 2)) @ vectors.T @ turned
        turned = turned / np.linalg.norm(turned)
    return best[1]


def _fitted(scaled: Array, effort: Effort) -> tuple[Array, float]:
    """Coordinates in which products of some length have small norms, and by how much their roots are larger than 1.

    Of one letter first, then of more, as long as these are not too many numbers.
    """
    turned, products, excess = coordinates(scaled), scaled, np.inf
    n, length = scaled.shape[1], 1
    while True:
        turned = _improved(products, turned, effort)
        norms = np.linalg.norm(turned @ products @ np.linalg.inv(turned), ord=2, axis=(1, 2))
        excess = min(excess, float(norms.max()) ** (1 / length) * (1 + 4 * _ROOM) - 1)
        if max(len(scaled), 2) ** (length + 1) * n**2 > _MOST_ENTRIES or not effort.allows(0):
            return turned, max(excess, _ROOM)
        products, length = (scaled[:, None] @ products[None]).reshape(-1, n, n), length + 1


def ellipsoid_bound(family: Family, rate: float, effort: Effort) -> Radius | None:
    """The bound of the radius by the best ellipsoid and tree of words; None where there is none.

    `rate` is a lower bound of the radius of the matrices divided by `family.unit`. Numbers x come nearer to it until
    trees have more words than the effort allows.
    """
    with np.errstate(all="ignore"):
        scaled = family.floats / rate
        if not np.abs(scaled).max() < _HUGE:
            return None
        turned, excess = _fitted(scaled, effort)
        images = turned @ scaled @ np.linalg.inv(turned)
    if not np.isfinite(images).all():
        return None
    most = max(family.letters, min(_MOST_WORDS, _WORK_A_WORD * effort.work // family.order**2))
    best: tuple[float, list[Word]] | None = None
    step = 0.5
    for _ in range(_SHRINKS):
        near = excess * (1 - step) if best else excess
        words = _tree(images / (1 + near), most, effort)
        if words is not None and _is_affordable(family, words):
            best, excess = (1 + near, words), near
        elif best is None or step < 0.1:
            break
        else:
            step /= 2
    if best is None:
        return None
    x = _short((Fraction(best[0]) * Fraction(rate) * family.unit) ** 2, excess)
    form = _integers(turned.T @ turned)
    if not _is_proved(family, form, best[1], x, effort):
        return None
    return Radius(None, None, (2, x), False, _proof(form, best[1], x))


def _tree(images: Array, most: int, effort: Effort) -> list[Word] | None:
    """The words, in alphabetical order, after which products are first smaller than 1; None for more than `most`."""
    words: list[Word] = []
    open_words: list[Word] = [()]
    products = np.eye(images.shape[1])[None]
    for _ in range(_DEEPEST):
        if not effort.allows(0):
            return None
        products = (images[None, :] @ products[:, None]).reshape(-1, *images.shape[1:])
        longer = [(*word, letter) for word in open_words for letter in range(len(images))]
        small = np.linalg.norm(products, ord=2, axis=(1, 2)) <= 1 - _ROOM
        words += [word for word, ends in zip(longer, small, strict=True) if ends]
        open_words = [word for word, ends in zip(longer, small, strict=True) if not ends]
        products = products[~small]
        if len(words) + len(open_words) > most:
            return None
        if not open_words:
            return sorted(words)
    return None


def _is_affordable(family: Family, words: list[Word]) -> bool:
    """Whether a checker need not spend too much on the products of these words, as it counts."""
    n, longest = family.order, max(map(len, words))
    bits = longest * (2 * family.bits + 2 * n.bit_length() + _SHORT_BITS)
    return (5 * len(words) + 1) * n**3 * (1 + bits // 512) ** 2 <= _MOST_SPENT


def _short(x: Fraction, excess: float) -> Fraction:
    """A number a little above x > 0, by less than the excess, with few significant bits."""
    bits = min(_SHORT_BITS, max(10, 6 - math.floor(math.log2(excess))))
    unit = Fraction(2) ** (x.numerator.bit_length() - x.denominator.bit_length() - bits)
    return -(-x // unit) * unit


def _integers(form: Array) -> list[list[int]]:
    """The form with its largest entry near 2^39, rounded."""
    unit = 2.0**_ENTRY_BITS / float(np.abs(form).max())
    return [[round(x * unit) for x in row] for row in ((form + form.T) / 2).tolist()]


def _proof(form: list[list[int]], words: list[Word], x: Fraction) -> RadiusProof:
    lower = tuple(entry for i, row in enumerate(form) for entry in row[: i + 1])
    return {"rule": "ellipsoid", "length": 2, "bound": x, "form": lower, "words": tuple(words)}


def _is_proved(family: Family, form: list[list[int]], words: list[Word], x: Fraction, effort: Effort) -> bool:
    """Whether the form is positive definite, and x^|w| P - Π'PΠ is for the products of all words."""
    with ctx.workprec(_PLACES):
        p = fmpq_mat(form)
        if not _is_definite(arb_mat(p)):
            return False
        for word in words:
            if not effort.allows(0):
                return False
            product = family.product(word)
            if not _is_definite(arb_mat(p * to_fmpq(x ** len(word)) - product.transpose() * p * product)):
                return False
    return True


def _is_definite(form: arb_mat) -> bool:
    """Whether an N×N form is positive definite: R'QR has a dominant diagonal, R about the inverse of a root of Q."""
    n = form.nrows()
    middle = np.array([[float(x.mid()) for x in row] for row in form.table()])
    scale = float(np.abs(middle).max())
    if not scale or not np.isfinite(scale):
        return False
    try:
        inverse = np.linalg.inv(np.linalg.cholesky(middle / scale)).T
    except np.linalg.LinAlgError:
        return False
    r = arb_mat([[arb(x) for x in row] for row in inverse.tolist()])
    table = (r.transpose() * form * r).table()
    return all(table[i][i] > sum((abs(table[i][j]) for j in range(n) if j != i), arb(0)) for i in range(n))


def common_ellipsoid(family: Family, rate: float, contenders: Sequence[Candidate], effort: Effort) -> Radius | None:
    """The radius ρ where ρ² is rational, attained by a candidate, and M'PM <= ρ²P for one rational form P.

    P is the unit form, or a solution of M'PM = ρ²P for all matrices that have only eigenvalues of modulus ρ; None where
    these do not do. `rate` is the radius of the candidates for the matrices divided by `family.unit`.
    """
    if family.order > _SMALL_ORDER or not 1 / _HUGE < rate < _HUGE:
        return None
    if (square := _square(family, rate)) is None:
        return None
    for form in _forms(family, rate, square):
        if not effort.allows(0):
            return None
        if form is not None and _is_extremal(family, form, square):
            below = next((b for b in (_attained(family, c, square) for c in contenders) if b is not None), None)
            if below is None:
                return None
            words: list[Word] = [(letter,) for letter in range(family.letters)]
            return meeting(_proof(form, words, square), below, 2, square)
    return None


def _square(family: Family, rate: float) -> Fraction | None:
    """The rational that ρ² seems to be: of small numerator and denominator, or so beside the largest entry."""
    for unit in (family.unit, family.size):
        share = (rate * float(family.unit / unit)) ** 2
        guess = Fraction(share).limit_denominator(_DENOMINATOR)
        if guess and abs(float(guess) / share - 1) < 1e-11:
            return guess * unit**2
    return None


def _forms(family: Family, rate: float, square: Fraction) -> list[list[list[int]] | None]:
    n = family.order
    sizes = np.abs(np.linalg.eigvals(family.floats))
    full = [letter for letter in range(family.letters) if sizes[letter].min() > rate * (1 - _ROOM)]
    unit = [[int(i == j) for j in range(n)] for i in range(n)]
    return [unit, _invariant_form(family, full, rate, square)] if full else [unit]


def _invariant_form(family: Family, letters: Sequence[int], rate: float, square: Fraction) -> list[list[int]] | None:
    """A form with M'PM = ρ²P for the matrices of these letters; None where there is none, or none of short numbers.

    Of several, one near the form of nearly the least norms.
    """
    n = family.order
    pairs = [(i, j) for i in range(n) for j in range(i + 1)]
    columns: list[list[fmpq]] = []
    for i, j in pairs:
        unit = fmpq_mat(n, n, [int((k, m) in ((i, j), (j, i))) for k in range(n) for m in range(n)])
        images = [family.matrices[letter] for letter in letters]
        columns.append([x for m in images for x in (m.transpose() * unit * m - unit * to_fmpq(square)).entries()])
    if not (solutions := nullspace(fmpq_mat(columns).transpose())):
        return None
    root = coordinates(family.floats / rate)
    near = np.array([(root.T @ root)[i, j] for i, j in pairs])
    basis = np.array([[float(x) for x in v] for v in solutions]).T
    shares = [Fraction(x).limit_denominator(_DENOMINATOR) for x in np.linalg.lstsq(basis, near, rcond=None)[0].tolist()]
    if len(solutions) == 1:
        shares = [Fraction(1 if shares[0] >= 0 else -1)]
    entries = [sum((c * x for c, x in zip(shares, v, strict=True)), Fraction(0)) for v in zip(*solutions, strict=True)]
    common = lcm(*(x.denominator for x in entries))
    lower = {pair: int(x * common) for pair, x in zip(pairs, entries, strict=True)}
    if max(map(abs, lower.values())).bit_length() > _ENTRY_BITS:
        return None
    return [[lower[max(i, j), min(i, j)] for j in range(n)] for i in range(n)]


def _is_extremal(family: Family, form: list[list[int]], square: Fraction) -> bool:
    """Whether P is positive definite and ρ²P - M'PM semidefinite for all matrices, exactly."""
    p = fmpq_mat(form)
    rests = (p * to_fmpq(square) - m.transpose() * p * m for m in family.matrices)
    return p.det() != 0 and _is_semidefinite(p) and all(map(_is_semidefinite, rests))


def _is_semidefinite(form: fmpq_mat) -> bool:
    """Whether no eigenvalue is negative: of a symmetric matrix, the coefficients of det(z - Q) then change signs."""
    n, f = form.nrows(), form.charpoly()
    return all(f[k] * (-1) ** (n - k) >= 0 for k in range(n + 1))


def _attained(family: Family, candidate: Candidate, square: Fraction) -> LowerBound | None:
    """The proof that ρ(Π)² >= (ρ²)^ℓ for the product of a candidate; None where it is smaller.

    Of a word, or of the word twice where ρ is irrational.
    """
    word = family.full_word(candidate)
    roots = [exact_root(x, 2) for x in square.as_integer_ratio()]
    rational = Fraction(roots[0], roots[1]) if roots[0] and roots[1] else None
    word, bound = (word * 2, square ** len(word)) if rational is None else (word, rational ** len(word))
    if WordProduct.of_word(family.matrices, word).eigenvalue.compare_modulus(bound) < 0:
        return None
    return {"word": word, "bound": bound}
