"""Pictures for LaTeX, in TikZ: graphs and heights."""

from __future__ import annotations

from collections.abc import Iterator

from subdiv_cli.model.blocks import Curve, Heights, Picture

_WIDTH, _HEIGHT = 12, 5
"""The centimetres of the picture."""
_SIDE = 7
"""The centimetres of the longer side of a surface."""
_POINTS = 200
"""The number of points of a curve, about."""
_CELLS = 1_500
"""The number of cells of a surface, about."""


def picture(block: Picture) -> Iterator[str]:
    """The lines of a picture; none for polygons and nets."""
    if isinstance(block, Curve):
        yield from _curve(block)
    elif isinstance(block, Heights):
        yield from _heights(block)


def _curve(values: Curve) -> Iterator[str]:
    """The lines of φ and the axis of x, scaled to the page."""
    first, last = map(float, values.support)
    step = 1.0 / values.arity**values.level
    every = max(1, len(values.values) // _POINTS)
    inner = ((values.start + i) * step for i in range(0, len(values.values), every))
    points = [*zip(inner, map(float, values.values[::every]), strict=True)]
    points = [*([(first, 0.0)] if first < points[0][0] else []), *points]
    points += [(last, 0.0)] if points[-1][0] < last else []
    low, high = min(y for _, y in points), max(y for _, y in points)
    x_unit, y_unit = _WIDTH / (last - first), _HEIGHT / (high - low)
    yield f"\\begin{{center}}\\begin{{tikzpicture}}[x={x_unit:.5f}cm,y={y_unit:.5f}cm]"
    yield f"\\draw[gray] ({first:.5g},0) -- ({last:.5g},0);"
    yield "\\draw plot coordinates {" + " ".join(f"({x:.6g},{y:.6g})" for x, y in points) + "};"
    yield f"\\node[below] at ({first:.5g},0) {{${first:.4g}$}}; \\node[below] at ({last:.5g},0) {{${last:.4g}$}};"
    yield "\\end{tikzpicture}\\end{center}"


def _heights(heights: Heights) -> Iterator[str]:
    """The lines of a surface from above, one cell for each of some values: the darker the higher, negative in red."""
    every = 1
    while len(heights.values) > _CELLS * every**2:
        every += 1
    kept = {alpha: float(x) for alpha, x in heights.values.items() if x and not any(i % every for i in alpha[:2])}
    if not kept:
        return
    (a, b), (c, d) = ((float(x), float(y)) for x, y in heights.unit)
    places = {alpha: (a * alpha[0] + b * alpha[1], c * alpha[0] + d * alpha[1]) for alpha in kept}
    spans = [max(axis) - min(axis) for axis in zip(*places.values(), strict=True)]
    unit, top = _SIDE / (max(spans) or 1.0), max(map(abs, kept.values()))
    first, second = (a * every, c * every), (b * every, d * every)
    yield f"\\begin{{center}}\\begin{{tikzpicture}}[x={unit:.5f}cm,y={unit:.5f}cm]"
    for alpha, (x, y) in sorted(places.items()):
        shade = f"{'black' if kept[alpha] > 0 else 'red'}!{max(1, round(100 * abs(kept[alpha]) / top))}"
        (u, v), (w, z) = first, second
        corner = f"({x - (u + w) / 2:.4g},{y - (v + z) / 2:.4g})"
        sides = f"++({u:.4g},{v:.4g}) -- ++({w:.4g},{z:.4g}) -- ++({-u:.4g},{-v:.4g})"
        yield f"\\fill[{shade}] {corner} -- {sides} -- cycle;"
    yield "\\end{tikzpicture}\\end{center}"
