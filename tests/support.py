"""What several tests need: schemes by hand, and the pipeline's answer in one call."""

from __future__ import annotations

import os
import random
import re
from collections.abc import Mapping, Sequence
from contextlib import chdir
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

from click.testing import CliRunner
from click.testing import Result as ClickResult

from subdiv_cli.catalog import masks_directory
from subdiv_cli.catalog.run import check_all
from subdiv_cli.cli import main
from subdiv_cli.kinds import kind_of
from subdiv_cli.kinds.kind import Scheme
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.model import Effort, Finding, Result
from subdiv_cli.pipeline import check
from subdiv_cli.spaces.lattice import IntMatrix


class Run:
    """What a command has said: texts, which are read in its encoding alone; `output` is both as a terminal has them."""

    def __init__(self, done: ClickResult, encoding: str) -> None:
        self.returncode, self.stdout_bytes = done.exit_code, done.stdout_bytes
        self._done, self._encoding = done, encoding

    @property
    def stdout(self) -> str:
        return self.stdout_bytes.decode(self._encoding)

    @property
    def stderr(self) -> str:
        return self._done.stderr_bytes.decode(self._encoding)

    @property
    def output(self) -> str:
        return self._done.output_bytes.decode(self._encoding)


def subdiv(
    *arguments: object, cwd: Path | None = None, stdin: str = "", encoding: str = "utf-8", **environment: str | None
) -> Run:
    """A command as a shell would run it, but in this process; a variable that is None is taken from the environment."""
    variables = {"COLUMNS": None, "NO_COLOR": None, "FORCE_COLOR": None, **environment}
    with chdir(cwd or Path()):
        runner = CliRunner(charset=encoding)
        done = runner.invoke(main, [*map(str, arguments)], input=stdin, env=variables, prog_name="subdiv")
    return Run(done, encoding)


def cases(ordinary: int = 1000) -> int:
    """How many random cases: `ordinary`, or as many as SUBDIV_CASES asks for."""
    return int(os.environ.get("SUBDIV_CASES", ordinary))


def seeded(part: int) -> random.Random:
    """The random numbers of a part of the cases: always the same, or those of SUBDIV_SEED (see conftest.py)."""
    seed = os.environ.get("SUBDIV_SEED")
    return random.Random(part if seed is None else f"{seed}, {part}")


def scheme(coefficients: Sequence[int | str | Fraction], start: int = 0, arity: int = 2, over: int = 1) -> ScalarScheme:
    """A mask with these coefficients, divided by `over`."""
    return ScalarScheme(arity=arity, start=start, coefficients=tuple(Fraction(c) / over for c in coefficients))


def canonical(scheme: Scheme) -> Mapping[str, Any]:
    """A scheme as certificates embed it."""
    return kind_of(scheme).canonical(scheme)


def answer(mask: ScalarScheme | MultivariateScheme, work: int = 20_000) -> Result:
    return check(mask, (), Effort(work)).result


def multivariate_scheme(
    terms: Mapping[tuple[int, ...], Fraction], dilation: IntMatrix = ((2, 0), (0, 2))
) -> MultivariateScheme:
    """A mask in several variables."""
    return MultivariateScheme(dilation=dilation, terms=terms)


@cache
def shipped_results() -> list[Result]:
    """What is found of each mask of the catalog without a cache, once for all tests."""
    return list(check_all([str(masks_directory())]))


@cache
def shipped_multivariate(name: str) -> MultivariateScheme:
    """A mask of the catalog in several variables."""
    found = read_path(masks_directory() / "multivariate" / f"{name}.toml").scheme()
    assert isinstance(found, MultivariateScheme)
    return found


@cache
def shipped_answer(name: str) -> Result:
    """What is found of a mask of the catalog in several variables, once for all tests."""
    return answer(shipped_multivariate(name))


def findings(result: Result, code: str) -> list[Finding]:
    return [finding for finding in result.findings if finding.code == code]


def four_point(w: Fraction | str) -> ScalarScheme:
    w = Fraction(w)
    return scheme([-w, 0, Fraction(1, 2) + w, 1, Fraction(1, 2) + w, 0, -w], start=-3)


def six_point(theta: Fraction | str) -> ScalarScheme:
    t = Fraction(theta)
    half = [t, Fraction(0), -(Fraction(1, 16) + 3 * t), Fraction(0), Fraction(9, 16) + 2 * t]
    return scheme([*half, 1, *half[::-1]], start=-5)


def corner_cutting(r: Fraction | str, s: Fraction | str) -> ScalarScheme:
    r, s = Fraction(r), Fraction(s)
    return scheme([1 - r, 1 - s, r, s], start=-2)


def b_spline(degree: int, arity: int = 2) -> ScalarScheme:
    """(1+z+…+z^(p-1))^(degree+1) / p^degree."""
    coefficients = [Fraction(1, arity**degree)]
    for _ in range(degree + 1):
        coefficients = [
            sum(coefficients[max(0, i - arity + 1) : i + 1], Fraction(0)) for i in range(len(coefficients) + arity - 1)
        ]
    return scheme(coefficients, arity=arity)


def deslauriers_dubuc(points: int) -> ScalarScheme:
    """The interpolatory mask of the polynomial of degree points - 1 through `points` points, at the midpoint."""
    nodes = range(1 - points, points, 2)
    weights = []
    for i in nodes:
        weight = Fraction(1)
        for j in nodes:
            if j != i:
                weight *= Fraction(-j, i - j)
        weights.append(weight)
    coefficients = [Fraction(0)] * (2 * points - 1)
    coefficients[::2] = weights
    coefficients[points - 1] = Fraction(1)
    return scheme(coefficients, start=1 - points)


def looks_like_latex(text: str) -> None:
    """ASCII, braces and dollars in pairs, environments closed in order: no compiler here, but what breaks one."""
    assert text.isascii()
    bare = text.replace("\\\\", "").replace("\\{", "").replace("\\}", "").replace("\\$", "")
    assert bare.count("$") % 2 == 0
    assert "$$" not in bare
    depth = 0
    for c in bare:
        depth += (c == "{") - (c == "}")
        assert depth >= 0
    assert depth == 0
    opened: list[str] = []
    for kind, name in re.findall(r"\\(begin|end)\{(\w+)\}", bare):
        if kind == "begin":
            opened.append(name)
        else:
            assert opened.pop() == name
    assert not opened
    outside = re.sub(r"\$[^$]*\$|\\\[.*?\\\]|\\begin\{tikzpicture\}.*?\\end\{tikzpicture\}", "", bare, flags=re.DOTALL)
    for special in "_^#~":
        assert f"{special}" not in outside.replace(f"\\{special}", ""), special
    for line in re.findall(r"\\begin\{tabular\}\{(\w+)\}(.*?)\\end\{tabular\}", text, flags=re.DOTALL):
        columns, rows = line
        assert {row.count("&") for row in rows.split("\\\\")[:-1]} == {len(columns) - 1}
