"""Letting the user choose a folder or a file."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QToolButton, QWidget

from ..icons import icon_in

#: The icons of the buttons in Qt's own dialog, by what Qt calls them.
PICTURES = {
    "backButton": "arrow-left",
    "forwardButton": "arrow-right",
    "toParentButton": "arrow-up",
    "newFolderButton": "folder-plus-outline",
    "listModeButton": "view-grid-outline",
    "detailModeButton": "format-list-bulleted",
}


def choose_folder(window: QWidget, title: str, beside: Path, then: Callable[[Path], object]) -> QFileDialog:
    """Ask for a folder; *then* is given it."""
    dialog = QFileDialog(window, title, str(beside))
    dialog.setFileMode(QFileDialog.FileMode.Directory)
    dialog.setOption(QFileDialog.Option.ShowDirsOnly, True)
    dialog.fileSelected.connect(lambda chosen: then(Path(chosen)))
    return _asked(dialog)


def choose_existing(
    window: QWidget, title: str, beside: Path, kinds: str, then: Callable[[Path], object]
) -> QFileDialog:
    """Ask for a file to read; *then* is given it.

    Args:
        beside: The folder that is shown first.
        kinds: What it may be, as `QFileDialog` wants it: "JSON (*.json)".
    """
    dialog = QFileDialog(window, title, str(beside), kinds)
    dialog.setFileMode(QFileDialog.FileMode.ExistingFile)
    dialog.fileSelected.connect(lambda chosen: then(Path(chosen)))
    return _asked(dialog)


def choose_file(
    window: QWidget, title: str, proposed: Path, kinds: str, then: Callable[[Path], object]
) -> QFileDialog:
    """Ask for a file to write; *then* is given it.

    Args:
        kinds: What it may be, as `QFileDialog` wants it: "SVG (*.svg);;PNG (*.png)".
    """
    dialog = QFileDialog(window, title, str(proposed.parent), kinds)
    dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
    dialog.setDefaultSuffix(_ending(kinds.split(";;", maxsplit=1)[0]))
    # The system's own may not add what the name ends with.
    dialog.setOption(QFileDialog.Option.DontUseNativeDialog)
    dialog.selectFile(proposed.name)
    dialog.filterSelected.connect(lambda kind: dialog.setDefaultSuffix(_ending(kind)))
    dialog.fileSelected.connect(lambda chosen: then(Path(chosen)))
    return _asked(dialog)


def _asked(dialog: QFileDialog) -> QFileDialog:
    """Show a dialog that goes for good once it is answered; Qt's own has pictures that hardly show on a dark ground."""
    for name, picture in PICTURES.items():
        button = dialog.findChild(QToolButton, name)
        if isinstance(button, QToolButton):  # the system's dialog has none
            button.setIcon(icon_in(picture, dialog.palette()))
    dialog.finished.connect(dialog.deleteLater)
    dialog.open()
    return dialog


def _ending(kind: str) -> str:
    return kind.rsplit("*.", maxsplit=1)[-1].rstrip(")")
