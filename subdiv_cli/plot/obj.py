"""Nets as Wavefront OBJ: vertices, and faces of three or four, the same text for the same net."""

from __future__ import annotations

from subdiv_cli.model.blocks import Net


def obj(net: Net, title: str) -> str:
    """The text of the file, `title` its first line; every coordinate is the double next to the exact one.

    Raises OverflowError for a coordinate beyond all doubles.
    """
    places = sorted(net.vertices)
    number = {place: i for i, place in enumerate(places, 1)}
    lines = [f"# {title}"]
    lines += ["v " + " ".join(repr(float(x)) for x in net.vertices[place]) for place in places]
    for face in net.faces():
        lines.append("f " + " ".join(str(number[place]) for place in (face[::-1] if net.turned else face)))
    return "\n".join(lines) + "\n"
