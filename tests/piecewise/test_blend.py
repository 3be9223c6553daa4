"""Special rules between two masks: published ones rebuilt, why there are no positive ones, and the command."""

import re
from fractions import Fraction

import pytest
from bsplines import bspline_mask
from random_piecewise import MASKS, mask
from support import cases, seeded, subdiv

from subdiv_cli.catalog import masks_directory
from subdiv_cli.exact.programs import largest_least_weight
from subdiv_cli.kinds.piecewise.blend import ImpossibleError, blended, certificate_holds, conditions
from subdiv_cli.kinds.piecewise.search import improved
from subdiv_cli.kinds.reading import read_path, read_text
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.pipeline import check

ONE = (Fraction(1), Fraction(1))
SCALAR = masks_directory() / "scalar"
FOUR, CUBIC, CHAIKIN = mask("four-point"), mask("cubic"), mask("chaikin")
LEVIN = read_path(masks_directory() / "piecewise" / "four_point_cubic.toml").scheme({})


def test_levins_scheme_is_rebuilt():
    """A. Levin 2003, section 3.5, from both masks alone: four points each, three special points."""
    blend = blended(FOUR, CUBIC)[0]
    assert blend.scheme == LEVIN
    assert sorted(blend.rules) == [-1, 1, 2]
    assert all(len(rule.points) == 4 for rule in blend.rules.values())


def test_knots_are_inserted_where_spacings_change():
    """Cubic B-splines with two spacings: positive rules on few points, and splines again, with all cubics."""
    blend = blended(CUBIC, CUBIC, (Fraction(1), Fraction(2)), positive=True)[0]
    result = check(blend.scheme, (), Effort()).result
    assert min(w for rule in blend.rules.values() for _, w in rule.row) > 0
    assert (result.generation, result.holder.exact) == (3, 3)


def test_rules_of_the_other_mask_are_positive_too():
    """Without negative weights: rules that the other mask has, where these have some, are replaced by means."""
    wide = type(FOUR)(arity=2, start=-7, coefficients=FOUR.coefficients)
    assert min(w for _, row in blended(wide, FOUR, degree=1)[0].scheme.special for _, w in row) < 0
    for blend in blended(wide, FOUR, degree=1, positive=True):
        assert len(blend.rules) == len(blend.scheme.special) > 1
        assert min(w for _, row in blend.scheme.special for _, w in row) > 0
        assert check(blend.scheme, (), Effort()).result.generation == 1


def test_special_rules_are_where_files_may_have_them():
    far = type(CUBIC)(arity=2, start=100, coefficients=CUBIC.coefficients)
    with pytest.raises(ImpossibleError, match="beyond 100; shift the masks towards 0"):
        blended(CUBIC, far)


def test_nothing_is_changed_where_nothing_must_be():
    assert all(not blend.scheme.special for blend in blended(CUBIC, CUBIC))
    assert not blended(FOUR, CUBIC, degree=1)[0].rules


def test_random_pairs_keep_their_polynomials():
    """S Q = Q σ on the degree that is wanted, by the stages; and the dual programs hold, from Q alone."""
    rng, rules = seeded(825), 0
    for _ in range(cases(16)):
        left, right = mask(rng.choice(list(MASKS))), mask(rng.choice(list(MASKS)))
        spacing = (Fraction(1), rng.choice([Fraction(1), Fraction(2), Fraction(2, 3)]))
        for blend in blended(left, right, spacing):
            result = check(blend.scheme, (), Effort()).result
            assert (result.generation or 0) >= blend.degree
            wanted = conditions(left, right, spacing, None, blend.boundary)
            for i, rule in blend.rules.items():
                assert certificate_holds(wanted, i, rule)
                assert wanted.are_met(i, rule.row)
                rules += 1
    assert rules > 20


def test_a_polynomial_says_why_there_are_no_positive_rules():
    """Between the points -1 and 0 of an interpolatory side: g = x(x + 1)(x + 6)/7 is negative at -1/2."""
    with pytest.raises(ImpossibleError) as raised:
        blended(FOUR, CUBIC, positive=True)
    first, second = str(raised.value).splitlines()
    assert "point -1 has no rule without negative weights on the old points -6, …, 5" in first
    assert "g = 1/7 x^3 + x^2 + 6/7 x has Q g ≥ 0 at all of them, and Q σ g = -11/56 < 0 at -1" in first
    g = [Fraction(0), Fraction(6, 7), Fraction(1), Fraction(1, 7)]
    wanted = conditions(FOUR, CUBIC, ONE, None, 1)

    def of(column):
        return sum(a * b for a, b in zip(g, column, strict=True))

    assert min(of(wanted.column(j)) for j in range(-6, 6)) == 0
    assert of(wanted.right_side(-1)) == Fraction(-11, 56)
    assert "with Q of the right mask at 0: point -3" in second


def test_programs_agree_with_a_search():
    """The largest least weight by random feasible points: never above it, and the bound is met."""
    rng = seeded(826)
    for _ in range(cases(40)):
        n, m = rng.randint(3, 6), rng.randint(1, 3)
        columns = [[Fraction(1), *(Fraction(rng.randint(-5, 5)) for _ in range(m))] for _ in range(n)]
        weights = [Fraction(rng.randint(-3, 6), 4) for _ in range(n - 1)]
        weights.append(1 - sum(weights))
        right = [sum(w * c[d] for w, c in zip(weights, columns, strict=True)) for d in range(m + 1)]
        optimum = largest_least_weight(columns, right)
        assert optimum.least == min(optimum.weights) >= min(weights)
        for d in range(m + 1):
            assert sum(w * c[d] for w, c in zip(optimum.weights, columns, strict=True)) == right[d]
        values = [sum(a * b for a, b in zip(optimum.multipliers, c, strict=True)) for c in columns]
        assert min(values) >= 0
        assert sum(values) == 1
        assert sum(a * b for a, b in zip(optimum.multipliers, right, strict=True)) == optimum.least
    assert largest_least_weight([[Fraction(1), Fraction(0)]], [Fraction(1), Fraction(1)]) is None


def test_what_cannot_be_is_said():
    for arguments, why in (
        ({"degree": 4}, "the left mask generates polynomials of degree 3, and S Q = Q σ is wanted on degree 4"),
        ({"support": 2}, "point -1 has no rule on 2 points"),
    ):
        with pytest.raises(ImpossibleError, match=re.escape(why)):
            blended(FOUR, CUBIC, **arguments)
    rough = type(FOUR)(arity=2, start=0, coefficients=(Fraction(1), Fraction(1, 2)))
    with pytest.raises(ImpossibleError, match="the right mask has no sum rule"):
        blended(FOUR, rough)


def test_the_search_reaches_the_sides():
    """Six-point Deslauriers-Dubuc and cubic B-splines: log2(64/9), that of the left mask, from log2(296/57)."""
    six = read_path(SCALAR / "deslauriers_dubuc_6.toml").scheme({})
    blend = blended(six, CUBIC)[0]
    assert str(check(blend.scheme, (), Effort()).result.holder.exact) == "log2(296/57)"
    wanted = conditions(six, CUBIC, ONE, blend.degree, blend.boundary)
    schemes = list(improved(blend, wanted, Effort(), positive=False))
    results = [check(scheme, (), Effort()).result for scheme in schemes]
    assert "log2(64/9)" in {str(result.holder.exact) for result in results}
    assert {result.generation for result in results} == {3}
    kept = list(improved(blend, wanted, Effort(), positive=True))
    assert not kept or all(w >= 0 for scheme in kept for i in blend.rules for _, w in dict(scheme.special)[i])


def blend_command(*arguments):
    return subdiv("blend", *(SCALAR / f"{name}.toml" for name in arguments[:2]), *arguments[2:])


def test_the_command_writes_a_file_that_passes(tmp_path):
    run = blend_command("four_point", "bspline_degree_3")
    assert (run.returncode, run.stderr.strip()) == (0, "C^1, not C^2 — convergence proved; Hölder exponent 2")
    assert read_text(run.stdout, file="blend.toml").scheme({}) == LEVIN
    assert run.stdout.startswith("# subdiv blend ")
    file = tmp_path / "blend.toml"
    written = blend_command("four_point", "bspline_degree_3", "-o", file)
    assert (written.returncode, written.stdout) == (0, "")
    assert file.read_text(encoding="utf-8") == run.stdout
    checked = subdiv("check", file, "--no-cache")
    assert checked.returncode == 0
    assert 'holder_at_zero = "log2(296/57)"' in run.stdout


def test_options_of_the_command():
    run = blend_command("bspline_degree_3", "bspline_degree_3", "--spacing", "1,2", "--positive")
    assert run.returncode == 0
    assert "spacing = [1, 2]" in run.stdout
    assert "--spacing 1,2 --positive" in run.stdout.splitlines()[0]
    assert read_text(run.stdout, file="blend.toml").scheme({}).spacing == (1, 2)
    more = blend_command("four_point", "bspline_degree_3", "--support", "6")
    assert more.returncode == 0
    assert more.stdout.splitlines()[0].endswith(" --support 6")
    best = blend_command("bspline_degree_5", "bspline_degree_6", "--best")
    assert (best.returncode, "Hölder exponent 5" in best.stderr) == (0, True)


@pytest.mark.parametrize(
    ("arguments", "code", "why"),
    [
        (("four_point", "bspline_degree_3", "--positive"), 1, "no rule without negative weights"),
        (("four_point", "bspline_degree_3", "--degree", "4"), 1, "generates polynomials of degree 3"),
        (("four_point", "bspline_ternary_degree_3"), 2, "must be of one arity, and there are 2 and 3"),
        (("four_point", "nothing"), 2, "no such file"),
        (("four_point", "bspline_degree_3", "--spacing", "1,0"), 2, "not two positive numbers"),
        (("four_point", "bspline_degree_3", "--spacing", "1"), 2, "not two positive numbers"),
        (("four_point", "bspline_degree_3", "--shear", "0,0"), 2, "No such option"),
    ],
)
def test_what_the_command_refuses(arguments, code, why):
    run = blend_command(*arguments)
    assert run.returncode == code
    assert why in run.stderr
    assert run.stdout == ""


def test_a_mask_in_two_variables_is_refused():
    run = subdiv("blend", masks_directory() / "multivariate" / "loop.toml", SCALAR / "four_point.toml")
    assert run.returncode == 2
    assert "a file of kind scalar was expected, not multivariate" in run.stderr


def test_diverging_sides_give_a_scheme_that_diverges():
    wild = bspline_mask(0, 2, 0)
    blend = blended(wild, CUBIC)[0]
    assert check(blend.scheme, (), Effort()).result.convergent is Verdict.REFUTED
    run = blend_command("bspline_degree_0", "bspline_degree_3")
    assert run.returncode == 1
    assert "convergent = false" in run.stdout
