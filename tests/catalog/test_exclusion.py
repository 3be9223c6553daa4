"""What a search of directories leaves out: patterns, and what git ignores; what is named is always there."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest
from test_discovery import MASK, names

from subdiv_cli.catalog.discovery import discover
from subdiv_cli.catalog.exclusion import Exclusion, ignored_by_git
from subdiv_cli.model import Problem

GIT = pytest.mark.skipif(shutil.which("git") is None, reason="git ignores, where there is git")
FILES = (
    "a.toml",
    "a_old.toml",
    "drafts/b.toml",
    "sub/c.toml",
    "sub/c_old.toml",
    "sub/drafts/d.toml",
    "sub/deep/e.toml",
)


@pytest.fixture
def tree(tmp_path, monkeypatch):
    for name in FILES:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(MASK)
    monkeypatch.chdir(tmp_path)
    for name in os.environ:
        if name.startswith("GIT_"):
            monkeypatch.delenv(name)
    return tmp_path


@pytest.mark.parametrize(
    ("pattern", "gone"),
    [
        ("drafts", {"drafts/b.toml", "sub/drafts/d.toml"}),
        ("drafts/", {"drafts/b.toml", "sub/drafts/d.toml"}),
        ("./drafts", {"drafts/b.toml"}),
        ("*_old.toml", {"a_old.toml", "sub/c_old.toml"}),
        ("[!a]_old.toml", {"sub/c_old.toml"}),
        ("?.toml", {"a.toml", "drafts/b.toml", "sub/c.toml", "sub/drafts/d.toml", "sub/deep/e.toml"}),
        ("./*.toml", {"a.toml", "a_old.toml"}),
        ("sub/*.toml", {"sub/c.toml", "sub/c_old.toml"}),
        ("sub/**/*.toml", {"sub/c.toml", "sub/c_old.toml", "sub/drafts/d.toml", "sub/deep/e.toml"}),
        ("**/d*", {"drafts/b.toml", "sub/drafts/d.toml", "sub/deep/e.toml"}),
        ("sub", {"sub/c.toml", "sub/c_old.toml", "sub/drafts/d.toml", "sub/deep/e.toml"}),
        ("a.tom", set()),
        ("A.TOML", set()),
        ("[.toml", set()),
        ("a(.toml", set()),
        ("", set()),
    ],
)
def test_patterns(tree, pattern, gone):
    expected = [name for name in names(discover([tree]), tree) if name not in gone]
    assert names(discover([tree], [pattern]), tree) == expected
    assert names(discover(["."], [pattern]), Path()) == expected, "however the directory is named"


def test_patterns_add_up_and_absolute_ones_are_paths_too(tree):
    patterns = ["*_old.toml", str(tree / "sub" / "deep"), "drafts"]
    assert names(discover([tree], patterns), tree) == ["a.toml", "sub/c.toml"]
    assert discover([tree], patterns).left_out == 5
    assert not Exclusion([]).covers(tree / "a.toml")


def test_what_is_named_is_there(tree):
    assert names(discover(["a_old.toml", "drafts", "*.toml"], ["*_old.toml", "drafts"]), Path()) == [
        "a_old.toml", "drafts/b.toml", "a.toml",
    ]  # fmt: skip


def test_a_directory_from_which_all_is_left_out(tree):
    (problem,) = discover([tree / "sub" / "deep"], ["e.toml"]).entries
    assert isinstance(problem, Problem)
    assert problem.code == "SD014"
    assert "besides what was left out: 1 that git ignores, or exclude" in problem.message


def git(*arguments, cwd):
    identity = ("-c", "user.name=x", "-c", "user.email=x@example.org", "-c", "init.defaultBranch=main")
    subprocess.run(["git", *identity, *arguments], cwd=cwd, check=True, capture_output=True)


@GIT
def test_what_git_ignores_is_left_out(tree):
    git("init", cwd=tree)
    (tree / ".gitignore").write_text("drafts/\n*_old.toml\n!/a_old.toml\n")
    assert names(discover([tree]), tree) == ["a.toml", "a_old.toml", "sub/c.toml", "sub/deep/e.toml"]
    assert discover(["."]).left_out == 3
    assert names(discover(["sub"]), Path()) == ["sub/c.toml", "sub/deep/e.toml"], "also of a directory below"
    assert names(discover(["sub/c_old.toml", "drafts"]), Path()) == ["sub/c_old.toml", "drafts/b.toml"]
    git("add", "--force", "sub/c_old.toml", cwd=tree)
    assert "sub/c_old.toml" in names(discover([tree]), tree), "what git follows it does not ignore"
    (tree / "sub" / ".gitignore").write_text("c*\n")
    assert names(discover(["sub"]), Path()) == ["sub/c_old.toml", "sub/deep/e.toml"]


@GIT
def test_a_hook_of_git_and_its_variables_change_nothing(tree, monkeypatch):
    git("init", cwd=tree)
    (tree / ".gitignore").write_text("drafts/\n")
    monkeypatch.setenv("GIT_DIR", ".git")
    monkeypatch.setenv("GIT_INDEX_FILE", ".git/other")
    assert names(discover(["sub"]), Path()) == ["sub/c.toml", "sub/c_old.toml", "sub/deep/e.toml"]


def test_without_git_or_a_repository_nothing_is_ignored(tree, monkeypatch):
    (tree / ".gitignore").write_text("*\n")
    assert ignored_by_git(str(tree)) == frozenset()
    (tree / ".git").mkdir()
    assert names(discover([tree]), tree) == names(discover([str(tree)]), tree) != []
    monkeypatch.setenv("PATH", "")
    assert ignored_by_git(str(tree)) == frozenset()
