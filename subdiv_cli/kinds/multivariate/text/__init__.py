"""The text of a mask in several variables: what [mask] may say, one form a file, and the way back.

`reading` is where the reader comes in; the forms themselves are data, in `bodies`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.model.closed import rational


def canonical(scheme: MultivariateScheme) -> Mapping[str, Any]:
    """The mask as certificates embed it, in one spelling, so that two masks are the same iff these are equal."""
    return {
        "kind": scheme.kind,
        "dilation": [list(row) for row in scheme.dilation],
        "terms": [[list(index), rational(value)] for index, value in scheme.terms.items()],
    }
