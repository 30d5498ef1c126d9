"""What diagrams have in common, of automata and of trees: a view to pan and zoom, text that fits, paths, bars."""
