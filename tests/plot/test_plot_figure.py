"""Pictures by matplotlib: whole files of the right kind, the same bytes twice, and a clear word where it is missing."""

import sys

import pytest

from subdiv_cli.plot.figure import MissingExtraError, picture
from subdiv_cli.plot.sampled import Panel, line

PANELS = [
    Panel("φ", (line("one", [(0, 0), (1, 1)]), line("two", [(0, 1), (1, 0)]))),
    Panel("curve", (line("polygon", [(0, 0), (1, 0), (1, 1)], polygon=True),), plane=True),
]
MAGIC = {"svg": b"<?xml", "png": b"\x89PNG", "pdf": b"%PDF"}


@pytest.mark.parametrize("form", MAGIC)
def test_each_format(form):
    pytest.importorskip("matplotlib")
    content = picture(PANELS, form)
    assert content.startswith(MAGIC[form])
    assert content == picture(PANELS, form)
    assert picture(PANELS[:1], form) != content


def test_without_matplotlib(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(MissingExtraError):
        picture(PANELS, "svg")
