"""Letters for a console: mathematics in ASCII where nothing else can be written, and no control characters anywhere."""

from __future__ import annotations

import re

from subdiv_cli.report.marks import MARKS

_WORDS = {
    "α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "ε": "epsilon", "ζ": "zeta", "η": "eta", "θ": "theta",
    "ι": "iota", "κ": "kappa", "λ": "lambda", "μ": "mu", "ν": "nu", "ξ": "xi", "π": "pi", "ρ": "rho", "σ": "sigma",
    "ς": "sigma", "τ": "tau", "υ": "upsilon", "φ": "phi", "ϕ": "phi", "χ": "chi", "ψ": "psi", "ω": "omega",
    "Γ": "Gamma", "Δ": "Delta", "Θ": "Theta", "Λ": "Lambda", "Ξ": "Xi", "Π": "Pi", "Σ": "Sum", "Φ": "Phi",
    "Ψ": "Psi", "Ω": "Omega", "∑": "Sum", "∏": "Prod", "∇": "nabla", "∂": "d", "∞": "inf", "√": "sqrt", "ℓ": "l",
}  # fmt: skip
_SIGNS = {
    "‖": "||", "∥": "||", "⁄": "/",
    "≥": ">=", "≤": "<=", "≠": "!=", "≈": "~", "≡": "==", "±": "+/-", "−": "-", "×": "x", "·": "*", "⋅": "*",
    "∘": "o", "⊕": "(+)", "⊗": "(x)", "∈": "in", "∉": "not in", "⊂": "subset of", "⊆": "subset of", "∀": "for all",
    "∃": "exists", "→": "->", "←": "<-", "↦": "|->", "⇒": "=>", "⇔": "<=>", "…": "...", "⋯": "...", "—": "--",
    "–": "-", "‐": "-", "‑": "-", "“": '"', "”": '"', "„": '"', "‘": "'", "’": "'", "′": "'", "″": "''",
    "«": '"', "»": '"', "⌈": "ceil(", "⌉": ")", "⌊": "floor(", "⌋": ")", "⟨": "<", "⟩": ">", "°": " deg",
    "ä": "ae", "ö": "oe", "ü": "ue", "Ä": "Ae", "Ö": "Oe", "Ü": "Ue", "ß": "ss", "ø": "oe", "Ø": "Oe", "æ": "ae",
    "ł": "l", "Ł": "L", "─": "-", "│": "|", "\N{NO-BREAK SPACE}": " ", "\u2009": " ", "\u202f": " ",
}  # fmt: skip
_RAISED = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿⁱ", "0123456789+-ni", strict=True))
_LOWERED = dict(zip("₀₁₂₃₄₅₆₇₈₉₊₋ₙᵢⱼₖ", "0123456789+-nijk", strict=True))
_PARTS = {
    "½": "1/2", "⅓": "1/3", "⅔": "2/3", "¼": "1/4", "¾": "3/4", "⅕": "1/5", "⅖": "2/5", "⅗": "3/5", "⅘": "4/5",
    "⅙": "1/6", "⅚": "5/6", "⅐": "1/7", "⅛": "1/8", "⅜": "3/8", "⅝": "5/8", "⅞": "7/8", "⅑": "1/9", "⅒": "1/10",
}  # fmt: skip
_TABLE = str.maketrans({**_SIGNS, **_WORDS, **{mark.sign: mark.ascii for mark in MARKS.values()}})


def clean(text: str) -> str:
    """The text on one line, with what could move a cursor, turn a line around or not be encoded made visible.

    Names and file names come from others: an escape sequence in them must not reach a terminal.
    """
    if text.isprintable():
        return text
    return "".join(
        c if c.isprintable() else " " if c.isspace() else c.encode("unicode_escape").decode("ascii")
        for c in text.replace("\r\n", " ")
    )


def transliterate(text: str) -> str:
    """The text in ASCII: mathematics by name, accents dropped, anything else as its escape; never an error."""
    if text.isascii():
        return text
    text = re.sub(f"[{''.join(_RAISED)}]+", lambda run: "^" + "".join(_RAISED[c] for c in run[0]), text)
    text = re.sub(f"[{''.join(_LOWERED)}]+", lambda run: "_" + "".join(_LOWERED[c] for c in run[0]), text)
    text = re.sub(f"(\\d?)([{''.join(_PARTS)}])(?=(\\w|\\()?)", _part, text)
    text = text.replace("‖∞", "||_inf").translate(_TABLE)
    return text if text.isascii() else "".join(map(_fallback, text))


def _part(match: re.Match[str]) -> str:
    """A fraction in ASCII, ½ as 1/2; in parentheses before a factor, and apart from a whole number."""
    whole, part, factor = match.groups()
    text = f"({_PARTS[part]})" if factor else _PARTS[part]
    return f"{whole} {text}" if whole else text


def _fallback(letter: str) -> str:
    if letter.isascii():
        return letter
    import unicodedata  # not needed for the common report

    plain = "".join(c for c in unicodedata.normalize("NFKD", letter) if not unicodedata.combining(c)).translate(_TABLE)
    return plain if plain.isascii() else letter.encode("ascii", "backslashreplace").decode("ascii")


def letters(text: str, unicode: bool) -> str:
    """The text as it may be printed: on one line, and in ASCII unless `unicode`."""
    return clean(text) if unicode else clean(transliterate(text))


def width(text: str) -> int:
    """The columns a text takes in a terminal: two for a wide character, none for a combining one."""
    if text.isascii():
        return len(text)
    import unicodedata

    return sum(0 if unicodedata.combining(c) else 2 if unicodedata.east_asian_width(c) in "WF" else 1 for c in text)
