"""Rules on curves that matrices refine, for documents of the kind `matrices`. See kinds/matrices/FORMAT.md.

`rules`: the table. `convergence`: the family on differences, positive columns, pieces that meet. `components`: the span
of the curve, its polynomials, the family on what annihilates them, derivatives at the joints. `conclusions`: smoothness
and the Hölder exponent.
"""
