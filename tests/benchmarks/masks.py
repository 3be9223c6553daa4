"""A catalog of a thousand masks: families over grids of their parameters, smooth, rough and divergent ones."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from pathlib import Path


def _file(name: str, start: int, coefficients: Sequence[Fraction], arity: int = 2) -> str:
    listed = ", ".join(f'"{c}"' for c in coefficients)
    return f'name = "{name}"\n[mask]\narity = {arity}\nstart = {start}\ncoefficients = [{listed}]\n'


def _four_point(w: Fraction) -> str:
    half = Fraction(1, 2)
    return _file(f"four-point {w}", -3, [-w, Fraction(0), half + w, Fraction(1), half + w, Fraction(0), -w])


def _corner_cutting(r: Fraction, s: Fraction) -> str:
    return _file(f"corner cutting {r} {s}", -2, [1 - r, 1 - s, r, s])


def _six_point(t: Fraction) -> str:
    half = [t, Fraction(0), -(Fraction(1, 16) + 3 * t), Fraction(0), Fraction(9, 16) + 2 * t]
    return _file(f"six-point {t}", -5, [*half, Fraction(1), *half[::-1]])


def texts() -> Iterator[str]:
    """A thousand mask files."""
    for i in range(300):
        yield _four_point(Fraction(i - 50, 1000))
    for i in range(20):
        for j in range(20):
            yield _corner_cutting(Fraction(i, 40), Fraction(20 + j, 40))
    for i in range(300):
        yield _six_point(Fraction(i - 100, 4000))


def write(directory: Path) -> int:
    """Write them all; how many there are."""
    count = 0
    for count, text in enumerate(texts(), 1):
        (directory / f"mask_{count:04}.toml").write_text(text, encoding="utf-8")
    return count
