"""Broken mask files as data: a name, the text, and every problem that reading it gives.

A problem is (code, fragment of the message, key, line, column, fragment of the help), in the order of the file. Files
marked `AT_SCHEME` read well and fail when parameters get their defaults.
"""

# One file a line:
# ruff: noqa: E501

from __future__ import annotations

from typing import NamedTuple


class Expected(NamedTuple):
    code: str
    message: str
    key: str | None
    line: int | None
    column: int | None
    help: str


class Broken(NamedTuple):
    name: str
    text: str
    problems: tuple[Expected, ...]


MASK = "[mask]\nstart = 0\ncoefficients = [1, 1]\n"
HEAD = "[mask]\nstart = 0\ncoefficients = "
VECTOR = 'kind = "vector"\n[mask]\nstart = 0\ncoefficients = '
HERMITE = 'kind = "hermite"\n[mask]\nstart = 0\ncoefficients = '
W = "[parameters]\nw = 0\n"
CURVE = 'kind = "matrices"\n'
SIDES = '[left]\nstart = -1\ncoefficients = ["1/2", 1, "1/2"]\n[right]\nstart = -1\ncoefficients = ["1/2", 1, "1/2"]\n'
PIECEWISE = f'kind = "piecewise"\n{SIDES}'
LINE = 'matrices = [[[1, 0], ["1/2", "1/2"]], [["1/2", "1/2"], [0, 1]]]\n'


def one(name: str, text: str, *problem: object) -> Broken:
    return Broken(name, text, (Expected(*problem),))  # type: ignore[arg-type]


def several(name: str, text: str, *problems: tuple[object, ...]) -> Broken:
    return Broken(name, text, tuple(Expected(*problem) for problem in problems))  # type: ignore[arg-type]


C0 = "mask.coefficients[0]"
C1 = "mask.coefficients[1]"
SYNTAX = [
    one("fraction", HEAD + '[-1/16, 0, "9/16"]\n', "SD003", "TOML has no fractions", C0, 3, 19, '"-1/16"'),
    one("fraction-later", HEAD + '[0,\n "1", 1 / 2]\n', "SD003", "TOML has no fractions", "mask.coefficients[2]", 4, 9, '"1 / 2"'),
    one("fraction-sum", HEAD + "[0, 1/2 + w]\n", "SD003", "TOML has no fractions", C1, 3, 21, '"1/2 + w"'),
    one("fraction-parameter", "[parameters]\nw = 1/16\n" + MASK, "SD003", "TOML has no fractions", "parameters.w", 2, 6, '"1/16"'),
    one("fraction-inline", "mask = {start = 0, coefficients = [1/2]}", "SD003", "no fractions", C0, 1, 37, '"1/2"'),
    one("expression-unquoted", HEAD + "[-w, 0]\n", "SD001", "must be quoted", C0, 3, 18, '"-w"'),
    one("sum-unquoted", HEAD + "[1 + w]\n", "SD001", "expression not quoted", C0, 3, 19, '"1 + w"'),
    one("product-unquoted", HEAD + "[2w, 1]\n", "SD001", "expression not quoted", C0, 3, 18, '"2w"'),
    one("unicode-minus-unquoted", HEAD + "[1 − w]\n", "SD001", "expression not quoted", C0, 3, 19, '"1 - w"'),
    one("no-comma", HEAD + "[1 2]\n", "SD001", 'a comma or "]" was expected, not "2"', C0, 3, 19, "between values"),
    one("no-comma-strings", HEAD + '["1/8" "4/8"]\n', "SD001", "a comma", C0, 3, 23, "comma between values"),
    one("two-commas", HEAD + "[1,,2]\n", "SD001", "missing before this comma", C0, 3, 19, "remove the comma"),
    one("array-open", HEAD + "[1, 2\n", "SD001", "never closed", "mask.coefficients", 3, 16, 'missing "]"'),
    one("array-open-and-more", HEAD + "[1, 2\n\n[expect]\n", "SD001", 'a comma or "]"', "mask.coefficients", 5, 1, "of line 3"),
    one("table-open", "mask = {start = 0", "SD001", "never closed", "mask.start", 1, 8, 'missing "}"'),
    one("no-value", "[mask]\nstart =\n", "SD001", "a value was expected, not the end of the line", "mask.start", 2, 8, "write a value"),
    one("no-equals", "[mask]\nstart 0\n", "SD001", '"=" was expected after the key start', None, 2, 7, "start = value"),
    one("colon", "[mask]\nstart: 0\n", "SD001", 'not ":"', None, 2, 6, "write start = 0"),
    one("text-unquoted", "name = four-point\n", "SD001", "must be quoted", "name", 1, 8, '"four-point"'),
    one("string-open", '[mask]\nsymbol = "1+z\n', "SD001", "not closed on its line", "mask.symbol", 2, 10, 'missing "'),
    one("long-string-open", 'name = """four\n', "SD001", "not closed", "name", 1, 8, 'missing """'),
    one("leading-zero", "[mask]\nstart = 01\n", "SD001", "does not begin with 0", "mask.start", 2, 10, "write 1"),
    one("no-digit-before-point", HEAD + "[.5]", "SD001", "a digit before its point", C0, 3, 17, '".5"'),
    one("no-digit-after-point", HEAD + "[5.]", "SD001", "a digit after its point", C0, 3, 18, '"5."'),
    one("capital-true", "[expect]\nconvergent = True\n", "SD001", "True is not a TOML value", "expect.convergent", 2, 14, "true in lower case"),
    one("header-open", "[mask\nstart = 0\n", "SD001", '"]" was expected', None, 1, 6, "[mask]"),
    one("header-and-more", "[mask] start = 0\n", "SD001", "the line should end here", None, 1, 8, "new line"),
    one("greek-key", "[parameters]\nω = 1\n" + MASK, "SD001", '"ω" (U+03C9) cannot stand in a bare key', None, 2, 1, '"ω" = 1'),
    one("greek-key-own", '[parameters]\nθ_1 = "1/16"  # tension\n' + MASK, "SD001", "bare key", None, 2, 1, 'quote the key: "θ_1" = "1/16"'),
    one("greek-key-bad-value", "[parameters]\nθ = 1/8\n" + MASK, "SD001", "bare key", None, 2, 1, 'quote the key: "θ" = "1/16"'),
    one("greek-inside-a-key", "[parameters]\nw_θ = 0.5\n" + MASK, "SD001", "bare key", None, 2, 3, '"w_θ" = 0.5'),
    one("minus-unquoted", "[mask]\nstart = −3\ncoefficients = [1]\n", "SD001", '"−" (U+2212)', "mask.start", 2, 9, 'the ASCII minus "-" instead: -3'),
    one("minus-fraction-unquoted", HEAD + "[−1/16, 1]\n", "SD001", '"−" (U+2212)', C0, 3, 17, 'instead: "-1/16"'),
    one("minus-in-fraction", HEAD + "[1/−16, 1]\n", "SD003", "no fractions", C0, 3, 18, '"1/-16"'),
    one("superscript-unquoted", HEAD + "[2⁻¹², 1]\n", "SD001", "expression not quoted", C0, 3, 18, '"2^-12"'),
    one("vulgar-fraction", HEAD + "[½, 1]\n", "SD001", '"½" (U+00BD)', C0, 3, 17, '"(1/2)"'),
    one("root-unquoted", HEAD + "[√3, 1]\n", "SD001", "must be quoted", C0, 3, 17, "rational masks only"),
    one("curly-quotes", HEAD + "[“1/8”, 1]\n", "SD001", '"“" (U+201C) is no quotation mark', C0, 3, 17, 'straight quotes: "1/8"'),
    one("curly-quotes-minus", "[mask]\nstart = “−3”\ncoefficients = [1]\n", "SD001", "(U+201C)", "mask.start", 2, 9, "without quotes: -3"),
    one("curly-quote-closing", HEAD + '["1/8”, 1]\n', "SD001", '"”" (U+201D) is no quotation mark', C0, 3, 21, "a straight quote"),
    one("curly-quoted-key", "[parameters]\n“w” = 1\n" + MASK, "SD001", "(U+201C)", None, 2, 1, "straight quotes"),
    one("no-break-space", "[mask]\nstart = 0\u00a0\ncoefficients = [1]\n", "SD001", "(U+00A0)", "mask.start", 2, 10, "a plain space"),
    one("two-signs", HEAD + "[--1]\n", "SD001", "must be quoted", C0, 3, 18, '"--1"'),
    one("slashes-comment", "// a mask\n" + MASK, "SD001", "a comment in TOML", None, 1, 1, "comments begin with #"),
    one("slashes-comment-behind", "[mask]\nstart = 0 // first\ncoefficients = [1]\n", "SD001", "a comment in TOML", "mask.start", 2, 11, "comments begin with #"),
    one("slashes-comment-inside", HEAD + "[1, // one\n 1]\n", "SD001", "a comment in TOML", C1, 3, 20, "comments begin with #"),
    one("slashes-comment-behind-a-list", HEAD + "[1] // one\n", "SD001", "a comment in TOML", C0, 3, 20, "comments begin with #"),
    one("decimal-commas", HEAD + "[0,0625, 0,5]\n", "SD001", "a decimal comma?", C1, 3, 20, "decimals need a point: 0.0625"),
    one("null-character", "a\x00 = 1", "SD001", "\\u0000", None, 1, 2, "a = value"),
    one("bad-escape", 'name = "a\\\\b \\q"\n', "SD001", "no escape", "name", 1, 14, "single quotes"),
    one("repeated-key", "[mask]\nstart = 0\n start = 1\ncoefficients = [1]\n", "SD015", "twice, first on line 2", "mask.start", 3, 2, "keep one"),
    one("repeated-table", MASK + "[mask]\n", "SD015", "mask is given twice, first on line 1", "mask", 4, 2, "keep one"),
    several(
        "repeated-key-and-fraction",
        "[mask]\nstart = 0\nstart = 1\ncoefficients = [1/2]\n",
        ("SD015", "first on line 2", "mask.start", 3, 1, "keep one"),
        ("SD003", "no fractions", C0, 4, 18, '"1/2"'),
    ),
]  # fmt: skip

STRUCTURE = [
    one("misspelt-key", 'nmae = "x"\n' + MASK, "SD004", 'unknown key "nmae" at the top', "nmae", 1, 1, "did you mean name?"),
    one("misspelt-in-mask", "[mask]\nstart = 0\ncoeffs = [1]\n", "SD004", '"coeffs" in [mask]', "mask.coeffs", 3, 1, "coefficients?"),
    one("misspelt-coefs", "[mask]\nstart = 0\ncoefs = [1]\n", "SD004", '"coefs" in [mask]', "mask.coefs", 3, 1, "coefficients?"),
    one("misspelt-coefficient", "[mask]\nstart = 0\ncoefficient = [1]\n", "SD004", '"coefficient"', "mask.coefficient", 3, 1, "coefficients?"),
    one("misspelt-coefs-at-the-top", "coefs = [1]\n", "SD004", '"coefs" at the top', "coefs", 1, 1, "coefficients? they belong below [mask]"),
    one("misspelt-masks", "[masks]\nstart = 0\ncoefficients = [1]\n", "SD004", '"masks"', "masks", 1, 2, "did you mean mask?"),
    one("misspelt-table", "[maks]\nstart = 0\ncoefficients = [1]\n", "SD004", '"maks"', "maks", 1, 2, "did you mean mask?"),
    one("unlike-any-key", MASK + "[extra]\n", "SD004", 'unknown key "extra"', "extra", 4, 2, "known keys: format"),
    one("of-another-kind", 'kind = "scalar"\n[mask]\nstart = 0\ncoefficients = [1]\ndilation = 2\n', "SD004", "dilation", "mask.dilation", 5, 1, "arity = 2"),
    one("kind-or-arity", "[mask]\nstart = 0\ncoefficients = [1]\ndilation = 2\n", "SD005", 'kind = "multivariate" is missing: dilation is', "mask.dilation", 4, 1, "arity = 2"),
    several(
        "not-in-mask",
        "start = 0\ncoefficients = [1]\n",
        ("SD004", '"start" at the top', "start", 1, 1, "below [mask]"),
        ("SD004", '"coefficients" at the top', "coefficients", 2, 1, "below [mask]"),
    ),
    one("no-mask", 'kind = "scalar"\n', "SD005", "[mask] is missing", "mask", None, None, "add [mask]"),
    one("mask-without-anything", "\n[mask]\narity = 2\n", "SD005", "no symbol", "mask.coefficients", 2, 2, "coefficients = ["),
    one("empty-file", "", "SD016", "the file is empty", None, None, None, "[mask]"),
    one("foreign-file", '[project]\nversion = "1"\n', "SD016", "no mask file", None, None, None, "[mask]"),
    one("mask-is-an-array", "mask = [1, 1]\n", "SD006", "mask must be a table, not an array", "mask", 1, 8, "[mask]"),
    one("parameters-no-table", "parameters = 1\n" + MASK, "SD006", "parameters must be a table", "parameters", 1, 14, "[parameters]"),
    one("name-no-string", "name = 1\n" + MASK, "SD006", "name must be a string, not an integer", "name", 1, 8, "quotes"),
    one("start-quoted", '[mask]\nstart = "-3"\ncoefficients = [1]\n', "SD006", "not the string", "mask.start", 2, 10, "start = -3"),
    one("start-decimal", "[mask]\nstart = 1.5\ncoefficients = [1]\n", "SD006", "not a decimal", "mask.start", 2, 9, "start = -3"),
    one("start-whole-decimal", "[mask]\nstart = -2.0\ncoefficients = [1]\n", "SD006", "not a decimal", "mask.start", 2, 9, "start = -2"),
    one("start-quoted-minus", '[mask]\nstart = "−3"\ncoefficients = [1]\n', "SD006", "not the string", "mask.start", 2, 10, "start = -3"),
    one("start-true", "[mask]\nstart = true\ncoefficients = [1]\n", "SD006", "not true", "mask.start", 2, 9, "start = -3"),
    one("start-huge", "[mask]\nstart = -9999999\ncoefficients = [1]\n", "SD010", "between -1000000 and", "mask.start", 2, 9, "index"),
    one("arity-1", "[mask]\narity = 1\nstart = 0\ncoefficients = [1]\n", "SD010", "between 2 and 64, not 1", "mask.arity", 2, 9, "arity = 2"),
    one("arity-big", "[mask]\narity = 65\nsymbol = '1'\n", "SD010", "between 2 and 64, not 65", "mask.arity", 2, 9, "arity = 2"),
    one("arity-true", "[mask]\narity = true\nsymbol = '1'\n", "SD006", "arity must be an integer, not true", "mask.arity", 2, 9, "arity = 2"),
    one("empty-mask", HEAD + "[]\n", "SD009", "the mask is empty", "mask.coefficients", 3, 16, "write its coefficients"),
    one("zero-mask", HEAD + '[0, "0", "1-1"]\n', "SD009", "all coefficients", "mask.coefficients", 3, 16, "must not be zero"),
    one("zero-symbol", '[mask]\nsymbol = "z-z"\n', "SD009", "all coefficients", "mask.symbol", 2, 11, "must not be zero"),
    one("coefficients-text", '[mask]\nstart = 0\ncoefficients = "1 1"\n', "SD006", "must be a list, not a string", "mask.coefficients", 3, 17, "[\"1/2\""),
    one("coefficient-true", HEAD + "[true]\n", "SD006", "a number was expected, not true", C0, 3, 17, "-1/16"),
    one("coefficient-list", HEAD + "[1, [1, 1]]\n", "SD006", "not an array", C1, 3, 20, 'kind = "multivariate"'),
    one("coefficient-lists", HEAD + "[[1, 1]]\n", "SD005", 'kind = "multivariate" is missing: coefficients in lists', "mask.coefficients", 3, 1, "at the top, above [mask]"),
    one("coefficient-table", HEAD + "[{a = 1}]\n", "SD006", "not a table", C0, 3, 17, "-1/16"),
    one("coefficient-date", HEAD + "[1, 1979-05-27]\n", "SD006", "not a date or time", C1, 3, 20, "-1/16"),
    one("symbol-number", "[mask]\nsymbol = 1\n", "SD006", "symbol must be a string", "mask.symbol", 2, 10, "expression in z"),
    several(
        "mask-twice",
        '[mask]\nstart = 0\ncoefficients = [1]\nsymbol = "1+z"\n',
        ("SD015", "start and symbol", "mask.start", 2, 1, "keep one"),
        ("SD015", "coefficients and symbol", "mask.coefficients", 3, 1, "keep one"),
    ),
    one("kind-planned", 'kind = "surface"\n' + MASK, "SD013", "kind surface cannot be checked yet", "kind", 1, 9, "scalar"),
    one("kind-misspelt", 'kind = "scaler"\n' + MASK, "SD013", 'no kind "scaler"', "kind", 1, 9, '"scalar"?'),
    one("kind-like-a-planned-one", 'kind = "surfac"\n' + MASK, "SD013", 'no kind "surfac"', "kind", 1, 9, "this version reads: scalar, multivariate, matrices, vector, hermite, piecewise; planned: irrational, surface, nonstationary"),
    one("kind-number", "kind = 1\n" + MASK, "SD006", "kind must be a string", "kind", 1, 8, 'kind = "scalar"'),
    one("matrices", "matrices = [[[1]]]\n", "SD013", "a family of matrices is a scheme", "matrices", 1, 12, 'add kind = "matrices", or use subdiv jsr'),
    one("matrices-without-kind", HEAD + "[[[1, 0], [0, 1]]]\n", "SD005", "the coefficients are matrices", "mask.coefficients", 3, 16, 'kind = "vector"'),
    one("matrices-missing", CURVE[:-1], "SD005", "matrices are missing", "matrices", None, None, "a list of rows"),
    one("matrices-one", f"{CURVE}matrices = [[[1, 0], [0, 1]]]\n", "SD010", "there is one matrix", "matrices", 2, 12, "every piece"),
    one("matrices-small", f"{CURVE}matrices = [[[1]], [[1]]]\n", "SD010", "the order is 1", "matrices", 2, 12, "subdiv jsr"),
    one("matrices-row-sum", f'{CURVE}matrices = [[[1, 0], ["1/2", "1/2"]], [["1/2", "2/3"], [0, 1]]]\n', "SD024", "the row sums to 7/6, must be 1", "matrices[1][0]", 2, 40, "correct its weights"),
    several("matrices-transposed", f'{CURVE}matrices = [[[1, 0], ["1/2", "1/2"]], [["1/2", 0], ["1/2", 1]]]\n', ("SD024", "sums to 1/2", "matrices[1][0]", 2, 40, "transposed"), ("SD024", "sums to 3/2", "matrices[1][1]", 2, 52, "transposed")),
    one("matrices-sizes", f"{CURVE}matrices = [[[1, 0], [0, 1]], [[1]]]\n", "SD023", "the first is 2×2, and this one is 1×1", "matrices[1]", 2, 31, "a list of rows"),
    one("matrices-not-square", f"{CURVE}matrices = [[[1, 0], [0, 1]], [[1, 0]]]\n", "SD006", "not square", "matrices[1][0]", 2, 32, "square matrices"),
    one("matrices-entry", f"{CURVE}matrices = [[[1, 0], [0, true]], [[1, 0], [0, 1]]]\n", "SD006", "not true", "matrices[0][1][1]", 2, 26, "-1/16"),
    one("matrices-text", f'{CURVE}matrices = [[[1, 0], ["x", 1]], [[1, 0], [0, 1]]]\n', "SD008", "x", "matrices[0][1][0]", 2, 24, "parameters"),
    one("matrices-property", f"{CURVE}{LINE}[expect]\nstable = true\n", "SD004", "kind matrices have no property stable", "expect.stable", 4, 1, "well_defined"),
    one("scalar-property", MASK + "[expect]\npolynomials = 1\n", "SD004", "kind scalar have no property polynomials", "expect.polynomials", 5, 1, "convergent"),
    one("vector-flat", VECTOR + "[1, 2]\n", "SD023", "no matrix; a flat list", "mask.coefficients", 4, 16, "a list of matrices"),
    one("vector-rows", VECTOR + "[[1, 0], [0, 1]]\n", "SD023", "is a row, and not a matrix", "mask.coefficients", 4, 16, "a list of matrices"),
    one("vector-sizes", VECTOR + "[[[1, 0], [0, 1]], [[1]]]\n", "SD023", "the first is 2×2, and this one is 1×1", "mask.coefficients[1]", 4, 35, "a list of matrices"),
    one("vector-not-square", VECTOR + "[[[1, 0], [0]]]\n", "SD006", "not square: rows 2, entries of this row 1", "mask.coefficients[0][1]", 4, 26, "m rows of m entries"),
    one("vector-number", VECTOR + '[[[1, "1//2"], [0, 1]]]\n', "SD008", '"/" stands where', "mask.coefficients[0][0][1]", 4, 25, "remove it"),
    one("vector-deep", VECTOR + "[[[[1]]]]\n", "SD006", "a number was expected, not a list", "mask.coefficients[0][0][0]", 4, 19, "a list of matrices"),
    one("vector-zero", VECTOR + "[[[0, 0], [0, 0]]]\n", "SD009", "all coefficients of the mask are zero", "mask.coefficients", 4, 16, "at least one"),
    one("vector-large", VECTOR + f"[{[[0] * 17] * 17}]\n", "SD010", "a matrix: 17 entries; the limit is 16", "mask.coefficients[0]", 4, 17, "a list of matrices"),
    one("vector-long", VECTOR + f"{[[[1]]] * 201}\n", "SD010", "201 entries; the limit is 200", "mask.coefficients", 4, 16, "a list of matrices"),
    one("vector-missing", 'kind = "vector"\n[mask]\nstart = 0\n', "SD005", "a list of m×m matrices", "mask.coefficients", 2, 2, "a list of matrices"),
    one("vector-symbol", VECTOR + '[[[1]]]\nsymbol = "1+z"\n', "SD004", 'unknown key "symbol"', "mask.symbol", 5, 1, "no symbol"),
    one("vector-stable", VECTOR + "[[[1]]]\n[expect]\nstable = true\n", "SD004", "masks of kind vector have no property stable", "expect.stable", 6, 1, "convergent, smoothness, holder, generation, dimension"),
    one("scalar-dimension", MASK + "[expect]\ndimension = 1\n", "SD004", "masks of kind scalar have no property dimension", "expect.dimension", 5, 1, "convergent, smoothness"),
    one("hermite-one-component", HERMITE + "[[[1]]]\n", "SD023", "the matrices are 1×1: a Hermite mask acts on a function", "mask.coefficients", 4, 16, 'kind = "scalar"'),
    one("hermite-flat", HERMITE + "[1, 2]\n", "SD023", "no matrix; a flat list", "mask.coefficients", 4, 16, "a list of matrices"),
    one("hermite-sizes", HERMITE + "[[[1, 0], [0, 1]], [[1]]]\n", "SD023", "the first is 2×2, and this one is 1×1", "mask.coefficients[1]", 4, 35, "a list of matrices"),
    one("vector-spectral", VECTOR + "[[[1, 0], [0, 1]]]\n[expect]\nspectral = true\n", "SD004", "no property spectral", "expect.spectral", 6, 1, "dimension"),
    several("piecewise-empty", 'kind = "piecewise"\n', ("SD005", "the left mask is missing", "left", None, None, "[left] with start"), ("SD005", "the right mask is missing", "right", None, None, "[right] with start")),
    one("piecewise-number", f'kind = "piecewise"\nleft = 3\n{SIDES[SIDES.index("[right]"):]}', "SD006", "a mask or the name of a file, not an integer", "left", 2, 8, "four_point.toml"),
    one("piecewise-no-file", f'kind = "piecewise"\nleft = "nothing.toml"\n{SIDES[SIDES.index("[right]"):]}', "SD002", "there is no such file", "left", 2, 9, "relative to this one"),
    one("piecewise-arity", PIECEWISE + "arity = 3\n", "SD023", "the left one has 2, the right one 3", "right", 5, 2, "the same arity"),
    one("piecewise-spacing", f'kind = "piecewise"\nspacing = [1, 0]\n{SIDES}', "SD010", "must be positive, not 0", "spacing[1]", 2, 15, "left and right of 0"),
    one("piecewise-spacings", f'kind = "piecewise"\nspacing = [1]\n{SIDES}', "SD006", "a list of two numbers, not a list of 1", "spacing", 2, 11, "spacing = [1, 2]"),
    one("piecewise-spacing-text", f'kind = "piecewise"\nspacing = "1"\n{SIDES}', "SD006", "not a string", "spacing", 2, 12, "spacing = [1, 2]"),
    one("piecewise-spacing-below", PIECEWISE + "spacing = [1, 2]\n", "SD004", 'unknown key "spacing" in [right]', "right.spacing", 8, 1, "above [left]"),
    one("piecewise-no-point", PIECEWISE + '[special]\n0 = {"1/2" = 1}\n', "SD004", 'there is no point "1/2"', 'special.0."1/2"', 9, 6, "weights of old points"),
    one("piecewise-no-row", PIECEWISE + '[special]\n"1/2" = {0 = 1}\n', "SD004", "a new point has an integer", 'special."1/2"', 9, 1, "weights of old points"),
    one("piecewise-far", PIECEWISE + "[special]\n0 = {101 = 1}\n", "SD010", "between -100 and 100, not at 101", "special.0.101", 9, 6, "near 0"),
    one("piecewise-row-list", PIECEWISE + "[special]\n0 = [1, 2]\n", "SD006", "a table of weights, not an array", "special.0", 9, 5, "such as 1 ="),
    one("piecewise-weight", PIECEWISE + '[special]\n0 = {0 = "1//2"}\n', "SD008", '"/" stands where', "special.0.0", 9, 13, "remove it"),
    one("piecewise-special", f'kind = "piecewise"\nspecial = 1\n{SIDES}', "SD006", "special must be a table", "special", 2, 11, "such as 1 ="),
    one("piecewise-two-variables", PIECEWISE + '[special]\n"0,1" = {0 = 1}\n', "SD013", "several components", 'special."0,1"', 9, 1, "weights of old points"),
    one("piecewise-dilation", f'kind = "piecewise"\n[left]\ndilation = 2\n{SIDES[SIDES.index("[right]"):]}', "SD013", "dilation is for masks in several variables", "left.dilation", 3, 1, "start and coefficients"),
    one("piecewise-shear", f'kind = "piecewise"\nshear = ["-1/2", 0]\n{SIDES}', "SD013", "shear is for two variables", "shear", 2, 1, "in one variable"),
    one("piecewise-zero", f'kind = "piecewise"\n[left]\ncoefficients = [0, 0]\n{SIDES[SIDES.index("[right]"):]}', "SD009", "all coefficients of the mask are zero", "left.coefficients", 3, 16, "at least one"),
    one("piecewise-far-mask", PIECEWISE.replace("start = -1", "start = 2000", 1), "SD010", "beyond index 1000", "left", 2, 2, "towards 0"),
    one("piecewise-stable", PIECEWISE + "[expect]\nstable = true\n", "SD004", "masks of kind piecewise have no property stable", "expect.stable", 9, 1, "holder_at_zero"),
    one("format-2", "format = 2\n" + MASK, "SD006", "format must be 1, not 2", "format", 1, 10, "newer subdiv"),
    one("format-text", 'format = "1"\n' + MASK, "SD006", "format must be 1, not a string", "format", 1, 11, "format = 1"),
    several(
        "many-at-once",
        'naem = "x"\n[mask]\narity = 1\nstart = "0"\ncoefficients = [true, "1/0", "q"]\n[expect]\nholdr = 1\n',
        ("SD004", "naem", "naem", 1, 1, "name?"),
        ("SD010", "arity", "mask.arity", 3, 9, "arity = 2"),
        ("SD006", "start", "mask.start", 4, 10, "without quotes"),
        ("SD006", "not true", C0, 5, 17, "-1/16"),
        ("SD007", "division by zero", C1, 5, 26, "not zero"),
        ("SD008", '"q" is not declared', "mask.coefficients[2]", 5, 31, "[parameters]"),
        ("SD004", '"holdr"', "expect.holdr", 7, 1, "holder?"),
    ),
]  # fmt: skip

NUMBERS = [
    one("zero-denominator", HEAD + '["1/0", 1]\n', "SD007", "division by zero", C0, 3, 20, "not zero"),
    one("nan", HEAD + "[1, nan]\n", "SD007", "nan is not a rational number", C1, 3, 20, "finite"),
    one("inf", HEAD + "[1, -inf]\n", "SD007", "-inf is not a rational number", C1, 3, 20, "finite"),
    one("nan-text", HEAD + '["1 + nan"]\n', "SD007", "nan is not a rational number", C0, 3, 22, "finite"),
    one("million-digits", HEAD + f"[{'1' * 200_000}]\n", "SD010", "200000 digits", C0, 3, 17, "shorter"),
    one("many-digits", HEAD + f"[{'1' * 4000}]\n", "SD010", "more than 1000 digits", C0, 3, 17, "shorter"),
    one("hex-digits", HEAD + f"[0x{'f' * 9000}]\n", "SD010", "more than 1000 digits", C0, 3, 17, "shorter"),
    one("quoted-digits", HEAD + f'["{"1" * 200_000}"]\n', "SD010", "200000 digits", C0, 3, 18, "shorter"),
    one("decimal-bomb", HEAD + "[1e999999999]\n", "SD010", "decimal exponent 999999999", C0, 3, 17, "sensible"),
    one("decimal-bomb-text", HEAD + '["1e-999999999"]\n', "SD010", "decimal exponent -999999999", C0, 3, 18, "sensible"),
    one("power-bomb", '[mask]\nsymbol = "2^99999999"\n', "SD010", "the exponent 99999999", "mask.symbol", 2, 13, "smaller"),
    one("number-bomb", '[mask]\nsymbol = "2^999999"\n', "SD010", "more than 1000 digits", "mask.symbol", 2, 11, "smaller"),
    one("tower", '[mask]\nsymbol = "((2^999)^999)^999"\n', "SD010", "more than 1000 digits", "mask.symbol", 2, 12, "smaller"),
    one("binomial-bomb", '[mask]\nsymbol = "(1+z)^1000000"\n', "SD010", "too large", "mask.symbol", 2, 11, "smaller"),
    one("far-exponent", '[mask]\nsymbol = "z^999999 z^999999"\n', "SD010", "beyond 1000000", "mask.symbol", 2, 11, "smaller"),
    one("long-symbol", '[mask]\nsymbol = "1 + z^5000"\n', "SD010", "5001 coefficients", "mask.symbol", 2, 11, "shorter"),
    one("long-mask", HEAD + f"[{'1,' * 2001}]\n", "SD010", "2001 coefficients", "mask.coefficients", 3, 16, "shorter"),
    one("denominators", HEAD + "[" + ",".join(f'"1/{10**90 + k}"' for k in range(40)) + "]\n", "SD010", "common denominator", "mask.coefficients", 3, 16, "smaller"),
    one("deep-arrays", HEAD + "[" * 5000, "SD010", "more than 32 deep", "mask.coefficients" + "[0]" * 32, 3, 48, "two levels"),
    one("deep-parentheses", HEAD + f'["{"(" * 5000}"]\n', "SD010", "more than 32 deep", C0, 3, 50, "multiply"),
    one("deep-keys", "a" + ".a" * 50_000 + " = 1\n", "SD010", "more than 32 deep", None, 1, 64, "two levels"),
]  # fmt: skip

EXPRESSIONS = [
    one("ambiguous", HEAD + '["3/8 z"]\n', "SD008", "directly after a division", C0, 3, 22, "3/8 * z, or put the divisor in parentheses, 3/(8 z)"),
    one("ambiguous-parameter", W + HEAD + '["1/2 w"]\n', "SD008", "directly after a division", C0, 5, 22, "1/2 * w"),
    one("square-root", HEAD + '["sqrt(3)/2"]\n', "SD008", "function call", C0, 3, 18, "rational masks only"),
    one("square-root-parameter", HEAD + '["1+sqrt(3)"]\n', "SD008", "function call", C0, 3, 20, "a parameter does not help"),
    one("other-function", HEAD + '["max(1)"]\n', "SD008", "function call", C0, 3, 18, "write the value itself"),
    one("variable-x", '[mask]\nsymbol = "(1+x)^4"\n', "SD008", '"x" is not declared', "mask.symbol", 2, 14, "the variable of a symbol is z"),
    one("braces", '[mask]\nsymbol = "z^{-2} (1+z)"\n', "SD008", '"{"', "mask.symbol", 2, 13, "write z^-2 or z^(-2)"),
    one("braces-after-group", '[mask]\nsymbol = "(1+z)^{4}"\n', "SD008", '"{"', "mask.symbol", 2, 17, "write ^4 or ^(4)"),
    one("superscript-minus", '[mask]\nsymbol = "z⁻¹²"\n', "SD008", '"⁻" (U+207B)', "mask.symbol", 2, 12, "write ^-12"),
    one("curly-inside", HEAD + '["“1/8”"]\n', "SD008", '"“" (U+201C)', C0, 3, 18, "leave it out"),
    one("one-name-often", HEAD + '["w", 1, "1 - w", "w", "-w"]\n', "SD008", '"w" is not declared (and in 3 more places)', C0, 3, 18, "[parameters]"),
    several(
        "two-names-often",
        HEAD + '["w", "v", "w"]\n',
        ("SD008", '"w" is not declared (and in 1 more place)', C0, 3, 18, "[parameters]"),
        ("SD008", '"v" is not declared', C1, 3, 23, "[parameters]"),
    ),
    one("root-sign", HEAD + '["√3"]\n', "SD008", "square root", C0, 3, 18, "rational masks only"),
    one("two-stars", '[mask]\nsymbol = "z**2"\n', "SD008", '"**"', "mask.symbol", 2, 12, "write ^"),
    several(
        "typographic",
        HEAD + '["−1/16", "½", "2×3", "z²"]\n',
        ("SD008", '"−"', C0, 3, 18, "write the ASCII minus \"-\" instead"),
        ("SD008", '"½"', C1, 3, 27, "write (1/2) instead"),
        ("SD008", '"×"', "mask.coefficients[2]", 3, 33, "write * instead"),
        ("SD008", '"²"', "mask.coefficients[3]", 3, 40, "write ^2"),
    ),
    one("superscript", '[mask]\nsymbol = "1+z²"\n', "SD008", '"²"', "mask.symbol", 2, 14, "write ^2"),
    one("decimal-comma", HEAD + '["0,5"]\n', "SD008", '","', C0, 3, 19, "0.5"),
    one("glued-names", W + '[mask]\nsymbol = "1 + zw"\n', "SD008", '"zw" is not declared', "mask.symbol", 4, 15, "z*w"),
    one("near-name", "[parameters]\nomega = 1\n" + HEAD + '["omga"]\n', "SD008", '"omga"', C0, 5, 18, "did you mean omega?"),
    one("unknown-name", HEAD + '["w"]\n', "SD008", '"w" is not declared', C0, 3, 18, 'w = "1/16"'),
    one("other-name", W + HEAD + '["w", "1+q"]\n', "SD008", '"q" is not declared', C1, 5, 25, "known here: w"),
    one("open-parenthesis", HEAD + '["1+(1/2"]\n', "SD008", "never closed", C0, 3, 20, 'missing ")"'),
    one("extra-parenthesis", HEAD + '["1/2)"]\n', "SD008", "closes nothing", C0, 3, 21, "remove it"),
    one("half-a-fraction", HEAD + '["1/"]\n', "SD008", "the expression ends where", C0, 3, 20, "complete"),
    one("two-slashes", HEAD + '["1//2"]\n', "SD008", '"/" stands where', C0, 3, 20, "remove it"),
    one("empty-text", HEAD + '[" "]\n', "SD008", "the expression is empty", C0, 3, 18, "-1/16"),
    one("two-numbers", HEAD + '["2 3"]\n', "SD008", "the number 3 stands directly after another number", C0, 3, 20, "write *"),
    one("missing-power-sign", '[mask]\nsymbol = "(1+z)2"\n', "SD008", "the number 2 stands directly after", "mask.symbol", 2, 16, "^ for a power"),
    one("percent", HEAD + '["5%"]\n', "SD008", '"%" cannot stand', C0, 3, 19, "has numbers, names"),
    one("power-of-power", '[mask]\nsymbol = "z^2^3"\n', "SD008", "two readings", "mask.symbol", 2, 14, "(z^2)^…"),
    one("fractional-power", '[mask]\nsymbol = "z^(1/2)"\n', "SD008", "single integer", "mask.symbol", 2, 15, "z^2"),
    one("power-parameter", W + '[mask]\nsymbol = "z^w"\n', "SD008", "an integer was expected after ^", "mask.symbol", 4, 13, "z^2"),
    one("not-laurent", '[mask]\nsymbol = "1/(1+z)"\n', "SD008", "1 + z does not divide 1 exactly", "mask.symbol", 2, 13, "no remainder"),
    one("not-laurent-remainder", '[mask]\nsymbol = "(1+z)^3 / (1-z/3) / 8"\n', "SD008", "1 - (1/3) z does not divide ", "mask.symbol", 2, 21, "no remainder"),
    one("not-laurent-power", '[mask]\nsymbol = "(1+z)^-1"\n', "SD008", "1 + z does not divide 1 exactly", "mask.symbol", 2, 11, "no remainder"),
    one("escaped", HEAD + '["\\u0031\\t/ 0"]\n', "SD007", "division by zero", C0, 3, 28, "not zero"),
    one("many-lines", HEAD + '["""\n1 + \\\n   q"""]\n', "SD008", '"q" is not declared', C0, 5, 4, "[parameters]"),
    one("crlf", (HEAD + '["q"]\n').replace("\n", "\r\n"), "SD008", '"q" is not declared', C0, 3, 18, "[parameters]"),
]  # fmt: skip

PARAMETERS = [
    one("declared-later", '[parameters]\nw = "1/v"\nv = 1\n' + MASK, "SD008", "v is declared after w", "parameters.w", 2, 8, "move v above w"),
    one("uses-itself", '[parameters]\nw = "w"\n' + MASK, "SD008", "uses itself", "parameters.w", 2, 6, "number"),
    one("called-z", "[parameters]\nz = 1\n" + MASK, "SD011", "z is the variable", "parameters.z", 2, 1, "call it w"),
    one("called-badly", '[parameters]\n"a b" = 1\n' + MASK, "SD011", "cannot be a parameter's name", 'parameters."a b"', 2, 1, "letters"),
    one("parameter-true", "[parameters]\nw = true\n" + MASK, "SD006", "not true", "parameters.w", 2, 5, "-1/16"),
]  # fmt: skip

EXPECT = [
    one("misspelt-property", MASK + "[expect]\nsmothness = 1\n", "SD004", '"smothness"', "expect.smothness", 5, 1, "smoothness?"),
    one("no-limit-but-smooth", MASK + "[expect]\nconvergent = false\nsmoothness = 1\n", "SD012", "contradicts smoothness = 1", "expect.smoothness", 6, 14, "one of the two"),
    one("reproduction-above", MASK + "[expect]\nreproduction = 3\ngeneration = 1\n", "SD012", "contradicts generation = 1", "expect.generation", 6, 14, "one of the two"),
    one("holder-below", MASK + '[expect]\nsmoothness = 2\nholder = "1.5"\n', "SD012", "at least n", "expect.holder", 6, 11, "one of the two"),
    one("holder-above", MASK + '[expect]\nsmoothness = 1\nholder = ">= log2(5)"\n', "SD012", "means C^(n+1)", "expect.holder", 6, 11, "one of the two"),
    one("holder-negative", MASK + '[expect]\nconvergent = true\nholder = "log2(1/3)"\n', "SD012", "continuous", "expect.holder", 6, 11, "one of the two"),
    one("sobolev-below-holder", MASK + '[expect]\nholder = "2"\nsobolev = "1.9"\n', "SD012", "at most the Sobolev exponent", "expect.sobolev", 6, 12, "one of the two"),
    one("sobolev-negative", MASK + '[expect]\nconvergent = true\nsobolev = "-1/2"\n', "SD012", "in L2", "expect.sobolev", 6, 12, "one of the two"),
    one("sobolev-at-the-top", "sobolev = 2\n" + MASK, "SD004", '"sobolev"', "sobolev", 1, 1, "below [expect]"),
    one("smoothness-beyond", MASK + '[expect]\nsmoothness = ">= C^2000"\n', "SD010", "too large", "expect.smoothness", 5, 20, "lower it"),
    one("holder-as-C", MASK + '[expect]\nholder = "C1"\n', "SD012", '"C1" is not declared', "expect.holder", 5, 11, "write a number"),
    one("empty-interval", MASK + '[expect]\nholder = "2 .. log2(3)"\n', "SD012", "is empty", "expect.holder", 5, 11, "smaller end first"),
    one("negative-smoothness", MASK + "[expect]\nsmoothness = -1\n", "SD012", "cannot be negative", "expect.smoothness", 5, 14, "0 or more"),
    one("fractional-smoothness", MASK + '[expect]\nsmoothness = ">= 1.5"\n', "SD012", "is an integer, not 1.5", "expect.smoothness", 5, 18, ">= 1"),
    one("upper-bound", MASK + '[expect]\nholder = "<= 2"\n', "SD012", "no comparison", "expect.holder", 5, 11, "1.99 .. 2.01"),
    one("strict", MASK + '[expect]\nholder = "> 2"\n', "SD012", "no comparison", "expect.holder", 5, 11, 'holder = ">= 2" for at least'),
    one("truth-quoted", MASK + '[expect]\nconvergent = "yes"\n', "SD006", "true or false", "expect.convergent", 5, 15, "convergent = true"),
    one("truth-number", MASK + "[expect]\nstable = 1\n", "SD006", "not an integer", "expect.stable", 5, 10, "stable = true"),
    one("order-true", MASK + "[expect]\nsmoothness = true\n", "SD006", "not true", "expect.smoothness", 5, 14, "smoothness = 1"),
    one("words", MASK + '[expect]\nholder = "about 2"\n', "SD012", '"about"', "expect.holder", 5, 11, "log2(64/9)"),
    one("logarithm-negative", MASK + '[expect]\nholder = "log2(-1)"\n', "SD012", "positive", "expect.holder", 5, 11, "log2(64/9)"),
    one("logarithm-base", MASK + '[expect]\nholder = "1 + log(3)"\n', "SD012", "needs its base", "expect.holder", 5, 15, "log3(11)/2"),
    one("order-huge", MASK + "[expect]\nsmoothness = 100000\n", "SD010", "limit is 1000", "expect.smoothness", 5, 14, "lower"),
    one("order-bomb", MASK + f"[expect]\nsmoothness = {'9' * 900}\n", "SD010", "far too large", "expect.smoothness", 5, 14, "1000"),
    one("closed-form-bomb", MASK + '[expect]\nholder = "log2(3)*99999"\n', "SD010", "too long", "expect.holder", 5, 18, "smaller"),
]  # fmt: skip

BROKEN = SYNTAX + STRUCTURE + NUMBERS + EXPRESSIONS + PARAMETERS + EXPECT

AT_SCHEME = [
    one("no-value", '[parameters]\nw = ""\n' + HEAD + '["w", 1]\n', "SD011", "w has no value", "parameters.w", 2, 6, "-p w=1/16"),
    one("zero-parameter", W + HEAD + '[1, "1/w"]\n', "SD011", "division by zero where w = 0", C1, 5, 23, "-p w="),
    one("zero-combination", W + HEAD + '["1/(2w)"]\n', "SD011", "where w = 0", C0, 5, 20, "-p w="),
    one("all-zero", W + HEAD + '["w", "2 w"]\n', "SD009", "all coefficients", "mask.coefficients", 5, 16, "other parameters"),
    one("zero-default", '[parameters]\nw = 0\nv = "1/w"\n' + HEAD + '["v"]\n', "SD011", "where w = 0", "parameters.v", 3, 8, "-p w="),
    one("divides-by-sum", W + '[mask]\nsymbol = "1/(w + z + 1)"\n', "SD008", "1 + z does not divide 1 exactly", "mask.symbol", 4, 13, "no remainder"),
    several(
        "two-at-once",
        W + HEAD + '["1/w", 1, "w^-1"]\n',
        ("SD011", "where w = 0", C0, 5, 20, "-p w="),
        ("SD011", "where w = 0", "mask.coefficients[2]", 5, 28, "-p w="),
    ),
]  # fmt: skip
