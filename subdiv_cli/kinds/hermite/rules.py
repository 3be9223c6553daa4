"""The codes of Hermite schemes: those of kind vector, of which convergence is one step, and those on jets."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from subdiv_cli.kinds.hermite import witnesses as w
from subdiv_cli.kinds.vector import rules as vector
from subdiv_cli.kinds.vector.witnesses import SequenceRadiusWitness, VectorDerivedWitness
from subdiv_cli.model import findings as q
from subdiv_cli.model.findings import Rule, row, table

SPECTRAL_CONDITION = row(
    "SD714",
    "spectral-condition",
    "Dubuc & Merrien 2009; Moosmüller & Dyn 2018, (28) and Lemma 28",
    w.SpectralConditionWitness,
    answers=q.SPECTRAL,
    proves="spectral",
    holds=True,
)
JET_RADIUS = row(
    "SD715",
    "jet-radius",
    "Dubuc & Merrien 2009; Rota & Strang 1960; Guglielmi, Wirth & Zennaro 2005",
    SequenceRadiusWitness,
    proves="jet radius bounded radius-upper",
    radius=True,
)
HERMITE_CONVERGENCE = row(
    "SD716",
    "hermite-convergence",
    "Dubuc & Merrien 2009; Moosmüller & Dyn 2018, Definition 3",
    w.HermiteConvergenceWitness,
    answers=(q.CONVERGENCE, q.DERIVATIVES),
    proves="hermite-convergent",
    holds=True,
)
TAYLOR_SCHEME = row(
    "SD717",
    "taylor-scheme",
    "Merrien & Sauer 2012, Theorem 21; Moosmüller & Dyn 2018, Theorem 34 and Lemma 35",
    VectorDerivedWitness,
    proves="taylor derived derived-norm hermite-convergent smooth",
)


def rules() -> Mapping[str, Rule[Any]]:
    """Every row by its code."""
    shared = {code: rule for code, rule in vector.rules().items() if code != vector.DERIVED_SCHEMES.code}
    shared[vector.CONVERGENCE.code] = vector.CONVERGENCE._replace(answers=())
    return {**shared, **table(globals())}
