"""The algebra: rationals through one door, Laurent polynomials, rational matrices, algebraic numbers, enclosures.

Everything here is exact or rigorously enclosed. FLINT aborts the process on huge sizes, so callers bound every size
(mask length, level, matrix order) before they come here.
"""
