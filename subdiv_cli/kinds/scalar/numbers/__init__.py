"""Numbers of a scheme, computed and not judged: one subject per file, pure functions; stages ask and judge.

`scalar.py` holds what has been computed for one scheme, so that each number is computed once.
"""
