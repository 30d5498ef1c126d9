"""Buttons of forms and dialogs, by keys."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QDialog,
    QDialogButtonBox,
    QLineEdit,
    QPushButton,
    QToolButton,
    QVBoxLayout,
)
from pytestqt.qtbot import QtBot

from app.editor.forms.buttons import stand_back
from app.editor.theme import Theme, ThemeMode


class Asking(QDialog):
    """A field, two buttons that stand back, and a standard one."""

    def __init__(self) -> None:
        super().__init__()
        self.pressed: list[str] = []
        self.field = QLineEdit()
        self.parts: dict[str, QAbstractButton] = {"browse": QPushButton("Browse…"), "up": QToolButton()}
        box = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok)
        self.parts["ok"] = box.button(QDialogButtonBox.StandardButton.Ok)
        column = QVBoxLayout(self)
        for part in (self.field, self.parts["browse"], self.parts["up"], box):
            column.addWidget(part)
        for name, button in self.parts.items():
            button.clicked.connect(lambda _=False, name=name: self.pressed.append(name))
            if name != "ok":
                stand_back(button)


@pytest.fixture
def asking(qtbot: QtBot) -> Asking:
    dialog = Asking()
    qtbot.addWidget(dialog)
    with qtbot.waitExposed(dialog):
        dialog.show()
    return dialog


@pytest.mark.parametrize("name", ["browse", "up", "ok"])
@pytest.mark.parametrize("key", [Qt.Key.Key_Return, Qt.Key.Key_Enter])
def test_enter_presses_the_button_that_has_the_keys_and_no_other(
    asking: Asking, qtbot: QtBot, name: str, key: Qt.Key
) -> None:
    asking.parts[name].setFocus()
    qtbot.keyClick(asking.parts[name], key)
    assert asking.pressed == [name]


def test_enter_in_a_field_presses_the_standard_button(asking: Asking, qtbot: QtBot) -> None:
    asking.field.setFocus()
    qtbot.keyClick(asking.field, Qt.Key.Key_Return)
    assert asking.pressed == ["ok"]


@pytest.mark.parametrize("mode", [ThemeMode.LIGHT, ThemeMode.DARK])
def test_the_button_that_enter_presses_is_the_one_that_stands_out(
    asking: Asking, qapp: QApplication, mode: ThemeMode
) -> None:
    theme = Theme(qapp, mode)
    theme.dress(asking)
    asking.parts["ok"].setFocusPolicy(Qt.FocusPolicy.NoFocus)

    def ground(name: str) -> str:
        part = asking.parts[name]
        return part.grab().toImage().pixelColor(part.width() // 2, 4).name()

    assert ground("ok") == theme.palette.accent
    assert ground("browse") == theme.palette.raised
    asking.parts["ok"].setEnabled(False)
    assert ground("ok") == theme.palette.panel
    theme.use(ThemeMode.LIGHT)
