"""How fast subdiv is, as ratios within one run: `python tests/benchmarks/bench.py`.

Each figure is the best of several runs, each in a process of its own where start-up counts. Machines are shared and
noisy: compare ratios, not milliseconds.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from fractions import Fraction
from pathlib import Path

ROOT = Path(__file__).parents[2]
SCALAR = ROOT / "masks" / "scalar"


def best(run: Callable[[], object], times: int = 9) -> float:
    """Seconds of the fastest of some runs."""
    seconds = []
    for _ in range(times):
        start = time.perf_counter()
        run()
        seconds.append(time.perf_counter() - start)
    return min(seconds)


def process(*arguments: str) -> Callable[[], object]:
    """A Python process with these arguments, its output thrown away; run once, so that its byte code is cached."""
    command = [sys.executable, *arguments]
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}

    def run() -> object:
        return subprocess.run(command, cwd=ROOT, env=environment, stdout=subprocess.DEVNULL, check=True)

    run()
    return run


def twenty_coefficients() -> Sequence[Fraction]:
    """A mask with 20 coefficients and sum rules of order 8."""
    coefficients = [Fraction(c, 4097) for c in (3, -41, 150, -601, 1511, 2053, 1511, -601, 150, -41, 3, 0)]
    coefficients[-1] = 1 - sum(coefficients)
    for _ in range(8):
        coefficients = [(a + b) / 2 for a, b in zip([*coefficients, 0], [0, *coefficients], strict=True)]
    return [2 * c for c in coefficients]


def norms_of_twenty_coefficients() -> None:
    """‖((1/2)S_ν)^L‖∞ for ν = 1, …, 8 and L = 1, …, 10."""
    from subdiv_cli.exact.laurent import Laurent
    from subdiv_cli.model import Effort
    from subdiv_cli.quantities.norms import power_norms
    from subdiv_cli.schemes.operators import difference_symbol

    a = Laurent.from_coefficients(0, twenty_coefficients())
    for nu in range(1, 9):
        stream = power_norms(difference_symbol(a, 2, nu), 2, Effort(10**9))
        for _ in range(10):
            next(stream)


def time_of_checking() -> tuple[float, float, float]:
    """Seconds for finding, certifying and checking the shipped catalog, with every import done before."""
    from subdiv_cli.certificate import certificate
    from subdiv_cli.checker import check_document
    from subdiv_cli.maskfile import read_path
    from subdiv_cli.model import Effort
    from subdiv_cli.stages.scalar import analyse

    clock, spent = time.perf_counter, [0.0, 0.0, 0.0]
    for file in sorted(SCALAR.rglob("*.toml")):
        scheme = read_path(file).scheme()
        moments = [clock()]
        findings = analyse(scheme, Effort()).findings
        moments.append(clock())
        written = certificate(scheme.arity, scheme.start, scheme.coefficients, findings)
        moments.append(clock())
        assert written is not None
        assert check_document(written.document).verified
        moments.append(clock())
        spent = [total + end - start for total, start, end in zip(spent, moments, moments[1:], strict=False)]
    return spent[0], spent[1], spent[2]


def catalog() -> int:
    """The shipped catalog in this process; the number of masks."""
    from subdiv_cli.catalog.run import check_all

    return sum(1 for _ in check_all([str(SCALAR)]))


def main() -> None:
    check = ("-m", "subdiv_cli", "check")
    masks = catalog()
    rows = [
        ("python -c pass", best(process("-c", "pass"))),
        ("import click, rich, flint", best(process("-c", "import click, rich.console, rich.table, flint"))),
        ("subdiv --help", best(process("-m", "subdiv_cli", "--help"))),
        ("check bspline_degree_2.toml", best(process(*check, str(SCALAR / "bspline_degree_2.toml")))),
        ("check four_point.toml", best(process(*check, str(SCALAR / "four_point.toml")))),
        (f"catalog in one process, per mask of {masks}", best(catalog, 3) / masks),
        ("norms of 20 coefficients, ν ≤ 8, L ≤ 10", best(norms_of_twenty_coefficients, 3)),
    ]
    unit = rows[1][1]
    width = max(len(name) for name, _ in rows)
    print(f"{'':{width}}       ms   ratio to the imports")
    for name, seconds in rows:
        print(f"{name:{width}} {1000 * seconds:8.1f}   {seconds / unit:6.3f}")
    finding, writing, checking = min(time_of_checking() for _ in range(3))
    print(
        f"certificates of the catalog: writing {writing / finding:.2f} and checking {checking / finding:.2f} of finding"
    )


if __name__ == "__main__":
    main()
