"""Failures of the program itself: what is kept of one in a file that can be sent with a report."""

import platform
import sys
import tempfile
import traceback
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path

import platformdirs

from .. import __version__

#: As the folders of the user's system know it.
PROGRAM = "understudy"


def traced(error: BaseException) -> str:
    """Where in the program it happened."""
    return "".join(traceback.format_exception(error))


def keep(error: BaseException, arguments: Sequence[str] | None = None) -> Path | None:
    """Write a file about a failure; None if no folder can be written to.

    Args:
        arguments: What the user typed; by default the command line's.
    """
    name = f"crash-{datetime.now(UTC):%Y%m%d-%H%M%S-%f}.txt"
    text = _text(traced(error), sys.argv[1:] if arguments is None else arguments)
    for folder in (platformdirs.user_log_path(PROGRAM, appauthor=False), Path(tempfile.gettempdir())):
        try:
            folder.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text, encoding="utf-8")
        except OSError:
            continue
        return folder / name
    return None


def _text(trace: str, arguments: Sequence[str]) -> str:
    head = (
        f"{PROGRAM} {__version__}, Python {platform.python_version()}, {platform.platform()}",
        f"arguments: {list(arguments)}",
    )
    return "\n".join((*head, "", trace))
