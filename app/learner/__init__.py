"""From examples to transition functions: datasets, the tree builder, other classifiers, pruning and evaluation.

May import `app.core`, numpy, scipy, and scikit-learn in `sklearn_backends` alone, which is loaded only when one of its
classifiers is asked for. Knows no world, no thread and no clock; every function returns a new value, and the same
examples give the same models whatever their order.
"""
