"""`subdiv explain`, with pages of its own so that the shipped ones may change."""

import pytest

from subdiv_cli import explain


@pytest.fixture(autouse=True)
def pages(tmp_path, monkeypatch):
    (tmp_path / "SD101.md").write_text(
        "# SD101 residue-sums\n\nΣ of each class is 1 ≥ ½.\n\n    code\n", encoding="utf-8"
    )
    (tmp_path / "SD201.md").write_text("# SD201 convergence\n\nText.\n", encoding="utf-8")
    (tmp_path / "notes.md").write_text("# notes\n\nRemarks.\n", encoding="utf-8")
    monkeypatch.setattr(explain, "_PAGES", tmp_path)


@pytest.mark.parametrize("code", ["SD101", "sd101", " Sd101 ", "residue-sums", "Residue-Sums"])
def test_page(code):
    assert explain.page(code).startswith("# SD101 residue-sums\n")


def test_codes_and_titles():
    assert explain.codes() == ["SD101", "SD201"]
    assert explain.subjects() == ["notes"]
    assert explain.title("SD101") == "residue-sums"


@pytest.mark.parametrize(
    ("code", "near"),
    [
        ("SD102", ["SD101", "SD201"]),
        ("convergance", ["convergence"]),
        ("note", ["notes"]),
        ("zzz", []),
        ("../SD101", ["SD101"]),
    ],
)
def test_unknown_codes(code, near):
    with pytest.raises(explain.UnknownPageError) as caught:
        explain.page(code)
    assert set(near) <= set(caught.value.near)
    assert bool(near) == bool(caught.value.near)
    assert repr(code) in str(caught.value)
    assert isinstance(caught.value, KeyError)


def test_command(run):
    shown = run("explain", "sd101")
    assert shown.exit_code == 0
    assert shown.stdout == "# SD101 residue-sums\n\nΣ of each class is 1 ≥ ½.\n\n    code\n"


def test_command_without_a_code(run):
    assert run("explain").stdout == (
        "notes  Remarks.\n\nSD101  residue-sums  Σ of each class is 1 ≥ ½.\nSD201  convergence   Text.\n"
    )


def test_command_of_a_subject(run):
    assert run("explain", "Notes").stdout == "# notes\n\nRemarks.\n"


@pytest.mark.parametrize(("unicode", "dots"), [(True, " …"), (False, " ...")])
def test_a_long_summary_is_shortened_to_its_line(run, tmp_path, monkeypatch, unicode, dots):
    text = "The first paragraph,\ngoing on for several words which are too many.\n\nThe second."
    (tmp_path / "SD201.md").write_text(f"# SD201 convergence\n\n{text}\n", encoding="utf-8")
    monkeypatch.setenv("COLUMNS", "60")
    monkeypatch.setattr("subdiv_cli.cli.explain.speaks_mathematics", lambda stream: unicode)
    line = run("explain").stdout.splitlines()[-1]
    assert line == "SD201  convergence   The first paragraph, going on for" + dots
    assert len(line) <= 60


def test_in_a_pipe_nothing_is_cut_or_wrapped(run, tmp_path):
    text = "The first paragraph, " + "which is long, " * 20 + "and its end."
    (tmp_path / "SD201.md").write_text(f"# SD201 convergence\n\n{text}\n", encoding="utf-8")
    assert run("explain").stdout.splitlines()[-1] == f"SD201  convergence   {text}"
    assert run("explain", "SD201").stdout == f"# SD201 convergence\n\n{text}\n"


def test_command_in_ascii(run, monkeypatch):
    monkeypatch.setattr("subdiv_cli.cli.explain.speaks_mathematics", lambda stream: False)
    assert run("explain", "SD101").stdout == "# SD101 residue-sums\n\nSum of each class is 1 >= 1/2.\n\n    code\n"


def test_command_in_colour(run, monkeypatch):
    monkeypatch.setenv("FORCE_COLOR", "1")
    shown = run("explain", "SD101", color=True).stdout
    assert "\x1b[" in shown
    assert "# SD101" not in shown


def test_command_for_an_unknown_code(run):
    shown = run("explain", "SD102")
    assert shown.exit_code == 2
    assert "SD101" in shown.stderr
    assert shown.stdout == ""
