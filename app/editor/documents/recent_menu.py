"""Recent projects in the File menu."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QMenu, QMenuBar

from ..letters import letters_of, marked

if TYPE_CHECKING:
    from .files import Files


class RecentMenu(QMenu):
    """Lists the projects that were open before, as they are when it is looked at."""

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
        folders = self._files.studio.settings.recent
        letters = letters_of([folder.name for folder in folders])
        for folder, letter in zip(folders, letters, strict=True):
            action = self.addAction(marked(folder.name, letter))
            action.setToolTip(str(folder))
            action.setEnabled((folder / "project.json").exists())
            action.triggered.connect(lambda _=False, folder=folder: self._files.open(folder))
        if self.isEmpty():
            self.addAction("Nothing was open before").setEnabled(False)
