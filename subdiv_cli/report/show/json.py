"""The page of `subdiv show` as JSON, `"format": "subdiv-show"`, version 1: keys are added, never changed.

`report` is the mask's entry in the report of `check`, with the findings that only `show` has; what follows it is the
data of the kind. Numbers are strings `"p/q"`.
"""

from __future__ import annotations

import json

import subdiv_cli
from subdiv_cli.model import Result
from subdiv_cli.model.blocks import Portrait
from subdiv_cli.report.blocks import Draw
from subdiv_cli.report.json import as_data, plain, valid
from subdiv_cli.report.look import Look


def render(result: Result, portrait: Portrait, draw: Draw, look: Look) -> str:
    """The page as JSON; `look` does not change how it looks."""
    page = {
        "format": "subdiv-show",
        "version": 1,
        "tool": {"name": "subdiv", "version": subdiv_cli.__version__},
        "report": as_data(result, look),
        **plain(portrait.data),
    }
    return valid(json.dumps(page, ensure_ascii=False, indent=2, allow_nan=False) + "\n")
