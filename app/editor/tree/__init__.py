"""The decision tree of the state that is shown."""
