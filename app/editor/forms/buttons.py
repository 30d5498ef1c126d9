"""Buttons with words on them."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QCursor, QKeyEvent
from PySide6.QtWidgets import QAbstractButton, QDialog, QDialogButtonBox, QMenu, QPushButton, QToolButton

ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter)


class _PressedByEnter(QObject):
    """Lets Enter press a button that has the keys: a dialog would press its standard one."""

    def eventFilter(self, button: QObject, event: QEvent) -> bool:
        """Press it."""
        if not isinstance(event, QKeyEvent) or event.type() is not QEvent.Type.KeyPress:
            return False
        if event.key() not in ENTER or not isinstance(button, QAbstractButton):
            return False
        if not event.isAutoRepeat():
            button.click()
        return True


def stand_back(button: QAbstractButton) -> None:
    """Let Enter press *button* where it has the keys, and never from another field: it is no standard button."""
    if isinstance(button, QPushButton):
        button.setAutoDefault(False)
    button.installEventFilter(_PressedByEnter(button))


def text_button(text: str, tip: str, act: Callable[[], object]) -> QPushButton:
    """A button that does one thing when it is pressed, and that Enter in another field does not press."""
    button = QPushButton(text)
    button.setToolTip(tip)
    stand_back(button)
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
    stand_back(close)
    close.setToolTip("Close; all changes are in the project already")
    buttons.rejected.connect(dialog.reject)
    return buttons
