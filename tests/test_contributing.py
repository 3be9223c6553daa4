"""The page for contributors is true: its picture is the table of arrows, its sessions run, its paths and codes exist.

`python tests/test_contributing.py` draws the picture in the page anew.
"""

import doctest
import re
from pathlib import Path

from test_house import ARROWS, BETWEEN_KINDS

import subdiv_cli
from subdiv_cli.explain import codes

ROOT = Path(__file__).parents[1]
PAGE = ROOT / ".github" / "CONTRIBUTING.md"
PICTURE = re.compile(r"(?<=<!-- the picture -->\n```text\n).*?(?=```\n)", re.DOTALL)
SESSION = re.compile(r"^```pycon\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NAMED = re.compile(r"`([^`\n]+)`")
PATH = re.compile(r"(?:subdiv_cli|tests|masks|\.github|\.ci)(?:/[\w.-]+)*/?|README\.md|pyproject\.toml")
FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE


def text():
    return PAGE.read_text(encoding="utf-8")


def picture(arrows, between_kinds):
    """Rooms as stairs: in a room's column, under its corner, are marked the rooms that it may import."""
    used = set().union(*arrows.values())
    rooms = [room for room in arrows if arrows[room] or room in used]

    def height(room):
        return 1 + max(map(height, arrows[room]), default=0)

    rooms.sort(key=height, reverse=True)
    lines = []
    for row, room in enumerate(rooms):
        marks = ["●" if room in arrows[other] else "·" for other in rooms[:row]]
        lines.append(f"{room:<12}" + "".join(f" {mark}" for mark in [*marks, "┐"]))
    lines += [f"kinds/{kind} → kinds/{below}" for kind in between_kinds for below in sorted(between_kinds[kind])]
    return "\n".join(lines) + "\n"


def test_the_picture_is_the_table_of_arrows():
    (drawn,) = PICTURE.findall(text())
    assert drawn == picture(ARROWS, BETWEEN_KINDS), "draw it anew: python tests/test_contributing.py"


def test_the_picture_shows_every_arrow():
    lines = picture({"c": {"a", "b"}, "b": {"a"}, "a": set(), "alone": set()}, {"x": set(), "y": {"x"}}).splitlines()
    assert [line.split() for line in lines] == [["c", "┐"], ["b", "●", "┐"], ["a", "●", "●", "┐"], lines[3].split()]
    assert lines[3] == "kinds/y → kinds/x"


def test_every_room_is_described():
    described = {name for line in text().splitlines() if line.startswith("| `") for name in NAMED.findall(line)}
    assert {room for room in ARROWS if not room.startswith("__")} <= described


def test_the_sessions_print_what_is_shown():
    """One after the other, in one interpreter."""
    page, names, heard = text(), {}, []
    for found in SESSION.finditer(page):
        line = page.count("\n", 0, found.start()) + 1
        session = doctest.DocTestParser().get_doctest(found[1], names, "a session", str(PAGE), line)
        session.globs = names
        runner = doctest.DocTestRunner(optionflags=FLAGS)
        runner.run(session, out=heard.append, clear_globs=False)
        assert runner.tries > 0
        assert not runner.failures, "".join(heard)
    assert names


def paths(page):
    """What is named in the page and begins as a path of this repository; `<kind>` and `SDnnn` stand for any."""
    names = NAMED.findall(page) + re.findall(r"\]\(([^)#]+)\)", page)
    for name in names:
        for part in name.split():
            if PATH.fullmatch(part.removeprefix("../")):
                yield part.removeprefix("../")


def test_every_path_that_is_named_exists():
    named = set(paths(text()))
    assert len(named) > 30
    assert not [path for path in sorted(named) if not (ROOT / path).exists()]


def test_every_path_in_a_command_exists():
    """In the fenced blocks of shell commands too."""
    blocks = re.findall(r"^```sh\n(.*?)^```$", text(), re.MULTILINE | re.DOTALL)
    named = {word for block in blocks for word in block.split() if PATH.fullmatch(word)}
    assert named
    assert not [path for path in sorted(named) if not (ROOT / path).exists()]


def test_every_name_in_the_code_exists():
    """Whatever is set as code and is a name, or dotted names, or a call of one: a word of the sources."""
    files = [
        file for folder in ("subdiv_cli", "tests") for file in (ROOT / folder).rglob("*") if file != Path(__file__)
    ]
    sources = [file.read_text(encoding="utf-8") for file in files if file.suffix == ".py"]
    words = {file.stem for file in files}.union(*(re.findall(r"\w+", source) for source in sources))
    named = {name for name in NAMED.findall(text()) if re.fullmatch(r"[A-Za-z_][\w.]*(\(.*\))?", name)}
    parts = {part for name in named for part in name.partition("(")[0].removesuffix(".md").split(".")}
    assert len(parts) > 40
    assert parts - words <= {"SDnnn"}


def test_every_code_that_is_named_exists():
    assert set(re.findall(r"\bSD\d{3}\b", text())) <= set(codes())


def test_what_is_cited_is_this_version():
    assert f"version = {{{subdiv_cli.__version__}}}" in text()


def test_it_is_read_in_a_quarter_of_an_hour():
    assert len(text().splitlines()) <= 400


if __name__ == "__main__":
    page = text()
    start, end = PICTURE.search(page).span()
    PAGE.write_text(page[:start] + picture(ARROWS, BETWEEN_KINDS) + page[end:], encoding="utf-8")
