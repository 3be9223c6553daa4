"""Plain mathematics as TeX: formulas for math mode, sentences with the mathematics in them set as such."""

from __future__ import annotations

import re

from subdiv_cli.report.letters import clean, transliterate

_COMMANDS = {
    "α": "\\alpha", "β": "\\beta", "γ": "\\gamma", "δ": "\\delta", "ε": "\\varepsilon", "θ": "\\theta",
    "λ": "\\lambda", "μ": "\\mu", "ν": "\\nu", "π": "\\pi", "ρ": "\\rho", "σ": "\\sigma", "τ": "\\tau",
    "φ": "\\varphi", "ψ": "\\psi", "ω": "\\omega", "Δ": "\\Delta", "Λ": "\\Lambda",
    "Π": "\\prod", "Σ": "\\sum", "Φ": "\\Phi", "∞": "\\infty",
    "‖": "\\|", "≤": "\\le", "≥": "\\ge", "≠": "\\ne", "±": "\\pm", "·": "\\cdot", "…": "\\dots", "⌊": "\\lfloor",
    "⌋": "\\rfloor", "∈": "\\in", "½": "\\tfrac12", "⅓": "\\tfrac13", "¼": "\\tfrac14", "⅕": "\\tfrac15",
    "−": "-", "√": "\\surd", "ℓ": "\\ell",
}  # fmt: skip
_ESCAPES = {
    "\\": "\\textbackslash{}", "{": "\\{", "}": "\\}", "$": "\\$", "&": "\\&", "#": "\\#", "%": "\\%",
    "~": "\\textasciitilde{}", "^": "\\textasciicircum{}", "_": "\\_", "<": "$<$", ">": "$>$", "|": "$|$",
    "—": "---", "–": "--", "ö": '\\"o', "ä": '\\"a', "ü": '\\"u', "Ö": '\\"O', "Ä": '\\"A', "Ü": '\\"U', "ß": "\\ss{}",
}  # fmt: skip
_RATIONAL = re.compile(r"(?<![\w/.^)])(\d+)/(\d+)(?![\w/.])")
_VARIABLE = re.compile(r"\bz(\d)\b")
"""A variable of a symbol in several variables."""
_PARTIAL = re.compile(r"_([xyzw]{2,})(?!\w)")
"""The index of a partial derivative."""
_SCRIPT = re.compile(r"([\^_])(\(([^()]*)\)|(-?\w|∞))")


def formula(text: str) -> str:
    """A formula for math mode: fractions, exponents and indices set as such."""
    text = _RATIONAL.sub(r"\\tfrac{\1}{\2}", _VARIABLE.sub(r"z_\1", clean(text).replace("_(i)", "_i")))
    text = _SCRIPT.sub(_script, _numbers(text))
    return "".join(f"{_COMMANDS[c]} " if c in _COMMANDS else c for c in _other(text))


def _numbers(text: str) -> str:
    """The text with parentheses where TeX needs them: z^-12 -> z^(-12), f_xy -> f_(xy)."""
    return re.sub(r"([\^_])(-?\d{2,}|-\d)(?!\d)", r"\1(\2)", _PARTIAL.sub(r"_(\1)", text))


def _script(match: re.Match[str]) -> str:
    """An exponent or an index in TeX; a derivative or a derived mask keeps its parentheses."""
    inside = match[3] if match[3] is not None else match[4]
    before = match.string[match.start() - 1 : match.start()]
    derived = match[1] == "^" and match[3] is not None and inside.isdecimal() and before in ("f", "φ", "a")
    return f"{match[1]}{{({inside})}}" if derived else f"{match[1]}{{{inside}}}"


def sentence(text: str) -> str:
    """A sentence for text mode: letters of mathematics in math mode one by one, exponents and indices as such."""
    out, at, text = "", 0, clean(text)
    while at < len(text):
        if (script := _SCRIPT.match(_numbers(text[at:]))) is not None and at:
            source = re.match(r"[\^_](\([^()]*\)|-?\d+|[xyzw]{2,}(?!\w)|-?\w|∞)", text[at:])
            inside = script[3] if script[3] is not None else script[4]
            out += f"${{}}{script[1]}{{{formula(inside)}}}$"
            at += len(source[0]) if source else 1
            continue
        c = text[at]
        out += f"${_COMMANDS[c]}$" if c in _COMMANDS else _ESCAPES.get(c, c if c.isascii() else plain(c))
        at += 1
    return out.replace("$$", "")


def label(text: str) -> str:
    """A label for text mode, where no letter is mathematics: a name of a file."""
    return "".join(_ESCAPES.get(c, c if c.isascii() else plain(c)) for c in clean(text))


def plain(text: str) -> str:
    """Any other letter in ASCII, escaped."""
    return "".join(_ESCAPES.get(c, c) if c in "\\{}$&#%~^_<>|" else c for c in transliterate(text))


def _other(text: str) -> str:
    """The letters that are not in the tables, in ASCII."""
    return "".join(c if c.isascii() or c in _COMMANDS else transliterate(c) for c in text)
