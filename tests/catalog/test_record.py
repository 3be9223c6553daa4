"""Results recorded and read again are equal, whatever is in them; anything else is refused."""

import dataclasses
import json
import sys
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support import shipped_results

sys.path.insert(0, str(Path(__file__).parents[1] / "report"))
import report_samples as samples

from subdiv_cli.catalog.record import UnreadableRecordError, decode, encode
from subdiv_cli.model import Exponent, Finding, Log, Result, Verdict


def again(value):
    return decode(json.loads(json.dumps(encode(value))))


def same(a, b):
    """Equal, and of the same types all the way down: True is not 1, a tuple not a list."""
    assert a == b
    assert types(a) == types(b)


def types(value):
    """The types of everything in a value."""
    if isinstance(value, dict):
        return {key: types(item) for key, item in value.items()}
    if dataclasses.is_dataclass(value):
        return type(value), types({f.name: getattr(value, f.name) for f in dataclasses.fields(value)})
    return (type(value), *map(types, value)) if isinstance(value, tuple) else type(value)


@pytest.mark.parametrize("result", samples.ALL, ids=lambda r: r.status)
def test_samples(result):
    same(again(result), result)


def test_the_catalog():
    for result in shipped_results():
        same(again(result), result)


data = st.recursive(
    st.none() | st.booleans() | st.integers() | st.fractions() | st.text(),
    lambda inner: st.lists(inner, max_size=4).map(tuple) | st.dictionaries(st.text(), inner, max_size=4),
    max_leaves=20,
)


@given(data, st.floats(allow_nan=False), st.fractions(min_value=Fraction(1, 100)))
def test_any_data(witness, bound, argument):
    found = Finding(code="SD1", name="n", verdict=Verdict.PROVED, statement="s", source="p", witness={"w": witness})
    holder = Exponent(lower=bound, upper=None, exact=Log(3, argument, 2), attained=True)
    result = Result(file="f", status="failed", findings=(found,), facts={"x": witness}, holder=holder)
    same(again(result), result)


def test_numbers_of_any_length():
    huge = 7**20_000
    same(again((huge, -huge, Fraction(huge, 3))), (huge, -huge, Fraction(huge, 3)))


@pytest.mark.parametrize(
    "data",
    [
        {"is": "Path", "fields": {}},
        {"is": "Fraction", "fields": {"numerator": 1}},
        {"is": "Effort", "fields": {"nonsense": 1}},
        {"is": "Verdict", "value": "maybe"},
        {"is": "Result", "fields": {"file": "x", "status": "passed", "colour": "red"}},
        {"is": "os", "fields": {}},
        {"is": 3, "fields": {}},
        {"fraction": "1/0"},
        {"fraction": "one/2"},
        {"int": "zz"},
        {"map": [1]},
        {"unknown": 1},
    ],
)
def test_what_is_no_record(data):
    with pytest.raises(UnreadableRecordError):
        decode(data)


def test_what_cannot_be_recorded():
    with pytest.raises(TypeError):
        encode(object())
