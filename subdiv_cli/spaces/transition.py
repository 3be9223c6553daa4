"""The transition operators of a mask of m×m matrices on Z^s, as matrices on sequences over a window.

S acts on data by (S c)(α) = Σ_β A_(α-Mβ) c(β). Its transition operators, one for each representative ε of Z^s/MZ^s,
act on finitely supported sequences of m-vectors:

    (T_ε v)(α) = Σ_β A_(ε+Mα-β)^T v(β).

With (v * c)(i) = Σ_j v(i-j)·c(j) they answer for S: (v * S c)(ε + M a) = (T_ε v * c)(a), so that
(v * S^n c)(i) = (T_(ε_n) ⋯ T_(ε_1) v * c)(a) for i = ε_1 + M ε_2 + … + M^(n-1) ε_n + M^n a: the finest digit acts
first.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import count, product
from math import lcm

from flint import fmpq_mat

from subdiv_cli.exact.linalg import identity, matrix, nullspace
from subdiv_cli.model import Look, no_clock
from subdiv_cli.spaces.lattice import Index, Lattice, box

LARGEST_WINDOW = 1000
"""The most indices of a window."""
LARGEST_BOX = 20_000
"""The most indices of the box in which the window is looked for."""


class TransitionOperators:
    """The T_ε of a mask of m×m matrices, not all of them 0, moved so that its support begins at 0 along each axis.

    With t the corner of the support these are the T_(ε+t) of the mask itself, ε the representatives of the lattice, 0
    first; ε + t are representatives too. The limits of the moved mask are translates of those of the mask.
    """

    def __init__(self, lattice: Lattice, terms: Mapping[Index, fmpq_mat]) -> None:
        kept = {index: a for index, a in sorted(terms.items()) if any(a.entries())}
        self.lattice = lattice
        self.corner: Index = tuple(map(min, zip(*kept, strict=True)))
        """The corner t."""
        self.terms = {tuple(x - t for x, t in zip(index, self.corner, strict=True)): a for index, a in kept.items()}

    @property
    def cosets(self) -> tuple[Index, ...]:
        """The representatives ε + t for the mask where it stands, t first."""
        return tuple(tuple(map(sum, zip(e, self.corner, strict=True))) for e in self.lattice.representatives)

    @property
    def size(self) -> int:
        """The number m of components."""
        return next(iter(self.terms.values())).nrows()

    @cached_property
    def sums(self) -> tuple[fmpq_mat, ...]:
        """The m×m matrices A^ε = Σ_β A_(ε+Mβ), ε the representatives."""
        sums = {self.lattice.coset(epsilon): identity(self.size) * 0 for epsilon in self.lattice.representatives}
        for index, a in self.terms.items():
            sums[self.lattice.coset(index)] += a
        return tuple(sums.values())

    @cached_property
    def constants(self) -> fmpq_mat | None:
        """A basis of E_A = {u : A^ε u = u for all ε}, r rows of m entries; None where it is 0."""
        unit = identity(self.size)
        rows = nullspace(fmpq_mat([row for a in self.sums for row in (a - unit).tolist()]))
        return matrix(rows) if rows else None

    @cached_property
    def _shifts(self) -> set[Index]:
        """The γ - ε: T_ε v has α in its support only if Mα = β + γ - ε for a β in that of v."""
        pairs = product(self.terms, self.lattice.representatives)
        return {tuple(g - e for g, e in zip(gamma, epsilon, strict=True)) for gamma, epsilon in pairs}

    def images(self, indices: Iterable[Index]) -> set[Index]:
        """The indices that supports of images can have, for sequences supported on these indices."""
        near = {tuple(map(sum, zip(beta, shift, strict=True))) for beta in indices for shift in self._shifts}
        return {alpha for x in near if (alpha := self.lattice.preimage(x)) is not None}

    def closed_window(self, start: Iterable[Index], look: Look = no_clock) -> tuple[Index, ...] | None:
        """The smallest set that holds the start and the supports of all images; None above LARGEST_WINDOW indices.

        Raises what `look` raises.
        """
        window, new = set[Index](), set(start)
        while new:
            look()
            window |= new
            if len(window) > LARGEST_WINDOW:
                return None
            new = self.images(new) - window
        return tuple(sorted(window))

    @cached_property
    def window(self) -> tuple[Index, ...] | None:
        """The indices W where all finitely supported sequences end up after finitely many T_ε; None as above.

        For s = 1 and a support [a, b] it is [⌈a/(p-1)⌉ - 1, ⌊b/(p-1)⌋]. In general: with ‖M^-n‖ <= 1/2 and all shifts
        in the ball of radius R, an orbit x_(j+1) = M^-1(x_j + shift) comes into the ball of radius
        2R Σ_(j<=n) ‖M^-j‖, again and again; so into the smallest invariant set that holds that ball, and into all
        images of that set, which shrink to W.
        """
        start = self._absorbing_box()
        if start is None:
            return None
        now = set(start)
        while not (inner := self.images(now)) <= now:
            now |= inner
        while inner != now:
            now, inner = inner, self.images(inner)
        return tuple(sorted(now))

    def _absorbing_box(self) -> list[Index] | None:
        """The indices of the ball that every orbit comes into, in the maximum norm; None where they are too many."""
        farthest, total = max(max(map(abs, shift)) for shift in self._shifts), Fraction(0)
        for n in count(1):
            norm = max(sum(map(abs, row), Fraction(0)) for row in self.lattice.inverse_power(n))
            total += norm
            if 2 * norm <= 1:
                break
        side, s = int(2 * farthest * total), self.lattice.dimension
        return list(box((-side,) * s, (side,) * s)) if (2 * side + 1) ** s <= LARGEST_BOX else None

    def on(self, window: Sequence[Index], look: Look = no_clock) -> tuple[fmpq_mat, ...]:
        """The T_ε on sequences over an invariant window as square matrices, m coordinates an index, index by index.

        They act on columns. Raises what `look` raises.
        """
        common = lcm(*(int(a.numer_denom()[1]) for a in self.terms.values()))
        scaled = {index: (a * common).numer_denom()[0].tolist() for index, a in self.terms.items()}
        m, places = self.size, {alpha: j for j, alpha in enumerate(window)}
        matrices = []
        for epsilon in self.lattice.representatives:
            look()
            rows = [[0] * (m * len(window)) for _ in range(m * len(window))]
            for alpha, i in places.items():
                at = [e + x for e, x in zip(epsilon, self.lattice.image(alpha), strict=True)]
                for gamma, a in scaled.items():
                    j = places.get(tuple(x - g for x, g in zip(at, gamma, strict=True)))
                    if j is not None:
                        for row in range(m):
                            for column in range(m):
                                rows[m * i + column][m * j + row] = int(a[row][column])
            matrices.append(fmpq_mat(m * len(window), m * len(window), [x for row in rows for x in row]) / common)
        return tuple(matrices)
