"""The session without a window: frozen commands in, frozen snapshots out; teaching, running, and experiments.

May import `app.learner`, `app.sim` and `app.core`; never Qt. The engine owns the world, its caller owns the project.
"""
