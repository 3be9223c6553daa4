"""Broken masks in several variables as data, as `broken_files` has those in one."""

# One file a line:
# ruff: noqa: E501

from __future__ import annotations

from broken_files import one, several

KIND = 'kind = "multivariate"\n'
MASK = KIND + "[mask]\n"
GRID = MASK + "start = [0, 0]\ncoefficients = "
TERMS = MASK + "terms = {"
BOX = MASK + "box_spline = {directions = "
TENSOR = MASK + "tensor = ["
HAT = '{symbol = "(1+z)^2/2"}'
ONE = 'terms = {"0,0" = 1}\n'
DEEP = "[[[[[1]]]]]"

DILATION = [
    one("dilation-text", MASK + 'dilation = "2"\n' + ONE, "SD006", "an integer or a matrix, not a string", "mask.dilation", 3, 13, "dilation = 2"),
    one("dilation-one", MASK + "dilation = 1\n" + ONE, "SD010", "between 2 and 64, not 1", "mask.dilation", 3, 12, "dilation = 2"),
    one("dilation-huge", MASK + "dilation = 64\nsymbol = 'z4'\n", "SD010", "determinant 16777216", "mask.dilation", 3, 12, "smaller"),
    one("dilation-not-square", MASK + "dilation = [[2, 0], [0]]\n" + ONE, "SD022", "not square: 2 rows, and one of length 1", "mask.dilation", 3, 12, "by rows"),
    one("dilation-one-row", MASK + "dilation = [[2]]\n" + ONE, "SD022", "one row", "mask.dilation", 3, 12, '"scalar"'),
    one("dilation-empty", MASK + "dilation = []\n" + ONE, "SD022", "0 rows", "mask.dilation", 3, 12, "by rows"),
    one("dilation-five-rows", MASK + "dilation = [[2], [2], [2], [2], [2]]\n" + ONE, "SD010", "5 rows", "mask.dilation", 3, 12, "by rows"),
    one("dilation-flat", MASK + "dilation = [2, [0, 2]]\n" + ONE, "SD006", "a list of integers, not an integer", "mask.dilation[0]", 3, 13, "by rows"),
    one("dilation-fraction", MASK + 'dilation = [["1/2", 0], [0, 2]]\n' + ONE, "SD006", 'an integer was expected, not the string "1/2"', "mask.dilation[0][0]", 3, 15, "by rows"),
    one("dilation-shear", MASK + "dilation = [[1, 1], [0, 1]]\n" + ONE, "SD022", "not expanding: x^2 - 2x + 1", "mask.dilation", 3, 12, "eigenvalues"),
    one("dilation-one-expands", MASK + "dilation = [[3, 0], [0, -1]]\n" + ONE, "SD022", "x^2 - 2x - 3", "mask.dilation", 3, 12, "eigenvalues"),
    one("dilation-too-many-cosets", MASK + "dilation = [[1000, 0], [0, 1000]]\n" + ONE, "SD010", "determinant 1000000", "mask.dilation", 3, 12, "smaller"),
    one("dilation-entry-huge", MASK + "dilation = [[9999, 0], [0, 2]]\n" + ONE, "SD010", "9999 is beyond 1000", "mask.dilation[0][0]", 3, 14, "smaller"),
    one("dilation-of-three", MASK + "dilation = [[2, 0, 0], [0, 2, 0], [0, 0, 2]]\n" + ONE, "SD022", "3 rows, and the mask has 2 variables", "mask.dilation", 3, 12, "a row for each"),
]  # fmt: skip
KEYS = [
    one("arity", MASK + "arity = 2\n" + ONE, "SD004", '"arity"', "mask.arity", 3, 1, "dilation = 2"),
    one("misspelt-box", MASK + "boxspline = {}\n", "SD004", '"boxspline"', "mask.boxspline", 3, 1, "box_spline?"),
    one("directions-outside", MASK + "directions = [[1,0],[0,1]]\n", "SD004", '"directions"', "mask.directions", 3, 1, "box_spline ="),
    one("nothing", MASK + "dilation = 2\n", "SD005", "nothing gives the coefficients", "mask.coefficients", 2, 2, "tensor"),
    one("two-forms", MASK + 'symbol = "z2"\n' + ONE, "SD015", "symbol and terms", "mask.terms", 4, 1, "one of the two"),
    one("start-with-terms", MASK + ONE + "start = [0, 0]\n", "SD015", "terms and start", "mask.start", 4, 1, "one of the two"),
    one("terms-without-kind", "[mask]\n" + ONE + "dilation = 2\n", "SD005", 'kind = "multivariate" is missing: dilation is for', "mask.dilation", 3, 1, "at the top, above [mask]"),
    one("terms-in-scalar", 'kind = "scalar"\n[mask]\ncoefficients = [1]\n' + ONE, "SD004", '"terms"', "mask.terms", 4, 1, "multivariate"),
]  # fmt: skip
COEFFICIENTS = [
    one("grid-start-number", MASK + "start = 0\ncoefficients = [[1, 1]]\n", "SD006", "a list of integers, not an integer", "mask.start", 3, 9, "[-1, -1]"),
    one("grid-start-short", MASK + "start = [0]\ncoefficients = [[1, 1]]\n", "SD023", "nested 2 deep", "mask.start", 3, 9, "each variable"),
    one("grid-start-far", MASK + "start = [0, 2000]\ncoefficients = [[1, 1]]\n", "SD010", "2000 is beyond 1000", "mask.start[1]", 3, 13, "smaller"),
    one("grid-index-far", MASK + "start = [0, 1000]\ncoefficients = [[1, 1]]\n", "SD010", "an index beyond 1000", "mask.coefficients", 4, 16, "towards 0"),
    one("grid-flat", GRID + "[1, 1]\n", "SD023", "one flat list", "mask.coefficients", 4, 16, '"scalar"'),
    one("grid-text", GRID + '"1"\n', "SD006", "a list of lists, not a string", "mask.coefficients", 4, 17, "list of rows"),
    one("grid-empty", GRID + "[]\n", "SD009", "the mask is empty", "mask.coefficients", 4, 16, "list of rows"),
    one("grid-empty-row", GRID + "[[], [1]]\n", "SD009", "first row is empty", "mask.coefficients", 4, 16, "list of rows"),
    one("grid-five-deep", GRID + DEEP + "\n", "SD010", "nested 5 deep", "mask.coefficients", 4, 16, "list of rows"),
    one("grid-ragged", GRID + "[[1, 2], [3]]\n", "SD023", "a list of 2 was expected", "mask.coefficients[1]", 4, 25, "zeros"),
    one("grid-number-for-row", GRID + "[[1, 2], 3]\n", "SD023", "not an integer", "mask.coefficients[1]", 4, 25, "list of rows"),
    one("grid-deeper", GRID + "[[1, [2]]]\n", "SD023", "nested deeper", "mask.coefficients[0][1]", 4, 21, "list of rows"),
    one("grid-zero", GRID + "[[0, 0]]\n", "SD009", "all coefficients", "mask.coefficients", 4, 16, "not be zero"),
    one("grid-huge", GRID + "[" + ", ".join(["[" + ", ".join(["0"] * 150) + "]"] * 70) + "]\n", "SD010", "more than 10000 coefficients", "mask.coefficients[66][100]", 4, 30150, "terms"),
    several("grid-numbers", GRID + '[["1/0", w]]\n', ("SD001", "must be quoted", "mask.coefficients[0][1]", 4, 25, '"w"')),
    several("grid-expressions", GRID + '[["1/0", "w"], ["z1", "z"]]\n',
            ("SD007", "division by zero", "mask.coefficients[0][0]", 4, 21, "not zero"), ("SD008", '"w" is not declared', "mask.coefficients[0][1]", 4, 26, "[parameters]"),
            ("SD008", "z1 cannot stand in a single number", "mask.coefficients[1][0]", 4, 33, "symbol"), ("SD008", "z cannot stand in a single number", "mask.coefficients[1][1]", 4, 39, "symbol")),
    one("terms-list", MASK + "terms = [1]\n", "SD006", "must be a table, not an array", "mask.terms", 3, 9, '"0,0" = 1'),
    one("terms-empty", MASK + "terms = {}\n", "SD009", "empty", "mask.terms", 3, 9, '"0,0" = 1'),
    one("terms-key", TERMS + "x = 1}\n", "SD023", '"x" is no index', "mask.terms.x", 3, 10, '"1,-1"'),
    one("terms-minus", TERMS + '"0,−1" = 1}\n', "SD023", "is no index", 'mask.terms."0,−1"', 3, 10, 'plain characters: "0,-1"'),
    one("terms-one-component", TERMS + '"3" = 1}\n', "SD023", "1 component;", "mask.terms.3", 3, 10, "each variable"),
    one("terms-mixed", TERMS + '"0,0" = 1, "0,0,0" = 1}\n', "SD023", "3 components, and the first one has 2", 'mask.terms."0,0,0"', 3, 21, "each index"),
    one("terms-twice", TERMS + '"0,0" = 1, "0, 0" = 1}\n', "SD015", "0,0 is given twice", 'mask.terms."0, 0"', 3, 21, "one of the two"),
    one("terms-far", TERMS + '"0,1001" = 1}\n', "SD010", "beyond 1000", 'mask.terms."0,1001"', 3, 10, "towards 0"),
    one("terms-number", TERMS + '"0,0" = [1]}\n', "SD006", "a number was expected", 'mask.terms."0,0"', 3, 18, "multivariate"),
    one("terms-unquoted", TERMS + "0,0 = 1}\n", "SD001", '"=" was expected after the key 0', None, 3, 11, '"0,0" = 1'),
    one("terms-zero", TERMS + '"0,0" = 0}\n', "SD009", "all coefficients", "mask.terms", 3, 9, "not be zero"),
]  # fmt: skip
SYMBOL = [
    one("symbol-number", MASK + "symbol = 1\n", "SD006", "a string, not an integer", "mask.symbol", 3, 10, "z1, z2"),
    one("symbol-z", MASK + 'symbol = "z1 z + z2"\n', "SD008", "z alone is no variable", "mask.symbol", 3, 14, "z1, z2, z3, z4"),
    one("symbol-z3-in-plane", MASK + 'dilation = [[1, 1], [1, -1]]\nsymbol = "z1 z3"\n', "SD008", "no variable z3", "mask.symbol", 4, 14, "are z1, z2"),
    one("symbol-z5", MASK + 'symbol = "z5"\n', "SD008", "no variable z5", "mask.symbol", 3, 11, "z1, z2, z3, z4"),
    one("symbol-of-one", MASK + 'symbol = "(1+z1)^2/2"\n', "SD023", "z2 is not in it", "mask.symbol", 3, 11, "[[2, 0], [0, 2]]"),
    one("symbol-quotient", MASK + 'symbol = "(1-z2)/(1-z1)"\n', "SD008", "1 - z1 does not divide 1 - z2 exactly", "mask.symbol", 3, 18, "leave no remainder"),
    one("symbol-too-large", MASK + 'symbol = "(1+z1)^60 (1+z2)^60"\n', "SD010", "more than 2000 terms", "mask.symbol", 3, 11, "smaller"),
    one("symbol-power", MASK + 'symbol = "(z1^999999 z2)^9"\n', "SD010", "beyond 1000000", "mask.symbol", 3, 11, "smaller"),
    one("symbol-far", MASK + 'symbol = "z1^1001 z2"\n', "SD010", "an index beyond 1000", "mask.symbol", 3, 11, "towards 0"),
    one("symbol-z1-in-scalar", '[mask]\nsymbol = "1+z1"\n', "SD008", "one variable, and z1 is not it", "mask.symbol", 2, 13, "multivariate"),
    one("parameter-z3", KIND + '[parameters]\nz3 = 1\n[mask]\nsymbol = "z2"\n', "SD011", "z3 is the variable", "parameters.z3", 3, 1, "call it w"),
]  # fmt: skip
BOXES = [
    one("box-list", MASK + "box_spline = [[1,0]]\n", "SD006", "must be a table", "mask.box_spline", 3, 14, "directions ="),
    one("box-empty", MASK + "box_spline = {}\n", "SD005", "directions of the box spline", "mask.box_spline.directions", 3, 1, "directions ="),
    one("box-key", BOX + "[[1,0],[0,1]], multiplicity = [1,1]}\n", "SD004", "multiplicity", "mask.box_spline.multiplicity", 3, 43, "multiplicities?"),
    one("box-no-directions", BOX + "[]}\n", "SD006", "not an empty list", "mask.box_spline.directions", 3, 28, "directions ="),
    several("box-numbers", BOX + "[1, 0]}\n", ("SD006", "a direction must be a list", "mask.box_spline.directions[0]", 3, 29, "directions ="), ("SD006", "a direction must be a list", "mask.box_spline.directions[1]", 3, 32, "directions =")),
    one("box-mixed", BOX + "[[1,0],[0,1,1]]}\n", "SD023", "different numbers of components", "mask.box_spline.directions", 3, 28, "each variable"),
    one("box-one-variable", BOX + "[[1],[1]]}\n", "SD023", "1 component;", "mask.box_spline.directions", 3, 28, "directions ="),
    one("box-flat", BOX + "[[1,0],[2,0]]}\n", "SD023", "span 1 of 2 dimensions", "mask.box_spline.directions", 3, 28, "add a direction"),
    one("box-zero", BOX + "[[1,0],[0,1],[0,0]]}\n", "SD023", "zero", "mask.box_spline.directions", 3, 28, "leave it out"),
    one("box-multiplicities", BOX + "[[1,0],[0,1]], multiplicities = [1]}\n", "SD023", "1 multiplicities for 2", "mask.box_spline.multiplicities", 3, 60, "each direction"),
    one("box-multiplicity-zero", BOX + "[[1,0],[0,1]], multiplicities = [1,0]}\n", "SD010", "at least 1, not 0", "mask.box_spline.multiplicities", 3, 60, "leave the direction out"),
    one("box-too-many", BOX + "[[1,0],[0,1]], multiplicities = [60,60]}\n", "SD010", "120 factors", "mask.box_spline.multiplicities", 3, 60, "smaller"),
    one("box-too-large", BOX + "[[1,0],[0,1]], multiplicities = [32,32]}\n" + "dilation = 64\n", "SD010", "too large", "mask.box_spline", 3, 14, "smaller"),
    one("box-far", BOX + "[[999,0],[0,1]], multiplicities = [2, 1]}\n", "SD010", "an index beyond 1000", "mask.box_spline", 3, 14, "towards 0"),
    one("box-quincunx", MASK + "dilation = [[1, 1], [1, -1]]\nbox_spline = {directions = [[1,0],[0,1]]}\n", "SD022", "not for this matrix", "mask.dilation", 3, 12, "symbol in z1"),
]  # fmt: skip
TENSORS = [
    one("tensor-text", MASK + 'tensor = "x.toml"\n', "SD006", "a list of masks, not a string", "mask.tensor", 3, 11, "for each variable"),
    one("tensor-one", TENSOR + HAT + "]\n", "SD023", "tensor has 1 mask;", "mask.tensor", 3, 10, "for each variable"),
    one("tensor-number", TENSOR + HAT + ", 2]\n", "SD006", "a mask or the name of a file", "mask.tensor[1]", 3, 35, "for each variable"),
    one("tensor-z2", TENSOR + HAT + ', {symbol = "z2"}]\n', "SD008", "one variable, and z2", "mask.tensor[1].symbol", 3, 46, "write z"),
    one("tensor-key", TENSOR + HAT + ', {dilation = 2, symbol = "z"}]\n', "SD004", '"dilation"', "mask.tensor[1].dilation", 3, 36, "arity = 2"),
    one("tensor-arities", TENSOR + HAT + ', {arity = 3, symbol = "z"}]\n', "SD023", "there are 2 and 3", "mask.tensor", 3, 10, "same arity"),
    one("tensor-no-file", TENSOR + HAT + ', "none.toml"]\n', "SD002", 'in "none.toml": there is no such file', "mask.tensor[1]", 3, 36, "relative to this one"),
    one("tensor-stdin", TENSOR + HAT + ', "-"]\n', "SD002", "no regular file", "mask.tensor[1]", 3, 36, "relative to this one"),
    one("tensor-null", TENSOR + HAT + ', "a\\u0000b"]\n', "SD002", "no such file", "mask.tensor[1]", 3, 36, "relative to this one"),
    one("tensor-dilation", MASK + f"dilation = 3\ntensor = [{HAT}, {HAT}]\n", "SD022", "of arity 2", "mask.dilation", 3, 12, "leave dilation out"),
    one("tensor-dilation-matrix", MASK + f"dilation = [[1, 1], [1, -1]]\ntensor = [{HAT}, {HAT}]\n", "SD022", "of arity 2", "mask.dilation", 3, 12, "leave dilation out"),
    one("tensor-zero", TENSOR + HAT + ', {symbol = "z - z"}]\n', "SD009", "all coefficients", "mask.tensor[1].symbol", 3, 46, "not be zero"),
    one("tensor-too-large", TENSOR + ", ".join(['{symbol = "(1+z)^44"}'] * 3) + "]\n", "SD010", "91125 coefficients", "mask.tensor", 3, 10, "smaller"),
]  # fmt: skip
BROKEN = [*DILATION, *KEYS, *COEFFICIENTS, *SYMBOL, *BOXES, *TENSORS]
AT_SCHEME = [
    one("multivariate-zero", KIND + "[parameters]\nw = 0\n[mask]\n" + 'terms = {"0,0" = "w", "1,1" = "w^2"}\n', "SD009", "all coefficients", "mask.terms", 5, 9, "other parameters"),
    one("multivariate-division", KIND + "[parameters]\nw = 0\n[mask]\n" + 'symbol = "z2/w"\n', "SD011", "division by zero where w = 0", "mask.symbol", 5, 14, "-p w=1/16"),
]  # fmt: skip
