"""Numbers of a scheme in several variables, computed and not judged: one subject per file, pure functions.

`multivariate` holds what has been computed for one scheme, so that each number is computed once.
"""
