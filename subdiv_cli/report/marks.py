"""The marks of verdicts and of masks, one table for all formats: a sign and a word always, never colour alone."""

from __future__ import annotations

from typing import NamedTuple

from subdiv_cli.model import Finding, Result, Verdict
from subdiv_cli.model.findings import HOLDER_ATTAINED, NEXT_SMOOTHNESS


class Mark(NamedTuple):
    """A sign, its letter where a console has ASCII only, its picture in Markdown, and the role of its colour."""

    sign: str
    ascii: str
    role: str
    picture: str = ""


MARKS = {
    "proved": Mark("✓", "+", "good"),
    "refuted": Mark("✗", "x", "bad"),
    "sharp": Mark("○", "o", "text"),
    "undecided": Mark("?", "?", "open", "❔"),
    "skipped": Mark("–", "-", "none"),
    "passed": Mark("✓", "+", "good", "✅"),
    "failed": Mark("✗", "x", "bad", "❌"),
    "invalid": Mark("!", "!", "bad", "🚫"),
}
"""The marks by verdict and by status; `sharp` is a refutation by which a mask fails nothing, and its word `refuted`."""
STATUSES = ("passed", "failed", "undecided", "invalid")
_SHARPENED = {NEXT_SMOOTHNESS: "smoothness", HOLDER_ATTAINED: "holder"}
"""The questions whose refutation makes a property sharp, and the key of that property."""


class Shown(NamedTuple):
    """A verdict or a status for a reader."""

    name: str
    """The key of its mark."""
    word: str

    @property
    def sign(self) -> str:
        """The sign alone: `✓`."""
        return MARKS[self.name].sign

    @property
    def role(self) -> str:
        """The role of its colour."""
        return MARKS[self.name].role

    @property
    def text(self) -> str:
        """The sign and the word: `✓ proved`."""
        return f"{self.sign} {self.word}"


def of_verdict(verdict: Verdict) -> Shown:
    """A verdict by itself: `✓ proved`."""
    return Shown(verdict.value, verdict.value)


def of_status(status: str) -> Shown:
    """The status of a mask: `✓ passed`."""
    return Shown(status, status)


def of_finding(result: Result, finding: Finding) -> Shown:
    """The verdict of a finding on a mask: `✗ refuted`, or `○ refuted` where that is its sharpness."""
    word = finding.verdict.value
    return Shown("sharp" if is_sharpness(result, finding) else word, word)


def is_sharpness(result: Result, finding: Finding) -> bool:
    """Whether a refuted finding only says that a scheme that converges is not better still.

    It answers no question but those that make a property sharp, and refutes no expectation of that property.
    """
    if finding.verdict is not Verdict.REFUTED or result.convergent is not Verdict.PROVED or result.regressions:
        return False
    questions = [question for question, _ in finding.answers]
    if not set(questions) <= _SHARPENED.keys():
        return False
    keys = {_SHARPENED[question] for question in questions} or {"smoothness"}
    return not any(
        judged.verdict is Verdict.REFUTED and judged.expectation.key in keys for judged in result.expectations
    )
