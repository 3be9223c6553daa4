"""What is computed of a scheme of matrices, each number once: `matrices` has the object, `curve` the theorems.

`components` has the polynomials among the components of the curve, `patterns` the sign patterns of stochastic products.
"""
