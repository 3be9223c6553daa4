"""Small certificates with every rule in them, written from FORMAT.md, and the naive arithmetic their numbers need."""

from __future__ import annotations

import copy
import itertools
import json
from fractions import Fraction

PLENTY = 20_000


def q(x):
    return str(Fraction(x))


def poly(start, *coefficients, over=1):
    return {"start": start, "coefficients": [q(Fraction(c) / over) for c in coefficients]}


def claim(rule, uses=(), witness=None, work=PLENTY, property=None, **fields):
    statement = {"property": property or rule, **{key.rstrip("_"): value for key, value in fields.items()}}
    return {"rule": rule, "statement": statement, "witness": witness or {}, "uses": list(uses), "work": work}


def sobolev(uses, polynomial, low, high=None, cofactor=None):
    witness = {"cofactor": cofactor or poly(0, 1)}
    return claim("sobolev", uses, witness, polynomial=polynomial, low=q(low), high=q(high or low))


def document(arity, mask, claims):
    return {
        "format": "subdiv-certificate",
        "version": 1,
        "mask": {"kind": "scalar", "arity": arity, **mask},
        "goal": [copy.deepcopy(c["statement"]) for c in claims],
        "claims": claims,
    }


def text(certificate):
    return json.dumps(certificate)


def numbers(value, path=()):
    """The paths of all numbers in a document."""
    if isinstance(value, dict):
        for key, member in value.items():
            yield from numbers(member, (*path, key))
    elif isinstance(value, list):
        for i, member in enumerate(value):
            yield from numbers(member, (*path, i))
    elif not isinstance(value, bool) and (isinstance(value, int) or value.lstrip("-")[:1].isdigit()):
        yield path


def naive_product(f, g):
    result = [Fraction(0)] * (len(f) + len(g) - 1)
    for (i, x), (j, y) in itertools.product(enumerate(f), enumerate(g)):
        result[i + j] += x * y
    return result


def naive_norm(c, p, level):
    """max_γ Σ_β |(Π_j c(z^(p^j)))_(γ+p^L β)| with Fractions."""
    product = [Fraction(1)]
    for j in range(level):
        factor = [Fraction(0)] * ((len(c) - 1) * p**j + 1)
        factor[:: p**j] = c
        product = naive_product(product, factor)
    return max(sum(map(abs, product[g :: p**level]), Fraction(0)) for g in range(min(p**level, len(product))))


def chaikin():
    """Claims: 0 residue-sums, 1 sum-rules, 2 derived, 3 generation, 4 reproduction, 5 norm ν=2, 6 norm ν=3, 7 product,
    8 eigen-condition, 9 independent, 10 stable, 11 converges, 12 smooth, 13 not-smooth, 14 not-smooth by the sum rules,
    15 holder-lower, 16 holder-upper, 17 holder-upper by the sum rules, 18 holder-exact, 19 sobolev, 20 converges,
    21 smooth, 22 not-smooth, 23 holder-lower and 24 holder-upper by it, 25 holder-lower by ν=2, 26 sobolev-at-least,
    27 sobolev-at-most, 28 the same by the sum rules."""
    return document(
        2,
        poly(-1, 1, 3, 3, 1, over=4),
        [
            claim("residue-sums", mask=0, sums=["1", "1"]),
            claim("sum-rules", mask=0, order=3, witness={"quotient": poly(-1, "1/4")}),
            claim("derived", [1], mask=0, nu=1, symbol=poly(0, 1, 2, 1, over=2)),
            claim("generation", [1], degree=2),
            claim("reproduction", [1], degree=1),
            claim("norm", [1], mask=0, nu=2, level=1, norm="1/2"),
            claim("norm", [1], mask=0, nu=3, level=2, norm="1"),
            claim("product", [1], mask=0, word=[0], radius="1/4"),
            claim("eigen-condition", [1], nu=2, holds=True),
            claim("independent", mask=0, holds=True, witness={"cofactors": [poly(0, "3/2"), poly(1, "-1/2")]}),
            claim("stable", [9], mask=0, holds=True),
            claim("converges", [5], property="convergent", holds=True),
            claim("smooth", [5], order=1),
            claim("not-smooth", [10, 7], order=2),
            claim("not-smooth", [10, 1], order=3),
            claim("holder-lower", [6, 1], level=2, norm="1/16"),
            claim("holder-upper", [10, 7], length=1, radius="1/4"),
            claim("holder-upper", [10, 1], length=1, radius="1/8"),
            claim("holder-exact", [15, 16], property="holder", level=2, norm="1/16"),
            sobolev([10, 1], poly(0, "-1/32", 1), "1/32"),
            claim("converges", [19, 10], property="convergent", holds=True),
            claim("smooth", [19], order=1),
            claim("not-smooth", [19], order=3),
            claim("holder-lower", [19], level=2, norm="1/16"),
            claim("holder-upper", [19], length=2, radius="1/32"),
            claim("holder-lower", [5, 1], level=1, norm="1/4"),
            claim("sobolev-at-least", [15], length=2, bound="1/16"),
            claim("sobolev-at-most", [16], length=2, bound="1/32"),
            claim("sobolev-at-most", [10, 1], length=1, bound="1/8"),
        ],
    )


def four_point():
    """0 sum-rules, 1 independent, 2 stable, 3 norm ν=2, 4 norm ν=4, 5 product, 6 converges, 7 smooth, 8 not-smooth,
    9 holder-lower, 10 holder-upper, 11 product of two letters with a complex pair of
    modulus exactly 1/64, 12 eigen-condition, 13 its failure for ν=2,
    14 reproduction, 15 sobolev."""
    second = [Fraction(c, 8) for c in (-1, 2, 6, 2, -1)]
    fourth = [Fraction(c, 2) for c in (-1, 4, -1)]
    lowest = naive_norm(fourth, 2, 3)
    return document(
        2,
        poly(-3, -1, 0, 9, 16, 9, 0, -1, over=16),
        [
            claim("sum-rules", mask=0, order=4, witness={"quotient": poly(-3, -1, 4, -1, over=16)}),
            claim("independent", mask=0, holds=True, witness={"cofactors": [poly(0, 1), poly(0)]}),
            claim("stable", [1], mask=0, holds=True),
            claim("norm", [0], mask=0, nu=2, level=2, norm=q(naive_norm(second, 2, 2))),
            claim("norm", [0], mask=0, nu=4, level=3, norm=q(lowest)),
            claim("product", [0], mask=0, word=[0], radius="1/4"),
            claim("converges", [3], property="convergent", holds=True),
            claim("smooth", [3], order=1),
            claim("not-smooth", [2, 5], order=2),
            claim("holder-lower", [4, 0], level=3, norm=q(lowest / 2**9)),
            claim("holder-upper", [2, 5], length=1, radius="1/4"),
            claim("product", [0], mask=0, word=[0, 1], radius="1/64"),
            claim("eigen-condition", [0], nu=1, holds=True),
            claim("eigen-condition", [0], nu=2, holds=False),
            claim("reproduction", [0], degree=3),
            sobolev([2, 0], poly(0, -1, -40, 2048), "339/10000", "34/1000", poly(0, "1/512", 1)),
        ],
    )


def unstable():
    """(1, 1, 1, 1)/2: 0 sum-rules, 1 dependent, 2 unstable, 3 product, 4 norm, 5 eigen-condition, 6 converges,
    7 reduction to the hat function, 8 its sum-rules, 9 norm, 10 smooth, 11 independent, 12 stable, 13 product,
    14 not-smooth, 15 norm, 16 holder-lower, 17 holder-upper, 18 holder-exact, 19 sobolev,
    20 values through the reduction, 21 values by S's own convergence."""
    return document(
        2,
        poly(0, 1, 1, 1, 1, over=2),
        [
            claim("sum-rules", mask=0, order=1, witness={"quotient": poly(0, 1, 0, 1, over=2)}),
            claim("dependent", property="independent", mask=0, holds=False, witness={"factor": poly(0, 1, 1)}),
            claim("unstable", property="stable", mask=0, holds=False, witness={"factor": poly(0, 1, 1)}),
            claim("product", [0], mask=0, word=[0, 1], radius="1/4"),
            claim("norm", [0], mask=0, nu=1, level=2, norm="1/2"),
            claim("eigen-condition", [0], nu=0, holds=True),
            claim("converges", [4], property="convergent", holds=True),
            claim("reduction", from_=0, to=1, witness={"factor": poly(0, 1, 1), "mask": poly(0, 1, 2, 1, over=2)}),
            claim("sum-rules", mask=1, order=2, witness={"quotient": poly(0, "1/2")}),
            claim("norm", [8], mask=1, nu=1, level=1, norm="1/2"),
            claim("smooth", [9, 7], order=0),
            claim("independent", mask=1, holds=True, witness={"cofactors": [poly(0), poly(0, 1)]}),
            claim("stable", [11], mask=1, holds=True),
            claim("product", [8], mask=1, word=[0], radius="1/2"),
            claim("not-smooth", [12, 13, 7], order=1),
            claim("norm", [8], mask=1, nu=2, level=1, norm="1"),
            claim("holder-lower", [15, 8, 7], level=1, norm="1/2"),
            claim("holder-upper", [12, 13, 7], length=1, radius="1/2"),
            claim("holder-exact", [16, 17], property="holder", level=1, norm="1/2"),
            sobolev([12, 8, 7], poly(0, -1, 8), "1/8"),
            claim("values", [9, 7], {"values": poly(1, 1)}, order=0, values=poly(1, 1, 1, over=2)),
            claim("values", [4], order=0, values=poly(1, 1, 1, over=2)),
        ],
    )


def cycle():
    """1 + z^3: 0 dependent, 1 unstable, 2 reduction to the Haar function, 3 independent, 4 stable, 5 sum-rules,
    6 norm, 7 product, 8 not-smooth by the product, 9 holder-upper, 10 diverges as φ is not continuous."""
    return document(
        2,
        poly(5, 1, 0, 0, 1),
        [
            claim("dependent", property="independent", mask=0, holds=False, witness={"cycle": 3}),
            claim("unstable", property="stable", mask=0, holds=False, witness={"cycle": 3}),
            claim("reduction", from_=0, to=1, witness={"factor": poly(0, 1, 1, 1), "mask": poly(5, 1, 1)}),
            claim("independent", mask=1, holds=True, witness={"cofactors": [poly(0), poly(-2, 1)]}),
            claim("stable", [3], mask=1, holds=True),
            claim("sum-rules", mask=1, order=1, witness={"quotient": poly(5, 1)}),
            claim("norm", [5], mask=1, nu=1, level=1, norm="1"),
            claim("product", [5], mask=1, word=[0], radius="1"),
            claim("not-smooth", [4, 7, 2], order=0),
            claim("holder-upper", [4, 7, 2], length=1, radius="1"),
            claim("diverges", [8], property="convergent", holds=False),
        ],
    )


def off_circle():
    """(1+z)²(2+z²)/6: the components share the zero -2. 0 dependent, 1 stable by the gcd, 2 sum-rules."""
    return document(
        2,
        poly(0, 2, 4, 3, 2, 1, over=6),
        [
            claim("dependent", property="independent", mask=0, holds=False, witness={"factor": poly(0, 2, 1)}),
            claim("stable", mask=0, holds=True, witness={"gcd": poly(0, 2, 1), "cofactors": [poly(0), poly(0, 3)]}),
            claim("sum-rules", mask=0, order=2, witness={"quotient": poly(0, 2, 0, 1, over=6)}),
        ],
    )


def divergent():
    """(1, 1, 1)/2 has the residue sums 1, 1/2; 0 residue-sums, 1 sum-rules, 2 generation, 3 diverges."""
    return document(
        2,
        poly(0, 1, 1, 1, over=2),
        [
            claim("residue-sums", mask=0, sums=["1", "1/2"]),
            claim("sum-rules", mask=0, order=0, witness={"quotient": poly(0, 1, 1, 1, over=2)}),
            claim("generation", [1], degree=-1),
            claim("diverges", [0], property="convergent", holds=False),
            claim("reproduction", [1], degree=-1),
        ],
    )


def overshooting():
    """(1+z)(3-z)/2: D = (3-z)/2 has the product T_0 = 3/2. 0 sum-rules, 1 product, 2 diverges by it,
    3 eigen-condition, 4 diverges by that."""
    return document(
        2,
        poly(0, 3, 2, -1, over=2),
        [
            claim("sum-rules", mask=0, order=1, witness={"quotient": poly(0, 3, -1, over=2)}),
            claim("product", [0], mask=0, word=[0], radius="3/2"),
            claim("diverges", [1], property="convergent", holds=False),
            claim("eigen-condition", [0], nu=0, holds=False),
            claim("diverges", [3], property="convergent", holds=False),
        ],
    )


def ternary():
    """The quadratic ternary B-spline (1+z+z²)³/9: 0 sum-rules, 1 norm ν=2, 2 converges, 3 smooth, 4 independent,
    5 stable, 6 norm ν=3, 7 product, 8 not-smooth, 9 holder-lower, 10 holder-upper, 11 holder-exact, 12 converges and
    13 smooth by the norm of ν=3, 14 eigen-condition, 15 sobolev."""
    components = [poly(0), poly(1, -1), poly(1, 2)]
    return document(
        3,
        poly(-3, 1, 3, 6, 7, 6, 3, 1, over=9),
        [
            claim("sum-rules", mask=0, order=3, witness={"quotient": poly(-3, "1/9")}),
            claim("norm", [0], mask=0, nu=2, level=1, norm="1/3"),
            claim("converges", [1], property="convergent", holds=True),
            claim("smooth", [1], order=1),
            claim("independent", mask=0, holds=True, witness={"cofactors": components}),
            claim("stable", [4], mask=0, holds=True),
            claim("norm", [0], mask=0, nu=3, level=1, norm="1"),
            claim("product", [0], mask=0, word=[0], radius="1/9"),
            claim("not-smooth", [5, 7], order=2),
            claim("holder-lower", [6, 0], level=1, norm="1/9"),
            claim("holder-upper", [5, 7], length=1, radius="1/9"),
            claim("holder-exact", [9, 10], property="holder", level=1, norm="1/9"),
            claim("converges", [6], property="convergent", holds=True),
            claim("smooth", [6], order=1),
            claim("eigen-condition", [0], nu=1, holds=True),
            sobolev([5, 0], poly(0, -1, 243), "1/243"),
        ],
    )


def cubic():
    """The cubic B-spline: 0 sum-rules, 1 norm ν=1, 2 norm ν=2, 3 norm ν=3, 4 converges, 5, 6, 7 values of φ, φ', φ'',
    8 quasi-interpolation, 9 error-bound, 10 levels, 11 error-bound of S_2, 12 hermite-bound, 13 norm ν=1 at level 2,
    14 error-bound at level 2."""
    return document(
        2,
        poly(-2, 1, 4, 6, 4, 1, over=8),
        [
            claim("sum-rules", mask=0, order=4, witness={"quotient": poly(-2, "1/8")}),
            claim("norm", [0], mask=0, nu=1, level=1, norm="1/2"),
            claim("norm", [0], mask=0, nu=2, level=1, norm="1/2"),
            claim("norm", [0], mask=0, nu=3, level=1, norm="1/2"),
            claim("converges", [1], property="convergent", holds=True),
            claim("values", [3], order=0, values=poly(-1, 1, 4, 1, over=6)),
            claim("values", [3], order=1, values=poly(-1, 1, 0, -1, over=2)),
            claim("values", [3], order=2, values=poly(-1, 1, -2, 1)),
            claim(
                "quasi-interpolation",
                [4, 5, 0],
                degree=3,
                operator=["1", "0", "-1/6", "0"],
                stencil=poly(-1, -1, 8, -1, over=6),
            ),
            claim("error-bound", [0, 1], nu=0, level=1, norm="1/2", constant="1/2"),
            claim("levels", [9], tolerance="1/1000", levels=9),
            claim("error-bound", [0, 3], nu=2, level=1, norm="1/2", constant="1"),
            claim("hermite-bound", [11, 2], order=2, constant="1/4"),
            claim("norm", [0], mask=0, nu=1, level=2, norm="1/4"),
            claim("error-bound", [0, 1, 13], nu=0, level=2, norm="1/4", constant="2/3"),
        ],
    )


ALL = {
    make.__name__: make
    for make in (chaikin, four_point, unstable, cycle, off_circle, divergent, overshooting, ternary, cubic)
}
