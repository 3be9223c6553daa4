"""The report as lines of JSON, one for each mask, as in `results` of the JSON report: for streams."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence

from subdiv_cli.model import Result
from subdiv_cli.report.json import as_data, valid
from subdiv_cli.report.look import Look


def pieces(results: Sequence[Result], look: Look) -> Iterator[str]:
    """The lines of these results; those of a longer run may be rendered one by one."""
    for result in results:
        yield valid(json.dumps(as_data(result, look), ensure_ascii=False, allow_nan=False)) + "\n"
