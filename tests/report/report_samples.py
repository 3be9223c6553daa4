"""Results written by hand, for the tests of the formats: they need no mask, no stage and no flint."""

from fractions import Fraction

from subdiv_cli.kinds.scalar.rules import rules
from subdiv_cli.model import (
    Expectation,
    Exponent,
    Finding,
    Interval,
    Judgement,
    Log,
    Problem,
    Result,
    Smoothness,
    Verdict,
)


def finding(*, code, **fields):
    """A finding of a scalar mask by hand, which answers what its rule answers."""
    return Finding(code=code, answers=tuple((asked, None) for asked in rules()[code].answers), **fields)


P, R, U, S = Verdict.PROVED, Verdict.REFUTED, Verdict.UNDECIDED, Verdict.SKIPPED


def judged(key, text, lower, verdict, upper=None):
    return Judgement(expectation=Expectation(key=key, text=text, lower=lower, upper=upper), verdict=verdict)


FOUR_POINT = Result(
    file="masks/scalar/four-point.toml",
    status="passed",
    name="four-point scheme",
    kind="scalar",
    parameters={"w": Fraction(1, 16)},
    reference="Dyn, Gregory, Levin 1987",
    facts={
        "arity": 2,
        "support": (-3, 3),
        "coefficients": 5,
        "symmetry": "symmetric",
        "centre": Fraction(0),
        "type": "primal",
        "interpolatory": True,
        "nonnegative": False,
        "gaps": (-2, 2),
    },
    sum_rule_order=4,
    convergent=P,
    smoothness=Smoothness(order=1, sharp=True),
    refinable=Smoothness(order=1, sharp=True),
    holder=Exponent(lower=1.9, upper=2.0),
    stable=P,
    linearly_independent=P,
    generation=3,
    reproduction=3,
    expectations=(judged("convergent", "true", True, P), judged("smoothness", "1", 1, P, 1)),
    findings=(
        finding(
            code="SD101",
            name="residue-sums",
            verdict=P,
            statement="every residue class mod 2 sums to 1",
            source="Dyn 1992, (2.7)",
            witness={"sums": (Fraction(1), Fraction(1))},
        ),
        finding(
            code="SD102",
            name="sum-rule-order",
            verdict=P,
            statement="the symbol has the factor (1+z)^4 and no higher power: order 4",
            why="the symbol has the factor (1+z)^4 and no higher power",
            source="Dyn 1992, section 3",
            witness={"cofactor": {"start": -3, "coefficients": (Fraction(-1, 16), Fraction(1, 4), Fraction(-1, 16))}},
        ),
        finding(
            code="SD201",
            name="convergence",
            verdict=P,
            statement="‖(1/2)S_1‖∞ = 5/8 < 1, so S converges uniformly",
            why="‖(1/2)S_1‖∞ = 5/8 < 1",
            source="Dyn 1992, Theorem 3.2",
            value=Interval(lower=0.625, upper=0.625, exact="5/8"),
            witness={"level": 1, "norm": Fraction(5, 8)},
        ),
        finding(
            code="SD302",
            name="smoothness",
            verdict=P,
            statement="‖((1/2)S_2)^2‖∞ = 3/4 < 1, so every limit function is C^1",
            why="‖((1/2)S_2)^2‖∞ = 3/4 < 1",
            source="Dyn 1992, Theorem 3.4",
            witness={"nu": 2, "level": 2, "norm": Fraction(3, 4)},
        ),
        finding(
            code="SD303",
            name="next-smoothness",
            verdict=R,
            statement="C^2 would need an eigenvalue below 1/4 where T_0 has 1/4, and the mask is interpolatory",
            why="C^2 would need an eigenvalue below 1/4 where T_0 has 1/4",
            source="Dyn 1992, Theorem 5.3",
            witness={"word": (0,), "factor": "z - 1/4"},
        ),
        finding(
            code="SD311",
            name="holder-lower",
            verdict=P,
            statement="α ≥ −log2(‖S_{Δ^4}^6‖∞)/6 ≥ 1.9",
            why="−log2(‖S_{Δ^4}^6‖∞)/6 ≥ 1.9",
            source="Dyn 1992, section 3",
        ),
        finding(
            code="SD312",
            name="holder-upper",
            verdict=P,
            statement="α ≤ −log2 ρ(T_0) = 2",
            why="−log2 ρ(T_0) = 2",
            source="Dyn 1992, section 4",
        ),
        finding(
            code="SD402",
            name="stability",
            verdict=P,
            statement="an interpolatory mask is stable: φ(k) = δ_k",
            why="φ(k) = δ_k",
            source="Dyn 1992, section 5",
        ),
    ),
)

DIVERGENT = Result(
    file="masks/scalar/half.toml",
    status="failed",
    name="halved Chaikin",
    kind="scalar",
    convergent=R,
    sum_rule_order=0,
    expectations=(judged("convergent", "true", True, R), judged("holder", "1.99 .. 2.01", Fraction(199, 100), U)),
    findings=(
        finding(
            code="SD101",
            name="residue-sums",
            verdict=R,
            statement="the residue classes sum to 1/2, 1/2, must be 1 (normalised to a(1) = 1? multiply by 2)",
            source="Dyn 1992, (2.7)",
        ),
        finding(
            code="SD301",
            name="contractivity",
            verdict=S,
            statement="is (1/2)S_1 contractive?",
            reason="S_1 does not exist: the residue sums are not 1",
            source="Dyn 1992, Theorem 3.2",
        ),
    ),
)

UNDECIDED = Result(
    file="masks/scalar/six-point.toml",
    status="undecided",
    name="Deslauriers–Dubuc, 6 points",
    kind="scalar",
    sum_rule_order=6,
    stopped="budget",
    convergent=P,
    smoothness=Smoothness(order=2),
    refinable=Smoothness(order=2),
    holder=Exponent(
        lower=2.8300749985, upper=2.8300749986, exact=Log(base=2, argument=Fraction(64, 9)), attained=False
    ),
    stable=U,
    generation=5,
    expectations=(judged("smoothness", ">= 3", 3, U),),
    findings=(
        finding(
            code="SD303",
            name="next-smoothness",
            verdict=U,
            statement="is every limit function C^3?",
            reason="no level up to 9 is below 1 within the effort of 20000; refuting it needs a stable φ",
            source="Dyn 1992, Theorem 3.4",
        ),
    ),
)

INVALID = Result(
    file="masks/broken.toml",
    status="invalid",
    problems=(
        Problem(
            code="SD003",
            message="fraction not quoted: TOML has no fractions",
            help='write exact coefficients as strings: "-1/16"',
            file="masks/broken.toml",
            key="mask.coefficients[0]",
            line=3,
            column=19,
            source='coefficients = [-1/16, 0, "9/16"]',
        ),
        Problem(code="SD005", message="the key `name` must be text", file="masks/broken.toml", key="name"),
    ),
)

ALL = (FOUR_POINT, DIVERGENT, UNDECIDED, INVALID)
