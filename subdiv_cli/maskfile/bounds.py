"""Bounds on the size of a mask file and everything in it. Each is checked before the work it bounds is done."""

from __future__ import annotations

import sys
from pathlib import Path

MAX_FILE_BYTES = 1 << 18
"""The most bytes of a mask file, 256 KiB: a mask of 2000 coefficients with a hundred digits each stays below."""
MAX_NESTING = 32
"""The deepest nesting: parentheses in an expression; arrays, inline tables and dotted keys in TOML."""
MAX_DIGITS = 1000
"""The most decimal digits of a number as written, and the largest decimal exponent (`1e1000`)."""
MAX_BITS = 3322
"""The most bits of a numerator or a denominator: what `MAX_DIGITS` decimal digits take."""
MAX_EXPONENT = 1_000_000
"""The largest size of `start`, of a power, and of an exponent of z."""
MAX_MASK_LENGTH = 2000
"""The most coefficients of a mask, and terms of a Laurent polynomial on the way to it."""
MAX_GRID = 10_000
"""The most nested coefficients of a multivariate mask, zeros included."""
MAX_INDEX = 1000
"""The largest size of a component of an index, of a direction, and of an entry of a dilation matrix."""
MAX_DIMENSION = 4
"""The most variables."""
MAX_COSETS = 4096
"""The largest determinant of a dilation matrix in size."""
MAX_FACTORS = 64
"""The most directions of a box spline, counted with their multiplicities."""
MAX_ARITY = 64
MAX_MATRICES = 64
MAX_MATRIX_ORDER = 120
MAX_COMPONENTS = 16
"""The largest size m of the matrices of a mask."""
MAX_VECTOR_LENGTH = 200
"""The most matrices of a mask."""
MAX_ORDER = 1000
"""The largest expected smoothness, generation or reproduction degree."""
MAX_WORK = 2_000_000
"""The most products of small integers that all expressions of a file together may cost: about a second."""
MAX_PROBLEMS = 50
"""The most problems of one file that are shown."""


def at_most(file: str | Path, count: int) -> bytes:
    """The first bytes of a file, `count` of them and one more if there are; "-" is standard input. Raises OSError."""
    if str(file) == "-":
        return sys.stdin.buffer.read(count + 1)
    try:
        with Path(file).open("rb") as stream:
            return stream.read(count + 1)
    except ValueError:  # a null character in the name
        raise FileNotFoundError(2, "No such file or directory") from None
