"""Where a project is to be saved."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QDialog, QLabel, QLineEdit, QWidget

from .forms import Form, PlaceEdit, folder_problem, usable_name

if TYPE_CHECKING:
    from ..studio import Studio


class SaveAs(QDialog):
    """Asks for a name and a folder.

    Signals:
        chosen: The name, and the folder that is to hold the project.
    """

    chosen = Signal(str, object)

    def __init__(self, window: QWidget, studio: Studio, folder: Path | None, why: str = "") -> None:
        super().__init__(window)
        self.setWindowTitle("Save as")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        project = studio.document.project
        self.name = QLineEdit(project.name)
        self.name.setAccessibleName("Name")
        beside = studio.settings.projects_folder
        self.place = PlaceEdit(beside if folder is None else folder.parent, f"{usable_name(project.name)}")
        self._form = Form(self, "Save", "Save the project into this folder")
        self._form.lead(why)
        self._form.row("Name", self.name)
        self._form.row("Folder", self.place)
        self._form.note(
            QLabel("The folder is made if it is not there; it holds this project and nothing else.")
        )
        self.name.textEdited.connect(lambda text: self.place.suggest(usable_name(text)))
        self.name.textChanged.connect(self._check)
        self.place.changed.connect(self._check)
        self.accepted.connect(self._accepted)
        self._check()
        self.name.setFocus()
        self.name.selectAll()

    @property
    def problem(self) -> str:
        """Why it cannot be saved like this; empty if it can."""
        if not self.name.text().strip():
            return "the project needs a name"
        return folder_problem(self.place.folder)

    def _check(self) -> None:
        self._form.complain(self.problem)

    def _accepted(self) -> None:
        self.chosen.emit(self.name.text().strip(), self.place.folder)
