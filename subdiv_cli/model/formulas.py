"""Numbers and formulas in plain letters: `-1/16 z^-3 + 9/16`, `f - 1/6 f''`; standard library only."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import groupby

from subdiv_cli.model.closed import rational

_LONGEST_EXACT = 24
_LONGEST_BRIEF = 26
_DIGITS = 10
_MOST_DIGITS = 9
"""The most digits of a fraction whose size is seen without a decimal."""
_BESIDE = 4
"""The places of a decimal that stands beside a fraction."""
_LONGEST_BITS = 256
"""The bits from which on only leading digits are shown: huge integers are slow to print."""
_VARIABLES = "xyzw"
_HIGHEST = 4
"""The highest order of a partial derivative that is written with the names of its variables."""

Spell = Callable[[Fraction], str]


def number(x: Fraction) -> str:
    """A rational as text: `-7/16`; one with a long spelling as its first digits, `0.43843…`, cut and not rounded."""
    short = is_short(x) and len(str(x)) <= _LONGEST_EXACT
    return str(x) if short else truncated(x)


def valued(x: Fraction) -> str:
    """A rational in a sentence: as `number`, one of ten digits or more with its decimal, `16295/16384 = 0.9945…`."""
    text = number(x)
    return text if "…" in text or is_plain(x) else f"{text} = {truncated(x, _BESIDE)}"


def is_plain(x: Fraction) -> bool:
    """Whether a rational says its size by itself: an integer, or a fraction of up to nine digits."""
    return x.denominator == 1 or (is_short(x) and sum(map(str.isdigit, str(x))) <= _MOST_DIGITS)


def sized(x: Fraction) -> str:
    """A rational in a series: a fraction of ten digits or more as its first digits, `0.9945…`."""
    return rational(x) if is_plain(x) else truncated(x, _BESIDE)


def near_one(x: Fraction) -> str:
    """As `number`; what differs from 1 in digits that are not shown is `1 - 2.4100000000…e-9`."""
    off = abs(x - 1)
    if not off or off * 10**4 > 1 or (is_short(x) and len(str(x)) <= _LONGEST_EXACT):
        return number(x)
    return f"1 {'-' if x < 1 else '+'} {truncated(off, 3)}"


def is_short(x: Fraction) -> bool:
    """Whether a rational can be printed in full without thought."""
    return max(x.numerator.bit_length(), x.denominator.bit_length()) <= _LONGEST_BITS


def truncated(x: Fraction, digits: int = _DIGITS) -> str:
    """The decimal digits of x up to some place, followed by `…`; tiny and huge numbers with an exponent."""
    if x < 0:
        return "-" + truncated(-x, digits)
    exponent = 0
    if x and not Fraction(1, 10**4) <= x < 10**6:
        exponent = _decimal_exponent(x)
        x /= Fraction(10) ** exponent
    whole, decimals = divmod(x.numerator * 10**digits // x.denominator, 10**digits)
    return f"{whole}.{decimals:0{digits}d}…" + (f"e{exponent}" if exponent else "")


def _decimal_exponent(x: Fraction) -> int:
    """The exponent e with 10^e <= x < 10^(e+1), x > 0: estimated from the bits, then put right."""
    exponent = (x.numerator.bit_length() - x.denominator.bit_length()) * 30103 // 100000
    while x < Fraction(10) ** exponent:
        exponent -= 1
    while x >= Fraction(10) ** (exponent + 1):
        exponent += 1
    return exponent


def brief(x: Fraction) -> str:
    """A rational in a formula: `-7/16`, or the first digits of a long number, `0.43843812…·10^-7`."""
    text = rational(x)
    if len(text) <= _LONGEST_BRIEF:
        return text
    digits, exponent = abs(x), 0
    while digits and digits < Fraction(1, 10):
        digits, exponent = digits * 10, exponent - 1
    while digits >= 10**6:
        digits, exponent = digits / 10, exponent + 1
    whole, decimals = divmod(digits.numerator * 10**8 // digits.denominator, 10**8)
    return f"{'-' if x < 0 else ''}{whole}.{decimals:08}…" + (f"·10^{exponent}" if exponent else "")


def point(entries: Iterable[Fraction | int], spell: Spell = rational) -> str:
    """A point as text: `(1/2, 0)`."""
    return f"({', '.join(spell(Fraction(x)) for x in entries)})"


def combination(terms: Iterable[tuple[Fraction, str]], spell: Spell = number) -> str:
    """A sum of terms with their coefficients as text, those with a zero one left out."""
    text = ""
    for c, name in terms:
        if not c:
            continue
        size = "" if abs(c) == 1 and name else spell(abs(c))
        sign = ("-" if c < 0 else "") if not text else " - " if c < 0 else " + "
        text += sign + size + (" " if size and name else "") + name
    return text or "0"


def power(variable: str, exponent: int) -> str:
    """A power of a variable as text: nothing, `z`, `z^-3`."""
    return "" if exponent == 0 else variable if exponent == 1 else f"{variable}^{exponent}"


def laurent(start: int, coefficients: Iterable[Fraction | int], spell: Spell = number) -> str:
    """A Laurent polynomial as text, by rising exponent, as symbols are written: `-1/16 z^-3 + 9/16 z^-1 + 1`."""
    return combination(((Fraction(c), power("z", start + i)) for i, c in enumerate(coefficients)), spell)


def polynomial(coefficients: Sequence[Fraction], spell: Spell = number) -> str:
    """A polynomial as text, highest power first: `x^2 - 1/3`; `coefficients` have the lowest first."""
    return combination(reversed([(c, power("x", i)) for i, c in enumerate(coefficients)]), spell)


def stencil(start: int, weights: Iterable[Fraction], name: Callable[[str], str]) -> str:
    """The sum Σ_j weights_j name(i + start + j) as text, indices as `i-1`."""
    return combination((w, name(shifted("i", start + j))) for j, w in enumerate(weights))


def shifted(index: str, by: int) -> str:
    """A shifted index as text: `i`, `i-1`, `i+2`."""
    return index + (f"{by:+d}" if by else "")


def datum(index: str, by: int) -> str:
    """A datum with a shifted index as text: `f_i`, `f_(i-1)`."""
    return f"f_({shifted(index, by)})" if by else f"f_{index}"


def operator(q: Iterable[Fraction], spell: Spell = number) -> str:
    """The operator Σ q_i D^i f as text: `f - 1/6 f'' + 1/2 f^(4)`."""
    return combination(((c, derivative("f", i)) for i, c in enumerate(q)), spell)


def derivative(name: str, order: int) -> str:
    """A derivative as text: `f`, `f'`, `f''`, `f'''`, `f^(4)`."""
    return name + ("'" * order if order < 4 else f"^({order})")


def partial(name: str, mu: Sequence[int]) -> str:
    """A partial derivative as text: `f`, `f_xy`, in at most four variables and up to order 4, otherwise `D^(3,2)f`."""
    if sum(mu) > _HIGHEST or len(mu) > len(_VARIABLES):
        return f"D^({','.join(map(str, mu))}){name}"
    letters = "".join(x * n for x, n in zip(_VARIABLES, mu, strict=False))
    return f"{name}_{letters}" if letters else name


def partial_operator(q: Mapping[tuple[int, ...], Fraction], spell: Spell = number) -> str:
    """The operator Σ q_μ D^μ f as text, by rising order: `f - 1/6 f_xx - 1/6 f_xy - 1/6 f_yy`."""
    return combination(((q[mu], partial("f", mu)) for mu in rising(q)), spell)


def rising(indices: Iterable[tuple[int, ...]]) -> list[tuple[int, ...]]:
    """The indices sorted by total degree, the first variable first."""
    return sorted(indices, key=lambda mu: (sum(mu), [-n for n in mu]))


def product(word: Sequence[int], name: str, times: str = "") -> str:
    """The product M_(w_ℓ) … M_(w_1) of a word as text, runs of one matrix as its powers: `M_1M_0^12`."""
    runs = ((letter, len(list(run))) for letter, run in groupby(reversed(word)))
    return times.join(f"{name}_{letter}" + (f"^{count}" if count > 1 else "") for letter, count in runs)
