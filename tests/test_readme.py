"""The README is true: its commands are run and must print what it shows. `UPDATE_GOLDEN=1` writes the outputs anew."""

import os
import re
import shlex
from pathlib import Path

import pytest
from support import subdiv

ROOT = Path(__file__).parents[1]
README = ROOT / "README.md"
CONSOLE = re.compile(r"^```console\n(.*?)^```$", re.MULTILINE | re.DOTALL)
TOML = re.compile(r"^```toml\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@pytest.fixture
def directory(tmp_path):
    """A directory as the reader has it: the shipped masks, my_scheme.toml, and the same with its mistake."""
    (tmp_path / "masks").symlink_to(ROOT / "masks")
    bodies = TOML.findall(README.read_text(encoding="utf-8"))
    (mask,) = (body for body in bodies if body.startswith("name") and "[mask]" in body)
    (family,) = (body for body in bodies if "matrices" in body)
    (tmp_path / "family.toml").write_text(family, encoding="utf-8")
    (tmp_path / "my_scheme.toml").write_text(mask, encoding="utf-8")
    (tmp_path / "mistake.toml").write_text(mask.replace('"1/20"', "1/20"), encoding="utf-8")
    return tmp_path


def output(command, directory):
    """stdout and stderr together, as a terminal of 100 columns without colour shows them."""
    return subdiv(*shlex.split(command)[1:], cwd=directory, NO_COLOR="1", COLUMNS="100").output


def test_every_command_prints_what_is_shown(directory):
    text = README.read_text(encoding="utf-8")

    def rerun(block):
        commands = [line[2:] for line in block[1].splitlines() if line.startswith("$ ")]
        return "```console\n" + "".join(f"$ {c}\n{output(c, directory)}" for c in commands) + "```"

    actual = CONSOLE.sub(rerun, text)
    if os.environ.get("UPDATE_GOLDEN"):
        README.write_text(actual, encoding="utf-8")
    assert len(CONSOLE.findall(text)) >= 5
    assert actual == text


def test_the_number_of_shipped_masks():
    (count,) = re.findall(r"ships (\d+) masks", README.read_text(encoding="utf-8"))
    assert int(count) == len(list((ROOT / "masks").rglob("*.toml")))


def test_the_commands_of_the_readme_are_what_ci_runs():
    """`.ci/run` installs and tests as the README says, in an environment of its own."""
    script = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    install, tests = re.findall(
        r"^(pip install .*|python -m pytest.*)$", README.read_text(encoding="utf-8"), re.MULTILINE
    )
    assert install == 'pip install -e ".[test]"'
    assert re.search(r'^python -m pip install .*-e "\.\[test\]"$', script, re.MULTILINE)
    assert re.search(r"^python -m pytest.*$", script, re.MULTILINE)[0].replace(" -q", "") == tests


def test_the_readme_has_a_line_for_each_kind():
    from subdiv_cli.kinds import KINDS

    text = README.read_text(encoding="utf-8")
    assert [kind for kind in KINDS if f"| `{kind}` |" in text and f"`subdiv explain {kind}`" in text] == list(KINDS)
