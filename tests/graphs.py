"""Whole graphs of automata."""

from collections.abc import Sequence
from itertools import chain

from app.core.automaton import Automaton
from app.core.examples import Example
from app.core.library import Library
from app.core.vocabulary import Vocabulary
from app.export.graph import AutomatonGraph, edges_from, graph_with


def graph_of(
    automaton: Automaton, library: Library, vocabulary: Vocabulary, examples: Sequence[Example] = ()
) -> AutomatonGraph:
    """The graph of an automaton, with the edges from each of its states."""
    edges = (edges_from(state.id, automaton, vocabulary, examples) for state in automaton.states)
    return graph_with(automaton, library, chain.from_iterable(edges))
