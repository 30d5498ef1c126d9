"""Buttons with words on them."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QPushButton


def text_button(text: str, tip: str, act: Callable[[], object]) -> QPushButton:
    """A button that does one thing when it is pressed."""
    button = QPushButton(text)
    button.setToolTip(tip)
    button.clicked.connect(lambda _checked: act())
    return button
