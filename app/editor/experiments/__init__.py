"""The window of experiments: choosing and building them, watching them run, and what came of them."""
