"""Many files: discovery, the run over all of them, and where the shipped masks are."""

from subdiv_cli.catalog.shipped import masks_directory

__all__ = ["masks_directory"]
