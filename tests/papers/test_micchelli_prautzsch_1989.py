"""Micchelli & Prautzsch 1989, Uniform refinement of curves (Linear Algebra Appl. 114/115, 841-870).

Its examples and theorems, and the exponents of curves by von Koch, Takagi, Landsberg, Lebesgue and de Rham.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from math import comb

import numpy as np
import pytest
from flint import fmpq_mat

from subdiv_cli.catalog import masks_directory
from subdiv_cli.exact.closed import digits
from subdiv_cli.exact.linalg import matrix, nullspace
from subdiv_cli.exact.rationals import to_fmpq
from subdiv_cli.kinds.matrices.numbers.matrices import MatrixNumbers
from subdiv_cli.kinds.matrices.numbers.patterns import patterns
from subdiv_cli.kinds.matrices.scheme import MatrixFamily
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.maskfile.closed import read_closed_form
from subdiv_cli.model import INFINITY, Effort, Result, Smoothness, Verdict
from subdiv_cli.pipeline import check
from subdiv_cli.spaces.closure import invariant_space

Q = Fraction


def shipped(name: str, **parameters: str) -> MatrixFamily:
    """A shipped scheme at these values of its parameters."""
    file = read_path(masks_directory() / "matrices" / f"{name}.toml")
    scheme = file.scheme({key: Q(value) for key, value in parameters.items()})
    assert isinstance(scheme, MatrixFamily)
    return scheme


def answer(scheme: MatrixFamily) -> Result:
    return check(scheme, (), Effort()).result


CURVES = {
    ("corner_cutting_5_8_1_8", ()): ("log2(8/3)", 1, 1, "3/8"),
    ("corner_cutting_5_8_1_8", (("r", "7/10"), ("s", "1/5"))): ("log2(10/3)", 1, 1, "3/10"),
    ("takagi", ()): ("1", 0, 1, "1/2"),
    ("takagi", (("a", "1/8"),)): ("1", 0, 1, "1/8"),
    ("takagi", (("a", "3/4"),)): ("log2(4/3)", 0, 1, "3/4"),
    ("lebesgue_de_rham_1_3", ()): ("log2(3/2)", 0, 0, "2/3"),
    ("koch", ()): ("log2(3)/2", 0, 0, "1/3"),
    ("four_point_segment", ()): ("2", 1, 3, "1/4"),
    ("counterexamples/polygon", ()): ("1", 0, 1, "0"),
}
"""The exponent, n with C^n and not C^(n+1), the degree of the polynomials, and the radius inside the pieces."""


@pytest.mark.parametrize(("name", "parameters"), CURVES)
def test_exponents(name: str, parameters: tuple[tuple[str, str], ...]) -> None:
    alpha, n, degree, inside = CURVES[name, parameters]
    result = answer(shipped(name, **dict(parameters)))
    assert result.holder is not None
    assert result.holder.exact == read_closed_form(alpha)
    assert result.smoothness == Smoothness(n, sharp=True)
    assert result.polynomials == degree
    (found,) = (f for f in result.findings if f.code == "SD814")
    root = found.witness.get("root", {"low": found.witness.get("bound")})
    assert root["low"] == Q(inside)  # type: ignore[index,call-overload]


def test_the_digits_of_de_rham_s_trisection() -> None:
    """The radius is the root of 81x^2 - 27x + 1 to the power 1/2, of B_1 B_0."""
    result = answer(shipped("de_rham_1_3"))
    assert result.holder is not None
    assert result.holder.exact is not None
    assert (digits(result.holder.exact) or "").startswith("0.890720587")
    (found,) = (f for f in result.findings if f.code == "SD814")
    assert found.witness["word"] == (0, 1)


def test_takagi_s_corners_are_at_the_joints() -> None:
    """Inside the pieces differences of a = 1/8 decay like those of a C^3 function: the radius 1/8 says too much."""
    result = answer(shipped("takagi", a="1/8"))
    found = {f.code: f for f in result.findings}
    assert "ρ = 1/8" in found["SD814"].statement
    assert found["SD815"].verdict is Verdict.REFUTED
    assert found["SD815"].witness["orders"] == (1,)
    assert answer(shipped("takagi", a="1/4")).smoothness.order == INFINITY  # the parabola 2x(1-x)


@pytest.mark.parametrize(
    ("name", "degree"),
    [("de_casteljau_2", 2), ("de_casteljau_3", 3), ("de_casteljau_4_in_3", 4), ("lane_riesenfeld_2", 2),
     ("lane_riesenfeld_3", 3), ("lane_riesenfeld_4", 4)],
)  # fmt: skip
def test_polynomials_and_theorem_7_1(name: str, degree: int) -> None:
    """B_i = U_i D U_i^-1 with U_i = U_0 T(-i/(p-1)): as T is printed, T(i/(p-1)) is wrong."""
    scheme = shipped(name)
    result = answer(scheme)
    assert result.smoothness == Smoothness(INFINITY, sharp=True)
    assert result.holder is not None
    assert (result.holder.exact, result.polynomials) == (INFINITY, degree)
    numbers = MatrixNumbers(scheme, Effort())
    p, n = numbers.p, numbers.n
    q = matrix(numbers.curve.components.polygons)  # q ψ = (1, x, …), so that ψ = q^-1 (1, x, …)
    d = fmpq_mat(n, n, [to_fmpq(Q(i == j, p**i)) for i in range(n) for j in range(n)])

    def printed(a: Fraction) -> fmpq_mat:
        return matrix([[(-a) ** (i - j) * comb(i, j) if j <= i else Q(0) for j in range(n)] for i in range(n)])

    def holds(sign: int) -> bool:
        each = [q.inv() * printed(Q(sign * i, p - 1)) for i in range(p)]
        return all(u * d * u.inv() == b for u, b in zip(each, numbers.operators, strict=True))

    assert holds(-1)
    assert not holds(1)
    assert [matrix(u) for u in numbers.curve.components.fixed_points()] == [printed(Q(-i, p - 1)) for i in range(p)]


@pytest.mark.parametrize("name", ["corner_cutting_5_8_1_8", "de_rham_1_3", "takagi", "koch", "four_point_segment"])
def test_the_chain_of_theorem_5_2(name: str) -> None:
    """S^(δ+1) is the invariant closure of p^δ B_i f - f for the derivative f of order δ: condition (c) and (d)."""
    numbers = MatrixNumbers(shipped(name), Effort())
    assert numbers.radius is not None
    curve, p = numbers.curve, numbers.p
    vectors = [numbers.ends[0]]
    for order in range(1, curve.components.degree + 1):
        if numbers.radius.is_below(Q(1, p**order)):
            vectors.append(curve.jet(order).left)
    for order, f in enumerate(vectors):
        column = fmpq_mat([[to_fmpq(x)] for x in f])
        steps = [b * column * p**order - column for b in numbers.operators]
        space = invariant_space(numbers.operators, fmpq_mat([x.transpose().tolist()[0] for x in steps]))
        assert space is not None
        expected = matrix(nullspace(matrix([*curve.components.polygons[: order + 1], *curve.annihilator])))
        assert space.dimension == curve.span.dimension - order - 1 == expected.nrows()
        assert fmpq_mat([*space.basis.tolist(), *expected.tolist()]).rank() == space.dimension


def test_corollary_6_1() -> None:
    """A curve in C^l has all polynomials of degree l among its components, and no more than n independent ones."""
    for file in sorted((masks_directory() / "matrices").glob("*.toml")):
        result = answer(read_path(file).scheme({}))
        order = result.smoothness.order
        assert order is not None
        assert result.polynomials is not None
        assert order == INFINITY or order <= result.polynomials


def test_theorem_2_1_by_all_products() -> None:
    """The least k is that of all products, and the cycle has none with a positive column."""
    for name in ("de_casteljau_3", "lane_riesenfeld_4", "corner_cutting_5_8_1_8", "lebesgue_de_rham_1_3"):
        scheme = shipped(name)
        found = patterns(scheme.matrices, Effort())
        assert found is not None
        assert found.length is not None
        least = next(k for k in range(1, 9) if _all_positive(scheme, k))
        assert least <= found.length
        assert found.corollary is not None or least == found.length
        assert found.length == len(scheme.matrices[0]) - 1 or found.corollary is None
    cycle = shipped("counterexamples/cycle")
    found = patterns(cycle.matrices, Effort())
    assert found is not None
    assert found.length is None
    word = np.eye(3)
    for letter in found.cycle:
        word = np.array(cycle.matrices[letter], dtype=float) @ word
    assert all(not (np.linalg.matrix_power(word, k) > 0).all(axis=0).any() for k in range(1, 20))
    assert all((np.linalg.matrix_power(np.array(a, dtype=float), 5) > 0).all(axis=0).any() for a in cycle.matrices)
    assert answer(cycle).convergent is Verdict.REFUTED


def _all_positive(scheme: MatrixFamily, k: int) -> bool:
    arrays = [np.array(a, dtype=float) for a in scheme.matrices]
    total = (np.linalg.multi_dot([*word, np.eye(len(arrays[0]))]) for word in product(arrays, repeat=k))
    return all((x > 0).all(axis=0).any() for x in total)


def test_theorem_3_1() -> None:
    """Pieces that do not meet: the two expansions of 1/2 have the limits c/3 and 2c/3."""
    result = answer(shipped("counterexamples/cantor"))
    assert (result.convergent, result.well_defined) == (Verdict.PROVED, Verdict.REFUTED)
    assert (result.smoothness, result.holder, result.polynomials) == (Smoothness(), None, None)


def test_the_exponent_is_that_of_the_scalar_scheme() -> None:
    """The four-point scheme, Deslauriers-Dubuc 6 and de Rham's: the segment has the exponent of φ."""
    masks = {
        "2": [Q(x, 16) for x in (-1, 0, 9, 16, 9, 0, -1)],
        "log2(64/9)": [Q(x, 256) for x in (3, 0, -25, 0, 150, 256, 150, 0, -25, 0, 3)],
        "log2(5/3)": [Q(x, 5) for x in (1, 4, 4, 1)],
    }
    for alpha, mask in masks.items():
        places = range(-(len(mask) - 2), 1)
        rows = [[mask[i - 2 * j] if 0 <= i - 2 * j < len(mask) else Q(0) for j in places] for i in (*places, 1)]
        scheme = MatrixFamily(tuple(tuple(map(tuple, piece)) for piece in (rows[:-1], rows[1:])))
        result = answer(scheme)
        assert result.holder is not None
        assert result.holder.exact == read_closed_form(alpha)
