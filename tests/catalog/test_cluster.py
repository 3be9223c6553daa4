"""A real Dask scheduler with two workers, each a process of its own, does the same as one process here."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from support import subdiv

from subdiv_cli.catalog import ClusterError
from subdiv_cli.catalog import cluster as module
from subdiv_cli.catalog.run import check_all
from subdiv_cli.catalog.shipped import masks_directory

distributed = pytest.importorskip("distributed", reason="the extra dask is not installed")
COUNTEREXAMPLES = masks_directory() / "scalar" / "counterexamples"
pytestmark = pytest.mark.filterwarnings("default")
"""Dask's own warnings are not ours."""


@pytest.fixture(scope="module")
def scheduler():
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, silence_logs=50
    ) as made:
        yield made


def test_the_same_results_in_the_same_order(scheduler):
    targets = [str(COUNTEREXAMPLES), str(masks_directory() / "scalar" / "four_point.toml"), "none.toml"]
    there = list(check_all(targets, cluster=scheduler.scheduler_address))
    assert there == list(check_all(targets))
    assert len(there) == 23


def test_from_the_command_line(scheduler):
    arguments = ["check", str(COUNTEREXAMPLES), "--format", "json", "--no-cache"]
    command = [sys.executable, "-m", "subdiv_cli", *arguments, "--dask", scheduler.scheduler_address]
    there = subprocess.run(command, capture_output=True, check=True)
    here = subdiv(*arguments)
    assert (here.returncode, here.stdout_bytes) == (0, there.stdout)
    assert there.stderr == b""
    assert len(json.loads(there.stdout)["results"]) == 21


def test_the_workers_need_not_have_the_files(scheduler, tmp_path, monkeypatch):
    """The bytes travel: the path means nothing where the workers are."""
    monkeypatch.chdir(tmp_path)
    Path("m.toml").write_text("[mask]\nstart = 0\ncoefficients = ['1/4', '3/4', '3/4', '1/4']\n")
    (result,) = check_all(["m.toml"], cluster=scheduler.scheduler_address)
    assert (result.file, result.status) == ("m.toml", "passed")


def test_a_mask_that_kills_its_worker_costs_only_itself(scheduler, tmp_path, monkeypatch):
    for number in range(8):
        text = f"[mask]\nstart = {number}\ncoefficients = ['1/4', '3/4', '3/4', '1/4']\n"
        (tmp_path / f"m{number}.toml").write_text(text)

    def deadly(task, settings):
        if task.file.endswith("m3.toml"):
            os.kill(os.getpid(), signal.SIGKILL)
        return perform(task, settings)

    perform = module.perform
    monkeypatch.setattr(module, "perform", deadly)
    results = list(check_all([str(tmp_path)], cluster=scheduler.scheduler_address))
    assert [result.status for result in results] == ["passed"] * 3 + ["invalid"] + ["passed"] * 4
    (problem,) = results[3].problems
    assert problem.code == "SD019"
    assert "the cluster lost it (KilledWorker)" in problem.message


def test_no_scheduler(monkeypatch):
    monkeypatch.setattr(module, "TIMEOUT", 1)
    for address in ("tcp://127.0.0.1:9", "nonsense://x", "127.0.0.1:99999999"):
        with pytest.raises(ClusterError, match="no scheduler answers at"):
            list(check_all([str(COUNTEREXAMPLES)], cluster=address))


def test_without_the_extra(monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(ClusterError, match="needs the extra dask"):
        list(check_all([str(COUNTEREXAMPLES)], cluster="tcp://127.0.0.1:9"))
