"""The fault of a name that is not known in an expression; loaded only when there is one."""

from __future__ import annotations

import re
from collections.abc import Collection

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.characters import RATIONAL_ONLY
from subdiv_cli.maskfile.problems import Fault, Reason, near, shown
from subdiv_cli.maskfile.tokens import Token

_VARIABLE = re.compile(r"z[0-9]*")
_NOT_FINITE = ("nan", "inf", "infinity")
_IRRATIONAL = ("sqrt", "cbrt", "root", "exp", "log", "ln", "sin", "cos", "tan", "pow", "pi", "phi", "tau", "e")


def unknown_name(token: Token, names: Collection[str], *, called: bool = False, logarithms: bool = False) -> Fault:
    """The fault of a name that is not known, with the likeliest help. `called`: a parenthesis follows."""
    name = token.text
    rule, reason = faults.BAD_EXPRESSION, None
    if name.lower() in _NOT_FINITE:
        rule, message, help = faults.BAD_NUMBER, f"{name} is not a rational number", "write a finite number"
    elif _VARIABLE.fullmatch(name):
        message, help = _variable(name, names)
    elif logarithms and name.lower().startswith(("log", "ln")):
        message, help = f'"{shown(name)}" needs its base and an argument', "write log2(64/9) or log3(11)/2"
    elif called and (name.lower() in _IRRATIONAL or len(name) > 1) and not _split(name, names):
        message = f'"{shown(name)}(…)" is a function call, and there are none'
        help = RATIONAL_ONLY if name.lower() in _IRRATIONAL else "write the value itself, or * to multiply"
    else:
        message = f'the name "{shown(name)}" is not declared'
        if meant := _meant(name, names, logarithms):
            reason, help = Reason.MISTAKEN, meant
        else:
            reason, help = Reason.UNDECLARED, _declared(name, names)
    return Fault(rule, message, help, token.at, reason=reason, about=name)


def _variable(name: str, names: Collection[str]) -> tuple[str, str]:
    """The message and the help for a variable where there are others, or none."""
    if "z1" in names:
        variables = sorted(known for known in names if _VARIABLE.fullmatch(known))
        help = "the variables here are " + ", ".join(variables)
        return (
            "z alone is no variable of a mask in several" if name == "z" else f"there is no variable {shown(name)}",
            help,
        )
    if "z" in names:
        help = 'write z; a mask in several variables has kind = "multivariate"'
        return f"a scalar mask has one variable, and {shown(name)} is not it", help
    help = "give the whole mask as a symbol to use z" if name == "z" else "give the whole mask as a symbol to use it"
    return f"{shown(name)} cannot stand in a single number", help


def _meant(name: str, names: Collection[str], logarithms: bool) -> str | None:
    """The help where something else is probably meant than a parameter of this name."""
    if parts := _split(name, names):
        return f"to multiply, write {'*'.join(parts)}"
    if name in ("x", "Z") and "z" in names:
        return "the variable of a symbol is z: (1+z)^4"
    if guess := near(name, names):
        return f"did you mean {shown(guess)}?"
    if name.lower() in _IRRATIONAL:
        return RATIONAL_ONLY
    return 'write a number or a closed form: "1.5", "log2(64/9)"' if logarithms else None


def _declared(name: str, names: Collection[str]) -> str:
    """The help that says how a parameter of this name is declared."""
    if not names or names == {"z"}:
        return f'declare it in [parameters] of a mask file: {shown(name)} = "1/16"'
    known = ", ".join(sorted(shown(n, 20) for n in names)[:8])
    return f"known here: {known}; declare it in [parameters]: {shown(name)} = 1"


def _split(name: str, names: Collection[str]) -> list[str]:
    """The two known names that a name is put together of, zw of z and w; none where it is not."""
    for i in range(1, min(len(name), 30)):
        if name[:i] in names and name[i:] in names:
            return [name[:i], name[i:]]
    return []
