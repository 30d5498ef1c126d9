"""Rigid physics: pymunk moves the bodies. pymunk may be imported here and nowhere else.

Time is counted in ticks, lengths in world units, and an agent has mass 1. A run's physics is a function of its columns and
of what the solver remembers from one tick to the next; the latter is thrown away at every keyframe.
"""

from .physics import KEYFRAME, RigidPhysics

__all__ = ["KEYFRAME", "RigidPhysics"]
