"""Processes that this program starts: its own modules, found as they are found here."""

import os
import sys
from collections.abc import Mapping
from pathlib import Path


def python(module: str, *words: str) -> list[str]:
    """The command that runs a module of this program."""
    return [sys.executable, "-P", "-m", module, *words]


def environment() -> Mapping[str, str]:
    """What such a process is given: it imports from where this one does."""
    return {**os.environ, "PYTHONPATH": os.pathsep.join(entry or str(Path.cwd()) for entry in sys.path)}


def step_back(by: int) -> None:
    """Leave the cores to the window where both want them; called in the process that was started.

    Args:
        by: How far, from 1 to 19: 5 where the user waits for it, more where many things are to be done.
    """
    if hasattr(os, "nice"):
        os.nice(by)
