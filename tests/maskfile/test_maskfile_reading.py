"""Good files: what is read, with parameters put in, from options, and written again."""

from __future__ import annotations

import contextlib
import io
import tomllib
from fractions import Fraction as Q

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from subdiv_cli.kinds.option import from_option
from subdiv_cli.kinds.reading import read_path, read_text
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.kinds.writing import from_scheme, write
from subdiv_cli.maskfile import MaskFile, MaskFileError
from subdiv_cli.maskfile.option import parse_expectation, parse_override
from subdiv_cli.maskfile.recognise import is_mask
from subdiv_cli.model import Expectation, Problem

FOUR_POINT = """\
format = 1
name = "four-point scheme"
reference = "Dyn, Gregory, Levin 1987"
kind = "scalar"

[parameters]
w = "1/16"

[mask]
arity = 2
start = -3
coefficients = ["-w", 0, "1/2 + w", 1, "1/2 + w", 0, "-w"]

[expect]
convergent = true
smoothness = 1
holder = "2"
generation = 3
reproduction = 3
stable = true
"""


def four_point(w: Q) -> ScalarScheme:
    return ScalarScheme(arity=2, start=-3, coefficients=(-w, Q(0), Q(1, 2) + w, Q(1), Q(1, 2) + w, Q(0), -w))


def test_the_file_of_the_design() -> None:
    mask = read_text(FOUR_POINT, file="four_point.toml")
    assert (mask.file, mask.name, mask.kind) == ("four_point.toml", "four-point scheme", "scalar")
    assert mask.reference == "Dyn, Gregory, Levin 1987"
    assert mask.values() == {"w": Q(1, 16)}
    assert mask.scheme() == four_point(Q(1, 16))
    assert mask.scheme({"w": Q(1, 20)}) == four_point(Q(1, 20))
    assert mask.expectations == (
        Expectation(key="convergent", text="true", lower=True, upper=True),
        Expectation(key="smoothness", text="1", lower=1, upper=1),
        Expectation(key="holder", text="2", lower=Q(2), upper=Q(2)),
        Expectation(key="generation", text="3", lower=3, upper=3),
        Expectation(key="reproduction", text="3", lower=3, upper=3),
        Expectation(key="stable", text="true", lower=True, upper=True),
    )


def test_the_symbol_gives_the_same_scheme() -> None:
    text = '[parameters]\nw = 0.0625\n[mask]\nsymbol = "z^-3 (1+z)^2 (z^2/2 - w (z-1)^2 (1+z^2))"\n'
    mask = read_text(text, file="symbol.toml")
    assert mask.scheme() == four_point(Q(1, 16))
    assert mask.scheme({"w": Q(-7, 3)}) == four_point(Q(-7, 3))


@pytest.mark.parametrize(
    "spelled",
    [
        '["1/2", 1, "1/2"]',
        "[0.5, 1, 0.5]",
        '["0.5", "1.0", "5e-1"]',
        "[5e-1, 1_0e-1, +0.5]",
        "[0, 0.5, 1, 0.5, 0]",
        '["1 - 1/2", "2^0", "(3-1)/4"]',
    ],
)
def test_spellings_of_one_mask(spelled: str) -> None:
    mask = read_text(f"[mask]\nstart = {-1 if spelled.startswith('[0, ') else 0}\ncoefficients = {spelled}\n", file="x")
    assert mask.scheme() == ScalarScheme(arity=2, start=0, coefficients=(Q(1, 2), Q(1), Q(1, 2)))


def test_decimals_are_what_they_spell() -> None:
    mask = read_text("[mask]\nstart = 0\ncoefficients = [0.1, 0.3333333333333333333333, 1e-30, 0xff]\n", file="x")
    assert mask.scheme().coefficients == (Q(1, 10), Q(3333333333333333333333, 10**22), Q(1, 10**30), Q(255))


def test_defaults_follow_earlier_parameters_and_overrides() -> None:
    text = '[parameters]\nu = 2\nv = "1/u + u^2"\n"ω_1" = ""\n[mask]\nsymbol = "u + v z + ω_1 z^2"\n'
    mask = read_text(text, file="x")
    assert mask.values({"ω_1": Q(5)}) == {"u": Q(2), "v": Q(9, 2), "ω_1": Q(5)}
    assert mask.values({"ω_1": Q(5), "u": Q(1, 2)}) == {"u": Q(1, 2), "v": Q(9, 4), "ω_1": Q(5)}
    assert mask.scheme({"ω_1": Q(5), "v": Q(0)}).coefficients == (Q(2), Q(0), Q(5))
    assert mask.parameters["ω_1"] is None


def test_a_default_that_fails_is_no_fault_where_it_is_overridden() -> None:
    mask = read_text('[parameters]\nw = 0\n[mask]\nstart = 0\ncoefficients = ["1/w", 1]\n', file="x")
    assert mask.scheme({"w": Q(1, 2)}).coefficients == (Q(2), Q(1))


@pytest.mark.parametrize(
    ("overrides", "message", "mend"),
    [
        ({"v": Q(1)}, "no parameter v", "its parameters: w"),
        ({"W": Q(1)}, "no parameter W", "did you mean w?"),
        ({"w": Q(10) ** 1001}, "more than 1000 digits", "shorter"),
    ],
)
def test_bad_overrides(overrides: dict[str, Q], message: str, mend: str) -> None:
    with pytest.raises(MaskFileError) as caught:
        read_text(FOUR_POINT, file="four_point.toml").scheme(overrides)
    (problem,) = caught.value.problems
    assert problem.code in ("SD010", "SD011")
    assert message in problem.message
    assert problem.help is not None
    assert mend in problem.help
    assert problem.file == "four_point.toml"


def test_files_and_standard_input(tmp_path, monkeypatch):
    path = tmp_path / "mask.toml"
    path.write_bytes(b"\xef\xbb\xbf" + FOUR_POINT.replace("\n", "\r\n").encode())
    assert read_path(path).scheme() == four_point(Q(1, 16))
    assert read_path(str(path)).file == str(path)

    class Stdin:
        buffer = io.BytesIO(FOUR_POINT.encode())

    monkeypatch.setattr("sys.stdin", Stdin)
    mask = read_path("-")
    assert (mask.file, mask.scheme()) == ("-", four_point(Q(1, 16)))


def test_is_mask() -> None:
    yes = [
        FOUR_POINT,
        "mask = 1",
        ' "kind"="x"',
        "[mask",
        "[ mask ]",
        "[mask.x]",
        "mask.arity = 2",
        "\ufeffkind = 1",
    ]
    yes += ["[parameters]\nw = 1/16\n[mask]\n", "name = broken\n[[parameters]]\n[mask]"]
    yes += [
        "",
        "# mask = 1",
        "masks = 1",
        "[masks]",
        "[[masks]]",
        "[Mask]",
        "[expect]\nconvergent = true",
        "symbol = '1'",
    ]
    yes += [
        "coefficients = [1]",
        "[coefficients]",
        "coefs = [1]",
        "start = 0\n",
        "[parameters]\nw = 1",
        "arity = 2 # p",
    ]
    yes += ["name = 'x'\n[msk]\nstart = 0\ncoefs = [1]\n", "[maks]\nsymbol = '1'"]
    no = [
        "matrices = [",
        "matrices = [[[1]]]\n[parameters]\na = 1",
        "[tool]\nkind = 1",
        "[project]\nmask = 2\n",
        "name = 'x'",
        "[tool.mask]\nx = 1",
        "[kind]\nx = 1",
    ]
    no += ["start = 1\nend = 2\n", "[parameters]\nlr = 0.1\n[training]\n", "[task]\nstart = 1\n[parameters]"]
    no += [
        "[project]\ncoefficients = [1]",
        "[tool.ruff]\nline-length = 120\n",
        "line-length = 100",
        "[rules]\nsymbol = 1",
    ]
    assert [is_mask(text.encode()) for text in yes if text != "[mask"] == [True] * (len(yes) - 1)
    assert all(is_mask(text.encode("utf-16")) for text in yes if text)
    assert [is_mask(text.encode()) for text in no] == [False] * len(no)


texts = st.text(st.characters(codec="utf-8"), max_size=20)
numbers = st.one_of(
    st.integers(-999, 999).map(str),
    st.fractions(max_denominator=64).map(str),
    st.sampled_from(["1/2 + w", "-w", "0.25", "w^2 (1 - w)", "2w/3"]),
)
EXPECT = {
    "convergent": st.just(True),
    "smoothness": st.sampled_from([0, 1, ">= 0", ">=1", "0 .. 1"]),
    "holder": st.sampled_from([1, "3/2", "log2(3)", ">= 1", "log4(8) .. 2", ">= 2 - log2(3)"]),
    "generation": st.sampled_from([5, ">= 5"]),
    "reproduction": st.sampled_from([3, ">= 2"]),
    "stable": st.booleans(),
}


@st.composite
def masks(draw: st.DrawFn) -> MaskFile:
    head = {"name": draw(st.none() | texts), "reference": draw(st.none() | texts)}
    defaults = draw(st.sampled_from([{"w": "1/16"}, {"w": "", "ω": "2"}, {"a": 3, "w": "a/7"}]))
    mask: dict[str, object] = {"arity": draw(st.integers(2, 5))}
    if draw(st.booleans()):
        mask |= {"start": draw(st.integers(-99, 99)), "coefficients": [*draw(st.lists(numbers, max_size=40)), "w+1"]}
    else:
        mask["symbol"] = " + z * ".join([*draw(st.lists(numbers.map("({})".format), max_size=4)), "1"])
    expect = {key: draw(EXPECT[key]) for key in draw(st.sets(st.sampled_from(sorted(EXPECT))))}
    expect = {k: v for k, v in expect.items() if not {"smoothness", "holder"} <= expect.keys() or k != "holder"}
    lines = [f"{k} = {quoted(v)}" for k, v in head.items() if v is not None] + ["[parameters]"]
    lines += [f"{quoted(k)} = {quoted(v)}" for k, v in defaults.items()] + ["[mask]"]
    lines += [f"{k} = {quoted(v)}" for k, v in mask.items()] + ["[expect]"]
    return read_text("\n".join([*lines, *(f"{k} = {quoted(v)}" for k, v in expect.items())]), file="drawn.toml")


def quoted(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list):
        return "[" + ", ".join(map(quoted, value)) + "]"
    if isinstance(value, str):
        return '"' + "".join(c if c.isalnum() or c in " +-*/^()=>." else f"\\U{ord(c):08x}" for c in value) + '"'
    return str(value)


@settings(max_examples=100, deadline=None)
@given(masks())
def test_written_masks_read_back_equal(mask: MaskFile) -> None:
    text = write(mask)
    again = read_text(text, file=mask.file)
    assert again == mask
    assert list(again.parameters) == list(mask.parameters)
    assert write(again) == text
    assert max(map(len, text.split("\n"))) <= 300
    assert tomllib.loads(text)["format"] == 1


@settings(max_examples=80, deadline=None)
@given(st.lists(st.fractions(), min_size=1, max_size=30).filter(any), st.integers(-50, 50), st.integers(2, 6), texts)
def test_schemes_written_and_read(coefficients: list[Q], start: int, arity: int, name: str) -> None:
    scheme = ScalarScheme(arity=arity, start=start, coefficients=tuple(coefficients))
    expected = parse_expectation("smoothness", ">= 1")
    mask = from_scheme(scheme, file="f", name=name, reference="made up", expectations=(expected,))
    again = read_text(write(mask), file="f")
    assert again == mask
    assert again.scheme() == scheme
    assert again.expectations == (expected,)


def test_writing_keeps_what_a_difference_would_show() -> None:
    mask = read_text(FOUR_POINT, file="x")
    changes = [("-w", "-2w"), ("smoothness = 1", 'smoothness = ">= 1"'), ("arity = 2", "arity = 3"), ("Dyn", "dyn")]
    for old, new in changes:
        assert read_text(FOUR_POINT.replace(old, new), file="x") != mask


def test_any_text_is_read_or_refused() -> None:
    """Mutated files: at least half stay valid masks, and nothing but MaskFileError is raised."""
    seen = {True: 0, False: 0}
    edits = st.lists(
        st.tuples(
            st.integers(0, len(FOUR_POINT)), st.integers(0, 6), st.text("w[]\"'=/^-+()1.\n{}z#,aé\\", max_size=4)
        ),
        max_size=2,
    )

    @settings(max_examples=300, deadline=None)
    @given(edits, st.sampled_from([True, True, False]))
    def mutate(edits: list[tuple[int, int, str]], harmless: bool) -> None:
        text = FOUR_POINT
        for at, length, replacement in edits:
            if harmless:
                at = text.find("\n", at)
                text = text if at < 0 else text[:at] + "  # " + replacement.replace("\n", " ") + text[at:]
            else:
                text = text[:at] + replacement + text[at + length :]
        problems: tuple[Problem, ...] = ()
        try:
            read_text(text, file="mutated").scheme()
        except MaskFileError as error:
            problems = error.problems
        seen[not problems] += 1
        for problem in problems:
            assert problem.message
            if problem.line is not None:
                assert problem.column is not None
                assert problem.source == text.split("\n")[problem.line - 1]

    mutate()
    assert seen[True] >= seen[False] > 0


@settings(max_examples=250, deadline=None)
@given(st.text(max_size=80) | st.text("mask[]\n=\"'{}1/w.# start", max_size=80))
def test_noise_is_read_or_refused(text: str) -> None:
    for reading in (lambda: read_text(text, file="noise"), lambda: from_option(text), lambda: parse_override(text)):
        with contextlib.suppress(MaskFileError):
            reading()
