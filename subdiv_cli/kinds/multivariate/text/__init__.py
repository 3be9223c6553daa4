"""Masks in several variables: what [mask] may say, one form a file, and what each comes to at the parameters' values.

`reading` is where the reader comes in; the forms themselves are data, in `bodies`.
"""
