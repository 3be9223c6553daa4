"""Families of matrices in the files that their users have, as the TOML text that `subdiv jsr` reads.

Nested lists and JSON, NumPy's .npy, MATLAB's .mat (by scipy). Floats are taken as the decimals that they spell.
"""

from __future__ import annotations

import json
import re
from typing import Any, NamedTuple

from subdiv_cli.kinds.reading import load_path, text_of
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_MATRICES, MAX_MATRIX_ORDER
from subdiv_cli.maskfile.problems import MaskFileError

_NPY = b"\x93NUMPY"
_NO_TOML = re.compile(r"\s*(\{|(\[\s*){3}|(\[\s*)+[\d.+-])")
"""The beginning of a text that is no TOML with a family."""


class FamilyText(NamedTuple):
    """A family as TOML, and whether its numbers were floats."""

    text: str
    floats: bool = False


def family_text(file: str) -> FamilyText:
    """The text of a file with a family; TOML stays as it is. Raises MaskFileError."""
    data = load_path(file)
    if data.startswith(_NPY) or file.lower().endswith(".mat"):
        return _of_arrays(data, file)
    text = text_of(data, file)
    return FamilyText(_of_json(text, file) or text)


def _fault(message: str, help: str, file: str) -> MaskFileError:
    return MaskFileError([faults.WRONG_TYPE.problem(message, help, file=file)])


def _of_arrays(data: bytes, file: str) -> FamilyText:
    from subdiv_cli.jsr import array_files  # numpy comes with it

    read = array_files.npy_matrices if data.startswith(_NPY) else array_files.mat_matrices
    try:
        matrices, floats = read(data, MAX_MATRICES, MAX_MATRIX_ORDER)
    except array_files.ArrayFileError as error:
        message, help = error.args
        raise _fault(message, help, file) from None
    except ImportError:
        message = ".mat files are read by scipy, which is not installed"
        raise MaskFileError([faults.UNREADABLE_FILE.problem(message, 'pip install "subdiv[mat]"', file=file)]) from None
    spelled = [[[_Spelled(x) for x in row] for row in matrix] for matrix in matrices]
    return FamilyText(f"matrices = {_toml(spelled)}\n", floats)


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
    return head + f"matrices = {_toml(value if depth == 3 else [value])}\n"


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


def _toml(value: object) -> str:
    if isinstance(value, list):
        return f"[{', '.join(map(_toml, value))}]"
    return value if isinstance(value, _Spelled) else json.dumps(value)
