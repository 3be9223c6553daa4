"""Certificates of curves that matrices refine: one or more for every rule, with claims that nobody's finding needs.

The masks and what they say are known by hand; radii are bounded by a claim that is written here.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.kinds.matrices.scheme import MatrixFamily
from subdiv_cli.model import Effort
from subdiv_cli.pipeline import check

Q = Fraction


def corner_cutting(r, s):
    rows = [[r, 1 - r, 0], [s, 1 - s, 0], [0, r, 1 - r], [0, s, 1 - s]]
    return [rows[:3], rows[1:]]


def takagi(a):
    """The sum of a^n s(2^n x), by the polygon (0, 0), (1/2, 1/2), (1, 0)."""
    apex = [(1 - a) / 2, Q(1, 2) + a, -a / 2]
    return [[[1, 0, 0], apex, [0, 1, 0]], [[0, 1, 0], apex[::-1], [0, 0, 1]]]


def lebesgue(a):
    return [[[1, 0], [1 - a, a]], [[1 - a, a], [0, 1]]]


def casteljau():
    return [[[1, 0, 0], [Q(1, 2), Q(1, 2), 0], [Q(1, 4), Q(1, 2), Q(1, 4)]],
            [[Q(1, 4), Q(1, 2), Q(1, 4)], [0, Q(1, 2), Q(1, 2)], [0, 0, 1]]]  # fmt: skip


def smooth_takagi():
    """1, x, x^2, x^3, x^4 and h with h(x) = h(px - i)/30 + x^2 (1-x)^2, which is flat at both ends: C^1."""
    flat = [0, 0, 1, -2, 1]
    maps = []
    for i in range(2):
        powers = [[Q(1)]]
        for _ in range(4):
            last = powers[-1]
            powers.append([Q(i, 2) * a + Q(1, 2) * b for a, b in zip([*last, 0], [0, *last], strict=True)])
        rows = [[*row, *[Q(0)] * (5 - len(row))] for row in powers]
        bump = [sum(c * row[k] for c, row in zip(flat, rows, strict=True)) for k in range(5)]
        maps.append([*([*row, Q(0)] for row in rows), [*bump, Q(1, 30)]])
    # ψ_0 = 1 - x - … - h, the others as they are
    found = []
    for m in maps:
        top = [m[0][j] - sum(m[i][j] for i in range(1, 6)) for j in range(6)]
        mixed = [top, *m[1:]]
        b = [[row[0], *(x + row[0] for x in row[1:])] for row in mixed]
        found.append([list(column) for column in zip(*b, strict=True)])
    return found


DEGENERATE = [
    [[1, 0, 0], [Q(2, 3), Q(1, 3), 0], [0, Q(1, 2), Q(1, 2)]],
    [[Q(2, 3), Q(1, 3), 0], [0, 1, 0], [0, Q(1, 2), Q(1, 2)]],
]
"""Lebesgue's function, and a third control point that the curve does not see."""
CYCLE = [[[1, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 0], [0, 0, 1], [0, 0, 1]]]
CANTOR = [[[1, 0], [Q(2, 3), Q(1, 3)]], [[Q(1, 3), Q(2, 3)], [0, 1]]]
CONSTANT = [[[1, 0, 0], [0, Q(1, 2), Q(1, 2)], [Q(1, 2), Q(1, 2), 0]]] * 2
"""A curve that is a point. Products of two matrices have a positive column, and no corollary says so."""

MATRICES = {
    "corner_cutting": corner_cutting(Q(5, 8), Q(1, 8)),
    "de_rham": corner_cutting(Q(2, 3), Q(1, 3)),
    "takagi": takagi(Q(1, 2)),
    "takagi_1_8": takagi(Q(1, 8)),
    "lebesgue": lebesgue(Q(1, 3)),
    "casteljau": casteljau(),
    "smooth_takagi": smooth_takagi(),
    "degenerate": DEGENERATE,
    "cycle": CYCLE,
    "cantor": CANTOR,
    "constant": CONSTANT,
}


def family(matrices):
    return MatrixFamily(tuple(tuple(tuple(map(Q, row)) for row in m) for m in matrices))


def claim(rule, statement, witness=None, uses=(), work=1):
    stated = {"property": rule, **statement}
    return {"rule": rule, "statement": stated, "witness": witness or {}, "uses": list(uses), "work": work}


def made(name):
    """The certificate that the program makes, with claims that it does not need appended."""
    document = check(family(MATRICES[name]), (), Effort(4000)).document
    claims = document["claims"]

    def number(rule, **fields):
        return next(i for i, c in enumerate(claims) if c["rule"] == rule and fields.items() <= c["statement"].items())

    def add(*more):
        claims.append(claim(*more))
        document["goal"].append(claims[-1]["statement"])

    if name in ("corner_cutting", "takagi"):  # bounds of the exponent, where the exact one is known
        on_curve, known = number("annihilators"), number("components")
        about = claims[on_curve]["statement"]["family"]
        radius = next(
            i
            for i, c in enumerate(claims)
            if c["statement"]["property"] in ("radius", "bounded") and c["statement"]["family"] == about
        )
        fits = [i for i, c in enumerate(claims) if c["rule"] == "derivative"]
        bound = {"length": 1, "bound": "3/8" if fits else "1/2"}
        add("holder-lower", bound, {}, [known, radius, on_curve, *fits], 2)
        low = {"property": "radius-lower", "family": about, "length": 1, "bound": "1/4"}
        claims.append(claim("word", low, {"word": [0]}, [], 2))
        used = [known, len(claims) - 1, on_curve]
        add("holder-upper", {"length": 1, "bound": "1/4"}, {}, used)
        add("not-smooth", {"order": 2}, {}, used)
    if name == "casteljau":
        columns = number("consecutive-columns")
        add("columns-converge", {"property": "convergent", "holds": True}, {}, [columns])
    return document


ALL_CURVES = {name: (lambda name=name: made(name)) for name in MATRICES}
