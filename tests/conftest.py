"""Hypothesis on shared machines: no deadline for one example; in CI the same examples every time."""

import os

from hypothesis import HealthCheck, settings

quiet = {"deadline": None, "suppress_health_check": [HealthCheck.too_slow]}
settings.register_profile("local", **quiet)
settings.register_profile("ci", derandomize=True, **quiet)
settings.load_profile("ci" if os.environ.get("CI") else "local")
