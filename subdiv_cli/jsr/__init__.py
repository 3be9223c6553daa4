"""The joint spectral radius of finite families of rational matrices, with proof; nothing of masks is known here.

ρ(M_0, …, M_(p-1)) = lim max ‖M_(w_L) … M_(w_1)‖^(1/L). `products` and `search` look for a product of large spectral
radius, which bounds it from below; `gauge` and `polytope` grow a convex body that the scaled matrices map into
itself, which bounds it from above; `reduce` takes families with a common invariant subspace apart; `certify` turns
what floats found into inequalities that are proved, and `radius` puts all of it together. numpy is loaded with
`search`, `gauge` and `polytope` only.
"""
