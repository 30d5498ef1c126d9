"""Fields of all kinds look as if they were one: their words begin at the same place."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QApplication,
    QComboBox,
    QDialog,
    QLineEdit,
    QPlainTextEdit,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)
from pytestqt.qtbot import QtBot

from app.editor.behavior_colors import luminance
from app.editor.forms.choosing import Choice, Chooser
from app.editor.forms.parts import framed
from app.editor.number_box import roomy
from app.editor.theme import Theme, ThemeMode

#: Pixels by which letters and digits may begin later than others.
SIDE = 1
#: What is darker than that is ink.
INK = 0.3


@pytest.fixture
def fields(qapp: QApplication, qtbot: QtBot) -> Iterator[dict[str, QWidget]]:
    """One field of every kind with a word in it, each as wide as the others."""
    theme = Theme(qapp, ThemeMode.LIGHT)
    word, list_, chooser = QLineEdit("Hunt"), QComboBox(), Chooser("behavior", "which")
    list_.addItem("Hunt")
    chooser.offer((Choice("Hunt", 1),), 1)
    number, text = roomy(QSpinBox(prefix="H")), QPlainTextEdit("Hunt")
    framed(text, theme)
    parts = {"word": word, "list": list_, "chooser": chooser, "number": number, "text": text}
    dialog = QDialog()
    qtbot.addWidget(dialog)
    column = QVBoxLayout(dialog)
    for part in parts.values():
        part.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        column.addWidget(part)
    with qtbot.waitExposed(dialog):
        dialog.show()
    yield parts
    dialog.close()


def where_words_begin(field: QWidget) -> int:
    """The first column of a field that has ink in it, behind its line."""
    image = field.grab().toImage()
    rows = range(5, min(image.height() - 3, 26))
    return next(
        x for x in range(3, image.width()) if any(luminance(image.pixelColor(x, y)) < INK for y in rows)
    )


def test_their_words_begin_at_the_same_place(fields: dict[str, QWidget]) -> None:
    begin = {name: where_words_begin(field) for name, field in fields.items()}
    assert max(begin.values()) - min(begin.values()) <= SIDE, begin
