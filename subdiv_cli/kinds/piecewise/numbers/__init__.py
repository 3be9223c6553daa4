"""What is computed of a piecewise scheme, each number once: `piecewise` has the object, `functionals` the theorems.

`spectrum` has spectral radii of one matrix, `sides` what certificates state of the masks on both sides, `polynomials`
the sequences whose limits are polynomials.
"""
