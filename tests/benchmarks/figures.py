"""What is measured: each figure is the best of several runs, of processes of their own where start-up counts.

Machines are shared, so it is processor time; only where jobs run side by side is it what a clock shows.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import masks

if TYPE_CHECKING:
    from subdiv_cli.kinds.scalar.scheme import ScalarScheme

ROOT = Path(__file__).parents[2]
SCALAR = ROOT / "masks" / "scalar"
UNIT = "import click, rich, flint"


class Figure(NamedTuple):
    """What was measured, and how long it took."""

    name: str
    seconds: float
    note: str = ""


def best(run: Callable[[], object], times: int = 9) -> float:
    """Seconds of processor time, in this process and those it starts, of the fastest of some runs."""
    seconds = []
    for _ in range(times):
        start = _spent()
        run()
        seconds.append(_spent() - start)
    return min(seconds)


def _spent() -> float:
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(usage.ru_utime + usage.ru_stime for usage in used)


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
    from subdiv_cli.kinds.scalar.numbers.norms import power_norms
    from subdiv_cli.kinds.scalar.numbers.operators import difference_symbol
    from subdiv_cli.model import Effort

    a = Laurent.from_coefficients(0, twenty_coefficients())
    for nu in range(1, 9):
        stream = power_norms(difference_symbol(a, 2, nu), 2, Effort(10**9))
        for _ in range(10):
            next(stream)


class Checking(NamedTuple):
    """Seconds that a mask of the shipped catalog takes, each the least of some runs, with every import done before."""

    name: str
    finding: float
    """Its stages."""
    writing: float
    """The claims of its certificate."""
    checking: float

    @property
    def ratio(self) -> float:
        """Checking against finding the certificate: stages and claims."""
        return self.checking / (self.finding + self.writing)


def times_of_checking(times: int = 5) -> list[Checking]:
    """Of every scalar mask that ships, the ratios falling."""
    from subdiv_cli.kinds.reading import read_path

    found = []
    for file in sorted(SCALAR.rglob("*.toml")):
        scheme = read_path(file).scheme()
        runs = [_time_of_checking(scheme) for _ in range(times)]
        found.append(Checking(file.stem, *map(min, zip(*runs, strict=True))))
    return sorted(found, key=lambda each: -each.ratio)


def _time_of_checking(scheme: ScalarScheme) -> tuple[float, float, float]:
    from subdiv_cli.checker import check_document, matrices
    from subdiv_cli.kinds.scalar.claims import certificate
    from subdiv_cli.kinds.scalar.stages import analyse
    from subdiv_cli.model import Effort

    matrices._characteristic_polynomial.cache_clear()
    moments = [time.process_time()]
    analysis = analyse(scheme, Effort())
    moments.append(time.process_time())
    written = certificate(analysis)
    moments.append(time.process_time())
    assert written is not None
    assert check_document(written.document).verified
    moments.append(time.process_time())
    first, second, third = (end - start for start, end in pairwise(moments))
    return first, second, third


GOLDEN = "matrices = [[[1, 1], [0, 1]], [[1, 0], [1, 1]]]\n"
"""A pair whose joint spectral radius is the golden ratio."""


def commands(directory: Path) -> Iterator[Figure]:
    """The command line on one mask or family: what a person waits for."""
    four_point, subdiv, check = str(SCALAR / "four_point.toml"), ("-m", "subdiv_cli"), ("-m", "subdiv_cli", "check")
    family, proofs = directory / "family.toml", directory / "proofs"
    family.write_text(GOLDEN, encoding="utf-8")
    process(*check, "-q", four_point, "--no-cache", "--certificate", str(proofs))
    proof = str(proofs / "four_point.json")
    yield Figure("python -c pass", best(process("-c", "pass")))
    yield Figure(UNIT, best(process("-c", "import click, rich.console, rich.table, flint")))
    yield Figure("subdiv --help", best(process(*subdiv, "--help")))
    spline = str(SCALAR / "bspline_degree_2.toml")
    yield Figure("check bspline_degree_2.toml", best(process(*check, "--no-cache", spline)))
    yield Figure("check four_point.toml", best(process(*check, "--no-cache", four_point)))
    kept = ("--cache-dir", str(directory / "kept"))
    yield Figure("check four_point.toml, from the cache", best(process(*check, *kept, four_point)))
    yield Figure("verify its certificate", best(process(*subdiv, "verify", proof)))
    yield Figure("verify it by the checker alone", best(process("-m", "subdiv_cli.checker", proof)))
    yield Figure("show four_point.toml", best(process(*subdiv, "show", four_point)))
    yield Figure("jsr of a pair of 2×2 matrices", best(process(*subdiv, "jsr", str(family))))


MULTIVARIATE = ("loop", "zwart_powell", "butterfly", "butterfly_1_12", "quincunx_interpolatory", "kobbelt_sqrt3")


def multivariate() -> Iterator[Figure]:
    """Masks in two variables: all stages, the certificate, and its check, which every run has."""
    for name in MULTIVARIATE:
        file = str(ROOT / "masks" / "multivariate" / f"{name}.toml")
        yield Figure(f"check {name}.toml", best(process("-m", "subdiv_cli", "check", "--no-cache", file), 3))


def polytopes() -> Iterator[Figure]:
    """Invariant polytopes of the last difference schemes of the Deslauriers–Dubuc masks, whose order grows by 2."""
    from support import deslauriers_dubuc

    from subdiv_cli.jsr.family import Family
    from subdiv_cli.jsr.radius import joint_spectral_radius
    from subdiv_cli.kinds.scalar.numbers.operators import transition_matrices
    from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
    from subdiv_cli.model import Effort

    for points in (10, 12, 14, 16):
        numbers = ScalarNumbers(deslauriers_dubuc(points), Effort())
        family = Family(transition_matrices(numbers.difference(numbers.order), numbers.p))
        radius = joint_spectral_radius(family, Effort())
        assert radius is not None
        assert radius.exact
        seconds = best(lambda family=family: joint_spectral_radius(family, Effort()), 3)
        name = f"polytope of Deslauriers–Dubuc, {points} points"
        yield Figure(name, seconds, f"order {numbers.transition_order}, {radius.vertices} vertices")


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
        """Seconds on the clock for all of them in a process of its own."""
        arguments = ["check", str(self.masks), "--allow-undecided", "--format", "junit", "--jobs", str(jobs), *options]
        command = [sys.executable, "-m", "subdiv_cli", *arguments]
        start = time.perf_counter()
        subprocess.run(command, stdout=subprocess.DEVNULL, check=False)
        return time.perf_counter() - start

    def figures(self) -> Iterator[Figure]:
        """Cold and from the cache, in one process and in two; what is compared is measured in turn."""
        cold = [(self.check(1, "--no-cache"), self.check(2, "--no-cache")) for _ in range(2)]
        kept = ("--cache-dir", str(self.cache))
        self.check(2, *kept)
        warm = [(self.check(1, *kept), self.check(2, *kept)) for _ in range(2)]
        named = {"cold": cold, "from the cache": warm}
        for name, pairs in named.items():
            for jobs in (1, 2):
                text = f"{self.count} masks {name}, {jobs} job{'s' if jobs > 1 else ''}"
                yield Figure(text, min(pair[jobs - 1] for pair in pairs))


def everything(directory: Path) -> Iterator[Figure]:
    """Every figure."""
    yield from commands(directory)
    yield from multivariate()
    shipped = catalog()
    yield Figure(f"shipped catalog in one process, per mask of {shipped}", best(catalog, 3) / shipped)
    yield Figure("norms of 20 coefficients, ν ≤ 8, L ≤ 10", best(norms_of_twenty_coefficients, 3))
    yield from polytopes()
    yield from Thousand(directory).figures()
