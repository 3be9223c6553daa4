"""Linear combinations as formulas: `1/6 f(i-1) + 2/3 f(i) + 1/6 f(i+1)`, `f - 1/6 f''`."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction

from subdiv_cli.exact.text import number

_VARIABLES = "xyzw"
_HIGHEST = 4
"""Order of a partial derivative that is written with the names of its variables."""


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


def stencil(start: int, weights: Iterable[Fraction], name: Callable[[str], str]) -> str:
    """Σ_j weights_j name(i + start + j), indices as `i-1`."""
    return combination((w, name(shifted("i", start + j))) for j, w in enumerate(weights))


def shifted(index: str, by: int) -> str:
    """`i`, `i-1`, `i+2`."""
    return index + (f"{by:+d}" if by else "")


def operator(q: Iterable[Fraction]) -> str:
    """Σ q_i D^i f: `f - 1/6 f'' + 1/2 f^(4)`."""
    return combination((c, derivative("f", i)) for i, c in enumerate(q))


def derivative(name: str, order: int) -> str:
    """`f`, `f'`, `f''`, `f'''`, `f^(4)`."""
    return name + ("'" * order if order < 4 else f"^({order})")


def partial(name: str, mu: Sequence[int]) -> str:
    """`f`, `f_xy`, in at most four variables and up to order 4, otherwise `D^(3,2)f`."""
    if sum(mu) > _HIGHEST or len(mu) > len(_VARIABLES):
        return f"D^({','.join(map(str, mu))}){name}"
    letters = "".join(x * n for x, n in zip(_VARIABLES, mu, strict=False))
    return f"{name}_{letters}" if letters else name


def partial_operator(q: Mapping[tuple[int, ...], Fraction]) -> str:
    """Σ q_μ D^μ f by rising order: `f - 1/6 f_xx - 1/6 f_xy - 1/6 f_yy`."""
    return combination((q[mu], partial("f", mu)) for mu in sorted(q, key=lambda mu: (sum(mu), [-n for n in mu])))


def polynomial(coefficients: Iterable[Fraction], variable: str = "x") -> str:
    """`x^2 - 1/3`, from the coefficients, lowest power first; printed with the highest first."""
    terms = [(c, "" if i == 0 else variable if i == 1 else f"{variable}^{i}") for i, c in enumerate(coefficients)]
    return combination(reversed(terms))
