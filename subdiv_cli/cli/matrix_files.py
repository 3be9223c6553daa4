"""Families of matrices in the files that their users have, as the TOML text that `subdiv jsr` reads.

Nested lists and JSON, NumPy's .npy, MATLAB's .mat (by scipy). Floats are taken as the decimals that they spell.
"""

from __future__ import annotations

import io
import json
import re
from collections.abc import Callable, Iterable
from importlib import import_module
from math import prod
from typing import Any, NamedTuple

from subdiv_cli.kinds.reading import load_path, text_of
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_MATRICES, MAX_MATRIX_ORDER
from subdiv_cli.maskfile.problems import MaskFileError

_NPY = b"\x93NUMPY"
_NO_TOML = re.compile(r"\s*(\{|(\[\s*){3}|(\[\s*)+[\d.+-])")
"""The beginning of a text that is no TOML with a family."""
_SHAPES = "one square matrix, or an array of matrices, p×N×N"


class FamilyText(NamedTuple):
    """A family as TOML, and whether its numbers were floats."""

    text: str
    floats: bool = False


def family_text(file: str) -> FamilyText:
    """The text of a file with a family; TOML stays as it is. Raises MaskFileError."""
    data = load_path(file)
    if data.startswith(_NPY):
        return _of_arrays(_npy(data, file), file)
    if file.lower().endswith(".mat"):
        return _of_arrays(_mat(data, file), file)
    text = text_of(data, file)
    return FamilyText(_of_json(text, file) or text)


def _fault(message: str, help: str, file: str) -> MaskFileError:
    return MaskFileError([faults.WRONG_TYPE.problem(message, help, file=file)])


def _of_json(text: str, file: str) -> str | None:
    """The TOML text of nested lists, or of an object with `matrices`; None where the text is not JSON."""
    if not text.lstrip("\ufeff \t\r\n").startswith(("[", "{")):
        return None
    try:
        value: Any = json.loads(text.removeprefix("\ufeff"), parse_float=_Spelled, parse_int=_Spelled)
    except (ValueError, RecursionError) as error:
        if _NO_TOML.match(text.removeprefix("\ufeff")) or file.lower().endswith(".json"):
            raise _not_json(error, file) from None
        return None
    name = None
    if isinstance(value, dict):
        if unknown := value.keys() - {"matrices", "name"}:
            raise _fault(f"the object has the key {min(unknown)!r}", "keep `matrices`, and `name` if you like", file)
        name, value = value.get("name"), value.get("matrices")
        if not isinstance(name, str | None) or isinstance(name, _Spelled):
            raise _fault("the name is no text", "write a string under `name`, or leave it out", file)
    depth, inner = 0, value
    while isinstance(inner, list):
        depth, inner = depth + 1, inner[0] if inner else None
    if depth not in (2, 3):
        raise _fault("these are no matrices", "write a list of matrices, each a list of rows", file)
    head = "" if name is None else f"name = {json.dumps(name)}\n"
    return head + f"matrices = {_spelled(value if depth == 3 else [value])}\n"


def _not_json(error: ValueError | RecursionError, file: str) -> MaskFileError:
    """The error where a text that must be JSON is none."""
    message, help = "this is not valid JSON: it is nested too deep", "write [[[1, 1], [0, 1]], [[1, 0], [1, 1]]]"
    if not isinstance(error, json.JSONDecodeError):
        return MaskFileError([faults.TOML_SYNTAX.problem(message, help, file=file)])
    message = f"this is not valid JSON: {error.msg}"
    place = {"line": error.lineno, "column": error.colno, "source": error.doc.split("\n")[error.lineno - 1]}
    return MaskFileError([faults.TOML_SYNTAX.problem(message, help, file=file, **place)])


class _Spelled(str):
    """A number as the text spells it."""

    __slots__ = ()


def _spelled(value: object) -> str:
    if isinstance(value, list):
        return f"[{', '.join(map(_spelled, value))}]"
    return value if isinstance(value, _Spelled) else json.dumps(value)


def _npy(data: bytes, file: str) -> list[Any]:
    import numpy as np

    try:
        _check_size(data)
        array = np.load(io.BytesIO(data), allow_pickle=False)
    except Exception as error:  # a header is parsed as Python, and raises whatever that does
        why = re.sub(r"[: ]*(<.* at 0x.*|\n.*)", "", str(error), flags=re.DOTALL)
        raise _fault(f"the array cannot be read: {why}", "save it by numpy.save, as numbers", file) from None
    if array.ndim not in (2, 3):
        raise _fault(f"the array has the shape {array.shape}", f"save {_SHAPES}", file)
    return [array] if array.ndim == 2 else list(array[: MAX_MATRICES + 1])


def _check_size(data: bytes) -> None:
    """Raise ValueError for an array that is larger than its file, before it is made."""
    from numpy.lib import format as npy

    stream = io.BytesIO(data)
    version = npy.read_magic(stream)
    read = npy.read_array_header_1_0 if version == (1, 0) else npy.read_array_header_2_0
    shape, _, dtype = read(stream)
    if prod(shape) * dtype.itemsize > len(data):
        raise ValueError("the file ends before the array does")


def _mat(data: bytes, file: str) -> list[Any]:
    """The matrices in the variables of a file, in the order of their names; N×N×p and cell arrays have several."""
    load = _loadmat(file)
    try:
        variables = load(io.BytesIO(data), chars_as_strings=False)
    except Exception as error:  # many kinds, of compression too
        raise _fault(f"the file cannot be read: {error}", "save it by save -v7", file) from None
    named = [variables[name] for name in sorted(variables, key=_natural) if not name.startswith("__")]
    return [matrix for value in named for matrix in _members(value)]


def _loadmat(file: str) -> Callable[..., dict[str, Any]]:
    """The function of scipy that reads .mat files."""
    try:
        loadmat: Callable[..., dict[str, Any]] = import_module("scipy.io").loadmat
    except ImportError:
        problem = faults.UNREADABLE_FILE.problem(
            ".mat files are read by scipy, which is not installed", 'pip install "subdiv[mat]"', file=file
        )
        raise MaskFileError([problem]) from None
    return loadmat


def _natural(name: str) -> tuple[str, int, str]:
    """A key that sorts M2 before M10."""
    stem = name.rstrip("0123456789")
    return stem, int(name[len(stem) :] or 0), name


def _members(value: Any) -> Iterable[Any]:
    if value.dtype == object:
        return [matrix for cell in value.ravel(order="F") for matrix in _members(cell)]
    return [value[:, :, k] for k in range(value.shape[2])] if value.ndim == 3 else [value]


def _of_arrays(arrays: list[Any], file: str) -> FamilyText:
    if not arrays:
        raise _fault("there is no matrix", f"save {_SHAPES}", file)
    for array in arrays:
        if array.ndim != 2 or array.shape[0] != array.shape[1] or not 1 <= array.shape[0] <= MAX_MATRIX_ORDER:
            raise _fault(f"a matrix has the shape {array.shape}", f"save {_SHAPES}, N at most {MAX_MATRIX_ORDER}", file)
        if array.dtype.kind not in "biuf":
            raise _fault(f"the numbers are of type {array.dtype}", "save real numbers", file)
    arrays = [array.toarray() if hasattr(array, "toarray") else array for array in arrays]  # sparse ones
    matrices = [[[_number(x, file) for x in row] for row in array] for array in arrays[: MAX_MATRICES + 1]]
    floats = any(array.dtype.kind == "f" and (array % 1).any() for array in arrays)
    return FamilyText(f"matrices = {_spelled(matrices)}\n", floats)


def _number(x: Any, file: str) -> _Spelled:
    """An integer, or the shortest decimal that rounds to the float."""
    import numpy as np

    if x.dtype.kind != "f":
        return _Spelled(int(x))
    if not np.isfinite(x):
        raise _fault(f"a number is {x}", "save finite numbers", file)
    return _Spelled(int(x) if x % 1 == 0 and abs(x) < 2**53 else np.format_float_scientific(x, trim="0"))
