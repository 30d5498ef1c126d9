"""Building an experiment in its dialog."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialogButtonBox
from pytestqt.qtbot import QtBot

from app.editor.experiments.builder import ExperimentBuilder
from app.editor.experiments.window import ExperimentsWindow
from app.editor.window.main_window import MainWindow


def test_a_complaint_goes_once_what_it_was_about_is_changed(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot
) -> None:
    _, window = shown
    window.listing.build()
    (builder,) = window.findChildren(ExperimentBuilder)
    builder.add_factor("world.boxes", "5, x")
    ok = builder.buttons.button(QDialogButtonBox.StandardButton.Ok)
    qtbot.mouseClick(ok, Qt.MouseButton.LeftButton)
    assert "it is 'x'" in builder.trouble.text()
    values = builder.factors.item(0, 1)
    assert values is not None
    values.setText("5, 10")  # as the editor in the cell does
    assert not builder.trouble.text()
    builder.reject()
