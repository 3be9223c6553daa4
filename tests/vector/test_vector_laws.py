"""Laws of masks of matrices made of shipped scalar masks: blocks and copies have the answers of the mask itself."""

import pytest
from matrix_masks import blocked, diagonal, scalar, scheme

from subdiv_cli.catalog.shipped import masks_directory
from subdiv_cli.exact.closed import compare
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.pipeline import check


def masks():
    """Scalar masks of the catalog with at most eight coefficients, every seventh, by their names."""
    for path in sorted((masks_directory() / "scalar").rglob("*.toml"))[::7]:
        mask = read_path(path).scheme({})
        if len(mask.coefficients) <= 8:
            yield path.stem, mask


MASKS = dict(masks())


@pytest.mark.parametrize("name", MASKS)
def test_blocks_and_copies_have_the_answers_of_the_scheme(name):
    mask = MASKS[name]
    one = check(mask, (), Effort(2000)).result
    copy = scalar(mask.coefficients, mask.start)
    others = [scheme(copy, mask.arity), scheme(diagonal(copy, copy), mask.arity)]
    if mask.arity == 2:
        others += [scheme(blocked(mask.coefficients, mask.start, size)) for size in (2, 3)]
    for other in others:
        result = check(other, (), Effort(2000)).result
        assert result.convergent is one.convergent
        if one.convergent is Verdict.REFUTED:
            continue
        assert result.smoothness == one.smoothness
        assert result.holder.lower <= one.holder.upper
        assert one.holder.lower <= result.holder.upper
        if result.holder.exact is not None and one.holder.exact is not None:
            assert compare(result.holder.exact, one.holder.exact) == 0
