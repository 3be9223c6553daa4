"""`check` with hand-made results: what it is told by the catalog is written down here, and what it asks recorded."""

import sys
from types import ModuleType

import pytest
from cli_samples import result
from click.testing import CliRunner

from subdiv_cli.cli import main


class Catalog:
    """Stands in for subdiv_cli.catalog.run."""

    def __init__(self):
        self.asked = None
        self.results = [result("passed")]
        self.error = None

    def check_all(self, targets, **settings):
        self.asked = (list(targets), settings)
        yield from self.results
        if self.error is not None:
            raise self.error


@pytest.fixture
def catalog(monkeypatch):
    catalog = Catalog()
    module = ModuleType("subdiv_cli.catalog.run")
    module.check_all = catalog.check_all
    monkeypatch.setitem(sys.modules, "subdiv_cli.catalog.run", module)
    for name in ("COLUMNS", "NO_COLOR", "FORCE_COLOR"):
        monkeypatch.delenv(name, raising=False)
    return catalog


@pytest.fixture
def run(catalog):
    """run("check", "a.toml") -> click's result, with stdout and stderr apart."""
    return lambda *args, **more: CliRunner().invoke(main, args, prog_name="subdiv", **more)
