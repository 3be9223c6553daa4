"""Witnesses have the form that their rule declares: the keys, and the types of the values, of every finding."""

import ast
from collections import defaultdict
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path
from types import NoneType, UnionType
from typing import TypedDict, Union, get_args, get_origin, get_type_hints, is_typeddict

import pytest
from support import multivariate_scheme, shipped_multivariate

import subdiv_cli
from subdiv_cli.catalog import masks_directory
from subdiv_cli.kinds import kind_of
from subdiv_cli.kinds.hermite import rules as hermite
from subdiv_cli.kinds.matrices import rules as matrices
from subdiv_cli.kinds.multivariate import rules as multivariate
from subdiv_cli.kinds.multivariate import witnesses as w
from subdiv_cli.kinds.option import from_option
from subdiv_cli.kinds.piecewise import rules as piecewise
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.kinds.scalar import rules as scalar
from subdiv_cli.kinds.vector import rules as vector
from subdiv_cli.model import DECIDED, Effort, proofs
from subdiv_cli.model.findings import proof_of, row
from subdiv_cli.model.proofs import RadiusProof

PACKAGE = Path(subdiv_cli.__file__).parent

TABLES = (scalar, multivariate, matrices, vector, hermite, piecewise)
RULES = {code: rule for table in TABLES for code, rule in table.rules().items()}
PROOFS = {
    scalar.JOINT_RADIUS.code: RadiusProof,
    scalar.HOLDER_ATTAINED.code: RadiusProof,
    matrices.CONVERGENCE.code: RadiusProof,
    matrices.COMPONENTS.code: matrices.w.ComponentsProof,
    matrices.DIFFERENCE_RADIUS.code: matrices.w.CurveRadiusProof,
    matrices.JOINTS.code: matrices.w.JointsProof,
    multivariate.DIFFERENCE_RADIUS.code: w.DifferenceRadiusProof,
    multivariate.DIRECTIONAL_NORMS.code: w.QuotientsProof,
    multivariate.DIRECTIONAL_SMOOTHNESS.code: w.QuotientsProof,
    multivariate.MATRIX_NORMS.code: w.MatrixNormsProof,
    multivariate.STABILITY.code: w.GramProof,
    multivariate.STENCIL_RADIUS.code: w.StencilRadiusProof,
    vector.EIGEN_SEQUENCES.code: vector.w.EigenSequencesProof,
    vector.DECAY_RADIUS.code: vector.w.SequenceRadiusProof,
    vector.STENCIL_RADIUS.code: vector.w.SequenceRadiusProof,
    vector.HOLDER_ATTAINED.code: vector.w.VectorAttainedProof,
    vector.DERIVED_SCHEMES.code: vector.w.VectorDerivedProof,
    hermite.TAYLOR_SCHEME.code: hermite.w.TaylorProof,
    hermite.JET_RADIUS.code: vector.w.SequenceRadiusProof,
}
"""The forms of further data, of other rules those of mean squares."""
UNSEEN = {("SD201", key) for key in ("eigenvalues", "matrix")}
UNSEEN |= {(code, "bound") for code in ("SD621", "SD704", "SD707", "SD710", "SD715", "SD811", "SD818")}
"""A mask that fails its eigen-condition has a product that shows it too, which comes first; radii are known exactly."""


def fits(value, form) -> bool:
    """Whether a value is of a type, down to the last number; no float is of any."""
    if is_typeddict(form):
        hints, required = get_type_hints(form), form.__required_keys__
        keys = isinstance(value, Mapping) and required <= value.keys() <= hints.keys()
        return keys and all(fits(each, hints[key]) for key, each in value.items())
    if get_origin(form) in (Union, UnionType):
        return any(fits(value, each) for each in get_args(form))
    if get_origin(form) is tuple:
        parts = get_args(form)
        if not isinstance(value, tuple):
            return False
        if parts[-1] is Ellipsis:
            return all(fits(each, parts[0]) for each in value)
        return len(value) == len(parts) and all(map(fits, value, parts))
    return type(value) is (NoneType if form is None else form)


def unstable_butterfly():
    """The butterfly scheme times 1 - z1 + z1^2, which makes φ into φ + φ(· - e1) + φ(· - 2 e1)."""
    terms = defaultdict(Fraction)
    for (i, j), x in shipped_multivariate("butterfly").terms.items():
        for k, sign in enumerate((1, -1, 1)):
            terms[i + k, j] += sign * x
    return multivariate_scheme({at: x for at, x in terms.items() if x})


def analyses():
    """The findings of masks of all sorts: the catalog, some of them under little effort, and taken apart."""
    for path in sorted(masks_directory().rglob("*.toml")):
        scheme = read_path(path).scheme({})
        yield kind_of(scheme).analyse(scheme, Effort(600)).findings
        if scheme.kind == "scalar":
            yield kind_of(scheme).portraits.analyse(scheme, Effort(1000), Fraction(1, 100)).findings
    for mask, work in (("[-9, -3, 2, 6, 5, 1, 6]/4", 300), ("[1, 1]", 300)):
        scheme = from_option(mask, start=0).scheme({})
        yield kind_of(scheme).analyse(scheme, Effort(work)).findings
    apart = multivariate_scheme({(0, 0): Fraction(1, 2), (3, 0): 1, (6, 0): Fraction(1, 2)}, ((1, 1), (1, -1)))
    doubled = read_path(masks_directory() / "multivariate" / "butterfly_doubled.toml").scheme({"w": Fraction(1, 16)})
    for scheme in (unstable_butterfly(), apart, doubled, shipped_multivariate("kobbelt_sqrt3")):
        yield kind_of(scheme).analyse(scheme, Effort(2000)).findings


def test_every_witness_has_the_form_of_its_rule():
    seen = set()
    for findings in analyses():
        for finding in (each for first in findings for each in (first, *first.otherwise)):
            form = RULES[finding.code].witness
            if finding.verdict in DECIDED or finding.witness:
                assert fits(finding.witness, form), (finding, form)
                assert RULES[finding.code].witness_of(finding) is finding.witness
            if finding.proof:
                form = PROOFS.get(finding.code, w.GrowthProof)
                assert fits(proof_of(finding, form), form), (finding.code, form)
            seen |= {(finding.code, key) for key in finding.witness}
    declared = {(code, key) for code, rule in RULES.items() for key in get_type_hints(rule.witness)}
    assert seen == declared - UNSEEN


def looked_for():
    """The keys in `"key" in x` and `x.get("key")`, with their places: there mypy sees no misspelt one."""
    rooms = [*PACKAGE.glob("kinds/*/claims"), *PACKAGE.glob("kinds/*/stages"), PACKAGE / "jsr"]
    files = [*PACKAGE.glob("kinds/*/claims.py"), PACKAGE / "certificate" / "radius.py"]
    for file in [*(file for room in rooms for file in room.glob("*.py")), *files]:
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            key = None
            if isinstance(node, ast.Compare) and isinstance(node.ops[0], ast.In | ast.NotIn):
                key = node.left
            elif isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "get":
                key = node.args[0]
            if isinstance(key, ast.Constant) and isinstance(key.value, str) and key.value.isidentifier():
                yield key.value, f"{file.relative_to(PACKAGE)}:{node.lineno}"


def test_keys_that_are_looked_for_are_declared():
    forms = [
        form
        for module in (scalar.w, w, matrices.w, piecewise.w, proofs)
        for form in vars(module).values()
        if is_typeddict(form)
    ]
    declared = {key for form in forms for key in get_type_hints(form)} | {"mask"}  # a statement's
    places = dict(looked_for())
    assert {"root", "tree", "sizes", "part", "sigma"} <= places.keys()
    assert {key: place for key, place in places.items() if key not in declared} == {}


class PointWitness(TypedDict):
    x: Fraction


def test_a_witness_of_another_form_is_not_read():
    rule = row("SD999", "point", "nobody", PointWitness)
    other = row("SD999", "point", "nobody", RadiusProof)
    assert rule.witness_of(rule.proved("there", {"x": Fraction(1)})) == {"x": Fraction(1)}
    for finding in (other.proved("there", {"rule": "zero"}), other.proved("there", {}), rule.skipped("where?", "none")):
        with pytest.raises(ValueError, match="the data of SD999 are no PointWitness"):
            rule.witness_of(finding)
    with pytest.raises(ValueError, match="no PointWitness: they have the keys y"):
        proof_of(rule.proved("there", {"x": Fraction(1)}, proof={"y": 1}), PointWitness)
