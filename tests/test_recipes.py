"""The CI recipes of `subdiv explain ci`, acted out: every `subdiv` command in them runs as written, and passes."""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import yaml
from junitparser import JUnitXml
from support import subdiv

from subdiv_cli.cli.settings import KEYS
from subdiv_cli.explain import page

ROOT = Path(__file__).parents[1]
PAGE = page("ci")
RECIPES = [yaml.safe_load(text) for text in re.findall(r"^```yaml\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)]
HOOK, WORKFLOW, JOB = RECIPES


@pytest.fixture
def project(tmp_path):
    """A repository with masks."""
    shutil.copytree(ROOT / "masks" / "scalar" / "counterexamples", tmp_path / "masks")
    return tmp_path


def run(line, cwd, code=0):
    """A `subdiv` command as a shell would run it."""
    program, *arguments = shlex.split(line)
    assert program == "subdiv"
    done = subdiv(*arguments, cwd=cwd)
    assert done.returncode == code, done.stderr
    return done.stdout


def commands(steps):
    return [step["run"] for step in steps if step.get("run", "").startswith("subdiv ")]


def test_the_github_workflow(project):
    (check,) = commands(WORKFLOW["jobs"]["check"]["steps"])
    for part in WORKFLOW["jobs"]["check"]["strategy"]["matrix"]["part"]:
        run(check.replace("${{ matrix.part }}", str(part)), project)
    (merge,) = commands(WORKFLOW["jobs"]["report"]["steps"])
    run(merge, project)
    for name in ("report.html", "report.sarif", "report.md"):
        assert "21" in (project / name).read_text("utf-8") or name == "report.sarif"
    broken = project / "masks" / "flat_1111.toml"
    broken.write_text(broken.read_text().replace("stable = false", "stable = true"))
    shown = [run(check.replace("${{ matrix.part }}", str(part)), project, code) for part, code in ((1, 0), (2, 1))]
    assert re.search(r"^::error title=.*file=masks/flat_1111\.toml,line=\d+::", "\n".join(shown), re.MULTILINE)


def test_the_gitlab_job(project):
    (line,) = [line for line in JOB["masks"]["script"] if line.startswith("subdiv ")]
    run(line, project)
    suites = JUnitXml.fromfile(str(project / JOB["masks"]["artifacts"]["reports"]["junit"]))
    assert (len(suites), suites.failures, suites.errors) == (21, 0, 0)
    assert (project / JOB["masks"]["artifacts"]["paths"][0]).is_file()
    assert (project / JOB["masks"]["cache"]["paths"][0] / "CACHEDIR.TAG").is_file()


def test_the_hook_is_the_one_the_page_names():
    (hook,) = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text("utf-8"))
    assert HOOK["repos"][0]["hooks"] == [{"id": hook["id"]}]
    assert re.search(hook["files"], "masks/scalar/four_point.toml")
    assert not re.search(hook["files"], "pyproject.toml")


@pytest.mark.skipif(shutil.which("git") is None, reason="no git")
def test_the_hook_in_a_scratch_repository(project):
    """What pre-commit does with it: its entry, with the names of the changed files behind it."""
    (hook,) = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text("utf-8"))
    subprocess.run(["git", "init", "-q"], cwd=project, check=True)
    subprocess.run(["git", "add", "."], cwd=project, check=True)
    listed = subprocess.run(["git", "ls-files"], cwd=project, capture_output=True, text=True, check=True).stdout
    files = [name for name in listed.split() if re.search(hook["files"], name)]
    assert len(files) == 21
    assert run(f"{hook['entry']} {shlex.join(files)}", project) == ""
    broken = project / "masks" / "flat_1111.toml"
    broken.write_text(broken.read_text().replace("stable = false", "stable = true"))
    assert "expected stable = true: ✗ refuted" in run(f"{hook['entry']} {shlex.join(files)}", project, 1)


@pytest.mark.skipif(shutil.which("bash") is None, reason="no bash")
def test_the_action_runs_its_command(project):
    """The last step as the runner gives it to bash, with its inputs in the environment."""
    action = yaml.safe_load((ROOT / ".github" / "action.yml").read_text("utf-8"))
    step = action["runs"]["steps"][-1]
    program = project / "bin" / "subdiv"
    program.parent.mkdir()
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m subdiv_cli "$@"\n')
    program.chmod(0o755)
    inputs = {"MASKS": action["inputs"]["masks"]["default"], "ARGUMENTS": "--require generation>=0"}
    environment = {**os.environ, **inputs, "PATH": f"{program.parent}:{os.environ['PATH']}"}
    assert set(step["env"]) == set(inputs)
    done = subprocess.run(
        ["bash", "-c", step["run"]], cwd=project, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 1
    assert "::error" in done.stdout


def test_the_settings_on_the_page_are_settings():
    import tomllib

    (table,) = re.findall(r"^```toml\n(\[tool\.subdiv\]\n.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
    assert set(tomllib.loads(table)["tool"]["subdiv"]) <= set(KEYS)
