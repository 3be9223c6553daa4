"""Bounds of the Hölder exponent that products of transition matrices give."""

from __future__ import annotations

from subdiv_cli.exact.algebraic import AlgebraicNumber
from subdiv_cli.exact.closed import closed_interval
from subdiv_cli.exact.text import root
from subdiv_cli.jsr.products import Product, radius_bound
from subdiv_cli.model import Interval, logarithm


def exponent_bound(product: Product, p: int) -> Interval:
    """-log_p(r) / ℓ with r of `radius_bound`: an upper bound of the Hölder exponent for a stable refinable function.

    `exact` is -log_p(|λ|) / ℓ itself, where λ is real.
    """
    exact = logarithm(p, 1 / radius_bound(product), len(product.word))
    if product.eigenvalue.rational is not None:
        return closed_interval(exact)
    return closed_interval(exact)._replace(exact=_closed_form(product.eigenvalue, p, len(product.word)))


def _closed_form(eigenvalue: AlgebraicNumber, p: int, length: int) -> str | None:
    """-log_p(|λ|)/ℓ as text for a real λ; for a complex one there is none in this grammar."""
    if not eigenvalue.is_real:
        return None
    sign = "-" if eigenvalue.region.real < 0 else ""
    return f"-log{p}({sign}{root(eigenvalue)})" + (f"/{length}" if length > 1 else "")
