"""A certificate under construction: the claims that several findings share."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any, cast

from subdiv_cli.certificate.claims import Claims, Json
from subdiv_cli.certificate.radius import Radii
from subdiv_cli.certificate.witness import as_integer, as_tuple, as_word
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.vector import rules
from subdiv_cli.model import Data, Finding, Verdict
from subdiv_cli.model.closed import rational

Map = Mapping[str, Data]


class VectorProof:
    """A certificate under construction: each method returns the numbers of claims, made if there are none yet."""

    def __init__(self, mask: Json, findings: Sequence[Finding]) -> None:
        self.claims = Claims()
        self.found = Facts(findings)
        self.p: int = mask["arity"]
        self.length = len(mask["coefficients"])
        self.size = len(mask["coefficients"][0])
        self._families: list[None] = []
        self._spaces: dict[int, int] = {}
        self._radii: dict[int, list[int]] = {}

    @property
    def entries(self) -> int:
        """The number of entries of all matrices."""
        return self.length * self.size**2

    @property
    def dimension(self) -> int:
        """The dimension r of E_A."""
        return as_integer(self.found[rules.CONSTANTS].witness["dimension"])

    def constants(self) -> int:
        """The claim on E_A."""
        found = self.found[rules.CONSTANTS].witness
        r = as_integer(found["dimension"])
        work = (self.entries + self.p * self.size**2) * (r + 1)
        return self.claims.prove("constants", {"dimension": r}, {"basis": rationals(found["basis"])}, work=work)

    def decay(self) -> list[int]:
        """The claims on the radius of sequences that die out, and on their space."""
        return self._radius(self.found[rules.DECAY_RADIUS])

    def growth(self) -> list[int]:
        """The claims on the radius of differences of limit stencils, and on their space."""
        return self._radius(self.found[rules.STENCIL_RADIUS])

    def _radius(self, finding: Finding) -> list[int]:
        order, space = as_integer(finding.witness["order"]), cast(Map, finding.proof["space"])
        return self.radius_of(finding, self.space(order, space))

    def radius_of(self, finding: Finding, introduced: int) -> list[int]:
        """The claims on the radius that a finding has on its space, which a claim introduces; made once."""
        if introduced not in self._radii:
            space, radius = cast(Map, finding.proof["space"]), cast(Map, finding.proof["radius"])
            self._radii[introduced] = self._radius_on(introduced, space, radius)
        return self._radii[introduced]

    def radius(self, order: int, space: Map, radius: Map) -> list[int]:
        """The claims on a radius, and on the space of this order."""
        return self._radius_on(self.space(order, space), space, radius)

    def _radius_on(self, introduced: int, space: Map, radius: Map) -> list[int]:
        number, n = self._number(introduced), len(as_tuple(space["basis"]))
        return [Radii(self.claims, self._families, self.p, []).claim(radius, number, n), introduced]

    def _number(self, introduced: int) -> int:
        number: int = self.claims.statement(introduced)["family"]
        return number

    def space(self, order: int, space: Map) -> int:
        """The claim that introduces the operators on an invariant space: of order 0 that of what dies out."""
        if order in self._spaces:
            return self._spaces[order]
        given = order + 2 + self.stencil_width() if order else 2
        witness, work = self.space_witness(space, given)
        if order:
            words, more = spanning_words(space)
            witness, work = {**witness, "words": words}, work + more
            rule, uses = "stencil-differences", [self.stencils()]
        else:
            witness["orthogonal"] = rationals(space["orthogonal"])
            rule, uses, work = "decay", [self.constants()], work + len(as_tuple(space["basis"])) * self.size**2
        statement = {"property": "family", "family": self.next_family(), "order": order}
        self._spaces[order] = self.claims.prove(rule, statement, witness, uses, work)
        return self._spaces[order]

    def next_family(self) -> int:
        """The number of a new family."""
        self._families.append(None)
        return len(self._families) - 1

    def space_witness(self, space: Map, given: int) -> tuple[Json, int]:
        """The witness of an invariant space, and its work where the given sequences have so many indices at most."""
        basis, tree, m = as_tuple(space["basis"]), as_tuple(space["tree"]), self.size
        n, width = len(basis), len(as_tuple(basis[0]))
        longest = max(self.length, given) + 2
        work = len(tree) * longest * self.entries + sum(as_word({"word": tree})) * n * width
        work += n * width * (n * (self.p + 1) + self.entries // m)
        witness: Json = {"start": space["start"], "tree": list(tree)}
        witness |= {key: rationals(space[key]) for key in ("basis", "matrices", "leaves")}
        return witness, work

    def stencil_width(self) -> int:
        """The number of indices of the limit stencils."""
        rows = as_tuple(self.found[rules.LIMIT_STENCILS].witness["rows"])
        return len(as_tuple(rows[0])) // self.size

    def word(self, order: int, space: Map, word: Sequence[int], bound: Fraction) -> list[int]:
        """The claims that a product bounds the radius on a space from below, and on that space."""
        return self.word_on(self.space(order, space), space, word, bound)

    def word_on(self, introduced: int, space: Map, word: Sequence[int], bound: Fraction) -> list[int]:
        """The claims that a product bounds the radius from below, and on the space that a claim introduces."""
        n = len(as_tuple(space["basis"]))
        statement = {
            "property": "radius-lower",
            "family": self._number(introduced),
            "length": len(word),
            "bound": rational(bound),
        }
        work = len(word) * n**3 + n**4
        return [self.claims.prove("word", statement, {"word": list(word)}, work=work), introduced]

    def defective(self, order: int, space: Map, witness: Map) -> list[int]:
        """The claims that a product on a space has a Jordan block, and on that space."""
        introduced, n, word = self.space(order, space), len(as_tuple(space["basis"])), list(as_word(witness))
        statement: Json = {"property": "defective", "family": self._number(introduced), "length": len(word)}
        statement["value"] = rationals(witness["value"])
        hints = {"word": word, "sign": witness["sign"], "vector": rationals(witness["vector"])}
        return [self.claims.prove("defective", statement, hints, work=len(word) * n**3 + 2 * n**2), introduced]

    def convergent(self) -> int:
        """The claim that S converges, or that it does not."""
        found = self.found[rules.CONVERGENCE]
        holds, by = found.verdict is Verdict.PROVED, found.witness["by"]
        statement: Json = {"property": "convergent", "holds": holds}
        if holds:
            return self.claims.prove("converges", statement, uses=self.decay())
        if by == rules.CONSTANTS.code:
            return self.claims.prove("diverges", statement, uses=[self.constants()])
        if by == rules.LIMIT_STENCILS.code:
            rows = as_tuple(found.witness["fixed"])
            witness = {"start": found.witness["start"], "rows": rationals(found.witness["fixed"])}
            return self.claims.prove(
                "fixed-diverges", statement, witness, [self.constants()], self._fixed(len(rows), len(as_tuple(rows[0])))
            )
        space = cast(Map, self.found[rules.DECAY_RADIUS].proof["space"])
        return self.claims.prove("diverges", statement, uses=self.word(0, space, as_word(found.witness), Fraction(1)))

    def stencils(self) -> int:
        """The claim on the limit stencils."""
        found = self.found[rules.LIMIT_STENCILS].witness
        rows = as_tuple(found["rows"])
        witness = {"start": found["start"], "rows": rationals(found["rows"])}
        work = self._fixed(len(rows), len(as_tuple(rows[0])))
        return self.claims.prove("limit-stencils", {"count": len(rows)}, witness, [self.constants()], work)

    def _fixed(self, count: int, length: int) -> int:
        return count * (length // self.size + 1) * self.entries + (count + self.size) ** 2 * length


def spanning_words(space: Map) -> tuple[list[list[Data]], int]:
    """The words that span an invariant space, a leaf and letters each, and the work of checking that they do."""
    words, n = [list(as_tuple(word)) for word in as_tuple(space["words"])], len(as_tuple(space["basis"]))
    return words, sum(map(len, words)) * n * n + n**3


def rationals(data: Data) -> Any:
    """Nested tuples of numbers, each as `p/q`, integers too."""
    return [rationals(x) for x in data] if isinstance(data, tuple) else rational(cast("Fraction | int", data))
