"""The exponent of a curve by another exact route: all differences, inside the pieces and across the joints.

On pairs (v, v') of two neighbouring pieces let C(v, v') = (B_(p-1) v, B_0 v') and D_i (v, v') = B_i v + B_(i+1) v'.
P is the smallest C-invariant space with the differences of order k that straddle a joint, modulo the pairs with
D_i C^n = 0 for all i and n; V_k the smallest B-invariant space with the differences inside [0, 1] and all D_i P. Then
the exponent is the smaller one of -log_p JSR(B | V_k) and -log_p ρ(C | P), as soon as that is below k. Nothing of
polynomial components or of derivatives is used.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from math import comb

import pytest
from flint import fmpq_mat
from matrix_families import segment, structured
from support import cases, seeded

from subdiv_cli.catalog import masks_directory
from subdiv_cli.exact.linalg import identity
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.products import WordProduct
from subdiv_cli.jsr.radius import joint_spectral_radius
from subdiv_cli.kinds.matrices.numbers.components import smallest_level
from subdiv_cli.kinds.matrices.numbers.curve import on_grid
from subdiv_cli.kinds.matrices.numbers.matrices import MatrixNumbers
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import INFINITY, Effort, Verdict
from subdiv_cli.model.order import enclosure
from subdiv_cli.pipeline import check

Columns = list[fmpq_mat]


def joined(parts: Sequence[fmpq_mat]) -> fmpq_mat:
    """Columns beside each other."""
    return fmpq_mat([[x for part in parts for x in part.tolist()[i]] for i in range(parts[0].nrows())])


def stacked(a: fmpq_mat, b: fmpq_mat) -> fmpq_mat:
    return fmpq_mat([*a.tolist(), *b.tolist()])


def closure(vectors: Columns, operators: Sequence[fmpq_mat]) -> Columns:
    """A basis of the smallest space with these columns that the operators map into itself."""
    basis: Columns = []
    waiting = list(vectors)
    while waiting:
        v = waiting.pop()
        if joined([*basis, v]).rank() > len(basis):
            basis.append(v)
            waiting += [m * v for m in operators]
    return basis


def restricted(operators: Sequence[fmpq_mat], basis: Columns) -> list[fmpq_mat]:
    """The operators in this basis."""
    b = joined(basis)
    left = (b.transpose() * b).inv() * b.transpose()
    found = [left * (m * b) for m in operators]
    assert all(b * x == m * b for x, m in zip(found, operators, strict=True))
    return found


def exponent(numbers: MatrixNumbers, k: int) -> tuple[float, float]:
    """The numbers -log_p JSR(B | V_k), a bound where it is enclosed, and -log_p ρ(C | P); infinite where it is 0."""
    b, p, n = numbers.operators, numbers.p, numbers.n
    level = smallest_level(p, k + 1)
    points = on_grid(b, *numbers.ends, level)
    weights = [(-1) ** (k - j) * comb(k, j) for j in range(k + 1)]
    zero = points[0] * 0
    inside = [sum((w * points[i + j] for j, w in enumerate(weights)), zero) for i in range(len(points) - k)]
    pairs = []
    for q in range(1, k):  # the joint is point q of the difference
        v = sum((weights[j] * points[len(points) - 1 - (q - j)] for j in range(q)), zero)
        pairs.append(stacked(v, sum((weights[j] * points[j - q] for j in range(q, k + 1)), zero)))
    empty = identity(n) * 0
    c = stacked(joined([b[-1], empty]), joined([empty, b[0]]))
    across = [joined([b[i], b[i + 1]]) for i in range(p - 1)]
    straddling = closure(pairs, [c])
    space = closure([*inside, *(d * x for d in across for x in straddling)], b)
    space = [v for v in space if any(v.entries())]
    if not space:
        return math.inf, math.inf
    radius = joint_spectral_radius(Family(restricted(b, space)), Effort(4000))
    assert radius is not None
    size = 0.0 if not radius.upper[1] else float(radius.upper[1]) ** (1 / radius.upper[0])
    # modulo the null pairs: the coordinates r x for all functionals r in the rows of D_i C^n
    seen = closure([row.transpose() for d in across for row in rows(d)], [c.transpose()])
    r = joined(seen).transpose()
    moved = restricted([c.transpose()], seen)[0].transpose()  # r c = moved r
    quotient = [v for v in closure([r * x for x in pairs], [moved]) if any(v.entries())]
    if not quotient:
        return _log(size, p), math.inf
    product = WordProduct.of_word(restricted([moved], quotient), (0,))
    return _log(size, p), _log(float(product.eigenvalue.modulus().mid()), p)


def rows(a: fmpq_mat) -> Columns:
    return [fmpq_mat([row]) for row in a.tolist()]


def _log(x: float, p: int) -> float:
    return math.inf if x < 1e-12 else -math.log(x) / math.log(p)


def agrees(numbers: MatrixNumbers) -> str | None:
    """What sort of curve it is, where both routes decide; they agree."""
    result = check(numbers.scheme, (), Effort(4000)).result
    if result.well_defined is not Verdict.PROVED or result.holder is None or result.holder.exact is None:
        return None
    assert result.polynomials is not None
    for k in (result.polynomials + 2, result.polynomials + 3):
        inside, joints = exponent(numbers, k)
        if result.holder.exact == INFINITY:
            assert (inside, joints) == (math.inf, math.inf)
        else:
            assert abs(min(inside, joints) - float(enclosure(result.holder.exact)[0])) < 1e-9, (inside, joints)
    if result.holder.exact == INFINITY:
        return "polynomial"
    return "corner" if joints < inside - 1e-9 else "inside"


@pytest.mark.parametrize("file", sorted((masks_directory() / "matrices").rglob("*.toml")), ids=lambda file: file.stem)
def test_shipped_curves(file) -> None:
    agrees(MatrixNumbers(read_path(file).scheme({}), Effort(4000)))


def test_random_curves() -> None:
    count = cases(24)
    built = ((structured, segment)[k % 3 == 2](seeded(3000 + k)).scheme for k in range(count))
    mix = Counter(agrees(MatrixNumbers(scheme, Effort(4000))) for scheme in built)
    for sort, least in (("corner", 0.2), ("inside", 0.15), ("polynomial", 0.03)):
        assert mix[sort] >= least * count, mix


def test_the_numbers_of_takagi_and_of_the_trisection() -> None:
    """Inside 1/8 and at the joints 1/2; inside the root of 81x^2 - 27x + 1 to the power 1/2, at the joints 1/3."""
    folder = masks_directory() / "matrices"
    corners = MatrixNumbers(read_path(folder / "counterexamples" / "takagi_landsberg_1_8.toml").scheme({}), Effort())
    assert exponent(corners, 3) == pytest.approx((3, 1))
    trisection = MatrixNumbers(read_path(folder / "de_rham_1_3.toml").scheme({}), Effort())
    assert exponent(trisection, 3) == pytest.approx((0.890720587, math.log2(3)))
    cut = MatrixNumbers(read_path(folder / "corner_cutting_5_8_1_8.toml").scheme({}), Effort())
    assert exponent(cut, 3) == pytest.approx((math.log2(8 / 3), math.log2(8 / 3)))
