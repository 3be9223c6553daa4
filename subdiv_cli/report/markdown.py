"""The report as Markdown, for a comment under a pull request: counts, what did not pass and why, all masks folded away.

A comment has bounds (65,536 characters on GitHub): of long lists the beginning is shown and the rest counted.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from subdiv_cli.model import Result
from subdiv_cli.report import words
from subdiv_cli.report.letters import clean
from subdiv_cli.report.look import Look
from subdiv_cli.report.marks import MARKS
from subdiv_cli.report.notices import Notice, notices

_SPECIAL = re.compile(r"([\\`*_{}\[\]<>#|~$@])")
_TITLES = ("", "mask", "convergence", "smoothness", "Hölder exponent")
MOST = 50_000
"""The most characters of the two lists together."""


def pieces(results: Sequence[Result], look: Look) -> Iterator[str]:
    """The Markdown of the comment."""
    missed = (r for r in results if r.status != "passed" and not (look.allow_undecided and r.status == "undecided"))
    shown = _within((_failure(result, look) for result in missed), MOST)
    sign = MARKS["failed" if shown else "passed"].picture
    yield f"### {sign} subdiv: {words.footer(results, allow_undecided=look.allow_undecided)}\n\n"
    if look.interrupted:
        yield "The run was interrupted: not all masks were checked.\n\n"
    if shown:
        yield shown + "\n"
    if look.missing:
        yield "Of the baseline, not checked: " + ", ".join(map(_code, look.missing[:50])) + "\n\n"
    rows = _within(map(_row, results), MOST - len(shown))
    header = "| " + " | ".join(_TITLES) + " |\n" + "|---" * len(_TITLES) + "|\n"
    yield f"<details><summary>All masks</summary>\n\n{header}{rows}\n</details>\n"


def _failure(result: Result, look: Look) -> str:
    """The Markdown of a mask that did not pass, and why."""
    head = f"- {MARKS[result.status].picture} **{_text(words.name(result))}** ({_code(result.file)})\n"
    return head + "".join(f"  - {_notice(notice)}\n" for notice in notices(result, look))


def _notice(notice: Notice) -> str:
    place = "" if notice.line is None else f", line {notice.line}"
    return f"{_text(notice.message)} ({notice.code}{place})"


def _row(result: Result) -> str:
    if result.status == "invalid":
        cells = [_text(words.name(result)), words.errors(result), "", ""]
    else:
        properties = (words.convergence(result), words.smoothness_or_that_of_phi(result), words.holder(result))
        cells = [_text(words.name(result)), *(_text(text or "") for text in properties)]
    return f"| {MARKS[result.status].picture} {result.status} | " + " | ".join(cells) + " |\n"


def _within(pieces: Iterable[str], room: int) -> str:
    """The text of as many pieces as there is room for, and the number of those left out."""
    kept, left = [], 0
    for piece in pieces:
        if room < len(piece) or left:
            left += 1
            continue
        kept.append(piece)
        room -= len(piece)
    return "".join(kept) + (f"\n… and {left} more\n" if left else "")


def _text(text: str) -> str:
    """A text in which Markdown and HTML mean nothing."""
    return _SPECIAL.sub(r"\\\1", clean(text))


def _code(text: str) -> str:
    """A file name as code; one with a backtick in it as text."""
    text = clean(text)
    return _text(text) if "`" in text else f"`{text.replace('|', chr(92) + '|')}`"
