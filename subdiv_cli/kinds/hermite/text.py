"""The text of a Hermite mask: that of a mask of matrices of size 2 or more."""

from __future__ import annotations

from collections.abc import Collection

from subdiv_cli.kinds.vector.text import MatrixCoefficients
from subdiv_cli.kinds.vector.text import read as read_matrices
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.entries import Table
from subdiv_cli.maskfile.problems import Collector, Fault


def read(top: Table, parameters: Collection[str], problems: Collector) -> MatrixCoefficients | None:
    """The mask of a file; None where something is wrong, which is recorded."""
    body = read_matrices(top, parameters, problems)
    if body is None:
        return None
    if len(body.matrices[0]) == 1:
        message = "the matrices are 1×1: a Hermite mask acts on a function and its derivatives, so m ≥ 2"
        help = 'write 2×2 matrices for a function and its derivative; for numbers as data kind = "scalar"'
        problems.add(Fault(faults.BAD_SHAPE, message, help), ("mask", "coefficients"))
        return None
    return body._replace(kind="hermite")
