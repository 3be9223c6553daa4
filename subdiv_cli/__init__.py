"""subdiv: decides convergence and smoothness of subdivision schemes from their masks, exactly."""

__version__ = "0.1.0"
