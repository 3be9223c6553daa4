"""Matrices in the files of NumPy and MATLAB, as decimals: each float is the shortest one that rounds to it."""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Iterable
from importlib import import_module
from math import prod
from typing import Any

import numpy as np
from numpy.lib import format as npy

_SHAPES = "save one square matrix, or an array of matrices, p×N×N"

Spelled = list[list[list[str]]]
"""Matrices by rows, each number as it is spelled."""


class ArrayFileError(Exception):
    """Raised where a file has no family of matrices; `args` are what is wrong, and the mend."""


def npy_matrices(data: bytes, most: int, largest: int) -> tuple[Spelled, bool]:
    """The matrices of an .npy file, at most `most` and one more, of order at most `largest`; and whether floats.

    Raises ArrayFileError. Nothing is unpickled.
    """
    try:
        _check_size(data)
        array = np.load(io.BytesIO(data), allow_pickle=False)
    except Exception as error:  # a header is parsed as Python, and raises whatever that does
        why = re.sub(r"[: ]*(<.* at 0x.*|\n.*)", "", str(error), flags=re.DOTALL)
        raise ArrayFileError(f"the array cannot be read: {why}", "save it by numpy.save, as numbers") from None
    if array.ndim not in (2, 3):
        raise ArrayFileError(f"the array has the shape {array.shape}", _SHAPES)
    return _of_arrays([array] if array.ndim == 2 else list(array[: most + 1]), largest)


def mat_matrices(data: bytes, most: int, largest: int) -> tuple[Spelled, bool]:
    """As `npy_matrices`, in the variables of a .mat file, in the order of their names; scipy reads it.

    An array N×N×p, or of cells, has several. Raises ArrayFileError, and ImportError without scipy.
    """
    load: Callable[..., dict[str, Any]] = import_module("scipy.io").loadmat
    try:
        variables = load(io.BytesIO(data), chars_as_strings=False)
    except Exception as error:  # many kinds, of compression too
        raise ArrayFileError(f"the file cannot be read: {error}", "save it by save -v7") from None
    named = [variables[name] for name in sorted(variables, key=_natural) if not name.startswith("__")]
    return _of_arrays([matrix for value in named for matrix in _members(value)][: most + 1], largest)


def _check_size(data: bytes) -> None:
    """Raise ValueError for an array that is larger than its file, before it is made."""
    stream = io.BytesIO(data)
    read = npy.read_array_header_1_0 if npy.read_magic(stream) == (1, 0) else npy.read_array_header_2_0
    shape, _, dtype = read(stream)
    if prod(shape) * dtype.itemsize > len(data):
        raise ValueError("the file ends before the array does")


def _natural(name: str) -> tuple[str, int, str]:
    """A key that sorts M2 before M10."""
    stem = name.rstrip("0123456789")
    return stem, int(name[len(stem) :] or 0), name


def _members(value: Any) -> Iterable[Any]:
    if value.dtype == object:
        return [matrix for cell in value.ravel(order="F") for matrix in _members(cell)]
    return [value[:, :, k] for k in range(value.shape[2])] if value.ndim == 3 else [value]


def _of_arrays(arrays: list[Any], largest: int) -> tuple[Spelled, bool]:
    if not arrays:
        raise ArrayFileError("there is no matrix", _SHAPES)
    for array in arrays:
        if array.ndim != 2 or array.shape[0] != array.shape[1] or not 1 <= array.shape[0] <= largest:
            raise ArrayFileError(f"a matrix has the shape {array.shape}", f"{_SHAPES}, N at most {largest}")
        if array.dtype.kind not in "biuf":
            raise ArrayFileError(f"the numbers are of type {array.dtype}", "save real numbers")
    arrays = [array.toarray() if hasattr(array, "toarray") else array for array in arrays]  # sparse ones
    for array in arrays:
        if not np.isfinite(array).all():
            raise ArrayFileError(f"a number is {array[~np.isfinite(array)][0]}", "save finite numbers")
    floats = any(array.dtype.kind == "f" and (array % 1).any() for array in arrays)
    return [[[_number(x) for x in row] for row in array] for array in arrays], floats


def _number(x: Any) -> str:
    """An integer, or the shortest decimal that rounds to the float."""
    if x.dtype.kind != "f":
        return str(int(x))
    return str(int(x)) if x % 1 == 0 and abs(x) < 2**53 else np.format_float_scientific(x, trim="0")
