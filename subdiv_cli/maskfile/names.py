"""The fault of a name that is not known in an expression; loaded only when there is one."""

from __future__ import annotations

import re
from collections.abc import Collection

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.characters import RATIONAL_ONLY
from subdiv_cli.maskfile.problems import Fault, near, shown
from subdiv_cli.maskfile.tokens import Token

_VARIABLE = re.compile(r"z[0-9]*")
_NOT_FINITE = ("nan", "inf", "infinity")
_IRRATIONAL = ("sqrt", "cbrt", "root", "exp", "log", "ln", "sin", "cos", "tan", "pow", "pi", "phi", "tau", "e")


def unknown_name(token: Token, names: Collection[str], *, called: bool = False, logarithms: bool = False) -> Fault:
    """SD008 (SD007 for nan and inf) with the likeliest help. `called`: a parenthesis follows."""
    fault = _unknown_name(token, names, called, logarithms)
    fault.about = token.text
    return fault


def _unknown_name(token: Token, names: Collection[str], called: bool, logarithms: bool) -> Fault:
    name, at = token.text, token.at
    if name.lower() in _NOT_FINITE:
        return Fault(faults.BAD_NUMBER, f"{name} is not a rational number", "write a finite number", at)
    if _VARIABLE.fullmatch(name):
        return _variable(name, names, at)
    if logarithms and name.lower().startswith(("log", "ln")):
        return Fault(
            faults.BAD_EXPRESSION,
            f'"{shown(name)}" needs its base and an argument',
            "write log2(64/9) or log3(11)/2",
            at,
        )
    if called and (name.lower() in _IRRATIONAL or len(name) > 1) and not _split(name, names):
        help = RATIONAL_ONLY if name.lower() in _IRRATIONAL else "write the value itself, or * to multiply"
        return Fault(faults.BAD_EXPRESSION, f'"{shown(name)}(…)" is a function call, and there are none', help, at)
    message = f'the name "{shown(name)}" is not declared'
    if parts := _split(name, names):
        return Fault(faults.BAD_EXPRESSION, message, f"to multiply, write {'*'.join(parts)}", at)
    if name in ("x", "Z") and "z" in names:
        return Fault(faults.BAD_EXPRESSION, message, "the variable of a symbol is z: (1+z)^4", at)
    if guess := near(name, names):
        return Fault(faults.BAD_EXPRESSION, message, f"did you mean {shown(guess)}?", at)
    if name.lower() in _IRRATIONAL:
        return Fault(faults.BAD_EXPRESSION, message, RATIONAL_ONLY, at)
    if names and names != {"z"}:
        known = ", ".join(sorted(shown(n, 20) for n in names)[:8])
        return Fault(
            faults.BAD_EXPRESSION, message, f"known here: {known}; declare it in [parameters]: {shown(name)} = 1", at
        )
    if logarithms:
        return Fault(faults.BAD_EXPRESSION, message, 'write a number or a closed form: "1.5", "log2(64/9)"', at)
    return Fault(
        faults.BAD_EXPRESSION, message, f'declare it in [parameters] of a mask file: {shown(name)} = "1/16"', at
    )


def _variable(name: str, names: Collection[str], at: int) -> Fault:
    """A variable where there are others, or none."""
    if "z1" in names:
        variables = sorted(known for known in names if _VARIABLE.fullmatch(known))
        said = "the variables here are " + ", ".join(variables)
        if name == "z":
            return Fault(faults.BAD_EXPRESSION, "z alone is no variable of a mask in several", said, at)
        return Fault(faults.BAD_EXPRESSION, f"there is no variable {shown(name)}", said, at)
    if "z" in names:
        help = 'write z; a mask in several variables has kind = "multivariate"'
        return Fault(faults.BAD_EXPRESSION, f"a scalar mask has one variable, and {shown(name)} is not it", help, at)
    help = "give the whole mask as a symbol to use z" if name == "z" else "give the whole mask as a symbol to use it"
    return Fault(faults.BAD_EXPRESSION, f"{shown(name)} cannot stand in a single number", help, at)


def _split(name: str, names: Collection[str]) -> list[str]:
    """zw as [z, w], where both are known."""
    for i in range(1, min(len(name), 30)):
        if name[:i] in names and name[i:] in names:
            return [name[:i], name[i:]]
    return []
