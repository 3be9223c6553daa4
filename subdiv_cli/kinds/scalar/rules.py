"""The codes of scalar schemes: a row for each, with its source, the questions it answers and what its claims state."""

from __future__ import annotations

from subdiv_cli.model import Rule
from subdiv_cli.model import findings as questions
from subdiv_cli.model.findings import table

_RADIUS = frozenset({"norm", "product", "family", "radius", "bounded", "radius-upper"})

RESIDUE_SUMS = Rule(
    "SD101",
    "residue-sums",
    "Dyn 1992, Proposition 2.1",
    answers=(questions.SUMS,),
    proves=frozenset({"residue-sums"}),
)
SUM_RULES = Rule(
    "SD102",
    "sum-rule-order",
    "Dyn 1992, (3.15)",
    answers=(questions.SUM_RULES,),
    proves=frozenset({"sum-rules"}),
)
GENERATION = Rule(
    "SD103",
    "generation-degree",
    "Levin 2003, section 2",
    answers=(questions.GENERATION,),
    proves=frozenset({"generation", "sum-rules"}),
)
REPRODUCTION = Rule(
    "SD104",
    "reproduction-degree",
    "Conti & Hormann 2011",
    answers=(questions.REPRODUCTION,),
    proves=frozenset({"reproduction", "sum-rules"}),
)
DERIVED_SCHEMES = Rule(
    "SD105",
    "derived-schemes",
    "Dyn 1992, Proposition 3.1 and (3.17)",
    proves=frozenset({"derived", "sum-rules"}),
)
CONVERGENCE = Rule(
    "SD201",
    "convergence",
    "Dyn 1992, Theorem 3.2",
    answers=(questions.CONVERGENCE,),
    proves=frozenset({"convergent"}),
    holds=True,
)
EIGEN_CONDITION = Rule(
    "SD202",
    "eigenvalue-condition",
    "Dyn 1992, Theorem 4.2",
    answers=(questions.EIGEN_CONDITION,),
    proves=frozenset({"eigen-condition"}),
    holds=True,
)
CONTRACTIVITY = Rule(
    "SD301",
    "contractivity",
    "Dyn 1992, Theorems 3.2 and 3.4",
    proves=_RADIUS | {"sum-rules"},
)
SMOOTHNESS = Rule(
    "SD302",
    "smoothness",
    "Dyn 1992, Theorem 3.4",
    answers=(questions.SMOOTHNESS,),
    proves=frozenset({"smooth", "not-smooth"}),
)
NEXT_SMOOTHNESS = Rule(
    "SD303",
    "next-smoothness",
    "Cavaretta, Dahmen & Micchelli 1991; Dyn 1992, Theorem 5.3",
    answers=(questions.NEXT_SMOOTHNESS,),
    proves=frozenset({"not-smooth"}),
)
SMOOTHNESS_SPECTRUM = Rule(
    "SD304",
    "smoothness-spectrum",
    "Dyn 1992, Theorem 4.2 and (4.12)",
    proves=frozenset({"eigen-condition", "sum-rules"}),
)
JOINT_RADIUS = Rule(
    "SD310",
    "joint-spectral-radius",
    "Rota & Strang 1960; Guglielmi, Wirth & Zennaro 2005; Dyn 1992, section 4",
    proves=_RADIUS,
    radius=True,
)
HOLDER_LOWER = Rule(
    "SD311",
    "holder-lower",
    "Dyn 1992, section 3; Rioul 1992",
    answers=(questions.HOLDER_LOWER,),
    proves=frozenset({"holder-lower", "holder", "holder-root"}),
)
HOLDER_UPPER = Rule(
    "SD312",
    "holder-upper",
    "Cavaretta, Dahmen & Micchelli 1991; Rioul 1992",
    answers=(questions.HOLDER_UPPER,),
    proves=frozenset({"holder-upper", "holder", "holder-root"}),
)
HOLDER_ATTAINED = Rule(
    "SD313",
    "holder-attained",
    "Rioul 1992; Dyn 1992, section 3",
    answers=(questions.HOLDER_ATTAINED,),
    proves=frozenset({"attained"}),
    holds=True,
)
SOBOLEV = Rule(
    "SD321",
    "sobolev-exponent",
    "Villemoes 1992; Jia 1999",
    answers=(questions.SOBOLEV,),
    proves=frozenset({"sobolev"}),
)
INDEPENDENCE = Rule(
    "SD401",
    "linear-independence",
    "Jia & Wang 1993; Zhou 1996",
    answers=(questions.INDEPENDENCE,),
    proves=frozenset({"independent"}),
    holds=True,
)
STABILITY = Rule(
    "SD402",
    "stability",
    "Jia & Wang 1993; Zhou 1996",
    answers=(questions.STABILITY,),
    proves=frozenset({"stable"}),
    holds=True,
)
REDUCTION = Rule("SD403", "reduction", "Jia & Wang 1993; Zhou 1996", proves=frozenset({"reduction"}))
INTEGER_VALUES = Rule(
    "SD501", "integer-values", "Dyn 1992, Theorem 4.2 and Corollary 4.6", proves=frozenset({"values"})
)
LIMIT_STENCILS = Rule(
    "SD502", "limit-stencils", "Dyn 1992, Corollaries 4.3 and 4.6", proves=frozenset({"convergent", "values"})
)
QUASI_INTERPOLATION = Rule(
    "SD503",
    "quasi-interpolation",
    "Levin 2003, Corollary 2.4 and section 2.5",
    answers=(questions.QUASI_INTERPOLATION,),
    proves=frozenset({"quasi-interpolation"}),
)
APPROXIMATION_ORDER = Rule(
    "SD504",
    "approximation-order",
    "Levin 2003, Theorem 2.7",
    proves=frozenset({"quasi-interpolation", "reproduction"}),
)
INTERPOLATORY_ORDER = Rule("SD505", "interpolatory-order", "Dyn 1992, Theorem 5.1", proves=frozenset({"not-smooth"}))
ERROR_BOUND = Rule("SD511", "error-bound", "Dyn 1992, Corollary 3.3", proves=frozenset({"error-bound", "levels"}))
HERMITE_BOUND = Rule("SD512", "hermite-bound", "Dyn 1992, Proposition 4.7", proves=frozenset({"hermite-bound"}))

RULES = table(
    RESIDUE_SUMS,
    SUM_RULES,
    GENERATION,
    REPRODUCTION,
    DERIVED_SCHEMES,
    CONVERGENCE,
    EIGEN_CONDITION,
    CONTRACTIVITY,
    SMOOTHNESS,
    NEXT_SMOOTHNESS,
    SMOOTHNESS_SPECTRUM,
    JOINT_RADIUS,
    HOLDER_LOWER,
    HOLDER_UPPER,
    HOLDER_ATTAINED,
    SOBOLEV,
    INDEPENDENCE,
    STABILITY,
    REDUCTION,
    INTEGER_VALUES,
    LIMIT_STENCILS,
    QUASI_INTERPOLATION,
    APPROXIMATION_ORDER,
    INTERPOLATORY_ORDER,
    ERROR_BOUND,
    HERMITE_BOUND,
)
