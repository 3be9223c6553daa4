"""The joint spectral radius of finite families of rational matrices, with proof; nothing of masks is known here.

ρ(M_0, …, M_(p-1)) = lim max ‖M_(w_L) … M_(w_1)‖^(1/L). `products` and `search` look for a product of large spectral
radius, which bounds it from below; `body`, `measure` and `polytope` grow a convex body that the scaled matrices map
into itself, which bounds it from above, by the linear programmes of `gauge` (balanced bodies) and `dominance` (monotone
ones); `closing` with `ties`, and `enclosing`, turn what floats found into equalities and inequalities that are proved.
`weights` and `ellipsoids` bound radii by norms with a formula. `irreducible` puts that together for one family,
`reduce` takes families with common invariant subspaces apart, and `radius` puts all of it together. numpy is loaded
with these parts only, not with `family`, `products` and `result`, and for one thread: its matrices are small, and
threads that wait for each other would take most of the time.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
