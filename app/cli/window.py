"""No verb: the studio's window. It imports no more than it needs, so that the window is there soon."""

import gc
from pathlib import Path

import platformdirs

from ..core.storage.loading import refuse_no_project
from ..core.storage.migrations import PROJECT_FILE
from .console import PROGRAM
from .places import FIRST_PROJECT, shipped_project


def open_window(project: Path | None, *, trust: bool) -> int:
    """Open the studio on *project*, or on the foraging project, until the user closes it."""
    named = project or shipped_project(FIRST_PROJECT)
    folder = named.parent if named.name == PROJECT_FILE else named
    refuse_no_project(folder)
    gc.disable()  # nothing of what is imported goes away again; later on the window looks itself, see `editor.garbage`
    from ..editor.application import run

    gc.freeze()
    settings = platformdirs.user_config_path(PROGRAM, appauthor=False) / "studio.ini"
    state = platformdirs.user_state_path(PROGRAM, appauthor=False)
    return run(folder, settings, state, trust=trust)
