"""The kind `scalar`: masks in one variable. See FORMAT.md.

`rules`: the table. `masks`: what a document is about. `symbols`: rules that compute with a mask. `conclusions`: those
that compose claims. `families`: joint spectral radii and what they say of α. `sobolev`, `values`, `bounds`: the Sobolev
exponent, φ at the integers and quasi-interpolation, distances of control polygons. `words`: the printed line.
"""
