"""Text <-> scheme: TOML mask files, expressions, expectations and positions; all errors of a file at once.

Reading keeps expressions (`read_text`, `read_path`, `from_option`); `MaskFile.scheme` substitutes parameters. Numbers
are Fractions, sizes are bounded before anything is computed (`bounds`), and nothing but `MaskFileError` is raised.
"""

from __future__ import annotations

from subdiv_cli.maskfile.mask import MaskFile, from_scheme
from subdiv_cli.maskfile.option import from_option, parse_expectation, parse_override, parse_property
from subdiv_cli.maskfile.problems import MaskFileError
from subdiv_cli.maskfile.reader import read_path, read_text
from subdiv_cli.maskfile.recognise import is_mask
from subdiv_cli.maskfile.writer import write

__all__ = [
    "MaskFile",
    "MaskFileError",
    "from_option",
    "from_scheme",
    "is_mask",
    "parse_expectation",
    "parse_override",
    "parse_property",
    "read_path",
    "read_text",
    "write",
]
