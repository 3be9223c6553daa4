"""A mask with sum rules near the decimals of an irrational filter: what is offered, how near, with which exponents.

Daubechies 1988 and Cohen, Daubechies & Feauveau 1992 have the filters; Hölder exponents 0.5500 of db2 and 2.4604 of
db7 in Gripenberg 1996 and Guglielmi & Protasov 2013, of 9/7 by the closed formulas of its symbol.
"""

from fractions import Fraction
from math import isqrt

import pytest
from support import b_spline, four_point, scheme, seeded

from subdiv_cli.catalog import masks_directory
from subdiv_cli.kinds.option import from_option
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.kinds.scalar.numbers import nearby as numbers
from subdiv_cli.kinds.scalar.numbers.facts import hints
from subdiv_cli.kinds.scalar.numbers.nearby import nearby
from subdiv_cli.model import Effort
from subdiv_cli.pipeline import check

ROOT_2 = Fraction(isqrt(2 * 10**80), 10**40)
FILTERS = {
    "db2": [
        "0.6830127018922193233819", "1.183012701892219323382", "0.3169872981077806766181", "-0.1830127018922193233819",
    ],
    "db7": [
        "0.110099430745623697782676", "0.56079128362552512542386", "1.03114849163619733624439",
        "0.664372482211079348474061", "-0.203513822462692484974628", "-0.316835011280665678753007",
        "0.100846465009388173805109", "0.114003445159743152633131", "-0.0537824525896908775264304",
        "-0.0234399415642065771438338", "0.0177497923793615278397267", "0.000607514995402138708529044",
        "-0.00254790471818737317084388", "0.000500226853122490657259685",
    ],
}  # fmt: skip
EXPONENTS = {"db2": (0.550015686523504, 1.0), "db7": (2.46040889528136, 2.65866030362895)}
CDF_9_7 = [
    "-0.091271763114", "-0.057543526229", "0.591271763114", "1.11508705", "0.591271763114", "-0.057543526229",
    "-0.091271763114",
]  # fmt: skip
COIF5 = [
    "-0.0002999290456691901", "0.000507105504716067", "0.0030805734519904447", "-0.005882156328071387",
    "-0.01432822469882011", "0.033104366612985776", "0.03983803439596865", "-0.1299967565094465",
    "-0.07360510694893749", "0.5961918029174383", "1.0950165427080736", "0.6194005181568408",
    "-0.08773462965647233", "-0.14928884026567946", "0.05838938555056148", "0.04620914455413369",
    "-0.027942585372764013", "-0.012953499503011725", "0.009562233598261315", "0.0034387669687710085",
    "-0.0023498958688270757", "-0.0009016444801392474", "0.00042689159501725844", "0.00019849382279747067",
    "-5.829368777244262e-05", "-3.008063596395372e-05", "5.233619320026237e-06", "2.9150058427103268e-06",
    "-2.29639929980596e-07", "-1.3582121354644715e-07",
]  # fmt: skip


def rounded(coefficients, digits, *, cut=False, scale=Fraction(1)):
    """The coefficients times a number, to so many decimals."""
    whole = [Fraction(c) * scale * 10**digits for c in coefficients]
    return scheme([int(c) if cut else round(c) for c in whole], over=10**digits)


def offered(mask):
    """What is offered, and the scheme of its symbol, which is held to what is said of it."""
    found = nearby(mask)
    assert found is not None
    there = from_option(found.symbol).scheme()
    scale = {None: 1, "√2": ROOT_2, "2": 2}[found.scale]
    differences = [abs(x - scale * y) for x, y in zip(there.coefficients, mask.coefficients, strict=True)]
    assert there.start == mask.start
    assert max(differences) == found.distance
    assert sum(there.coefficients) == 2
    return found, there


def exponents(mask):
    result = check(mask, (), Effort()).result
    return result.sum_rule_order, result.holder.lower, result.sobolev.lower


@pytest.mark.parametrize("digits", [8, 10, 12, 16])
@pytest.mark.parametrize("cut", [False, True])
@pytest.mark.parametrize("name", FILTERS)
def test_a_rounded_filter(name, cut, digits):
    """To eight digits and more the exponents of the mask that is offered are those of the filter, to most of them."""
    mask, rules = rounded(FILTERS[name], digits, cut=cut), {"db2": 2, "db7": 7}[name]
    if name == "db2" and not cut:  # the rounded numbers have both sum rules by themselves
        assert nearby(mask) is None
        there = mask
    else:
        found, there = offered(mask)
        assert (found.rules, found.scale) == (rules, None)
        assert found.distance < Fraction(11, 10) / 10**digits
    order, holder, sobolev = exponents(there)
    assert order == rules
    assert (holder, sobolev) == pytest.approx(EXPONENTS[name], abs=100 * 10.0**-digits + 1e-14)


@pytest.mark.parametrize("digits", [10, 16])
@pytest.mark.parametrize("name", FILTERS)
def test_a_filter_of_norm_one(name, digits):
    """Wavelet programs print filters whose sum is √2."""
    found, there = offered(rounded(FILTERS[name], digits, scale=1 / ROOT_2))
    assert (found.rules, found.scale) == ({"db2": 2, "db7": 7}[name], "√2")
    assert exponents(there)[1:] == pytest.approx(EXPONENTS[name], abs=200 * 10.0**-digits + 1e-14)
    (hint,) = hints(rounded(FILTERS[name], digits, scale=1 / ROOT_2))
    assert "near this one times √2" in hint


def test_a_filter_that_sums_to_one():
    found, _ = offered(rounded(FILTERS["db7"], 10, scale=Fraction(1, 2)))
    assert (found.rules, found.scale) == (7, "2")


def test_cdf_9_7():
    """One coefficient has eight digits, the others twelve: each counts with its own."""
    mask = scheme(CDF_9_7, start=-3)
    found, there = offered(mask)
    assert (found.rules, found.exact) == (4, 0)
    assert found.symbol == "z^-3 * (1 + z)^4 * (-0.730174104915 + 2.46034820983*z - 0.730174104915*z^2) / 8"
    assert Fraction("2.45e-9") < found.distance < Fraction("2.46e-9")
    assert there.coefficients == there.coefficients[::-1]
    assert exponents(there) == (4, pytest.approx(1.7011374873, abs=1e-9), pytest.approx(2.1226443841, abs=1e-9))
    (hint,) = hints(mask)
    assert hint == (
        "decimals of an irrational filter? 4 sum rules hold to the digits given, none exactly. All hold for a mask "
        "near this one, whose coefficients differ by 2.457…e-9 at most; its exponents are those of the filter to some "
        f'digits only: symbol = "{found.symbol}"'
    )


def test_coif5():
    """Doubles, off by more than their last digits: ten sum rules, and exponents that fewer digits do not change."""
    found, there = offered(scheme(COIF5))
    assert found.rules == 10
    assert found.distance < Fraction(1, 10**15)
    shorter, other = offered(rounded(COIF5, 12))
    assert shorter.rules == 10
    first, second = exponents(there), exponents(other)
    assert first == (10, pytest.approx(second[1], abs=1e-8), pytest.approx(second[2], abs=1e-8))


def test_one_coefficient_further_off(monkeypatch):
    """A slip of one unit is mended; nine units are not the rounding of the digits."""
    whole = [round(Fraction(c) * 10**12) for c in COIF5]
    one, nine = ([c + slip * (i == 12) for i, c in enumerate(whole)] for slip in (1, 9))
    assert offered(scheme(one, over=10**12))[0].distance < Fraction(2, 10**12)
    assert nearby(scheme(nine, over=10**12)) is None
    monkeypatch.setattr(numbers, "_UNITS", Fraction(1, 10))
    assert nearby(scheme(one, over=10**12)) is None, "what is offered is held to the digits once more"


def test_a_ternary_filter():
    cofactor = "(0.30901699437494745 + 0.69098300562505255 z)"
    symbol = from_option(f"z^-2 (1+z+z^2)^3 {cofactor} / 9", arity=3).scheme()
    mask = scheme([round(c * 10**9) for c in symbol.coefficients], over=10**9, start=-2, arity=3)
    found = nearby(mask)
    assert found.rules == 3
    there = from_option(found.symbol, arity=3).scheme()
    assert max(abs(x - y) for x, y in zip(there.coefficients, symbol.coefficients, strict=True)) < Fraction(1, 10**8)
    assert check(there, (), Effort()).result.sum_rule_order == 3


def test_nothing_is_offered_where_nothing_is_near():
    good = (four_point("1/16"), four_point("0.0607"), b_spline(3), b_spline(2, 3), b_spline(12), b_spline(60))
    assert [nearby(mask) for mask in good] == [None] * len(good)
    assert nearby(scheme(["0.683", "1.183", "0.317", "-0.183"])) is None, "three digits do not tell a filter"
    assert nearby(scheme(["1/3", "1/3"])) is None
    assert nearby(scheme(["0.333333", "0.666667", "0.666667", "0.333334"])) is not None, "near (1+z)^2 q(z)"
    assert nearby(scheme(["0.68301270", "1.18301270", "0.31698730", "-0.18301210"])) is None, "60 units off"


def test_a_good_mask_has_no_hint():
    for file in sorted((masks_directory() / "scalar").rglob("*.toml")):
        assert nearby(read_path(file).scheme()) is None, file


def test_what_is_offered_lies_within_two_units():
    """Random smoothing factors times random cofactors, rounded: the mask that is meant has no more sum rules."""
    rng, offers = seeded(0), 0
    for _ in range(100):
        k, digits = rng.randint(1, 6), rng.randint(6, 12)
        cofactor = [Fraction(rng.randint(-(10**20), 10**20), 10**20) for _ in range(rng.randint(2, 5))]
        cofactor[0] += 1 - sum(cofactor)
        terms = " + ".join(f"({c}) z^{i}" for i, c in enumerate(cofactor))
        mask = rounded(from_option(f"(1+z)^{k} ({terms}) / {2 ** (k - 1)}").scheme().coefficients, digits)
        if (found := nearby(mask)) is not None:
            offers += 1
            assert found.rules == k
            assert offered(mask)[0].distance <= Fraction(2, 10**digits) + Fraction(2, 10**15)
    assert offers >= 50
