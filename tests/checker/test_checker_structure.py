"""What is not a certificate of version 1 to the letter is rejected in one line, never with a traceback."""

import copy
import json
import os
import shutil
import subprocess
import sys
import time
from fractions import Fraction
from pathlib import Path

import pytest
from hand_made import ALL, chaikin, claim, document, four_point, naive_norm, poly, q, text

import subdiv_cli
from subdiv_cli.checker import check_document, check_file, check_text
from subdiv_cli.checker.__main__ import main
from subdiv_cli.checker.core import MAX_WORK

BY_HAND = Path(__file__).parents[1] / "certificate" / "chaikin_by_hand.json"


def rejected(content, *words):
    outcome = check_text(content) if isinstance(content, str) else check_document(content)
    assert not outcome.verified
    assert outcome.line.startswith("NOT VERIFIED ")
    assert "\n" not in outcome.line
    assert len(outcome.line) < 300
    assert "fails on it" not in outcome.line
    for word in words:
        assert word in outcome.line
    return outcome


def changed(path, value, make=chaikin):
    certificate = make()
    place = certificate
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = value
    return certificate


@pytest.mark.parametrize(
    "content", ["", " ", "nonsense", "{", "[]", "null", "1", '"x"', "{}", "\x00", "{}{}", "\ufeff{}"]
)
def test_other_texts(content):
    rejected(content, "document")


@pytest.mark.parametrize("value", [None, [], {}, "", 0, 2, -1, True, 1.0, "1", [1], {"version": 1}, float("nan")])
@pytest.mark.parametrize(
    "path",
    [
        ("format",),
        ("version",),
        ("mask",),
        ("goal",),
        ("claims",),
        ("mask", "kind"),
        ("mask", "arity"),
        ("mask", "start"),
        ("mask", "coefficients"),
        ("mask", "coefficients", 0),
        ("goal", 0),
        ("goal", 0, "property"),
        ("claims", 0),
        ("claims", 1, "rule"),
        ("claims", 1, "statement"),
        ("claims", 1, "statement", "property"),
        ("claims", 1, "statement", "order"),
        ("claims", 2, "statement", "mask"),
        ("claims", 1, "witness"),
        ("claims", 1, "witness", "quotient"),
        ("claims", 1, "witness", "quotient", "start"),
        ("claims", 1, "witness", "quotient", "coefficients"),
        ("claims", 1, "witness", "quotient", "coefficients", 0),
        ("claims", 2, "uses"),
        ("claims", 2, "uses", 0),
        ("claims", 2, "work"),
        ("claims", 7, "statement", "word"),
        ("claims", 7, "statement", "word", 0),
        ("claims", 7, "statement", "radius"),
        ("claims", 8, "statement", "holds"),
        ("claims", 9, "statement", "holds"),
        ("claims", 9, "witness", "cofactors"),
    ],
)
def test_wrong_types_anywhere(path, value):
    certificate = changed(path, value)
    original = chaikin()
    for key in path:
        original = original[key]
    if original == value and type(original) is type(value):
        pytest.skip("that is what stood there")
    if path[-1] == "arity" and value == 2:
        pytest.skip("that is what stood there")
    rejected(certificate)


@pytest.mark.parametrize("place", [(), ("mask",), ("goal", 0), ("claims", 0), ("claims", 1, "statement")])
def test_unknown_and_missing_keys(place):
    certificate = chaikin()
    spot = certificate
    for key in place:
        spot = spot[key]
    for key in list(spot):
        less = copy.deepcopy(certificate)
        target = less
        for step in place:
            target = target[step]
        del target[key]
        rejected(less)
    spot["comment\n\ud800"] = 1
    rejected(certificate, "unknown key")


def test_unknown_keys_in_witness_and_polynomial():
    rejected(changed(("claims", 5, "witness", "hint"), 1), "claim 5 (norm)", "unknown key 'hint'")
    rejected(changed(("claims", 1, "witness", "quotient", "end"), 1), "claim 1 (sum-rules)", "unknown key 'end'")


@pytest.mark.parametrize(
    "number",
    ["0.25", "1.0", "1e3", "1E400", "NaN", "Infinity", "-Infinity", "1" * 30, "-0", "1" * 5000, "true", "1e999999999"],
)
@pytest.mark.parametrize("key", ["order", "start", "work"])
def test_numbers_that_are_not_small_integers(number, key):
    head, separator, tail = text(chaikin()).rpartition(f'"{key}": ')
    assert separator
    rest = tail.lstrip("-0123456789")
    rejected(head + separator + number + rest)


@pytest.mark.parametrize(
    "number",
    ["2/8", "1/4 ", " 1/4", "+1/4", "0.25", "1e-1", "1/-4", "-1/-4", "1/0", "0/4", "-0", "01/4", "1/04", "4/1", "¼",
     "١/4", "", "/", "1/", "/4", "1/4/1", "1/4\n", "0x1", "1_0", "inf", "nan"],
)  # fmt: skip
def test_rationals_that_are_not_canonical(number):
    rejected(changed(("mask", "coefficients", 0), number), "the mask")
    rejected(changed(("claims", 5, "statement", "norm"), number), "claim 5 (norm)")


def test_long_numbers():
    """20,000 digits are read, whatever Python's own limit; 20,001 are not."""
    huge = "9" * 20_000
    for number in (huge, f"1/{huge}", f"-{huge}"):
        rejected(changed(("claims", 5, "statement", "norm"), number), "claim 5 (norm): the norm is another")
        rejected(changed(("claims", 7, "statement", "radius"), number))
        rejected(changed(("mask", "coefficients", 0), number))
    rejected(changed(("claims", 7, "statement", "radius"), huge), "claim 7 (product): all eigenvalues")
    rejected(changed(("claims", 7, "statement", "radius"), f"1/{huge}"), "claim 13 (not-smooth): the radius")
    rejected(changed(("claims", 5, "statement", "norm"), huge + "9"), "too many digits")
    rejected(changed(("claims", 5, "statement", "norm"), f"1/{huge}9"), "too many digits")
    rejected(changed(("mask", "coefficients"), ["1/2" + "0" * i + "1" for i in range(5000, 5020)]))


def test_duplicate_keys():
    once = '"property": "sum-rules"'
    content = text(chaikin())
    assert once in content
    rejected(content.replace(once, f"{once}, {once}"), "an object has a key twice")


def test_deep_nesting_and_long_lists():
    rejected("[" * 1_000_000, "document")
    rejected("[" * 100_000 + "]" * 100_000, "document")
    rejected('{"a":' * 100_000, "document")
    deep = []
    for _ in range(100_000):
        deep = [deep]
    rejected(changed(("mask",), deep))
    rejected(changed(("claims", 1, "witness"), {"quotient": deep}), "claim 1")
    rejected(changed(("mask", "coefficients"), ["1"] * 1_000_000), "too long")
    rejected(changed(("goal",), chaikin()["goal"] * 1000), "too long")
    rejected(changed(("claims", 7, "statement", "word"), [0] * 100_000), "too long")
    while deep:
        deep = deep.pop()


def test_sizes_are_bounded_before_anything_is_computed():
    began = time.process_time()
    rejected(changed(("claims", 6, "statement", "level"), 64), "claim 15 (holder-lower)")
    rejected(changed(("claims", 6, "statement", "level"), 10_000), "claim 6 (norm): the level")
    rejected(changed(("claims", 6, "statement", "level"), 10**6), "claim 6 (norm)")
    rejected(changed(("claims", 3, "statement", "level"), 60, four_point), "claim 3 (norm): it takes more work")
    rejected(changed(("claims", 3, "work"), 40_000_000, four_point_at_level(21)), "claim 3 (norm): it takes more work")
    rejected(changed(("claims", 11, "statement", "word"), [0, 1] * 1500, four_point), "claim 11 (product)")
    rejected(changed(("claims", 13, "statement", "order"), 10**6), "claim 13")
    rejected(changed(("claims", 13, "statement", "order"), 10_000**3), "claim 13")
    rejected(changed(("mask", "arity"), 10**9), "arity")
    rejected(changed(("mask", "start"), 10**9), "out of range")
    rejected(changed(("claims", 10, "statement", "mask"), 10_000))
    rejected(changed(("claims", 0, "witness"), {"cycle": 9_999}, ALL["cycle"]), "claim 0 (dependent)")
    assert time.process_time() - began < 5


def four_point_at_level(level):
    def make():
        certificate = four_point()
        certificate["claims"][3]["statement"]["level"] = level
        return certificate

    return make


def test_long_numbers_times_much_work():
    """A constant of 20,000 digits to the power 10,000 is refused, not computed."""
    digits = "7" * 19_999
    mask = {"start": 0, "coefficients": [digits, f"-{digits[:-1]}5"]}
    certificate = document(
        2,
        mask,
        [
            claim("sum-rules", mask=0, order=0, witness={"quotient": mask}),
            claim("norm", [0], mask=0, nu=1, level=1, norm="1"),
        ],
    )
    began = time.process_time()
    rejected(certificate, "claim 1 (norm)")
    wide = document(
        2,
        poly(0, 1, 1),
        [
            claim("sum-rules", mask=0, order=1, witness={"quotient": poly(0, 1)}),
            claim("norm", [0], mask=0, nu=1, level=64, norm="1"),
            claim("product", [0], mask=0, word=[0] * 4000, radius=digits),
        ],
    )
    rejected(wide, "claim 2 (product)")
    assert time.process_time() - began < 5


def test_work():
    for number, c in enumerate(chaikin()["claims"]):
        if c["rule"] == "eigen-condition":
            continue  # nothing is left to compute for this mask
        rejected(
            changed(("claims", number, "work"), 0), f"claim {number} ({c['rule']}): it takes more work than stated"
        )
    rejected(changed(("claims", 4, "work"), MAX_WORK), "claim 4 (reproduction)", str(MAX_WORK))
    rejected(changed(("claims", 4, "work"), 10**12), "claim 4 (reproduction)")
    assert check_document(changed(("claims", 4, "work"), MAX_WORK // 2)).verified
    split = changed(("claims", 4, "work"), MAX_WORK // 2)
    split["claims"][17]["work"] = MAX_WORK // 2
    rejected(split, "claim 17 (holder-upper)")


def test_uses():
    rejected(changed(("claims", 5, "uses"), []), "claim 5 (norm): it does not use a claim on sum-rules")
    rejected(changed(("claims", 5, "uses"), [1, 1]), "claim 5 (norm): it uses claims that it does not need")
    rejected(changed(("claims", 5, "uses"), [0]), "claim 5 (norm): it uses residue-sums, not sum-rules")
    for ahead in (5, 6, 18, 19, 10_000, -1):
        rejected(changed(("claims", 5, "uses"), [ahead]), "claim 5 (norm)")
    swapped = chaikin()
    swapped["claims"][13]["uses"].reverse()
    rejected(swapped, "claim 13 (not-smooth): it uses product, not stable")
    circular = chaikin()
    circular["claims"][9] = claim("stable", [10], mask=0, holds=True)
    rejected(circular, "claim 9 (stable): it uses a claim that does not come before it")


def test_missing_claims_and_goals():
    certificate = chaikin()
    certificate["claims"].pop()
    rejected(certificate, "goal: no claim proves: s <= 3")
    rejected(changed(("claims",), []), "goal: no claim proves")
    rejected(changed(("goal",), []), "goal: there is none")
    rejected(changed(("goal", 12, "order"), 2), "goal: no claim proves: φ is C^2")
    rejected(changed(("goal", 11, "holds"), False), "goal: no claim proves: S diverges")
    rejected(changed(("goal", 18, "norm"), "1/32"), "goal: no claim proves: α = 5/2")
    rejected(changed(("goal", 18, "norm"), "0"), "goal: no claim proves: ")
    rejected(changed(("goal", 11, "holds"), 1), "goal: ")
    without = chaikin()
    del without["claims"][5]
    rejected(without)


def test_unknown_names():
    rejected(changed(("claims", 5, "rule"), "norms"), "claim 5: unknown rule 'norms'")
    rejected(changed(("claims", 5, "rule"), "é\n" * 99), "claim 5: unknown rule")
    rejected(changed(("claims", 5, "statement", "property"), "smooth"), "claim 5 (norm)")
    rejected(
        changed(("claims", 5, "rule"), "converges"), "claim 5 (converges): the rule does not prove such statements"
    )
    rejected(changed(("version",), 2), "version")
    rejected(changed(("format",), "subdiv-report"), "format")
    rejected(changed(("mask", "kind"), "vectors"), "kind")


@pytest.mark.parametrize("other", [poly(0, 1, 3, 3, 1, over=4), poly(-1, 1, 4, 6, 4, 1, over=8), poly(0)])
def test_a_certificate_of_another_mask(other):
    certificate = chaikin()
    certificate["mask"] |= other
    rejected(certificate)


def test_subclasses_and_other_objects():
    class Sly(int):
        def __eq__(self, other):
            return True

        __hash__ = int.__hash__

    for value in (Sly(3), Fraction(1), object(), (1,), {1: 2}, {None: 3}):
        rejected(changed(("claims", 1, "statement", "order"), value), "claim 1 (sum-rules)")
    rejected(changed(("claims", 1, "statement"), {1: 2}), "claim 1")


def test_files(tmp_path, capsys):
    bad, bytes_, empty = tmp_path / "bad.json", tmp_path / "bytes.json", tmp_path / "empty.json"
    bad.write_text(text(changed(("claims", 5, "statement", "norm"), "1/4")), encoding="utf-8")
    bytes_.write_bytes(b"\xff\xfe\x00")
    empty.write_bytes(b"")
    assert main([str(BY_HAND)]) == 0
    assert capsys.readouterr().out.startswith("VERIFIED S converges; ")
    assert main([str(bad)]) == 1
    assert capsys.readouterr().out == "NOT VERIFIED claim 5 (norm): the norm is another\n"
    assert main([str(BY_HAND), str(bytes_), str(empty)]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith(f"{BY_HAND}: VERIFIED")
    assert lines[1] == f"{bytes_}: NOT VERIFIED document: not UTF-8"
    assert lines[2].startswith(f"{empty}: NOT VERIFIED document: not JSON")
    assert main([str(tmp_path / "none.json"), str(bad)]) == 2
    assert main([]) == main(["--help"]) == main([str(BY_HAND), "-x"]) == 2
    outcome, content = check_file(str(BY_HAND))
    assert outcome.verified
    assert json.loads(content)["version"] == 1


def test_it_runs_alone(tmp_path):
    """A copy of the folder and of the package's first file, isolated, without site packages."""
    package = Path(subdiv_cli.__file__).parent
    shutil.copytree(package / "checker", tmp_path / "subdiv_cli" / "checker", ignore=shutil.ignore_patterns("__py*"))
    shutil.copy(package / "__init__.py", tmp_path / "subdiv_cli")
    code = (
        f"import sys; sys.path.insert(0, {str(tmp_path)!r}); sys.argv = ['checker', *sys.argv[1:]]\n"
        "import runpy; runpy.run_module('subdiv_cli.checker', run_name='__main__', alter_sys=True)"
    )
    environment = {**os.environ, "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0", "LC_ALL": "C"}
    isolated = [sys.executable, "-I", "-S", "-c", code, str(BY_HAND)]
    run = subprocess.run(isolated, capture_output=True, text=True, encoding="utf-8", env=environment, cwd=tmp_path)
    assert (run.returncode, run.stderr) == (0, "")
    assert run.stdout.startswith("VERIFIED S converges; ")
    module = [sys.executable, "-S", "-E", "-s", "-m", "subdiv_cli.checker", str(BY_HAND), "missing.json"]
    run = subprocess.run(module, capture_output=True, text=True, encoding="utf-8", env=environment, cwd=tmp_path)
    assert run.returncode == 2
    assert "VERIFIED" in run.stdout
    assert "missing.json" in run.stderr
    assert "Traceback" not in run.stderr


def test_imports_stay_in_the_standard_library():
    code = (
        "import sys; before = set(sys.modules); from subdiv_cli.checker import KINDS, __main__\n"
        "rulebooks = [KINDS[name] for name in KINDS]; print(*set(sys.modules) - before)"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    modules = {name.split(".")[0] for name in run.stdout.split()}
    assert modules - {"subdiv_cli"} <= sys.stdlib_module_names
    ours = {name for name in run.stdout.split() if name.startswith("subdiv_cli.")}
    assert all(name.startswith("subdiv_cli.checker") for name in ours)


def test_a_norm_of_twelve_coefficients_at_level_ten_is_quick():
    """And right: the naive product of the same at level 4."""
    coefficients = [Fraction(c, 64) for c in (3, -7, 11, 20, -5, 31, 17, -2, 9, 13, -8, 1)]
    mask = [sum(coefficients[max(0, i - 1) : i + 1]) for i in range(13)]
    scale = 2 / sum(mask)
    mask = [c * scale for c in mask]
    quotient = [c * scale for c in coefficients]
    claims = [
        claim("sum-rules", mask=0, order=1, witness={"quotient": poly(0, *quotient)}),
        claim("norm", [0], mask=0, nu=1, level=4, norm=q(naive_norm(quotient, 2, 4)), work=10**6),
    ]
    assert check_document(document(2, poly(0, *mask), claims)).verified
    claims[1]["statement"]["level"] = 10
    certificate = document(2, poly(0, *mask), claims)
    times = []
    for _ in range(5):
        began = time.process_time()
        rejected(certificate, "claim 1 (norm): the norm is another")
        times.append(time.process_time() - began)
    assert min(times) < 0.04
