"""When the program itself is wrong: a short message, and a file that can be sent with a report."""

import sys
from collections.abc import Sequence

from ..engine import crashes
from .console import say


def report(error: Exception, arguments: Sequence[str], *, show: bool = False) -> None:
    """Keep the traceback in a file and tell the user.

    Args:
        show: Print it as well.
    """
    say(f"the program failed: {type(error).__name__}: {error}")
    kept = crashes.keep(error, arguments)
    if kept is not None:
        say(f"this should not happen; please report it, with what is in {kept}")
    if show or kept is None:
        print(crashes.traced(error), file=sys.stderr)
