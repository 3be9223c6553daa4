"""Values that lie in a temporary file and are read again, and JSON that is read value by value, as json reads it."""

import io
import json
import os
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from subdiv_cli.catalog import json_reader, spool
from subdiv_cli.catalog.json_reader import JsonReader
from subdiv_cli.catalog.spool import Mapped, Spool

VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(), inner, max_size=4),
    max_leaves=12,
)


def filled(count):
    made = Spool()
    for number in range(count):
        made.append({"number": number, "text": "ö" * number})
    return made


def test_a_spool_is_the_list_of_what_was_added(monkeypatch):
    monkeypatch.setattr(spool, "KEPT", 3)
    made, listed = filled(10), [{"number": n, "text": "ö" * n} for n in range(10)]
    assert list(made) == listed
    assert (made[7], made[-1], made[2:5], len(made)) == (listed[7], listed[-1], listed[2:5], 10)
    with pytest.raises(IndexError):
        made[10]
    made.append("last")
    assert [*made] == [*listed, "last"], "reading and adding in turns"
    assert list(Mapped(lambda value: value["number"], made[:10])) == list(range(10))
    assert not Spool()


def test_only_the_first_values_stay_in_memory():
    made = filled(spool.KEPT + 1)
    assert made[0] is made[0]
    assert made[spool.KEPT] is not made[spool.KEPT]


def test_the_file_has_no_name(tmp_path, monkeypatch):
    monkeypatch.setattr(spool, "KEPT", 0)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    made = filled(3)
    assert list(tmp_path.iterdir()) == []
    assert made[2]["number"] == 2


@pytest.mark.parametrize("when", ["no file", "half of it"])
def test_where_the_disk_is_full_values_stay_in_memory(monkeypatch, when):
    class Full(io.BytesIO):
        def write(self, data):
            return super().write(data[: len(data) // 2])

    def made_file(**_):
        if when == "no file":
            raise OSError("full")
        return Full()

    monkeypatch.setattr(spool, "KEPT", 1)
    monkeypatch.setattr("tempfile.TemporaryFile", made_file)
    assert [value["number"] for value in filled(4)] == [0, 1, 2, 3]


def reader(text, encoding="utf-8"):
    return JsonReader(io.BufferedReader(io.BytesIO(text.encode(encoding, "surrogatepass"))))


@pytest.fixture
def small_blocks(monkeypatch):
    monkeypatch.setattr(json_reader, "BLOCK", 1)


@given(VALUES, st.sampled_from(["utf-8", "utf-8-sig", "utf-16", "utf-32"]), st.sampled_from([None, 1]), st.booleans())
def test_a_value_is_read_as_json_reads_it(value, encoding, indent, ascii_only):
    block, json_reader.BLOCK = json_reader.BLOCK, 1
    try:
        text = f" {json.dumps(value, indent=indent, ensure_ascii=ascii_only)}\n"
        found = reader(text, encoding)
        assert found.value() == json.loads(text)
        found.end()
    finally:
        json_reader.BLOCK = block


def read_members(found):
    read = {key: list(found.elements()) if found.next() == "[" else found.value() for key in found.members()}
    found.end()
    return read


@pytest.mark.usefixtures("small_blocks")
def test_objects_and_arrays_part_by_part():
    found = reader(' { "a" : 12 , "b":[ 1 , "x]" ,{}], "c": [], "d": {} } ')
    assert read_members(found) == {"a": 12, "b": [1, "x]", {}], "c": [], "d": {}}


@pytest.mark.usefixtures("small_blocks")
@pytest.mark.parametrize(
    "text", ["", "{", '{"a"', '{"a":', '{"a":1', '{"a":1,}', '{"a" 1}', "{1:2}", "{a:1}", '{"a":1}x']
)
def test_what_is_no_object(text):
    with pytest.raises(ValueError):  # noqa: PT011 (json's own errors among them)
        json.loads(text)
    with pytest.raises(ValueError):  # noqa: PT011
        read_members(reader(text))


@pytest.mark.usefixtures("small_blocks")
@pytest.mark.parametrize("text", ["[", "[1", "[1,", "[1,]", "[1 2]", "[tru]"])
def test_what_is_no_array(text):
    with pytest.raises(ValueError):  # noqa: PT011
        list(reader(text).elements())


def test_a_report_that_comes_through_a_pipe(tmp_path):
    sys.path.insert(0, str(Path(__file__).parents[1] / "report"))
    import report_samples as samples

    from subdiv_cli.catalog.reports import read_report
    from subdiv_cli.report import renderer
    from subdiv_cli.report.look import Look

    text = renderer("json")(samples.ALL, Look(shard=(1, 2)))
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    if os.fork() == 0:
        pipe.write_text(text, encoding="utf-8")
        os._exit(0)
    report = read_report(str(pipe))
    os.wait()
    assert list(report.results) == json.loads(text)["results"]
    assert report.shard == (1, 2)
