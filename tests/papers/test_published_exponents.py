"""Exponents as papers print them, in decimals, against the closed forms that the shipped masks state.

Deslauriers & Dubuc 1989 and the other papers that the mask files name.
"""

import tomllib

import pytest
from flint import ctx

from subdiv_cli.catalog import masks_directory
from subdiv_cli.exact.closed import closed_ball
from subdiv_cli.maskfile.closed import read_closed_form

HOLDER = {
    "deslauriers_dubuc_4": "2",
    "deslauriers_dubuc_6": "2.83007500",
    "deslauriers_dubuc_8": "3.55113053",
    "deslauriers_dubuc_10": "4.19357343",
    "deslauriers_dubuc_12": "4.77674818",
    "deslauriers_dubuc_ternary_4": "1.8173",
    "deslauriers_dubuc_quaternary_4": "1.7075",
    "dual_four_point": "2.8300",
    "cubic_tension": "1.678",
    "hormann_sabin_5": "2.830",
    "hormann_sabin_6": "3.678",
    "hormann_sabin_7": "4.540",
    "pseudo_spline_3_1": "3.678",
    "pseudo_spline_4_1": "5.415",
    "dual_pseudo_spline_1_1": "1.192",
    "dual_pseudo_spline_4_1": "6.299",
    "ternary_four_point": "2.1826",
    "ternary_four_point_1_10": "2.0959",
    "ternary_four_point_1_13": "2.0728",
    "ternary_four_point_1_5": "1.4649",
    "ternary_three_point": "1.2618",
    "ternary_three_point_3_10": "1.2031",
    "ternary_three_point_4_15": "1.4649",
}
SOBOLEV = {
    "four_point": "2.4407",
    "deslauriers_dubuc_6": "3.1751",
    "deslauriers_dubuc_8": "3.7931",
    "four_point_1_32": "1.7184",
    "pseudo_spline_3_1": "4.0981",
    "de_rham_1_5": "0.9844",
    "colella_heil": "0.8684",
}
CASES = [(mask, "holder", digits) for mask, digits in HOLDER.items()]
CASES += [(mask, "sobolev", digits) for mask, digits in SOBOLEV.items()]


@pytest.mark.parametrize(("mask", "key", "digits"), CASES)
def test_the_closed_form_has_the_published_digits(mask, key, digits):
    """Cut or rounded: a unit of the last place at most."""
    file = masks_directory() / "scalar" / f"{mask}.toml"
    stated = tomllib.loads(file.read_text(encoding="utf-8"))["expect"][key]
    with ctx.workprec(128):
        value = closed_ball(read_closed_form(stated))
    unit = 10.0 ** -len(digits.partition(".")[2]) if "." in digits else 0.0
    assert abs(float(value.mid()) - float(digits)) <= unit
