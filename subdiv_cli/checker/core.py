"""The core: a document's goal and claims in order, each by its rule from earlier claims, within its work."""

from __future__ import annotations

import marshal
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from subdiv_cli.checker.json_text import parse
from subdiv_cli.checker.matrices import RationalFamily
from subdiv_cli.checker.numerals import shown
from subdiv_cli.checker.reading import Exhausted, Fields, Rejected, read_object, require, require_few

if TYPE_CHECKING:
    from subdiv_cli.checker.plain import PlainReaders

FORMAT, VERSION = "subdiv-certificate", 1
MAX_FAMILIES = 1000
MAX_ENTRIES = 4_000_000
"""The most entries of the matrices of all families."""
MAX_CLAIMS = 10_000
MAX_WORK = 250_000_000
"""Over all claims, unless the caller sets another bound: some 30 s where every operation is done."""
SIZE = 4
"""Work times the squares of the lengths of its numbers in pieces of 512 bits, over all claims: a multiple of it."""
_CLAIM = {"rule": "any", "statement": "any", "witness": "any", "uses": "natural[]", "work": "work"}
Statement = dict[str, Any]


class Outcome(NamedTuple):
    """The outcome of a check: whether the certificate is verified, and the line to print."""

    verified: bool
    spell: Callable[[], str]
    """A function that spells the line, which is called only when the line is wanted."""
    statements: tuple[dict[str, object], ...] = ()
    """The statements of the goal as the document has them; none unless verified."""
    claim: int | None = None
    """The number of the claim that fails, where it is one that does."""
    exhausted: bool = False
    """Whether it is not verified only because it needs more work than the checker does."""

    @property
    def line(self) -> str:
        """The line to print: `VERIFIED` and the goal in words, or `NOT VERIFIED` and why."""
        return self.spell()


def not_verified(place: str, why: object, claim: int | None = None) -> Outcome:
    """The outcome that a certificate is not verified, with the place and the reason."""
    line = f"NOT VERIFIED {place}: {why}"
    return Outcome(False, lambda: line, claim=claim, exhausted=isinstance(why, Exhausted))


class Proved(NamedTuple):
    """A claim that holds, with a result that later claims need, such as the quotient of a sum-rules claim."""

    statement: Statement
    result: Any


class Step(NamedTuple):
    """A rule: the form of its claims, and the function that checks one: it returns `Proved.result` or rejects."""

    properties: Sequence[str]
    """The properties of the statements that it proves."""
    fixed: Mapping[str, object]
    """Fields of the statement whose value the rule fixes."""
    witnesses: Sequence[Fields]
    """The witnesses the rule knows; their keys tell them apart."""
    check: Callable[[Claim], object]


class Subject:
    """The mask or family that a document's claims are about, and what is left of the bound on the sizes of numbers."""

    def __init__(self, letters: int, about: Any, families: Sequence[RationalFamily] = ()) -> None:
        self.letters = letters
        """The arity of the mask, m = |det M| of its dilation, or the number of matrices of the family."""
        self.about = about
        """The mask or family in the form that the rules of the kind use."""
        self.families = list(families)
        """Those of the document, and those that claims introduce."""
        self.work = MAX_WORK
        """The bound on the work of all claims."""
        self.size_left = SIZE * MAX_WORK
        self.kinds: Mapping[str, Rulebook] = {}
        """The rulebooks for certificates inside of the document."""


class Rulebook(NamedTuple):
    """The rulebook of a kind of documents: what they are about, and the rules of their claims."""

    fields: Fields
    """The fields of the document's mask, besides its kind."""
    subject: Callable[[dict[str, Any]], Subject]
    properties: Mapping[str, Fields]
    rules: Mapping[str, Step]
    words: Callable[[Statement, Subject], str]
    """A function that spells a statement, its property under the key `property`, as a phrase."""
    plain: PlainReaders
    """The readers of mask files with literal numbers."""


class Claim:
    """A claim under check: statement and witness read, and the claims that it uses."""

    def __init__(
        self, subject: Subject, statement: Statement, witness: dict[str, Any], work: int, uses: list[Proved]
    ) -> None:
        self.p = subject.letters
        self.about = subject.about
        self.statement = statement
        self.witness = witness
        self._subject, self._work, self._uses = subject, work, uses

    def family(self) -> RationalFamily:
        """The matrices of the family that the statement names."""
        number: int = self.statement["family"]
        require(number < len(self._subject.families), f"there is no family {number}")
        return self._subject.families[number]

    def introduce(self, number: int, family: RationalFamily) -> None:
        """Add a new family, numbered as the statement says."""
        families = self._subject.families
        require(number == len(families), f"the next family is number {len(families)}")
        families.append(family)
        require_few(len(families) <= MAX_FAMILIES, "there are too many families")
        entries = sum(len(each.matrices) * each.order**2 for each in families)
        require_few(entries <= MAX_ENTRIES, "the families have too many entries")

    def check_inside(self, document: object) -> tuple[Outcome, Rulebook | None, Subject | None]:
        """Another certificate, on numbers as long as this document may still have; what it is about as well."""
        checker = _Checker(self._subject.work, self._subject.size_left)
        outcome = _outcome(checker, document, self._subject.kinds)
        if checker.subject is not None:
            self._subject.size_left = checker.subject.size_left
        return outcome, checker.rulebook, checker.subject

    def count(self, operations: int, bits: int = 0) -> None:
        """Count operations as the rule counts them, on numbers of so many bits, before they are done.

        Raises Rejected where the claim states less work, and Exhausted where the numbers are too long.
        """
        if operations > self._work:
            raise Rejected(f"it takes more work than stated: {min(operations, 10**18)}")
        self.spend(operations, bits)

    def spend(self, operations: int, bits: int) -> None:
        """Count more work of the operations that are counted, or of some of them, on numbers of so many bits.

        Raises Exhausted where the numbers are too long for so much work.
        """
        self._subject.size_left -= (1 + operations) * (1 + bits // 512) ** 2
        if self._subject.size_left < 0:
            raise Exhausted("the numbers are too long for so much work")

    def use(self, *properties: str, **fields: object) -> Proved:
        """The next claim that is used. Raises Rejected unless it states one of these properties with these fields."""
        if not self._uses:
            raise Rejected(f"it does not use a claim on {' or '.join(properties)}")
        proved = self._uses.pop(0)
        if proved.statement["property"] not in properties:
            raise Rejected(f"it uses {proved.statement['property']}, not {' or '.join(properties)}")
        for key, value in fields.items():
            if proved.statement.get(key) != value:
                raise Rejected(f"it uses {' or '.join(properties)} with another {key}")
        return proved

    def use_nothing_else(self) -> None:
        """Raise Rejected where the claim lists more claims than its rule has used."""
        require(not self._uses, "it uses claims that it does not need")


def check_text(text: str, kinds: Mapping[str, Rulebook], work: int = MAX_WORK) -> Outcome:
    """Never raises: whatever goes wrong is NOT VERIFIED; `work` bounds that of all claims."""
    try:
        document = parse(text)
    except Rejected as why:
        return not_verified("document", why)
    return check_document(document, kinds, work)


def check_document(
    document: object, kinds: Mapping[str, Rulebook], work: int = MAX_WORK, goes_on: Callable[[], bool] = lambda: True
) -> Outcome:
    """As `check_text`, of a document that is parsed; `goes_on` is asked before each claim whether there is time for it.

    Where there is none, that claim is the one that fails: those before it are checked, and hold.
    """
    return _outcome(_Checker(work, SIZE * work, goes_on), document, kinds)


def _outcome(checker: _Checker, document: object, kinds: Mapping[str, Rulebook]) -> Outcome:
    try:
        return checker.run(document, kinds)
    except Rejected as why:
        return not_verified(checker.place, why, checker.number)
    except (Exception, RecursionError, MemoryError) as error:
        return not_verified(checker.place, f"the checker fails on it ({type(error).__name__})", checker.number)


class _Checker:
    """One run of the checker on a document, and the place that it has reached."""

    def __init__(self, most: int, size: int, goes_on: Callable[[], bool] = lambda: True) -> None:
        self.most, self.size, self.goes_on = most, size, goes_on
        self.rulebook: Rulebook | None = None
        self.subject: Subject | None = None
        self.place = "document"
        self.number: int | None = None
        self.proved: list[Proved] = []
        self.read: dict[bytes, Statement] = {}
        self.work = 0

    def run(self, document: object, kinds: Mapping[str, Rulebook]) -> Outcome:
        fields = {"format": "any", "version": "natural", "mask": "any", "goal": "any[]", "claims": "any"}
        parts = read_object(document, fields, "the document")
        require(parts["format"] == FORMAT, f"the format is not {FORMAT}")
        require(parts["version"] == VERSION, f"the version is not {VERSION}")
        rulebook, subject = self.rulebook, self.subject = _read_mask(parts["mask"], kinds)
        subject.kinds, subject.work, subject.size_left = kinds, self.most, self.size
        claims = parts["claims"]
        if type(claims) is not list:
            raise Rejected("the claims are not a list")
        require_few(len(claims) <= MAX_CLAIMS, "there are too many claims")
        for self.number, claim in enumerate(claims):
            self.place = f"claim {self.number}"
            if not self.goes_on():
                raise Exhausted("there is no time left")
            self.proved.append(self.check(claim, rulebook, subject))
        self.place, self.number = "goal", None
        goal = [self.statement(statement, rulebook) for statement in parts["goal"]]
        require(bool(goal), "there is none")
        same = {id(proved.statement) for proved in self.proved}  # of one spelling, most often
        for statement in goal:
            if id(statement) not in same and all(statement != proved.statement for proved in self.proved):
                raise Rejected(f"no claim proves: {rulebook.words(statement, subject)}")

        def spell() -> str:
            return "VERIFIED " + "; ".join(rulebook.words(statement, subject) for statement in goal)

        return Outcome(True, spell, tuple(map(dict, parts["goal"])))

    def statement(self, value: object, rulebook: Rulebook) -> Statement:
        """The statement read strictly, each spelling once: claims and goal have the same statements."""
        try:
            spelling = marshal.dumps(value, 2)  # type: ignore[arg-type]  # exact types only; version 2 has no references
        except ValueError:
            return read_statement(value, rulebook)
        if spelling not in self.read:
            self.read[spelling] = read_statement(value, rulebook)
        return self.read[spelling]

    def check(self, value: object, rulebook: Rulebook, subject: Subject) -> Proved:
        name = value.get("rule") if type(value) is dict else None
        if type(name) is not str or name not in rulebook.rules:
            raise Rejected(f"unknown rule {shown(name)}")
        self.place += f" ({name})"
        step = rulebook.rules[name]
        parts = read_object(value, _CLAIM, "the claim")
        statement = self.statement(parts["statement"], rulebook)
        fits = statement["property"] in step.properties and step.fixed.items() <= statement.items()
        require(fits, "the rule does not prove such statements")
        require(max(parts["uses"], default=-1) < len(self.proved), "it uses a claim that does not come before it")
        self.work += parts["work"]
        require_few(self.work <= self.most, f"the claims up to this one take more than {self.most} of work")
        uses = [self.proved[i] for i in parts["uses"]]
        claim = Claim(subject, statement, _read_witness(parts["witness"], step.witnesses), parts["work"], uses)
        result = step.check(claim)
        claim.use_nothing_else()
        return Proved(statement, result)


def _read_mask(value: object, kinds: Mapping[str, Rulebook]) -> tuple[Rulebook, Subject]:
    name = value.get("kind") if type(value) is dict else None
    if type(name) is not str or name not in kinds:
        raise Rejected(f"the kind of the mask is not one of {', '.join(kinds)}")
    rulebook = kinds[name]
    return rulebook, rulebook.subject(read_object(value, {"kind": "any", **rulebook.fields}, "the mask"))


def read_statement(value: object, rulebook: Rulebook) -> Statement:
    """The statement read strictly, so that two statements are the same iff they are equal.

    Raises Rejected for an unknown property, and for values that are not as specified.
    """
    name = value.get("property") if type(value) is dict else None
    if type(name) is not str or name not in rulebook.properties:
        raise Rejected(f"unknown property {shown(name)}")
    return read_object(value, {"property": "any", **rulebook.properties[name]}, "the statement")


def _read_witness(value: object, known: Sequence[Fields]) -> dict[str, Any]:
    """The witness, read by the known one with the same keys, otherwise by the first, which says what is wrong."""
    keys = value.keys() if type(value) is dict else ()
    return read_object(value, next((fields for fields in known if fields.keys() == keys), known[0]), "the witness")
