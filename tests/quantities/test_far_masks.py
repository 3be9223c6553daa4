"""Masks far from the origin are decided as those at it, up to the bounds of indices; and splines of high degree."""

from fractions import Fraction

import pytest

from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.option import from_option
from subdiv_cli.model import DECIDED, Effort, Verdict
from subdiv_cli.pipeline import check

QUINCUNX, SKEW = ((1, -1), (1, 1)), ((5, 23), (-1, -5))


def hat(dilation, step, at):
    terms = {
        tuple(x + i * e for x, e in zip(at, step, strict=True)): weight for i, weight in enumerate(("1/2", "1", "1/2"))
    }
    return MultivariateScheme(dilation=dilation, terms={index: Fraction(text) for index, text in terms.items()})


def answers(scheme):
    result = check(scheme, (), Effort()).result
    assert all(finding.claims for finding in result.findings if finding.verdict in DECIDED)
    return result.convergent, result.refinable, result.holder, result.sobolev, result.stable


@pytest.mark.parametrize("start", [-1_000_000, -999_999, 1, 999_997, 1_000_000])
def test_chaikin_anywhere(start):
    at_home = answers(from_option("[1, 3, 3, 1]/4").scheme({}))
    assert answers(from_option("[1, 3, 3, 1]/4", start=start).scheme({})) == at_home
    assert at_home[0] is Verdict.PROVED


@pytest.mark.parametrize("at", [(1, 0), (10, -7), (-300, 4), (900, 990), (-998, -998)])
def test_the_quincunx_hat_anywhere(at):
    convergent, refinable, holder, *_ = answers(hat(QUINCUNX, (1, 0), at))
    assert convergent is Verdict.PROVED
    assert (refinable.order, refinable.sharp) == (0, True)
    assert 0.47637291379750 < holder.lower <= holder.upper < 0.47637291379751
    assert answers(hat(QUINCUNX, (1, 0), at)) == answers(hat(QUINCUNX, (1, 0), (0, 0)))


def test_a_skew_dilation_far_off():
    convergent, refinable, holder, sobolev, stable = far = answers(hat(SKEW, (0, 1), (1000, 998)))
    assert far == answers(hat(SKEW, (0, 1), (0, 0)))
    assert (refinable.order, refinable.sharp) == (0, True)
    assert (holder.lower, holder.upper) == (1, 1)
    assert (sobolev.lower, sobolev.upper) == (1.5, 1.5)
    assert stable is Verdict.REFUTED
    assert convergent is Verdict.REFUTED, "(0, 1) and M(0, 1) = (23, -5) span a lattice of index 23"


@pytest.mark.parametrize(
    ("degree", "mask"), [(163, "(1+z)^164/2^163"), (164, "(1+z)^165/2^164"), (199, "(1+z)^200/2^199")]
)
def test_splines_of_high_degree(degree, mask):
    convergent, refinable, holder, sobolev, stable = answers(from_option(mask).scheme({}))
    assert (convergent, stable) == (Verdict.PROVED, Verdict.PROVED)
    assert (refinable.order, refinable.sharp) == (degree - 1, True)
    assert (holder.lower, holder.upper) == (degree, degree)
    assert (sobolev.lower, sobolev.upper) == (degree + 0.5, degree + 0.5)
