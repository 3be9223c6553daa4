"""Control polygons: a CSV file of points, two numbers in a row, exactly as they are spelled."""

from __future__ import annotations

import csv
import re
import sys
from fractions import Fraction
from pathlib import Path

from subdiv_cli.maskfile.problems import MaskFileError, shown, unreadable
from subdiv_cli.model import Problem

MAX_POINTS = 2_000
_MAX_BYTES = 1 << 20
_NUMBER = re.compile(
    r"[+-]?([0-9]{1,40}(\.[0-9]{0,40})?|\.[0-9]{1,40})([eE][+-]?[0-9]{1,2})?|[+-]?[0-9]{1,40}/[0-9]{1,40}"
)

Points = tuple[tuple[Fraction, ...], tuple[Fraction, ...]]
"""The x and the y."""


def read_points(file: str) -> Points:
    """The points of a CSV file; "-" is standard input. A first row without numbers is a header.

    Raises MaskFileError: SD002 where the file cannot be read, SD021 for what is no list of points.
    """
    try:
        if file == "-":
            data = sys.stdin.buffer.read(_MAX_BYTES + 1)
        else:
            with Path(file).open("rb") as stream:
                data = stream.read(_MAX_BYTES + 1)
    except OSError as error:
        raise MaskFileError([unreadable(file, error)]) from None
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise _bad(file, "the points are not UTF-8 text", "save them as CSV in UTF-8") from None
    if len(data) > _MAX_BYTES:
        raise _bad(file, "the file of points is larger than 1 MiB", f"the limit is {MAX_POINTS} points")
    return points(text, file)


def points(text: str, file: str) -> Points:
    """The points in a text."""
    found: list[tuple[Fraction, Fraction]] = []
    separator = ";" if ";" in text else ","
    try:
        rows = list(csv.reader(text.splitlines(), delimiter=separator, strict=True))
    except csv.Error as error:
        raise _bad(file, f"this is not CSV: {error}", "write one point in a line: 0.5, 1") from None
    for line, row in enumerate(rows, 1):
        cells = [cell.strip() for cell in row]
        if not any(cells) or cells[0].startswith("#"):
            continue
        numbers = [cell for cell in cells if _NUMBER.fullmatch(cell) and not re.search(r"/0+$", cell)]
        if not found and not numbers:
            continue  # the header
        if len(numbers) != 2 or len(cells) != 2:
            wrong = next((cell for cell in cells if cell not in numbers), f"{len(cells)} cells")
            raise _bad(file, f'"{shown(wrong)}" is not a point: two numbers in a row', "write 0.5, 1", line)
        found.append((Fraction(numbers[0]), Fraction(numbers[1])))
        if len(found) > MAX_POINTS:
            raise _bad(file, f"there are more than {MAX_POINTS} points", "draw a piece of the polygon", line)
    if len(found) < 2:
        raise _bad(file, "there are fewer than two points", "write one point in a line: 0.5, 1")
    return tuple(x for x, _ in found), tuple(y for _, y in found)


def _bad(file: str, message: str, mend: str, line: int | None = None) -> MaskFileError:
    return MaskFileError([Problem(code="SD021", message=message, help=mend, file=file, line=line)])
