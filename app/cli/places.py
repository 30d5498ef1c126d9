"""Where the program is, and what it runs on."""

import os
import sys
from pathlib import Path

from ..core.errors import StorageError

ROOT = Path(__file__).parents[1]
#: Holds the lock and the set-up, if this is a clone.
CLONE = ROOT.parent


def shipped_project(name: str) -> Path:
    """The folder of a project that ships with Understudy: beside an installed package, or in a clone."""
    return _shipped(Path("projects", name))


def shipped_bench(name: str) -> Path:
    """The folder of a project that only `understudy bench` looks at."""
    return _shipped(Path("resources", "bench", name))


def _shipped(path: Path) -> Path:
    places = [ROOT / path, CLONE / path]
    for place in places:
        if place.is_dir():
            return place
    raise StorageError(f"the project {path.name!r} is missing; looked for it in {places[0]} and {places[1]}")


def cores() -> int:
    """How many cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def display() -> str:
    """The screen that windows would open on; empty if there is none."""
    if sys.platform != "linux":
        return sys.platform
    return os.environ.get("WAYLAND_DISPLAY") or os.environ.get("DISPLAY") or ""
