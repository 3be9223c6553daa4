"""Random piecewise schemes, and what floats that share no code with the program see of them."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from subdiv_cli.kinds.piecewise.scheme import PiecewiseScheme
from subdiv_cli.kinds.scalar.scheme import ScalarScheme

MASKS = {
    "hat": (-1, [Fraction(1, 2), Fraction(1), Fraction(1, 2)]),
    "chaikin": (-1, [Fraction(1, 4), Fraction(3, 4), Fraction(3, 4), Fraction(1, 4)]),
    "shifted chaikin": (0, [Fraction(1, 4), Fraction(3, 4), Fraction(3, 4), Fraction(1, 4)]),
    "cubic": (-2, [Fraction(1, 8), Fraction(1, 2), Fraction(3, 4), Fraction(1, 2), Fraction(1, 8)]),
    "shifted cubic": (-1, [Fraction(1, 8), Fraction(1, 2), Fraction(3, 4), Fraction(1, 2), Fraction(1, 8)]),
    "four-point": (
        -3,
        [Fraction(-1, 16), Fraction(0), Fraction(9, 16), Fraction(1), Fraction(9, 16), Fraction(0), Fraction(-1, 16)],
    ),
    "four-point 1/10": (
        -3,
        [Fraction(-1, 10), Fraction(0), Fraction(3, 5), Fraction(1), Fraction(3, 5), Fraction(0), Fraction(-1, 10)],
    ),
    "unstable": (0, [Fraction(1, 4), Fraction(1, 4), Fraction(1, 2), Fraction(1, 2), Fraction(1, 4), Fraction(1, 4)]),
    "corner cutting": (-1, [Fraction(1, 8), Fraction(5, 8), Fraction(7, 8), Fraction(3, 8)]),
}


def mask(name, arity=2):
    start, coefficients = MASKS[name]
    return ScalarScheme(arity=arity, start=start, coefficients=tuple(coefficients))


def random_scheme(rng, masks=tuple(MASKS), rows=4, size=4):
    """Two masks, spacings, and special rows: the mask's own, changed by weights that sum to 0, or other means."""
    left, right = mask(rng.choice(masks)), mask(rng.choice(masks))
    spacing = (Fraction(1), rng.choice([Fraction(1), Fraction(1), Fraction(2), Fraction(1, 2), Fraction(3, 2)]))
    plain = PiecewiseScheme(left, right, spacing)
    special = []
    for i in sorted(rng.sample(range(-3, 5), rng.randint(0, rows))):
        row = dict(plain.row(i))
        if rng.random() < 0.2:  # the mean of few old points, of one side only at times
            first = rng.randint(-2, 2)
            weights = [Fraction(rng.randint(0, 4), 1) for _ in range(rng.randint(1, 3))]
            total = sum(weights) or 1
            row = {first + k: w / total for k, w in enumerate(weights)} if sum(weights) else {first: Fraction(1)}
        else:
            first, x = rng.randint(-3, 3), Fraction(rng.randint(-size, size), rng.choice([8, 16, 32]))
            change = rng.choice([(1, -1), (1, -2, 1), (1, -3, 3, -1), (-1, 0, 1)])
            for k, c in enumerate(change):
                row[first + k] = row.get(first + k, Fraction(0)) + c * x
        special.append((i, tuple(row.items())))
    return PiecewiseScheme(left, right, spacing, tuple(special))


def dense(scheme, reach):
    """S as a matrix of floats on -reach … reach, from the definition alone; inputs beyond are left out."""
    p, size = scheme.arity, 2 * reach + 1
    a, special = np.zeros((size, size)), dict(scheme.special)
    for i in range(-reach, reach + 1):
        if i in special:
            for j, x in special[i]:
                a[i + reach, j + reach] += float(x)
            continue
        side = scheme.left if i < 0 else scheme.right
        for k, x in enumerate(side.coefficients, side.start):
            j, rest = divmod(i - k, p)
            if not rest and abs(j) <= reach:
                a[i + reach, j + reach] += float(x)
    return a


def spread(scheme, reach=40, levels=60):
    """The largest difference of data near 0 after so many levels, data of size 1."""
    power = np.linalg.matrix_power(dense(scheme, reach), levels)
    near = power[reach - 10 : reach + 11]
    return float(np.abs(near - near[0]).max())


def largest_step(side, levels=12):
    """The largest difference of S^n δ for the scheme of a mask."""
    data = np.array([1.0])
    coefficients = np.array([float(x) for x in side.coefficients])
    for _ in range(levels):
        spaced = np.zeros(side.arity * (len(data) - 1) + 1)
        spaced[:: side.arity] = data
        data = np.convolve(spaced, coefficients)
    return float(np.abs(np.diff(data)).max())


def limit_value(scheme, data, first, i, levels=36):
    """The limit at point i of data c_first, c_(first+1), …, on a side where the masks alone act."""
    p, side = scheme.arity, scheme.left if i < 0 else scheme.right
    coefficients = np.array([float(x) for x in side.coefficients])
    wide = len(coefficients) + 2
    patch = {j: data[j - first] for j in range(i - wide, i + wide + 1)}
    for _ in range(levels):
        i *= p
        new = {}
        for m in range(i - wide, i + wide + 1):
            total = 0.0
            for k, x in enumerate(coefficients, side.start):
                j, rest = divmod(m - k, p)
                if not rest:
                    total = total + x * patch[j]
            new[m] = total
        patch = new
    return patch[i]


def _rows_at_zero(scheme, k, reach, outer):
    """S, the projection that annihilates π_(k-1), and the limits of all unit data at points away from 0."""
    h = [float(x) for x in scheme.spacing]
    points = [*range(-2 * outer + 1, -outer + 1), *range(outer, 2 * outer)]
    x = np.array([i * h[i >= 0] / (2 * outer) for i in points])
    stencils = np.array([limit_value(scheme, np.eye(2 * reach + 1), -reach, i) for i in points])
    q, _ = np.linalg.qr(np.vander(x, k, increasing=True))
    return dense(scheme, reach), q, stencils - q @ (q.T @ stencils)


def decay_at_zero(scheme, k, reach=40, outer=12, levels=14):
    """The sizes of combinations of values that annihilate π_(k-1), at p^-m of the points, m = 1, 2, …, by iteration."""
    a, q, rows = _rows_at_zero(scheme, k, reach, outer)
    inner, sizes = slice(reach - 12, reach + 13), []
    for _ in range(levels):
        rows = rows @ a
        rows = rows - q @ (q.T @ rows)
        sizes.append(np.abs(rows[:, inner]).max())
    return sizes


def exponent_at_zero(scheme, k, reach=40, outer=12):
    """-log_p of the largest eigenvalue of S on the combinations of values that annihilate π_(k-1); None for no such."""
    a, q, rows = _rows_at_zero(scheme, k, reach, outer)
    for _ in range(5):
        rows = rows @ a
        rows = rows - q @ (q.T @ rows)
    _, sizes, basis = np.linalg.svd(np.vstack([rows, 2 * rows @ a, 4 * rows @ a @ a]))
    basis = basis[: np.count_nonzero(sizes > 1e-9)]
    if not len(basis):
        return None
    return -np.log(np.abs(np.linalg.eigvals(basis @ a @ basis.T)).max()) / np.log(scheme.arity)
