"""A joint spectral radius as all kinds record it in witnesses and say it in statements."""

from __future__ import annotations

from flint import ctx

from subdiv_cli.exact.algebraic import number_of
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import certain, is_short, number, valued
from subdiv_cli.jsr.result import Radius
from subdiv_cli.model import Interval
from subdiv_cli.model.proofs import PowerData, RadiusWitness


def put_radius(witness: RadiusWitness, radius: Radius) -> None:
    """Write into a witness a product, where one is known, and what is proved of a radius."""
    if radius.word is not None:
        witness["word"] = radius.word
    put_power(witness, radius)


def put_power(witness: PowerData, radius: Radius) -> None:
    """Write into a witness what is proved of a radius ρ: ρ^length <= bound or = root, both where a norm is attained."""
    witness["length"] = radius.proof["length"]
    if "root" in radius.proof:
        witness["root"] = radius.proof["root"]
    if "bound" in radius.proof:
        witness["bound"] = radius.proof["bound"]


def enclosed(radius: Radius) -> Interval:
    """The radius in outward doubles; only from above where it is not known exactly."""
    length, bound = radius.upper
    with ctx.workprec(128):
        power = ball(1) / length
        if radius.exact is None:
            return Interval(upper=interval(ball(bound) ** power if length > 1 else bound).upper)
        root = radius.exact[1]
        if root.low == root.high and length == 1:
            return interval(root.low)
        return interval(number_of(root).enclosure().real ** power)


def shown(radius: Radius) -> str:
    """The radius as text: exactly where it is a short rational, else its digits, and behind them a short power."""
    assert radius.exact is not None
    length, root = radius.exact
    exact = number(root.low) if root.low == root.high and is_short(root.low) else None
    if exact is not None and length == 1:
        return valued(root.low)
    figures = certain(lambda: number_of(root).enclosure().real ** (ball(1) / length))
    return figures if exact is None or "…" in exact else f"{figures} = ({exact})^(1/{length})"
