"""Masks and parameter values from the command line."""

from __future__ import annotations

from fractions import Fraction as Q

import pytest

from subdiv_cli.maskfile import MaskFileError, read_text
from subdiv_cli.maskfile.option import from_option, parse_override
from subdiv_cli.maskfile.writer import write
from subdiv_cli.schemes.scalar import ScalarScheme


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
        ("[1 2]", "SD008", "the number 2 stands directly after", 4),
        ("[1,]", "SD008", '"]" stands where', 4),
        ("[1,2]/0", "SD007", "division by zero", 7),
        ("[1,z]", "SD008", "z cannot stand", 4),
        ("[1,2] 3", "SD008", "* or / or the end", 7),
        ("[1,w]/2", "SD008", '"w" is not declared', 4),
        ("1/(1+z)", "SD008", "1 + z does not divide 1", 3),
        ("", "SD008", "empty", 1),
        ("1/8,1/2,3/4", "SD008", "stands in brackets", 4),
        ("(1,2,1)/4", "SD008", "stands in brackets", 3),
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
        ("1/8,1/2,3/4", "put the list in brackets: [1/8,1/2,3/4]"),
        ("(1,2,1)/4", "put the list in brackets: [1, 2, 1]/2"),
        ("[1,w]", "give it a value: -p w=1/16"),
    ):
        with pytest.raises(MaskFileError) as caught:
            from_option(text)
        assert caught.value.problems[0].help == mend


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
