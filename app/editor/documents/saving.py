"""Saving: a value of the project goes to the disk in the background, and nothing of others is overwritten unasked."""

from __future__ import annotations

import shutil
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from ...core.errors import UnderstudyError
from ...core.project import Project
from ...core.storage import FilesError, save
from ...engine.scenarios import OWN_CODE
from ..behavior_colors import Places
from . import colors
from .asking import Answer
from .held import Held, Then
from .outside import Stamps, changes, stamps_of
from .private import private_folder

if TYPE_CHECKING:
    from .files import Files

#: What a project's folder holds besides the project itself, and goes with it into another folder.
COMPANIONS = (OWN_CODE, "experiments")


@dataclass(frozen=True, slots=True)
class Stored:
    """A project is in its folder."""

    stamps: Stamps
    private: Path


@dataclass(frozen=True, slots=True)
class ChangedOutside:
    """It is not: somebody else changed these files meanwhile."""

    files: tuple[str, ...]


def store(project: Project, folder: Path, held: Held, state: Path, places: Places) -> Stored | ChangedOutside:
    """Make *folder* hold *project*, unless somebody else changed files that *held* knows.

    Args:
        places: The colors of its behaviors.
    """
    same = held.folder == folder
    if same and held.stamps is not None:
        found = changes(held.stamps, stamps_of(folder, held.stamps))
        if found:
            return ChangedOutside(found)
    save(project, folder, held.base if same else None)
    if held.folder is not None and not same:
        bring_along(held.folder, folder)
    private = private_folder(folder, state)
    colors.keep(private, project, places)
    return Stored(stamps_of(folder), private)


def bring_along(old: Path, new: Path) -> None:
    """Copy what belongs to a project without being part of its value."""
    for name in COMPANIONS:
        if (old / name).is_dir():
            shutil.copytree(old / name, new / name, dirs_exist_ok=True)
        elif (old / name).is_file():
            shutil.copy2(old / name, new / name)


class Saving:
    """Saves the project that is open, once at a time."""

    def __init__(self, files: Files) -> None:
        self._files = files
        self._afterwards: list[Then] = []
        self.runs = False

    def save(self, then: Then | None = None) -> None:
        """Save where the project is kept, or ask where that is to be; *then* follows once it is saved."""
        held = self._files.held
        if self.runs:
            self.afterwards(partial(self.save, then))
        elif held.folder is None:
            self._files.choose_place(then)
        elif held.read_only:
            self._files.choose_place(then, "This window looks at the project only, so it is saved elsewhere.")
        else:
            self.into(held.folder, then)

    def afterwards(self, then: Then) -> None:
        """Do something when the saving that goes on has ended, well or not."""
        self._afterwards.append(then)

    def into(self, folder: Path, then: Then | None = None) -> None:
        """Save into *folder*, which is where the project is kept from then on."""
        files, project = self._files, self._files.studio.document.project
        self._running(on=True)
        files.background.do(
            partial(store, project, folder, files.held, files.state, files.studio.colors.places),
            partial(self._stored, project, folder, then),
            partial(self._failed, folder, then),
        )

    def _running(self, *, on: bool) -> None:
        self.runs = on
        self._files.studio.document.saving = on
        self._files.studio.touch()

    def _stored(
        self, project: Project, folder: Path, then: Then | None, result: Stored | ChangedOutside
    ) -> None:
        self._running(on=False)
        if isinstance(result, ChangedOutside):
            self._ask_overwrite(folder, then, result.files)
        else:
            self._files.saved(project, folder, result)
            if then is not None:
                then()
        self._end()

    def _end(self) -> None:
        waiting, self._afterwards = self._afterwards, []
        for then in waiting:
            then()

    def _failed(self, folder: Path, then: Then | None, error: UnderstudyError) -> None:
        self._running(on=False)
        problems = error.problems if isinstance(error, FilesError) else ()
        self._files.ask(
            "The project could not be saved",
            f"{folder} is as it was, and all your work is still in this window.",
            (
                Answer("Save elsewhere…", partial(self._files.choose_place, then)),
                Answer("Try again", partial(self.into, folder, then)),
                Answer("Not now"),
            ),
            "\n".join(str(problem) for problem in problems) or str(error),
            "alert-circle-outline",
        )
        self._end()

    def _ask_overwrite(self, folder: Path, then: Then | None, found: tuple[str, ...]) -> None:
        files = self._files

        def overwrite() -> None:
            files.held = replace(files.held, base=None, stamps=None)
            self.into(folder, then)

        files.ask(
            "Somebody else changed this project's files",
            f"Files in {folder} are not as this window left them. Nothing has been written yet.",
            (
                Answer("Save elsewhere…", partial(files.choose_place, then), "Keep both"),
                Answer("Overwrite", overwrite, "Keep what is in this window; what was changed is gone"),
                Answer(
                    "Reload",
                    files.reload,
                    "Keep what is in the folder; unsaved changes in this window are gone",
                ),
                Answer("Cancel"),
            ),
            "\n".join(found),
            "file-alert-outline",
        )
