"""Hypothesis without deadlines on shared machines, in CI the same examples every time; a cache of its own.

`SUBDIV_CASES=10000` asks the fuzzers and the laws of random masks for so many cases each, fresh ones: those of a seed
that is printed at the end, by which as `SUBDIV_SEED` they come again, and Hypothesis's own, which prints what fails.
Without it the fuzzers have the same cases in every run.
"""

import os
import secrets
import shutil
import tempfile

from hypothesis import HealthCheck, settings

quiet = {"deadline": None, "suppress_health_check": [HealthCheck.too_slow]}
settings.register_profile("local", **quiet)
settings.register_profile("ci", derandomize=True, **quiet)
settings.register_profile("many", max_examples=int(os.environ.get("SUBDIV_CASES", "100")), print_blob=True, **quiet)
settings.load_profile("many" if "SUBDIV_CASES" in os.environ else "ci" if os.environ.get("CI") else "local")

WORKER = "PYTEST_XDIST_WORKER" in os.environ
"""Then the process that started this one has chosen the cache and the seed."""

for name in [name for name in os.environ if name.startswith("SUBDIV_")]:
    if name not in ("SUBDIV_CASES", "SUBDIV_SEED") and not (WORKER and name == "SUBDIV_CACHE_DIR"):
        del os.environ[name]
if "SUBDIV_CASES" in os.environ:
    os.environ.setdefault("SUBDIV_SEED", str(secrets.randbelow(10**9)))
if "SUBDIV_CACHE_DIR" not in os.environ:
    os.environ["SUBDIV_CACHE_DIR"] = tempfile.mkdtemp(prefix="subdiv-cache-")


def pytest_terminal_summary(terminalreporter):
    """How to have the same cases again."""
    if seed := os.environ.get("SUBDIV_SEED"):
        cases = os.environ.get("SUBDIV_CASES")
        again = f"SUBDIV_CASES={cases} SUBDIV_SEED={seed}" if cases else f"SUBDIV_SEED={seed}"
        terminalreporter.write_line(f"the same cases again: {again} python -m pytest")


def pytest_unconfigure():
    """No test leaves anything behind."""
    if not WORKER:
        shutil.rmtree(os.environ["SUBDIV_CACHE_DIR"], ignore_errors=True)
