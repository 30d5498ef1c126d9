"""Building an experiment in its dialog."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialogButtonBox
from pytestqt.qtbot import QtBot

from app.editor.documents.asking import Question
from app.editor.experiments.builder import ExperimentBuilder
from app.editor.experiments.window import ExperimentsWindow
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE
from tests.gui.experiments.looking import finished, small


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


def test_who_deletes_an_experiment_is_told_of_results_only_where_there_are_some(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot
) -> None:
    _, window = shown
    small(window, runs=1)
    assert asked_to_delete(window, qtbot) == "The file of 'figure3' is deleted."
    window.begin()
    qtbot.waitUntil(lambda: window.pages.runs.model.rowCount() == 4, timeout=3 * PATIENCE)
    qtbot.waitUntil(lambda: finished(window), timeout=PATIENCE)
    assert "What was found stays in figure3" in asked_to_delete(window, qtbot)


def test_an_experiment_that_cannot_be_read_can_be_deleted(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot
) -> None:
    _, window = shown
    assert window.folder is not None
    file = window.folder / "experiments" / "figure3.json"
    file.write_text("{", encoding="utf-8")
    window.refresh("figure3")
    assert window.title.text() == "figure3 cannot be read: mend its file, or delete it"
    assert not window.listing.edit.isEnabled()
    qtbot.mouseClick(window.listing.delete, Qt.MouseButton.LeftButton)
    question = next(found for found in window.findChildren(Question) if found.isVisible())
    with qtbot.waitSignal(question.destroyed, timeout=PATIENCE):
        qtbot.mouseClick(question.buttons[0], Qt.MouseButton.LeftButton)
    assert not file.exists()
    qtbot.waitUntil(lambda: window.study is not None, timeout=PATIENCE)  # the next one is shown
    assert window.listing.current != "figure3"


def asked_to_delete(window: ExperimentsWindow, qtbot: QtBot) -> str:
    """Press Delete, and think better of it."""
    qtbot.mouseClick(window.listing.delete, Qt.MouseButton.LeftButton)
    question = next(found for found in window.findChildren(Question) if found.isVisible())
    words = question.text
    with qtbot.waitSignal(question.destroyed, timeout=PATIENCE):
        qtbot.mouseClick(question.buttons[-1], Qt.MouseButton.LeftButton)
    return words
