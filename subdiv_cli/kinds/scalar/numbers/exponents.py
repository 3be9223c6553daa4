"""Bounds of the Hölder exponent that products of transition matrices give."""

from __future__ import annotations

from subdiv_cli.exact.closed import closed_interval
from subdiv_cli.jsr.products import Product, radius_bound
from subdiv_cli.model import Interval, logarithm


def exponent_bound(product: Product, p: int) -> Interval:
    """-log_p(r) / ℓ with r of `radius_bound`: an upper bound of the Hölder exponent for a stable refinable function.

    `exact` where λ is rational: r is |λ| then, and a little below it otherwise.
    """
    bound = closed_interval(logarithm(p, 1 / radius_bound(product), len(product.word)))
    return bound if product.eigenvalue.rational is not None else bound._replace(exact=None)
