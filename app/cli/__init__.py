"""The command line: it reads what the user typed, has the work done, and prints what came out.

`verbs` says what can be typed and imports next to nothing, so that help comes at once. Each verb's work is in the module
of its name, which shapes tables and JSON apart from doing anything. Only this package prints.
"""

from .application import main

__all__ = ["main"]
