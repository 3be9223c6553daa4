"""`list`, `clean` and `completion`, as a person uses them."""

import json
import os
import re
import shutil
import subprocess
import sys

import pytest
from click.shell_completion import BashComplete, FishComplete, ZshComplete
from click.testing import CliRunner
from support import subdiv

from subdiv_cli.catalog.shipped import masks_directory
from subdiv_cli.cli import main
from subdiv_cli.cli.group import COMMANDS


def test_list_shows_every_shipped_mask_with_what_is_proved():
    run = subdiv("list", COLUMNS="200")
    assert run.returncode == 0
    count = len(list(masks_directory().rglob("*.toml")))
    assert run.stdout.splitlines()[-1] == f"{count} masks"
    assert re.search(
        r"four-point scheme +converges +C\^1, not C\^2 +2, not attained +✓ proved +scalar/four_point\.toml", run.stdout
    )
    assert run.stdout.count(".toml") == count


def test_list_finds_words_in_names_files_and_references():
    run = subdiv("list", "dyn", "four-point", "--format", "json")
    names = [result["name"] for result in json.loads(run.stdout)["results"]]
    assert "four-point scheme" in names
    assert "Chaikin in z^3" not in names
    assert all(result["status"] == "passed" for result in json.loads(run.stdout)["results"])
    assert subdiv("list", "no such mask").returncode == 1


def test_list_in_a_pipe_has_a_line_for_each_mask():
    rows = subdiv("list", COLUMNS=None).stdout.splitlines()[3:-1]
    assert len(rows) == len(list(masks_directory().rglob("*.toml")))
    assert all(row.endswith(".toml") for row in rows)
    assert max(map(len, rows)) > 120


def test_clean(tmp_path):
    cache = tmp_path / "cache"
    subdiv("check", masks_directory() / "scalar" / "four_point.toml", "--cache-dir", cache)
    run = subdiv("clean", "--cache-dir", cache)
    assert re.fullmatch(rf"removed 1 result, 0\.0 MB, from {re.escape(str(cache))}\n", run.stdout)
    assert not cache.exists()
    assert subdiv("clean", SUBDIV_CACHE_DIR=str(cache)).stdout.startswith("removed 0 results, ")


def complete(words, cursor_at, shell=BashComplete):
    """What the shell is given for the word at the cursor."""
    runner = CliRunner()
    line = " ".join(words)
    environment = {"_SUBDIV_COMPLETE": f"{shell.name}_complete", "COMP_WORDS": line, "COMP_CWORD": str(cursor_at)}
    if shell is FishComplete:
        environment["COMP_CWORD"] = words[cursor_at] if cursor_at < len(words) else ""
    shown = runner.invoke(main, [], prog_name="subdiv", env=environment)
    return shown.output.splitlines()


def values(lines):
    return [line.split(",", 1)[1] for line in lines if line]


def test_commands_and_options():
    assert values(complete(["subdiv", ""], 1)) == list(COMMANDS)
    assert "plain,--shard" in complete(["subdiv", "check", "--sh"], 2)
    assert "plain,junit" in complete(["subdiv", "check", "--format", "ju"], 3)


def test_codes():
    assert "SD301" in values(complete(["subdiv", "explain", "sd3"], 2))
    assert values(complete(["subdiv", "check", "--select", "SD40"], 3)) == ["SD401", "SD402", "SD403"]
    assert any("contractivity" in line for line in complete(["subdiv", "explain", "SD301"], 2, FishComplete))
    assert "contractivity" in complete(["subdiv", "explain", "SD301"], 2, ZshComplete)


def test_files():
    """They are left to the shell, which does not close a directory's name with a space."""
    for words in (["check", "mas"], ["check", "-o", "rep"], ["show", "mas"], ["verify", "pro"], ["merge", "part"]):
        assert complete(["subdiv", *words], len(words)) == [f"file,{words[-1]}"], words


def test_parameters_of_the_named_files():
    file = str(masks_directory() / "scalar" / "ternary_four_point_1_9.toml")
    for words in (["check"], ["show"], ["plot"], ["verify", "--mask"]):
        assert values(complete(["subdiv", *words, file, "-p", ""], len(words) + 3)) == ["mu="]
    assert values(complete(["subdiv", "check", "none.toml", "-p", ""], 4)) == []


def test_properties():
    assert values(complete(["subdiv", "check", "--require", "C"], 3)) == ["C0", "C1", "C2", "C3"]
    assert "holder>=" in values(complete(["subdiv", "check", "--require", "h"], 3))


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_the_script_is_one_the_shell_accepts(shell, tmp_path):
    run = subdiv("completion", shell)
    assert run.returncode == 0
    assert "_SUBDIV_COMPLETE" in run.stdout
    if (program := shutil.which(shell)) is None:
        pytest.skip(f"no {shell} here")
    script = tmp_path / "script"
    script.write_text(run.stdout)
    checked = subprocess.run([program, "-n", str(script)], capture_output=True, text=True, check=False)
    assert (checked.returncode, checked.stderr) == (0, "")


COMPLETED = {
    "bash": """
source <(subdiv completion bash)
COMP_WORDS=(subdiv explain SD30) COMP_CWORD=2
_subdiv_completion subdiv
echo "${COMPREPLY[@]}"
""",
    "zsh": """
compdef() {}
_describe() { print -l -- ${(P)3} }
source <(subdiv completion zsh)
words=(subdiv explain SD30) CURRENT=3
_subdiv_completion
""",
    "fish": """
subdiv completion fish | source
complete -C "subdiv explain SD30"
""",
}
"""The printed script, sourced, and a word completed: by the shell, or by the function as the shell calls it."""


@pytest.mark.parametrize("shell", COMPLETED)
def test_a_real_shell_completes(shell, tmp_path):
    if shutil.which(shell) is None:
        pytest.skip(f"no {shell} here")
    program = tmp_path / "subdiv"
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m subdiv_cli "$@"\n')
    program.chmod(0o755)
    environment = {**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}", "HOME": str(tmp_path)}
    quiet = {"bash": ["--norc"], "zsh": ["-f"], "fish": ["--no-config"]}[shell]
    run = subprocess.run(
        [shell, *quiet, "-c", COMPLETED[shell]], capture_output=True, text=True, env=environment, check=False
    )
    assert re.findall(r"SD\d+", run.stdout) == ["SD301", "SD302", "SD303", "SD304"], run.stderr


@pytest.mark.parametrize("command", COMMANDS)
def test_every_help_has_examples_or_exit_codes_and_fits(command):
    run = subdiv(command, "--help", COLUMNS="80")
    assert run.returncode == 0
    assert "Usage: subdiv " + command in run.stdout
    assert "Examples:" in run.stdout or "Exit codes:" in run.stdout or "every shell" in run.stdout
    assert all(len(line) <= 100 for line in run.stdout.splitlines())


def test_the_help_of_check_has_its_options_in_sections():
    shown = subdiv("check", "--help").stdout
    assert re.findall(r"^([A-Z]\w+(?: \w+)?):$", shown, re.MULTILINE)[:5] == [
        "Masks", "Report", "Gate", "Run", "Other options",
    ]  # fmt: skip
    assert "SUBDIV_JOBS" in shown
