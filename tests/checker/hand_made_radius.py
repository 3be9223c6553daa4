"""Certificates of joint spectral radii: of small families whose radius is known, and of masks.

Some are written by hand; of the others, which the package writes, the radius stands beside them.
"""

from __future__ import annotations

import json
from fractions import Fraction

from hand_made import claim
from support import four_point, scheme

from subdiv_cli.checker.radius.rules import RULEBOOK as RADIUS
from subdiv_cli.model import Effort
from subdiv_cli.pipeline import check, joint_spectral_radius

OF_RADII = {
    *RADIUS.rules,
    "transition",
    "positive-symbol",
    "holder-root",
    "attained-bounded",
    "attained-norm",
    "not-attained",
}
"""The rules that these certificates are about; those of hand_made.py are about all others."""
POSITIVE = [[[1, 1], [0, 1]], [[1, 0], [1, 1]]]
"""JSR (1+√5)/2."""
GOLDEN = [[[-1, -1], [0, -1]], [[-1, 0], [-1, -1]]]
"""The same with signs, which nothing monotone is of."""
ROTATION = [[["3/5", "-4/5"], ["4/5", "3/5"]], [["1/2", "0"], ["0", "1/3"]]]
"""JSR 1, attained by a rotation."""
TRIANGULAR = [[[2, 1], [0, 1]], [[1, 5], [0, -3]]]
"""JSR 3: the blocks are 2, 1 and 1, -3."""
NO_FINITENESS = [
    [[-1, -1], [0, -1]],
    [["-749326546/1000000000", 0], ["-749326546/1000000000", "-749326546/1000000000"]],
]
"""Near the parameter for which no product attains the radius: 1.4092472…, an enclosure."""
NILPOTENT = [[[0, 1], [0, 0]]]


def family(matrices):
    return [[[Fraction(x) for x in row] for row in rows] for rows in matrices]


def of_family(matrices):
    document = joint_spectral_radius(family(matrices), Effort()).document
    return json.loads(json.dumps(document))


def of_mask(mask):
    return json.loads(json.dumps(check(mask, (), Effort()).document))


def golden():
    return of_family(GOLDEN)


def monotone():
    return of_family(POSITIVE)


def monotone_enclosed():
    return of_family([[[abs(Fraction(x)) for x in row] for row in rows] for rows in NO_FINITENESS])


def one_vertex():
    """By hand, RADIUS.md's example of `monotone-polytope`: (1, 1) alone bounds the radius by 2."""
    witness = {
        "symmetry": 0,
        "bits": 0,
        "vertices": [["1", "1"]],
        "basis": [0, 0],
        "weight_bits": 0,
        "images": [[0, 1], [0, 1]],
    }
    bound = claim("monotone-polytope", property="radius-upper", family=0, length=1, bound="2", witness=witness)
    return matrices_document([[["1", "1"], ["0", "1"]], [["1", "0"], ["1", "1"]]], [bound])


def signed():
    """Three shears up to sign: two of them, and one of these again."""
    return of_family([*GOLDEN, [[1, 1], [0, 1]]])


def rotation():
    return of_family(ROTATION)


def triangular():
    return of_family(TRIANGULAR)


def nilpotent():
    return of_family(NILPOTENT)


def enclosed():
    return of_family(NO_FINITENESS)


def lower_of_blocks():
    """By hand: the word 0 of the first block of ((2, 1), (0, 1)) has radius 2, and so the family has."""
    matrices = [[["2", "1"], ["0", "1"]]]
    claims = [
        claim("blocks", family=0, parts=[1, 2], witness={"basis": [["1", "0"], ["0", "1"]], "sizes": [1, 1]}),
        claim("word", property="radius-lower", family=1, length=1, bound="2", witness={"word": [0]}),
        claim("lower-of-blocks", [0, 1], property="radius-lower", family=0, length=1, bound="2"),
    ]
    return matrices_document(matrices, claims)


def matrices_document(matrices, claims):
    return {
        "format": "subdiv-certificate",
        "version": 1,
        "mask": {"kind": "matrices", "matrices": matrices},
        "goal": [dict(c["statement"]) for c in claims],
        "claims": claims,
    }


def swap():
    """By hand, RADIUS.md's example of `polytope`: a permutation maps the square with corners ±e_1, ±e_2 into itself."""
    witness = {
        "symmetry": 0,
        "bits": 0,
        "vertices": [["1", "0"], ["0", "1"]],
        "basis": [0, 1],
        "weight_bits": 0,
        "images": [[1, 1], [0, 1]],
    }
    bound = claim("polytope", property="radius-upper", family=0, length=1, bound="1", witness=witness)
    return matrices_document([[["0", "1"], ["1", "0"]]], [bound])


ONE = {"length": 1, "polynomial": ["-1", "1"], "low": "1", "high": "1"}


def weighted():
    """By hand: M_0 has row sums 1, and M_1 smaller ones, in units of 1 and 2; the radius 1 is that of M_0 alone."""
    matrices = [[["1/2", "1/4"], ["0", "1"]], [["1/2", "0"], ["1/3", "1/2"]]]
    vector = {"left": False, "vector": ["1", "2"]}
    claims = [
        claim(
            "growing-vector", property="radius-lower", family=0, length=1, bound="1",
            witness={"word": [0], "sign": 1, **vector},
        ),
        claim("common-vector", property="radius-upper", family=0, length=1, bound="1", witness=vector),
        claim("meeting-bounds", [0, 1], property="bounded", family=0, witness={}, **ONE),
    ]  # fmt: skip
    return matrices_document(matrices, claims)


def column_sums():
    """By hand: columns of sum 1 and at most 1; the transposes have small row sums, and (0, 1) grows under M_0 M_0."""
    matrices = [[["1", "1/2"], ["0", "1/2"]], [["0", "1/2"], ["1/2", "1/4"]]]
    claims = [
        claim("transposed", property="transposed", family=0, part=1, witness={}),
        claim(
            "common-vector", property="radius-upper", family=1, length=1, bound="1",
            witness={"left": False, "vector": ["1", "1"]},
        ),
        claim("of-transposed", [0, 1], property="radius-upper", family=0, length=1, bound="1", witness={}),
        claim(
            "growing-vector", property="radius-lower", family=0, length=2, bound="1",
            witness={"word": [0, 0], "sign": 1, "left": True, "vector": ["1", "1"]},
        ),
        claim("meeting-bounds", [3, 2], property="bounded", family=0, witness={}, **ONE),
    ]  # fmt: skip
    return matrices_document(matrices, claims)


SELF_DUAL = [[[2, 1], [0, -2]], [[2, 0], [-1, -2]]]
"""JSR 2: with P = ((4, 1), (1, 4)) both have M' P M = 4P."""


def ellipse():
    """By hand: RADIUS.md's example of `ellipsoid`, with the eigenvector (1, -4) of -2 from below."""
    matrices = [[[str(x) for x in row] for row in m] for m in SELF_DUAL]
    claims = [
        claim(
            "growing-vector", property="radius-lower", family=0, length=1, bound="2",
            witness={"word": [0], "sign": -1, "left": False, "vector": ["1", "-4"]},
        ),
        claim(
            "ellipsoid", property="radius-upper", family=0, length=2, bound="4",
            witness={"form": [4, 1, 4], "words": [[0], [1]]},
        ),
        claim(
            "meeting-bounds", [0, 1], property="bounded", family=0, witness={},
            length=1, polynomial=["-2", "1"], low="2", high="2",
        ),
    ]  # fmt: skip
    return matrices_document(matrices, claims)


def tree_of_words():
    """By hand: the swap of 2 and 1/2, and a half: no letter is small in P = 1, the words 00, 01 and 1 are. JSR 1."""
    matrices = [[["0", "2"], ["1/2", "0"]], [["1/2", "0"], ["0", "1/2"]]]
    witness = {"form": [1, 0, 1], "words": [[0, 0], [0, 1], [1]]}
    bound = claim("ellipsoid", property="radius-upper", family=0, length=2, bound="1", witness=witness)
    return matrices_document(matrices, [bound])


def four_point_attained():
    """α = 2 and not attained; positive-symbol, holder-root, defective, not-attained."""
    return of_mask(four_point("1/16"))


def four_point_polytope():
    """w = 1/10: a polytope closes, α is a logarithm of a root of degree 4, and attained."""
    return of_mask(four_point("1/10"))


def quadratic():
    """Chaikin: α = 2, attained by a norm."""
    return of_mask(scheme([1, 3, 3, 1], over=4))


ALL_RADIUS = {
    make.__name__: make
    for make in (
        golden, monotone, monotone_enclosed, one_vertex, signed, rotation, triangular, nilpotent, enclosed,
        lower_of_blocks, swap, weighted, column_sums, ellipse, tree_of_words,
        four_point_attained, four_point_polytope, quadratic,
    )
}  # fmt: skip
