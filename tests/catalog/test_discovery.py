"""Arguments -> files: searched, sorted, once each, and a problem instead of an exception."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from subdiv_cli.catalog.discovery import Discovery, discover
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.maskfile import MaskFileError
from subdiv_cli.model import Problem

MASK = "[mask]\nstart = 0\ncoefficients = [1, 1]\n"


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    files = {
        "b.toml": MASK,
        "a.toml": 'kind = "vector"\n',
        "notes.txt": MASK,
        "settings.toml": "[tool]\nx = 1\n",
        "sub/c.toml": 'kind = "matrices"\nmatrices = []\n',
        "sub/broken.toml": "[mask]\ncoefficients = [1/2]\n",
        "sub/deep/d.toml": MASK,
        "Z/e.toml": MASK,
        ".git/f.toml": MASK,
        ".venv/lib/g.toml": MASK,
        ".#b.toml": MASK,
        "empty/readme.md": "",
    }
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return tmp_path


def names(found: Discovery, root: Path) -> list[str]:
    return [e if e == "-" else str(Path(e).relative_to(root)) for e in found.entries if isinstance(e, str)]


def test_a_directory_is_searched_in_a_stable_order(tree: Path) -> None:
    found = discover([tree])
    assert names(found, tree) == ["a.toml", "b.toml", "Z/e.toml", "sub/broken.toml", "sub/c.toml", "sub/deep/d.toml"]
    assert found.skipped == 1
    assert discover([str(tree)]) == found


def test_the_order_of_arguments_is_kept_and_nothing_comes_twice(tree: Path) -> None:
    (tree / "link.toml").symlink_to(tree / "b.toml")
    found = discover([tree / "sub", "-", tree / "b.toml", tree / "sub" / ".." / "b.toml", tree, "-"])
    assert names(found, tree)[:5] == ["sub/broken.toml", "sub/c.toml", "sub/deep/d.toml", "-", "b.toml"]
    assert names(found, tree)[5:] == ["a.toml", "Z/e.toml"]


def test_loops_of_links_are_harmless(tree: Path) -> None:
    (tree / "sub" / "loop").symlink_to(tree, target_is_directory=True)
    (tree / "sub" / "self").symlink_to(tree / "sub" / "self")
    (tree / "gone.toml").symlink_to(tree / "nowhere")
    found = discover([tree])
    assert len(names(found, tree)) == 7  # the dangling link is for the reader to report
    assert len(set(found.entries)) == len(found.entries)


def test_relative_paths_stay_relative(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tree)
    assert discover(["."]).entries[0] == "a.toml"
    assert discover(["sub"]).entries[0] == str(Path("sub/broken.toml"))


def test_an_explicit_file_is_left_to_the_reader(tree: Path) -> None:
    assert names(discover([tree / "settings.toml", tree / "notes.txt"]), tree) == ["settings.toml", "notes.txt"]
    assert names(discover([tree / ".git"]), tree) == [".git/f.toml"]


def test_what_is_not_there(tree: Path) -> None:
    found = discover([tree / "none.toml", tree / "empty", tree / "b.toml", "a\x00b", "x" * 5000])
    codes = [e.code if isinstance(e, Problem) else e for e in found.entries]
    assert codes == ["SD002", "SD014", str(tree / "b.toml"), "SD002", "SD002"]
    problems = [e for e in found.entries if isinstance(e, Problem)]
    assert problems[0].file == str(tree / "none.toml")
    assert problems[1].message == "no mask files in this directory"
    assert all(p.help for p in problems)


def test_an_empty_name_is_not_the_directory_here(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tree)
    (problem,) = discover([""]).entries
    assert isinstance(problem, Problem)
    assert (problem.code, problem.message) == ("SD002", "the name of a file is empty")


def test_a_directory_with_other_toml_files_only(tmp_path: Path) -> None:
    (tmp_path / "pyproject.toml").write_text("[project]\n")
    found = discover([tmp_path])
    (problem,) = found.entries
    assert isinstance(problem, Problem)
    assert (problem.code, found.skipped) == ("SD014", 1)
    assert "one other TOML file" in problem.message


def test_a_directory_that_cannot_be_listed(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    scandir = os.scandir

    def refuse(path: object) -> object:
        if Path(str(path)).name == "sub":
            raise PermissionError(13, "Permission denied")
        return scandir(str(path))

    monkeypatch.setattr("os.scandir", refuse)
    found = discover([tree])
    assert [e.code for e in found.entries if isinstance(e, Problem)] == ["SD002"]
    assert names(found, tree) == ["a.toml", "b.toml", "Z/e.toml"]


def test_pipes_do_not_block(tree: Path) -> None:
    os.mkfifo(tree / "pipe.toml")
    assert "pipe.toml" not in names(discover([tree]), tree)


def test_broken_text_and_big_files_are_recognised(tree: Path) -> None:
    (tree / "latin.toml").write_bytes(b"name = '\xe9'\n[mask]\n")
    (tree / "big.toml").write_text("[mask]\n" + "#" * 2_000_000)
    assert {"latin.toml", "big.toml"} <= set(names(discover([tree]), tree))


@pytest.mark.parametrize(
    "text",
    [
        "",
        "# nothing yet\n",
        MASK.replace("mask", "masks"),
        "start = 0\ncoefficients = [1, 1]\n",
        "symbol = '1 + z'\n",
        "[expect]\nconvergent = true\n",
        "[parameters]\nw = 1\n",
        "arity = 2\n",
        "[msk]\nstart = 0\ncoefs = [1, 1]\n",
    ],
)
def test_misspelt_masks_are_not_passed_over(tmp_path: Path, text: str) -> None:
    (tmp_path / "misspelt.toml").write_text(text)
    (tmp_path / "good.toml").write_text(MASK)
    (tmp_path / "pyproject.toml").write_text("[project]\nname = 'x'\n[tool.ruff]\nline-length = 100\n")
    (tmp_path / "ruff.toml").write_text("line-length = 100\n[lint]\nselect = ['E']\n")
    found = discover([tmp_path])
    assert names(found, tmp_path) == ["good.toml", "misspelt.toml"]
    assert found.skipped == 2
    with pytest.raises(MaskFileError):
        read_path(tmp_path / "misspelt.toml")
