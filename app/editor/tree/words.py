"""Prunes, moved cuts, and why there is no tree, in words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...core.automaton import Automaton, Cut, Prune, Refit
from ...core.conditions import Condition
from ...core.cuts import stands
from ...core.library import Library
from ...core.tree import Tree
from ...core.vocabulary import Vocabulary
from ...core.wording import condition_words, guard_words, state_words
from ...learner.registry import METHODS

if TYPE_CHECKING:
    from .subject import Subject

#: Of the states that have learned something, so many are named.
MOST_NAMED = 4


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


def treeless_words(subject: Subject | None) -> str:
    """Why a state has no tree, and what to do."""
    if subject is None:
        return "Choose a behavior in the library to see how it decides."
    name = subject.name(subject.state)
    if isinstance(subject.model, Refit):
        title = METHODS[subject.model.classifier].title
        return f"{title} has no tree to show: {name} decides by a model that is fitted to its examples."
    if subject.automaton.rules_of(subject.state):
        return f"{name} has learned nothing; its rules decide, and what they leave stays."
    said = f"{name} has learned nothing yet, so it stays for ever. Teach it, or add a rule."
    taught = [subject.name(s.id) for s in subject.automaton.states if s.id in subject.automaton.learned]
    named = f"{', '.join(taught[:MOST_NAMED])}{' or another state' if taught[MOST_NAMED:] else ''}"
    return f"{said}\n\nTo see what was learned, choose above: {named}." if taught else said
