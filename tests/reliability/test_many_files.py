"""Many masks: all checked, in order, in bounded memory, and quickly from the cache.

Four hundred; `SUBDIV_CASES=10000` asks for ten thousand.
"""

import json
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

from runs import CHAIKIN
from support import cases

from subdiv_cli.catalog.run import check_all
from subdiv_cli.kinds.reading import read_text
from subdiv_cli.report import renderer
from subdiv_cli.report.look import Look

COUNT = cases(400)
BASE = 60
"""The MiB of a run of few masks, at most."""
SUFFIXES = ["json", "jsonl", "html", "xml", "sarif", "md", "txt"]
MEASURED = """
import json, resource, sys, time
from subdiv_cli.cli import main
start = time.perf_counter()
code = None
try:
    main({args!r})
except SystemExit as end:
    code = end.code
usage = [resource.getrusage(who).ru_maxrss / 1024 for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
try:  # ru_maxrss is no less than what the process had that started this one
    usage[0] = next(int(line.split()[1]) / 1024 for line in open("/proc/self/status") if line.startswith("VmHWM"))
except OSError:
    pass
print(json.dumps([code, time.perf_counter() - start, *usage]), file=sys.stderr)
"""


def texts(count):
    """So many masks, every tenth the first of its kind: the others are found in the cache under another name."""
    for number in range(count):
        yield CHAIKIN.format(start=number % max(1, count // 10))


def measured(*arguments):
    """stdout; exit code, seconds, and the most MiB of the process and of the largest of its workers."""
    code = MEASURED.format(args=list(arguments))
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=max(900, COUNT)
    )
    return done.stdout, json.loads(done.stderr.splitlines()[-1])


def written(cache):
    """When each entry of the cache was."""
    return {path.name: path.stat().st_mtime_ns for path in Path(cache).rglob("*.entry")}


def test_many_masks(tmp_path):
    directory, cache = tmp_path / "masks", str(tmp_path / "cache")
    directory.mkdir()
    for number, text in enumerate(texts(COUNT)):
        (directory / f"m{number:05}.toml").write_text(text)
    (directory / "m00007.toml").write_text("[mask]\nstart = 0\ncoefficients = [1/2]\n")
    arguments = ("check", str(directory), "--jobs", "2", "--effort", "500", "--cache-dir", cache)
    out, (code, cold, own, worker) = measured(*arguments, "--format", "jsonl")
    names = [json.loads(line)["file"] for line in out.splitlines()]
    assert names == sorted(str(path) for path in directory.iterdir())
    assert len(names) == COUNT
    assert code == 2
    assert out.count('"status": "passed"') == COUNT - 1
    assert own < BASE + COUNT / 250, "a few KiB a mask at most"
    assert worker < 160
    entries = written(cache)
    assert len(entries) == COUNT // 10
    files = [tmp_path / f"report.{suffix}" for suffix in SUFFIXES]
    outputs = [word for file in files for word in ("-o", str(file))]
    out, (code, warm, own, worker) = measured(*arguments, *outputs)
    assert written(cache) == entries, "all are found, none is written again"
    assert code == 2
    assert files[SUFFIXES.index("xml")].read_text("utf-8").count("<testcase ") == COUNT
    assert len(json.loads(files[SUFFIXES.index("json")].read_bytes())["results"]) == COUNT
    assert own < BASE + COUNT / 250
    print(f"\n  {COUNT} masks: {cold:.1f} s cold, {warm:.1f} s from the cache, {own:.0f} and {worker:.0f} MiB")


def test_merged_reports_need_no_more_memory_the_more_masks_they_have(tmp_path):
    (result,) = check_all([read_text(CHAIKIN.format(start=0), file="m.toml")])
    needed = []
    for count in (100, 500):
        file, written = tmp_path / f"{count}.json", [tmp_path / f"{count}-merged.{suffix}" for suffix in SUFFIXES]
        results = [replace(result, file=f"m{number}.toml", status="failed") for number in range(count)]
        file.write_text(renderer("json")(results, Look()), encoding="utf-8")
        _, (code, _, own, _) = measured("merge", str(file), *(word for path in written for word in ("-o", str(path))))
        assert (code, written[0].read_bytes()) == (0, file.read_bytes())
        needed.append(own)
    assert needed[1] < needed[0] + 5, "MiB"
