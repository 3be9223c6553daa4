"""The gate on real masks: requirements, baselines, selections, lists of files, shards and merge."""

import json
import re
from pathlib import Path

import pytest
from support import subdiv

from subdiv_cli.catalog.shipped import masks_directory
from subdiv_cli.explain import page

SCALAR = masks_directory() / "scalar"
SOME = (SCALAR / "counterexamples", masks_directory() / "multivariate" / "counterexamples")
FOUR_POINT = """name = "four-point"
[parameters]
w = "1/16"
[mask]
start = -3
coefficients = ["-w", 0, "1/2 + w", 1, "1/2 + w", 0, "-w"]
"""


def report(*arguments, **more):
    done = subdiv("check", *arguments, "--format", "json", **more)
    return done.returncode, json.loads(done.stdout)


@pytest.fixture
def mask(tmp_path):
    """A mask file, and the means to change it."""
    file = tmp_path / "masks" / "four.toml"
    file.parent.mkdir()
    file.write_text(FOUR_POINT)
    return file


# requirements


@pytest.mark.parametrize(
    ("properties", "code"),
    [
        (["C1"], 0),
        (["C2"], 1),
        (["holder>=1.5", "C1"], 0),
        (["holder >= 1.5", "C2"], 1),
        (["holder>=2.1"], 1),
        (["convergent", "stable", "reproduction>=3"], 0),
        (["convergent=false"], 1),
        (["smoothness=1"], 0),
    ],
)
def test_require(mask, properties, code):
    options = [part for text in properties for part in ("--require", text)]
    got, read = report(mask, *options)
    assert got == code
    assert len(read["results"][0]["expectations"]) == len(properties)


def test_require_comes_beside_what_the_file_expects(mask):
    mask.write_text(FOUR_POINT + "[expect]\nsmoothness = 1\n")
    code, read = report(mask, "--require", "C2")
    assert code == 1
    assert [(e["expected"], e["verdict"], e["line"]) for e in read["results"][0]["expectations"]] == [
        ("1", "proved", None),
        (">= 2", "refuted", None),
    ]


def test_a_requirement_that_is_none(mask):
    done = subdiv("check", mask, "--require", "C1", "--require", "smothness>=1", "--require", "holder")
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.count("error[SD012]") == 2
    assert "did you mean smoothness?" in done.stderr


def test_an_annotation_stands_on_the_line_of_the_expectation(mask):
    mask.write_text(FOUR_POINT + "\n[expect]\nsmoothness = 2\n")
    done = subdiv("check", mask, "--format", "github")
    assert re.search(r"^::error .*four\.toml,line=9::expected smoothness = 2: refuted", done.stdout, re.MULTILINE)


# baselines


def baseline(mask, tmp_path, **more):
    file = tmp_path / "baseline.json"
    subdiv("check", "masks", "-o", file, "-q", cwd=tmp_path, **more)
    return file


def test_nothing_is_worse(mask, tmp_path):
    file = baseline(mask, tmp_path)
    done = subdiv("check", "masks", "--baseline", file, cwd=tmp_path)
    assert done.returncode == 0
    last = done.stdout.splitlines()[-1]
    assert last == "✓ passed: C^1, not C^2; Hölder 2 (not attained); nothing is worse than in the baseline"


def test_what_is_worse(mask, tmp_path):
    file = baseline(mask, tmp_path)
    mask.write_text(FOUR_POINT.replace("1/16", "1/2"))
    code, read = report("masks", "--baseline", file, cwd=tmp_path)
    assert code == 1
    convergence, smoothness, holder, sobolev, *degrees = read["results"][0]["regressions"]
    assert convergence == "convergence was proved and is refuted"
    assert smoothness == "the order of smoothness was 1 and is not known"
    assert degrees == [
        "the sum-rule order was 4 and is 2",
        "the generation degree was 3 and is 1",
        "the reproduction degree was 3 and is 1",
    ]
    assert holder == "the Hölder exponent was in [2.0, 2.0] and is in [0.0, 0.0]"
    assert sobolev.startswith("the Sobolev exponent was in [2.44")
    for form in ("github", "sarif", "junit", "markdown", "html", "text"):
        done = subdiv("check", "masks", "--baseline", file, "--format", form, cwd=tmp_path)
        assert "convergence was proved and is refuted" in done.stdout


def test_undecided_is_worse_than_proved_and_better_than_refuted(mask, tmp_path):
    """The same mask with next to no effort decides less, and with all of it more."""
    proved = baseline(mask, tmp_path)
    code, read = report("masks", "--baseline", proved, "--effort", "1", cwd=tmp_path)
    assert code == 1
    assert "convergence was proved and is undecided" in read["results"][0]["regressions"]
    undecided = tmp_path / "undecided.json"
    subdiv("check", "masks", "--effort", "1", "-o", undecided, cwd=tmp_path)
    assert report("masks", "--baseline", undecided, cwd=tmp_path)[0] == 0


def test_a_known_failure_does_not_fail_again_and_a_new_mask_is_judged_by_itself(mask, tmp_path):
    mask.write_text(FOUR_POINT.replace("1/16", "1/2"))
    file = baseline(mask, tmp_path)
    assert subdiv("check", "masks", cwd=tmp_path).returncode == 1
    assert subdiv("check", "masks", "--baseline", file, cwd=tmp_path).returncode == 0
    (mask.parent / "new.toml").write_text(FOUR_POINT.replace("1/16", "3/4"))
    code, read = report("masks", "--baseline", file, cwd=tmp_path)
    assert code == 1
    assert [(Path(r["file"]).name, r["status"]) for r in read["results"]] == [
        ("four.toml", "passed"), ("new.toml", "failed"),
    ]  # fmt: skip


def test_a_new_expectation_must_be_proved(mask, tmp_path):
    file = baseline(mask, tmp_path)
    mask.write_text(FOUR_POINT + "[expect]\nsmoothness = 2\n")
    code, read = report("masks", "--baseline", file, cwd=tmp_path)
    assert (code, read["results"][0]["regressions"]) == (1, ["the new expectation smoothness 2 is refuted"])
    mask.write_text(FOUR_POINT + "[expect]\nsmoothness = 1\n")
    assert report("masks", "--baseline", file, cwd=tmp_path)[0] == 0


def test_an_expectation_that_was_proved(mask, tmp_path):
    mask.write_text(FOUR_POINT + "[expect]\nstable = true\n")
    file = baseline(mask, tmp_path)
    old = json.loads(file.read_text())
    old["results"][0]["expectations"][0]["verdict"] = "refuted"
    file.write_text(json.dumps(old))
    assert report("masks", "--baseline", file, cwd=tmp_path)[0] == 0, "better than it was"


def test_an_interval_that_no_longer_meets_the_old_one(mask, tmp_path):
    file = baseline(mask, tmp_path)
    old = json.loads(file.read_text())
    for bounds, code in (((1.9, 2.1), 0), ((2.0, None), 0), ((None, 2.0), 0), ((2.01, 2.1), 1), ((1.0, 1.99), 1)):
        old["results"][0]["holder"].update(lower=bounds[0], upper=bounds[1])
        file.write_text(json.dumps(old))
        assert report("masks", "--baseline", file, cwd=tmp_path)[0] == code, bounds


def test_missing_masks_are_listed(mask, tmp_path):
    (mask.parent / "other.toml").write_text(FOUR_POINT)
    file = baseline(mask, tmp_path)
    (mask.parent / "other.toml").unlink()
    done = subdiv("check", "masks", "--baseline", file, "--format", "json", cwd=tmp_path)
    assert done.returncode == 0
    name = str(Path("masks") / "other.toml")
    assert json.loads(done.stdout)["missing"] == [name]
    assert done.stderr == f"note: 1 mask of the baseline not checked: {name}\n"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "it is not JSON"),
        ("[]", "its format is not subdiv-report"),
        ('{"format": "subdiv-report", "version": 2}', "reads version 1, not 2"),
        ('{"format": "subdiv-report", "version": 1}', "something is missing"),
        ('{"format": "subdiv-report", "version": 1, "results": [{}]}', "something is missing"),
        ('{"format": "subdiv-report", "version": 1, "results": 3}', "something is missing"),
        ("[" * 100_000, "it is not JSON"),
    ],
)
def test_a_baseline_that_is_no_report(mask, tmp_path, text, said):
    file = tmp_path / "broken.json"
    file.write_text(text)
    for command in (["check", mask, "--baseline", file], ["merge", file]):
        done = subdiv(*command)
        assert done.returncode == 2
        assert "error[SD020]" in done.stderr
        assert said in done.stderr
        assert done.stdout == ""
    assert "error[SD002]" in subdiv("merge", tmp_path / "none.json").stderr


def test_the_page_of_the_baseline_shows_what_is_worse(tmp_path):
    """The fences of SD018: the second file is worse than the first, and passes alone."""
    fences = dict(re.findall(r"^```toml (passes|worse)\n(.*?)^```$", page("SD018"), re.MULTILINE | re.DOTALL))
    file = tmp_path / "mask.toml"
    file.write_text(fences["passes"])
    subdiv("check", file, "-o", tmp_path / "old.json")
    file.write_text(fences["worse"])
    assert subdiv("check", file).returncode == 0
    code, read = report(file, "--baseline", tmp_path / "old.json")
    assert code == 1
    assert "the generation degree was 3 and is 1" in read["results"][0]["regressions"]


# what is shown


def test_select_and_ignore_show_less_and_change_no_exit_code(mask):
    mask.write_text(FOUR_POINT + "[expect]\nsmoothness = 2\n")
    code, read = report(mask, "--select", "sd1", "--ignore", "SD105")
    assert code == 1
    assert [f["code"] for f in read["results"][0]["findings"]] == ["SD101", "SD102", "SD103", "SD104"]
    done = subdiv("check", mask, "--select", "SDX")
    assert done.returncode == 2
    assert "no finding code begins with 'SDX'" in done.stderr


# which files


def test_files_from(mask, tmp_path):
    other = mask.parent / "with space.toml"
    other.write_text(FOUR_POINT)
    names = [str(mask), str(other)]
    for data in ("\n".join(names) + "\n", "\0".join(names) + "\0", "\r\n".join(names)):
        code, read = report("--files-from", "-", stdin=data)
        assert (code, [r["file"] for r in read["results"]]) == (0, names)
    listed = tmp_path / "list.txt"
    listed.write_text("\n".join(names))
    assert report("--files-from", listed)[1]["summary"]["files"] == 2
    assert subdiv("check", "--files-from", tmp_path / "none").returncode == 2
    assert subdiv("check", "--files-from", "-", stdin="").returncode == 0, "no file, nothing wrong"


def test_patterns(mask, tmp_path):
    (mask.parent / "deep").mkdir()
    (mask.parent / "deep" / "six.toml").write_text(FOUR_POINT)
    for pattern, count in (("masks/*.toml", 1), ("masks/**/*.toml", 2), ("masks/f*", 1), ("m*s", 2), ("masks/**", 2)):
        assert report(pattern, cwd=tmp_path)[1]["summary"]["files"] == count, pattern
    code, read = report("masks/*.tml", cwd=tmp_path)
    assert (code, read["results"][0]["errors"][0]["code"]) == (2, "SD014")
    odd = tmp_path / "a[1].toml"
    odd.write_text(FOUR_POINT)
    assert report("a[1].toml", cwd=tmp_path)[0] == 0, "a file of that very name is no pattern"


# shards


def test_the_parts_of_a_run_merged_are_the_run(tmp_path):
    whole = subdiv("check", *SOME, "--format", "json").stdout
    parts = []
    for i in (1, 2, 3):
        part = tmp_path / f"part-{i}.json"
        assert subdiv("check", *SOME, "--shard", f"{i}/3", "-o", part, "-q").returncode == 0
        assert json.loads(part.read_text())["shard"] == {"index": i, "count": 3}
        parts.append(part)
    for order in (parts, parts[::-1]):
        assert subdiv("merge", *order).stdout == whole
    merged = tmp_path / "all.json"
    done = subdiv("merge", *parts, "-o", merged, "-o", f"junit:{tmp_path / 'all.xml'}")
    assert (done.returncode, done.stdout) == (0, "")
    assert merged.read_text("utf-8") == whole
    for form in ("text", "junit", "sarif", "markdown", "github", "concise"):
        timeless = re.sub(' time="[0-9.]+"', "", subdiv("check", *SOME, "--format", form).stdout)
        assert subdiv("merge", *parts, "--format", form).stdout == timeless
    assert (tmp_path / "all.xml").read_text("utf-8") == subdiv("merge", merged, "--format", "junit").stdout


def test_parts_that_do_not_fit(tmp_path):
    def part(name, *options):
        file = tmp_path / name
        subdiv("check", SCALAR / "counterexamples", *options, "-o", file, "-q")
        return file

    first, second, other = part("1.json", "--shard", "1/3"), part("2.json", "--shard", "2/3"), part("w.json")
    for files, said in (
        ((first, second), "of 3 parts, missing: 3"),
        ((first, first, second), "a part comes twice"),
        ((first, other), "not the parts of one run"),
    ):
        done = subdiv("merge", *files)
        assert (done.returncode, done.stdout) == (2, "")
        assert said in done.stderr
    assert json.loads(subdiv("merge", first).stdout)["shard"] == {"index": 1, "count": 3}


def test_reports_of_different_runs_follow_one_another(mask, tmp_path):
    one, two, three = tmp_path / "1.json", tmp_path / "2.json", tmp_path / "3.json"
    subdiv("check", mask, "-o", one)
    subdiv("check", SCALAR / "dual_four_point.toml", mask, "-o", two)
    merged = json.loads(subdiv("merge", one, two).stdout)
    assert [Path(r["file"]).name for r in merged["results"]] == ["four.toml", "dual_four_point.toml"]
    assert merged["summary"]["files"] == 2
    mask.write_text(FOUR_POINT.replace("1/16", "1/4"))
    subdiv("check", mask, "-p", "w=1/16", "--effort", "3", "-o", three)
    done = subdiv("merge", one, three)
    assert done.returncode == 2
    assert "two results for" in done.stderr


@pytest.mark.parametrize("shard", ["0/3", "4/3", "1", "a/", "1/0", "-1/3", "1/99999999999"])
def test_shards_that_are_none(mask, shard):
    assert "is no part: write 1/4" in subdiv("check", mask, "--shard", shard).stderr


@pytest.mark.parametrize("form", ["text", "concise"])
def test_what_is_worse_is_said_in_short_reports_too(mask, tmp_path, form):
    mask.write_text(FOUR_POINT + "[expect]\nsmoothness = 1\n")
    file = baseline(mask, tmp_path)
    more = ("--baseline", file, "-q", "--format", form)
    done = subdiv("check", "masks", "-p", "w=1/2", "--no-cache", *more, cwd=tmp_path)
    assert done.returncode == 1
    said = " ".join(done.stdout.split())
    assert "worse than the baseline: convergence was proved and is refuted" in said
    assert "worse than the baseline: the order of smoothness was 1 and is not known" in said
    assert "expected smoothness" not in said


def test_a_family_of_matrices_in_a_directory_is_no_mask(mask, tmp_path):
    (tmp_path / "family.toml").write_text("matrices = [[[1, 1], [0, 1]]]\n", encoding="utf-8")
    run = subdiv("check", tmp_path, "--no-cache", "-v")
    assert run.returncode == 0
    assert "skipped 1 TOML file without kind or mask" in run.stderr
    named = subdiv("check", tmp_path / "family.toml", "--no-cache")
    assert named.returncode == 2
    assert 'add kind = "matrices", or use subdiv jsr' in named.stderr


# the end of a run


@pytest.fixture
def some(tmp_path):
    """Six masks, of which the second fails, the third is none, the fifth is undecided."""
    texts = [FOUR_POINT] * 6
    texts[1] += "[expect]\nsmoothness = 2\n"
    texts[2] = "[mask]\ncoefficients = 3\n"
    texts[4] = FOUR_POINT.replace("1/16", "1/10") + '[expect]\nholder = "1.2345678"\n'
    for number, text in enumerate(texts):
        (tmp_path / f"{number}.toml").write_text(text)
    return tmp_path


def test_exit_zero(some):
    def codes(*names):
        runs = [subdiv("check", *(some / name for name in names), *more) for more in ([], ["--exit-zero"])]
        assert runs[0].stdout == runs[1].stdout
        return [run.returncode for run in runs]

    assert codes("0.toml", "1.toml") == [1, 0]
    assert codes("0.toml") == [0, 0]
    assert codes("1.toml", "2.toml") == [2, 2], "what was not checked is no verdict"


@pytest.mark.parametrize("jobs", ["1", "2"])
def test_maxfail(some, jobs):
    for limit, (names, code) in {1: ("01", 1), 2: ("012", 2)}.items():
        done = subdiv("check", some, "--maxfail", limit, "--format", "json", "--jobs", jobs)
        read = json.loads(done.stdout)
        assert [Path(result["file"]).stem for result in read["results"]] == list(names)
        assert (done.returncode, read["interrupted"]) == (code, True)
        left = 6 - len(names)
        assert done.stderr.endswith(f"stopped by --maxfail {limit}: {left} masks not checked\n")
    whole = subdiv("check", some, "--maxfail", 9, "--format", "json")
    assert whole.stdout == subdiv("check", some, "--format", "json").stdout
    assert "maxfail" not in whole.stderr
    last = subdiv("check", some / "0.toml", some / "1.toml", "--maxfail", 1, "--format", "json")
    assert "interrupted" not in json.loads(last.stdout), "nothing was left"
    assert subdiv("check", some, "--maxfail", 0).returncode == 2


def test_statistics(some):
    done = subdiv("check", some, "--statistics", "-o", some / "report.json", COLUMNS="100")
    rows = [line.split() for line in done.stdout.splitlines()]
    assert rows[0] == ["masks", "code", "property", "verdict", "reason"]
    assert ["1", "SD302", "smoothness", "refuted"] in rows
    assert any(row[2:] == ["invalid"] for row in rows if row)
    assert len(json.loads((some / "report.json").read_text())["results"]) == 6
    assert done.returncode == 2
    report = json.loads(subdiv("check", some, "--statistics", "--format", "json").stdout)
    assert sum(row["masks"] for row in report["statistics"]) >= 3
    refused = subdiv("check", some, "--statistics", "--format", "junit")
    assert (refused.returncode, refused.stdout) == (2, "")
    assert "--statistics is text or json, not junit" in refused.stderr


def test_junit_has_the_time_of_each_mask(some):
    from lxml import etree

    suites = etree.fromstring(subdiv("check", some, "--format", "junit").stdout_bytes)
    for suite in suites:
        times = [float(case.get("time")) for case in suite.iter("testcase")]
        assert abs(sum(times) - float(suite.get("time"))) <= 0.001 * len(times)
    assert sum(float(suite.get("time")) for suite in suites) > 0
