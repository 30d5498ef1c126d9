"""Prunes and moved cuts in words."""

from ...core.automaton import Automaton, Cut, Prune
from ...core.conditions import Condition
from ...core.cuts import stands
from ...core.library import Library
from ...core.tree import Tree
from ...core.vocabulary import Vocabulary
from ...core.wording import condition_words, guard_words, state_words


def prune_words(prune: Prune, automaton: Automaton, library: Library, vocabulary: Vocabulary) -> str:
    """A prune: "Wander: never to ReturnWithBox when sees a box"."""
    names = [state_words(automaton, label, library) for label in sorted(prune.forbidden)]
    source = state_words(automaton, prune.source, library)
    when = f" when {guard_words(prune.guard, automaton, vocabulary)}" if prune.guard else ""
    return f"{source}: never to {' or '.join(names)}{when}"


def cut_words(cut: Cut, automaton: Automaton, library: Library, vocabulary: Vocabulary) -> str:
    """A moved cut: "Forward: cut at within 4.5 of deposit"."""
    source = state_words(automaton, cut.source, library)
    said = condition_words(Condition(cut.test), automaton, vocabulary)
    tree = automaton.learned.get(cut.source)
    waits = (
        "" if isinstance(tree, Tree) and stands(tree, cut) else " (waits: the tree does not test that now)"
    )
    return f"{source}: cut moved to “{said}”{waits}"
