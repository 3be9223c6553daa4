"""Control polygons and control nets: CSV files of points, every number exactly as it is spelled."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator
from fractions import Fraction
from itertools import product

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import at_most
from subdiv_cli.maskfile.problems import MaskFileError, shown, unreadable

MAX_POINTS = 2_000
MAX_NET = 10_000
_MAX_BYTES = 1 << 20
_NUMBER = re.compile(
    r"[+-]?([0-9]{1,40}(\.[0-9]{0,40})?|\.[0-9]{1,40})([eE][+-]?[0-9]{1,2})?|[+-]?[0-9]{1,40}/[0-9]{1,40}"
)
_INTEGER = re.compile(r"[+-]?[0-9]{1,6}")
_POINT, _VERTEX = "write 0.5, 1", "write 0, 1, 0.5, 1, 0: the place i, j and the point x, y, z"

Points = tuple[tuple[Fraction, ...], tuple[Fraction, ...]]
"""The x and the y coordinates of the points."""
Net = dict[tuple[int, ...], tuple[Fraction, ...]]
"""The vertices of a net by their places: (i, j) -> (x, y, z), for all places of a rectangle."""


def read_points(file: str) -> Points:
    """The points of a CSV file; "-" is standard input. A first row without numbers is a header.

    Raises MaskFileError: SD002 where the file cannot be read, SD021 for what is no list of points.
    """
    return points(_text(file, MAX_POINTS), file)


def read_net(file: str) -> Net:
    """The control net of a CSV file; "-" is standard input. Raises MaskFileError: SD002 or SD021."""
    return net(_text(file, MAX_NET), file)


def points(text: str, file: str) -> Points:
    """The points in a text."""
    polygon: list[tuple[Fraction, Fraction]] = []
    for line, cells in _rows(text, file, _POINT):
        x, y = _numbers(cells, 2, "a point: two numbers in a row", _POINT, file, line)
        polygon.append((x, y))
        if len(polygon) > MAX_POINTS:
            raise _bad(file, f"there are more than {MAX_POINTS} points", "draw a piece of the polygon", line)
    if len(polygon) < 2:
        raise _bad(file, "there are fewer than two points", "write one point in a line: 0.5, 1")
    return tuple(x for x, _ in polygon), tuple(y for _, y in polygon)


def net(text: str, file: str) -> Net:
    """The net in a text: its rows in any order, its places a rectangle."""
    vertices: Net = {}
    for line, cells in _rows(text, file, _VERTEX):
        numbers = _numbers(cells, 5, "a point of a net: i, j, x, y, z", _VERTEX, file, line)
        wrong = next((cell for cell in cells[:2] if not _INTEGER.fullmatch(cell)), None)
        if wrong is not None:
            raise _bad(file, f'"{shown(wrong)}" is no place in a net: i and j are integers', _VERTEX, line)
        place = int(cells[0]), int(cells[1])
        if place in vertices:
            raise _bad(file, f"the place {place[0]}, {place[1]} has a point already", "leave one out", line)
        vertices[place] = tuple(numbers[2:])
        if len(vertices) > MAX_NET:
            raise _bad(file, f"there are more than {MAX_NET} points", "write a piece of the net", line)
    if not vertices:
        raise _bad(file, "there are no points", _VERTEX)
    rows, columns = (range(min(side), max(side) + 1) for side in zip(*vertices, strict=True))
    if len(rows) * len(columns) > len(vertices):
        i, j = next(place for place in product(rows, columns) if place not in vertices)
        size = f"{rows[0]} … {rows[-1]} by {columns[0]} … {columns[-1]}"
        raise _bad(file, f"the net has no point at {i}, {j}", f"give one to every place of the rectangle {size}")
    return vertices


def _text(file: str, limit: int) -> str:
    """The text of a file of points. Raises MaskFileError."""
    try:
        data = at_most(file, _MAX_BYTES)
    except OSError as error:
        raise MaskFileError([unreadable(file, error)]) from None
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise _bad(file, "the points are not UTF-8 text", "save them as CSV in UTF-8") from None
    if len(data) > _MAX_BYTES:
        raise _bad(file, "the file of points is larger than 1 MiB", f"the limit is {limit} points")
    return text


def _rows(text: str, file: str, help: str) -> Iterator[tuple[int, list[str]]]:
    """The rows of cells with their lines, without empty ones, comments and a header."""
    separator = ";" if ";" in text else ","
    try:
        rows = list(csv.reader(text.splitlines(), delimiter=separator, strict=True))
    except csv.Error as error:
        raise _bad(file, f"this is not CSV: {error}", help) from None
    begun = False
    for line, row in enumerate(rows, 1):
        cells = [cell.strip() for cell in row]
        if not any(cells) or cells[0].startswith("#"):
            continue
        begun = begun or any(map(_is_number, cells))
        if begun:
            yield line, cells


def _is_number(cell: str) -> bool:
    """Whether a Fraction can be made of a cell."""
    return bool(_NUMBER.fullmatch(cell) and not re.search(r"/0+$", cell))


def _numbers(cells: list[str], count: int, what: str, help: str, file: str, line: int) -> list[Fraction]:
    """The numbers of a row, `count` of them. Raises MaskFileError."""
    if len(cells) != count or not all(map(_is_number, cells)):
        wrong = next((cell for cell in cells if not _is_number(cell)), f"{len(cells)} cells")
        raise _bad(file, f'"{shown(wrong)}" is not {what}', help, line)
    return list(map(Fraction, cells))


def _bad(file: str, message: str, help: str, line: int | None = None) -> MaskFileError:
    """The error of a text that is no list of points."""
    return MaskFileError([faults.BAD_POINTS.problem(message, help, file=file, line=line)])
