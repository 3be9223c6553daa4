"""The cache: hits are verified, whatever is wrong with an entry it is not used, and nothing about it stops a run."""

import json
import os
import shutil
import subprocess
import sys
import zlib
from dataclasses import replace
from fractions import Fraction
from hashlib import sha256
from pathlib import Path

import pytest
from support import shipped_results, subdiv

from subdiv_cli.catalog import cache as module
from subdiv_cli.catalog.cache import Cache, Entry, directory, key
from subdiv_cli.catalog.run import check_all
from subdiv_cli.catalog.shipped import masks_directory
from subdiv_cli.catalog.task import Settings, Task, perform
from subdiv_cli.maskfile.option import parse_property
from subdiv_cli.model import Log, Verdict

FOUR_POINT = masks_directory() / "scalar" / "four_point.toml"
CHAIKIN = "[mask]\nstart = 0\ncoefficients = ['1/4', '3/4', '3/4', '1/4']\n[expect]\nsmoothness = 1\n"


def check(targets, **settings):
    """The results, and which files came from the cache."""
    hits = []

    def hear(done):
        if done.cached:
            hits.append(done.result.file)

    return list(check_all([str(t) for t in targets], on_done=hear, **settings)), hits


@pytest.fixture
def store(tmp_path):
    return str(tmp_path / "cache")


def entries(store):
    return sorted(Path(store).rglob("*.entry"))


def test_a_directory_is_not_hit_at_first_and_says_the_same(store):
    counterexamples = masks_directory() / "scalar" / "counterexamples"
    first, hits = check([counterexamples], cache=store)
    assert hits == []
    second, hits = check([counterexamples], cache=store)
    assert len(hits) == len(second) == 21
    assert first == second == check([counterexamples])[0]


def test_the_whole_catalog_is_hit_and_says_the_same():
    """In the cache that all tests share, where other tests may have put a part of it."""
    first, _ = check([masks_directory()], cache=os.environ["SUBDIV_CACHE_DIR"])
    second, hits = check([masks_directory()], cache=os.environ["SUBDIV_CACHE_DIR"])
    assert len(hits) == len(second) >= 120
    assert first == second == shipped_results()


def test_what_a_hit_depends_on(store, tmp_path):
    def hit(file=FOUR_POINT, **settings):
        return bool(check([file], cache=store, **settings)[1])

    assert not hit()
    assert hit()
    assert not hit(overrides={"w": [Fraction(1, 20)]})
    assert hit(overrides={"w": [Fraction(1, 20)]})
    assert hit(overrides={"w": [Fraction(1, 20), Fraction(1, 16)]}), "the values are those of one result"
    assert not hit(work=10_000)
    assert not hit(required=[parse_property("C1")])
    assert hit(required=[parse_property("C1")])
    copy = tmp_path / "copy.toml"
    copy.write_bytes(FOUR_POINT.read_bytes())
    assert hit(copy), "the name of the file is not in the key"
    copy.write_bytes(FOUR_POINT.read_bytes() + b"# changed\n")
    assert not hit(copy)
    assert hit(seconds=100), "what is found does not depend on a budget that does not strike"


def test_a_file_whose_mask_changes_is_checked_anew(store, tmp_path):
    mask = tmp_path / "mask.toml"
    mask.write_text(CHAIKIN)
    assert check([mask], cache=store)[0][0].status == "passed"
    mask.write_text(CHAIKIN.replace("3/4', '3/4", "1', '1/2"))
    (result,), hits = check([mask], cache=store)
    assert (result.status, hits) == ("failed", [])


def test_another_version_does_not_use_it(store, monkeypatch):
    check([FOUR_POINT], cache=store)
    monkeypatch.setattr(module, "_version", lambda: "0.0.0")
    assert check([FOUR_POINT], cache=store)[1] == []


def test_a_result_that_the_budget_stopped_is_not_kept(store):
    (result,), _ = check([FOUR_POINT], cache=store, seconds=1e-9)
    assert result.stopped == "budget"
    assert entries(store) == []


def spoiled(data):
    """What a disk, another program or a fool may make of an entry."""
    yield b""
    yield data[: len(data) // 2]
    yield data[:-1]
    yield data + b"x"
    yield bytes(reversed(data))
    yield b"not zlib at all"
    yield zlib.compress(b"")
    for place in range(len(data)):
        yield data[:place] + bytes([data[place] ^ 1 << place % 8]) + data[place + 1 :]
    head, _, packed = data.partition(b"\n")
    text = zlib.decompress(packed)
    for other in (b"", b"no result", text.replace(b"Dyn", b"Din"), b"\0" * (2 << 20) + text):
        yield head + b"\n" + zlib.compress(other)
    yield data.replace(b"subdiv-cache 2", b"subdiv-cache 1")


def test_corrupt_entries_are_ignored_and_replaced(store):
    (good,), _ = check([FOUR_POINT], cache=store)
    (entry,) = entries(store)
    data = entry.read_bytes()
    changed = list(spoiled(data))
    assert len(set(changed) - {data}) == len(changed) > len(data)
    for bad in changed:
        entry.write_bytes(bad)
        assert Cache(store).find(entry.stem) is None
    for bad in changed[:: len(changed) // 40]:
        entry.write_bytes(bad)
        (again,), hits = check([FOUR_POINT], cache=store)
        assert again == good
        assert hits == []
        assert entry.read_bytes() == data


def test_a_huge_entry_is_not_unpacked(store, monkeypatch):
    check([FOUR_POINT], cache=store)
    monkeypatch.setattr(module, "MOST_BYTES", 1000)
    assert check([FOUR_POINT], cache=store)[1] == []


def forge(store, change, *, certificate=None):
    """Rewrites the only entry with a right digest: a forger knows the format."""
    (file,) = entries(store)
    kept = Cache(store)
    entry = kept.find(file.stem)
    assert entry is not None
    kept.keep(file.stem, Entry(change(entry.result), certificate or entry.certificate))


def finding(result, code, **changes):
    return replace(result, findings=tuple(replace(f, **changes) if f.code == code else f for f in result.findings))


LIES = [
    lambda r: replace(r, convergent=Verdict.REFUTED),
    lambda r: finding(r, "SD201", verdict=Verdict.REFUTED),
    lambda r: replace(finding(r, "SD201", verdict=Verdict.REFUTED), convergent=Verdict.REFUTED),
    lambda r: finding(r, "SD302", claims=()),
    lambda r: finding(r, "SD302", claims=(0,)),
    lambda r: finding(r, "SD201", claims=(0,)),
    lambda r: finding(r, "SD302", claims=(10_000,)),
    lambda r: finding(r, "SD302", claims=(-1,)),
    lambda r: replace(r, smoothness=r.smoothness._replace(order=2)),
    lambda r: replace(r, refinable=r.refinable._replace(order=3)),
    lambda r: replace(r, smoothness=r.smoothness._replace(order=0, sharp=True)),
    lambda r: replace(r, sum_rule_order=5),
    lambda r: replace(r, generation=4),
    lambda r: replace(r, reproduction=4),
    lambda r: replace(r, stable=Verdict.REFUTED),
    lambda r: replace(r, linearly_independent=Verdict.REFUTED),
    lambda r: replace(r, status="failed"),
    lambda r: replace(r, expectations=()),
    lambda r: replace(r, expectations=r.expectations[1:]),
    lambda r: replace(r, expectations=tuple(j._replace(verdict=Verdict.REFUTED) for j in r.expectations)),
    lambda r: replace(r, stopped="budget"),
    lambda r: replace(r, findings=()),
]


@pytest.fixture(scope="module")
def checked(tmp_path_factory):
    """checked(store, mask) -> its result, with the store as a first run leaves it."""
    made = {}

    def checked(store, mask):
        if mask not in made:
            kept = tmp_path_factory.mktemp("kept")
            made[mask] = *check([masks_directory() / mask], cache=str(kept), **SETTINGS.get(mask, {}))[0], kept
        good, kept = made[mask]
        shutil.copytree(kept, store)
        return good

    return checked


@pytest.mark.parametrize("lie", LIES)
def test_a_forged_result_is_not_believed(store, checked, lie):
    good = checked(store, "scalar/four_point.toml")
    forge(store, lambda r: r)
    assert check([FOUR_POINT], cache=store)[1], "an entry rewritten as it was is a hit"
    forge(store, lie)
    (again,), hits = check([FOUR_POINT], cache=store)
    assert hits == []
    assert again == good


def exponent(key, **changes):
    """The result with another exponent, in short and in its finding."""
    code = {"holder": "SD311", "sobolev": "SD321"}[key]

    def lie(r):
        (of,) = (f for f in r.findings if f.code == code)
        value = of.value._replace(**{k: v if k != "exact" else str(v) for k, v in changes.items()})
        r = finding(r, code, value=value, closed=changes.get("exact", of.closed))
        return replace(r, **{key: getattr(r, key)._replace(**changes)})

    return lie


def value(code, **changes):
    return lambda r: replace(
        r,
        findings=tuple(replace(f, value=f.value._replace(**changes)) if f.code == code else f for f in r.findings),
    )


def in_short(key, **changes):
    return lambda r: replace(r, **{key: getattr(r, key)._replace(**changes)})


def other_text(r):
    """A root by another polynomial in the text alone."""
    text = r.holder.exact.text.replace("x^3", "x^5")
    return exponent("holder", exact=r.holder.exact._replace(text=text))(r)


def other_root(r):
    root = r.holder.exact.root
    return exponent("holder", exact=r.holder.exact._replace(root=root._replace(low=root.low / 2)))(r)


RATIONAL, LOGARITHM, ROOT, BOUNDED = (
    f"scalar/{name}.toml" for name in ("four_point", "dual_four_point", "six_point_1_64", "six_point")
)
SETTINGS = {BOUNDED: {"overrides": {"theta": [Fraction(117, 4000)]}, "work": 250}}
"""With so little effort the exponent is not known exactly."""
NUMBERS = [
    *((RATIONAL, exponent("holder", exact=Fraction(3))), (RATIONAL, exponent("holder", exact=Fraction(3, 2)))),
    *((LOGARITHM, exponent("holder", exact=Log(2, Fraction(65, 9)))), (LOGARITHM, value("SD311", exact="log2(65/9)"))),
    *((ROOT, other_text), (ROOT, other_root), (ROOT, exponent("sobolev", exact=Fraction(3)))),
    *((mask, in_short("holder", exact=Fraction(4))) for mask in (RATIONAL, LOGARITHM, ROOT, BOUNDED)),
    *((mask, lie(key, lower=4.5)) for mask in (RATIONAL, LOGARITHM, ROOT) for key in ("holder", "sobolev")
      for lie in (exponent, in_short)),
    *((mask, lie(key, upper=0.5)) for mask in (RATIONAL, LOGARITHM, ROOT) for key in ("holder", "sobolev")
      for lie in (exponent, in_short)),
    *((BOUNDED, lie(key, lower=4.5)) for key in ("holder", "sobolev") for lie in (exponent, in_short)),
    *((mask, value("SD310", upper=1e-9)) for mask in (RATIONAL, LOGARITHM, ROOT, BOUNDED)),
    *((mask, value("SD310", lower=2.0)) for mask in (RATIONAL, LOGARITHM, ROOT)),
    *((RATIONAL, value("SD310", exact="1/8")), (LOGARITHM, value("SD310", exact="0"))),
    *((mask, value("SD312", upper=0.25)) for mask in (RATIONAL, LOGARITHM, ROOT, BOUNDED)),
    *((RATIONAL, value("SD312", exact="1")), (RATIONAL, in_short("holder", attained=True))),
    *((LOGARITHM, in_short("holder", attained=False)), (ROOT, in_short("holder", attained=False))),
]  # fmt: skip


@pytest.mark.parametrize(("mask", "lie"), NUMBERS)
def test_a_forged_number_is_not_believed(store, checked, mask, lie):
    """Each is compared with the statements of the verified certificate, which the forger has not changed."""
    file, settings = masks_directory() / mask, SETTINGS.get(mask, {})
    good = checked(store, mask)
    assert (good.holder.exact is None) == (mask == BOUNDED)
    forge(store, lie)
    (again,), hits = check([file], cache=store, **settings)
    assert (hits, again) == ([], good)


def test_a_forged_judgement_is_not_believed(store, tmp_path):
    """Every expectation is judged again, so no forger makes a mask pass."""
    mask = tmp_path / "mask.toml"
    mask.write_text(CHAIKIN + 'holder = "2"\nsobolev = ">= 3"\n')
    (failed,), _ = check([mask], cache=store)
    assert failed.status == "failed"
    passed = tuple(judged._replace(verdict=Verdict.PROVED) for judged in failed.expectations)
    forge(store, lambda r: replace(r, status="passed", expectations=passed))
    (again,), hits = check([mask], cache=store)
    assert (hits, again) == ([], failed)


def test_a_certificate_of_another_mask_is_not_believed(store, tmp_path):
    """The whole entry of a smooth mask under the name of a rough one: proved, but not of this mask."""
    rough = masks_directory() / "scalar" / "counterexamples" / "four_point_sign_slip.toml"
    settings = Settings(cache=store, certificates=True)
    smooth = perform(Task(str(FOUR_POINT)), settings)
    name = key(rough.read_bytes(), {}, settings.work, ())
    Cache(store).keep(name, Entry(smooth.result, smooth.certificate))
    (result,), hits = check([rough], cache=store)
    assert hits == []
    assert result.convergent is Verdict.REFUTED


def test_a_certificate_that_does_not_verify_is_not_believed(store):
    check([FOUR_POINT], cache=store)
    (file,) = entries(store)
    document = json.loads(Cache(store).find(file.stem).certificate)
    norm = next(c for c in document["claims"] if c["rule"] == "norm")
    norm["statement"]["norm"] = "1/2"
    forge(store, lambda r: r, certificate=json.dumps(document))
    assert check([FOUR_POINT], cache=store)[1] == []


@pytest.mark.parametrize("name", ["scalar/four_point", "multivariate/loop"])
@pytest.mark.parametrize("more", [[], ["-v"], ["--format", "html"]])
def test_a_hit_loads_no_flint(tmp_path, name, more):
    """Nor do the stencils and the curve of a report."""
    arguments = ["check", str(masks_directory() / f"{name}.toml"), "--cache-dir", str(tmp_path), *more]
    code = (
        "import sys\nfrom subdiv_cli.cli import main\n"
        f"try:\n    main({arguments!r})\n"
        "except SystemExit as end:\n    print(end.code, 'flint' in sys.modules, 'numpy' in sys.modules)\n"
    )
    runs = [subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True) for _ in "ab"]
    said = [run.stdout for run in runs]
    assert said[0].splitlines()[-1] == "0 True False"
    assert said[1].splitlines()[-1] == "0 False False"
    assert said[0].splitlines()[:-1] == said[1].splitlines()[:-1]
    assert more == [] or ("1/16" in said[1] and ("f_k" in said[1] or "coset (0, 0)" in said[1]))


SUBDIV = [sys.executable, "-m", "subdiv_cli"]


def test_a_file_where_the_directory_should_be_does_not_stop_a_run(tmp_path):
    place = tmp_path / "cache"
    place.write_text("a file")
    run = subdiv("check", FOUR_POINT, "-q", "--cache-dir", place / "below")
    assert (run.returncode, run.stdout) == (0, "")
    assert run.stderr == "note: results cannot be kept in the cache: Not a directory\n"


def bound_by_permissions():
    """A command prefix without which root may write anywhere; None where there is none."""
    if os.getuid() != 0:
        return []
    return ["setpriv", "--bounding-set=-dac_override,-dac_read_search"] if shutil.which("setpriv") else None


@pytest.mark.skipif(bound_by_permissions() is None, reason="root, and no setpriv: nothing is read-only")
def test_a_read_only_directory_is_read_and_does_not_stop_a_run(tmp_path):
    place = tmp_path / "cache"
    place.mkdir()
    arguments = [*bound_by_permissions(), *SUBDIV, "check", "-q", "--cache-dir", str(place)]
    subprocess.run([*arguments, str(FOUR_POINT)], check=True)
    for path in (*place.rglob("*"), place):
        path.chmod(0o555 if path.is_dir() else 0o444)
    other = masks_directory() / "scalar" / "four_point_1_8.toml"
    run = subprocess.run([*arguments, str(FOUR_POINT), str(other)], capture_output=True, text=True, check=False)
    assert (run.returncode, run.stdout) == (0, "")
    assert run.stderr == "note: results cannot be kept in the cache: Permission denied\n"
    assert len(list(place.rglob("*.entry"))) == 1
    hit = subprocess.run([*arguments, str(FOUR_POINT)], capture_output=True, text=True, check=False)
    assert (hit.returncode, hit.stderr) == (0, ""), "what is there is used, and nothing has to be written"
    for path in (place, *place.rglob("*")):
        path.chmod(0o755)


def test_a_full_disk(tmp_path):
    """RLIMIT_FSIZE stands for a full disk: the write fails half way."""
    code = (
        "import resource, sys\nresource.setrlimit(resource.RLIMIT_FSIZE, (700, 700))\n"
        f"sys.argv = ['subdiv', 'check', {str(FOUR_POINT)!r}, '--cache-dir', {str(tmp_path / 'cache')!r}]\n"
        "from subdiv_cli.__main__ import run\nrun()\n"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert run.returncode == 0
    assert run.stderr == "note: results cannot be kept in the cache: File too large\n"
    assert "convergence proved" in run.stdout
    assert [p for p in (tmp_path / "cache").rglob("*") if p.suffix in (".part", ".entry")] == []


def test_two_runs_at_once_on_one_cache(tmp_path):
    masks = str(masks_directory() / "scalar" / "counterexamples")
    arguments = ["check", masks, "--jobs", "2", "--cache-dir", str(tmp_path), "--format", "json"]
    code = f"import sys\nsys.argv = ['subdiv', *{arguments!r}]\nfrom subdiv_cli.__main__ import run\nrun()\n"
    runs = [
        subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE) for _ in range(4)
    ]
    outputs = [run.communicate(timeout=120) for run in runs]
    assert {run.returncode for run in runs} == {0}
    assert {error for _, error in outputs} == {b""}
    assert len({out for out, _ in outputs}) == 1
    assert not list(tmp_path.rglob("*.part"))
    _, hits = check([masks], cache=str(tmp_path))
    assert len(hits) == 21


def test_clean_removes_entries_and_nothing_else(store):
    check([FOUR_POINT], cache=store)
    (entry,) = entries(store)
    (entry.parent / f".{entry.name}.123.part").write_bytes(b"left by a killed run")
    mine = Path(store) / "thesis.tex"
    mine.write_text("mine")
    assert Cache(store).clean()[0] == 2
    assert [p.name for p in Path(store).iterdir()] == ["thesis.tex"]
    mine.unlink()
    check([FOUR_POINT], cache=store)
    Cache(store).clean()
    assert not Path(store).exists()
    assert Cache(store).clean() == (0, 0)


def test_the_directory_is_marked_as_a_cache(store):
    check([FOUR_POINT], cache=store)
    assert (Path(store) / "CACHEDIR.TAG").read_text().startswith("Signature: 8a477f597d28d172789f06886806bc55\n")


def test_where_it_is(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert directory() == str(tmp_path / "subdiv")
    assert directory("there") == "there"
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setattr(module.sys, "platform", "linux")
    monkeypatch.setenv("HOME", str(tmp_path))
    assert directory() == str(tmp_path / ".cache" / "subdiv")


def test_an_entry_is_named_by_its_key(store):
    check([FOUR_POINT], cache=store)
    (entry,) = entries(store)
    assert entry.stem == key(FOUR_POINT.read_bytes(), {}, Settings().work, ())
    other = entry.with_name(sha256(b"other").hexdigest() + ".entry")
    other.write_bytes(entry.read_bytes())
    assert Cache(store).find(other.stem) is None, "a copy under another name is none"
