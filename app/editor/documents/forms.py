"""Small forms: rows of a caption and a control, what is wrong with them, and a button that works once nothing is."""

from __future__ import annotations

import re
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from ...core.errors import StorageError
from ...engine.fresh import refuse_folder
from ..forms.buttons import stand_back
from .choosing import choose_folder
from .private import writable

WIDTH = 520


class Form:
    """Lays a dialog out.

    Attributes:
        fine: The button that accepts.
        complaint: Says what is wrong.
    """

    def __init__(self, dialog: QDialog, fine: str, tip: str) -> None:
        dialog.setMinimumWidth(WIDTH)
        layout = QVBoxLayout(dialog)
        layout.setContentsMargins(20, 18, 20, 16)
        layout.setSpacing(12)
        self._lead = QLabel()
        self._lead.setWordWrap(True)
        self._lead.hide()
        self._rows = QFormLayout()
        self._rows.setHorizontalSpacing(16)
        self._rows.setVerticalSpacing(10)
        self._rows.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.ExpandingFieldsGrow)
        self.complaint = QLabel()
        self.complaint.setWordWrap(True)
        self.complaint.setTextFormat(Qt.TextFormat.PlainText)
        self.complaint.setMinimumHeight(self.complaint.fontMetrics().lineSpacing() * 2)
        self.complaint.setAlignment(Qt.AlignmentFlag.AlignTop)
        box = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.fine = QPushButton(fine)
        self.fine.setToolTip(tip)
        box.addButton(self.fine, QDialogButtonBox.ButtonRole.AcceptRole)
        stand_back(box.button(QDialogButtonBox.StandardButton.Cancel))
        box.accepted.connect(dialog.accept)
        box.rejected.connect(dialog.reject)
        layout.addWidget(self._lead)
        layout.addLayout(self._rows)
        layout.addWidget(self.complaint)
        layout.addWidget(box)
        self.fine.setDefault(True)  # it has to be in the dialog for that

    def lead(self, text: str) -> None:
        """Say something first."""
        self._lead.setText(text)
        self._lead.setVisible(bool(text))

    def row(self, caption: str, control: QWidget) -> None:
        """Add a control."""
        self._rows.addRow(caption, control)

    def note(self, label: QLabel) -> None:
        """Add an explanation below the controls so far."""
        label.setProperty("role", "caption")
        label.setWordWrap(True)
        label.setAlignment(Qt.AlignmentFlag.AlignTop)
        # Its lines are as long as the controls.
        label.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self._rows.addRow("", label)

    def complain(self, problem: str) -> None:
        """Say what is wrong; as long as something is, the form cannot be accepted."""
        self.complaint.setText(problem[:1].upper() + problem[1:])
        self.fine.setEnabled(not problem)


class PlaceEdit(QWidget):
    """A folder, typed or chosen; it follows the project's name until the user has a say in it.

    Signals:
        changed: It is another one.
    """

    changed = Signal()

    def __init__(self, beside: Path, name: str) -> None:
        super().__init__()
        self._beside = beside
        self._own = False
        self.edit = QLineEdit()
        self.edit.setAccessibleName("Folder")
        self.edit.textEdited.connect(self._edited)
        self.edit.textChanged.connect(lambda _: self.changed.emit())
        self.browse = QPushButton("Browse…")
        stand_back(self.browse)
        self.browse.setToolTip("Choose the folder that the project's folder is to be in")
        self.browse.clicked.connect(self._browse)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(8)
        layout.addWidget(self.edit, 1)
        layout.addWidget(self.browse)
        self.setFocusProxy(self.edit)
        self.suggest(name)

    @property
    def folder(self) -> Path:
        """What is named."""
        return Path(self.edit.text().strip()).expanduser()

    def suggest(self, name: str) -> None:
        """Let the folder be called *name*, or as near to it as is free, unless the user named it."""
        if not self._own:
            self.edit.setText(str(free_folder(self._beside, name)))

    def _edited(self) -> None:
        self._own = True

    def _browse(self) -> None:
        def chosen(above: Path) -> None:
            self._beside = above
            self.edit.setText(str(free_folder(above, self.folder.name or "project")))

        choose_folder(self.window(), "Where the project's folder is to be", self._beside, chosen)


def free_folder(above: Path, name: str) -> Path:
    """A folder in *above* called *name*, with a number if that is taken."""
    folder, number = above / name, 2
    while folder_problem(folder).endswith("or is empty") and number < 1000:
        folder, number = above / f"{name}-{number}", number + 1
    return folder


def folder_problem(folder: Path) -> str:
    """Why *folder* cannot hold a new project; empty if it can."""
    if str(folder) in ("", ".") or not folder.is_absolute():
        return "name the whole path of a folder, such as " + str(Path.home() / "my-project")
    try:
        refuse_folder(folder)
    except StorageError as error:
        return str(error)
    except OSError as error:
        return f"{folder}: {error.strerror}"
    there = next((above for above in (folder, *folder.parents) if above.exists()), folder)
    return "" if there.is_dir() and writable(there) else f"{there} cannot be written to"


def usable_name(name: str) -> str:
    """*name* as a folder may be called on any system."""
    plain = re.sub(r"[^\w.-]+", "-", name.strip().lower()).strip("-.")
    return plain or "project"
