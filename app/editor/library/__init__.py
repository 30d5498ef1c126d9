"""The behaviors, by type and kind."""
