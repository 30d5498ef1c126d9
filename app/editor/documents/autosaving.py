"""Saving by itself while there is something unsaved, in the background, so that a crash costs seconds."""

from __future__ import annotations

from datetime import datetime
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer

from ...core.errors import UnderstudyError
from ...core.project import Project
from . import autosaves
from .private import unnamed_folder

if TYPE_CHECKING:
    from pathlib import Path

    from .files import Files


class Autosaving(QObject):
    """Keeps what is unsaved where it can be recovered from."""

    def __init__(self, files: Files) -> None:
        super().__init__(files)
        self._files = files
        self._kept: Project | None = None
        self._where: Path | None = None
        self._writing = False
        self._unwanted = False
        self._told = ""
        self._timer = QTimer(self)
        self._timer.timeout.connect(self.keep)
        files.studio.settings.changed.connect(self._setting_changed)
        self._set_timer()

    def _setting_changed(self, name: str) -> None:
        if name == "autosave_seconds":
            self._set_timer()

    def _set_timer(self) -> None:
        seconds = self._files.studio.settings.autosave_seconds
        if seconds > 0:
            self._timer.start(seconds * 1000)
        else:
            self._timer.stop()

    def keep(self) -> None:
        """Save what is unsaved, if there is something that has not been kept yet."""
        files, document = self._files, self._files.studio.document
        project = document.project
        if not files.studio.is_open or document.is_saved or project is self._kept:
            return
        if self._writing or files.saving.runs:
            return
        where = files.held.private or unnamed_folder(files.state, files.owner.token)
        previous = self._kept if where == self._where else None
        self._writing, self._where = True, where
        files.background.do(
            partial(self._write, where, project, previous),
            partial(self._done, project),
            self._failed,
        )

    def _write(self, where: Path, project: Project, previous: Project | None) -> datetime:
        files = self._files
        autosaves.note(files.state, files.owner, where)
        return autosaves.write(where, project, files.held.folder, files.owner, previous)

    def _done(self, project: Project, at: datetime) -> None:
        self._writing, self._kept, self._told = False, project, ""
        if self._unwanted:
            self.discard()
        else:
            self._files.studio.document.autosaved = at
            self._files.studio.touch()

    def _failed(self, error: UnderstudyError) -> None:
        self._writing = False
        if str(error) != self._told:  # once, not every half minute
            self._told = str(error)
            self._files.studio.warn(f"nothing can be autosaved: {error}")

    def discard(self) -> None:
        """Throw away what was kept: it is saved, or not wanted."""
        if self._writing:
            self._unwanted = True
            return
        self._unwanted = False
        where, self._where, self._kept = self._where, None, None
        self._files.studio.document.autosaved = None
        if where is not None:
            self._writing = True  # nothing is kept there meanwhile
            self._files.background.do(
                partial(autosaves.discard, where), self._discarded, lambda _: self._discarded(None)
            )

    def _discarded(self, _: object) -> None:
        self._writing = False

    def adopt(self, where: Path) -> None:
        """Go on where a window that is gone had kept its work: what is kept next replaces it, saving removes it."""
        self._where = where

    def stop(self) -> None:
        """Save nothing any more."""
        self._timer.stop()
        self._writing = False
        if self._where is not None:
            autosaves.discard(self._where)
