"""The one grammar of properties: `[expect]` in files, `holder>=1.5` and `C1` on the command line.

Examples:

    convergent = true      smoothness = 1 (exactly), "C1", ">= 1", ">= C1"
    holder = "2", ">= log2(3)", "1.99 .. 2.01", "-log2(root(x^2-x-1, 1.61, 1.62))"
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from fractions import Fraction

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_ORDER
from subdiv_cli.maskfile.closed import certainly_less, read_closed_form
from subdiv_cli.maskfile.problems import Fault, near, shown
from subdiv_cli.maskfile.values import Decimal, described
from subdiv_cli.model import ClosedForm, Expectation
from subdiv_cli.model.closed import INFINITY, spelled
from subdiv_cli.model.findings import HOLDER_AT_ZERO, HOLDER_LOWER, SMOOTHNESS
from subdiv_cli.model.properties import BY_KEY, EXPECTED

KEYS = EXPECTED
TRUTHS = tuple(key for key in KEYS if BY_KEY[key].form == "verdict")
ORDER = re.compile(r"\s*H?[Cc]\s*\^?\s*(?:([0-9]+)|\(([0-9]+)\))\s*")
"""An order of smoothness as `C1`, `C^1` or `C^(1)`; `HC1` of Hermite schemes."""
_AT_LEAST = re.compile(r"(?:≥|=>|>)\s*([^\s<>=≤≥].*)", re.DOTALL)
ORDERS = tuple(key for key in KEYS if BY_KEY[key].form in ("smoothness", "order", "degree", "dimension"))


def expectation(key: str, value: object) -> Expectation:
    """The expectation `key = value` of a file, value as TOML gives it (`Decimal` for a float).

    Raises Fault: SD004 for an unknown key, SD006 for a type, SD010 for a size, SD012 for the rest; its offset counts
    in the string that value is.
    """
    if key not in KEYS:
        guess = near(key, KEYS)
        help = f"did you mean {guess}?" if guess else "properties: " + ", ".join(KEYS)
        raise Fault(faults.UNKNOWN_KEY, f'there is no property "{shown(key)}"', help)
    if key in TRUTHS:
        if isinstance(value, bool):
            return Expectation(key=key, text=str(value).lower(), lower=value, upper=value)
        given = f'"{shown(value)}"' if isinstance(value, str) else described(value)
        raise Fault(
            faults.WRONG_TYPE, f"{key} must be true or false, not {given}", f"write {key} = true, without quotes"
        )
    if isinstance(value, bool) or not isinstance(value, int | str | Decimal):
        what = "an integer or a string" if key in ORDERS else "a number or a string"
        help = f'write {key} = 1 or {key} = ">= 1"' if key in ORDERS else f'write {key} = "2" or {key} = ">= 1.99"'
        raise Fault(faults.WRONG_TYPE, f"{key} must be {what}, not {described(value)}", help)
    if isinstance(value, int):
        if value.bit_length() > 64:
            raise Fault(faults.OUT_OF_BOUNDS, f"the expected {key} is far too large", f"the limit is {MAX_ORDER}")
        value = str(value)
    elif isinstance(value, Decimal):
        value = value.text
    return comparison(key, value)


def comparison(key: str, text: str, at: int = 0) -> Expectation:
    """The expectation that `1`, `= 1`, `>= 1.99` or `1.99 .. 2.01` states for a property that has a number.

    Raises Fault.
    """
    if not text.strip():
        raise Fault(faults.BAD_EXPECTATION, f"the expected {key} is empty", _form(key), at)
    body = text.lstrip()
    at += len(text) - len(body)
    body = body.rstrip()
    if body.startswith(("≥", "=>", "≤", "<", ">")) and not body.startswith(">="):
        least = _AT_LEAST.match(body)
        help = f'write {key} = ">= {shown(least[1], 30)}" for at least' if least else _form(key)
        raise Fault(faults.BAD_EXPECTATION, f'"{shown(body[:2].strip())}" is no comparison here', help, at)
    equals = len(body) - len(body.lstrip("="))
    if equals > 2:
        raise Fault(faults.BAD_EXPECTATION, f'"{shown(body[:equals])}" is no comparison here', _form(key), at)
    at += len(body) - len(body[equals:].lstrip())
    body = body[equals:].strip()
    if body.startswith(">="):
        lower = _number(key, body[2:], at + 2)
        return Expectation(key=key, text=f">= {body[2:].strip()}", lower=lower)
    if ".." in body:
        first, second = body.split("..", 1)
        lower, upper = _number(key, first, at), _number(key, second, at + len(first) + 2)
        if _is_less(upper, lower):
            help = "write the smaller end first: 1.99 .. 2.01"
            raise Fault(faults.BAD_EXPECTATION, f"the interval {shown(body)} is empty", help, at)
        return Expectation(key=key, text=f"{first.strip()} .. {second.strip()}", lower=lower, upper=upper)
    value = _number(key, body, at)
    return Expectation(key=key, text=body, lower=value, upper=value)


def _form(key: str) -> str:
    """The help that shows how an expectation of this property is written."""
    if key in ORDERS:
        return f'write {key} = 1 for exactly, or {key} = ">= 1" for at least'
    return f'write {key} = "2" for exactly, ">= 1.99" for at least, or "1.99 .. 2.01"'


def _is_less(x: int | ClosedForm, y: int | ClosedForm) -> bool:
    """Whether x < y for certain; infinity is beyond all other numbers."""
    x, y = (Fraction(value) if isinstance(value, int) else value for value in (x, y))
    if isinstance(x, float) or isinstance(y, float):
        return not isinstance(x, float)
    return certainly_less(x, y)


def _number(key: str, text: str, at: int) -> int | ClosedForm:
    """The number of an expectation: an integer 0 … MAX_ORDER for an order, a closed form for an exponent.

    `infinity`, of polynomials, is an order of smoothness and a Hölder exponent, at 0 as well.
    """
    if text.strip() == spelled(INFINITY) and BY_KEY[key].question in (SMOOTHNESS, HOLDER_LOWER, HOLDER_AT_ZERO):
        return INFINITY
    if not text.strip():
        raise Fault(faults.BAD_EXPECTATION, f"a number is missing in the expected {key}", _form(key), at)
    if key == "smoothness" and (order := ORDER.fullmatch(text)):
        at, text = at + max(order.start(1), order.start(2)), order[1] or order[2]
    try:
        value = read_closed_form(text, at)
    except Fault as fault:
        rule = faults.BAD_EXPECTATION if fault.rule is faults.BAD_EXPRESSION else fault.rule
        raise Fault(rule, fault.message, fault.help, fault.at) from None
    if key not in ORDERS:
        return value
    start = at + len(text) - len(text.lstrip())
    if not isinstance(value, Fraction) or value.denominator != 1:
        raise Fault(faults.BAD_EXPECTATION, f"{key} is an integer, not {shown(text.strip())}", _form(key), start)
    if value < 0:
        raise Fault(faults.BAD_EXPECTATION, f"{key} cannot be negative", "write 0 or more, or leave it out", start)
    if value > MAX_ORDER:
        raise Fault(
            faults.OUT_OF_BOUNDS, f"the expected {key} is too large; the limit is {MAX_ORDER}", "lower it", start
        )
    return int(value)


def contradictions(expectations: Sequence[Expectation]) -> list[tuple[str, Fault]]:
    """The pairs of expectations that no scheme can meet, each with the key of the later one."""
    given = {e.key: e for e in expectations}
    order = list(given)
    pairs = []
    for first, second, law in _LAWS:
        if first in given and second in given and (why := law(given[first], given[second])):
            sides = [
                shown(f"{k} {'' if given[k].text.startswith('>') else '= '}{given[k].text}") for k in (first, second)
            ]
            fault = Fault(
                faults.BAD_EXPECTATION,
                f"{sides[0]} contradicts {sides[1]}: {why}",
                "correct one of the two, or leave it out",
            )
            pairs.append((max(first, second, key=order.index), fault))
    return pairs


def _above(x: Expectation, y: Expectation, why: str) -> str | None:
    """The text `why` where everything that x allows is more than everything that y allows, else None."""
    if y.upper is not None and _is_less(y.upper, x.lower):
        return why
    return None


def _convergent_smoothness(convergent: Expectation, _: Expectation) -> str | None:
    return None if convergent.lower else "a scheme without limit functions has no smoothness"


def _convergent_holder(convergent: Expectation, holder: Expectation) -> str | None:
    zero = Expectation(key="holder", text="", lower=Fraction(0))
    why = "the refinable function of a convergent scheme is continuous"
    return _above(zero, holder, why) if convergent.lower else None


def _holder_sobolev(holder: Expectation, sobolev: Expectation) -> str | None:
    return _above(holder, sobolev, "the Hölder exponent is at most the Sobolev exponent")


def _holder_at_zero(holder: Expectation, at_zero: Expectation) -> str | None:
    return _above(holder, at_zero, "the Hölder exponent is at most that at 0 alone")


def _convergent_sobolev(convergent: Expectation, sobolev: Expectation) -> str | None:
    zero = Expectation(key="holder", text="", lower=Fraction(0))
    why = "the refinable function of a convergent scheme is in L2"
    return _above(zero, sobolev, why) if convergent.lower else None


def _reproduction_generation(reproduction: Expectation, generation: Expectation) -> str | None:
    return _above(reproduction, generation, "polynomials that are reproduced are generated")


def _smoothness_holder(smoothness: Expectation, holder: Expectation) -> str | None:
    if why := _above(smoothness, holder, "C^n has a Hölder exponent of at least n"):
        return why
    if not isinstance(smoothness.upper, int):  # bounded from below alone, or infinite
        return None
    ceiling = Expectation(key="holder", text="", lower=Fraction(0), upper=Fraction(smoothness.upper + 1))
    return _above(holder, ceiling, "a Hölder exponent above n + 1 means C^(n+1)")


_LAWS: tuple[tuple[str, str, Callable[[Expectation, Expectation], str | None]], ...] = (
    ("convergent", "smoothness", _convergent_smoothness),
    ("convergent", "holder", _convergent_holder),
    ("reproduction", "generation", _reproduction_generation),
    ("smoothness", "holder", _smoothness_holder),
    ("holder", "sobolev", _holder_sobolev),
    ("holder", "holder_at_zero", _holder_at_zero),
    ("convergent", "sobolev", _convergent_sobolev),
)
