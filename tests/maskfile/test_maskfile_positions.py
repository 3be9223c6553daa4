"""The scanner against tomllib: the same key paths, and at each position the value that tomllib finds there."""

from __future__ import annotations

import tomllib

from hypothesis import given, settings
from hypothesis import strategies as st

from subdiv_cli.maskfile.positions import inner_offset, line_and_column, scan

keys = st.sampled_from(["a", "b-c", "d_1", "12", '"quoted key"', "'literal.key'", '"\\u00e9\\t"', '""'])
plain = st.text(st.characters(codec="utf-8", exclude_characters="\\\"'", exclude_categories=("Cc", "Cs")), max_size=8)
strings = st.one_of(
    plain.map(lambda s: f'"{s}"'),
    plain.map(lambda s: f"'{s}'"),
    plain.map(lambda s: f'"\\"{s}\\n\\u0041\\\\"'),
    plain.map(lambda s: f'"""\n{s}\n"quoted" \\\n   # no comment\n"""'),
    plain.map(lambda s: f"'''{s}\n[no.table]\nit''s'''"),
)
scalars = st.one_of(
    st.sampled_from(
        ["true", "false", "0", "+7", "-1_000", "0xff", "0o17", "0b10", "1.5e-3", "-0.0", "6e2", "inf", "-inf"]
    ),
    st.sampled_from(["1979-05-27", "1979-05-27 07:32:00", "1979-05-27T07:32:00.5-07:00", "07:32:00"]),
    strings,
)
gaps = st.sampled_from(["", " ", "\n", " # a comment ] }\n  ", "\r\n"])


def arrays(children: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.tuples(st.lists(children, max_size=3), gaps, gaps, st.booleans()).map(
        lambda t: "[" + t[1] + (t[2] + "," + t[1]).join(t[0]) + ("," if t[0] and t[3] else "") + t[2] + "]"
    )


def inline_tables(children: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.dictionaries(keys, children, max_size=3).map(
        lambda d: "{" + ", ".join(f"{k} = {v}" for k, v in d.items()) + "}"
    )


values = st.recursive(scalars, lambda c: arrays(c) | inline_tables(c), max_leaves=6)
dotted = st.lists(keys, min_size=1, max_size=3).map(" . ".join)
lines = st.one_of(
    st.tuples(dotted, values).map(lambda t: f"{t[0]} ={t[1]}"),
    dotted.map(lambda k: f"[ {k} ]"),
    dotted.map(lambda k: f"[[{k}]] # many"),
    st.sampled_from(["", "# comment [x", "   "]),
)
documents = st.lists(lines, max_size=7).map("\n".join)


def paths_of(value: object, path: tuple[str | int, ...] = ()) -> dict[tuple[str | int, ...], object]:
    out = {path: value} if path else {}
    if isinstance(value, dict):
        for key, child in value.items():
            out |= paths_of(child, (*path, key))
    elif isinstance(value, list):
        for i, child in enumerate(value):
            out |= paths_of(child, (*path, i))
    return out


def test_every_path_and_value_is_where_tomllib_has_it() -> None:
    seen = {True: 0, False: 0}

    @settings(max_examples=300, deadline=None)
    @given(documents)
    def compare(text: str) -> None:
        result = scan(text)
        try:
            document = tomllib.loads(text)
        except tomllib.TOMLDecodeError:
            seen[False] += 1
            return
        seen[True] += 1
        assert result.stuck is None
        assert result.duplicates == []
        expected = paths_of(document)
        assert set(result.spots) == set(expected)
        for path, spot in result.spots.items():
            if spot.end > spot.start:
                read = tomllib.loads("x = " + text[spot.start : spot.end])["x"]
                assert repr(read) == repr(expected[path])
            if isinstance(path[-1], str) and text[spot.key] not in "\"'":
                assert text.startswith(path[-1], spot.key)

    compare()
    assert seen[True] >= seen[False]


@settings(max_examples=250, deadline=None)
@given(st.text(st.sampled_from("ab=.[]{},\"'\\#\n\r 01-/+eT:zé"), max_size=60))
def test_any_text_is_scanned_to_an_end(text: str) -> None:
    result = scan(text)
    for spot in result.spots.values():
        assert 0 <= spot.key <= len(text)
        assert spot.start <= spot.end <= len(text)
    if result.stuck is not None:
        assert 0 <= result.stuck.at <= len(text)
        line, column, source = line_and_column(text, result.stuck.at)
        assert line >= 1
        assert 1 <= column <= len(source) + 2


@settings(max_examples=300, deadline=None)
@given(strings)
def test_offsets_inside_strings_count_decoded_characters(raw: str) -> None:
    decoded = tomllib.loads("x = " + raw)["x"]
    quote = raw[:3] if raw[:3] in ('"""', "'''") else raw[0]
    for n, character in enumerate(decoded):
        at = inner_offset(raw, n)
        assert raw[at] == "\\" or raw[at] == character
    if decoded:
        assert inner_offset(raw, len(decoded)) == len(raw) - len(quote)


def test_a_scan_is_linear() -> None:
    for text in ("[" * 200_000, "a." * 100_000, '"' * 200_001, "\\" * 200_000, "a = [" + "1," * 100_000, "#" * 200_000):
        scan(text)
