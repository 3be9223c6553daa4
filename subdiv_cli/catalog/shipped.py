"""The place of the masks that ship with subdiv."""

from __future__ import annotations

from pathlib import Path


def masks_directory() -> Path:
    """The catalog beside this package in an installation, above it in a checkout. Raises FileNotFoundError for none."""
    package = Path(__file__).parents[1]
    for directory in (package / "masks", package.parent / "masks"):
        if directory.is_dir():
            return directory
    raise FileNotFoundError("the masks that ship with subdiv are missing: install the package again")
