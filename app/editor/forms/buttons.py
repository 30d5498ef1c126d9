"""Buttons with words on them."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QDialog, QDialogButtonBox, QPushButton


def text_button(text: str, tip: str, act: Callable[[], object]) -> QPushButton:
    """A button that does one thing when it is pressed, and that Enter in another field does not press."""
    button = QPushButton(text)
    button.setToolTip(tip)
    button.setAutoDefault(False)
    button.clicked.connect(lambda _checked: act())
    return button


def closing(dialog: QDialog) -> QDialogButtonBox:
    """The last row of a dialog whose changes are made at once."""
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
    close = buttons.button(QDialogButtonBox.StandardButton.Close)
    close.setAutoDefault(False)
    close.setToolTip("Close; all changes are in the project already")
    buttons.rejected.connect(dialog.reject)
    return buttons
