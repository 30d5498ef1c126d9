"""Values and rules: what a behavior is and what one tick of it does.

Only the standard library, networkx and pydantic may be imported here; never Qt, numba, scikit-learn, a clock, or global
random numbers. Every value is frozen, every edit is a function from one value to the next.
"""
