"""`check` with hand-made results: what it is told by the catalog is written down here, and what it asks recorded."""

import sys
from types import ModuleType

import pytest
from cli_samples import result
from click.testing import CliRunner

from subdiv_cli import pipeline
from subdiv_cli.catalog.task import Done
from subdiv_cli.cli import main


class Catalog:
    """Stands in for subdiv_cli.catalog.run."""

    def __init__(self):
        self.asked = None
        self.results = [result("passed")]
        self.error = None

    def check_all(self, targets, **settings):
        listeners = {name: settings.pop(name, None) for name in ("on_total", "on_done", "on_skipped", "on_unwritten")}
        self.asked = (list(targets), settings)
        listeners["on_total"](len(self.results))
        for made in self.results:
            listeners["on_done"](Done(made))
            yield made
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


@pytest.fixture(scope="module")
def analyses():
    """What `show` has found of a mask so far."""
    return {}


@pytest.fixture
def analysed_once(monkeypatch, analyses):
    """Where the formats are the point: the first of them has a mask analysed, for all."""

    def show(scheme, tolerance, effort, show=pipeline.show):
        asked = repr((scheme, tolerance, effort.work))
        if asked not in analyses:
            analyses[asked] = show(scheme, tolerance, effort)
        return analyses[asked]

    monkeypatch.setattr(pipeline, "show", show)
