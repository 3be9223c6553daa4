"""TOML mask files of every kind -> `MaskFile`. Everything that is wrong with a file is collected and raised at once."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from subdiv_cli.kinds import KINDS, PLANNED, kind_named, kinds_that, lacking
from subdiv_cli.kinds.kind import Kind
from subdiv_cli.kinds.option import from_given
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_FILE_BYTES, at_most
from subdiv_cli.maskfile.entries import Table, read_parameters, text_at
from subdiv_cli.maskfile.mask import MaskFile, check_fixed_mask
from subdiv_cli.maskfile.option import NOTHING_GIVEN, Given
from subdiv_cli.maskfile.pasted import is_toml
from subdiv_cli.maskfile.problems import Collector, Fault, MaskFileError, Source, near, shown, unreadable
from subdiv_cli.maskfile.properties import KEYS, contradictions, expectation
from subdiv_cli.maskfile.recognise import MARKS
from subdiv_cli.maskfile.toml import load
from subdiv_cli.maskfile.values import described
from subdiv_cli.model import Expectation, Problem
from subdiv_cli.model.properties import PROPERTIES

_TOP = ("format", "name", "reference", "kind", "parameters", "expect")
"""The keys that files of every kind may have."""


def read_path(
    path: str | Path, *, kind: str | None = None, capability: str = "analyse", given: Given = NOTHING_GIVEN
) -> MaskFile:
    """The mask of a file; "-" is standard input. Raises MaskFileError, also for a file that cannot be read (SD002).

    `kind`: the one whose family of matrices is wanted; another is refused (SD013) before its mask is read, and so is,
    without it, a kind that does not declare the capability, a field of `Kind`. `given` belongs to a list on standard
    input.
    """
    text = text_of(load_path(path), str(path))
    return read_text(text, file=str(path), wanted=kind, capability=capability, given=given)


def load_path(path: str | Path) -> bytes:
    """The bytes of a mask file; "-" is standard input. Raises MaskFileError: SD002, or SD010 for a file too large."""
    file = str(path)
    try:
        data = at_most(path, MAX_FILE_BYTES)
    except OSError as error:
        raise MaskFileError([unreadable(file, error)]) from None
    if len(data) > MAX_FILE_BYTES:
        raise MaskFileError([_too_big(file)])
    return data


def read_bytes(data: bytes, *, file: str, given: Given = NOTHING_GIVEN) -> MaskFile:
    """The mask in the bytes of a file. Raises MaskFileError and nothing else, whatever the bytes."""
    return read_text(text_of(data, file), file=file, given=given)


def text_of(data: bytes, file: str) -> str:
    """The bytes of a file as text. Raises MaskFileError: SD002."""
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise MaskFileError([_not_utf8(file, data, error)]) from None


def _too_big(file: str) -> Problem:
    """The problem of a file that is too large for a mask."""
    message = f"the file is larger than {MAX_FILE_BYTES >> 10} KiB, the limit for a mask file"
    return faults.OUT_OF_BOUNDS.problem(message, "is this really a mask file?", file=file)


def _not_utf8(file: str, data: bytes, error: UnicodeDecodeError) -> Problem:
    """The problem of a file that is not UTF-8, at the first byte that is not."""
    start = data.rfind(b"\n", 0, error.start) + 1
    end = data.find(b"\n", error.start)
    wide = data.startswith((b"\xff\xfe", b"\xfe\xff"))
    return faults.UNREADABLE_FILE.problem(
        f"the file is not UTF-8: byte 0x{data[error.start]:02x} at byte {error.start + 1}",
        "it looks like UTF-16; save it as UTF-8" if wide else "save it as UTF-8",
        file=file,
        line=data.count(b"\n", 0, error.start) + 1,
        column=len(data[start : error.start].decode("utf-8", "replace").removeprefix("\ufeff")) + 1,
        source=data[start : end if end >= 0 else None].decode("utf-8", "replace").rstrip("\r"),
    )


def _says_itself(file: str, option: str) -> Problem:
    """The problem of an option that belongs to a list, beside a mask file on standard input."""
    message = f"--{option} belongs to a list of coefficients, and this is a mask file"
    return faults.DUPLICATE_KEY.problem(message, f"write it under [mask]: {option} = …", file=file)


def read_text(
    text: str, *, file: str, wanted: str | None = None, capability: str = "analyse", given: Given = NOTHING_GIVEN
) -> MaskFile:
    """The mask in the text of a file. Raises MaskFileError and nothing else, whatever the text.

    Standard input, "-", may have a list or a symbol instead, as `--mask` has it.

    Expressions without parameters are evaluated, so that their faults are reported here; those of the others come
    from `MaskFile.scheme`.
    """
    text = text.removeprefix("\ufeff")
    if len(text) > MAX_FILE_BYTES:
        raise MaskFileError([_too_big(file)])
    if file == "-" and wanted is None:
        if not is_toml(text):
            return from_given(text, given, file=file)
        if given.start is not None or given.arity is not None:
            raise MaskFileError([_says_itself(file, "start" if given.start is not None else "arity")])
    source = Source(file, text)
    problems = Collector(source)
    document = load(source)
    kind = kind_named(_kind(document, wanted, capability, problems))
    read = kind.read if wanted is None or kind.read_family is None else kind.read_family
    top = Table(document, (), problems)
    top.only((*_TOP, *kind.keys), _BELONGS if "mask" in kind.keys else {})
    _format(document, problems)
    name, reference = text_at(top, "name"), text_at(top, "reference")
    parameters = read_parameters(top.table("parameters"), problems)
    body = read(top, parameters, problems)
    expectations = _expectations(top.table("expect"), kind, problems)
    if body is not None:
        check_fixed_mask(body, problems)
    problems.raise_any()
    assert body is not None, "a missing body is a problem"
    return MaskFile(
        file=file,
        body=body,
        name=name,
        reference=reference,
        kind=kind.name,
        parameters=parameters,
        expectations=expectations,
        source=source,
    )


_BELONGS = dict.fromkeys(
    ("arity", "start", "coefficients", "symbol"), ("it belongs below [mask]", "mask")
) | dict.fromkeys(KEYS, ("it belongs below [expect]", "expect"))
_BELONGS |= dict.fromkeys(
    ("coef", "coefs", "coeff", "coeffs", "coefficient"), ("did you mean coefficients? they belong below [mask]", "mask")
)


def _kind(document: Mapping[str, object], wanted: str | None, capability: str, problems: Collector) -> str:
    """The kind that the document names. Raises MaskFileError at once for another (SD013) and for no mask (SD016)."""
    if not any(mark in document for mark in MARKS):
        _is_meant(document, problems)
    kind = document.get("kind", "matrices" if "matrices" in document and "mask" not in document else "scalar")
    where = ("kind" if "kind" in document else "mask" if "mask" in document else "matrices",)
    known = ", ".join(kinds_that(capability))
    if "kind" not in document and _has_matrices(document.get("mask")):
        help = 'write kind = "vector" at the top, or kind = "hermite" where the data are a function and its derivatives'
        unsaid = "the coefficients are matrices, and the file does not say of which kind the mask is"
        problems.add(Fault(faults.MISSING_KEY, unsaid, help), ("mask", "coefficients"))
    elif not isinstance(kind, str):
        problems.add(
            Fault(faults.WRONG_TYPE, f"kind must be a string, not {described(kind)}", 'write kind = "scalar"'), where
        )
    elif kind not in KINDS and kind not in PLANNED:
        help = f"this version reads: {known}; planned: {', '.join(PLANNED)}"
        if guess := near(kind, KINDS):
            help = f'did you mean "{guess}"?'
        problems.add(Fault(faults.KIND_NOT_BUILT, f'there is no kind "{shown(kind)}"', help), where)
    elif wanted not in (None, kind):
        problems.add(
            Fault(faults.KIND_NOT_BUILT, f"a file of kind {wanted} was expected, not {kind}", "name another file"),
            where,
        )
    elif wanted is None and (message := lacking(kind, capability)) is not None:
        problems.add(Fault(faults.KIND_NOT_BUILT, message, f"this version does it for kind {known}"), where)
    elif wanted is None and "kind" not in document and kind == "matrices":
        message = "a family of matrices is a scheme where the file says so"
        problems.add(Fault(faults.KIND_NOT_BUILT, message, 'add kind = "matrices", or use subdiv jsr'), where)
    else:
        return kind
    problems.raise_any()
    raise AssertionError("unreachable: there is a problem")


def _answered(kind: Kind) -> tuple[str, ...]:
    """The keys of [expect] that findings of a kind answer."""
    questions = {question for rule in kind.rules().values() for question in rule.answers}
    return tuple(row.key for row in PROPERTIES if row.expected and row.question in questions)


def _has_matrices(mask: object) -> bool:
    """Whether the coefficients of a mask in one variable are lists of lists of numbers."""
    if not isinstance(mask, dict) or isinstance(mask.get("start"), list) or "dilation" in mask:
        return False
    first, depth = mask.get("coefficients"), 0
    while isinstance(first, list) and first:
        first, depth = first[0], depth + 1
    return depth == 3


def _is_meant(document: Mapping[str, object], problems: Collector) -> None:
    """Refuses a document that does not look like a mask at all; a misspelt [mask] passes."""
    if not document:
        problems.add(Fault(faults.NOT_A_MASK, "the file is empty", "write a mask: [mask] with start and coefficients"))
    elif not any(
        key.lower() in (*_TOP, *MARKS) or key.lower() in _BELONGS or near(key, ("mask", "kind", "matrices"))
        for key in list(document)[:50]
    ):
        help = "a mask file has [mask] with start and coefficients, or symbol"
        problems.add(Fault(faults.NOT_A_MASK, "this is TOML, but no mask file: it has no kind, mask or matrices", help))
    problems.raise_any()


def _format(document: Mapping[str, object], problems: Collector) -> None:
    """Records a format that is not 1."""
    version = document.get("format", 1)
    if isinstance(version, bool) or not isinstance(version, int):
        problems.add(
            Fault(faults.WRONG_TYPE, f"format must be 1, not {described(version)}", "write format = 1"), ("format",)
        )
    elif version != 1:
        given = str(version) if version.bit_length() < 64 else "a long number"
        help = "write format = 1, or use a newer subdiv"
        problems.add(Fault(faults.WRONG_TYPE, f"format must be 1, not {given}", help), ("format",))


def _expectations(table: Table | None, kind: Kind, problems: Collector) -> tuple[Expectation, ...]:
    """The expectations of [expect]; what is wrong with them, or not answered by the kind, is recorded."""
    expectations: list[Expectation] = []
    for key, value in table.data.items() if table else ():
        try:
            expectations.append(expectation(key, value))
            if key not in (answered := _answered(kind)):
                help = f"properties of this kind: {', '.join(answered)}"
                raise Fault(faults.UNKNOWN_KEY, f"masks of kind {kind.name} have no property {key}", help)
        except Fault as fault:
            problems.add(fault, ("expect", key), of_key=fault.rule is faults.UNKNOWN_KEY)
    for later, contradiction in contradictions(expectations):
        problems.add(contradiction, ("expect", later))
    return tuple(expectations)
