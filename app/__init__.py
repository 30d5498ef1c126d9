"""Understudy: teach behaviors to groups of simulated agents by showing them."""

__version__ = "0.1.0"
