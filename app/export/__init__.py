"""What leaves Understudy: one neutral graph of an automaton, and one module per format.

Knows `app.learner`, `app.sim` and `app.core`; nothing here runs a world or knows Qt.
"""
