"""Control polygons from CSV."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from subdiv_cli.maskfile import MaskFileError
from subdiv_cli.maskfile.points import points, read_points


@pytest.mark.parametrize(
    "text",
    [
        "0,0\n1,1/2\n",
        "x,y\n0,0\n1,0.5\n",
        "# a comment\n\nx , y\n 0 , 0 \n1,5e-1",
        '"0","0"\n"1",".5"\n',
        "x;y\n0;0\n1;0.5\n",
        "0,0\r\n1,0.5\r\n",
    ],
)
def test_points_are_exact(text):
    assert points(text, "a.csv") == ((0, 1), (0, Fraction(1, 2)))


@pytest.mark.parametrize(
    ("text", "message", "line"),
    [
        ("", "fewer than two points", None),
        ("0,0\n", "fewer than two points", None),
        ("x,y\n", "fewer than two points", None),
        ("0,0\n1,one\n", '"one" is not a point', 2),
        ("0,0\n1\n", "1 cells", 2),
        ("0,0\n1,2,3\n", "3 cells", 2),
        ("0,0\n1,1/0\n", '"1/0" is not a point', 2),
        ("0,0\n1,nan\n", '"nan" is not a point', 2),
        ("0,0\n1,1e999\n", '"1e999" is not a point', 2),
        ('0,0\n"1,1\n', "not CSV", None),
        ("0,0\n" * 2001, "more than 2000 points", 2001),
    ],
)
def test_what_is_no_polygon(text, message, line):
    with pytest.raises(MaskFileError) as caught:
        points(text, "a.csv")
    (problem,) = caught.value.problems
    assert (problem.code, problem.line, problem.file) == ("SD021", line, "a.csv")
    assert message in problem.message
    assert problem.help


def test_files(tmp_path):
    good, bytes_ = tmp_path / "good.csv", tmp_path / "bytes.csv"
    good.write_text("\ufeffx,y\n1,2\n3,4\n", encoding="utf-8")
    bytes_.write_bytes(b"\xff\xfe1\x00")
    assert read_points(str(good)) == ((1, 3), (2, 4))
    for file, code in ((bytes_, "SD021"), (tmp_path / "none.csv", "SD002"), (tmp_path, "SD002")):
        with pytest.raises(MaskFileError) as caught:
            read_points(str(file))
        assert caught.value.problems[0].code == code


@given(st.text('0123456789,;.-/e\n" x', max_size=40))
def test_any_text_is_read_or_refused(text):
    found, problems = None, ()
    try:
        found = points(text, "a.csv")
    except MaskFileError as error:
        problems = error.problems
    assert len(found[0]) == len(found[1]) >= 2 if found else problems[0].help
