"""Masks and values from the command line, on real masks: standard input, several values of -p, certificates' names."""

import json

import pytest
from support import subdiv

from subdiv_cli.kinds.option import from_option

W = '[parameters]\nw = "1/16"\n[mask]\nstart = -3\ncoefficients = ["-w", 0, "1/2 + w", 1, "1/2 + w", 0, "-w"]\n'
TWO = '[parameters]\na = 1\nb = 3\n[mask]\ncoefficients = ["a/4", "b/4", "b/4", "a/4"]\n'


@pytest.fixture
def family(tmp_path):
    """A directory with a mask of the parameter w, one of a and b, one of none."""
    (tmp_path / "masks").mkdir()
    for name, text in (("w", W), ("two", TWO), ("plain", "[mask]\ncoefficients = [0.5, 1, 0.5]\n")):
        (tmp_path / "masks" / f"{name}.toml").write_text(text)
    return tmp_path


def report(*arguments, **more):
    done = subdiv("check", *arguments, "--format", "json", **more)
    return done.returncode, json.loads(done.stdout)["results"]


def seen(results):
    return [(r["file"].rpartition("/")[2], r["parameters"], r["status"]) for r in results]


def test_several_values_are_results_of_their_own(family):
    values = [word for value in ("w=1/16", "w=1", "a=1", "a=2", "b=3", "b=2") for word in ("-p", value)]
    code, results = report("masks", *values, cwd=family)
    assert code == 1
    assert seen(results) == [
        ("plain.toml", {}, "passed"),
        ("two.toml", {"a": "1", "b": "3"}, "passed"),
        ("two.toml", {"a": "1", "b": "2"}, "failed"),
        ("two.toml", {"a": "2", "b": "3"}, "failed"),
        ("two.toml", {"a": "2", "b": "2"}, "passed"),
        ("w.toml", {"w": "1/16"}, "passed"),
        ("w.toml", {"w": "1"}, "failed"),
    ]
    parts = [report("masks", "-p", "a=1", "-p", "a=2", "--shard", f"{i}/2", cwd=family)[1] for i in (1, 2)]
    assert [len(part) for part in parts] == [2, 2], "a shard has its part of the results"
    again = report("masks", *values, "--jobs", "2", "--no-cache", cwd=family)
    assert again == (code, results)


def test_the_reports_tell_values_apart(family):
    done = subdiv("check", "masks/w.toml", "-p", "w=1/16", "-p", "w=1", cwd=family)
    assert "masks/w.toml, w = 1/16" in done.stdout
    assert "masks/w.toml, w = 1:" in done.stdout
    lines = subdiv("check", "masks/w.toml", "-p", "w=1/16", "-p", "w=1", "--format", "concise", cwd=family).stdout
    assert "masks/w.toml[w=1/16]: SD201 convergence proved" in lines
    assert "masks/w.toml[w=1]: SD201 convergence refuted" in lines
    one = subdiv("check", "masks/w.toml", "-p", "w=1/16", "--format", "concise", cwd=family).stdout
    assert "masks/w.toml: SD201" in one


def test_a_parameter_concerns_the_masks_that_have_it(family):
    code, results = report("masks", "-p", "w=1", cwd=family)
    assert seen(results)[2] == ("w.toml", {"w": "1"}, "failed")
    assert [r["status"] for r in results[:2]] == ["passed", "passed"]
    code, (nobody,) = report("masks", "-p", "ww=1", cwd=family)
    assert code == 2
    (problem,) = nobody["errors"]
    assert (nobody["file"], problem["code"], problem["message"]) == ("-p", "SD011", "no mask here has a parameter ww")
    assert problem["help"] == "did you mean w?"
    code, (alone,) = report("masks/plain.toml", "-p", "w=1", cwd=family)
    assert (code, alone["errors"][0]["message"]) == (2, "this mask has no parameter w")
    (family / "masks" / "broken.toml").write_text("[mask]\ncoefficients = [v]\n")
    code, results = report("masks", "-p", "w=1", cwd=family)
    assert code == 2
    assert [r["status"] for r in results] == ["invalid", "passed", "passed", "failed"]


def test_a_baseline_knows_the_values(family):
    values = ("masks/w.toml", "-p", "w=1/16", "-p", "w=1/20")
    written = subdiv("check", *values, "--format", "json", cwd=family).stdout
    (family / "base.json").write_text(written)
    assert report(*values, "--baseline", "base.json", cwd=family)[0] == 0
    code, results = report("masks/w.toml", "-p", "w=1/16", "-p", "w=1", "--baseline", "base.json", cwd=family)
    assert [r["regressions"] for r in results] == [[], None], "w = 1 is new, and fails by itself"
    assert code == 1
    done = subdiv("check", "masks/w.toml", "-p", "w=1/16", "--baseline", "base.json", cwd=family)
    assert "not checked: masks/w.toml[w=1/20]" in done.stderr
    old = json.loads(written)
    old["results"] = old["results"][:1]
    (family / "base.json").write_text(json.dumps(old))
    code, results = report("masks/w.toml", "-p", "w=1/16", "-p", "w=1", "--baseline", "base.json", cwd=family)
    assert [r["regressions"] for r in results] == [[], None], "several values are not held to another one"
    code, (only,) = report("masks/w.toml", "-p", "w=1", "--baseline", "base.json", cwd=family)
    assert code == 1
    assert "convergence was proved and is refuted" in only["regressions"], "another value of the only one is compared"


def test_certificates_have_names_of_their_own(family):
    code, results = report("masks", "-p", "w=1/16", "-p", "w=1/20", "--certificate", "proofs", cwd=family)
    assert code == 0
    names = sorted(path.name for path in (family / "proofs").iterdir())
    assert names == ["plain.json", "two.json", "w-w=1_16.json", "w-w=1_20.json"]
    for result, w in ((results[2], "1/16"), (results[3], "1/20")):
        document = json.loads((family / result["certificate"]).read_text())
        assert document["mask"]["coefficients"][0] == f"-{w}"
    assert subdiv("verify", "proofs", cwd=family).returncode == 0


@pytest.mark.parametrize("length", [245, 250])
def test_a_certificate_of_a_long_name(family, length):
    (family / f"{'x' * length}.toml").write_text(W)
    code, (result,) = report(f"{'x' * length}.toml", "--certificate", "proofs", cwd=family)
    assert (code, result["certificate"]) == (0, f"proofs/{'x' * length}.json")
    assert (family / result["certificate"]).exists()
    values = ("-p", "w=1/16", "-p", "w=1/20")
    done = subdiv("check", f"{'x' * length}.toml", *values, "--certificate", "proofs", cwd=family)
    assert done.returncode == 2
    assert "2 masks: 2 passed" in done.stdout, "the report is printed"
    (line,) = done.stderr.splitlines()
    assert line.startswith("error: the certificate of xxx")
    assert line.endswith(".toml cannot be written: File name too long")


def test_a_list_on_standard_input():
    for text in ("[1, 3, 3, 1]/4", "0.25\n0.75\n0.75\n0.25\n", "array([0.25, 0.75, 0.75, 0.25])", "(1+z)^3/4"):
        code, (result,) = report("-", stdin=text)
        assert (code, result["file"], result["facts"]["support"]) == (0, "-", [0, 3])
        assert (result["smoothness"], result["holder"]["exact"]) == ({"order": 1, "sharp": True}, "2")
    code, (result,) = report("-", "--start", "-1", "--arity", "3", "-p", "w=3", stdin="[1 2 w 2 1]/3")
    assert (code, result["facts"]["support"], result["parameters"]) == (0, [-1, 3], {"w": "3"})
    code, (result,) = report("-", "--start", "-1", stdin=W)
    assert (code, result["errors"][0]["code"]) == (2, "SD015")
    assert subdiv("show", "-", stdin="[1 3 3 1]/4").returncode == 0
    assert subdiv("check", "a.toml", "--start", "1").returncode == 2


def test_a_file_without_start_begins_at_zero(tmp_path):
    (tmp_path / "m.toml").write_text("[mask]\ncoefficients = [0.25, 0.75, 0.75, 0.25]\n")
    rows = "[[0.25, 0.5, 0.25], [0.5, 1, 0.5], [0.25, 0.5, 0.25]]"
    (tmp_path / "grid.toml").write_text(f'kind = "multivariate"\n[mask]\ncoefficients = {rows}\n')
    code, (grid, mask) = report(".", "--certificate", "proofs", cwd=tmp_path)
    assert (code, mask["facts"]["support"], grid["status"]) == (0, [0, 3], "passed")
    for name in ("m", "grid"):
        done = subdiv("verify", f"proofs/{name}.json", "--mask", f"{name}.toml", cwd=tmp_path)
        assert done.returncode == 0
        assert "expanded by subdiv" not in done.stdout, "the checker's own reader reads it"
    shifted = tmp_path / "shifted.toml"
    shifted.write_text("[mask]\nstart = 1\ncoefficients = [0.25, 0.75, 0.75, 0.25]\n")
    assert subdiv("verify", "proofs/m.json", "--mask", "shifted.toml", cwd=tmp_path).returncode == 1
    assert from_option("[1, 1]").scheme().start == 0


def test_orders_of_smoothness_in_a_file(tmp_path):
    for text, verdict in (("C1", "proved"), (">= C^1", "proved"), ("C2", "refuted"), (">= C(2)", "refuted")):
        (tmp_path / "m.toml").write_text(f'[mask]\nsymbol = "(1+z)^3/4"\n[expect]\nsmoothness = "{text}"\n')
        _, (result,) = report("m.toml", cwd=tmp_path)
        (judged,) = result["expectations"]
        assert (judged["key"], judged["expected"], judged["verdict"]) == ("smoothness", text, verdict)


def test_a_mask_in_several_variables_without_its_kind_has_one_error(tmp_path):
    (tmp_path / "m.toml").write_text('[mask]\ndilation = [[1, 1], [1, -1]]\nterms = {"0,0" = 1, "1,0" = 1}\n')
    code, (result,) = report("m.toml", cwd=tmp_path)
    (problem,) = result["errors"]
    assert (code, problem["code"], problem["line"]) == (2, "SD005", 2)
    assert problem["message"] == 'kind = "multivariate" is missing: dilation is for masks in several variables'
