"""subdiv: decides convergence and smoothness of subdivision schemes from their masks, exactly."""

__version__ = "0.2.0"
