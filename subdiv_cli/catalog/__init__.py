"""Many files: discovery, the run over all of them, and where the shipped masks are."""

from subdiv_cli.catalog.shipped import masks_directory

__all__ = ["ClusterError", "masks_directory"]


class ClusterError(Exception):
    """The Dask cluster cannot be used; the text says why."""
