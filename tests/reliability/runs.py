"""Runs of the command line as processes, and small masks for them."""

import json
import subprocess
import sys
import time
from pathlib import Path

CHAIKIN = "[mask]\nstart = {start}\ncoefficients = ['1/4', '3/4', '3/4', '1/4']\n[expect]\nsmoothness = 1\n"
SLOW = """
import sys, time
from subdiv_cli.catalog import pool, run
from subdiv_cli.__main__ import run as main

def hang(task, settings, perform=pool.perform):
    if task.file.endswith({names!r}):
        time.sleep(600)
    return perform(task, settings)

pool.perform = run.perform = hang
sys.argv = ["subdiv", *{arguments!r}]
main()
"""
"""The command line with masks on which it stays forever."""
SUBDIV = [sys.executable, "-m", "subdiv_cli"]


def masks(directory, count):
    """So many masks in a directory, no two alike."""
    for number in range(count):
        (directory / f"m{number:05}.toml").write_text(CHAIKIN.format(start=number))
    return directory


def start(*arguments, slow=()):
    """`subdiv` in the background, in a process group of its own; on the masks of these names it stays forever."""
    code = SLOW.format(names=tuple(slow), arguments=list(map(str, arguments)))
    command = [sys.executable, "-c", code]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)


def run(*arguments, **more):
    """`subdiv` to its end."""
    return subprocess.run([*SUBDIV, *map(str, arguments)], capture_output=True, check=False, timeout=300, **more)


def children(pid):
    """The processes a process has started."""
    return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


def wait_for(condition, seconds=60):
    """The first true answer."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if found := condition():
            return found
        time.sleep(0.02)
    raise AssertionError("it did not happen")


def asleep(pid, count):
    """The children of a process, if there are so many and all have slept for a while: they are in slow masks."""
    found = children(pid)
    states = [Path(f"/proc/{child}/stat").read_text().rpartition(")")[2].split()[0] for child in found]
    return found if len(found) == count and set(states) == {"S"} else None


def settled(pid, count):
    """`asleep`, and still half a second later."""
    first = wait_for(lambda: asleep(pid, count))
    time.sleep(0.5)
    return first if asleep(pid, count) == first else None


def report(output):
    """A JSON report by files' names."""
    read = json.loads(output)
    return read, {Path(result["file"]).name: result for result in read["results"]}
