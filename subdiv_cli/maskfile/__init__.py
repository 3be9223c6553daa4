"""Text <-> scheme: TOML mask files, expressions, expectations and positions; all errors of a file at once.

Reading keeps expressions (`read_text`, `read_path`); `MaskFile.scheme` substitutes parameters. Numbers are Fractions,
sizes are bounded before anything is computed (`bounds`), and nothing but `MaskFileError` is raised. What the command
line spells is in `option`, the way back to text in `writer`: they are imported from there, where they are needed.
"""

from __future__ import annotations

from subdiv_cli.maskfile.mask import MaskFile, from_scheme
from subdiv_cli.maskfile.problems import MaskFileError
from subdiv_cli.maskfile.reader import load_path, read_bytes, read_path, read_text

__all__ = ["MaskFile", "MaskFileError", "from_scheme", "load_path", "read_bytes", "read_path", "read_text"]
