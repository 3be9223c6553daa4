"""The codes of schemes in several variables: a row for each, as those of scalar schemes have it."""

from __future__ import annotations

from subdiv_cli.model import Rule
from subdiv_cli.model import findings as questions
from subdiv_cli.model.findings import table

_RADIUS = frozenset({"family", "radius", "bounded", "radius-upper"})
_BOX_SPLINES = "de Boor, Höllig & Riemenschneider 1993"

COSET_SUMS = Rule(
    "SD601",
    "coset-sums",
    "Dyn 1992, Proposition 6.1",
    answers=(questions.SUMS,),
    proves=frozenset({"coset-sums"}),
    holds=True,
)
SUM_RULES = Rule(
    "SD602",
    "total-sum-rules",
    "Jia 1998; Levin 2003, section 2",
    answers=(questions.SUM_RULES, questions.GENERATION),
    proves=frozenset({"total-sum-rules", "generation"}),
)
BOX_SPLINE = Rule("SD603", "box-spline", f"{_BOX_SPLINES}, chapters I and II", proves=frozenset({"box-spline"}))
DIRECTIONAL_NORMS = Rule(
    "SD604",
    "directional-norms",
    "Dyn 1992, (6.52), (6.53) and Proposition 6.10",
    proves=frozenset({"directional-norm"}),
)
DIFFERENCE_RADIUS = Rule(
    "SD605",
    "difference-radius",
    "Jia 1998; Han & Jia 1998; Guglielmi, Wirth & Zennaro 2005",
    proves=_RADIUS,
    radius=True,
)
MATRIX_NORMS = Rule(
    "SD606",
    "matrix-norms",
    "Dyn 1992, Propositions 6.8 and 6.10, Theorems 6.9 and 7.5",
    proves=frozenset({"matrix-norm"}),
)
DIRECTIONAL_SMOOTHNESS = Rule(
    "SD607",
    "directional-smoothness",
    "Dyn 1992, Corollary 7.9 and Proposition 6.10",
    proves=frozenset({"smooth"}),
)
POSITIVE_MASK = Rule("SD608", "positive-mask", "Dyn 1992, Theorem 6.4", proves=frozenset({"convergent"}), holds=True)
TENSOR_PRODUCT = Rule("SD609", "tensor-product", "Dyn 1992, Proposition 6.3", proves=frozenset({"tensor-product"}))
CONVERGENCE = Rule(
    "SD611",
    "surface-convergence",
    "Han & Jia 1998, Theorem 4.3; Dyn 1992, section 6",
    answers=(questions.CONVERGENCE,),
    proves=frozenset({"convergent"}),
    holds=True,
)
SMOOTHNESS = Rule(
    "SD612",
    "surface-smoothness",
    f"Jia 1998; Han 2003; {_BOX_SPLINES}, I.36",
    answers=(questions.SMOOTHNESS,),
    proves=frozenset({"smooth", "not-smooth"}),
)
NEXT_SMOOTHNESS = Rule(
    "SD613",
    "surface-next-smoothness",
    f"Jia 1998; {_BOX_SPLINES}, I.36",
    answers=(questions.NEXT_SMOOTHNESS,),
    proves=frozenset({"not-smooth"}),
)
HOLDER_LOWER = Rule(
    "SD614",
    "surface-holder-lower",
    f"Jia 1998; Han 2003; {_BOX_SPLINES}, I.36",
    answers=(questions.HOLDER_LOWER,),
    proves=_RADIUS - {"family"} | {"holder-lower", "holder-root", "holder-value", "of-factor"},
)
HOLDER_UPPER = Rule(
    "SD615",
    "surface-holder-upper",
    f"Jia 1998; Han 2003; {_BOX_SPLINES}, I.36",
    answers=(questions.HOLDER_UPPER,),
    proves=frozenset({"holder-upper", "holder-root", "holder-value", "of-factor", "at-most-factor"}),
)
STABILITY = Rule(
    "SD616",
    "surface-stability",
    f"Jia & Micchelli 1991; {_BOX_SPLINES}, II.57",
    answers=(questions.STABILITY,),
    proves=frozenset({"stable"}),
    holds=True,
)
SOBOLEV = Rule(
    "SD617",
    "surface-sobolev",
    f"Jia 1999; Han 2003; {_BOX_SPLINES}, chapter I",
    answers=(questions.SOBOLEV,),
    proves=frozenset({"sobolev", "sobolev-lower", "sobolev-value", "of-factor"}),
)
REPRODUCTION = Rule(
    "SD618",
    "surface-reproduction",
    "Levin 2003, section 2; Conti & Hormann 2011; Charina & Conti 2013",
    answers=(questions.REPRODUCTION,),
    proves=frozenset({"reproduction"}),
)
QUASI_INTERPOLATION = Rule(
    "SD619",
    "surface-quasi-interpolation",
    "Levin 2003, Corollary 2.4 and section 2.5",
    answers=(questions.QUASI_INTERPOLATION,),
    proves=frozenset({"quasi-interpolation"}),
)

RULES = table(
    COSET_SUMS,
    SUM_RULES,
    BOX_SPLINE,
    DIRECTIONAL_NORMS,
    DIFFERENCE_RADIUS,
    MATRIX_NORMS,
    DIRECTIONAL_SMOOTHNESS,
    POSITIVE_MASK,
    TENSOR_PRODUCT,
    CONVERGENCE,
    SMOOTHNESS,
    NEXT_SMOOTHNESS,
    HOLDER_LOWER,
    HOLDER_UPPER,
    STABILITY,
    SOBOLEV,
    REPRODUCTION,
    QUASI_INTERPOLATION,
)
