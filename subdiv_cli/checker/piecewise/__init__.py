"""The rules of kind `piecewise`: a mask on each side of 0 and special rows, on the kinds below as it stands there.

`masks` reads, `spaces` computes the spaces of functionals exactly, `spectra` has the eigenvalues of one matrix, `sides`
the certificates of the masks, `polynomials` what is generated, `conclusions` the statements on limits. See FORMAT.md.
"""
