"""Hypothesis without deadlines on shared machines, in CI the same examples every time; a cache of its own."""

import os
import shutil
import tempfile

from hypothesis import HealthCheck, settings

quiet = {"deadline": None, "suppress_health_check": [HealthCheck.too_slow]}
settings.register_profile("local", **quiet)
settings.register_profile("ci", derandomize=True, **quiet)
settings.load_profile("ci" if os.environ.get("CI") else "local")

for name in [name for name in os.environ if name.startswith("SUBDIV_")]:
    if not name.endswith(("_SIZE", "_ATTACK")):
        del os.environ[name]
CACHE = os.environ["SUBDIV_CACHE_DIR"] = tempfile.mkdtemp(prefix="subdiv-cache-")


def pytest_unconfigure():
    """No test leaves anything behind."""
    shutil.rmtree(CACHE, ignore_errors=True)
