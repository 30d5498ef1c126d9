"""Measures and shares over time while a world runs, for the world or a group."""
