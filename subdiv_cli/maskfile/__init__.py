"""Text of mask files: TOML, expressions, expectations and positions; all errors of a file at once. It knows no kind.

Reading keeps expressions; `MaskFile.scheme` substitutes parameters. Numbers are Fractions, sizes are bounded before
anything is computed (`bounds`), and nothing but `MaskFileError` is raised. Which kinds there are, and what the files of
each say, is in `kinds`.
"""

from __future__ import annotations

from subdiv_cli.maskfile.mask import MaskFile
from subdiv_cli.maskfile.problems import MaskFileError

__all__ = ["MaskFile", "MaskFileError"]
