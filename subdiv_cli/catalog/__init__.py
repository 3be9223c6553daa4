"""The catalog: discovery of many files, the run over all of them, and the place of the shipped masks."""

from subdiv_cli.catalog.shipped import masks_directory

__all__ = ["ClusterError", "masks_directory"]


class ClusterError(Exception):
    """Raised where the Dask cluster cannot be used; the text says why."""
