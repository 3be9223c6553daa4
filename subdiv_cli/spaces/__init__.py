"""Invariant spaces of the transition operators of a mask: where smoothness is decided, stable or not.

`lattice` has Z^s and the dilation, `transition` the operators T_ε of a mask of m×m matrices, `closure` the smallest
space that holds given sequences and is mapped into itself, and `stencils` the theorems: the space of constants, limit
stencils, and V_k(w). Scalar masks are those with m = 1, masks in one variable those with s = 1.
"""
