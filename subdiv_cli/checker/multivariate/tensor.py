"""Tensor products of masks on Z^s: factors with certificates of their own, and what follows. See FORMAT.md.

a(z) = Π_j a_j(z_(P_j)) over a partition of the variables for which M is block diagonal, the coefficients of a_j adding
up to m_j = |det M_j|. Then φ is the product of the φ_j.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import NamedTuple

from subdiv_cli.checker.core import Claim, Statement, Subject, read_statement
from subdiv_cli.checker.multivariate.lattice import Sparse
from subdiv_cli.checker.multivariate.masks import SparseMask, mask_of
from subdiv_cli.checker.numerals import UnreadableError
from subdiv_cli.checker.reading import Exhausted, Fields, Rejected, record, require
from subdiv_cli.checker.roots import fraction_bits
from subdiv_cli.checker.scalar.masks import Symbols

MAX_BETWEEN = 1000
"""The largest number between exponents, and its largest denominator."""


_EXPONENTS: tuple[Fields, ...] = (
    {"level": "natural", "norm": "rational"},
    {"length": "length", "radius": "rational"},
    {"length": "length", "bound": "rational"},
    {"length": "length", "polynomial": "root", "low": "rational", "high": "rational"},
    {"polynomial": "polynomial", "low": "rational", "high": "rational"},
    {"value": "rational"},
)
"""Fields of statements on exponents, in masks of all kinds, besides their property."""


def exponent(value: object) -> Statement:
    """The statement on an exponent that a value is; which ones there are, the rule knows.

    Raises UnreadableError for any other value.
    """
    if type(value) is not dict or type(value.get("property")) is not str:
        raise UnreadableError("is no statement")
    keys = value.keys() - {"property"}
    fields = next((fields for fields in _EXPONENTS if fields.keys() == keys), _EXPONENTS[0])
    if value["property"] == "holder-value":
        fields = {"value": "natural"}
    statement: Statement = record({"property": "any", **fields})(value)
    return statement


class _Factor(NamedTuple):
    variables: tuple[int, ...]
    certificate: int
    goal: list[Statement]
    """The statements that its certificate proves."""
    cosets: int
    """The number m_j of its cosets."""

    def says(self, name: str, holds: Callable[[Statement], bool]) -> bool:
        return any(s["property"] == name and holds(s) for s in self.goal)


def tensor_product(c: Claim) -> list[_Factor]:
    """The certificates verify, their masks have the sums m_j, and their product is the mask."""
    a, parts, which = mask_of(c), c.statement["parts"], c.witness["which"]
    documents = c.witness["certificates"]
    s = a.dilation.dimension
    require(len(parts) >= 2, "there is only one factor")
    require(sorted(i for part in parts for i in part) == list(range(s)), "the variables are not in one factor each")
    require(all(list(part) == sorted(part) for part in parts), "the variables of a factor are not in order")
    require(len(which) == len(parts), "there is not one certificate for each factor")
    require(sorted({*which}) == list(range(len(documents))), "a certificate is missing, or not used")
    c.count(sum(map(_stated_work, documents)) + len(a.terms) * (s + 1), a.bits)
    proved = [_verified(c, number, document) for number, document in enumerate(documents)]
    factors: list[_Factor] = []
    product: Sparse = {(): 1}
    denominator = 1
    for variables, number in zip(parts, which, strict=True):
        subject, goal = proved[number]
        block = [[a.dilation.rows[i][j] for j in variables] for i in variables]
        terms, common, rows = _mask(subject)
        require(rows == block, f"the dilation of certificate {number} is another")
        require(sum(terms.values()) == subject.letters * common, f"the mask of certificate {number} has another sum")
        factors.append(_Factor(variables, number, goal, subject.letters))
        require(len(product) * len(terms) <= len(a.terms), "the factors have too many terms")
        c.spend(len(product) * len(terms), common.bit_length() + denominator.bit_length())
        product = {(*x, *y): p * q for x, p in product.items() for y, q in terms.items()}
        denominator *= common
    order = [i for part in parts for i in part]
    same = all(not a.dilation.rows[i][j] for part in parts for i in part for j in order if j not in part)
    require(same, "the dilation is not block diagonal")
    moved = {tuple(x[order.index(i)] for i in range(s)): value for x, value in product.items()}
    same = moved.keys() == a.terms.keys()
    same = same and all(value * a.denominator == a.terms[x] * denominator for x, value in moved.items())
    require(same, "the product of the factors is not the mask")
    return factors


def _stated_work(document: object) -> int:
    """The work that all claims of a certificate state, whether it is one or not."""
    claims = document.get("claims") if type(document) is dict else None
    if type(claims) is not list or any(type(claim) is not dict for claim in claims):
        raise Rejected("a certificate is none")
    works = [claim.get("work") for claim in claims]
    require(all(type(work) is int and work >= 0 for work in works), "a certificate has a claim without its work")
    return sum(works)


def _verified(c: Claim, number: int, document: object) -> tuple[Subject, list[Statement]]:
    outcome, rulebook, subject = c.check_inside(document)
    if subject is None or rulebook is None or not outcome.verified:
        raise (Exhausted if outcome.exhausted else Rejected)(f"certificate {number}: {outcome.line}"[:300])
    return subject, [read_statement(statement, rulebook) for statement in outcome.statements]


def _mask(subject: Subject) -> tuple[Sparse, int, list[list[int]]]:
    """The numerators of a factor's mask, their denominator, and the rows of its dilation."""
    about = subject.about
    if isinstance(about, SparseMask):
        return about.terms, about.denominator, about.dilation.rows
    if not isinstance(about, Symbols):
        raise Rejected("a certificate is about no mask")
    terms: Sparse = {(i,): x for i, x in enumerate(about[0].numerators, about[0].start) if x}
    return terms, about[0].denominator, [[subject.letters]]


def _factors(c: Claim) -> Sequence[_Factor]:
    factors: Sequence[_Factor] = c.use("tensor-product").result
    c.count(len(factors))
    return factors


def converges(c: Claim) -> None:
    """Convergence of all factors, or divergence of one."""
    factors, holds = _factors(c), c.statement["holds"]
    certified = [factor.says("convergent", lambda s: s["holds"] == holds) for factor in factors]
    require(all(certified) if holds else any(certified), "the factors do not say so")


def stable(c: Claim) -> None:
    """S converges; stability of all φ_j, or instability of one. Of a scalar mask: of the mask itself, number 0."""
    factors, holds = _factors(c), c.statement["holds"]
    c.use("convergent", holds=True)
    certified = [factor.says("stable", lambda s: s["holds"] == holds and not s.get("mask", 0)) for factor in factors]
    require(all(certified) if holds else any(certified), "the factors do not say so")


def smooth(c: Claim) -> None:
    """φ is C^n: all φ_j are."""
    n = c.statement["order"]
    certified = [factor.says("smooth", lambda s: s["order"] >= n) for factor in _factors(c)]
    require(all(certified), "a factor is not known to be so smooth")


def not_smooth(c: Claim) -> None:
    """φ is not C^n: one φ_j is not."""
    n = c.statement["order"]
    certified = [factor.says("not-smooth", lambda s: s["order"] <= n) for factor in _factors(c)]
    require(any(certified), "no factor is known not to be so smooth")


def of_factor(c: Claim) -> None:
    """The exponent of φ, or its bound from below, is that of φ_j: it is positive, and the least."""
    factors, statement = _factors(c), c.statement["statement"]
    factor = _speaker(c, factors)
    require(statement["property"] in _HOLDER + _SOBOLEV, "the statement is not on an exponent, or only from above")
    require(_is_positive(statement), "the exponent is not seen to be positive")
    others = [other for other in factors if other.certificate != factor.certificate]
    require(bool(others) == ("between" in c.witness), "there is a number between where none is needed, or none")
    if others:
        _require_least(c, statement, factor, others)


def at_most_factor(c: Claim) -> None:
    """The exponent of φ is at most the number that is claimed of φ_j: it is never larger than that of φ_j."""
    _speaker(c, _factors(c))
    require(c.statement["statement"]["property"] in _ABOVE, "the statement does not bound an exponent from above")


def _speaker(c: Claim, factors: Sequence[_Factor]) -> _Factor:
    """The factor whose certificate proves the statement."""
    factor = next((factor for factor in factors if factor.variables == c.statement["variables"]), None)
    if factor is None:
        raise Rejected("there is no factor in these variables")
    require(c.statement["statement"] in factor.goal, "the certificate of the factor does not prove the statement")
    return factor


_HOLDER = ("holder-lower", "holder", "holder-root", "holder-value")
_SOBOLEV = ("sobolev", "sobolev-lower", "sobolev-value", "sobolev-at-least")
_ABOVE = (
    "holder-upper", "holder", "holder-root", "holder-value", "sobolev", "sobolev-value", "sobolev-at-most",
)  # fmt: skip


def _require_least(c: Claim, statement: Statement, factor: _Factor, others: Sequence[_Factor]) -> None:
    """Check that the exponent of the factor is at most r, and those of the others are at least r."""
    r = c.witness["between"]
    require(0 < r <= MAX_BETWEEN and r.denominator <= MAX_BETWEEN, "the number between is out of range")
    require(_is_at_most(c, statement, factor, r), "the exponent is not seen to be at most the number between")
    kinds = _SOBOLEV if statement["property"] in _SOBOLEV else _HOLDER
    for other in others:
        bounds = [s for s in other.goal if s["property"] in kinds]
        require(any(_is_at_least(c, s, other, r) for s in bounds), "another factor may have a smaller exponent")


def _is_positive(s: Statement) -> bool:
    return bool(s["value"] > 0 if "value" in s else 0 < _ends(s)[1] < 1)


def _is_at_least(c: Claim, s: Statement, factor: _Factor, r: Fraction) -> bool:
    if "value" in s:
        return bool(s["value"] >= r)
    _, high, length = _ends(s)
    return high > 0 and _power(c, high, length, factor, r) <= 1


def _is_at_most(c: Claim, s: Statement, factor: _Factor, r: Fraction) -> bool:
    if "value" in s:
        return bool(s["value"] <= r)
    low, _, length = _ends(s)
    return low > 0 and _power(c, low, length, factor, r) >= 1


def _ends(s: Statement) -> tuple[Fraction, Fraction, int]:
    """The numbers low, high and ℓ of a statement on -log_λ(x)/ℓ, low <= x <= high."""
    if "low" in s:
        return s["low"], s["high"], s.get("length", 2)
    x = s["norm"] if "norm" in s else s["bound"]
    return x, x, s["level"] if "norm" in s else s["length"]


def _power(c: Claim, x: Fraction, length: int, factor: _Factor, r: Fraction) -> Fraction:
    """The number (x λ^(ℓr))^(v s) for r = u/v and λ^s = m: rational, and <= 1 iff -log_λ(x)/ℓ >= r."""
    u, v = r.as_integer_ratio()
    s, m = len(factor.variables), factor.cosets
    c.spend(2, v * s * fraction_bits(x) + u * length * m.bit_length())
    return Fraction(x ** (v * s) * m ** (u * length))
