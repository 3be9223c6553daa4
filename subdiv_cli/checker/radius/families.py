"""Rules on joint spectral radii besides those of polytopes: families, their blocks, and products of their matrices."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim, Statement
from subdiv_cli.checker.matrices import Matrix, RationalFamily
from subdiv_cli.checker.reading import Rejected, require
from subdiv_cli.checker.roots import fraction_bits, isolated_root

UPPER = ("radius-upper", "radius", "bounded")


def blocks(c: Claim) -> None:
    """P^-1 M_i P are block triangular, so products have the products of the blocks: JSR is the largest of them.

    Raises Rejected where P is singular.
    """
    family, parts, sizes = c.family(), c.statement["parts"], c.witness["sizes"]
    order, basis = family.order, c.witness["basis"]
    require(len(parts) == len(sizes) >= 2 and min(sizes) >= 1, "there are not two blocks, or not as many as parts")
    require(
        sum(sizes) == order == basis.order, "the sizes of the blocks do not add up, or the basis is of another order"
    )
    bits, p = family.bits + basis.bits, basis.matrices[0]
    c.count((len(family.matrices) + 1) * order**3, (order.bit_length() + 1) * bits)
    longest = matrices.minor_bits(p)
    c.spend(8 * order**3, longest)  # two products and a division, which takes longer than they do
    c.spend(len(family.matrices) * order**3 * (longest // 512), bits)
    if (inverted := matrices.inverse(p)) is None:
        raise Rejected("the basis is not one")
    changed = [matrices.multiply(inverted[0], matrices.multiply(m, p)) for m in family.matrices]
    ends = [sum(sizes[: j + 1]) for j in range(len(sizes))]
    for m in changed:
        for first, end in zip([0, *ends], ends, strict=False):
            require(not any(any(row[first:end]) for row in m[end:]), "a matrix is not block upper triangular")
    sign = 1 if inverted[1] > 0 else -1
    for number, first, end in zip(parts, [0, *ends], ends, strict=False):
        part = [[[sign * x for x in row[first:end]] for row in m[first:end]] for m in changed]
        c.introduce(number, matrices.family(part, family.denominator * abs(inverted[1])))


def distinct(c: Claim) -> None:
    """The new family has some of the matrices, and each of them is ± one of those: products are the same up to sign."""
    family, letters = c.family(), c.witness["letters"]
    require(0 < len(letters) <= len(family.matrices), "there is no letter, or there are more than matrices")
    require(max(letters) < len(family.matrices), "a letter is not there")
    c.count(len(family.matrices) * len(letters) * family.order**2, family.bits)
    kept = [family.matrices[letter] for letter in letters]
    for number, matrix in enumerate(family.matrices):
        negative = [[-x for x in row] for row in matrix]
        require(any(each in (matrix, negative) for each in kept), f"matrix {number} is another, up to sign too")
    c.introduce(c.statement["part"], RationalFamily(kept, family.denominator))


def transposed(c: Claim) -> None:
    """The new family has the transposes: the transpose of a product is the product of the reversed word."""
    family = c.family()
    c.count(len(family.matrices) * family.order**2)
    turned = [matrices.transpose(m) for m in family.matrices]
    c.introduce(c.statement["part"], RationalFamily(turned, family.denominator))


def of_distinct(c: Claim) -> object:
    """The norms and eigenvalues of products up to sign, and so the bounds, are the same for both families."""
    return _of_part(c, "distinct")


def of_transposed(c: Claim) -> object:
    """Products and their transposes have the same eigenvalues, and norms that bound each other by a constant."""
    return _of_part(c, "transposed")


def _of_part(c: Claim, relation: str) -> object:
    """The result of the claim that says the same of the part that the claim of this relation introduces."""
    c.count(1)
    part = c.use(relation, family=c.statement["family"]).statement["part"]
    bound = {key: value for key, value in c.statement.items() if key != "property"}
    return c.use(c.statement["property"], **{**bound, "family": part}).result


def word(c: Claim) -> None:
    """JSR^ℓ >= x: the product of a word of ℓ letters has an eigenvalue of modulus >= x."""
    bound = c.statement["bound"]
    require(bound > 0, "the bound is not positive")
    total, denominator = _product(c, fraction_bits(bound), fourth_power=True)
    f = matrices.characteristic_polynomial(total)
    require(not matrices.roots_lie_inside(f, bound * denominator), "all eigenvalues of the product are smaller")


def zero(c: Claim) -> None:
    """JSR = 0: all matrices are zero."""
    family = c.family()
    c.count(len(family.matrices) * family.order**2)
    require(c.statement["bound"] == 0, "the bound is not zero")
    require(not any(any(row) for matrix in family.matrices for row in matrix), "a matrix is not zero")


def radius_of_blocks(c: Claim) -> None:
    """JSR^ℓ = Λ: it is that of a part, and all other parts have the same or a radius that is not larger."""
    c.count(1)
    root, s = isolated_root(c), c.statement
    claimed = {key: s[key] for key in ("length", "polynomial", "low", "high")}
    reached = False
    for part in c.use("blocks", family=s["family"]).statement["parts"]:
        used = c.use(*UPPER, family=part).statement
        if used["property"] != "radius-upper" and claimed.items() <= used.items():
            reached = True
        else:
            require(_powers_fit(c, used, root.low, s["length"]), f"the radius of part {part} may be larger")
    require(reached, "no part has the radius")


def upper_of_blocks(c: Claim) -> None:
    """JSR^ℓ <= x, x >= 0: so it is for all parts."""
    c.count(1)
    s = c.statement
    require(s["bound"] >= 0, "the bound is negative")
    for part in c.use("blocks", family=s["family"]).statement["parts"]:
        used = c.use(*UPPER, family=part).statement
        require(_powers_fit(c, used, s["bound"], s["length"]), f"the radius of part {part} may be larger")


def lower_of_blocks(c: Claim) -> None:
    """JSR^ℓ >= x: so it is for one of the parts."""
    c.count(1)
    s = c.statement
    parts = c.use("blocks", family=s["family"]).statement["parts"]
    used = c.use("radius-lower", length=s["length"], bound=s["bound"]).statement
    require(used["family"] in parts, "it uses radius-lower of a family that is not a part")


def bound_of(s: Statement) -> Fraction:
    """The bound x with JSR^length <= x, of a claim that bounds a radius from above."""
    bound: Fraction = s["bound" if s["property"] == "radius-upper" else "high"]
    return bound


def _powers_fit(c: Claim, used: Statement, x: Fraction, length: int) -> bool:
    """Whether y^(1/ℓ') <= x^(1/ℓ), from JSR^ℓ' <= y; both are >= 0."""
    y = bound_of(used)
    c.spend(1, fraction_bits(y) * length + fraction_bits(x) * used["length"])
    return bool(y**length <= x ** used["length"])


def defective(c: Claim) -> None:
    """Norms grow like L v^(L/ℓ), v > 0: with E = Π - s v, E y ≠ 0 = E² y, Π^r y = (s v)^r y + r (s v)^(r-1) E y."""
    v, y, sign = c.statement["value"], c.witness["vector"], c.witness["sign"]
    order = c.family().order
    require(v > 0 and sign != 0, "the value is not positive, or the sign is not 1 or -1")
    require(len(y) == order, "the vector is of another order")
    total, denominator = _product(c, fraction_bits(v) + max(map(fraction_bits, y)), fourth_power=False)
    e = [[v.denominator * x for x in row] for row in total]
    for i in range(order):
        e[i][i] -= sign * v.numerator * denominator
    once = _apply(e, y)
    require(any(once) and not any(_apply(e, once)), "the vector is not one of a chain of length 2")


def _apply(a: Matrix, y: list[Fraction] | tuple[Fraction, ...]) -> list[Fraction]:
    return [sum((x * t for x, t in zip(row, y, strict=True)), Fraction(0)) for row in a]


def _product(c: Claim, more_bits: int, fourth_power: bool) -> tuple[Matrix, int]:
    """The N×N product of the witness's word, of as many letters as the statement's length, and its denominator."""
    family, letters = c.family(), c.witness["word"]
    require(len(letters) == c.statement["length"], "the word is of another length")
    require(max(letters) < len(family.matrices), "a letter is not there")
    order = family.order
    bits = len(letters) * (family.bits + order.bit_length()) + more_bits
    work = len(letters) * order**3 + (order**4 if fourth_power else 2 * order**2)
    c.count(work, (isqrt(order) + 1 if fourth_power else 1) * bits)
    if fourth_power:  # the characteristic polynomial has numbers so long
        c.spend(4 * order**2, 2 * order * bits)
    return family.product(letters)
