"""Transliteration, and widths."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from subdiv_cli.report.letters import clean, letters, transliterate, width


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("‖((1/2)S_1)^2‖∞ ≥ ½", "||((1/2)S_1)^2||_inf >= 1/2"),
        ("‖½S_1‖∞", "||(1/2)S_1||_inf"),
        ("½(1+z), 2½", "(1/2)(1+z), 2 1/2"),
        ("⅕S_ν contracts", "(1/5)S_nu contracts"),
        ("φ ∈ C², α ≤ −log2 ρ(T₀)", "phi in C^2, alpha <= -log2 rho(T_0)"),
        ("z⁻¹² + zⁿ", "z^-12 + z^n"),
        ("Σ a_(γ+2β) = 1 ∀γ", "Sum a_(gamma+2beta) = 1 for allgamma"),
        ("Hölder; Möller; Grünwald; Beauté", "Hoelder; Moeller; Gruenwald; Beaute"),
        ("C^1 — “proved” …", 'C^1 -- "proved" ...'),
        ("⌈n/(p−1)⌉", "ceil(n/(p-1))"),
        ("ℤ, 𝑥, ﬁ", "Z, x, fi"),
        ("中", r"\u4e2d"),
        ("\udc80", r"\udc80"),
        ("plain a^2", "plain a^2"),
        ("½½", "(1/2)1/2"),
    ],
)
def test_ascii(text, shown):
    assert transliterate(text) == shown


@given(st.text(st.characters(exclude_categories=[])))
def test_every_text_becomes_printable_ascii(text):
    shown = letters(text, unicode=False)
    assert shown.isascii()
    assert shown.isprintable()


@given(st.text(st.characters(exclude_categories=[])))
def test_clean_text_has_no_control_characters_and_can_be_encoded(text):
    shown = clean(text)
    shown.encode("utf-8")
    assert not any(ord(c) < 32 or 127 <= ord(c) < 160 or c in "\u202e\u2028\ufeff" for c in shown)


def test_clean_keeps_mathematics():
    text = "‖(½S_1)^2‖∞ ≥ ρ(Π), φ ∈ C² — Hölder"
    assert clean(text) == text


def test_width():
    assert width("abc") == 3
    assert width("φ½∞") == 3
    assert width("中文") == 4
    assert width("e\u0301") == 1
