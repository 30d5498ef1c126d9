"""The dialog in which a file is chosen, where it is Qt's own."""

from pathlib import Path

import pytest
from PySide6.QtWidgets import QToolButton, QWidget
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from app.editor.documents.choosing import PICTURES, choose_file
from app.editor.studio import Studio
from app.editor.theme import ThemeMode
from tests.gui.conftest import PATIENCE
from tests.gui.test_lists import contrast_in


@pytest.mark.parametrize("mode", [ThemeMode.LIGHT, ThemeMode.DARK])
def test_the_pictures_of_its_buttons_can_be_seen(
    empty_studio: Studio, qtbot: QtBot, tmp_path: Path, mode: ThemeMode
) -> None:
    empty_studio.theme.use(mode)
    window = QWidget()
    qtbot.addWidget(window)
    dialog = choose_file(window, "Export to", tmp_path / "a.json", "JSON (*.json)", lambda _: None)
    for name in PICTURES:
        button = dialog.findChild(QToolButton, name)
        assert isinstance(button, QToolButton)
        button.setEnabled(True)
        assert contrast_in(button.grab(button.rect().adjusted(4, 4, -4, -4)).toImage()) >= 4.5
    dialog.reject()
    qtbot.waitUntil(lambda: not isValid(dialog), timeout=PATIENCE)
