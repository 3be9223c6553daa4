"""Certificates of masks on Z^s with every rule in them, made from MULTIVARIATE.md by naive arithmetic with Fractions.

Only the bounds of joint spectral radii come from the package: their rules have their own tests.
"""

from __future__ import annotations

import functools
import itertools
import json
from fractions import Fraction
from math import comb, factorial, lcm, prod

from hand_made import chaikin, claim, poly, q, sobolev
from hand_made import document as univariate

from subdiv_cli.model import Effort
from subdiv_cli.pipeline import joint_spectral_radius

WORK = 1_000_000
TWO = [[2, 0], [0, 2]]
QUINCUNX = [[1, 1], [1, -1]]
QUINCUNX_GROWTH = ("33/100", "17/50")
"""Around the largest zero of the whole polynomial."""


def product(*factors):
    """Of sparse polynomials, dictionaries from indices to Fractions."""
    total = {(0,) * len(next(iter(factors[0]))): Fraction(1)}
    for factor in factors:
        new = {}
        for (x, p), (y, r) in itertools.product(total.items(), factor.items()):
            at = tuple(i + j for i, j in zip(x, y, strict=True))
            new[at] = new.get(at, 0) + p * r
        total = {at: value for at, value in new.items() if value}
    return total


def scaled(terms, factor, shift=(0, 0, 0)):
    return {tuple(i + j for i, j in zip(x, shift, strict=False)): Fraction(v) * factor for x, v in terms.items()}


def ray(*direction, count=2):
    return {tuple(i * t for t in direction): Fraction(1) for i in range(count)}


def box(directions, factor, shift=(0, 0, 0)):
    return scaled(product(*(ray(*x) for x in directions)), Fraction(factor), shift)


def butterfly_terms(w=Fraction(1, 16)):
    half, two = Fraction(1, 2), 2 * w
    near = dict.fromkeys([(1, 0), (0, 1), (1, 1)], half)
    middle = dict.fromkeys([(1, -1), (1, 2), (2, 1)], two)
    far = dict.fromkeys([(1, -2), (2, -1), (1, 3), (3, 1), (2, 3), (3, 2)], -w)
    one = {(0, 0): Fraction(1)} | near | middle | far
    return one | {(-i, -j): v for (i, j), v in one.items()}


MASKS = {
    "bilinear": (TWO, box([(1, 0), (1, 0), (0, 1), (0, 1)], "1/4", (-1, -1))),
    "courant": (TWO, box([(1, 0), (0, 1), (1, 1)], "1/2", (-1, -1))),
    "zwart_powell": (TWO, box([(1, 0), (0, 1), (1, 1), (1, -1)], "1/4")),
    "quincunx": (
        QUINCUNX,
        {(0, 0): Fraction(1)} | dict.fromkeys([(1, 0), (-1, 0), (0, 1), (0, -1)], Fraction(1, 4)),
    ),
    "four_eight": (QUINCUNX, box([(1, 0), (1, 0), (0, 1), (0, 1)], "1/8")),
    "butterfly": (TWO, butterfly_terms()),
    "loop": (TWO, box([(1, 0), (1, 0), (0, 1), (0, 1), (1, 1), (1, 1)], "1/16", (-2, -2))),
    "flat": (TWO, {(0, 0): Fraction(1), (0, 1): Fraction(1), (1, 0): Fraction(1), (1, 1): Fraction(1, 2)}),
    "haar": (TWO, box([(1, 0), (0, 1)], 1)),
    "trapezoids": (TWO, dict.fromkeys(itertools.product(range(4), repeat=2), Fraction(1, 4))),
    "chaikin_hat": (TWO, box([(1, 0)] * 3 + [(0, 1)] * 2, "1/8", (-1, -1))),
    "trilinear": (
        [[2, 0, 0], [0, 2, 0], [0, 0, 2]],
        box([(1, 0, 0), (1, 0, 0), (0, 1, 0), (0, 1, 0), (0, 0, 1), (0, 0, 1)], "1/8", (-1, -1, -1)),
    ),
    "moved": (TWO, box([(1, 0), (1, 0), (0, 1), (0, 1)], "1/4", (0, -1))),
    "perturbed": (  # its values on 2Z^2 are not those of δ
        TWO,
        product(
            {(i, 0): Fraction(x, 8) for i, x in zip(range(-2, 3), (-1, 4, 8, 4, 1), strict=True)},
            {(0, j): Fraction(x, 2) for j, x in zip(range(-1, 2), (1, 2, 1), strict=True)},
        ),
    ),
    "parallel": (TWO, box([(-1, 0), (0, 1), (1, 0), (2, 0)], "1/4")),
    "line": (TWO, box([(1, 0), (1, 0)], 1)),
    "negative": (QUINCUNX, box([(1, 0), (1, 0), (0, 1), (0, 1)], "-1/8")),
    "anisotropic": (
        [[2, 0], [0, 3]],
        scaled(product(ray(1, 0), ray(1, 0), ray(0, 1, count=3), ray(0, 1, count=3)), Fraction(1, 6), (-1, -2)),
    ),
    "halves": (QUINCUNX, {(0, 0): Fraction(1, 2), (0, 1): Fraction(1), (0, 2): Fraction(1, 2)}),
    "apart": (QUINCUNX, {(0, 0): Fraction(1, 2), (3, 0): Fraction(1), (6, 0): Fraction(1, 2)}),
    "half_haar": (TWO, box([(1, 0), (0, 1), (0, 1)], "1/2")),  # 1, 1 times a hat: it does not converge
    "sheared": ([[2, 1], [0, 2]], box([(1, 0), (0, 1)], 1)),
}


def monomials(s, degree):
    return [mu for mu in itertools.product(range(degree + 1), repeat=s) if sum(mu) == degree]


def power(x, mu):
    return prod(i**n for i, n in zip(x, mu, strict=True))


def times(matrix, x):
    return tuple(sum(a * b for a, b in zip(row, x, strict=True)) for row in matrix)


def solve(matrix, x):
    """M^-1 x, in order 2 by Cramer's rule; None where it is not integral."""
    if len(matrix) == 3:  # 2I
        return None if any(i % 2 for i in x) else tuple(i // 2 for i in x)
    (a, b), (c, d) = matrix
    det = a * d - b * c
    y = (d * x[0] - b * x[1], a * x[1] - c * x[0])
    return None if any(i % det for i in y) else tuple(i // det for i in y)


def representatives(matrix):
    found = []
    for x in itertools.product(range(4), repeat=len(matrix)):
        if all(solve(matrix, tuple(i - j for i, j in zip(x, y, strict=True))) is None for y in found):
            found.append(x)
    return found


def transition(matrix, terms, epsilon, v):
    """T_ε v of a sequence v, a dictionary."""
    image = {}
    for (x, p), (beta, r) in itertools.product(terms.items(), v.items()):
        at = solve(matrix, tuple(i + j - e for i, j, e in zip(x, beta, epsilon, strict=True)))
        if at is not None:
            image[at] = image.get(at, 0) + p * r
    return {at: value for at, value in image.items() if value}


def difference(mu):
    """∇^μ δ."""
    corner = itertools.product(*(range(n + 1) for n in mu))
    return {x: Fraction((-1) ** sum(x) * prod(map(comb, mu, x))) for x in corner}


def window_of(matrix, terms, cosets, k):
    """The least set with the supports of all ∇^μ δ that T_ε does not leave, signs aside."""
    positive = {x: abs(v) for x, v in terms.items()}
    window, new = set(), {x for mu in monomials(len(matrix), k) for x in difference(mu)}
    while new - window:
        window |= new
        new = {x for e in cosets for x in transition(matrix, positive, e, dict.fromkeys(window, Fraction(1)))}
    return sorted(window)


def null_space(rows):
    """A basis, and the columns where one of its vectors alone is not zero."""
    rows, pivots, n = [list(row) for row in rows], [], len(rows[0])
    for column in range(n):
        at = next((i for i in range(len(pivots), len(rows)) if rows[i][column]), None)
        if at is None:
            continue
        here = len(pivots)
        rows[here], rows[at] = rows[at], rows[here]
        rows[here] = [x / rows[here][column] for x in rows[here]]
        for i, row in enumerate(rows):
            if i != here and row[column]:
                rows[i] = [x - row[column] * y for x, y in zip(row, rows[here], strict=True)]
        pivots.append(column)
    free = [column for column in range(n) if column not in pivots]
    basis = []
    for column in free:
        v = [Fraction(0)] * n
        v[column] = Fraction(1)
        for i, pivot in enumerate(pivots):
            v[pivot] = -rows[i][column]
        common = lcm(*(x.denominator for x in v))
        basis.append([int(x * common) for x in v])
    return basis, free


@functools.cache
def space(name, k):
    """The witness of `differences`, as JSON text."""
    matrix, terms = MASKS[name]
    cosets = representatives(matrix)
    window = window_of(matrix, terms, cosets, k)
    conditions = [
        [Fraction(power(x, mu)) for x in window] for degree in range(k) for mu in monomials(len(matrix), degree)
    ]
    basis, free = null_space(conditions)

    def coordinates(v):
        return [v.get(window[column], Fraction(0)) / row[column] for row, column in zip(basis, free, strict=True)]

    matrices = []
    for epsilon in cosets:
        vectors = [{x: Fraction(value) for x, value in zip(window, row, strict=True) if value} for row in basis]
        columns = [coordinates(transition(matrix, terms, epsilon, v)) for v in vectors]
        matrices.append([[q(x) for x in row] for row in zip(*columns, strict=True)])
    return json.dumps(
        {
            "cosets": cosets,
            "window": window,
            "basis": basis,
            "matrices": matrices,
            "generators": [[q(x) for x in coordinates(difference(mu))] for mu in monomials(len(matrix), k)],
        }
    )


def differences(name, k, uses, family=0):
    return claim("differences", [uses], json.loads(space(name, k)), WORK, "family", family=family, order=k)


@functools.cache
def _radius(name, k, made=space):
    matrices = json.loads(made(name, k))["matrices"]
    family = [[[Fraction(x) for x in row] for row in rows] for rows in matrices]
    return json.dumps(joint_spectral_radius(family, Effort()).document)


def radius(name, k, offset, made=space):
    """The package's claims on the radius of the family 0, as claims from number `offset` on; the radius's number."""
    document = json.loads(_radius(name, k, made))
    claims = document["claims"]
    for each in claims:
        each["uses"] = [i + offset for i in each["uses"]]
    goal = next(s for s in document["goal"] if s["property"] in ("bounded", "radius"))
    return claims, offset + next(i for i, c in enumerate(claims) if c["statement"] == goal)


def window_with(name, start):
    """The least set with these indices that no T_ε leaves, signs aside."""
    matrix, terms = MASKS[name]
    positive, window, new = {x: abs(v) for x, v in terms.items()}, set(), set(start)
    while new - window:
        window |= new
        all_of = dict.fromkeys(window, Fraction(1))
        new = {x for e in representatives(matrix) for x in transition(matrix, positive, e, all_of)}
    return sorted(window)


def limit_stencil(name):
    """The sequence w with T_0 w = w, the sum 1, as the only one there is."""
    matrix, terms = MASKS[name]
    window = window_with(name, [(0,) * len(matrix)])
    images = [transition(matrix, terms, (0,) * len(matrix), {x: Fraction(1)}) for x in window]
    rows = [[image.get(x, Fraction(0)) - (x == y) for image, y in zip(images, window, strict=True)] for x in window]
    (basis,), _ = null_space(rows)
    return {x: Fraction(value, sum(basis)) for x, value in zip(window, basis, strict=True) if value}


def combination(vectors, v):
    """The coefficients of v as a combination of independent sequences; None where it is none."""
    indices = sorted({x for each in (*vectors, v) for x in each})
    basis, _ = null_space([[each.get(x, Fraction(0)) for each in (*vectors, v)] for x in indices])
    return [-Fraction(c, basis[0][-1]) for c in basis[0][:-1]] if basis else None


@functools.cache
def stencil_space(name, k):
    """The witness of `stencil-differences`, as JSON text: the first of the differences is replaced by its images."""
    matrix, terms = MASKS[name]
    cosets, w = representatives(matrix), limit_stencil(name)
    first, *others = (product(difference(mu), w) for mu in monomials(len(matrix), k))
    leaves = [*others, *(transition(matrix, terms, e, first) for e in cosets)]
    waiting, vectors, words = [([i], v) for i, v in enumerate(leaves)], [], []
    while waiting:
        word, v = waiting.pop(0)
        if v and combination(vectors, v) is None:
            common = lcm(*(x.denominator for x in v.values()))
            vectors.append({x: value * common for x, value in v.items()})
            words.append(word)
            waiting += [([*word, i], transition(matrix, terms, e, v)) for i, e in enumerate(cosets)]
    window = sorted({x for v in vectors for x in v})
    images = [[combination(vectors, transition(matrix, terms, e, v)) for v in vectors] for e in cosets]
    return json.dumps(
        {
            "cosets": cosets,
            "window": window,
            "basis": [[int(v.get(x, 0)) for x in window] for v in vectors],
            "matrices": [[[q(x) for x in row] for row in zip(*columns, strict=True)] for columns in images],
            "tree": [0, *(1 for _ in leaves)],
            "breadth": max(map(len, (first, *leaves))),
            "leaves": [[q(x) for x in combination(vectors, v)] for v in leaves],
            "words": words,
        }
    )


def document(name, claims, goal=None):
    matrix, terms = MASKS[name]
    return {
        "format": "subdiv-certificate",
        "version": 1,
        "mask": {"kind": "multivariate", "dilation": matrix, "terms": [[list(x), q(terms[x])] for x in sorted(terms)]},
        "goal": goal or [json.loads(json.dumps(c["statement"])) for c in claims],
        "claims": json.loads(json.dumps(claims)),
    }


def quotient(name, *direction, count=2):
    """a(z) / (1 + … + z^((count-1)θ)) as terms, by the series in z^θ: the lines of this direction one by one."""
    terms, found = dict(MASKS[name][1]), {}
    height = max(abs(t) for t in direction)
    while terms:
        at = min(terms, key=lambda x: (sum(i * t for i, t in zip(x, direction, strict=True)), x))
        value = terms[at]
        found[at] = value
        for i in range(count):
            x = tuple(j + i * t for j, t in zip(at, direction, strict=True))
            terms[x] = terms.get(x, 0) - value
            if not terms[x]:
                del terms[x]
        assert len(found) < 200 * height
    return [[list(x), q(found[x])] for x in sorted(found)]


def norm(quotient, p, level):
    """‖S_d^L‖∞ of the dilation pI, L = level."""
    d = {tuple(x): Fraction(value) for x, value in quotient}
    spread = [{tuple(i * p**j for i in x): value for x, value in d.items()} for j in range(level)]
    classes = {}
    for x, value in product(*spread).items():
        key = tuple(i % p**level for i in x)
        classes[key] = classes.get(key, 0) + abs(value)
    return max(classes.values())


PAIRS = [((0, 1), (1, 0)), ((0, 1), (1, 1)), ((1, 0), (1, 1))]


def pair_quotient(name, first, second):
    """a(z) / ((1 + z^θ) (1 + z^η)) as terms."""
    d = {tuple(x): Fraction(value) for x, value in quotient(name, *first)}
    MASKS["quotient"] = (TWO, d)
    found = quotient("quotient", *second)
    del MASKS["quotient"]
    return found


def pair_norm(found, level):
    """‖S_(2d)^level‖∞ of the dilation 2I."""
    return 2**level * norm(found, 2, level)


def quincunx_reduction():
    """MULTIVARIATE.md: Q of the interpolatory mask on the quincunx lattice, by rows."""
    entries = [
        {(-1, 0): -1, (-1, 1): -2, (0, 1): -1},
        {(-1, 0): 2, (-1, 1): 1, (0, 0): 1},
        {(-1, 0): 1, (0, 0): 2, (0, 1): 1},
        {(0, -1): 2, (0, 0): 1, (1, -1): 1},
    ]
    return [[[list(x), q(Fraction(value, 4))] for x, value in sorted(f.items())] for f in entries]


def correlation(name):
    """b(z) = a(z) a(1/z)."""
    terms = MASKS[name][1]
    return product(terms, {tuple(-i for i in x): v for x, v in terms.items()})


def mean_square_step(name, v):
    """(G v)(α) = (1/m) Σ_β b(Mα-β) v(β)."""
    matrix = MASKS[name][0]
    image = transition(matrix, correlation(name), (0,) * len(matrix), v)
    return {x: value / len(representatives(matrix)) for x, value in image.items()}


def laplacian_power(s, k):
    """w, as a sum over all |μ| = k of the autocorrelations of ∇^μ δ with multinomial weights."""
    total = {}
    for mu in monomials(s, k):
        weight = Fraction(factorial(k), prod(map(factorial, mu)))
        d = difference(mu)
        for x, value in product(d, {tuple(-i for i in x): v for x, v in d.items()}).items():
            total[x] = total.get(x, 0) + weight * value
    return {x: value for x, value in total.items() if value}


@functools.cache
def annihilator(name, k):
    """The monic polynomial f of the least degree with f(G) w = 0, the constant first."""
    vectors = [laplacian_power(len(MASKS[name][0]), k)]
    while True:
        window = sorted({x for v in vectors for x in v})
        basis, _ = null_space([[v.get(x, Fraction(0)) for v in vectors] for x in window])
        if basis:
            return [Fraction(c, basis[0][-1]) for c in basis[0]]
        vectors.append(mean_square_step(name, vectors[-1]))


@functools.cache
def gram(name):
    """The g with G g = g and Σ g = 1, by elimination on the least set that G does not leave: terms, as JSON text."""
    zero = (0,) * len(MASKS[name][0])
    window, new = set(), {zero}
    absolute = {x: abs(v) for x, v in correlation(name).items()}
    while new - window:
        window |= new
        new = set(transition(MASKS[name][0], absolute, zero, dict.fromkeys(window, Fraction(1))))
    window = sorted(window)
    images = [mean_square_step(name, {x: Fraction(1)}) for x in window]
    basis, _ = null_space(
        [[v.get(x, Fraction(0)) - (x == y) for v, y in zip(images, window, strict=True)] for x in window]
    )
    assert len(basis) == 1
    values = [Fraction(x, sum(basis[0])) for x in basis[0]]
    return json.dumps([[list(x), q(v)] for x, v in zip(window, values, strict=True) if v])


def divided(f, g):
    """f / g, the constants first."""
    f, found = list(f), []
    while len(f) >= len(g):
        found.append(f[-1] / g[-1])
        f = [x - found[-1] * y for x, y in zip(f, [0] * (len(f) - len(g)) + g, strict=True)][:-1]
    assert not any(f)
    return found[::-1]


def polynomial(coefficients):
    return {"start": 0, "coefficients": [q(Fraction(c)) for c in coefficients]}


def terms_of(values):
    return [[list(index), q(value)] for index, value in sorted(values.items())]


NEIGHBOURS = [(1, 0), (-1, 0), (0, 1), (0, -1)]


class _Book:
    """Claims in the order they are made; `add` returns the number of a claim."""

    def __init__(self, name):
        self.name, self.claims = name, []

    def add(self, rule, uses=(), witness=None, **fields):
        self.claims.append(claim(rule, uses, witness, WORK, **fields))
        return len(self.claims) - 1

    def structure(self, k):
        """Coset sums and sum rules, claims 0 and 1."""
        self.add("coset-sums", holds=bool(k))
        self.add("total-sum-rules", order=k)
        self.add("generation", [1], degree=k - 1)

    def radius(self, k):
        """The numbers of family 0 and of its radius."""
        self.claims.append(differences(self.name, k, 1))
        family = len(self.claims) - 1
        more, number = radius(self.name, k, len(self.claims))
        self.claims += more
        return family, number

    def sobolev(self, k, f, low, high, stable=None):
        """By the zero of f in [low, high]; from below where no claim on stability is given."""
        uses = [1] if stable is None else [1, stable]
        cofactor = polynomial(divided(annihilator(self.name, k), [Fraction(c) for c in f]))
        fields = {"polynomial": polynomial(f), "low": low, "high": high}
        name = "sobolev-lower" if stable is None else "sobolev"
        return self.add("surface-sobolev", uses, {"cofactor": cofactor}, property=name, **fields)

    def routes(self, converges, stable, lower, upper, mean, factors):
        """What follows for the bilinear B-spline from other claims on it, k = 2, α = 1, σ = 3/2."""
        self.add("smooth", [converges], order=0)
        self.add("holder-lower", [converges], length=1, bound="1")
        self.add("holder-upper", [1, stable], length=2, bound="1/16")
        self.add("holder-upper", [mean], length=2, bound="1/8")
        self.add("not-smooth", [mean], order=2)
        self.add("sobolev-at-least", [lower], length=1, bound="1/2")
        self.add("sobolev-at-most", [upper], length=2, bound="1/16")
        self.add("sobolev-at-most", [1, stable], length=2, bound="1/16")
        decay = self.add("directional-decay", [0, *factors], order=1, level=2, norm="1/4")
        self.add("holder-lower", [decay], length=2, bound="1/4")
        self.add("converges", [decay], property="convergent", holds=True)

    def quasi_interpolation(self, converges, degree, centre, *around):
        """The stencil has a weight at the centre, and others at indices about it: pairs of both."""
        weight, *others = around
        t = {centre: Fraction(weight)}
        for x, indices in others:
            t |= {tuple(i + j for i, j in zip(centre, index, strict=True)): Fraction(x) for index in indices}
        operator = {}
        for mu in (mu for j in range(degree + 1) for mu in monomials(len(centre), j)):
            if moment := sum(x * power(j, mu) for j, x in t.items()):
                operator[mu] = moment / prod(map(factorial, mu))
        fields = {"operator": terms_of(operator), "stencil": terms_of(t)}
        rule = "surface-quasi-interpolation"
        return self.add(rule, [converges, 1], property="quasi-interpolation", degree=degree, **fields)

    def box(self, directions, power, shift, scale=2):
        directions = [list(x) for x in sorted(directions)]
        return self.add(
            "box-spline", witness={"power": power, "shift": list(shift)}, directions=directions, scale=scale
        )

    def gram(self, converges, **witness):
        """φ is stable by a tree, unstable by a zero."""
        rule, holds = ("gram-stable", True) if "tree" in witness else ("gram-unstable", False)
        witness["gram"] = json.loads(gram(self.name))
        return self.add(rule, [converges], witness, property="stable", holds=holds)

    def document(self):
        return document(self.name, self.claims)


def bilinear():
    """All that there is to say of the bilinear B-spline, by differences, as a box spline and by its factors."""
    book = _Book("bilinear")
    book.structure(2)
    family, root = book.radius(2)
    converges = book.add("converges", [root, family], property="convergent", holds=True)
    stable = book.add("interpolatory-stable", [converges], property="stable", holds=True)
    book.add("smooth", [root, family], order=0)
    book.add("not-smooth", [stable, root, family], order=1)
    book.add("not-smooth", [stable, 1], order=2)
    lower = book.add("holder-lower", [root, family], length=1, bound="1/2")
    upper = book.add("holder-upper", [root, family, 1, stable], length=1, bound="1/2")
    exact = {"length": 1, "polynomial": ["-1", "2"], "low": "1/2", "high": "1/2"}
    book.add("holder-root", [root, family, 1, stable], **exact)
    book.add("reproduction", [1], degree=1)
    book.quasi_interpolation(converges, 1, (0, 0), 1)
    mean = book.sobolev(2, [-1, 8], "1/8", "1/8", stable)
    book.sobolev(2, [-1, 8], "1/8", "1/8")
    spline = book.box([(1, 0), (1, 0), (0, 1), (0, 1)], 1, (-1, -1))
    book.add("box-smooth", [spline], property="smooth", order=0)
    book.add("box-not-smooth", [spline], property="not-smooth", order=1)
    book.add("box-holder", [spline], property="holder-value", value=1)
    book.add("box-sobolev", [spline], property="sobolev-value", value="3/2")
    book.add("box-stable", [spline], property="stable", holds=True)
    factors = [
        book.add(
            "directional-norm", witness={"quotient": quotient("bilinear", *x)}, direction=list(x), level=1, norm="1/2"
        )
        for x in ((1, 0), (0, 1))
    ]
    book.add("directional-converges", [0, *factors], property="convergent", holds=True)
    book.gram(converges, tree=[-1, 1, -1, -1, -1, 1, -1, -1])
    book.add("positive-converges", [0], property="convergent", holds=True)
    book.routes(converges, stable, lower, upper, mean, factors)
    return book.document()


def courant():
    book = _Book("courant")
    book.structure(2)
    family, root = book.radius(2)
    converges = book.add("converges", [root, family], property="convergent", holds=True)
    stable = book.add("interpolatory-stable", [converges], property="stable", holds=True)
    book.add("smooth", [root, family], order=0)
    book.add("not-smooth", [stable, root, family], order=1)
    spline = book.box([(1, 0), (0, 1), (1, 1)], 1, (-1, -1))
    book.add("box-holder", [spline], property="holder-value", value=1)
    return book.document()


def zwart_powell():
    """C^1, α = 2, s = 5/2, not stable: differences see s >= 2. Of cubics it generates lines only."""
    book = _Book("zwart_powell")
    book.structure(2)
    book.add("reproduction", [1], degree=1)
    book.sobolev(2, [-1, 16], "1/16", "1/16")
    converges = book.add("converges", [len(book.claims) - 1], property="convergent", holds=True)
    book.gram(converges, point=[1, 1], order=2)
    spline = book.box([(1, 0), (0, 1), (1, 1), (1, -1)], 1, (0, 0))
    book.add("box-smooth", [spline], property="smooth", order=1)
    book.add("box-not-smooth", [spline], property="not-smooth", order=2)
    book.add("box-holder", [spline], property="holder-value", value=2)
    book.add("box-sobolev", [spline], property="sobolev-value", value="5/2")
    book.add("box-stable", [spline], property="stable", holds=False)
    return book.document()


def trapezoids():
    """All coefficients are 1/4: a product of trapezoids, C^0, α = 1, unstable, so that limit stencils must tell."""
    book = _Book("trapezoids")
    book.structure(1)
    converges = book.add("positive-converges", [0], property="convergent", holds=True)
    stencil = book.add("limit-stencil", [], {"terms": terms_of(limit_stencil("trapezoids"))}, coset=[0, 0])
    witness = json.loads(stencil_space("trapezoids", 2))
    family = book.add("stencil-differences", [stencil], witness, property="stencil-family", family=0, order=2)
    more, root = radius("trapezoids", 2, len(book.claims), stencil_space)
    book.claims += more
    uses, exact = [converges, root, family], {"length": 1, "polynomial": ["-1", "2"], "low": "1/2", "high": "1/2"}
    book.add("stencil-smooth", uses, property="smooth", order=0)
    book.add("stencil-not-smooth", uses, property="not-smooth", order=1)
    lower = book.add("stencil-holder-lower", uses, property="holder-lower", length=1, bound="1/2")
    upper = book.add("stencil-holder-upper", uses, property="holder-upper", length=1, bound="1/2")
    book.add("stencil-holder-root", uses, property="holder-root", **exact)
    book.add("holder-meets", [lower, upper], property="holder-root", **exact)
    return book.document()


def quincunx():
    """Interpolatory: α = 2 - 2 log_2((1+√5)/2)."""
    book = _Book("quincunx")
    book.structure(2)
    family, root = book.radius(2)
    said = book.claims[root]["statement"]
    converges = book.add("converges", [root, family], property="convergent", holds=True)
    stable = book.add("interpolatory-stable", [converges], property="stable", holds=True)
    book.add("smooth", [root, family], order=0)
    book.add("not-smooth", [stable, root, family], order=1)
    book.add("holder-lower", [root, family], length=said["length"], bound=said["high"])
    book.add("holder-upper", [root, family, 1, stable], length=said["length"], bound=said["low"])
    book.add("reproduction", [1], degree=1)
    book.sobolev(2, annihilator("quincunx", 2), *QUINCUNX_GROWTH, stable)
    exact = {key: said[key] for key in ("length", "polynomial", "low", "high")}
    book.add("holder-root", [root, family, 1, stable], **exact)
    found = {"power": 1, "entries": quincunx_reduction()}
    matrix = book.add("matrix-norm", [1], found, order=1, level=3, norm="27/32")
    book.add("converges", [matrix], property="convergent", holds=True)
    book.add("smooth", [matrix], order=0)
    book.add("holder-lower", [matrix], length=3, bound="27/32")
    return book.document()


def four_eight():
    """α = 5 as a box spline of the quincunx dilation, of which differences see 4. It generates cubics."""
    book = _Book("four_eight")
    book.structure(4)
    book.add("reproduction", [1], degree=1)
    family, root = book.radius(4)
    book.add("smooth", [root, family], order=3)
    book.add("holder-lower", [root, family], length=1, bound="1/4")
    converges = book.add("converges", [root, family], property="convergent", holds=True)
    book.quasi_interpolation(converges, 3, (3, 1), 2, ("-1/4", NEIGHBOURS))
    spline = book.box([(1, 0), (1, 0), (0, 1), (0, 1), (1, 1), (1, 1), (1, -1), (1, -1)], 2, (0, 0))
    book.add("box-smooth", [spline], property="smooth", order=4)
    book.add("box-not-smooth", [spline], property="not-smooth", order=5)
    book.add("box-holder", [spline], property="holder-value", value=5)
    book.add("box-sobolev", [spline], property="sobolev-value", value="11/2")
    book.add("box-stable", [spline], property="stable", holds=False)
    return book.document()


def butterfly():
    """ω = 1/16: converges by its directional factors."""
    book = _Book("butterfly")
    book.structure(4)
    book.claims.append(differences("butterfly", 4, 1))
    for level in (1, 2, 3):
        factors = [
            book.add(
                "directional-norm",
                witness={"quotient": quotient("butterfly", *x)},
                direction=list(x),
                level=level,
                norm=q(norm(quotient("butterfly", *x), 2, level)),
            )
            for x in ((1, 0), (0, 1))
        ]
    converges = book.add("directional-converges", [0, *factors], property="convergent", holds=True)
    stable = book.add("interpolatory-stable", [converges], property="stable", holds=True)
    book.add("not-smooth", [stable, 1], order=4)
    book.add("reproduction", [1], degree=3)
    book.quasi_interpolation(converges, 3, (0, 0), 1)
    book.sobolev(4, [-1, -40, 2048], "339/10000", "17/500", stable)
    book.sobolev(4, [-1, -40, 2048], "339/10000", "17/500")
    mean = len(book.claims) - 1
    book.add("converges", [mean], property="convergent", holds=True)
    book.add("smooth", [mean], order=1)
    book.add("holder-lower", [mean], length=2, bound="17/125")
    pairs = []
    for pair in PAIRS:
        found = pair_quotient("butterfly", *pair)
        fields = {"directions": [list(x) for x in pair], "level": 2, "norm": q(pair_norm(found, 2))}
        pairs.append(book.add("pair-norm", witness={"quotient": found}, **fields))
    book.add("directional-smooth", [0, *pairs], property="smooth", order=1)
    worst = max(Fraction(book.claims[number]["statement"]["norm"]) for number in pairs)
    decay = book.add("directional-decay", [0, *pairs], order=2, level=2, norm=q(worst / 4))
    book.add("smooth", [decay], order=1)
    return book.document()


def hat():
    """The linear B-spline in one variable. Claims: 0 residue-sums, 1 sum-rules, 2 norm ν=2, 3 product, 4 independent,
    5 stable, 6 norm ν=1, 7 converges, 8 smooth, 9 not-smooth, 10 holder-lower, 11 holder-upper, 12 holder-exact,
    13 sobolev.
    """
    return univariate(
        2,
        poly(-1, 1, 2, 1, over=2),
        [
            claim("residue-sums", mask=0, sums=["1", "1"]),
            claim("sum-rules", mask=0, order=2, witness={"quotient": poly(-1, "1/2")}),
            claim("norm", [1], mask=0, nu=2, level=1, norm="1"),
            claim("product", [1], mask=0, word=[0], radius="1/2"),
            claim("independent", mask=0, holds=True, witness={"cofactors": [poly(0, 1), poly(0)]}),
            claim("stable", [4], mask=0, holds=True),
            claim("norm", [1], mask=0, nu=1, level=1, norm="1/2"),
            claim("converges", [6], property="convergent", holds=True),
            claim("smooth", [6], order=0),
            claim("not-smooth", [5, 3], order=1),
            claim("holder-lower", [2, 1], level=1, norm="1/2"),
            claim("holder-upper", [5, 3], length=1, radius="1/2"),
            claim("holder-exact", [10, 11], property="holder", level=1, norm="1/2"),
            sobolev([5, 1], poly(0, "-1/8", 1), "1/8"),
        ],
    )


def chaikin_hat():
    """The product of a quadratic and a linear B-spline: the linear one is rougher."""
    book, parts = _Book("chaikin_hat"), [chaikin(), hat()]
    book.structure(2)
    tensor = book.add("tensor-product", witness={"which": [0, 1], "certificates": parts}, parts=[[0], [1]])
    converges = book.add("tensor-converges", [tensor], property="convergent", holds=True)
    book.add("tensor-stable", [tensor, converges], property="stable", holds=True)
    book.add("tensor-smooth", [tensor], property="smooth", order=0)
    book.add("tensor-not-smooth", [tensor], property="not-smooth", order=1)
    holder, sobolev_exponent = (each["statement"] for each in parts[1]["claims"][-2:])
    book.add("of-factor", [tensor], {"between": "3/2"}, variables=[1], statement=holder)
    book.add("of-factor", [tensor], {"between": "2"}, variables=[1], statement=sobolev_exponent)
    book.add("at-most-factor", [tensor], variables=[1], statement=holder)
    return book.document()


def loop():
    """The worked example of MULTIVARIATE.md: cubics by a stencil on the hexagon."""
    book = _Book("loop")
    book.structure(4)
    factors = [
        book.add("directional-norm", witness={"quotient": quotient("loop", *x)}, direction=list(x), level=1, norm="1/2")
        for x in ((1, 0), (0, 1))
    ]
    converges = book.add("directional-converges", [0, *factors], property="convergent", holds=True)
    book.quasi_interpolation(converges, 3, (0, 0), "3/2", ("-1/12", [*NEIGHBOURS, (1, 1), (-1, -1)]))
    book.quasi_interpolation(converges, 1, (0, 0), 1)
    return book.document()


def haar():
    """The indicator function of the square: stable, α = 0, and S does not converge uniformly."""
    book = _Book("haar")
    book.structure(1)
    family, root = book.radius(1)
    book.add("diverges", [root, family], property="convergent", holds=False)
    spline = book.box([(1, 0), (0, 1)], 1, (0, 0))
    stable = book.add("box-stable", [spline], property="stable", holds=True)
    jumps = book.add("box-not-smooth", [spline], property="not-smooth", order=0)
    book.add("not-smooth", [stable, root, family], order=0)
    book.add("diverges", [jumps], property="convergent", holds=False)
    book.add("box-holder", [spline], property="holder-value", value=0)
    book.add("holder-root", [root, family, 1, stable], length=1, polynomial=["-1", "1"], low="1", high="1")
    return book.document()


def apart():
    """The mask stays in 3 Z^2: its box spline is C^0, and S diverges."""
    book = _Book("apart")
    book.structure(2)
    witness = {"functional": [1, 0], "modulus": 3}
    book.add("sublattice-diverges", witness=witness, property="convergent", holds=False)
    return book.document()


def flat():
    book = _Book("flat")
    book.structure(0)
    book.add("diverges", [0], property="convergent", holds=False)
    return book.document()


def trilinear():
    book = _Book("trilinear")
    book.structure(2)
    book.claims.append(differences("trilinear", 2, 1))
    axes = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    spline = book.box(2 * axes, 1, (-1, -1, -1))
    book.add("box-holder", [spline], property="holder-value", value=1)
    book.add("box-sobolev", [spline], property="sobolev-value", value="3/2")
    book.add("box-stable", [spline], property="stable", holds=True)
    factors = [
        book.add(
            "directional-norm", witness={"quotient": quotient("trilinear", *x)}, direction=list(x), level=1, norm="1/2"
        )
        for x in axes
    ]
    book.add("directional-converges", [0, *factors], property="convergent", holds=True)
    return book.document()


ALL_MULTIVARIATE = {
    make.__name__: make
    for make in (
        bilinear,
        courant,
        zwart_powell,
        quincunx,
        four_eight,
        butterfly,
        chaikin_hat,
        loop,
        haar,
        apart,
        flat,
        trilinear,
        trapezoids,
    )
}
