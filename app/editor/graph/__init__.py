"""The automaton that is shown, as a graph."""
