"""The kind `hermite`: the rules of kind `vector`, and those on jets as data. See FORMAT.md of the kind.

`jets`: the spectral condition, what lies between components and differences of the limit, and Hermite convergence.
"""
