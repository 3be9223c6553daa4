"""The stages of Hermite schemes: those of vector schemes for the limit, and those on derivatives (SD714 to SD716)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction

from subdiv_cli.exact.linalg import rows_of
from subdiv_cli.exact.text import number
from subdiv_cli.kinds.hermite.numbers import HermiteNumbers
from subdiv_cli.kinds.hermite.rules import HERMITE_CONVERGENCE, JET_RADIUS, SPECTRAL_CONDITION, TAYLOR_SCHEME
from subdiv_cli.kinds.hermite.witnesses import HermiteConvergenceWitness, SpectralConditionWitness, TaylorProof
from subdiv_cli.kinds.kind import Analysis, Facts, Stage, asking, run_stages
from subdiv_cli.kinds.scalar.stages.joint_radius import threshold
from subdiv_cli.kinds.scalar.stages.wording import product_name
from subdiv_cli.kinds.vector.numbers.derived import derivation
from subdiv_cli.kinds.vector.rules import CONSTANTS, CONVERGENCE
from subdiv_cli.kinds.vector.scheme import VectorScheme
from subdiv_cli.kinds.vector.stages import convergence, smoothness
from subdiv_cli.kinds.vector.stages.convergence import TOO_LARGE, radius_finding, space_data
from subdiv_cli.kinds.vector.stages.smoothness import (
    NOT_CONTRACTING,
    contracts,
    dense,
    derived_masks,
    most_derivations,
)
from subdiv_cli.kinds.vector.witnesses import VectorDerivedWitness
from subdiv_cli.model import Data, Effort, Finding, Verdict
from subdiv_cli.model import findings as questions


def spectral_condition(numbers: HermiteNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD714: the spectral condition: jets y_j = (f_j, f_j', …), f_j = x^j/j! + …, with S y_j = p^-j y_j, j < d.

    Of a Hermite scheme with d components (Dubuc & Merrien 2009; for d = 2 Moosmüller & Dyn 2018, (28), Lemma 28). The
    φ_j of f_j = Σ_l φ_l x^(j-l)/(j-l)! are unique (numbers.py); higher degrees are looked for until there is none. It
    is neither necessary nor sufficient for Hermite convergence, but necessary where S is interpolatory: SD716
    does not rest on it. No hypothesis.

    Witness: `order`, the number of degrees; `shifts`, 1, φ_1, …
    """
    (k, shifts), d = numbers.jets, numbers.size
    witness: SpectralConditionWitness = {"order": k, "shifts": shifts}
    if k >= d:
        why = f"shifts {', '.join(map(number, shifts[1:]))}"
        statement = f"the spectral condition holds up to degree {k - 1}, and no further: {why}"
        return (SPECTRAL_CONDITION.proved(statement, witness, why=why),)
    why = f"no jet of degree {k} is an eigen-sequence" if k else f"{_first(d)} is not reproduced as constant"
    return (SPECTRAL_CONDITION.refuted(f"the spectral condition does not hold: {why}", witness, why=why),)


def _first(d: int) -> str:
    """The vector e_0 = (1, 0, …) as text."""
    return f"(1{', 0' * (d - 1)})"


def vector_convergence(numbers: HermiteNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD705, whether S converges as a scheme of vectors: a step to SD716, which answers for a Hermite scheme."""
    (finding,) = convergence.convergence(numbers, facts)
    if finding.verdict is Verdict.PROVED and numbers.is_function:
        statement = f"D^n c^n converges uniformly, to functions f {_first(numbers.size)}: {finding.why}"
        finding = replace(finding, statement=statement)
    return (replace(finding, answers=()),)


_RADIUS_QUESTION = "how fast do data approach the derivatives of the limit?"


@asking((JET_RADIUS, _RADIUS_QUESTION))
def jet_radius(numbers: HermiteNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD715: σ_j, the joint spectral radius of the T_ε on U_j, for the derivatives j = 1, …, d-1.

    U_j is the smallest space that holds e_j δ - ∇^j w and ∇^(j+1) w and is mapped into itself (theorem 5 of
    spaces/stencils.py): images of the first are what lies between the j-th components and the j-th differences of the
    limit. Found and proved as SD310 says. Hypotheses: S converges as a scheme of vectors (SD705), and E_A is spanned
    by e_0 (SD701): checked. A derivative after one that refutes is not asked for.

    Witness: `order`, j; `dimension`; `method`; `word` of a product; `length` and `bound`, or `length` and `root`.
    `proof`: `space` and `radius`.
    """
    if facts.verdict(CONVERGENCE) is not Verdict.PROVED:
        return (JET_RADIUS.skipped(_RADIUS_QUESTION, "it is not proved that S converges"),)
    if not numbers.is_function:
        return (JET_RADIUS.skipped(_RADIUS_QUESTION, f"E_A is not spanned by {_first(numbers.size)}"),)
    findings = []
    for j in range(1, numbers.size):
        if (growth := numbers.jet_growth(j)) is None:
            findings.append(JET_RADIUS.undecided(f"how fast do components {j} approach derivatives?", TOO_LARGE))
            continue
        findings.append(radius_finding(JET_RADIUS, growth, f"σ_{j}", space_data(growth.on)))
        if growth.product is not None and growth.product.compare(Fraction(1, numbers.p**j)) >= 0:
            break
    return tuple(findings)


_CONVERGENCE_QUESTION = "do data tend to a function and its derivatives?"


@asking((HERMITE_CONVERGENCE, _CONVERGENCE_QUESTION))
def hermite_convergence(numbers: HermiteNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD716: whether S is HC^(d-1), d the number of components: D^-n S^n c tends to f, f', …, f^(d-1), not all f = 0.

    Theorem 5 of spaces/stencils.py, for any arity and any d: it is iff S converges as a scheme of vectors (SD705), E_A
    is spanned by e_0 (SD701), and σ_j < p^-j for j = 1, …, d-1 (SD715). No further hypothesis.

    Witness: `order`, d - 1; `by`, refuted: SD701, SD705, or SD715 with the `derivative` j and the `word` of a product.
    """
    d, p = numbers.size, numbers.p
    if not numbers.is_function:
        return (_diverges({"order": d - 1, "by": CONSTANTS.code}, f"E_A is not spanned by {_first(d)}"),)
    if facts.verdict(CONVERGENCE) is Verdict.REFUTED:
        why = f"D^n c^n does not converge: {facts[CONVERGENCE].why}"
        return (_diverges({"order": d - 1, "by": CONVERGENCE.code}, why),)
    radii = facts.all(JET_RADIUS)
    growths = {
        j: growth
        for j in (JET_RADIUS.witness_of(finding)["order"] for finding in radii if finding.verdict is Verdict.PROVED)
        if (growth := numbers.jet_growth(j)) is not None
    }
    for j, growth in growths.items():
        if growth.product is not None and growth.product.compare(Fraction(1, p**j)) >= 0:
            why, word = f"{product_name(growth.product.word)} keeps σ_{j} ≥ {threshold(p, j)}", growth.product.word
            return (_diverges({"order": d - 1, "by": JET_RADIUS.code, "derivative": j, "word": word}, why),)
    if len(growths) < d - 1 or not all(growth.radius.is_below(Fraction(1, p**j)) for j, growth in growths.items()):
        reasons = [finding.reason for finding in radii if finding.reason is not None]
        unknown = "a bound of a σ_j is missing, and no product is known that keeps it above"
        return (HERMITE_CONVERGENCE.undecided(_CONVERGENCE_QUESTION, reasons[0] if reasons else unknown),)
    why = " and ".join(f"σ_{j} < {threshold(p, j)}" for j in range(1, d))
    data = "f and f'" if d == 2 else f"f, …, f^({d - 1})"
    statement = f"S is HC^{d - 1}, data tend to {data}: {why}"
    witness: HermiteConvergenceWitness = {"order": d - 1, "by": JET_RADIUS.code}
    return (HERMITE_CONVERGENCE.proved(statement, witness, answers={questions.DERIVATIVES: d - 1}, why=why),)


def _diverges(witness: HermiteConvergenceWitness, why: str) -> Finding:
    return HERMITE_CONVERGENCE.refuted(f"S is not HC^{witness['order']}: {why}", witness, why=why)


_TAYLOR_QUESTION = "does a scheme contract that is derived from the Taylor scheme?"


@asking((TAYLOR_SCHEME, _TAYLOR_QUESTION))
def taylor_scheme(numbers: HermiteNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD717: the Taylor scheme, and those derived from it, a second proof of Hermite convergence and smoothness.

    T S_A = p^-(d-1) S_B T for the Taylor mask B (taylor.py, with the theorem). If the n-th scheme that is derived from
    B contracts, S_B is C^(n-1) (SD713), so that S is HC^(d-1) with functions in C^(d+n-2). Hypotheses: E_A is spanned
    by e_0, there is a Taylor mask, E_B is spanned by e_(d-1): checked. It is sufficient, so that SD708 may say more.

    Witness: as SD713, `order` d+n-2. `proof`: as SD713, with the Taylor mask, from its `start`, as `taylor`.
    """
    d, p = numbers.size, numbers.p
    if not numbers.is_function:
        return (TAYLOR_SCHEME.skipped(_TAYLOR_QUESTION, f"E_A is not spanned by {_first(d)}"),)
    if facts.verdict(HERMITE_CONVERGENCE) is Verdict.REFUTED:
        return (TAYLOR_SCHEME.skipped(_TAYLOR_QUESTION, f"S is not HC^{d - 1}"),)
    mask = numbers.taylor
    if mask is None:
        return (TAYLOR_SCHEME.undecided(_TAYLOR_QUESTION, "there is no Taylor scheme"),)
    steps = derivation(p, mask, max(most_derivations(facts) - d + 1, 1), numbers.effort)
    if not steps.on_line(d - 1):
        reason = f"E_B is not spanned by e_{d - 1}, or 1 is an eigenvalue of M_B more than once, B the Taylor mask"
        return (TAYLOR_SCHEME.undecided(_TAYLOR_QUESTION, reason),)
    n = steps.contracting
    if not n:
        return (TAYLOR_SCHEME.undecided(_TAYLOR_QUESTION, NOT_CONTRACTING),)
    why, (level, norm) = contracts(p, steps, "B")
    witness: VectorDerivedWitness = {"derivations": n, "level": level, "norm": norm, "order": d + n - 2}
    taylor = tuple(map(rows_of, dense(mask)))
    proof: TaylorProof = {**derived_masks(steps), "start": min(mask), "taylor": taylor}
    statement = f"S is HC^{d - 1}, with functions in C^{d + n - 2}, as {why}, B the Taylor mask"
    return (TAYLOR_SCHEME.proved(statement, witness, proof=proof, why=why),)


def _of_function(stage: Stage) -> Stage:
    """The stage where the exponent of all limits of the scheme of vectors is that of the function component."""

    def run(numbers: HermiteNumbers, facts: Facts) -> tuple[Finding, ...]:
        return stage(numbers, facts) if numbers.has_function else ()

    return run


STAGES: tuple[Stage, ...] = (
    convergence.constants,
    convergence.eigen_sequences,
    convergence.mean_matrix,
    spectral_condition,
    convergence.decay_radius,
    vector_convergence,
    convergence.limit_stencils,
    jet_radius,
    hermite_convergence,
    *map(
        _of_function,
        (smoothness.stencil_radius, smoothness.smoothness, smoothness.holder, smoothness.holder_attained),
    ),
    taylor_scheme,
)


def analyse(scheme: VectorScheme, effort: Effort, _: Fraction | None = None) -> Analysis:
    """The findings of all stages under the effort."""
    numbers = HermiteNumbers(scheme, effort)
    findings = run_stages(numbers, STAGES)
    return Analysis(scheme, facts(scheme), findings, numbers, tuple(hints(numbers, Facts(findings))))


def facts(scheme: VectorScheme) -> Mapping[str, Data]:
    """The facts that are seen without a theorem; interpolatory is A_0 = D, and A_(pi) = 0 for i ≠ 0."""
    last, p = scheme.start + len(scheme.coefficients) - 1, scheme.arity
    at_multiples = [a for i, a in enumerate(scheme.coefficients, scheme.start) if not i % p and i]
    centre = scheme.coefficients[-scheme.start] if scheme.start <= 0 <= last else ()
    d = tuple(tuple(Fraction(int(k == l), p**k) for l in range(scheme.size)) for k in range(scheme.size))
    return {
        "arity": p,
        "support": (scheme.start, last),
        "size": scheme.size,
        "interpolatory": centre == d and not any(any(map(any, a)) for a in at_multiples),
    }


def hints(numbers: HermiteNumbers, facts: Facts) -> Iterator[str]:
    """The sentences on rows that are not scaled by D, and on components that tend to a multiple of a derivative."""
    if facts.verdict(HERMITE_CONVERGENCE) is Verdict.REFUTED:
        yield from _unscaled(numbers)
        yield from _multiple(numbers, facts.witness(HERMITE_CONVERGENCE).get("derivative"))


def _unscaled(numbers: HermiteNumbers) -> Iterator[str]:
    """The sentence on a mask A_i that has not the spectral condition where D A_i has it."""
    scheme, p = numbers.scheme, numbers.p
    rows = tuple(tuple(tuple(x / p**j for x in row) for j, row in enumerate(a)) for a in scheme.coefficients)
    scaled = HermiteNumbers(replace(scheme, coefficients=rows), numbers.effort)
    if numbers.jets.order < scheme.size <= scaled.jets.order:
        each = f"row 1 times 1/{p}" if scheme.size == 2 else f"row j times {p}^-j, j = 0, …, {scheme.size - 1},"
        yield (
            f"with {each} the spectral condition holds: are these rows for derivatives themselves? The matrices act "
            f"on h^j f^(j), as subdiv explain hermite says"
        )


def _multiple(numbers: HermiteNumbers, j: int | None) -> Iterator[str]:
    """The sentence on a component j that tends to a multiple of the derivative.

    An eigen-sequence S y = p^-j y with y_0 = x^j/j! + … has y_j for the j-th component of all D^-n S^n y, where a
    Hermite scheme has the derivative 1.
    """
    sequences = numbers.sequences
    if j is None or sequences is None or not numbers.jets.order <= j < sequences.order:
        return
    (y,) = sequences.each[j]
    leading = y[j][0]
    for i in range(2, j + 1):
        leading *= i
    c = y[0][j] / leading
    if c == 1 or any(coefficient[j] for coefficient in y[1:]):
        return
    if c == 0:
        yield f"data of x^{j} have the component {j} zero at all levels: it does not tend to a derivative"
        return
    diagonal = ", ".join("1" if i != j else number(c) for i in range(numbers.size))
    yield (
        f"component {j} of the data of x^{j} is {number(c)} times the derivative: with R = diag({diagonal}) the mask "
        f"R^-1 A_i R has the derivative itself"
    )
