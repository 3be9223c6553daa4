"""Progress on a terminal: counts, what did not pass, the slowest; elsewhere not a byte."""

import io

import pytest
from cli_samples import result

from subdiv_cli.catalog.task import Done
from subdiv_cli.cli import progress as module
from subdiv_cli.cli.progress import Progress
from subdiv_cli.model import Effort, watch
from subdiv_cli.model.watch import At


@pytest.fixture(autouse=True)
def at_once(monkeypatch):
    monkeypatch.setattr(module, "PAUSE", 0)
    monkeypatch.setenv("TERM", "xterm-256color")
    monkeypatch.setenv("COLUMNS", "60")


def run(terminal, *dones):
    made = io.StringIO()
    made.isatty = lambda: terminal
    progress = Progress(made)
    progress.begin(len(dones))
    for done in dones:
        progress.step(done)
    return progress, made


DONES = [Done(result("passed"), seconds=0.25), Done(result("failed"), seconds=2), Done(result("passed"), cached=True)]


def test_a_terminal_sees_counts_and_the_slowest():
    progress, made = run(True, *DONES)
    shown = made.getvalue().split("\r")
    assert shown[1].rstrip() == "1/3 masks, slowest passed.toml 0.2 s"
    assert shown[2].rstrip() == "2/3 masks, 1 not passed, slowest failed.toml 2.0 s"
    progress.close()
    assert made.getvalue().endswith("\r" + " " * len(shown[3]) + "\r")


def test_a_file_or_a_single_mask_sees_nothing():
    assert run(False, *DONES)[1].getvalue() == ""
    assert run(True, DONES[0])[1].getvalue() == ""


def test_the_line_is_never_longer_than_the_terminal(monkeypatch):
    monkeypatch.setenv("COLUMNS", "20")
    _, made = run(True, *DONES)
    assert max(len(line) for line in made.getvalue().split("\r")) == 19


def test_names_are_harmless():
    nasty = Done(result("passed").__class__(file="a\x1b[2J.toml", status="passed"), seconds=1)
    assert "\x1b" not in run(True, nasty, nasty)[1].getvalue()


def test_what_is_told_afterwards():
    progress, made = run(False, *DONES)
    progress.tell()
    assert made.getvalue().splitlines() == [
        "1 of 3 masks from the cache, verified again",
        "   2.000 s  failed.toml",
        "   0.250 s  passed.toml",
        "   0.000 s  passed.toml",
    ]


@pytest.fixture
def heard(monkeypatch):
    """What is heard while there is a listener."""
    heard = []
    watch.listen(lambda at: heard.append(str(at)))
    yield heard
    watch.listen(None)


def test_who_listens_hears_where_the_clock_is_looked_at(heard, monkeypatch):
    monkeypatch.setattr(watch, "PAUSE", 0)
    watch.begin("joint radius")
    watch.count(1234, "vertices")
    Effort(5).limited(3).allows(2)
    watch.begin("checker")
    assert heard == ["joint radius", "joint radius, 1,234 vertices", "checker"]
    watch.listen(None)
    watch.begin("nobody hears this")
    assert len(heard) == 3


def test_a_listener_is_not_told_too_often(heard):
    watch.begin("smoothness")
    for number in range(1000):
        watch.count(number, "products")
        watch.look()
    assert heard[0] == "smoothness"
    assert len(heard) < 10


def test_one_mask_shows_what_it_is_at_once_it_takes_long(monkeypatch):
    made = io.StringIO()
    made.isatty = lambda: True
    progress = Progress(made)
    with progress.watching():
        watch.begin("sum rules")
        assert made.getvalue() == ""
        monkeypatch.setattr(module, "PATIENCE", 0)
        watch.tell(At("joint radius", 312, "vertices"))
        assert made.getvalue() == "\rjoint radius, 312 vertices, 0 s"
        progress.begin(2)
        progress.step(DONES[0])
        watch.begin("checker")
        assert made.getvalue().endswith("\r1/2 masks, slowest passed.toml 0.2 s; checker, 0 s")
    assert made.getvalue().endswith(" \r")
    assert not watch.is_heard()


def test_nobody_listens_where_there_is_no_terminal():
    made = io.StringIO()
    with Progress(made).watching():
        assert not watch.is_heard()
