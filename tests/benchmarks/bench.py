"""How fast subdiv is, as ratios within one run: `python tests/benchmarks/bench.py`.

Each figure is the best of several runs, each in a process of its own where start-up counts. Machines are shared and
noisy: compare ratios, not milliseconds. `--save` keeps a run's ratios and `--compare` shows the change since then.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from argparse import ArgumentParser
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryDirectory

import masks

ROOT = Path(__file__).parents[2]
SCALAR = ROOT / "masks" / "scalar"
UNIT = "import click, rich, flint"
Rows = list[tuple[str, float]]


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


class Thousand:
    """A thousand generated masks, checked by the command line."""

    def __init__(self, directory: Path) -> None:
        self.masks, self.cache = directory / "masks", directory / "cache"
        self.masks.mkdir()
        self.count = masks.write(self.masks)

    def check(self, jobs: int, *options: str) -> float:
        """Seconds for all of them in a process of its own."""
        arguments = ["check", str(self.masks), "--allow-undecided", "--format", "junit", "--jobs", str(jobs), *options]
        command = [sys.executable, "-m", "subdiv_cli", *arguments]
        start = time.perf_counter()
        subprocess.run(command, stdout=subprocess.DEVNULL, check=False)
        return time.perf_counter() - start

    def rows(self) -> Rows:
        """Cold and from the cache, in one process and in two; what is compared is measured in turn."""
        cold = [(self.check(1, "--no-cache"), self.check(2, "--no-cache")) for _ in range(2)]
        kept = ("--cache-dir", str(self.cache))
        self.check(2, *kept)
        warm = [(self.check(1, *kept), self.check(2, *kept)) for _ in range(2)]
        named = {"cold": cold, "from the cache": warm}
        return [
            (f"{self.count} masks {name}, {jobs} job{'s' if jobs > 1 else ''}", min(pair[jobs - 1] for pair in pairs))
            for name, pairs in named.items()
            for jobs in (1, 2)
        ]


def rows() -> Rows:
    """Every figure: its name and its seconds."""
    check = ("-m", "subdiv_cli", "check")
    shipped = catalog()
    with TemporaryDirectory() as directory:
        kept = ("--cache-dir", directory)
        return [
            ("python -c pass", best(process("-c", "pass"))),
            (UNIT, best(process("-c", "import click, rich.console, rich.table, flint"))),
            ("subdiv --help", best(process("-m", "subdiv_cli", "--help"))),
            ("check bspline_degree_2.toml", best(process(*check, "--no-cache", str(SCALAR / "bspline_degree_2.toml")))),
            ("check four_point.toml", best(process(*check, "--no-cache", str(SCALAR / "four_point.toml")))),
            ("check four_point.toml, from the cache", best(process(*check, *kept, str(SCALAR / "four_point.toml")))),
            (f"shipped catalog in one process, per mask of {shipped}", best(catalog, 3) / shipped),
            ("norms of 20 coefficients, ν ≤ 8, L ≤ 10", best(norms_of_twenty_coefficients, 3)),
        ]


def table(figures: Rows, saved: Mapping[str, float]) -> str:
    """Milliseconds, the ratio to the imports, and by how much that ratio has changed since a saved run."""
    unit = dict(figures)[UNIT]
    width = max(len(name) for name, _ in figures)
    lines = [f"{'':{width}}         ms    ratio" + ("   saved   change" if saved else "")]
    for name, seconds in figures:
        line = f"{name:{width}} {1000 * seconds:10.1f} {seconds / unit:8.3f}"
        if name in saved:
            line += f"{saved[name]:8.3f} {100 * (seconds / unit / saved[name] - 1):+7.0f}%"
        lines.append(line)
    return "\n".join(lines)


def main() -> None:
    """Measure, print, compare, save."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--compare", type=Path, metavar="FILE", help="show the change since a saved run")
    parser.add_argument("--save", type=Path, metavar="FILE", help="save the ratios of this run as JSON")
    options = parser.parse_args()
    saved = {} if options.compare is None else json.loads(options.compare.read_text("utf-8"))
    figures = rows()
    with TemporaryDirectory() as directory:
        figures += Thousand(Path(directory)).rows()
    print(table(figures, saved))
    of = dict(figures)
    cold = [seconds for name, seconds in figures if " cold, " in name]
    print(f"two jobs are {cold[0] / cold[1]:.2f} times as fast as one")
    finding, writing, checking = min(time_of_checking() for _ in range(3))
    print(
        f"certificates of the catalog: writing {writing / finding:.2f} and checking {checking / finding:.2f} of finding"
    )
    if options.save is not None:
        ratios = {name: seconds / of[UNIT] for name, seconds in figures}
        options.save.write_text(json.dumps(ratios, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
