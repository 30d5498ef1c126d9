"""Processes that this program starts: its own modules, found as they are found here."""

import os
import sys
import threading
from collections.abc import Mapping
from multiprocessing import parent_process, resource_tracker
from pathlib import Path


def python(module: str, *words: str) -> list[str]:
    """The command that runs a module of this program."""
    return [sys.executable, "-P", "-m", module, *words]


def environment() -> Mapping[str, str]:
    """What such a process is given: it imports from where this one does."""
    return {**os.environ, "PYTHONPATH": os.pathsep.join(entry or str(Path.cwd()) for entry in sys.path)}


def clear_up_in_silence() -> None:
    """Have Python clear up after processes without a word, also where this one is ended at once; before any is started."""
    quiet = "ignore::UserWarning"
    sys.warnoptions.append(quiet)  # what clears up is given them on its command line
    try:
        resource_tracker.ensure_running()
    finally:
        sys.warnoptions.remove(quiet)


def end_with_parent() -> None:
    """Called in a worker of an executor, which would outlive a parent that was killed."""
    threading.Thread(target=_await_parent, daemon=True).start()


def _await_parent() -> None:
    parent = parent_process()
    if parent is not None:
        parent.join()
    os._exit(1)


def step_back(by: int) -> None:
    """Leave the cores to the window where both want them; called in the process that was started.

    Args:
        by: How far, from 1 to 19: 5 where the user waits for it, more where many things are to be done.
    """
    if hasattr(os, "nice"):
        os.nice(by)
