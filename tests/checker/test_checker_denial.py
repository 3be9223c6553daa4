"""Documents that are short and cheap by their own account must be cheap to check."""

import time

from subdiv_cli.checker import check_document


def haar(arity, claims, goal):
    rules = {
        "rule": "sum-rules",
        "statement": {"property": "sum-rules", "mask": 0, "order": 1},
        "witness": {"quotient": {"start": 0, "coefficients": ["1"]}},
        "uses": [],
        "work": 2 * arity**2,
    }
    mask = {"kind": "scalar", "arity": arity, "start": 0, "coefficients": ["1"] * arity}
    return {"format": "subdiv-certificate", "version": 1, "mask": mask, "goal": goal, "claims": [rules, *claims]}


def claim(rule, statement, work):
    return {"rule": rule, "statement": statement, "witness": {}, "uses": [0], "work": work}


def test_a_huge_level_of_a_constant_symbol():
    for level, verified in ((64, True), (65, False), (10_000, False)):
        norm = {"property": "norm", "mask": 0, "nu": 1, "level": level, "norm": "1"}
        document = haar(61, [claim("norm", norm, 1)] * 500, [norm])
        start = time.process_time()
        outcome = check_document(document)
        assert outcome.verified is verified, outcome.line
        assert time.process_time() - start < 5


def test_many_goals_that_are_nearly_alike():
    products = [{"property": "product", "mask": 0, "word": [0] * 400, "radius": f"1/{i}"} for i in range(2, 1002)]
    document = haar(2, [claim("product", statement, 401) for statement in products], [products[-1]] * 400)
    start = time.process_time()
    assert check_document(document).verified
    assert time.process_time() - start < 5
