"""Scalar masks for readers: `page` takes one apart for `show`, `curves` draws for `plot`, `sections` for reports."""
