"""Understudy: teach behaviors to groups of simulated agents by showing them."""
