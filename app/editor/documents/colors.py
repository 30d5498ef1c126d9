"""Which colors a project's behaviors have, kept beside the project, so that it looks the same when it is opened again."""

import contextlib
import json
from collections.abc import Mapping
from pathlib import Path

from ...core.project import Project
from ..behavior_colors import Places, first_places
from . import private

COLORS = "colors.json"


def read(private_folder: Path) -> Places:
    """The places in the row of colors by the behaviors' names; empty where nothing sensible is kept."""
    try:
        found = json.loads((private_folder / COLORS).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    sensible = isinstance(found, dict) and all(type(place) is int and place >= 0 for place in found.values())
    return found if sensible and len(set(found.values())) == len(found) else {}


def keep(private_folder: Path, project: Project, places: Mapping[str, int]) -> None:
    """Keep the colors of *project*, unless they are those that it gets in any case.

    Where nothing can be written, it is opened with other colors, and that is all.
    """
    with contextlib.suppress(OSError):
        if places != first_places(project):
            private.make(private_folder)
            private.write_whole(private_folder / COLORS, json.dumps(dict(places), indent=1))
        else:
            (private_folder / COLORS).unlink(missing_ok=True)
