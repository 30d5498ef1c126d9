"""What the window shows while the user has to wait for a project."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QLabel, QProgressBar, QPushButton, QVBoxLayout, QWidget

if TYPE_CHECKING:
    from .files import Files


class BusyPage(QWidget):
    """Says what is being done, and can be left."""

    def __init__(self, files: Files) -> None:
        super().__init__()
        self.words = QLabel()
        self.words.setProperty("role", "title")
        bar = QProgressBar()
        bar.setRange(0, 0)
        bar.setTextVisible(False)
        bar.setFixedSize(240, 4)
        self.cancel = QPushButton("Cancel")
        self.cancel.setToolTip("Stay with what is open (Esc)")
        self.cancel.clicked.connect(files.opening.cancel)
        layout = QVBoxLayout(self)
        layout.setSpacing(16)
        layout.addStretch(1)
        for widget in (self.words, bar, self.cancel):
            layout.addWidget(widget, 0, Qt.AlignmentFlag.AlignHCenter)
        layout.addStretch(1)
        files.waiting.connect(self.words.setText)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Esc is as good as the button."""
        if event.key() == Qt.Key.Key_Escape:
            self.cancel.click()
        else:
            super().keyPressEvent(event)
