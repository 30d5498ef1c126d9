"""What windows saved by themselves: writing it, finding it after a crash, and throwing it away."""

import contextlib
import json
import shutil
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from datetime import datetime
from pathlib import Path

from ...core.project import Project
from ...core.storage import load, save
from . import private
from .claims import Owner

PROJECT, ABOUT = "autosave", "autosave.json"


@dataclass(frozen=True, slots=True)
class Autosave:
    """A project as a window saved it by itself.

    Attributes:
        private: The private folder that it is in.
        folder: The project's own; None if none holds it yet.
        name: What the project is called.
        at: When it was written.
        owner: The window.
    """

    private: Path
    folder: Path | None
    name: str
    at: datetime
    owner: Owner

    @property
    def is_left_over(self) -> bool:
        """Whether its window is gone without having closed it."""
        return not self.owner.lives

    def project(self) -> Project:
        """What was saved.

        Raises:
            FilesError: It is damaged.
        """
        return load(self.private / PROJECT)


def write(
    private_folder: Path, project: Project, folder: Path | None, owner: Owner, previous: Project | None
) -> datetime:
    """Keep *project*; the time is the result.

    Args:
        previous: What the same window kept last.

    Raises:
        FilesError, OSError: It cannot be written.
    """
    private.make(private_folder)
    save(project, private_folder / PROJECT, previous)
    at = datetime.now().astimezone()
    about = {
        "folder": None if folder is None else str(folder),
        "name": project.name,
        "at": at.isoformat(timespec="seconds"),
        "owner": asdict(owner),
    }
    private.write_whole(private_folder / ABOUT, json.dumps(about))
    return at


def find(private_folder: Path) -> Autosave | None:
    """What is kept in a private folder, if anything is."""
    try:
        about = json.loads((private_folder / ABOUT).read_text(encoding="utf-8"))
        folder = None if about["folder"] is None else Path(about["folder"])
        at = datetime.fromisoformat(about["at"])
        return Autosave(private_folder, folder, str(about["name"]), at, Owner(**about["owner"]))
    except (OSError, ValueError, TypeError, KeyError):
        return None


def discard(private_folder: Path) -> None:
    """Throw away what is kept in a private folder."""
    with contextlib.suppress(OSError):
        (private_folder / ABOUT).unlink(missing_ok=True)
        shutil.rmtree(private_folder / PROJECT, ignore_errors=True)
    private.clear(private_folder)


def left_over(state: Path) -> Iterator[Autosave]:
    """What windows left behind that are gone, as far as the user's own state tells."""
    known = [*_folders(state / private.UNNAMED), *_folders(state / private.PROJECTS), *_noted(state)]
    for folder in dict.fromkeys(known):
        found = find(folder)
        if found is not None and found.is_left_over:
            yield found


def _folders(above: Path) -> list[Path]:
    return sorted(above.iterdir()) if above.is_dir() else []


# ----------------------------------------------------------------------------------- where windows keep theirs

_NOTES = "windows"


def note(state: Path, owner: Owner, private_folder: Path) -> None:
    """Write down where a window keeps what it saves, to be found if it should end without closing."""
    notes = state / _NOTES
    notes.mkdir(parents=True, exist_ok=True)
    private.write_whole(notes / f"{owner.token}.json", json.dumps({"private": str(private_folder)}))


def strike(state: Path, owner: Owner) -> None:
    """The window has closed."""
    with contextlib.suppress(OSError):
        (state / _NOTES / f"{owner.token}.json").unlink(missing_ok=True)


def _noted(state: Path) -> Iterator[Path]:
    """Private folders that windows wrote down; notes that lead nowhere any more are removed."""
    notes = state / _NOTES
    for path in _folders(notes):
        try:
            folder = Path(json.loads(path.read_text(encoding="utf-8"))["private"])
        except (OSError, ValueError, TypeError, KeyError):
            continue
        if (folder / ABOUT).exists():
            yield folder
        elif not (folder / "lock").exists():
            path.unlink(missing_ok=True)
