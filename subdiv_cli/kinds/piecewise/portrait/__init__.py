"""Pieces of a piecewise scheme for `show`: its rules, what it does near 0, and its polynomials."""
