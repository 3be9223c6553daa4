"""Masks and parameter values from the command line."""

from __future__ import annotations

from fractions import Fraction as Q
from typing import Any

import pytest

from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.option import from_option
from subdiv_cli.kinds.reading import read_text
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.kinds.writing import write
from subdiv_cli.maskfile import MaskFileError
from subdiv_cli.maskfile.option import Given, parse_override
from subdiv_cli.maskfile.pasted import is_toml


def four_point(w: Q) -> ScalarScheme:
    return ScalarScheme(arity=2, start=-3, coefficients=(-w, Q(0), Q(1, 2) + w, Q(1), Q(1, 2) + w, Q(0), -w))


@pytest.mark.parametrize(
    ("text", "start", "coefficients"),
    [
        ("[-1,0,9,16,9,0,-1]/16", -3, four_point(Q(1, 16)).coefficients),
        (" [ -1 , 0, 9, 16, 9, 0, -1 ] / 16 ", -3, four_point(Q(1, 16)).coefficients),
        ("[1/2, 1, 0.5]", 0, (Q(1, 2), Q(1), Q(1, 2))),
        ("[1, 1+1, -(-1)] * 3 / 2", 5, (Q(3, 2), Q(3), Q(3, 2))),
        ("[1]/(1/2)^2", 0, (Q(4),)),
        ("(1+z)^2/2", 0, (Q(1, 2), Q(1), Q(1, 2))),
        ("1", 0, (Q(1),)),
    ],
)
def test_masks_from_the_command_line(text: str, start: int, coefficients: tuple[Q, ...]) -> None:
    mask = from_option(text, start=start, arity=3)
    assert mask.scheme() == ScalarScheme(arity=3, start=start, coefficients=coefficients)
    assert read_text(write(mask), file="--mask") == mask


@pytest.mark.parametrize(
    ("text", "code", "message", "column"),
    [
        ("[1,2", "SD008", "never closed", 1),
        ("[]", "SD009", "the mask is empty", 2),
        ("[0, 0]/2", "SD009", "all coefficients", 1),
        ("[1, 2 2]", "SD008", "the number 2 stands directly after", 7),
        ("[1 2", "SD008", "never closed", 1),
        ("[1, 3; 3, 1]/4", "SD008", "[1, 3; 3, 1] is a matrix, as MATLAB writes it", 6),
        ("[1 3; 3 1]/4", "SD008", "[1 3; 3 1] is a matrix, as MATLAB writes it", 5),
        ("1,3\n3,1\n", "SD008", "one list or the rows of a matrix?", 4),
        ("0,25; 0,75", "SD008", "Decimals have a point", 5),
        ("1,3,3,1/4", "SD008", "is the list divided, or its last number?", 8),
        ('["0,5", 1]', "SD008", 'the character """', 2),
        ('["1/2, 1]', "SD008", 'the character """', 2),
        ('{"coefficients": [1, 3, 3, 1]}', "SD008", "braces are no list", 1),
        ("[0.125 0.375 ... 0.125]", "SD008", "the list is abridged", 14),
        ("(1+z)*[1, 3, 3, 1]", "SD008", "z cannot stand in a single number", 4),
        ("1/0*[1, 3, 3, 1]", "SD007", "division by zero", 3),
        ("v*[1, 3, 3, 1]", "SD008", '"v" is not declared', 1),
        ("(1, 3, 3, 1]", "SD008", '"," stands where', 3),
        ("1 + 1*[1, 3, 3, 1]", "SD008", '"+" stands where * or / or a list', 3),
        ("[1, 3] * [3, 1]", "SD008", '"[" stands where', 10),
        ("Fraction(1, 2), 1", "SD008", "function call", 1),
        ("[1,]", "SD008", '"]" stands where', 4),
        ("[1,2]/0", "SD007", "division by zero", 7),
        ("[1,z]", "SD008", "z cannot stand", 4),
        ("[1,2] 3", "SD008", "* or / or the end", 7),
        ("[1,w]/2", "SD008", '"w" is not declared', 4),
        ("1/(1+z)", "SD008", "1 + z does not divide 1", 3),
        ("", "SD008", "empty", 1),
        ("[1, z], 2", "SD008", "z cannot stand", 5),
    ],
)
def test_bad_masks_from_the_command_line(text: str, code: str, message: str, column: int) -> None:
    with pytest.raises(MaskFileError) as caught:
        from_option(text)
    (problem, *_) = caught.value.problems
    assert problem.code == code
    assert message in problem.message
    assert problem.file == "--mask"
    assert text == "" or problem.column == column


def test_mends_on_the_command_line() -> None:
    for text, mend in (
        ("[1,w]", "give it a value: -p w=1/16"),
        ("[1, 3; 3, 1]/4", "a mask in two variables is lists in lists: [[1, 3], [3, 1]]"),
        ("1,3\n3,1\n", "put one list in brackets; a mask in two variables is [[1,3], [3,1]]"),
        ("1,3,3,1/4", "write [1,3,3,1]/4 or [1,3,3,1/4]"),
        ('{"a": [1, 3, 3, 1]}', "write the list alone: [1, 3, 3, 1]"),
        ("3/8 z", "write * to multiply, 3/8 * z, or put the divisor in parentheses, 3/(8 z)"),
        ("(1+z)**4/8", "write ^ for a power: (…)^4"),
        ("z**3", "write ^ for a power: z^3"),
        ("z + 0,25", "write decimals with a point: 0.25"),
    ):
        with pytest.raises(MaskFileError) as caught:
            from_option(text)
        assert caught.value.problems[0].help == mend


CUBIC = ["1/4", "3/4", "3/4", "1/4"]
SPELLED = {
    "1/4*[1, 3, 3, 1]": CUBIC,
    "1/4 [1 3 3 1]": CUBIC,
    "(1/4)[1, 3, 3, 1]": CUBIC,
    "-1/2*[1, 2]/2": ["-1/4", "-1/2"],
    "-[1, 2]": ["-1", "-2"],
    "(1+1)*[1 + 1, 2]": ["4", "4"],
    '["1/4", \'3/4\', "3/4", 0.25]': CUBIC,
    '["1/2 + 1/4", "(1+2)/4"]': ["3/4", "3/4"],
    '["1/2 + 1", "3/2"]/2': ["3/4", "3/4"],
    "[2.5e-1, 0.75, 7.5E-1, 25e-2]": CUBIC,
    "array([0.25, 0.75, 0.75, 0.25])": CUBIC,
    "np.array([1, 3, 3, 1], dtype=float64) / 4": CUBIC,
    "0.25*numpy.array([1., 3., 3., 1.])": CUBIC,
    "[np.float64(0.25), np.float64(0.75), np.float64(0.75), np.float64(0.25)]": CUBIC,
    "[np.float64(1 + 2)/4, float(3)/4]": ["3/4", "3/4"],
    "[0.25 0.75 0.75 0.25]": CUBIC,
    "[ 0.25 -0.75\n -0.75  0.25]": ["1/4", "-3/4", "-3/4", "1/4"],
    "[1 -2 + 3 4]": ["1", "1", "4"],
    "[1 - 2 3]": ["-1", "3"],
    "[1 -2, 3]": ["-1", "3"],
    "[1 3 3 1]/4;": CUBIC,
    "[1; 3; 3; 1]'/4": CUBIC,
    "[1, 3, ...\n 3, 1]./4": CUBIC,
    "(0.25, 0.75, 0.75, 0.25)": CUBIC,
    "(1,3,3,1)/4": CUBIC,
    "1/4,3/4,3/4,1/4": CUBIC,
    "0.25,0.75,0.75,0.25\n": CUBIC,
    "0.25;0.75;0.75;0.25": CUBIC,
    "0.25\t0.75\t0.75\t0.25": CUBIC,
    "0.25\n0.75\r\n0.75\n\n0.25\n": CUBIC,
    "0.25,\n0.75,\n0.75,\n0.25,\n": CUBIC,
    "1/4 3/4 3/4 1/4": CUBIC,
    "(1+z)^3\n/ 4\n": CUBIC,
    "(1 + z) (1 + z) (1 + z) / 4": CUBIC,
}


@pytest.mark.parametrize("text", SPELLED)
def test_spellings_of_other_programs(text: str) -> None:
    """Each is the mask that is meant, exactly, from --mask and from standard input, and is written as it reads."""
    wanted = ScalarScheme(arity=2, start=0, coefficients=tuple(map(Q, SPELLED[text])))
    mask = from_option(text)
    assert mask.scheme() == wanted
    assert read_text(write(mask), file="--mask") == mask
    assert read_text(text, file="-").scheme() == wanted


def test_spellings_with_parameters_and_in_two_variables() -> None:
    for text in ("w, 1, w", "[w 1 w]", "1/2*[2w, 2, 2w]", '["w", 1, "w"]'):
        assert from_option(text, names=["w"]).scheme({"w": Q(1, 2)}).coefficients == (Q(1, 2), 1, Q(1, 2))
    rows = "[[1 2 1]\n [2 4 2]\n [1 2 1]]"
    for text in (f"{rows}/4", "array([[1, 2, 1], [2, 4, 2], [1, 2, 1]])/4", "((1,2,1),(2,4,2),(1,2,1))/4"):
        assert from_option(text, start=(-1, -1)).scheme().terms == BILINEAR


@pytest.mark.parametrize(
    ("text", "toml"),
    [
        ("[mask]\ncoefficients = [1, 1]", True),
        ("kind = 1", True),
        ("", True),
        ("# nothing\n", True),
        ("[mask]\n", True),
        ("[mask\n1, 1", True),
        ("[[1, 2], [2, 1]]", False),
        ("[1, 1]", False),
        ("(1+z)^2/2", False),
        ('["a = b", 1]', False),
        ("array([1, 1], dtype=int)", False),
        ("1, 1  # a = b", False),
        ("[w 1 w]/2", False),
    ],
)
def test_a_mask_file_is_told_from_a_list(text: str, toml: bool) -> None:
    assert is_toml(text) is toml


def test_what_stands_beside_a_list_on_standard_input() -> None:
    read = read_text("[w, 1, w]", file="-", given=Given((-3,), 3, ("w",)))
    assert read.scheme({"w": Q(2)}) == ScalarScheme(arity=3, start=-3, coefficients=(Q(2), Q(1), Q(2)))
    with pytest.raises(MaskFileError, match="--start belongs to a list of coefficients"):
        read_text("[mask]\ncoefficients = [1, 1]\n", file="-", given=Given((-3,), None, ()))
    with pytest.raises(MaskFileError) as caught:
        read_text("[1, 2\n 3, v]", file="-")
    assert [(p.file, p.line, p.column) for p in caught.value.problems] == [("-", 2, 2)]
    with pytest.raises(MaskFileError, match="table name"):
        read_text("[1, 2, 1]", file="list.toml")


def test_parameters_of_a_mask_from_the_command_line() -> None:
    for text in ("[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]", "[-2w, 0, 1+2w, 2, 1+2w, 0, -2w]/2"):
        mask = from_option(text, start=-3, names=["w"])
        assert mask.parameters == {"w": None}
        assert mask.scheme({"w": Q(1, 20)}) == four_point(Q(1, 20))
        assert read_text(write(mask), file="--mask") == mask
    symbol = from_option("z^-3 (1+z)^2 (z^2/2 - w (z-1)^2 (1+z^2))", names={"w": Q(1)})
    assert symbol.scheme({"w": Q(1, 20)}) == four_point(Q(1, 20))
    assert from_option("[1, 1]", names=["w"]).parameters == {}
    with pytest.raises(MaskFileError, match="no parameter w"):
        from_option("[1, 1]", names=["w"]).scheme({"w": Q(1)})
    with pytest.raises(MaskFileError, match="w = 0"):
        from_option("[1, 1/w]", names=["w"]).scheme({"w": Q(0)})
    with pytest.raises(MaskFileError, match="z is the variable"):
        from_option("1+z", names=["z"])


def test_options_out_of_bounds() -> None:
    for options, code in (({"arity": 1}, "SD010"), ({"start": 10**7}, "SD010")):
        with pytest.raises(MaskFileError) as caught:
            from_option("[1]", **options)
        assert caught.value.problems[0].code == code
    with pytest.raises(MaskFileError, match="--start and a symbol"):
        from_option("1+z", start=1)


BILINEAR = {(i, j): Q(1, 2 ** (abs(i) + abs(j))) for i in (-1, 0, 1) for j in (-1, 0, 1)}


@pytest.mark.parametrize(
    ("text", "start"),
    [
        ("[[1, 2, 1], [2, 4, 2], [1, 2, 1]]/4", (-1, -1)),
        ("[[1/4, w, 1/4], [w, 1, w], [1/4, 1/2, 1/4]]", (-1, -1)),
        ("(1+z1)^2 (1+z2)^2 / (4 z1 z2)", 0),
        ("z1^-1 z2^-1 (1+z1)^2 (1+2w z2)^2 w/2", 0),
    ],
)
def test_masks_in_several_variables_from_the_command_line(text: str, start: int | tuple[int, ...]) -> None:
    mask = from_option(text, start=start, names=["w"])
    assert mask.kind == "multivariate"
    overrides = {"w": Q(1, 2)} if "w" in text else {}
    assert mask.scheme(overrides) == MultivariateScheme(dilation=((2, 0), (0, 2)), terms=BILINEAR)
    assert read_text(write(mask), file="--mask") == mask
    assert from_option("1 + z1 z3", arity=3).scheme().dilation == ((3, 0, 0), (0, 3, 0), (0, 0, 3))


@pytest.mark.parametrize(
    ("text", "options", "code", "message", "column"),
    [
        ("[[1, 2], [3]]", {}, "SD023", "different lengths", 1),
        ("[[1, 2], 3]", {}, "SD023", "different lengths or depths", 1),
        ("[[1, 2], [3, 4]]", {"start": (1,)}, "SD023", "--start has 1 component", 1),
        ("[[1, 2], [3, 4]]", {"start": (0, 0, 0)}, "SD023", "--start has 3 components", 1),
        ("[[1, 2], [3, 4]]", {"start": (0, 2000)}, "SD010", "beyond 1000", 1),
        ("[1, 2]", {"start": (0, 0)}, "SD023", "one variable", 1),
        ("[[[[[1]]]]]", {}, "SD010", "5 deep", 1),
        ("[" * 40, {}, "SD010", "more than 32 deep", 33),
        ("[[1, 2], [3, z1]]", {}, "SD008", "z1 cannot stand", 14),
        ("[[1, 2], [3, 4]]/0", {}, "SD007", "division by zero", 18),
        ("[[0, 0]]", {}, "SD009", "all coefficients", 1),
        ("1 + z1", {}, "SD023", "one variable", 1),
        ("z1 + z", {}, "SD008", "z alone", 6),
        ("z1 + z2", {"start": (1, 1)}, "SD015", "--start and a symbol", 1),
        ("z4", {"arity": 64}, "SD010", "determinant", 1),
        ("[" + ",".join(["[" + ",".join("0" * 150) + "]"] * 70) + "]", {}, "SD010", "more than 10000", 1),
    ],
)
def test_bad_masks_in_several_variables(
    text: str, options: dict[str, Any], code: str, message: str, column: int
) -> None:
    with pytest.raises(MaskFileError) as caught:
        from_option(text, **options)
    (problem, *_) = caught.value.problems
    assert (problem.code, problem.file, problem.column) == (code, "--mask", column)
    assert message in problem.message


def test_overrides_from_the_command_line() -> None:
    assert parse_override("w=1/20") == ("w", Q(1, 20))
    assert parse_override(" ω = -0.05 ") == ("ω", Q(-1, 20))
    assert parse_override("w=(1+1)^-2") == ("w", Q(1, 4))
    cases = {"w": "gives no value", "=1": "cannot be a parameter", "w=": "no value for w", "w=1/0": "division by zero"}
    cases |= {"w=v": "not declared", "w=z": "z cannot stand", "1w=2": "cannot be a parameter", "w=1e9999": "too large"}
    for text, message in cases.items():
        with pytest.raises(MaskFileError, match=message) as caught:
            parse_override(text)
        assert caught.value.problems[0].help
