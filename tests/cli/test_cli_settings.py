"""[tool.subdiv] in pyproject.toml: nearest wins, beneath the environment and the command line; slips are told."""

import json
import re

import pytest
from support import subdiv

from subdiv_cli.cli.settings import KEYS
from subdiv_cli.explain import page

CHAIKIN = "[mask]\nstart = 0\ncoefficients = ['1/4', '3/4', '3/4', '1/4']\n"


@pytest.fixture
def tree(tmp_path):
    """project/pyproject.toml, project/inner/pyproject.toml, and a mask in each."""
    for directory in ("project/masks", "project/inner/masks", "elsewhere"):
        (tmp_path / directory).mkdir(parents=True)
        (tmp_path / directory / "m.toml").write_text(CHAIKIN)
    return tmp_path / "project"


def settings(directory, text):
    (directory / "pyproject.toml").write_text(f"[project]\nname = 'x'\n\n[tool.subdiv]\n{text}\n")


def check(cwd, *arguments, **environment):
    return subdiv("check", *arguments, cwd=cwd, **environment)


def asked(run):
    """What the masks were held to."""
    return [e["expected"] for r in json.loads(run.stdout)["results"] for e in r["expectations"]]


def test_the_nearest_one_wins_and_alone(tree):
    settings(tree, 'require = ["C2"]\nformat = "json"')
    settings(tree / "inner", 'require = ["C1"]')
    assert asked(check(tree, "masks")) == [">= 2"]
    assert check(tree, "masks").returncode == 1
    assert check(tree / "inner", "masks").returncode == 0
    assert "convergence proved" in check(tree / "inner", "masks").stdout, "of the outer one nothing is taken"
    assert check(tree, "inner/masks").returncode == 0, "the masks decide, not the working directory"
    assert asked(check(tree, "masks", "inner/masks")) == [">= 2"] * 2, "what they have in common"
    assert check(tree.parent, "elsewhere", "--format", "json").returncode == 0


def test_a_file_without_the_table_is_passed_over(tree):
    settings(tree, 'require = ["C2"]\nformat = "json"')
    for text in ("[tool.other]\nx = 1\n", "[tool.subdivision]\nx = 1\n", "this is not TOML", ""):
        (tree / "inner" / "pyproject.toml").write_text(text)
        assert asked(check(tree / "inner", "masks")) == [">= 2"], text


def test_the_command_line_beats_the_environment_beats_the_file(tree):
    settings(tree, 'require = ["C2"]\nformat = "json"\neffort = 5')
    assert asked(check(tree, "masks", SUBDIV_REQUIRE="C0 stable")) == [">= 0", "true"]
    assert asked(check(tree, "masks", "--require", "C1", SUBDIV_REQUIRE="C0")) == [">= 1"]
    assert check(tree, "masks", SUBDIV_FORMAT="concise").stdout.startswith("masks/m.toml: SD101")
    assert check(tree, "masks", "--format", "concise", SUBDIV_FORMAT="jsonl").stdout.startswith("masks/m.toml: SD101")
    findings = [json.loads(run.stdout)["results"][0]["findings"] for run in (
        check(tree, "masks"), check(tree, "masks", SUBDIV_EFFORT="20000"),
    )]  # fmt: skip
    assert findings[0] != findings[1]


def test_every_key(tree):
    (tree / "old.json").write_text(check(tree, "masks", "--format", "json").stdout)
    settings(
        tree,
        'format = "json"\nselect = ["SD2"]\nignore = ["SD202"]\nrequire = ["convergent"]\nbaseline = "old.json"\n'
        'allow-undecided = true\neffort = 20000\nbudget = 10.5\njobs = "auto"\ncache = true\ncache-dir = "kept"',
    )
    run = check(tree / "masks", "m.toml")
    assert (run.returncode, run.stderr) == (0, "note: 1 mask of the baseline not checked: masks/m.toml\n")
    assert [f["code"] for f in json.loads(run.stdout)["results"][0]["findings"]] == ["SD201"]
    assert subdiv("check", "m.toml", cwd=tree / "masks", SUBDIV_CACHE_DIR=None).returncode == 0
    assert len(list((tree / "kept").rglob("*.entry"))) == 1, "paths are relative to the file"
    said = subdiv("clean", cwd=tree / "masks", SUBDIV_CACHE_DIR=None).stdout
    assert said.startswith("removed 1 result, ")
    assert not (tree / "kept").exists()


def files(run):
    return [result["file"] for result in json.loads(run.stdout)["results"]]


def test_paths_are_checked_where_none_is_named(tree):
    settings(tree, 'paths = ["masks", "inner/masks/m.toml"]\nformat = "json"')
    assert files(check(tree)) == ["masks/m.toml", "inner/masks/m.toml"]
    assert files(check(tree / "masks")) == ["m.toml", "../inner/masks/m.toml"], "from where one stands"
    assert files(check(tree, "inner/masks")) == ["inner/masks/m.toml"]
    assert files(check(tree, "--mask", "[1, 1]")) == ["--mask"]
    (tree / "list.txt").write_text("inner/masks\n")
    assert files(check(tree, "--files-from", "list.txt")) == ["inner/masks/m.toml"]
    settings(tree, 'format = "json"')
    assert "nothing to check: name a file" in check(tree).stderr
    settings(tree, "paths = []")
    assert check(tree).returncode == 2


def test_exclude(tree):
    for name in ("drafts", "masks/drafts"):
        (tree / name).mkdir()
        (tree / name / "d.toml").write_text(CHAIKIN)
    settings(tree, 'paths = ["."]\nexclude = ["inner", "./drafts"]\nformat = "json"')
    assert files(check(tree)) == ["masks/m.toml", "masks/drafts/d.toml"]
    assert files(check(tree / "masks")) == ["../masks/m.toml", "../masks/drafts/d.toml"], "relative to the file"
    assert files(check(tree, "--exclude", "masks")) == ["drafts/d.toml", "inner/masks/m.toml"][:1]
    assert files(check(tree, SUBDIV_EXCLUDE="m.toml drafts/*")) == ["masks/drafts/d.toml"]
    assert files(check(tree, "inner/masks/m.toml", "drafts")) == ["inner/masks/m.toml", "drafts/d.toml"]


def test_no_cache(tree):
    settings(tree, 'cache = false\ncache-dir = "kept"')
    assert subdiv("check", "masks", cwd=tree, SUBDIV_CACHE_DIR=None).returncode == 0
    assert not (tree / "kept").exists()


@pytest.mark.parametrize(
    ("text", "said", "line"),
    [
        ('requires = ["C1"]', 'there is no setting "requires"', 5),
        ('require = "C1"', "require cannot be str", 5),
        ('paths = "masks"', "paths cannot be str", 5),
        ("exclude = [1]", "exclude must be a list of strings", 5),
        ("require = [1]", "require must be a list of strings", 5),
        ("jobs = true", "jobs cannot be bool", 5),
        ("jobs = 0", "is neither auto nor a number", 5),
        ('effort = "much"', "effort cannot be str", 5),
        ("effort = 0", "is not a positive whole number", 5),
        ("budget = -1", "is not a positive number of seconds", 5),
        ('\nformat = "xml"', "'xml' is not one of", 6),
        ("cache-dir = 3", "cache-dir cannot be int", 5),
        ("allow-undecided = 1", "allow-undecided cannot be int", 5),
        ("baseline = [\n", "not valid TOML", None),
    ],
)
def test_slips(tree, text, said, line):
    settings(tree, text)
    run = check(tree, "masks")
    assert run.returncode == 2
    assert run.stdout == ""
    assert "error[SD017]" in run.stderr
    assert said in run.stderr
    assert "Traceback" not in run.stderr
    if line is not None:
        assert f"pyproject.toml:{line}:1 in tool.subdiv." in run.stderr


def test_a_table_that_is_none(tree):
    (tree / "pyproject.toml").write_text("[tool]\nsubdiv = 3\n")
    assert "tool.subdiv must be a table" in check(tree, "masks").stderr


def test_a_bad_environment_variable_is_a_usage_error(tree):
    run = check(tree, "masks", SUBDIV_JOBS="many")
    assert run.returncode == 2
    assert "'many' is neither auto nor a number" in run.stderr


def test_the_page_names_every_key_and_its_fences_are_true(tree):
    text = page("SD017")
    assert set(KEYS) <= set(re.findall(r"`([a-z-]+)`", text))
    fences = dict(re.findall(r"^```toml pyproject (passes|fails)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL))
    (tree / "pyproject.toml").write_text(fences["passes"])
    assert check(tree, "masks").returncode == 0
    (tree / "pyproject.toml").write_text(fences["fails"])
    run = check(tree, "masks")
    assert (run.returncode, "error[SD017]" in run.stderr, "did you mean require?" in run.stderr) == (2, True, True)
