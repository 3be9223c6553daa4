"""The explain pages: every code has one, and what their fences show is what happens."""

import re
from fractions import Fraction
from pathlib import Path

import pytest

from subdiv_cli.catalog.run import check_all
from subdiv_cli.explain import codes, page, subjects, title
from subdiv_cli.kinds import KINDS, kind_named
from subdiv_cli.kinds.reading import read_text
from subdiv_cli.maskfile import MaskFileError
from subdiv_cli.maskfile.rules import ROWS
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.model.properties import PROPERTIES
from subdiv_cli.pipeline import show

PACKAGE = Path(__file__).parents[1] / "subdiv_cli"
PAGES = sorted((PACKAGE / "explain" / "pages").glob("SD*.md"))
FENCE = re.compile(r"^```toml (passes|fails)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
HEADINGS = ["What it checks", "Why it matters", "Example", "Instead", "Source"]
WITHOUT_A_FAILING_FILE = {"SD002", "SD014", "SD017", "SD018", "SD019", "SD020", "SD021", "SD099"}
NEVER_PROVED = {"SD303", "SD613", "SD709", "SD817", "SD826"}
"""The next order of smoothness: where it is proved, it is not the next one."""


def fences(text, kind):
    return [body for how, body in FENCE.findall(text) if how == kind]


def findings_of(body, code, tmp_path):
    """Those of `subdiv show` for a code that only it has."""
    if not code.startswith("SD5"):
        return result_of(body, tmp_path).findings
    return show(read_text(body, file="mask.toml").scheme({}), Fraction(1, 1000), Effort())[0].result.findings


def result_of(body, tmp_path):
    file = tmp_path / "mask.toml"
    file.write_text(body, encoding="utf-8")
    (result,) = check_all([str(file)], debug=True)
    return result


def test_pages_are_the_rows_of_all_tables():
    tables = (ROWS, *(kind_named(name).rules() for name in KINDS))
    rows = {code: row.name for table in tables for code, row in table.items()}
    meanings = {(code, row.name, row.source) for table in tables for code, row in table.items() if code >= "SD100"}
    assert len(meanings) == len([code for code in rows if code >= "SD100"]), "a code has two meanings"
    assert rows == {code: title(code) for code in codes()}


@pytest.mark.parametrize("file", PAGES, ids=lambda file: file.stem)
def test_page_has_its_headings(file):
    text = file.read_text(encoding="utf-8")
    assert re.match(rf"# {file.stem} [a-z-]+\n", text)
    assert re.findall(r"^## (.*)$", text, re.MULTILINE) == HEADINGS
    assert page(file.stem) == page(file.stem.lower()) == text


@pytest.mark.parametrize("file", PAGES, ids=lambda file: file.stem)
def test_passing_example(file, tmp_path):
    examples = fences(file.read_text(encoding="utf-8"), "passes")
    assert examples
    for body in examples:
        result = result_of(body, tmp_path)
        assert result.status == "passed"
        if file.stem >= "SD100":
            expected = Verdict.REFUTED if file.stem in NEVER_PROVED else Verdict.PROVED
            assert expected in {f.verdict for f in findings_of(body, file.stem, tmp_path) if f.code == file.stem}


@pytest.mark.parametrize("file", PAGES, ids=lambda file: file.stem)
def test_failing_example(file, tmp_path):
    examples = fences(file.read_text(encoding="utf-8"), "fails")
    assert bool(examples) is (file.stem not in WITHOUT_A_FAILING_FILE)
    for body in examples:
        result = result_of(body, tmp_path)
        if file.stem < "SD100":
            assert result.status == "invalid"
            assert {problem.code for problem in result.problems} == {file.stem}
        else:
            assert result.status in {"failed", "undecided"}
            assert file.stem in {finding.code for finding in findings_of(body, file.stem, tmp_path)}


def test_every_kind_has_a_page():
    assert set(KINDS) | {"formats", "ci"} == set(subjects())


@pytest.mark.parametrize("name", subjects())
def test_examples_of_a_kind_pass_and_are_of_it(name, tmp_path):
    examples = fences(page(name), "passes")
    assert examples or name not in KINDS or name == "matrices"
    for body in examples:
        assert (result_of(body, tmp_path).status, read_text(body, file="mask.toml").kind) == ("passed", name)


def test_the_symbol_on_the_page_of_scalar_masks_is_the_mask_there():
    coefficients, symbol = (read_text(body, file="mask.toml").scheme({}) for body in fences(page("scalar"), "passes"))
    assert coefficients == symbol


@pytest.mark.parametrize("kind", KINDS)
def test_the_page_of_a_kind_names_the_keys_of_expectations(kind):
    keys = {row.key for row in PROPERTIES if row.expected and row.question in answered(kind)}
    assert keys
    text = page(kind) + (page("scalar") if kind == "multivariate" else "")  # which says that they are the same
    assert [key for key in keys if f"`{key}`" not in text and f"{key} =" not in text] == []


def answered(kind):
    """The questions that the findings of a kind answer."""
    return {question for rule in kind_named(kind).rules().values() for question in rule.answers}


def test_the_page_of_formats_names_every_format_and_every_key():
    import json

    from subdiv_cli.report import FORMATS

    schema = json.loads((PACKAGE / "report" / "schema.json").read_text(encoding="utf-8"))
    for name in (*FORMATS, *schema["$defs"]["result"]["properties"]):
        assert f"`{name}`" in page("formats"), name


def test_files_that_fail_do_so_when_read():
    """The same without the pipeline: the reader alone refuses them."""
    for file in PAGES:
        for body in fences(file.read_text(encoding="utf-8"), "fails") if file.stem < "SD011" else []:
            with pytest.raises(MaskFileError):
                read_text(body, file="mask.toml").scheme({})
