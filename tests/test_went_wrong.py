"""Masks that the program once did not handle well, each with what is right for it, and certified in full."""

import math
import re
from pathlib import Path

import pytest

from subdiv_cli.catalog.run import check_all
from subdiv_cli.checker import check_document
from subdiv_cli.kinds.option import from_option
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import DECIDED, Effort, Verdict
from subdiv_cli.pipeline import check

MASKS = Path(__file__).parent / "data" / "went_wrong"


def checked(name):
    """The result and the certificate of a mask."""
    found = check(read_path(str(MASKS / f"{name}.toml")).scheme({}), (), Effort())
    assert check_document(found.document).verified
    assert all(finding.claims for finding in found.result.findings if finding.verdict in DECIDED)
    return found.result


def test_a_shift_of_the_zwart_powell_element_is_certified():
    """Four coefficients apart, and no certificate: convergent, C^1 and not C^2, α = 2, not stable."""
    result = checked("uncertified_zp")
    assert (result.convergent, result.stable) == (Verdict.PROVED, Verdict.REFUTED)
    assert (result.smoothness.order, result.smoothness.sharp) == (1, True)
    assert result.holder.exact == 2


def test_a_far_mask_on_a_lattice_of_index_23_diverges():
    """e = (0,1) and Me = (23,-5) span a lattice of index 23; φ is C^0, not C^1, and α = 1."""
    result = checked("far_skew")
    assert result.convergent is Verdict.REFUTED
    assert (result.refinable.order, result.refinable.sharp, result.holder.exact) == (0, True, 1)


def test_a_far_quincunx_mask_has_its_exponent():
    result = checked("shifted_quincunx")
    assert result.convergent is Verdict.PROVED
    assert (result.smoothness.order, result.smoothness.sharp) == (0, True)
    assert math.isclose(result.holder.lower, 0.4763729137975079, abs_tol=1e-15)
    assert result.holder.exact is not None


def test_a_box_spline_of_33_directions():
    result = checked("box_11")
    assert (result.smoothness.order, result.smoothness.sharp, result.holder.exact) == (20, True, 21)


@pytest.mark.parametrize(
    ("name", "rules", "alpha", "sobolev"),
    [
        ("cdf97_synthesis_decimals", 4, 1.7011374873, 2.1226443841),
        ("coif5_decimals", 10, 3.46570732, 3.56564015),
    ],
)
def test_the_decimals_of_an_irrational_filter(name, rules, alpha, sobolev):
    """No fraction is guessed; the mask near it has the exponents of the filter to eight places."""
    (result,) = check_all([str(MASKS / f"{name}.toml")])
    assert not any("/11" in hint or "/52" in hint for hint in result.hints)
    (hint,) = result.hints
    assert f"{rules} sum rules hold to the digits given" in hint
    (symbol,) = re.findall(r'symbol = "(.*)"', hint)
    near = check(from_option(symbol, start=0).scheme({}), (), Effort()).result
    assert (near.convergent, near.sum_rule_order) == (Verdict.PROVED, rules)
    assert near.holder.lower == pytest.approx(alpha, abs=2e-8)
    assert near.sobolev.lower == pytest.approx(sobolev, abs=2e-8)
