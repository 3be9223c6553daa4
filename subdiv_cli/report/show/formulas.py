"""Formulas in plain letters: symbols, stencils, operators. `report/show/tex.py` makes TeX of them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from subdiv_cli.model.blocks import Anatomy, Factor
from subdiv_cli.report.numbers import exact

_LONG = 26
"""A number with a longer spelling is shown by its first digits."""


def number(x: Fraction) -> str:
    """`-7/16`, or the first digits of a long one, `0.43843…`."""
    text = exact(x)
    if len(text) <= _LONG:
        return text
    digits, sign = abs(x), "-" if x < 0 else ""
    exponent = 0
    while digits and digits < Fraction(1, 10):
        digits, exponent = digits * 10, exponent - 1
    while digits >= 10**6:
        digits, exponent = digits / 10, exponent + 1
    scaled = digits.numerator * 10**8 // digits.denominator
    return f"{sign}{scaled // 10**8}.{scaled % 10**8:08}…" + (f"·10^{exponent}" if exponent else "")


def combination(terms: Iterable[tuple[Fraction, str]]) -> str:
    """Terms with their coefficients, those with a zero one left out."""
    text = ""
    for c, name in terms:
        if not c:
            continue
        size = "" if abs(c) == 1 and name else number(abs(c))
        sign = ("-" if c < 0 else "") if not text else " - " if c < 0 else " + "
        text += sign + size + (" " if size and name else "") + name
    return text or "0"


def power(variable: str, exponent: int) -> str:
    return "" if exponent == 0 else variable if exponent == 1 else f"{variable}^{exponent}"


def polynomial(start: int, coefficients: Sequence[Fraction | int], variable: str = "z") -> str:
    """By rising exponent, as symbols are written."""
    return combination((Fraction(c), power(variable, start + i)) for i, c in enumerate(coefficients))


def descending(coefficients: Sequence[Fraction], variable: str = "x") -> str:
    """`x^2 - 1/3`, from the coefficients, lowest power first."""
    return combination((c, power(variable, i)) for i, c in reversed(list(enumerate(coefficients))))


def factor(f: Factor) -> str:
    """`(1 + z)^4`; a long smoothing factor as `(1 + z + … + z^6)`."""
    if f.smoothing and len(f.coefficients) > 4:
        inside = f"1 + z + … + z^{len(f.coefficients) - 1}"
    else:
        inside = polynomial(0, f.coefficients)
    return f"({inside})" + (f"^{f.multiplicity}" if f.multiplicity > 1 else "")


def symbol(anatomy: Anatomy) -> str:
    """`-1/16 z^-3 (1 + z)^4 (1 - 4 z + z^2)`."""
    parts = [power("z", anatomy.power), *map(factor, anatomy.factors)]
    product = " ".join(part for part in parts if part)
    return combination([(anatomy.constant, product)])


def derivative(name: str, order: int) -> str:
    """`f`, `f'`, `f''`, `f'''`, `f^(4)`."""
    return name + ("'" * order if order < 4 else f"^({order})")


def partial(name: str, mu: Sequence[int]) -> str:
    """`f`, `f_xy`, in at most four variables and up to order 4, otherwise `D^(3,2)f`."""
    if sum(mu) > 4 or len(mu) > 4:
        return f"D^({','.join(map(str, mu))}){name}"
    letters = "".join(x * n for x, n in zip("xyzw", mu, strict=False))
    return f"{name}_{letters}" if letters else name


def operator(q: Sequence[Fraction]) -> str:
    """`f - 1/6 f''`."""
    return combination((c, derivative("f", i)) for i, c in enumerate(q))


def index(letter: str, by: int) -> str:
    """`i`, `i-1`, `i+2`."""
    return letter + (f"{by:+d}" if by else "")
