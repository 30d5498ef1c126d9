"""Letting the user choose a folder with the system's own dialog."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QWidget


def choose_folder(window: QWidget, title: str, beside: Path, then: Callable[[Path], object]) -> QFileDialog:
    """Ask for a folder; *then* is given it."""
    dialog = QFileDialog(window, title, str(beside))
    dialog.setFileMode(QFileDialog.FileMode.Directory)
    dialog.setOption(QFileDialog.Option.ShowDirsOnly, True)
    dialog.fileSelected.connect(lambda chosen: then(Path(chosen)))
    dialog.finished.connect(dialog.deleteLater)
    dialog.open()
    return dialog
