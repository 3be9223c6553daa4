"""The kind `multivariate`: masks on Z^s. `kinds/multivariate/FORMAT.md` specifies it.

`rules`: the table. `masks`, `lattice`: what a document is about, and its arithmetic. `sum_rules`, `stability`,
`differences`, `matrix_schemes`, `mean_squares`, `directional`: rules that compute with a mask. `box_splines`, `tensor`:
masks whose φ is known, or is a product. `conclusions`: rules that compose claims. `words`: the printed line.
"""
