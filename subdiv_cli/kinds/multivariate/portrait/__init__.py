"""Masks in several variables for readers: `page` takes one apart for `show`, `pictures` draws φ and nets for `plot`.

`stencils` has the grids of both and of reports.
"""
