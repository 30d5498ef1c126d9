"""How sure a state is of what comes next, whatever is seen: found without looking at any world."""

from .automaton import Automaton
from .transition import Classifier
from .tree import Leaf, Tree, shares


def least_certainty(automaton: Automaton, state: str, classifier: Classifier | None) -> float:
    """The most probable next state is at least as probable as this, in every situation; 0 where that is not known."""
    if any(0.0 < rule.probability < 1.0 for rule in automaton.rules_of(state)):
        return 0.0
    if classifier is None:
        return 1.0  # it stays, or a rule decides
    if not isinstance(classifier, Tree):
        return 0.0
    least = min(_certainty(node) for node in classifier.nodes() if isinstance(node, Leaf))
    if least < 1.0 and automaton.prunes_of(state):
        return 0.0  # what they leave of a leaf may be less clear than the leaf
    return least


def _certainty(leaf: Leaf) -> float:
    return max(shares(leaf.counts)) if any(leaf.counts) else 1.0  # no data: it stays
