"""numpy's array types, for the modules that work in floats, and complex vectors as real ones of twice the length."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]
Numbers = npt.NDArray[Any]
"""An array of real or complex numbers."""


def as_real(vectors: Numbers) -> Array:
    """Complex vectors of n entries as real ones of 2n, (Re, Im) along the last axis; real vectors as they are."""
    if np.iscomplexobj(vectors):
        return np.concatenate([vectors.real, vectors.imag], axis=-1)
    return np.asarray(vectors, dtype=np.float64)
