"""``python -m app.cli.first_window PROJECT``: the studio as a user starts it; says once its window was painted, and ends.

For `understudy bench`, which times it.
"""

import sys
from pathlib import Path

from . import application  # noqa: F401 - as every start imports it


def main(project: str) -> int:
    """Start, say that the window is there, close it."""
    from ..editor.bench.first_window import tell_when_painted
    from .window import open_window

    look = tell_when_painted()
    code = open_window(Path(project), trust=False)
    del look
    return code


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
