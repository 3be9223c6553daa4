"""The pieces of a mask file that every kind shares: tables with known keys, texts, numbers, expressions, parameters."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_BITS, MAX_DIGITS
from subdiv_cli.maskfile.characters import mended
from subdiv_cli.maskfile.expressions import Expression, evaluate, is_fixed
from subdiv_cli.maskfile.grammar import parse
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.nodes import Number
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath, Reason, near, shown
from subdiv_cli.maskfile.tokens import is_name
from subdiv_cli.maskfile.values import Decimal, described

_VARIABLE = re.compile(r"z[0-9]*")
_INTEGER = re.compile(r"[+-]?(0|[1-9][0-9]{0,9})")
_WHOLE = re.compile(r"([+-]?[0-9]{1,10})\.0+")


class Table:
    """A TOML table with its place in the file; what is wrong with it goes to `problems`."""

    def __init__(self, data: Mapping[str, object], path: KeyPath, problems: Collector) -> None:
        self.data = data
        self.path = path
        self.problems = problems
        self._meant: set[str] = set()

    def only(self, known: Iterable[str], elsewhere: Mapping[str, tuple[str, str]] | None = None) -> None:
        """Record every key that is not known (SD004), with the known key it resembles.

        `elsewhere`: the message and help for keys that belong elsewhere, and the known key that is then not missing.
        """
        known = tuple(known)
        for key in self.data:
            if key in known:
                continue
            where = f"in [{'.'.join(map(str, self.path))}]" if self.path else "at the top"
            if elsewhere and key in elsewhere:
                help, meant = elsewhere[key]
                self._meant.add(meant)
            elif not self.problems.full and (guess := near(key, known)):
                help = f"did you mean {guess}?"
                self._meant.add(guess)
            else:
                help = "known keys: " + ", ".join(known)
            self.problems.add(
                Fault(faults.UNKNOWN_KEY, f'unknown key "{shown(key)}" {where}', help), (*self.path, key), of_key=True
            )

    def missing(self, key: str, message: str, help: str, *, instead: Collection[str] = ()) -> None:
        """Record a missing key (SD005), unless a misspelt or misplaced one is meant, which `only` has recorded.

        `instead`: keys that would do as well.
        """
        if self._meant.isdisjoint((key, *instead)):
            self.problems.add(Fault(faults.MISSING_KEY, message, help), (*self.path, key), of_key=True)

    def table(self, key: str, help: str | None = None) -> Table | None:
        """The table at `key`; None where it is missing or (recorded, SD006) something else."""
        value = self.data.get(key)
        if isinstance(value, dict):
            return Table(value, (*self.path, key), self.problems)
        if key in self.data:
            fault = Fault(
                faults.WRONG_TYPE,
                f"{key} must be a table, not {described(value)}",
                help or f"write [{key}] on its own line",
            )
            self.problems.add(fault, (*self.path, key))
        return None

    def integer(self, key: str, default: int | None, lowest: int, highest: int, help: str) -> int | None:
        """The integer at `key`; None where it is missing without default (SD005), no integer (SD006), out of bounds."""
        if key not in self.data and default is None:
            self.missing(key, f"{key} is missing", help)
            return None
        value = self.data.get(key, default)
        if isinstance(value, bool) or not isinstance(value, int):
            given = f'the string "{shown(value)}"' if isinstance(value, str) else described(value)
            if isinstance(value, str) and _INTEGER.fullmatch(plain := mended(value.strip())):
                help = f"write it without quotes: {key} = {plain}"
            elif isinstance(value, Decimal) and (whole := _WHOLE.fullmatch(value.text)):
                help = f"write it without a point: {key} = {whole[1]}"
            self.problems.add(
                Fault(faults.WRONG_TYPE, f"{key} must be an integer, not {given}", help), (*self.path, key)
            )
            return None
        if not lowest <= value <= highest:
            given = str(value) if value.bit_length() < 64 else "a long number"
            fault = Fault(faults.OUT_OF_BOUNDS, f"{key} must be between {lowest} and {highest}, not {given}", help)
            self.problems.add(fault, (*self.path, key))
            return None
        return value


def mask_table(top: Table) -> Table | None:
    """The table [mask] of a file; None where it is missing or something else, which is recorded."""
    if "mask" not in top.data:
        top.missing("mask", "the table [mask] is missing", "add [mask] with start and coefficients, or symbol")
        return None
    return top.table("mask", 'write [mask] and below it start = 0 and coefficients = ["1/2", 1, "1/2"]')


def text_at(table: Table, key: str) -> str | None:
    """The string at `key`, None where there is none; another type is recorded (SD006)."""
    value = table.data.get(key)
    if value is not None and not isinstance(value, str):
        fault = Fault(
            faults.WRONG_TYPE, f"{key} must be a string, not {described(value)}", f'put it in quotes: {key} = "…"'
        )
        table.problems.add(fault, (*table.path, key))
        return None
    return value


def read_expression(value: object, path: KeyPath, names: Collection[str]) -> Expression:
    """The exact number or expression over `names` that TOML gives. Raises Fault: SD006, SD007, SD008 or SD010."""
    if isinstance(value, int) and not isinstance(value, bool):
        if value.bit_length() > MAX_BITS:
            raise Fault(faults.OUT_OF_BOUNDS, f"the number has more than {MAX_DIGITS} digits", "use a shorter number")
        text = str(value)
    elif isinstance(value, Decimal):
        text = value.text
        if text.lstrip("+-") in ("nan", "inf"):
            raise Fault(faults.BAD_NUMBER, f"{text} is not a rational number", "write a finite number")
    elif isinstance(value, str):
        text = value
    else:
        help = 'write an integer, a decimal or a string such as "-1/16"'
        if isinstance(value, list):
            help = 'a scalar mask is one flat list: [1, 2, 1]; lists of lists are for kind = "multivariate"'
        raise Fault(faults.WRONG_TYPE, f"a number was expected, not {described(value)}", help)
    return Expression(text=text, node=parse(text, names), path=path)


def check_fixed(expression: Expression, work: Work) -> None:
    """Evaluate an expression that has no parameters. Raises Fault where it has no value."""
    if not isinstance(expression.node, Number) and is_fixed(expression.node):
        evaluate(expression.node, {}, work)


def read_number(
    value: object, path: KeyPath, parameters: Collection[str], problems: Collector, work: Work
) -> Expression | None:
    """A coefficient; None where it is wrong, which is recorded."""
    try:
        entry = read_expression(value, path, parameters)
        check_fixed(entry, work)
    except Fault as fault:
        problems.add(fault, path)
        return None
    return entry


def read_symbol(table: Table, names: Collection[str], help: str) -> Expression | None:
    """The expression at `symbol`; None where it is wrong, which is recorded."""
    path, value = (*table.path, "symbol"), table.data["symbol"]
    if isinstance(value, str):
        return read_number(value, path, names, table.problems, Work())
    table.problems.add(Fault(faults.WRONG_TYPE, f"symbol must be a string, not {described(value)}", help), path)
    return None


def read_parameters(table: Table | None, problems: Collector) -> dict[str, Expression | None]:
    """The defaults by name, in order of declaration: a number, an expression in earlier parameters, or None for ""."""
    defaults: dict[str, Expression | None] = {}
    for name, value in table.data.items() if table else ():
        path = ("parameters", name)
        if fault := fault_of_name(name):
            problems.add(fault, path, of_key=True)
            continue
        expression = None
        try:
            expression = read_expression(value, path, defaults) if value != "" else None
        except Fault as wrong:
            problems.add(_out_of_order(wrong, name, table.data if table else ()) or wrong, path)
        defaults[name] = expression
    return defaults


def fault_of_name(name: str) -> Fault | None:
    """The fault of what cannot be a parameter's name; None for one that can."""
    if _VARIABLE.fullmatch(name):
        return Fault(faults.BAD_PARAMETER, f"{name} is the variable of symbols and cannot be a parameter", "call it w")
    if not is_name(name):
        message = f'"{shown(name)}" cannot be a parameter\'s name'
        return Fault(faults.BAD_PARAMETER, message, "use letters, digits and _: w, w_1")
    return None


def _out_of_order(fault: Fault, name: str, declared: Collection[str]) -> Fault | None:
    """The fault of a default that uses its own parameter or one declared below; None where `fault` is another."""
    used = fault.about
    if used is None or fault.reason not in (Reason.UNDECLARED, Reason.MISTAKEN):
        return None
    if used == name:
        return Fault(fault.rule, f"the default of {shown(name)} uses itself", "write a number", fault.at)
    if used not in declared:
        return None
    message = f"{shown(used)} is declared after {shown(name)}, whose default uses it"
    return Fault(fault.rule, message, f"move {shown(used)} above {shown(name)}", fault.at)
