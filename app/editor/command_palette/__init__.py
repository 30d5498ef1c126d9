"""The command palette: every action, behavior, node, arm, parameter and setting, found by a few letters."""
