"""How fast subdiv is, as ratios within one run: `python tests/benchmarks/bench.py`.

Machines are shared and noisy: compare ratios, not milliseconds. `--save` keeps a run's ratios and `--compare` shows the
change since then.
"""

from __future__ import annotations

import gc
import json
import sys
from argparse import ArgumentParser
from collections.abc import Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

sys.path.insert(0, str(Path(__file__).parents[1]))  # for `support`

from figures import UNIT, Figure, everything, times_of_checking


def table(figures: Sequence[Figure], saved: Mapping[str, float]) -> str:
    """Milliseconds, the ratio to the imports, and by how much that ratio has changed since a saved run."""
    unit = next(figure.seconds for figure in figures if figure.name == UNIT)
    width = max(len(figure.name) for figure in figures)
    lines = [f"{'':{width}}         ms    ratio" + ("   saved   change" if saved else "")]
    for name, seconds, note in figures:
        line = f"{name:{width}} {1000 * seconds:10.1f} {seconds / unit:8.3f}"
        if name in saved:
            line += f"{saved[name]:8.3f} {100 * (seconds / unit / saved[name] - 1):+7.0f}%"
        lines.append(line + (f"  {note}" if note else ""))
    return "\n".join(lines)


def main() -> None:
    """Measure, print, compare, save."""
    gc.set_threshold(50_000)  # as the command line does
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--compare", type=Path, metavar="FILE", help="show the change since a saved run")
    parser.add_argument("--save", type=Path, metavar="FILE", help="save the ratios of this run as JSON")
    options = parser.parse_args()
    saved = {} if options.compare is None else json.loads(options.compare.read_text("utf-8"))
    with TemporaryDirectory() as directory:
        figures = list(everything(Path(directory)))
    print(table(figures, saved))
    cold = [figure.seconds for figure in figures if " cold, " in figure.name]
    print(f"two jobs are {cold[0] / cold[1]:.2f} times as fast as one")
    checked = times_of_checking()
    finding, writing, checking = (sum(times) for times in zip(*(each[1:] for each in checked), strict=True))
    half, worst = sum(each.ratio <= 0.5 for each in checked), checked[0]
    print(f"certificates: writing {writing / finding:.2f} and checking {checking / finding:.2f} of finding;")
    print(f"checking at most half of both for {half} of {len(checked)} masks, {worst.ratio:.2f} for {worst.name}")
    if options.save is not None:
        unit = next(figure.seconds for figure in figures if figure.name == UNIT)
        ratios = {figure.name: figure.seconds / unit for figure in figures}
        options.save.write_text(json.dumps(ratios, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
