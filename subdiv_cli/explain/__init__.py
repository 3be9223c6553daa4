"""The pages, as Markdown in `pages/`: `SDnnn.md` of a finding code, which begins `# SD101 residue-sums`, and others.

The others are of a kind of scheme, whose name they bear (`scalar.md`, `# scalar`), or of a subject such as `formats`.
"""

from __future__ import annotations

from pathlib import Path

_PAGES = Path(__file__).with_name("pages")


class UnknownPageError(KeyError):
    """Raised for a name without a page; `near` has names that are like it."""

    def __init__(self, name: str, near: list[str]) -> None:
        super().__init__(name)
        self.name = name
        self.near = near

    def __str__(self) -> str:
        guess = f"Did you mean {' or '.join(self.near)}?" if self.near else "`subdiv explain` lists the pages."
        return f"there is no page {self.name!r}. {guess}"


def codes() -> list[str]:
    """All codes that have a page, in order."""
    return sorted(path.stem for path in _PAGES.glob("SD*.md"))


def subjects() -> list[str]:
    """The names of the pages that are of no code, in order: kinds of schemes, outputs, and the like."""
    return sorted({path.stem for path in _PAGES.glob("*.md")} - set(codes()))


def title(code: str) -> str:
    """The code in words, for instance `residue-sums`: the rest of the first line of its page."""
    with (_PAGES / f"{code}.md").open(encoding="utf-8") as file:
        return file.readline().removeprefix("#").strip().removeprefix(code).strip()


def page(name: str) -> str:
    """The page of a code (`SD101`, `sd101`), of a finding's name (`residue-sums`) or of a subject (`scalar`).

    Raises UnknownPageError.
    """
    pages = {title(code): code for code in codes()}
    pages |= {stem.lower(): stem for stem in [*subjects(), *codes()]}
    wanted = name.strip().lower()
    if wanted not in pages:
        from difflib import get_close_matches

        raise UnknownPageError(name.strip(), [_shown(near) for near in get_close_matches(wanted, pages, n=3)])
    return (_PAGES / f"{pages[wanted]}.md").read_text(encoding="utf-8")


def _shown(name: str) -> str:
    """A code in capitals, as reports have it; another name as it is."""
    return name.upper() if name.upper() in codes() else name
