"""The report as SARIF 2.1.0: a result for each error in a file and each expectation that is not proved."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from hashlib import sha256
from typing import Any
from urllib.parse import quote

import subdiv_cli
from subdiv_cli.model import Result
from subdiv_cli.report import words
from subdiv_cli.report.letters import clean
from subdiv_cli.report.look import Look
from subdiv_cli.report.notices import Notice, is_file, notices

_PLACE = "results of subdiv"
"""What stands for the results while the rest of the log is spelled."""
_LEVELS = {"error": "error", "warning": "warning", "note": "note"}


def pieces(results: Sequence[Result], look: Look) -> Iterator[str]:
    """The JSON of a log with one run."""
    rules = _rules(results, look)
    index = {rule["id"]: number for number, rule in enumerate(rules)}
    run = {
        "tool": {"driver": {"name": "subdiv", "semanticVersion": subdiv_cli.__version__, "rules": rules}},
        "columnKind": "unicodeCodePoints",
        "invocations": [{"executionSuccessful": not look.interrupted}],
        "results": [_PLACE] if rules else [],
        "properties": {"summary": words.summary(results)},
    }
    head, _, tail = _spelled({"version": "2.1.0", "runs": [run]}).partition(_spelled(_PLACE))
    yield head
    objects = (_result(result, notice, index) for result in results for notice in notices(result, look))
    for number, shown in enumerate(objects):
        yield (",\n        " if number else "") + _spelled(shown).replace("\n", "\n        ")
    yield tail + "\n"


def _spelled(data: Any) -> str:
    return json.dumps(data, ensure_ascii=False, indent=2)


def _rules(results: Sequence[Result], look: Look) -> list[dict[str, Any]]:
    """The rules of the log, one for each code of a notice, in their order."""
    names: dict[str, str] = {}
    codes: set[str] = set()
    for result in results:
        names |= {finding.code: finding.name for finding in result.findings}
        names |= {worse.code: "baseline" for worse in result.regressions or ()}
        codes |= {notice.code for notice in notices(result, look)}
    rules = []
    for code in sorted(codes):
        name = names.get(code, code)
        more = f"`subdiv explain {code}` says what it means." if code.startswith("SD") else "An expectation of a mask."
        rules.append({"id": code, "name": name, "shortDescription": {"text": name}, "help": {"text": more}})
    return rules


def _result(result: Result, notice: Notice, index: dict[str, int]) -> dict[str, Any]:
    name = clean(words.name(result))
    shown = {
        "ruleId": notice.code,
        "ruleIndex": index[notice.code],
        "kind": "informational" if notice.level == "note" else "fail",
        "level": "none" if notice.level == "note" else _LEVELS[notice.level],
        "message": {"text": f"{name}: {clean(notice.message)}"},
        "partialFingerprints": {"subdiv/v1": _fingerprint(result, notice)},
    }
    if is_file(result):
        shown["locations"] = [{"physicalLocation": _location(result, notice)}]
    return shown


def _location(result: Result, notice: Notice) -> dict[str, Any]:
    uri = quote(_bytes(result.file.replace("\\", "/")), safe="/")
    location: dict[str, Any] = {"artifactLocation": {"uri": f"file://{uri}" if uri.startswith("/") else uri}}
    if notice.line is not None:
        column = {} if notice.column is None else {"startColumn": notice.column}
        location["region"] = {"startLine": notice.line, **column}
    return location


def _fingerprint(result: Result, notice: Notice) -> str:
    """A key that is the same while the mask fails in the same way, wherever in its file that stands."""
    parts = (result.file, notice.code, notice.title)
    return sha256(_bytes("\0".join(parts))).hexdigest()[:32]


def _bytes(text: str) -> bytes:
    """The bytes of a file name as the system has them; of a text that is no file name its escapes."""
    try:
        return text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        return text.encode("utf-8", "backslashreplace")
