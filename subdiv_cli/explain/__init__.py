"""The pages for finding codes, as Markdown in `pages/SDnnn.md`; the first line of each is `# SD101 residue-sums`.

Pages on kinds of masks stand beside them, `pages/hermite.md`, and begin with the name of the kind.
"""

from __future__ import annotations

from pathlib import Path

_PAGES = Path(__file__).with_name("pages")


class UnknownCodeError(KeyError):
    """Raised for a code without a page; `near` has codes that are like it."""

    def __init__(self, code: str, near: list[str]) -> None:
        super().__init__(code)
        self.code = code
        self.near = near

    def __str__(self) -> str:
        guess = f"Did you mean {' or '.join(self.near)}?" if self.near else "`subdiv explain` lists the codes."
        return f"there is no finding code {self.code!r}. {guess}"


def codes() -> list[str]:
    """All codes that have a page, in order."""
    return sorted(path.stem for path in _PAGES.glob("SD*.md"))


def kinds() -> list[str]:
    """All kinds of masks that have a page, in order."""
    return sorted(path.stem for path in _PAGES.glob("[a-z]*.md"))


def title(code: str) -> str:
    """The code in words, for instance `residue-sums`: the rest of the first line of its page."""
    with (_PAGES / f"{code}.md").open(encoding="utf-8") as file:
        return file.readline().removeprefix("#").strip().removeprefix(code).strip()


def page(code: str) -> str:
    """The page of a code (`SD101`, `sd101`), of its name (`residue-sums`) or of a kind. Raises UnknownCodeError."""
    if (kind := code.strip().lower()) in kinds():
        return (_PAGES / f"{kind}.md").read_text(encoding="utf-8")
    known = codes()
    wanted = code.strip().upper()
    if wanted not in known:
        wanted = _by_name(code.strip(), known)
    return (_PAGES / f"{wanted}.md").read_text(encoding="utf-8")


def _by_name(name: str, known: list[str]) -> str:
    names = {title(code).lower(): code for code in known}
    if name.lower() in names:
        return names[name.lower()]
    from difflib import get_close_matches

    near = get_close_matches(name.upper(), known, n=3) or get_close_matches(name.lower(), names, n=3)
    raise UnknownCodeError(name, near)
