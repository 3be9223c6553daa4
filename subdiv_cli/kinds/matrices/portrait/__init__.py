"""A scheme of matrices taken apart and drawn: `page` for `show`, `pictures` for `plot` and the cards of reports."""
