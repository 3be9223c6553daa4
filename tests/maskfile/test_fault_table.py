"""The table of what can be wrong with an input: its rows are the explain pages, and no code stands elsewhere."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import subdiv_cli
from subdiv_cli.explain import codes, title
from subdiv_cli.kinds.reading import read_text
from subdiv_cli.maskfile import MaskFileError
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.problems import Fault, Reason, internal_error
from subdiv_cli.maskfile.rules import ROWS, FaultRule
from subdiv_cli.model import Problem

PACKAGE = Path(subdiv_cli.__file__).parent
FILES = sorted(PACKAGE.rglob("*.py"))
CODE = re.compile(r"SD0[0-9]{2}")


def literals(text: str) -> Iterator[tuple[str, int]]:
    """The string literals of a module with their lines; docstrings, those of attributes too, are none."""
    tree = ast.parse(text)
    said = {node.value for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node not in said:
            yield node.value, node.lineno


def message_uses(text: str) -> Iterator[int]:
    """The lines where something looks into the message of an error: a method of it, a piece, a comparison."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Attribute | ast.Subscript):
            looked_at = [node.value]
        elif isinstance(node, ast.Compare):
            looked_at = [node.left, *node.comparators]
        else:
            continue
        yield from (n.lineno for n in looked_at if isinstance(n, ast.Attribute) and n.attr == "message")


def test_rows_are_the_pages_of_explain() -> None:
    assert {code: row.name for code, row in ROWS.items()} == {
        code: title(code) for code in codes() if CODE.fullmatch(code)
    }


def test_every_row_has_one_name_that_is_its_own() -> None:
    named = {name: row for name, row in vars(faults).items() if isinstance(row, FaultRule)}
    assert named == {row.name.upper().replace("-", "_"): row for row in ROWS.values()}
    assert all(code == row.code for code, row in ROWS.items())
    assert list(ROWS) == sorted(ROWS)


def test_codes_stand_in_tables_only() -> None:
    outside = {file: literals(file.read_text(encoding="utf-8")) for file in FILES if file.name != "rules.py"}
    assert not [(str(file), line, value) for file in outside for value, line in outside[file] if CODE.search(value)]


def test_literals_are_told_from_docstrings() -> None:
    text = '"""SD001"""\nx = 1\n"""SD002"""\ndef f():\n    """SD003"""\n    return f"error[SD004]", {"SD005": 1}\n'
    assert [value for value, _ in literals(text)] == ["error[SD004]", "SD005"]


def test_nothing_looks_into_a_message() -> None:
    uses = {file: message_uses(file.read_text(encoding="utf-8")) for file in FILES}
    assert not [(str(file), line) for file in FILES for line in uses[file]]


def test_looking_into_a_message_is_seen() -> None:
    bad = ['e.message.endswith("x")', "e.message[0]", '"x" in e.message', 'e.message == "x"']
    good = ["show(e.message)", 'f"{e.message}!"', "e.message + x", "(e.message, e.about)"]
    assert [len(list(message_uses(text))) for text in bad + good] == [1] * len(bad) + [0] * len(good)


def test_a_fault_has_the_code_and_the_help_of_its_row() -> None:
    fault = Fault(faults.DUPLICATE_KEY, "a key is given twice")
    assert (fault.code, fault.help, fault.reason, fault.about) == ("SD015", "keep one of the two", None, None)
    assert fault.problem(file="mask.toml", line=3) == Problem(
        code="SD015", message="a key is given twice", help="keep one of the two", file="mask.toml", line=3
    )
    assert Fault(faults.DUPLICATE_KEY, "a key is given twice", "leave it out").help == "leave it out"
    assert Fault(faults.UNKNOWN_KEY, "no such key").help is None


def test_an_internal_error_is_no_fault_of_the_mask() -> None:
    problem = internal_error(ValueError("no root"), file="mask.toml")
    assert (problem.code, problem.message, problem.file) == (
        "SD099",
        "internal error: ValueError: no root",
        "mask.toml",
    )
    assert problem.help == faults.INTERNAL_ERROR.help
    for part in ("the mask file", "`subdiv --version`", "`--debug` prints"):
        assert part in (problem.help or "")


LONG = "w" * 80


@pytest.mark.parametrize(
    ("parameters", "message", "help"),
    [
        ('w = "2 w"', "the default of w uses itself", "write a number"),
        ('w = "v"\nv = 1', "v is declared after w, whose default uses it", "move v above w"),
        ('w_1 = 1\nw_3 = "w_2"\nw_2 = 1', "w_2 is declared after w_3, whose default uses it", "move w_2 above w_3"),
        (f'{LONG} = "2 {LONG}"', f"the default of {LONG[:59]}… uses itself", "write a number"),
        ('w = "v"', 'the name "v" is not declared', "declare it in [parameters] of a mask file: v = "),
    ],
)
def test_defaults_out_of_order(parameters: str, message: str, help: str) -> None:
    """What a default uses is known by its name, whether or not another name resembles it, and however long it is."""
    with pytest.raises(MaskFileError) as caught:
        read_text(f"[parameters]\n{parameters}\n[mask]\nstart = 0\ncoefficients = [1, 1]\n", file="mask.toml")
    (problem,) = caught.value.problems
    assert problem.message == message
    assert (problem.help or "").startswith(help)


def test_every_reason_is_used() -> None:
    source = "\n".join(file.read_text(encoding="utf-8") for file in FILES)
    for reason in Reason:
        assert len(re.findall(rf"\bReason\.{reason.name}\b", source)) >= 2, "given in one place, asked for in another"
