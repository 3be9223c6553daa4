"""Joint spectral radii: what `jsr` proves and how long it takes, beside Gripenberg's algorithm in floats, in one run.

`python tests/benchmarks/radii.py`. Processor time; the ratio is to branch and bound with the 2-norm, which proves
nothing, until its bounds are a thousandth apart or its products have had `_ENTRIES` entries.
"""

from __future__ import annotations

import random
import sys
import time
import tomllib
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path

import numpy as np

from subdiv_cli.model import Effort
from subdiv_cli.pipeline import joint_spectral_radius

FAMILIES = Path(__file__).parents[1] / "data" / "jsr"
_ENTRIES = 2_000_000
_NEAR = 1e-3


def gripenberg(matrices: np.ndarray) -> tuple[float, float]:
    """Bounds of the radius of p matrices N×N (Gripenberg 1996)."""
    lower = upper = 0.0
    products, bounds, looked, length = np.eye(matrices.shape[1])[None], np.array([np.inf]), 0, 0
    while len(products) and looked + 2 * products.size < _ENTRIES:
        length += 1
        products = (matrices[None] @ products[:, None]).reshape(-1, *matrices.shape[1:])
        norms = np.linalg.norm(products, ord=2, axis=(1, 2)) ** (1 / length)
        bounds = np.minimum(np.repeat(bounds, len(matrices)), norms)
        lower = max(lower, float(np.abs(np.linalg.eigvals(products)).max() ** (1 / length)))
        looked += products.size
        kept = bounds > lower * (1 + _NEAR)
        products, bounds = products[kept], bounds[kept]
    upper = max([lower * (1 + _NEAR), *bounds.tolist()])
    return lower, upper


def families() -> Iterator[tuple[str, list[list[list[Fraction]]]]]:
    """Families of the literature and at random, with their names."""
    for name in ("overlap20", "mejstrik_119", "longsmp15", "consensus", "sel1"):
        with (FAMILIES / f"{name}.toml").open("rb") as file:
            rows = tomllib.load(file, parse_float=Fraction)["matrices"]
        yield name, [[[Fraction(x) for x in row] for row in m] for m in rows]
    for order in (64, 100):
        yield f"stochastic in other units, {order}", stochastic(order)
    for order, seed in ((12, 2), (20, 0), (20, 1), (20, 2), (20, 3), (60, 1)):
        entries = np.random.default_rng(seed).integers(-1, 2, (2, order, order))
        yield f"-1, 0, 1 at random, {order}, {seed}", [[[Fraction(int(x)) for x in row] for row in m] for m in entries]
    entries = np.random.default_rng(60).integers(0, 2, (2, 60, 60))
    yield "0, 1 at random, 60", [[[Fraction(int(x)) for x in row] for row in m] for m in entries]


def stochastic(order: int) -> list[list[list[Fraction]]]:
    """Two matrices of row sums 1, in units of 1 to 50."""
    rng = random.Random(order)
    units = [rng.randrange(1, 50) for _ in range(order)]
    family = []
    for _ in range(2):
        rows = [[rng.randrange(10) for _ in range(order)] for _ in range(order)]
        pairs = zip(rows, units, strict=True)
        family.append([[Fraction(x * d, sum(row) * c) for x, d in zip(row, units, strict=True)] for row, c in pairs])
    return family


def timed(run: Callable[[], object]) -> tuple[object, float]:
    """What a function returns, and the seconds of processor time that it takes."""
    start = time.process_time()
    return run(), time.process_time() - start


def main() -> None:
    """Print the table; names of families may be given as arguments, or parts of them."""
    wanted = sys.argv[1:]
    print(f"{'':34} {'seconds':>8} {'ratio':>7}  {'width':>9}  rule, and the width that Gripenberg has")
    for name, family in families():
        if wanted and not any(part in name for part in wanted):
            continue
        floats = np.array([[[float(x) for x in row] for row in m] for m in family])
        (lower, upper), other = timed(lambda floats=floats: gripenberg(floats))
        checked, seconds = timed(lambda family=family: joint_spectral_radius(family, Effort()))
        radius = checked.radius
        width = "exact" if radius.exact or radius.digits else f"{radius.width:.1e}"
        theirs = f"{(upper - lower) / upper:.1e}"
        print(f"{name:34} {seconds:8.2f} {seconds / other:7.2f}  {width:>9}  {radius.method}, {theirs}", flush=True)


if __name__ == "__main__":
    main()
