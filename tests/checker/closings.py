"""True `closing` and `polytope` witnesses for small families, found by floating point search and nothing of the
package.

The gauge of a point is the least Σ |c_k| over all combinations of N vertices that give it, which is what linear
programming would find: good for N <= 3 and some dozens of vertices.
"""

from __future__ import annotations

import itertools
from fractions import Fraction

import numpy as np

WEIGHT_BITS = 36


def gauge(vertices, x):
    """(gauge, vertex numbers, weights) of x in hull(±v); None where the vertices do not span."""
    v, best = np.array(vertices), None
    for basis in itertools.combinations(range(len(v)), len(x)):
        b = v[list(basis)].T
        if abs(np.linalg.det(b)) > 1e-9:
            c = np.linalg.solve(b, x)
            if best is None or np.abs(c).sum() < best[0] - 1e-12:
                best = np.abs(c).sum(), basis, c
    return best


def best_basis(vertices):
    """N vertices that span well."""
    v = np.array(vertices)
    return list(max(itertools.combinations(range(len(v)), v.shape[1]), key=lambda b: abs(np.linalg.det(v[list(b)]))))


def rounded(numbers, weights):
    """The flat list of a witness: k_1, c_1, …, no zeros."""
    pairs = [(int(k), round(float(c) * 2**WEIGHT_BITS)) for k, c in zip(numbers, weights, strict=True)]
    return [x for pair in pairs if pair[1] for x in pair]


def hull(vertices, symmetry):
    return [*vertices, *(v[::-1] for v in vertices)] if symmetry else list(vertices)


def leading(matrix, annihilator, mu, column, scale=1):
    """h(Π) e_j, or h(Π) y, as RADIUS.md defines it."""
    n, g = len(matrix), [float(Fraction(c)) for c in annihilator]
    w, x = np.zeros(n), np.zeros(n)
    start = np.eye(n)[column] if isinstance(column, int) else np.array(column, dtype=float)
    for k in range(len(g) - 2, -1, -1):
        w = matrix @ w
        w = w + g[k + 1] * start
        x = x + mu**k * w
    return scale * x


def is_tie(vertices, point, depth, depths, length):
    """(k, ±1) where the point is ± a vertex whose depth fits."""
    for k, v in enumerate(vertices):
        for sign in (1, -1):
            if np.allclose(point, sign * v, atol=1e-9) and (depth - depths[k % len(depths)]) % length == 0:
                return k, sign
    return None


def closing(matrices, root, leaders, symmetry=0, bits=80, extras=(), most=60):
    """The witness; matrices of Fractions, root the fields of the statement, leaders as in the witness."""
    family = [np.array([[float(x) for x in row] for row in m]) for m in matrices]
    p, length = len(family), root["length"]
    value = next(
        z.real
        for z in np.roots([float(Fraction(c)) for c in root["polynomial"]][::-1])
        if abs(z.imag) < 1e-12 and float(Fraction(root["low"])) - 1e-9 <= z.real <= float(Fraction(root["high"])) + 1e-9
    )
    sigma = value ** (1 / length)
    vertices, depths, children, tree = [], [], {}, []
    for leader in leaders:
        total = np.eye(len(family[0]))
        for letter in leader["word"]:
            total = family[letter] @ total
        total = total[::-1] if leader["reflected"] else total
        scale = float(Fraction(leader["scale"]))
        vertices.append(leading(total, leader["annihilator"], leader["sign"] * value, leader["column"], scale))
        depths.append(0)

    def add(u, letter):
        if (u, letter) not in children:
            children[u, letter] = len(vertices)
            tree.extend((u, letter))
            vertices.append(family[letter] @ vertices[u] / sigma)
            depths.append(depths[u] + 1)
        return children[u, letter]

    returns = set()
    for u, leader in enumerate(leaders):
        for letter in leader["word"][:-1]:
            u = add(u, letter)
        returns.add((u, leader["word"][-1]))
    for e, extra in enumerate(extras):
        tree.extend((-1, e))
        vertices.append(np.array(extra) / 2**30)
        depths.append(10**6 + e)
    ties, u = {}, 0
    while u < len(vertices):
        for letter in range(p):
            if (u, letter) in children or (u, letter) in returns:
                continue
            point = family[letter] @ vertices[u] / sigma
            found = gauge(hull(vertices, symmetry), point)
            tie = is_tie(hull(vertices, symmetry), point, depths[u] + 1, depths, length)
            if tie and depths[u] < 10**6:
                ties[u, letter] = tie
            elif found is None or found[0] > 1 - 1e-7:
                assert len(vertices) < most, "it does not close"
                add(u, letter)
        u += 1
    last, n = hull(vertices, symmetry), len(vertices)
    images, listed = [], []
    for u, letter in itertools.product(range(n), range(p)):
        if (u, letter) in ties:
            k, sign = ties[u, letter]
            listed.append({"vertex": u, "letter": letter, "weights": [{"vertex": k, "weight": str(sign)}]})
        elif (u, letter) not in children and (u, letter) not in returns:
            _, basis, c = gauge(last, family[letter] @ vertices[u] / sigma)
            images.append(rounded(basis, c))
    return {
        "symmetry": symmetry,
        "bits": bits,
        "leaders": leaders,
        "extras": [list(e) for e in extras],
        "tree": tree,
        "basis": best_basis(vertices),
        "weight_bits": WEIGHT_BITS,
        "images": images,
        "ties": listed,
    }


def polytope(matrices, bound, start, symmetry=0, bits=20, most=60):
    """The witness of JSR <= bound: images of the start vectors are added, rounded, until all lie inside.

    They are added as for a bound a little smaller, so that rounding does no harm.
    """
    family = [np.array([[float(x) for x in row] for row in m]) / (0.9999 * float(bound)) for m in matrices]
    vertices, u = [np.round(np.array(v) * 2**bits) for v in start], 0
    while u < len(vertices):
        for m in family:
            found = gauge(hull(vertices, symmetry), m @ vertices[u])
            if found is None or found[0] > 1 - 1e-5:
                assert len(vertices) < most, "it does not close"
                vertices.append(np.round(m @ vertices[u]))
        u += 1
    last = hull(vertices, symmetry)
    images = [rounded(*gauge(last, 0.9999 * m @ v)[1:]) for v in vertices for m in family]
    return {
        "symmetry": symmetry,
        "bits": bits,
        "vertices": [[str(int(x)) for x in v] for v in vertices],
        "basis": best_basis(vertices),
        "weight_bits": WEIGHT_BITS,
        "images": images,
    }
