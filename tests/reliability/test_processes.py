"""Processes that are killed, disks that are full, files that vanish, runs that are interrupted."""

import faulthandler
import json
import os
import signal
import subprocess
import sys
from fractions import Fraction
from multiprocessing import get_context

import pytest
from runs import SUBDIV, children, masks, report, settled, start, wait_for

from subdiv_cli.catalog import pool
from subdiv_cli.catalog.run import check_all
from subdiv_cli.model import Verdict

LINUX = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="/proc tells which processes there are")


pytestmark = pytest.mark.filterwarnings("ignore:.*fork:DeprecationWarning")


@pytest.fixture
def forked(monkeypatch):
    """Processes that have what a test has changed, also where other tests have left threads behind."""
    monkeypatch.setattr(pool, "_context", lambda: get_context("fork"))


@pytest.mark.parametrize("how", ["fork", "spawn"])
def test_either_way_to_start_a_process(tmp_path, monkeypatch, how):
    monkeypatch.setattr(pool, "_context", lambda: get_context(how))
    directory = str(masks(tmp_path, 12))
    assert list(check_all([directory], jobs=2)) == list(check_all([directory]))


@LINUX
def test_a_worker_that_is_killed_costs_only_its_mask(tmp_path):
    """kill -9 from outside, in the middle of a mask; twice, as the second slow mask meets the same end."""
    directory = masks(tmp_path, 40)
    slow = ("m00005.toml", "m00020.toml")
    running = start("check", directory, "--jobs", 2, "--no-cache", "--format", "json", slow=slow)
    for victim in wait_for(lambda: settled(running.pid, 2)):
        os.kill(victim, signal.SIGKILL)
    out, error = running.communicate(timeout=120)
    read, by_name = report(out)
    assert running.returncode == 2
    assert error == b""
    assert read["summary"] == {"files": 40, "passed": 38, "failed": 0, "undecided": 0, "invalid": 2}
    assert list(by_name) == [f"m{number:05}.toml" for number in range(40)]
    for name in slow:
        (problem,) = by_name[name]["errors"]
        assert problem["code"] == "SD019"
        assert problem["message"] == "not checked: the process that checked it was killed by SIGKILL"


@pytest.mark.parametrize("how", ["SIGKILL", "SIGSEGV", "SIGABRT", "exit 134"])
def test_every_way_to_die(tmp_path, monkeypatch, forked, how):
    """FLINT ends the process where a size overwhelms it, and nothing can catch that."""

    def die(task, settings):
        faulthandler.disable()
        if task.file.endswith("m00003.toml"):
            os._exit(134) if how == "exit 134" else os.kill(os.getpid(), getattr(signal, how))
        return perform(task, settings)

    perform = pool.perform
    monkeypatch.setattr(pool, "perform", die)
    results = list(check_all([str(masks(tmp_path, 12))], jobs=2))
    assert [result.status for result in results] == ["passed"] * 3 + ["invalid"] + ["passed"] * 8
    (problem,) = results[3].problems
    assert problem.code == "SD019"
    assert ("was killed by " + how in problem.message) or ("exit code 134" in problem.message)


def test_all_workers_dying_all_the_time_ends_too(tmp_path, monkeypatch, forked):
    monkeypatch.setattr(pool, "perform", lambda task, settings: os._exit(1))
    results = list(check_all([str(masks(tmp_path, 12))], jobs=2))
    assert [problem.code for result in results for problem in result.problems] == ["SD019"] * 12


@LINUX
def test_ctrl_c_keeps_what_is_done(tmp_path):
    """A slow mask comes first, so all that is done waits for its turn; it is reported all the same."""
    directory = masks(tmp_path, 30)
    file = tmp_path / "report.json"
    slow = ("m00000.toml", "m00029.toml")
    running = start("check", directory, "--jobs", 2, "--no-cache", "--format", "json", "-o", file, slow=slow)
    workers = wait_for(lambda: settled(running.pid, 2))
    os.killpg(running.pid, signal.SIGINT)
    out, error = running.communicate(timeout=60)
    assert running.returncode == 130
    assert error.decode().splitlines()[-1] == "interrupted: 28 masks checked until then"
    read, by_name = report(out)
    assert read["interrupted"] is True
    assert list(by_name) == [f"m{number:05}.toml" for number in range(1, 29)]
    assert json.loads(file.read_bytes()) == read
    for worker in workers:
        wait_for(lambda worker=worker: not os.path.exists(f"/proc/{worker}"))  # noqa: PTH110


@LINUX
def test_ctrl_c_in_one_process(tmp_path):
    directory = masks(tmp_path, 6)
    options = ("--jobs", 1, "--no-cache", "--format", "jsonl")
    running = start("check", directory, *options, slow=("m00004.toml",))
    first = [json.loads(running.stdout.readline()) for _ in range(4)]
    os.killpg(running.pid, signal.SIGINT)
    out, _ = running.communicate(timeout=60)
    assert (running.returncode, out) == (130, b"")
    assert [result["status"] for result in first] == ["passed"] * 4


@LINUX
def test_workers_end_with_a_run_that_is_killed(tmp_path):
    """They are at work while it dies, and end when they find nobody to give a result to."""
    running = start("check", masks(tmp_path, 3000), "--jobs", 2, "--no-cache")
    workers = wait_for(lambda: children(running.pid) if len(children(running.pid)) == 2 else None)
    running.kill()
    running.communicate()
    for worker in workers:
        wait_for(lambda worker=worker: not os.path.exists(f"/proc/{worker}"))  # noqa: PTH110


def test_a_file_that_is_deleted_while_the_run_goes_on(tmp_path):
    directory = masks(tmp_path, 30)
    gone = directory / "m00029.toml"
    results = []
    for result in check_all([str(directory)], jobs=2):
        results.append(result)
        gone.unlink(missing_ok=True)
    assert [result.status for result in results] == ["passed"] * 29 + ["invalid"]
    assert [problem.code for problem in results[-1].problems] == ["SD002"]


def many_signs():
    """(1+z) q(z) with sixty coefficients ±1/6: norms fall below 1 late, if at all, and a polytope is not tried."""
    state, q = 12345, []
    for _ in range(60):
        state = (1103515245 * state + 12345) % 2**31
        q.append(Fraction(1 if state >> 16 & 1 else -1, 6))
    q.append(1 - sum(q))
    coefficients = [a + b for a, b in zip([*q, 0], [0, *q], strict=True)]
    return "[mask]\nstart = 0\ncoefficients = [" + ", ".join(f'"{c}"' for c in coefficients) + "]\n"


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_mask_that_needs_more_than_the_budget(tmp_path, monkeypatch, jobs):
    """It stops soon after its time and says so; what was found until then is in the report."""
    monkeypatch.setattr(pool, "PATIENCE", (1.0, 600.0))  # on a busy machine a step may take long
    directory = masks(tmp_path, 8)
    (directory / "m00002.toml").write_text(many_signs())
    results = list(check_all([str(directory)], jobs=jobs, work=20_000_000, seconds=0.2))
    stopped = results[2]
    assert stopped.stopped == "budget"
    assert stopped.convergent in (Verdict.REFUTED, Verdict.UNDECIDED), (
        "it diverges; how soon that is seen hangs on luck"
    )
    assert stopped.sum_rule_order == 1
    assert len(results) == 8


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_step_that_no_budget_interrupts_is_ended_from_outside(tmp_path, monkeypatch, forked, jobs):
    """A library call looks at no clock: after a while its process is ended, and the mask is undecided."""
    import time

    def hang(task, settings):
        if task.file.endswith("m00003.toml"):
            time.sleep(600)
        return perform(task, settings)

    perform = pool.perform
    monkeypatch.setattr(pool, "perform", hang)
    monkeypatch.setattr(pool, "PATIENCE", (1.5, 0.5))
    results = list(check_all([str(masks(tmp_path, 12))], jobs=jobs, seconds=2))
    assert (results[3].status, results[3].stopped, results[3].findings) == ("undecided", "budget", ())
    assert [result.status for result in results if result is not results[3]] == ["passed"] * 11


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="no device that is always full")  # noqa: PTH110
@pytest.mark.parametrize("form", ["text", "json", "jsonl", "junit", "html"])
def test_a_full_disk_under_stdout(tmp_path, form):
    with open("/dev/full", "wb") as full:  # noqa: PTH123
        done = subprocess.run(
            [*SUBDIV, "check", str(masks(tmp_path, 3)), "--format", form],
            stdout=full,
            stderr=subprocess.PIPE,
            check=False,
        )
    assert done.returncode == 2
    assert b"the report cannot be written: No space left on device" in done.stderr
    assert b"Traceback" not in done.stderr


def test_a_full_disk_under_an_output_file(tmp_path):
    """The old report stays, whole."""
    directory = masks(tmp_path, 20)
    file = tmp_path / "report.json"
    file.write_text("the report of yesterday")
    code = (
        "import resource, sys\nresource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))\n"
        f"sys.argv = ['subdiv', 'check', {str(directory)!r}, '--no-cache', '-o', {str(file)!r}]\n"
        "from subdiv_cli.__main__ import run\nrun()\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "report.json cannot be written: File too large" in done.stderr
    assert "20 masks: 20 passed" in done.stdout
    assert file.read_text() == "the report of yesterday"
    assert sorted(p.name for p in tmp_path.iterdir() if p.suffix != ".toml") == ["report.json"]


def test_the_order_is_that_of_the_files_whatever_finishes_first(tmp_path, monkeypatch, forked):
    import random
    import time

    def dawdle(task, settings):
        time.sleep(random.random() / 50)
        return perform(task, settings)

    perform = pool.perform
    monkeypatch.setattr(pool, "perform", dawdle)
    finished = []
    directory = masks(tmp_path, 60)
    results = list(check_all([str(directory)], jobs=4, on_done=lambda done: finished.append(done.result.file)))
    files = sorted(str(path) for path in directory.iterdir())
    assert [result.file for result in results] == files
    assert sorted(finished) == files
    assert finished != files, "they did not finish in order"


def test_no_result_runs_far_ahead_of_the_first_that_is_missing(tmp_path, monkeypatch, forked):
    """Memory is bounded: while one mask takes long, only so many others are done and wait."""
    import time

    from subdiv_cli.catalog import ordered

    def late(task, settings):
        if task.file.endswith("m00000.toml"):
            time.sleep(1.5)
        return perform(task, settings)

    perform = pool.perform
    monkeypatch.setattr(pool, "perform", late)
    monkeypatch.setattr(ordered, "WINDOW", 10)
    finished = []
    run_of = check_all([str(masks(tmp_path, 40))], jobs=2, on_done=lambda done: finished.append(done.result.file))
    assert next(run_of).file.endswith("m00000.toml")
    assert len(finished) <= 11
    assert len(list(run_of)) == 39


def test_workers_are_replaced_after_a_while(tmp_path, monkeypatch, forked):
    from dataclasses import replace

    def mark(task, settings):
        done = perform(task, settings)
        return done._replace(result=replace(done.result, reference=str(os.getpid())))

    perform = pool.perform
    monkeypatch.setattr(pool, "perform", mark)
    monkeypatch.setattr(pool, "MOST_TASKS", 5)
    results = list(check_all([str(masks(tmp_path, 40))], jobs=2))
    assert len({result.reference for result in results}) >= 8
    assert {result.status for result in results} == {"passed"}
