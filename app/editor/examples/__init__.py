"""The examples of the automaton that is shown."""
