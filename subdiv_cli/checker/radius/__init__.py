"""Rules on joint spectral radii of families of matrices, shared by all kinds, and the kind `matrices`. See RADIUS.md.

`rules`: the table. `families`: blocks, distinct matrices, words. `polytopes`: unit balls and what they bound. `norms`:
ellipsoids, weighted sums and growing vectors. `closing`: closed polytopes, where the radius is exact, of which
`vertices` has the tree, `ties` the images on the boundary, `eigenvectors` the leading vectors and `disc` complex
eigenvalues.
"""
