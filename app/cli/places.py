"""Where the program is, and what it runs on."""

import os
import sys
from pathlib import Path

from ..engine.shipped import CLONE, PROJECTS, ROOT, shipped_folder

__all__ = ["CLONE", "FIRST_PROJECT", "ROOT", "display", "shipped_bench", "shipped_project"]

#: The project to begin with.
FIRST_PROJECT = "foraging"


def shipped_project(name: str) -> Path:
    """The folder of a project that ships with Understudy: beside an installed package, or in a clone."""
    return shipped_folder(Path(PROJECTS, name))


def shipped_bench(name: str) -> Path:
    """The folder of a project that only `understudy bench` looks at."""
    return shipped_folder(Path("resources", "bench", name))


def display() -> str:
    """The screen that windows would open on; empty if there is none."""
    if sys.platform != "linux":
        return sys.platform
    return os.environ.get("WAYLAND_DISPLAY") or os.environ.get("DISPLAY") or ""
