"""A vector scheme shown: the page of `show`, sections of reports, and the curves of `plot`."""
