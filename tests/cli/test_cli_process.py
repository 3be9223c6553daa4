"""The command as a process: what it imports, what it prints on odd consoles, how it ends."""

import os
import subprocess
import sys

import pytest
from support import subdiv

HEAVY = ("numpy", "flint", "rich", "matplotlib", "highspy", "mpmath")
ASCII = [{"PYTHONIOENCODING": "ascii"}, {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}]
"""Two ways to an ASCII console."""
LATER = ("subdiv_cli.model", "subdiv_cli.cli.check", "subdiv_cli.report", "json", "pathlib")
FAKE = """
import sys
from types import ModuleType
from subdiv_cli.model import Finding, Result, Smoothness, Verdict

def check_all(targets, **settings):
    said = "‖½S_1‖∞ ≤ φ"
    finding = Finding(code="SD201", name="convergence", verdict=Verdict.PROVED, statement=said, source="Möller")
    for target in targets:
        if target == "interrupt":
            import os, signal
            os.kill(os.getpid(), signal.SIGINT)
        for _ in range(2000 if target == "many" else 1):
            yield Result(file=target, name="Hölder ½", status="passed", convergent=Verdict.PROVED,
                         smoothness=Smoothness(order=1, sharp=True), findings=(finding,))

module = ModuleType("subdiv_cli.catalog.run")
module.check_all = check_all
sys.modules["subdiv_cli.catalog.run"] = module
from subdiv_cli.cli import main
"""
MODULES = """
import sys
try:
    main({args!r})
finally:
    print([m for m in {heavy!r} if m in sys.modules], file=sys.stderr)
"""


def python(code, **environment):
    keep = {key: value for key, value in os.environ.items() if key not in ("COLUMNS", "NO_COLOR", "FORCE_COLOR")}
    command = [sys.executable, "-W", "error", "-"]
    return subprocess.run(command, input=code.encode(), capture_output=True, env={**keep, **environment}, timeout=60)


def test_the_list_of_commands_needs_neither_commands_nor_model():
    done = python(f"from subdiv_cli.cli import main\n{MODULES.format(args=['--help'], heavy=LATER)}")
    assert done.stderr.decode().splitlines()[-1] == "[]"


@pytest.mark.parametrize("args", [["--help"], ["--version"], ["check", "--help"], ["explain", "--help"], []])
def test_help_loads_nothing_heavy(args):
    done = python(f"from subdiv_cli.cli import main\n{MODULES.format(args=args, heavy=HEAVY)}")
    assert done.stderr.decode().splitlines()[-1] == "[]"


def test_a_report_to_a_pipe_loads_nothing_heavy_and_one_in_colour_loads_rich():
    code = FAKE + MODULES.format(args=["check", "x"], heavy=HEAVY)
    assert python(code).stderr.decode().splitlines()[-1] == "[]"
    assert python(code, FORCE_COLOR="1").stderr.decode().splitlines()[-1] == "['rich']"


@pytest.mark.parametrize("args", [["check", "x"], ["check", "x", "y", "-v"], ["check", "x", "--format", "concise"]])
@pytest.mark.parametrize("environment", ASCII)
def test_an_ascii_console(args, environment):
    done = python(FAKE + f"main({args!r})", **environment)
    assert done.returncode == 0
    text = done.stdout.decode("ascii")
    assert "Hoelder 1/2" in text or "--format" in args
    assert done.stderr == b""


@pytest.mark.parametrize("args", [["--help"], ["check", "--help"], ["check", "φ", "--nonsense½"]])
def test_help_and_usage_on_an_ascii_console(args):
    done = python(f"from subdiv_cli.cli import main\nmain({args!r})", PYTHONIOENCODING="ascii")
    assert done.returncode == (2 if "φ" in args else 0)
    assert b"Traceback" not in done.stderr


def test_json_is_the_same_bytes_on_any_console():
    code = FAKE + "main(['check', 'x', '--format', 'json'])"
    assert python(code).stdout == python(code, PYTHONIOENCODING="ascii", COLUMNS="20", FORCE_COLOR="1").stdout


def test_no_colour_means_not_one_escape():
    code = FAKE + "main(['check', 'x'])"
    assert b"\x1b" in python(code, FORCE_COLOR="1").stdout
    assert b"\x1b" not in python(code, FORCE_COLOR="1", NO_COLOR="1").stdout


def test_a_pipe_that_closes_early_is_silent_and_keeps_the_verdict():
    process = subprocess.Popen(
        [sys.executable, "-c", FAKE + "main(['check', 'many', '-v'])"], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    process.stdout.read(10)
    process.stdout.close()
    error = process.stderr.read()
    process.stderr.close()
    assert (process.wait(60), error) == (0, b"")


FULL = "/dev/full"


@pytest.mark.skipif(not os.path.exists(FULL), reason="no device that is always full")  # noqa: PTH110
@pytest.mark.parametrize(
    "args", [["check", "x"], ["check", "x", "--format", "json"], ["--help"], ["explain"], ["explain", "SD201"]]
)
def test_a_full_disk_is_not_an_internal_error(args):
    with open(FULL, "wb") as full:  # noqa: PTH123
        command = [sys.executable, "-c", FAKE + f"main({args!r})"]
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, timeout=60)
    assert done.returncode == 2
    assert done.stderr == b"error: the report cannot be written: No space left on device\n"


@pytest.mark.skipif(not os.path.exists(FULL), reason="no device that is always full")  # noqa: PTH110
def test_a_full_disk_keeps_the_other_reports_and_a_full_stderr_the_exit_code(tmp_path):
    with open(FULL, "wb") as full:  # noqa: PTH123
        code = FAKE + f"main(['check', 'x', '-o', {str(tmp_path / 'r.json')!r}])"
        assert subprocess.run([sys.executable, "-c", code], stdout=full, stderr=full, timeout=60).returncode == 2
        assert (tmp_path / "r.json").read_bytes().startswith(b"{")
        code = FAKE + "main(['check', 'x', '--nonsense'])"
        assert subprocess.run([sys.executable, "-c", code], stderr=full, timeout=60).returncode == 2


def test_ctrl_c():
    handle = "import signal\nsignal.signal(signal.SIGINT, signal.default_int_handler)\n"
    done = python(handle + FAKE + "main(['check', 'x', 'interrupt', 'y'])")
    assert done.returncode == 130
    assert b"C^1, not C^2" in done.stdout
    assert b"interrupted: 1 mask checked" in done.stderr
    assert b"Traceback" not in done.stderr


def test_module_and_version():
    done = subprocess.run([sys.executable, "-m", "subdiv_cli", "--version"], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0
    assert done.stdout.startswith("subdiv, version ")


@pytest.mark.parametrize(
    ("args", "code"),
    [
        (["check", "mask.toml"], 0),
        (["check", "mask.toml", "none.toml", "--require", "C7"], 2),
        (["explain", "SD201"], 0),
    ],
)
@pytest.mark.parametrize("encoding", ["utf-8", "ascii"])
def test_a_process_says_what_a_run_in_this_one_says(args, code, encoding, tmp_path):
    """The other tests of commands have no process of their own: nothing is different there."""
    (tmp_path / "mask.toml").write_text("[mask]\nstart = 0\ncoefficients = ['1/4', '3/4', '3/4', '1/4']\n")
    keep = {key: value for key, value in os.environ.items() if key not in ("COLUMNS", "NO_COLOR", "FORCE_COLOR")}
    command = [sys.executable, "-m", "subdiv_cli", *args]
    environment = {**keep, "PYTHONIOENCODING": encoding}
    there = subprocess.run(command, cwd=tmp_path, capture_output=True, env=environment, check=False, timeout=60)
    here = subdiv(*args, cwd=tmp_path, encoding=encoding)
    assert there.returncode == here.returncode == code
    assert (there.stdout.decode(encoding), there.stderr.decode(encoding)) == (here.stdout, here.stderr)


def test_other_toml_files_of_a_directory_are_counted_when_verbose(tmp_path):
    (tmp_path / "settings.toml").write_text("[tool]\n")
    (tmp_path / "chaikin.toml").write_text("[mask]\nstart = 0\ncoefficients = ['1/4', '3/4', '3/4', '1/4']\n")
    for options, told in (((), ""), (("-v",), "skipped 1 TOML file without kind or mask\n")):
        run = subdiv("check", tmp_path, *options)
        assert (run.returncode, run.stderr) == (0, told)
