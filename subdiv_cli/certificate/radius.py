"""Joint spectral radii of families of matrices as claims (RADIUS.md)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from subdiv_cli.certificate.claims import MOST_WORK, WORK_A_SECOND, Claims, Json, polynomial
from subdiv_cli.model.closed import rational
from subdiv_cli.model.proofs import LeaderData, LowerBound, RadiusProof, RootData, TieData

if TYPE_CHECKING:
    from subdiv_cli.model.family import FamilyRadius


class Radii:
    """The claims on families of matrices: each introduces the families that it needs."""

    def __init__(self, claims: Claims, families: list[None], letters: int, uses: list[int]) -> None:
        self._claims, self._families, self._p, self._uses = claims, families, letters, uses

    def claim(self, data: RadiusProof, family: int, order: int) -> int:
        """The number of the claim that a proof on a family of matrices of this order is turned into."""
        rule, witness = data["rule"], dict[str, Any]()
        if rule == "blocks":
            return self._of_blocks(data, family, order)
        if rule in ("distinct", "transposed"):
            return self._of_part(data, family, order)
        if rule == "meeting-bounds":
            lower, upper = self.below(data["below"], family, order), self.claim(data["part"], family, order)
            name = "bounded" if data["bounded"] else "radius"
            return self._exact(rule, name, family, data, {}, 1, [lower, upper])
        if rule == "common-vector":
            witness = {"left": data["left"], "vector": spelled(data["vector"])}
            return self._upper(rule, family, 1, data["bound"], witness, self._p * order**2)
        if rule == "ellipsoid":
            words = data["words"]
            witness = {"form": list(data["form"]), "words": spelled(words)}
            work = (5 * len(words) + 1) * order**3
            return self._upper(rule, family, 2, data["bound"], witness, work)
        if rule == "zero":
            return self._upper("zero", family, 1, Fraction(0), {}, order * order * self._p)
        if rule in ("polytope", "monotone-polytope"):
            weights = sum(map(len, data["images"])) // 2
            work = self._p * len(data["vertices"]) * order**2 + weights * order + order**3
            witness = {"symmetry": data["symmetry"], "bits": data["bits"], **_images(data)}
            witness["vertices"] = [[str(x) for x in v] for v in data["vertices"]]
            return self._upper(rule, family, 1, data["bound"], witness, work)
        if rule == "positive-symbol":
            squares, rest = polynomial(0, data["squares"]), polynomial(0, data["rest"])
            witness = {"power": data["power"], "squares": squares, "rest": rest}
            name = "bounded" if data["bounded"] else "radius"
            return self._exact(rule, name, family, data, witness, 2 * (order + 2) ** 4)
        return self._closing(data, family, order)

    def _closing(self, data: RadiusProof, family: int, order: int) -> int:
        leaders, ties = data["leaders"], data["ties"]
        vertices, degree = len(leaders) + len(data["tree"]) // 2, len(data["root"]["polynomial"])
        length = len(leaders[0]["word"])
        weights = sum(map(len, data["images"])) // 2
        work = self._p * vertices * order**2 + weights * order + order**3 + len(leaders) * (length + 1) * order**3
        if ties:
            longest = max((len(weight) for weight in _polynomials(ties)), default=1)
            work += vertices * degree * order**2 + len(ties) * order * (degree + vertices + longest) ** 2
            if "sigma" in data:
                work += (length + len(ties) * (1 + order) * vertices) * degree**2
        witness: Json = {"symmetry": data["symmetry"], "bits": data["bits"]}
        witness |= {"extras": spelled(data["extras"]), "tree": spelled(data["tree"]), **_images(data)}
        witness["leaders"] = [_leader(leader) for leader in leaders]
        if "sign" in leaders[0]:
            witness["ties"] = spelled(ties)
            if "sigma" in data:
                witness["sigma"] = spelled(data["sigma"])
            return self._exact(data["rule"], "bounded", family, data, witness, work)
        return self._exact("complex-closing", "bounded", family, data, witness, 8 * work)

    def _of_blocks(self, data: RadiusProof, family: int, order: int) -> int:
        sizes = list(data["sizes"])
        parts = []
        for _ in sizes:
            parts.append(len(self._families))
            self._families.append(None)
        witness = {"basis": spelled(data["basis"]), "sizes": sizes}
        statement = {"property": "blocks", "family": family, "parts": parts}
        blocks = self._claims.add("blocks", statement, witness, [], (self._p + 1) * order**3)
        each = zip(data["parts"], parts, sizes, strict=True)
        uses = [blocks, *(self.claim(part, number, size) for part, number, size in each)]
        if "root" in data:
            return self._exact("radius-of-blocks", "radius", family, data, {}, 1, uses)
        return self._upper("upper-of-blocks", family, data["length"], data["bound"], {}, 1, uses)

    def _of_part(self, data: RadiusProof, family: int, order: int) -> int:
        """The claim on a family of one that has some of its matrices, or their transposes."""
        rule, number = data["rule"], len(self._families)
        self._families.append(None)
        statement = {"property": rule, "family": family, "part": number}
        witness = {"letters": list(data["letters"])} if rule == "distinct" else {}
        work = self._p * len(data.get("letters", (0,))) * order**2
        relation = self._claims.add(rule, statement, witness, [], work)
        used = self.claim(data["part"], number, order)
        statement = {**self._claims.statement(used), "family": family}
        return self._claims.add(f"of-{rule}", statement, {}, [relation, used], 1)

    def below(self, data: LowerBound, family: int, order: int) -> int:
        """The number of the claim that a product has so large a spectral radius."""
        word = list(data["word"])
        statement = {
            "property": "radius-lower",
            "family": family,
            "length": len(word),
            "bound": rational(data["bound"]),
        }
        if "vector" not in data:
            return self._claims.add("word", statement, {"word": word}, [], len(word) * order**3 + order**4)
        witness = {"word": word, "sign": data["sign"], "left": data["left"], "vector": spelled(data["vector"])}
        return self._claims.add("growing-vector", statement, witness, [], len(word) * order**2)

    def _exact(
        self,
        rule: str,
        name: str,
        family: int,
        data: RadiusProof,
        witness: Json,
        work: int,
        uses: list[int] | None = None,
    ) -> int:
        statement = {"property": name, "family": family, "length": data["length"], **root_fields(data["root"])}
        return self._claims.add(rule, statement, witness, self._uses if uses is None else uses, work)

    def _upper(
        self,
        rule: str,
        family: int,
        length: int,
        bound: Fraction,
        witness: Json,
        work: int,
        uses: list[int] | None = None,
    ) -> int:
        statement = {"property": "radius-upper", "family": family, "length": length, "bound": rational(bound)}
        return self._claims.add(rule, statement, witness, uses or [], work)


def _images(data: RadiusProof) -> Json:
    """The entries of a polytope's witness that say where images lie."""
    return {"basis": spelled(data["basis"]), "weight_bits": data["weight_bits"], "images": spelled(data["images"])}


def _polynomials(ties: Iterable[TieData]) -> Iterator[tuple[Fraction, ...]]:
    """The weights of all ties that are polynomials."""
    for tie in ties:
        for share in tie["weights"]:
            if isinstance(weight := share["weight"], tuple):
                yield weight


def _leader(leader: LeaderData) -> Json:
    """A leader as witnesses have it: integers of a complex eigenvalue's polynomial may be long, so they are strings."""
    written = {key: spelled(value) for key, value in leader.items()}
    if "factor" in leader:
        written["factor"] = [rational(x) for x in leader["factor"]]
    return written


def root_fields(root: RootData) -> Json:
    """The fields of a root in a statement."""
    return {
        "polynomial": [rational(c) for c in root["polynomial"]],
        "low": rational(root["low"]),
        "high": rational(root["high"]),
    }


def spelled(data: object) -> Any:
    """Plain data as JSON: a Fraction as `p/q`, a tuple as a list; integers stay integers."""
    if isinstance(data, Mapping):
        return {key: spelled(value) for key, value in data.items()}
    if isinstance(data, tuple):
        return [spelled(value) for value in data]
    return rational(data) if isinstance(data, Fraction) else data


def family_certificate(
    matrices: Sequence[Sequence[Sequence[Fraction]]], radius: FamilyRadius, seconds: float | None = None
) -> Json | None:
    """The proof of the bounds of a joint spectral radius; None where there are none, or where it takes too long.

    That is the work that the checker does, or what it does in so many seconds.
    """
    if not radius.proof:
        return None
    claims = Claims()
    radii = Radii(claims, [None], radius.letters, [])
    goal = [radii.claim(radius.proof, 0, radius.order)]
    if radius.below:
        goal.append(radii.below(radius.below, 0, radius.order))
    rows = [[[rational(x) for x in row] for row in matrix] for matrix in matrices]
    room = MOST_WORK if seconds is None else min(MOST_WORK, int(seconds * WORK_A_SECOND))
    if sum(claim["work"] for claim in claims.made) > room:
        return None
    return claims.document({"kind": "matrices", "matrices": rows}, goal, range(len(claims.made)))
