"""Streams and files: encodings, colour, pipes that break, writing whole files."""

import io
import os
import stat
from pathlib import Path

import pytest

from subdiv_cli.catalog.files import write_whole
from subdiv_cli.cli.streams import (
    columns,
    emit,
    has_colour,
    look_of,
    speaks_mathematics,
    why_not,
)


def stream(encoding="utf-8", terminal=False):
    made = io.TextIOWrapper(io.BytesIO(), encoding=encoding)
    made.isatty = lambda: terminal
    return made


@pytest.fixture(autouse=True)
def environment(monkeypatch):
    for name in ("COLUMNS", "NO_COLOR", "FORCE_COLOR"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("TERM", "xterm-256color")


@pytest.mark.parametrize(("encoding", "speaks"), [("utf-8", True), ("ascii", False), ("latin-1", False)])
def test_encodings(encoding, speaks):
    assert speaks_mathematics(stream(encoding)) is speaks
    assert look_of(stream(encoding)).unicode is speaks


@pytest.mark.parametrize(
    ("terminal", "environment", "colour"),
    [
        (True, {}, True),
        (False, {}, False),
        (True, {"NO_COLOR": "1"}, False),
        (True, {"NO_COLOR": ""}, True),
        (True, {"TERM": "dumb"}, False),
        (False, {"FORCE_COLOR": "1"}, True),
        (True, {"FORCE_COLOR": "1", "NO_COLOR": "1"}, False),
    ],
)
def test_colour(monkeypatch, terminal, environment, colour):
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert has_colour(stream(terminal=terminal)) is colour


def test_columns(monkeypatch):
    assert columns(stream()) == 100
    monkeypatch.setattr(os, "get_terminal_size", lambda _: os.terminal_size((300, 9)))
    made = stream()
    made.fileno = lambda: 1
    assert columns(made) == 120
    monkeypatch.setenv("COLUMNS", "40")
    assert columns(made) == 40
    monkeypatch.setenv("COLUMNS", "wide")
    assert columns(made) == 120


@pytest.mark.parametrize("encoding", ["utf-8", "ascii", "latin-1", "cp437"])
def test_emit_never_fails_on_a_letter(encoding):
    made = stream(encoding)
    emit("φ \udc80 é\n", made)
    assert made.buffer.getvalue().endswith(b"\n")


def test_emit_json_is_utf8_whatever_the_console():
    made = stream("ascii")
    emit("φ", made, encoding="utf-8")
    assert made.buffer.getvalue() == "φ".encode()


def test_a_reader_that_went_away_is_no_error():
    ours, theirs = os.pipe()
    os.close(ours)
    with os.fdopen(theirs, "w", encoding="utf-8") as made:
        emit("x" * 10_000, made)
        emit("again", made)


def test_a_failure_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "report.json"
    path.write_text("old", encoding="utf-8")

    def fail(self, target):
        assert Path(self).read_text("utf-8") == "new"
        raise OSError(5, "Input/output error")

    monkeypatch.setattr(Path, "replace", fail)
    with pytest.raises(OSError, match="Input/output"):
        write_whole(str(path), "new")
    assert path.read_text("utf-8") == "old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["report.json"]


def test_the_new_file_keeps_mode_and_link(tmp_path):
    path, link = tmp_path / "report.json", tmp_path / "link.json"
    path.write_text("old", encoding="utf-8")
    path.chmod(0o640)
    link.symlink_to(path)
    write_whole(str(link), "new φ")
    assert link.is_symlink()
    assert path.read_text("utf-8") == "new φ"
    assert stat.S_IMODE(path.stat().st_mode) == 0o640


def test_what_is_not_a_plain_file_is_written_to():
    write_whole(os.devnull, "text")
    assert not Path(os.devnull).is_file()
    assert why_not(os.devnull) is None


def test_why_not(tmp_path):
    assert why_not(str(tmp_path / "x")) is None
    assert why_not(str(tmp_path)) == "it is a directory"
    assert "no directory" in why_not(str(tmp_path / "no" / "x"))
