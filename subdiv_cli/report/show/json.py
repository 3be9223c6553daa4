"""`subdiv show` as JSON, `"format": "subdiv-show"`, version 1: keys are added, never changed.

`report` is the mask's entry in the report of `check`, with the findings that only `show` has. Numbers are strings
`"p/q"`, sequences have the index of their first value.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import subdiv_cli
from subdiv_cli.model import Result
from subdiv_cli.model.blocks import Anatomy, Curve, Factor, Signal
from subdiv_cli.report.json import as_data, plain, valid
from subdiv_cli.report.look import Look
from subdiv_cli.report.show.formulas import symbol


def render(result: Result, anatomy: Anatomy, picture: Sequence[str], look: Look) -> str:
    """The page; how it is to look is of no matter here."""
    page = {
        "format": "subdiv-show",
        "version": 1,
        "tool": {"name": "subdiv", "version": subdiv_cli.__version__},
        "report": as_data(result, look),
        "mask": _signal(anatomy.mask),
        "symbol": {
            "text": symbol(anatomy),
            "constant": plain(anatomy.constant),
            "power": anatomy.power,
            "factors": [_factor(factor) for factor in anatomy.factors],
        },
        "polyphase": [_signal(component) for component in anatomy.components],
        "derived": [{"nu": nu, **_signal(mask)} for nu, mask in enumerate(anatomy.derived, 1)],
        "refinement_matrices": {
            "first_index": anatomy.window,
            "matrices": plain(anatomy.matrices),
            "eigenvalues": plain(anatomy.eigenvalues),
        },
        "support": plain(anatomy.support),
        "values": [{"order": order, **_signal(values)} for order, values in enumerate(anatomy.values)],
        "stencils": [{"order": order, **_signal(weights)} for order, weights in enumerate(anatomy.stencils)],
        "quasi_interpolation": _quasi(anatomy),
        "approximation_order": None
        if anatomy.orders is None
        else {"with_q": anatomy.orders[0], "without_q": anatomy.orders[1]},
        "error_bound": _witness(result, "SD511", ("constant", "norms", "level", "distance", "tolerance", "levels")),
        "hermite_bound": _witness(result, "SD512", ("order", "constant")),
        "curve": None if anatomy.curve is None else _curve(anatomy.curve),
    }
    return valid(json.dumps(page, ensure_ascii=False, indent=2, allow_nan=False) + "\n")


def _signal(signal: Signal) -> dict[str, Any]:
    return {"start": signal.start, "values": plain(signal.values)}


def _factor(factor: Factor) -> dict[str, Any]:
    return {
        "coefficients": plain(factor.coefficients),
        "multiplicity": factor.multiplicity,
        "smoothing": factor.smoothing,
        "zeros": list(factor.zeros),
    }


def _quasi(anatomy: Anatomy) -> dict[str, Any] | None:
    if anatomy.quasi_stencil is None:
        return None
    return {
        "degree": len(anatomy.operator) - 1,
        "moments": plain(anatomy.moments),
        "operator": plain(anatomy.operator),
        "stencil": _signal(anatomy.quasi_stencil),
        "eigen_sequences": plain(anatomy.eigen_sequences),
    }


def _witness(result: Result, code: str, keys: Sequence[str]) -> dict[str, Any] | None:
    """These numbers of a finding, where it is proved."""
    for found in result.findings:
        if found.code == code and found.witness:
            return {key: plain(found.witness[key]) for key in keys}
    return None


def _curve(curve: Curve) -> dict[str, Any]:
    return {
        "arity": curve.arity,
        "level": curve.level,
        "start": curve.start,
        "values": plain(curve.values),
    }
