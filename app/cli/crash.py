"""When the program itself is wrong: a short message, and a file that can be sent with a report."""

import platform
import sys
import tempfile
import traceback
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path

import platformdirs

from .. import __version__
from .console import PROGRAM, say


def report(error: Exception, arguments: Sequence[str], *, show: bool = False) -> None:
    """Keep the traceback in a file and tell the user.

    Args:
        show: Print it as well.
    """
    trace = "".join(traceback.format_exception(error))
    say(f"the program failed: {type(error).__name__}: {error}")
    kept = _kept(_text(trace, arguments))
    if kept is not None:
        say(f"this should not happen; please report it, with what is in {kept}")
    if show or kept is None:
        print(trace, file=sys.stderr)


def _text(trace: str, arguments: Sequence[str]) -> str:
    head = (
        f"{PROGRAM} {__version__}, Python {platform.python_version()}, {platform.platform()}",
        f"arguments: {list(arguments)}",
    )
    return "\n".join((*head, "", trace))


def _kept(text: str) -> Path | None:
    """The file that *text* was written to; None if no folder could be written to."""
    name = f"crash-{datetime.now(UTC):%Y%m%d-%H%M%S-%f}.txt"
    for folder in (platformdirs.user_log_path(PROGRAM, appauthor=False), Path(tempfile.gettempdir())):
        try:
            folder.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text, encoding="utf-8")
        except OSError:
            continue
        return folder / name
    return None
