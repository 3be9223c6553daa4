"""The joint spectral radius of finite families of rational matrices, with proof; nothing of masks is known here.

ρ(M_0, …, M_(p-1)) = lim max ‖M_(w_L) … M_(w_1)‖^(1/L). `products` and `search` look for a product of large spectral
radius, which bounds it from below; `gauge` and `polytope` grow a convex body that the scaled matrices map into
itself, which bounds it from above; `closing` and `enclosing` turn what floats found into inequalities that are proved.
`irreducible` puts that together for one family, `reduce` takes families with common invariant subspaces apart, and
`radius` puts all of it together. numpy is loaded with `search`, `gauge` and `polytope` only, for one thread: its
matrices are small, and threads that wait for each other would take most of the time.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
