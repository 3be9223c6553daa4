"""The files that `subdiv jsr` reads besides TOML: JSON, nested lists, NumPy's arrays, MATLAB's variables."""

from __future__ import annotations

import io
import json
import sys
import zlib
from types import ModuleType

import numpy as np
import pytest
from support import subdiv

from subdiv_cli.kinds.family_files import family_text
from subdiv_cli.maskfile.problems import MaskFileError

PAIR = [[[1, 1], [0, 1]], [["4/5", 0], ["4/5", "4/5"]]]
FLOATS = np.array([[[1, 1], [0, 1]], [[0.8, 0], [0.8, 0.8]]])
NOTE = "note: floats are taken as the decimals that they spell\n"


def radius(path, *arguments, **options):
    run = subdiv("jsr", path, "--format", "json", *arguments, **options)
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout), run.stderr


@pytest.fixture
def expected(tmp_path):
    file = tmp_path / "pair.toml"
    file.write_text(f"matrices = {json.dumps(PAIR)}\n", encoding="utf-8")
    return radius(file)[0]


def without_smp(said):
    return {key: value for key, value in said.items() if key != "smp"}


@pytest.mark.parametrize(
    "text",
    [
        json.dumps(PAIR),
        json.dumps({"matrices": PAIR, "name": "two"}),
        " \n[[[1, 1], [0, 1]],\n [[0.8, 0], [0.80, 8e-1]]]",
    ],
)
def test_json(tmp_path, expected, text):
    file = tmp_path / "pair.json"
    file.write_text(text, encoding="utf-8")
    assert radius(file) == (expected, "")


def test_a_single_matrix_as_nested_lists(tmp_path):
    file = tmp_path / "one.json"
    file.write_text("[[1, 1], [1, 0]]", encoding="utf-8")
    assert radius(file)[0]["exact"] == "root(x^2-x-1, 1.61803, 1.61804)"


@pytest.mark.parametrize("dtype", ["f8", "f4", ">f8"])
def test_an_array_of_floats_is_what_its_decimals_say(tmp_path, expected, dtype):
    np.save(tmp_path / "pair.npy", FLOATS.astype(dtype))
    assert radius(tmp_path / "pair.npy") == (expected, NOTE)


def test_integers_are_no_floats(tmp_path):
    np.save(tmp_path / "one.npy", np.array([[1, 1], [1, 0]], order="F"))
    said, warned = radius(tmp_path / "one.npy")
    assert (said["exact"], warned) == ("root(x^2-x-1, 1.61803, 1.61804)", "")


def test_transposes_have_the_reversed_words(tmp_path, expected):
    rows = [[[0, 2, 1], [1, 0, 0], [0, 1, 0]], [[1, 0, 3], [0, 0, 1], [1, 1, 0]], [[0, 0, 1], [2, 0, 0], [0, 1, 1]]]
    file, turned = tmp_path / "rows.json", tmp_path / "columns.json"
    file.write_text(json.dumps(rows), encoding="utf-8")
    turned.write_text(json.dumps([list(map(list, zip(*m, strict=True))) for m in rows]), encoding="utf-8")
    one, other = radius(file, "--transpose")[0], radius(turned)[0]
    assert one == other
    assert without_smp(one)["exact"] == radius(file)[0]["exact"]


def array_bytes(array, **options):
    stream = io.BytesIO()
    np.save(stream, array, **options)
    return stream.getvalue()


LARGE = array_bytes(np.zeros((2, 2, 2))).replace(b"(2, 2, 2)", b"(9999999,9999999)")
BAD = [
    (array_bytes(np.array([[{}, 1], [1, 2]], dtype=object), allow_pickle=True), "Object arrays cannot be loaded"),
    (array_bytes(np.array([[1, np.nan], [0, 1]])), "a number is nan"),
    (array_bytes(np.array([[1, np.inf], [0, 1]])), "a number is inf"),
    (array_bytes(np.array([[1j, 0], [0, 1]])), "the numbers are of type complex128"),
    (array_bytes(np.zeros((2, 3))), "a matrix has the shape (2, 3)"),
    (array_bytes(np.zeros(4)), "the array has the shape (4,)"),
    (array_bytes(np.zeros((0, 2, 2))), "there is no matrix"),
    (array_bytes(np.zeros((2, 0, 0))), "a matrix has the shape (0, 0)"),
    (LARGE, "the file ends before the array does"),
    (LARGE[:30], "the array cannot be read"),
    (b'{"matrix": [[1]]}', "the object has the key 'matrix'"),
    (b"[1, 2, 3]", "these are no matrices"),
    (b"[[[[1]]]]", "these are no matrices"),
]


@pytest.mark.parametrize(("data", "message"), BAD, ids=[message for _, message in BAD])
def test_bad_files_are_refused(tmp_path, data, message):
    file = tmp_path / "bad"
    file.write_bytes(data)
    run = subdiv("jsr", file)
    assert (run.returncode, run.stdout) == (2, "")
    assert message in run.stderr
    assert "= help: " in run.stderr
    assert "Traceback" not in run.stderr


@pytest.mark.parametrize(
    ("text", "place", "message"),
    [
        ("[[[1, 2],\n [3 4]]]", ":2:5", "this is not valid JSON: Expecting ',' delimiter"),
        ('{"matrices": [[[1]]]', ":1:21", "this is not valid JSON: Expecting ',' delimiter"),
        ("[[[01]]]", ":1:5", "this is not valid JSON"),
        ("[" * 30_000, "", "this is not valid JSON: it is nested too deep"),
        ('{"matrices": [[[1]]], "name": {}}', "", "the name is no text"),
        ('{"matrices": [[[1]]], "name": 5}', "", "the name is no text"),
    ],
)
def test_text_that_is_no_json_is_refused_where_it_goes_wrong(tmp_path, text, place, message):
    file = tmp_path / "bad"
    file.write_text(text, encoding="utf-8")
    run = subdiv("jsr", file)
    assert (run.returncode, run.stdout) == (2, "")
    assert message in run.stderr
    assert f"--> {file}{place}\n" in run.stderr


@pytest.mark.parametrize("shape", ["(True, True)", "(1, 1), 1: 2", "(1, ", "(1 * 10**9,)"])
def test_headers_that_numpy_does_not_expect(tmp_path, shape):
    """Whatever numpy raises, the file is refused, and with the same words every time."""
    header = f"{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}}}\n".encode()
    file = tmp_path / "bad.npy"
    file.write_bytes(b"\x93NUMPY\x01\x00" + len(header).to_bytes(2, "little") + header + bytes(8))
    run = subdiv("jsr", file)
    assert (run.returncode, run.stdout) == (2, "")
    assert "error[SD006] the array cannot be read: " in run.stderr
    assert "0x" not in run.stderr


def test_rows_of_two_lengths_are_named_by_their_place(tmp_path):
    file = tmp_path / "bad.json"
    file.write_text("[[[1, 2], [3]]]", encoding="utf-8")
    run = subdiv("jsr", file)
    assert run.returncode == 2
    assert "matrices[0]" in run.stderr


def as_scipy(monkeypatch, variables):
    """A module that reads .mat files as scipy.io does, where that need not be there."""

    class MatReadError(Exception):
        pass

    def loadmat(stream, **_):
        if not (data := stream.read()).startswith(b"MATLAB"):
            raise MatReadError("Unknown mat file type")
        zlib.decompress(data.removeprefix(b"MATLAB 5.0") or zlib.compress(b""))
        return {"__version__": "1.0", **variables}

    package, io_module, matlab = ModuleType("scipy"), ModuleType("scipy.io"), ModuleType("scipy.io.matlab")
    io_module.loadmat, matlab.MatReadError = loadmat, MatReadError
    for module in (package, io_module, matlab):
        monkeypatch.setitem(sys.modules, module.__name__, module)


def cells(*matrices):
    array = np.empty((1, len(matrices)), dtype=object)
    for k, m in enumerate(matrices):
        array[0, k] = m
    return array


class Sparse:
    """A matrix as scipy.sparse has them: no array, but it makes one."""

    def __init__(self, full):
        self.full, self.ndim, self.shape, self.dtype = full, full.ndim, full.shape, full.dtype

    def toarray(self):
        return self.full


@pytest.mark.parametrize(
    "variables",
    [
        {"M10": FLOATS[1], "M2": FLOATS[0]},
        {"M": np.moveaxis(FLOATS, 0, 2)},
        {"M": cells(*FLOATS)},
        {"A": Sparse(FLOATS[0]), "B": Sparse(FLOATS[1])},
    ],
    ids=["variables", "pages", "cells", "sparse"],
)
def test_variables_of_a_mat_file(monkeypatch, tmp_path, variables):
    as_scipy(monkeypatch, variables)
    file = tmp_path / "pair.mat"
    file.write_bytes(b"MATLAB 5.0")
    np.save(tmp_path / "pair.npy", FLOATS)
    assert family_text(str(file)) == family_text(str(tmp_path / "pair.npy"))


@pytest.mark.parametrize(("data", "message"), [(b"text", "Unknown mat file type"), (b"MATLAB 5.0?", "decompressing")])
def test_a_mat_file_that_is_none(monkeypatch, tmp_path, data, message):
    as_scipy(monkeypatch, {})
    file = tmp_path / "pair.mat"
    file.write_bytes(data)
    with pytest.raises(MaskFileError) as raised:
        family_text(str(file))
    assert message in raised.value.problems[0].message


def test_without_scipy_the_extra_is_named(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "scipy.io", None)
    file = tmp_path / "pair.mat"
    file.write_bytes(b"MATLAB 5.0")
    with pytest.raises(MaskFileError) as raised:
        family_text(str(file))
    assert raised.value.problems[0].help == 'pip install "subdiv[mat]"'


@pytest.mark.parametrize(
    ("matrices", "line"),
    [
        ('[[["12345678901234567890123/3"]]]', "✓ joint spectral radius = a long fraction = 4.115226300411522"),
        ('[[["5/3"]]]', "✓ joint spectral radius = 5/3 = 1.66666"),
        ("[[[2]]]", "✓ joint spectral radius = 2\n"),
        ("[[[1e400]]]", "✓ joint spectral radius = a long fraction = 1.000000000000000e400\n"),
    ],
)
def test_long_numbers_are_shown_by_their_decimals(tmp_path, matrices, line):
    file = tmp_path / "one.json"
    file.write_text(matrices, encoding="utf-8")
    assert subdiv("jsr", file).stdout.startswith(line)
