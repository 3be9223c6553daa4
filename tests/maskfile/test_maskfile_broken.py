"""Every broken file gives its problems, all of them: what, where, how to mend."""

from __future__ import annotations

import time

import broken_files
import broken_multivariate
import pytest
from broken_files import Broken

from subdiv_cli.kinds.reading import read_path, read_text
from subdiv_cli.maskfile import MaskFileError
from subdiv_cli.model import Problem

BROKEN = [*broken_files.BROKEN, *broken_multivariate.BROKEN]
AT_SCHEME = [*broken_files.AT_SCHEME, *broken_multivariate.AT_SCHEME]


def compare(broken: Broken, problems: tuple[Problem, ...]) -> None:
    assert [(p.code, p.key, p.line, p.column) for p in problems] == [
        (e.code, e.key, e.line, e.column) for e in broken.problems
    ]
    lines = broken.text.split("\n")
    for problem, expected in zip(problems, broken.problems, strict=True):
        assert expected.message in problem.message
        assert problem.help is not None
        assert expected.help in problem.help
        assert problem.file == "broken.toml"
        assert problem.source == (None if problem.line is None else lines[problem.line - 1].rstrip("\r"))
        for text in (problem.message, problem.help):
            assert "\n" not in text
            assert len(text) < 240
            assert "Traceback" not in text


@pytest.mark.parametrize("broken", BROKEN, ids=lambda broken: broken.name)
def test_broken_file(broken: Broken) -> None:
    started = time.monotonic()
    with pytest.raises(MaskFileError) as caught:
        read_text(broken.text, file="broken.toml")
    assert time.monotonic() - started < 2
    compare(broken, caught.value.problems)


@pytest.mark.parametrize("broken", AT_SCHEME, ids=lambda broken: broken.name)
def test_broken_at_its_parameters(broken: Broken) -> None:
    mask = read_text(broken.text, file="broken.toml")
    with pytest.raises(MaskFileError) as caught:
        mask.scheme()
    compare(broken, caught.value.problems)


def test_there_are_enough_and_each_code_is_met() -> None:
    assert len({broken.text for broken in BROKEN}) == len(BROKEN) >= 120
    codes = {e.code for broken in (*BROKEN, *AT_SCHEME) for e in broken.problems}
    on_disk = {"SD002", "SD014"}  # below and in the tests of discovery
    assert codes | on_disk == {f"SD{n:03}" for n in (*range(1, 17), 22, 23, 24)}


def problem_of(path: object) -> Problem:
    with pytest.raises(MaskFileError) as caught:
        read_path(path)  # type: ignore[arg-type]
    (problem,) = caught.value.problems
    assert problem.file == str(path)
    return problem


def test_missing_file(tmp_path):
    problem = problem_of(tmp_path / "none.toml")
    assert (problem.code, problem.message) == ("SD002", "there is no such file")
    assert problem_of("a\x00b").code == "SD002"


def test_directory(tmp_path):
    problem = problem_of(tmp_path)
    assert problem.code == "SD002"
    assert "is a directory" in problem.message


def test_name_too_long_for_the_system():
    assert problem_of("x" * 5000).code == "SD002"


def test_permission(tmp_path, monkeypatch):
    def denied(*_args, **_kwargs):
        raise PermissionError(13, "Permission denied")

    path = tmp_path / "secret.toml"
    path.write_text("")
    monkeypatch.setattr("pathlib.Path.open", denied)
    problem = problem_of(path)
    assert "permission" in problem.message
    assert problem.help is not None
    assert "chmod" in problem.help


def test_too_big_is_not_read(tmp_path):
    path = tmp_path / "big.toml"
    with path.open("wb") as stream:
        stream.truncate(10**10)
    assert problem_of(path).code == "SD010"


def test_not_utf8(tmp_path):
    path = tmp_path / "latin.toml"
    path.write_bytes('name = "x"\nreference = "Hölder"\n'.encode("latin-1"))
    problem = problem_of(path)
    assert (problem.code, problem.line, problem.column) == ("SD002", 2, 15)
    assert "byte 0xf6 at byte 26" in problem.message
    assert problem.help == "save it as UTF-8"
    path.write_bytes("[mask]\n".encode("utf-16"))
    problem = problem_of(path)
    assert problem.help is not None
    assert "UTF-16" in problem.help


def test_too_many_problems_are_cut():
    text = "\n".join(f"key{i} = 1" for i in range(5000)) + "\n[mask]\nsymbol = '1'\n"
    with pytest.raises(MaskFileError) as caught:
        read_text(text, file="x")
    assert len(caught.value.problems) == 51
    assert caught.value.problems[-1].message == "4950 more problems in this file are not shown"
