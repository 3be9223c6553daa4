"""A Hermite scheme shown, and its functions drawn: as the scheme of vectors, whose limits are f e_0."""

from subdiv_cli.kinds.vector.portrait.curves import functions
from subdiv_cli.kinds.vector.portrait.page import portrait, sections

__all__ = ["functions", "portrait", "sections"]
