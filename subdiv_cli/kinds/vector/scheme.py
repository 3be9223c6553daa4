"""Subdivision schemes of m-vectors in one variable, of any arity p >= 2: (S c)_i = Σ_j A_(i-pj) c_j, c_j in Q^m."""

from __future__ import annotations

from dataclasses import dataclass

from subdiv_cli.kinds.matrices.text import Matrix


@dataclass(frozen=True, slots=True, kw_only=True)
class VectorScheme:
    """A finitely supported mask of rational m×m matrices A_start, …, A_(start+n), by rows, m >= 1.

    Zero matrices at the ends are dropped on construction. Raises ValueError for an arity below 2, for matrices that are
    not square and of one size, of size 1 for jets, and where all are zero; readers of files report all of them before
    they come here.
    """

    arity: int
    start: int
    coefficients: tuple[Matrix, ...]
    kind: str = "vector"
    """The name of the kind: `vector`, or `hermite` where the data are jets."""

    def __post_init__(self) -> None:
        if self.arity < 2:
            raise ValueError(f"the arity must be at least 2, not {self.arity}")
        sizes = {len(row) for matrix in self.coefficients for row in matrix} | set(map(len, self.coefficients))
        if len(sizes) > 1:
            raise ValueError("the matrices are not square, or not of one size")
        if self.kind == "hermite" and sizes == {1}:
            raise ValueError("jets have two components at least")
        support = [i for i, matrix in enumerate(self.coefficients) if any(map(any, matrix))]
        if not support:
            raise ValueError("all coefficients are zero")
        object.__setattr__(self, "start", self.start + support[0])
        object.__setattr__(self, "coefficients", tuple(self.coefficients[support[0] : support[-1] + 1]))

    @property
    def size(self) -> int:
        """The number m of components."""
        return len(self.coefficients[0])

    @property
    def first(self) -> int:
        """The number of the first component: 0 of jets, whose component j is the j-th derivative, else 1."""
        return int(self.kind != "hermite")
