"""Every command and format on poor terminals: 40 columns, no colour, ASCII only."""

import os
import pty
import re
import subprocess
import sys

import pytest
from runs import SUBDIV, masks
from support import subdiv

from subdiv_cli.catalog.shipped import masks_directory
from subdiv_cli.report import FORMATS

SHIPPED = masks_directory() / "scalar"
SOME = [str(SHIPPED / "four_point.toml"), str(SHIPPED / "counterexamples" / "four_point_1_2.toml")]
POOR = {"COLUMNS": "40", "NO_COLOR": "1", "TERM": "dumb"}
COMMANDS = [
    ["--help"], ["check", "--help"], ["list", "--help"], ["merge", "--help"], ["clean", "--help"], ["verify", "--help"],
    ["explain", "--help"], ["completion", "--help"], ["explain"], ["explain", "SD301"], ["list"], ["list", "zzz"],
    ["check", *SOME], ["check", *SOME, "-v"], ["check", *SOME, "-vv"], ["check", *SOME, "-q"],
    ["check", "nowhere.toml"],    ["check", "--require", "C9", *SOME], ["check", "--require", "nonsense", *SOME],
    ["merge", "nowhere.json"],
    ["smooth", "--help"], ["smooth", SOME[0]], ["smooth", SOME[1]], ["smooth", "nowhere.toml"],
    ["show", "--help"], ["show", SOME[0]], ["show", "nowhere.toml"], ["plot", "--help"], ["plot", SOME[0]],
    ["jsr", "--help"], ["jsr", "nowhere.toml"], ["verify", "nowhere.json"],
    ["completion", "bash"],
]  # fmt: skip


def poor(*arguments):
    return subdiv(*arguments, encoding="ascii", **POOR)


@pytest.mark.parametrize("arguments", COMMANDS, ids=" ".join)
def test_in_ascii_without_colour(arguments):
    done = poor(*arguments)
    assert done.returncode in (0, 1, 2)
    for text in (done.stdout, done.stderr):
        assert "\x1b" not in text
        assert "Traceback" not in text
        assert not re.search(r"\\u[0-9a-f]{4}|\\x[0-9a-f]{2}", text) or arguments[0] == "completion"


NARROW = [
    *(["check", *SOME], ["check", *SOME, "-v"], ["check", SOME[0]], ["list"]),
    *(["show", SOME[0]], ["plot", SOME[0]], ["explain"], ["explain", "SD301"]),
]


@pytest.mark.parametrize("arguments", NARROW, ids=" ".join)
def test_forty_columns(arguments):
    """Nothing is wider but paths, which are there to be copied, the rows of matrices, and masks."""
    for line in poor(*arguments).stdout.splitlines():
        assert (
            len(line) <= 40 or ".toml" in line or "/" in line or line.endswith("|") or line.startswith("coefficients")
        ), line


@pytest.mark.parametrize("form", FORMATS)
def test_every_format_has_the_same_bytes_wherever_it_goes(form):
    rich = subdiv("check", *SOME, "--format", form)
    told = poor("check", *SOME, "--format", form)
    if form in ("text", "concise"):
        assert told.stdout.isascii()
    else:
        timeless = (re.sub(rb' time="[0-9.]+"', b"", run.stdout_bytes) for run in (told, rich))
        assert len(set(timeless)) == 1


def on_a_terminal(arguments, command=SUBDIV, **environment):
    """stdout and stderr as a terminal gets them."""
    leader, follower = pty.openpty()
    environment = {**os.environ, "COLUMNS": "40", "TERM": "xterm-256color", **environment}
    process = subprocess.Popen(
        [*command, *arguments], stdin=follower, stdout=follower, stderr=follower, env=environment, close_fds=True
    )
    os.close(follower)
    shown = b""
    while True:
        try:
            piece = os.read(leader, 4096)
        except OSError:
            break
        if not piece:
            break
        shown += piece
    os.close(leader)
    return process.wait(60), shown.decode("utf-8")


@pytest.mark.skipif(sys.platform == "win32", reason="no pseudo-terminals")
def test_progress_on_a_real_terminal(tmp_path):
    code, shown = on_a_terminal(["check", str(masks(tmp_path, 120)), "--jobs", "2", "--no-cache", "-q"])
    assert code == 0
    assert re.search(r"\r\d+/120 masks, slowest", shown)
    assert all(len(piece) < 40 for piece in shown.split("\r"))
    assert shown.endswith("\r"), "the line is wiped away"


IMPATIENT = """
from subdiv_cli.__main__ import run
from subdiv_cli.cli import progress
from subdiv_cli.model import watch
progress.PATIENCE = progress.PAUSE = watch.PAUSE = 0
run()
"""
PAIR = "matrices = [[[1, 1], [0, 1]], [[1, 0], [1, 1]]]"


@pytest.mark.skipif(sys.platform == "win32", reason="no pseudo-terminals")
@pytest.mark.parametrize(
    ("arguments", "stages"),
    [
        (["check", "--mask", "[-1, 0, 6, 10, 6, 0, -1]/10", "-q"], "sum rules|joint radius, [0-9]+ products|checker"),
        (["check", SOME[0], "--no-cache", "-q", "--budget", "60"], "sum rules|smoothness|checker"),
        (["jsr", "pair.toml"], "joint spectral radius, [0-9]+ vert|checker"),
        (["show", SOME[0]], "error bounds|page"),
        (["plot", SOME[0]], "checker|picture"),
    ],
    ids=lambda value: " ".join(value)[:40] if isinstance(value, list) else "",
)
def test_what_takes_long_shows_on_a_terminal_what_it_is_at(tmp_path, monkeypatch, arguments, stages):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "pair.toml").write_text(PAIR)
    code, shown = on_a_terminal(arguments, command=[sys.executable, "-c", IMPATIENT])
    assert code == 0
    *lines, rest = shown.split("\r")
    assert [stage for stage in stages.split("|") if not any(re.match(stage, line) for line in lines)] == []
    assert not re.search(stages + ", [0-9]+ s", rest), "the line is wiped away"


@pytest.mark.skipif(sys.platform == "win32", reason="no pseudo-terminals")
def test_colour_on_a_real_terminal_unless_it_is_unwanted():
    assert "\x1b[" in on_a_terminal(["check", SOME[0]])[1]
    assert "\x1b[" not in on_a_terminal(["check", SOME[0]], NO_COLOR="1")[1]
    assert "\x1b[" not in on_a_terminal(["check", SOME[0]], TERM="dumb")[1]
