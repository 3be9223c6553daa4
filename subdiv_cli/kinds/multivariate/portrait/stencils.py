"""Functions on Z^s as planes of numbers: the stencil of each coset of MZ^s, values of φ, the stencil of Q; no flint.

Of more than two variables the further ones are fixed, a plane for each of their values.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from itertools import groupby, islice
from math import lcm
from typing import NamedTuple

from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.multivariate.witnesses import MultivariateQuasiInterpolationWitness
from subdiv_cli.model import Finding, Result, Verdict
from subdiv_cli.model.blocks import Block, Plane, Planes, Section, Text
from subdiv_cli.model.closed import rational
from subdiv_cli.model.findings import QUASI_INTERPOLATION, answering
from subdiv_cli.model.formulas import point
from subdiv_cli.spaces.lattice import Index, Lattice

MOST_COSETS = 16
"""The most cosets of a mask whose stencils are drawn."""
_LARGEST_DENOMINATOR = 10**6
"""The largest denominator that is taken out of the weights, which keeps them short."""

Values = Mapping[Index, Fraction]


class Stencil(NamedTuple):
    """The rule (S f)(γ + Mβ) = Σ_δ weights[δ] f(β + δ), for all β, of the new points M^-1 γ + Z^s."""

    coset: Index
    """The representative γ of the coset."""
    at: tuple[Fraction, ...]
    """The place M^-1 γ of the new points."""
    weights: Values
    """The weights δ -> a_(γ - Mδ) that are not zero."""

    @property
    def title(self) -> str:
        """The title of the stencil: `coset (1, 0) at (1/2, 0), in 1/8`."""
        where = f"at {point(self.at)}" if any(self.at) else "at the old points"
        return f"coset {point(self.coset)} {where}{scaled(self.weights) if self.weights else ': no weights'}"


def stencils(terms: Values, lattice: Lattice) -> Iterator[Stencil]:
    """The stencils of the |det M| cosets, representatives with small entries first; `terms` has α -> a_α on Z^s."""
    of_coset: dict[Index, list[Index]] = {}
    for alpha in terms:
        of_coset.setdefault(lattice.coset(alpha), []).append(alpha)
    for gamma in lattice.corner:
        weights = {}
        for alpha in of_coset.get(lattice.coset(gamma), ()):
            delta = lattice.preimage(tuple(g - a for g, a in zip(gamma, alpha, strict=True)))
            assert delta is not None, "they differ by an element of MZ^s"
            weights[delta] = terms[alpha]
        yield Stencil(gamma, lattice.place(gamma), weights)


def stencil_blocks(terms: Values, lattice: Lattice) -> Iterator[Block]:
    """The blocks of the stencils of the first cosets, in the plane beside each other."""
    shown = list(islice(stencils(terms, lattice), MOST_COSETS))
    if lattice.dimension == 2:
        yield Planes(tuple(plane for stencil in shown for plane in _planes(stencil.title, stencil.weights)))
    else:
        for stencil in shown:
            yield from _sliced(stencil.title, stencil.weights)
    if (more := lattice.index - len(shown)) > 0:
        yield Text(f"and {more} more coset{'' if more == 1 else 's'}", "quiet")


def value_blocks(title: str, values: Values) -> Iterator[Block]:
    """The blocks of a function on Z^s, where it is not zero."""
    title += scaled(values)
    if len(next(iter(values))) == 2:
        yield Planes(tuple(_planes(title, values)))
    else:
        yield from _sliced(title, values)


def quasi_blocks(stencil: Values) -> Iterator[Block]:
    """The block of the stencil of Q, where it is more than one weight."""
    if len(stencil) > 1:
        yield from value_blocks("Q f(α) = Σ t_j f(α+j)", stencil)


def quasi_witness(findings: Iterable[Finding]) -> MultivariateQuasiInterpolationWitness | None:
    """The witness of the finding on Q, None where Q is not proved."""
    finding = answering(findings, QUASI_INTERPOLATION)
    proved = finding is not None and finding.verdict is Verdict.PROVED
    return rules.QUASI_INTERPOLATION.witness_of(finding) if finding is not None and proved else None


def sections(scheme: MultivariateScheme, result: Result) -> tuple[Section, ...]:
    """The sections of a report on a mask beside the findings: the stencils."""
    quasi = quasi_witness(result.findings)
    stencil = quasi_blocks({} if quasi is None else dict(quasi["stencil"]))
    return (Section("stencils", (*stencil_blocks(scheme.terms, Lattice(scheme.dilation)), *stencil)),)


def scaled(weights: Values) -> str:
    """The unit of the cells as text: `, in 1/8` where they have eight times the weights."""
    denominator = _denominator(weights)
    return f", in 1/{denominator}" if denominator > 1 else ""


def _denominator(weights: Values) -> int:
    """The factor by which the weights are multiplied before they are shown."""
    common = lcm(*(weight.denominator for weight in weights.values()))
    return common if common <= _LARGEST_DENOMINATOR else 1


def _planes(title: str, weights: Values) -> Iterator[Plane]:
    """The planes of a function: one for two variables; for more those with weights, under titles of their own."""
    scale = _denominator(weights)
    cells = sorted(((index, rational(weight * scale)) for index, weight in weights.items()), key=lambda c: c[0][2:])
    if not cells:
        yield Plane(title, {})
    for fixed, group in groupby(cells, key=lambda cell: cell[0][2:]):
        own = ", ".join(f"x{i} = {k}" for i, k in enumerate(fixed, 3)) or title
        yield Plane(own, {index[:2]: text for index, text in group})


def _sliced(title: str, weights: Values) -> Iterator[Block]:
    yield Text(title, "quiet")
    if weights:
        yield Planes(tuple(_planes("", weights)))
