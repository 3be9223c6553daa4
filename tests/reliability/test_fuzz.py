"""Mutants of the shipped masks, half of them still masks: no crash, nothing proved that the checker does not verify.

A thousand in four parts, always the same; `SUBDIV_CASES` asks for another number of fresh ones. Those in several
variables are read, and written again.
"""

import json
import os
import re
from collections import Counter
from fractions import Fraction
from pathlib import Path

import pytest
from support import canonical, cases, seeded

from subdiv_cli.catalog.shipped import masks_directory
from subdiv_cli.catalog.task import Settings, Task, perform
from subdiv_cli.checker import check_text
from subdiv_cli.kinds.option import from_option
from subdiv_cli.kinds.reading import read_bytes, read_text
from subdiv_cli.kinds.writing import from_scheme, write
from subdiv_cli.maskfile import MaskFileError
from subdiv_cli.model import Verdict

PARTS = 4
COUNT = cases() // PARTS
TEXTS = [path.read_bytes() for path in sorted((masks_directory() / "scalar").rglob("*.toml"))]
MULTIVARIATE = {path: path.read_bytes() for path in sorted((masks_directory() / "multivariate").rglob("*.toml"))}
NUMBER = re.compile(rb"(?<=[\[\s\"(])-?\d+(?:/\d+)?(?=[\"\],\s)])")
JUNK = [
    b"\x00",
    b"\xff",
    b'"',
    b"[",
    b"]",
    b"=",
    b"#",
    b"1e999",
    b"nan",
    b"'''",
    b"w",
    b"z^",
    b"\\u",
    "ü".encode(),
    b"\n",
]
DECIDED = (Verdict.PROVED, Verdict.REFUTED)


def another_number(rng, data):
    """A number of the mask is another one: a mask as before, mostly a divergent one."""
    found = [m for m in NUMBER.finditer(data) if data.rfind(b"[mask]", 0, m.start()) >= 0]
    if not found:
        return data
    place = rng.choice(found)
    old = Fraction(place[0].decode()) if place[0][-2:] != b"/0" else Fraction(0)
    new = rng.choice([-old, old + 1, old / 2, old * 2, old + Fraction(1, rng.randint(2, 64)), Fraction(0)])
    quoted = data[place.start() - 1 : place.start()] == b'"'
    text = str(new).encode() if quoted or new.denominator == 1 else f'"{new}"'.encode()
    return data[: place.start()] + text + data[place.end() :]


def two_numbers(rng, data):
    """Two are exchanged: the sums stay, the smoothness does not."""
    found = [m for m in NUMBER.finditer(data) if data.rfind(b"coefficients", 0, m.start()) >= 0]
    if len(found) < 2:
        return another_number(rng, data)
    a, b = sorted(rng.sample(found, 2), key=lambda m: m.start())
    return data[: a.start()] + b[0] + data[a.end() : b.start()] + a[0] + data[b.end() :]


def a_parameter(rng, data):
    """The parameter has another value."""
    number = Fraction(rng.randint(-40, 40), rng.choice([1, 2, 3, 16, 64, 100]))
    default = re.compile(rb'^(\w+) = "[-0-9/]+"$', re.MULTILINE)
    changed = default.sub(rb'\1 = "' + str(number).encode() + b'"', data, count=1)
    return changed if changed != data else another_number(rng, data)


def without_expectations(rng, data):
    return another_number(rng, data.partition(b"[expect]")[0])


def noise(rng, data):
    """Bytes that stand for others, are added or are lost."""
    at = rng.randrange(len(data))
    if rng.random() < 0.5:
        return data[:at] + data[at + rng.randint(1, 9) :]
    return data[:at] + rng.choice(JUNK) + data[at + rng.randint(0, 3) :]


def lines(rng, data):
    """A line twice, none, or elsewhere."""
    rows = data.split(b"\n")
    row = rows.pop(rng.randrange(len(rows)))
    for _ in range(rng.randint(0, 2)):
        rows.insert(rng.randrange(len(rows) + 1), row)
    return b"\n".join(rows)


def cut(rng, data):
    return data[: rng.randrange(len(data))]


def crossed(rng, data):
    """The beginning of one file and the end of another."""
    other = rng.choice(TEXTS + list(MULTIVARIATE.values()))
    return data[: rng.randrange(len(data))] + other[rng.randrange(len(other)) :]


def shifted(rng, data):
    """The mask begins elsewhere, which changes nothing but its values."""
    return re.sub(rb"^start = -?\d+", b"start = %d" % rng.randint(-99, 99), data, count=1, flags=re.MULTILINE)


KEEP = [shifted, another_number, two_numbers, a_parameter, without_expectations]
BREAK = [noise, noise, lines, cut, crossed]


def mutant(rng, data):
    for _ in range(rng.choice([1, 1, 1, 2, 3])):
        data = rng.choice(KEEP)(rng, data)
    return rng.choice(BREAK)(rng, data) if rng.random() < 0.4 else data


def resident():
    """MiB in memory now."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


def hold(data, done):
    """What must be true of every result."""
    result = done.result
    if result.status == "invalid":
        assert result.problems, data
        assert all(problem.code != "SD099" for problem in result.problems), (data, result.problems)
        assert all("Traceback" not in problem.message for problem in result.problems)
        return
    decided = [finding for finding in result.findings if finding.verdict in DECIDED]
    if done.certificate is None:  # its proof asks more than the checker does, which long numbers alone can do
        assert not any(finding.claims for finding in decided), data
        assert b"Deslauriers" in data or len(data) > 500, data
        return
    outcome = check_text(done.certificate)
    assert outcome.verified, (data, outcome.line)
    document = json.loads(done.certificate)
    assert document["mask"] == canonical(read_bytes(data, file="x").scheme()), data
    for finding in decided:
        assert finding.claims, (data, finding)
        assert max(finding.claims) < len(document["claims"]), (data, finding)


@pytest.mark.parametrize("part", range(PARTS))
def test_mutants(part, capsys):
    rng, mix, sizes = seeded(part), Counter(), []
    settings = Settings(work=1000, certificates=True)
    for number in range(COUNT):
        data = mutant(rng, rng.choice(TEXTS))
        done = perform(Task("mutant.toml", data=data), settings)
        hold(data, done)
        mix[done.result.status] += 1
        mix[done.result.convergent.value] += done.result.status != "invalid"
        if number % max(1, COUNT // 5) == 0:
            sizes.append(resident())
    with capsys.disabled():
        print(f"\n  {COUNT} mutants, part {part}: {dict(mix)}, {sizes[1]:.0f} … {sizes[-1]:.0f} MiB")
    assert mix["invalid"] <= COUNT * 0.55, "half of them are still masks"
    assert mix["invalid"] >= COUNT * 0.25
    assert mix["proved"] >= COUNT * 0.1
    assert mix["refuted"] >= COUNT * 0.1
    assert sizes[-1] < sizes[1] + 40, "memory stays where it is"


def spelled(rng, numbers):
    """A list as some program prints it, and the numbers that it has; sometimes there is a factor."""
    times = rng.choice([1, 1, Fraction(1, 4), 2])
    words = [rng.choice([str(x), f"{x} ", f"({x})"]) for x in numbers]
    quote = rng.choice(["'", '"'])
    body = rng.choice(
        [
            lambda: f"[{', '.join(words)}]",
            lambda: f"[{'  '.join(map(str, numbers))}]",
            lambda: f"[{','.join(f'{quote}{x}{quote}' for x in numbers)}]",
            lambda: f"np.array([{', '.join(words)}])",
            lambda: f"array([{','.join(words)}], dtype=float64)",
            lambda: f"[{'; '.join(map(str, numbers))}]'",
            lambda: f"({', '.join(words)},0)",
            lambda: f"[{' '.join(map(str, numbers[:1]))} ...\n {' '.join(map(str, numbers[1:]))}]",
        ]
    )()
    if times == 1:
        bare = [",".join(words), " ".join(map(str, numbers)), "\n".join(map(str, numbers)) + "\n", ";".join(words)]
        divided = any(x.denominator > 1 for x in numbers[:-1]) or numbers[-1].denominator == 1
        text = rng.choice([body, *(bare if divided and len(numbers) > 1 else [])])
    else:
        text = rng.choice([f"{times}*{body}", f"{times} * {body}", f"{body}*{times}", f"{body} / ({1 / times});"])
    return text, tuple(times * x for x in numbers)


@pytest.mark.parametrize("part", range(PARTS))
def test_lists_of_other_programs_and_mutants_of_them(part):
    """Half are as they are printed, and are exactly those numbers; of the others nothing but MaskFileError comes."""
    rng, mix = seeded(part), Counter()
    for _ in range(COUNT):
        numbers = [Fraction(rng.randint(-9, 9), rng.choice([1, 1, 2, 4, 10])) for _ in range(rng.randint(1, 6))]
        numbers[0], numbers[-1] = numbers[0] or Fraction(1), numbers[-1] or Fraction(1)
        text, wanted = spelled(rng, numbers)
        if rng.random() < 0.5:
            assert read_text(text, file="-").scheme().coefficients == wanted, text
            assert from_option(text).scheme().coefficients == wanted, text
            mix["read"] += 1
            continue
        for _ in range(rng.randint(1, 3)):
            at = rng.randrange(len(text) + 1)
            text = text[:at] + rng.choice("[](),;:'\"\n ./*-+^zw=#{}…0e") + text[at + rng.randint(0, 1) :]
        try:
            mask = from_option(text, names=["w"])
            scheme = mask.scheme({name: Fraction(3, 2) for name in mask.parameters})
            mix["mutant read"] += 1
        except MaskFileError as error:
            (problem, *_) = error.problems
            assert problem.code != "SD099", text
            assert problem.help, text
            mix["refused"] += 1
            continue
        again = read_text(write(mask), file="--mask")
        assert again.scheme({name: Fraction(3, 2) for name in mask.parameters}) == scheme, text
    assert mix["read"] >= COUNT * 0.4
    assert mix["mutant read"] >= COUNT * 0.02
    assert mix["refused"] >= COUNT * 0.15


@pytest.mark.parametrize("part", range(PARTS))
def test_mutants_in_several_variables_are_read(part):
    rng, mix = seeded(part), Counter()
    for _ in range(COUNT):
        file = rng.choice(list(MULTIVARIATE))
        data = mutant(rng, MULTIVARIATE[file])
        try:
            mask = read_bytes(data, file=str(file))
            scheme = mask.scheme()
        except MaskFileError:
            mix["refused"] += 1
            continue
        mix[mask.kind] += 1
        again = read_bytes(write(from_scheme(scheme)).encode(), file="again")
        assert canonical(again.scheme()) == canonical(scheme), data
        assert read_bytes(write(mask).encode(), file=str(file)) == mask, data
    assert COUNT * 0.25 <= mix["refused"] <= COUNT * 0.67, "a third of them are still masks"
