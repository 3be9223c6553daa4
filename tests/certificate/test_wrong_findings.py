"""A claim states what its finding says: where a stage is wrong, the checker disagrees, and nothing is printed."""

from dataclasses import replace
from fractions import Fraction

import pytest

from subdiv_cli.kinds.kind import Analysis
from subdiv_cli.kinds.option import from_option
from subdiv_cli.kinds.scalar import KIND
from subdiv_cli.model import Effort
from subdiv_cli.pipeline import DisagreementError, certified

FOUR_POINT = "[-1, 0, 9, 16, 9, 0, -1]/16"


def one_more(value):
    return value + 1


def last_one_longer(masks):
    return (*masks, masks[-1])


@pytest.mark.parametrize(
    ("code", "key", "wrong"),
    [
        ("SD101", "sums", lambda sums: (Fraction(2), *sums[1:])),
        ("SD102", "order", one_more),
        ("SD103", "degree", one_more),
        ("SD104", "degree", one_more),
        ("SD105", "masks", last_one_longer),
        ("SD302", "order", one_more),
        ("SD303", "order", lambda order: order - 1),
    ],
)
def test_a_wrong_number(code, key, wrong):
    scheme = from_option(FOUR_POINT, start=-3).scheme({})
    analysis = KIND.analyse(scheme, Effort())
    (finding,) = (each for each in analysis.findings if each.code == code)
    forged = replace(finding, witness={**finding.witness, key: wrong(finding.witness[key])})
    findings = tuple(forged if each is finding else each for each in analysis.findings)
    with pytest.raises(DisagreementError):
        certified(KIND, analysis._replace(findings=findings), (), Effort())


def test_the_right_numbers():
    analysis = KIND.analyse(from_option(FOUR_POINT, start=-3).scheme({}), Effort())
    assert isinstance(analysis, Analysis)
    assert certified(KIND, analysis, (), Effort()).document is not None
