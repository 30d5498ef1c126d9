"""Where the projects are that ship with Understudy: beside an installed package, or in a clone."""

from pathlib import Path

from ..core.errors import StorageError

ROOT = Path(__file__).parents[1]
#: Holds the lock and the set-up, if this is a clone.
CLONE = ROOT.parent
PROJECTS = "projects"


def shipped_folder(path: Path) -> Path:
    """The folder at *path* among what ships.

    Raises:
        StorageError: It is not there.
    """
    places = [ROOT / path, CLONE / path]
    for place in places:
        if place.is_dir():
            return place
    raise StorageError(f"the project {path.name!r} is missing; looked for it in {places[0]} and {places[1]}")


def shipped_projects() -> tuple[Path, ...]:
    """The folders of all projects that ship, by name."""
    for place in (ROOT / PROJECTS, CLONE / PROJECTS):
        if place.is_dir():
            return tuple(sorted(folder.parent for folder in place.glob("*/project.json")))
    return ()


def is_shipped(folder: Path) -> bool:
    """Whether *folder* is one of those that ship."""
    return folder.resolve() in {shipped.resolve() for shipped in shipped_projects()}
