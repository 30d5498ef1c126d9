"""Buttons with words on them."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtGui import QCursor
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QMenu, QPushButton, QToolButton


def text_button(text: str, tip: str, act: Callable[[], object]) -> QPushButton:
    """A button that does one thing when it is pressed, and that Enter in another field does not press."""
    button = QPushButton(text)
    button.setToolTip(tip)
    button.setAutoDefault(False)
    button.clicked.connect(lambda _checked: act())
    return button


def opens(button: QToolButton, menu: QMenu) -> None:
    """Let a button open *menu* at once; it is not lit any more once the menu has gone and the mouse is elsewhere."""

    def look() -> None:
        if not button.rect().contains(button.mapFromGlobal(QCursor.pos())):
            button.setAttribute(Qt.WidgetAttribute.WA_UnderMouse, on=False)  # no event tells: the menu had it
            button.update()

    button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
    button.setMenu(menu)
    menu.aboutToHide.connect(look)


def closing(dialog: QDialog) -> QDialogButtonBox:
    """The last row of a dialog whose changes are made at once."""
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
    close = buttons.button(QDialogButtonBox.StandardButton.Close)
    close.setAutoDefault(False)
    close.setToolTip("Close; all changes are in the project already")
    buttons.rejected.connect(dialog.reject)
    return buttons
