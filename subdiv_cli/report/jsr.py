"""A joint spectral radius for a reader: the number, what attains it, what proves it."""

from __future__ import annotations

import re

from subdiv_cli.model.family import FamilyRadius
from subdiv_cli.model.formulas import product
from subdiv_cli.report.letters import clean, letters
from subdiv_cli.report.look import Look
from subdiv_cli.report.numbers import LONGEST, enclosed

_NARROW = 1e-6
"""The relative width up to which an enclosure is as good as the number."""
_LONG_NUMBER = re.compile(r"\d{21}")
"""Numbers that nobody reads: their decimals say more."""
_METHODS = {
    "closing": "an invariant polytope of {n}, closed at exactly this radius",
    "polytope": "an invariant polytope of {n}",
    "monotone-closing": "a monotone invariant polytope of {n}, closed at exactly this radius",
    "monotone-polytope": "a monotone invariant polytope of {n}",
    "common-vector": "one positive vector that no matrix makes larger than so many times itself",
    "ellipsoid": "an ellipsoid that products map into multiples of itself",
    "blocks": "a common block triangular form, and the largest radius of its blocks",
    "zero": "all matrices are zero",
}


def render(radius: FamilyRadius, look: Look, *, file: str, name: str | None, proof: str | None) -> str:
    """The lines on a joint spectral radius; mathematics in ASCII where nothing else can be written."""
    lines = [_first(radius), f"  {file} · {radius.letters} {_matrices(radius.letters)} of order {radius.order}"]
    if name:
        lines[1] = f"  {name} · {lines[1].strip()}"
    if radius.words:
        attained = "attained by" if radius.exact is not None or radius.digits else "at least that of"
        lines += [f"  {attained} the product {product(word, 'M', ' ')}, length {len(word)}" for word in radius.words]
    if radius.method:
        lines.append("  proof: " + _METHODS[radius.method].format(n=_count(radius.vertices)))
    if radius.bounded:
        lines.append("  products of L matrices are bounded by a constant times the L-th power of the radius")
    if proof is not None:
        lines.append(f"  certificate: {proof}")
    return "".join(letters(clean(line), look.unicode) + "\n" for line in lines)


def _first(radius: FamilyRadius) -> str:
    title = "joint spectral radius"
    if radius.upper is None and radius.exact is None and radius.digits is None:
        why = radius.left_out or ("the time budget ended" if radius.stopped else "a higher effort computes more")
        return f"? {title}: not one bound was found; {why}"
    if radius.exact is None and radius.digits is None:
        sign = "✓" if radius.width <= _NARROW else "~"
        return f"{sign} {title} in {enclosed(radius.lower, radius.upper)}"
    exact = radius.exact or "an algebraic number"
    digits = radius.digits
    if digits and (len(exact) > LONGEST or _LONG_NUMBER.search(exact)):
        exact = "a long fraction" if exact.replace("/", "").isdigit() else "an algebraic number"
    elif digits and (digits.rstrip("…") == exact or _short(radius)):
        digits = None
    return f"✓ {title} = {exact}" + (f" = {digits}" if digits else "")


def _short(radius: FamilyRadius) -> bool:
    """Whether the radius is a rational that needs no decimals beside it."""
    return radius.exact is not None and radius.exact.isdigit()


def _count(vertices: int | None) -> str:
    return "1 vertex" if vertices == 1 else f"{vertices} vertices"


def _matrices(count: int) -> str:
    return "matrix" if count == 1 else "matrices"
