"""Claims in the order they are made: each statement once, with what it uses, as FORMAT.md says.

A certificate has as many of them as the checker is asked to do work for. What is too dear is left out alone: findings
come in the order of the questions that they answer, each with all that its claims rest on.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence, Set
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.model import DECIDED, Finding
from subdiv_cli.model.closed import rational
from subdiv_cli.model.properties import PROPERTIES

Json = dict[str, Any]
MOST_WORK = 250_000_000
"""What the checker does for one certificate."""
WORK_A_SECOND = 8_000_000
"""What the checker does in a second, at least nearly: a claim that asks more than the time allows is not begun."""


class UnwrittenError(Exception):
    """A claim cannot be made, because the certificate of a factor leaves out what it rests on."""


class Claims:
    """The claims of one certificate. `add` returns the number of a claim; the same claim is made only once."""

    def __init__(self) -> None:
        self.made: list[Json] = []
        self._numbers: dict[str, int] = {}

    def add(self, rule: str, statement: Json, witness: Json, uses: Sequence[int] = (), work: int = 1) -> int:
        """The number of the claim; the same claim has the same number."""
        claim = {"rule": rule, "statement": statement, "witness": witness, "uses": list(uses), "work": work}
        key = json.dumps(claim, sort_keys=True)
        if key not in self._numbers:
            self._numbers[key] = len(self.made)
            self.made.append(claim)
        return self._numbers[key]

    def prove(
        self, rule: str, statement: Json, witness: Json | None = None, uses: Sequence[int] = (), work: int = 1
    ) -> int:
        """The number of the claim, as in `add`; a statement without a property has that of the rule's name."""
        return self.add(rule, {"property": rule, **statement}, witness or {}, uses, work)

    def statement(self, number: int) -> Json:
        """The statement of the claim with this number."""
        statement: Json = self.made[number]["statement"]
        return statement

    def needs(self, number: int) -> Iterator[int]:
        """The earlier claims that a claim rests on: those that it uses, and those that introduce what it speaks of."""
        claim = self.made[number]
        yield from claim["uses"]
        statement, own = claim["statement"], set(_introduced(claim))
        if (family := statement.get("family")) is not None and family not in own:
            yield from (k for k in range(number) if family in _introduced(self.made[k]))
        if mask := statement.get("mask", statement.get("from", 0)):
            yield from (k for k in range(number) if self.made[k]["rule"] == "reduction" and _to(self.made[k]) <= mask)

    def closure(self, numbers: Iterable[int], known: Collection[int]) -> set[int]:
        """These claims and all that they rest on, without those that are known."""
        needed: set[int] = set()
        waiting = list(numbers)
        while waiting:
            number = waiting.pop()
            if number not in needed and number not in known:
                needed.add(number)
                waiting += self.needs(number)
        return needed

    def document(self, mask: Mapping[str, Any], goal: Iterable[int], kept: Sequence[int]) -> Json:
        """The document as FORMAT.md has it: the kept claims, in their order, and the statements of some as its goal."""
        new, families = {old: number for number, old in enumerate(kept)}, dict[int, int]()
        first = min((family for claim in self.made for family in _introduced(claim)), default=0)
        made = []
        for number in kept:
            claim = self.made[number]
            for family in _introduced(claim):
                families[family] = first + len(families)
            uses = [new[used] for used in claim["uses"]]
            made.append({**claim, "statement": _renumbered(claim, families), "uses": uses})
        statements = [made[new[number]]["statement"] for number in dict.fromkeys(goal)]
        return {"format": "subdiv-certificate", "version": 1, "mask": mask, "goal": statements, "claims": made}


def _introduced(claim: Json) -> list[int]:
    """The families that a claim introduces."""
    statement = claim["statement"]
    if statement["property"] in ("family", "jet", "stencil-family"):
        return [statement["family"]]
    return list(statement["parts"]) if claim["rule"] == "blocks" else [statement["part"]] if "part" in statement else []


def _to(claim: Json) -> int:
    """The mask that a step of a reduction leads to."""
    number: int = claim["statement"]["to"]
    return number


def _renumbered(claim: Json, families: Mapping[int, int]) -> Json:
    """The statement of a claim with its families as they are numbered where some are left out."""
    statement: Json = dict(claim["statement"])
    for key in ("family", "part"):
        if key in statement:
            statement[key] = families.get(statement[key], statement[key])
    if claim["rule"] == "blocks":
        statement["parts"] = [families[part] for part in statement["parts"]]
    return statement


class Certificate(NamedTuple):
    """A document as FORMAT.md has it, and for each finding the numbers of its claims that say the same."""

    document: Json
    findings: tuple[Finding, ...]
    """The findings, in the place of each that is left out the first of those otherwise that is not."""
    claims: tuple[tuple[int, ...], ...]
    made: Sequence[int]
    """The claims of the document, as they are numbered where none is left out."""

    def first(self, count: int) -> Certificate | None:
        """The certificate of the first claims, which rest on each other only; None where no finding is among them."""
        claims = tuple(several if max(several, default=0) < count else () for several in self.claims)
        goal = [self.document["claims"][number]["statement"] for several in claims for number in several]
        unique = {json.dumps(statement): statement for statement in goal}
        document = {**self.document, "goal": list(unique.values()), "claims": self.document["claims"][:count]}
        return Certificate(document, self.findings, claims, self.made[:count]) if goal else None


class Proofs(NamedTuple):
    """The claims that were made of an analysis, and for each finding the numbers of those that say the same."""

    claims: Claims
    mask: Mapping[str, Any]
    findings: Sequence[Finding]
    numbers: Sequence[Sequence[int]]
    """None for a finding that is not decided, or whose witness was too costly to compute."""
    make: Callable[[Finding], Sequence[int]]
    """The function that makes the claims of one more finding."""

    def certificate(self, without: Set[int] = frozenset(), seconds: float | None = None) -> Certificate | None:
        """The certificate of the findings that the checker has work for and that need none of these claims.

        With so many seconds for the checker the claims stand in the order of the questions, and none takes longer. None
        where there is no finding.
        """
        kept, chosen = self._selected(without, seconds)
        goal = [number for _, numbers in chosen for number in numbers]
        if not goal:
            return None
        made = sorted(kept) if seconds is None else list(kept)
        new = {old: number for number, old in enumerate(made)}
        renumbered = tuple(tuple(new[number] for number in numbers) for _, numbers in chosen)
        document = self.claims.document(self.mask, goal, made)
        return Certificate(document, tuple(finding for finding, _ in chosen), renumbered, made)

    def _selected(
        self, without: Set[int], seconds: float | None
    ) -> tuple[Collection[int], Sequence[tuple[Finding, Sequence[int]]]]:
        """The claims that are kept, and for each place its finding, or one otherwise, with the numbers of its claims.

        The claims are in the order of the questions. There are no numbers where the finding is left out.
        """
        room = MOST_WORK if seconds is None else min(MOST_WORK, int(seconds * WORK_A_SECOND))
        chosen = list(zip(self.findings, self.numbers, strict=True))
        written = all(numbers or not finding.otherwise for finding, numbers in chosen)
        enough = seconds is None and not without and written
        if enough and sum(claim["work"] for claim in self.claims.made) <= room:
            return range(len(self.claims.made)), chosen
        kept = dict[int, None]()
        for place in sorted(range(len(chosen)), key=lambda place: _importance(self.findings[place])):
            chosen[place] = self.findings[place], ()
            for finding, numbers in self._choices(place):
                more = self.claims.closure(numbers, kept)
                work = sum(self.claims.made[number]["work"] for number in more)
                if numbers and work <= room and not more & without:
                    kept |= dict.fromkeys(sorted(more))
                    room -= work
                    chosen[place] = finding, numbers
                    break
        return kept, chosen

    def _choices(self, place: int) -> Iterator[tuple[Finding, Sequence[int]]]:
        """The finding at a place and those otherwise, each with its claims, which are made when it is asked for."""
        yield self.findings[place], self.numbers[place]
        yield from ((other, self.make(other)) for other in self.findings[place].otherwise)


def _importance(finding: Finding) -> int:
    """The place of its question among the properties of a scheme; what answers none comes last."""
    questions = {question for question, _ in finding.answers}
    places = (place for place, row in enumerate(PROPERTIES) if questions & {row.question, *row.more, *row.instead})
    return next(places, len(PROPERTIES))


def proofs(
    claims: Claims, mask: Mapping[str, Any], findings: Sequence[Finding], claims_of: Callable[[Finding], Iterable[int]]
) -> Proofs:
    """The claims of the findings that are decided; `claims_of` makes those that say what a finding says.

    It makes none where the witness was too costly to compute, or raises UnwrittenError.
    """

    def made(finding: Finding) -> tuple[int, ...]:
        try:
            return tuple(claims_of(finding)) if finding.verdict in DECIDED else ()
        except UnwrittenError:
            return ()

    return Proofs(claims, mask, findings, tuple(map(made, findings)), made)


def polynomial(start: int, coefficients: Sequence[Fraction | int]) -> Json:
    """A polynomial as statements have it: its start and its coefficients."""
    return {"start": start, "coefficients": [rational(c) for c in coefficients]}


def document_text(document: Mapping[str, Any]) -> str:
    """The JSON text of a certificate, a line for each statement of the goal and for each claim."""
    lines = []
    for key, value in document.items():
        if isinstance(value, list):
            entries = ",\n  ".join(json.dumps(entry) for entry in value)
            lines.append(f"{json.dumps(key)}: [\n  {entries}\n ]" if value else f"{json.dumps(key)}: []")
        else:
            lines.append(f"{json.dumps(key)}: {json.dumps(value)}")
    return "{" + ",\n ".join(lines) + "}\n"
