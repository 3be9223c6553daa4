"""Nets as Wavefront OBJ: vertices, and faces of three or four, the same text for the same net."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from subdiv_cli.model.blocks import Net

Place = tuple[int, ...]


def obj(net: Net, title: str) -> str:
    """The text of the file; every coordinate is the double next to the exact one.

    Raises OverflowError for a coordinate beyond all doubles.
    """
    places = sorted(net.vertices)
    number = {place: i for i, place in enumerate(places, 1)}
    lines = [f"# {title}"]
    lines += ["v " + " ".join(repr(float(x)) for x in net.vertices[place]) for place in places]
    for face in faces(net):
        lines.append("f " + " ".join(str(number[place]) for place in (face[::-1] if net.turned else face)))
    return "\n".join(lines) + "\n"


def faces(net: Net) -> Iterator[tuple[Place, ...]]:
    """Those with all their vertices in the net, counterclockwise in Z^2."""
    known: Mapping[Place, object] = net.vertices
    for i, j in sorted(known):
        a, b, c, d = (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)
        halves = {None: ((a, b, c, d),), (1, 1): ((a, b, c), (a, c, d)), (1, -1): ((a, b, d), (b, c, d))}
        yield from (face for face in halves[net.diagonal] if all(place in known for place in face))
