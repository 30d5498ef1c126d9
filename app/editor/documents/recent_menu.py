"""Recent projects in the File menu."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QMenu, QMenuBar

from ...core.storage import file_is_there
from ..letters import letters_of, marked

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from .files import Files


class RecentMenu(QMenu):
    """Lists the projects that were open before, other than the one that is, as they are when it is looked at."""

    def __init__(self, files: Files, bar: QMenuBar) -> None:
        super().__init__("Open recent", bar)
        self._files = files
        self.setObjectName(self.title())
        self.setToolTipsVisible(True)
        self.aboutToShow.connect(self.fill)
        self.fill()
        menu = bar.findChild(QMenu, "File")
        if menu is not None:
            menu.insertMenu(files.studio.actions["file.save"], self)
            menu.insertSeparator(files.studio.actions["file.save"])

    def fill(self) -> None:
        """List what there is now."""
        self.clear()
        folders = [
            folder for folder in self._files.studio.settings.recent if folder != self._files.held.folder
        ]
        names = told_apart(folders)
        for folder, name, letter in zip(folders, names, letters_of(names), strict=True):
            action = self.addAction(marked(name, letter))
            action.setToolTip(str(folder))
            action.setEnabled(file_is_there(folder / "project.json"))
            action.triggered.connect(lambda _=False, folder=folder: self._files.open(folder))
        if self.isEmpty():
            self.addAction("Nothing was open before").setEnabled(False)


def told_apart(folders: Sequence[Path]) -> list[str]:
    """What folders are called: where two have one name, with the folder that each is in."""
    names = Counter(folder.name for folder in folders)
    return [f"{f.name} in {f.parent}" if names[f.name] > 1 else f.name for f in folders]
