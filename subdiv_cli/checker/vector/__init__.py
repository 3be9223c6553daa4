"""Rules on masks of matrices in one variable, and the kind `vector`. See FORMAT.md of the kind.

`masks`: the masks, and the images of sequences under their transition operators. `sequences`: constants, polynomials
and limit stencils. `spaces`: invariant spaces of sequences, which introduce families. `derived`: derived schemes.
`conclusions`: what follows.
"""
