"""The result for a family: bounds of its joint spectral radius, and the proof as plain data."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import NamedTuple

from subdiv_cli.jsr.family import Word
from subdiv_cli.model import Root
from subdiv_cli.model.proofs import LowerBound, RadiusProof, root_data


class Radius(NamedTuple):
    """The joint spectral radius ρ of a family: bounds, and the number itself where it is known."""

    word: Word | None
    """A product that attains the lower bound; None where all products met are nilpotent."""
    exact: tuple[int, Root] | None
    """The pair (n, Λ) with ρ^n = Λ, where ρ is known."""
    upper: tuple[int, Fraction]
    """A pair (n, x) with ρ^n <= x."""
    bounded: bool
    """Whether it is proved that all products of L matrices have norms <= C ρ^L."""
    proof: RadiusProof
    """A proof as plain data: `rule`, `length`, `root` or `bound`, and the witness of the rule.

    `rule` names a rule of certificate/RADIUS.md (or `norm`, of FORMAT.md); `length` with `root` or `bound` is what is
    proved: ρ^length = Λ or <= bound. Rule `blocks` has a proof for each of its `parts`, rules `distinct`, `transposed`
    and `meeting-bounds` one for their `part`.
    """

    @property
    def ceiling(self) -> float:
        """The number log2 of ρ or of a little more, in floats, for comparisons that decide nothing."""
        length, x = self.upper
        return (math.log2(x.numerator) - math.log2(x.denominator)) / length if x else -math.inf

    @property
    def method(self) -> str:
        """The rule that does the work: for rules with one part, such as `distinct`, that of the part."""
        proof = self.proof
        while "part" in proof:
            proof = proof["part"]
        return proof["rule"]

    @property
    def vertices(self) -> int | None:
        """The number of vertices of all polytopes, reflections and conjugates not counted; None without a polytope."""
        return _vertices(self.proof)

    def is_below(self, x: Fraction) -> bool:
        """Whether ρ < x is proved, x > 0."""
        return self.upper[1] < x ** self.upper[0]


def meeting(part: RadiusProof, below: LowerBound, length: int, value: Fraction) -> Radius:
    """The radius ρ with ρ^length = value, which the proof of a norm bounds from above, and a product from below."""
    root = Root((-value.numerator, value.denominator), value, value)
    proof: RadiusProof = {"rule": "meeting-bounds", "part": part, "below": below, "bounded": True}
    proof |= {"length": length, "root": root_data(root)}
    return Radius(below["word"], (length, root), (length, value), True, proof)


def carried(rule: str, radius: Radius, word: Word | None, letters: Word = ()) -> Radius:
    """The same radius of a family of which the first one has some letters (`distinct`), or the transposes."""
    proof: RadiusProof = {"rule": rule, "part": radius.proof, "length": radius.proof["length"]}
    if letters:
        proof["letters"] = letters
    if "root" in radius.proof:
        proof["root"] = radius.proof["root"]
    if "bound" in radius.proof:
        proof["bound"] = radius.proof["bound"]
    return radius._replace(word=word, proof=proof)


def _vertices(proof: RadiusProof) -> int | None:
    if "leaders" in proof:
        return len(proof["leaders"]) + len(proof["tree"]) // 2
    if "part" in proof:
        return _vertices(proof["part"])
    if "parts" in proof:
        return sum(_vertices(part) or 0 for part in proof["parts"]) or None
    return len(proof["vertices"]) if "vertices" in proof else None
