"""Messages above the world: answered by clicks and keys, gone once they hold no more."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QPushButton
from pytestqt.qtbot import QtBot

from app.core.project import Project
from app.editor.library.new_automaton import NewAutomatonDialog
from app.editor.window.main_window import MainWindow
from app.engine.scenarios import open_scenario
from tests.gui.conftest import PATIENCE


def test_keys_work_on_after_a_message_was_answered_by_a_click(window: MainWindow, qtbot: QtBot) -> None:
    studio = window.studio
    studio.warn("something to answer", (("Later", lambda: None),))
    answer = next(b for b in window.messages.findChildren(QPushButton) if b.text() == "Later")
    qtbot.mouseClick(answer, Qt.MouseButton.LeftButton)
    focus = QApplication.focusWidget()
    assert focus is window
    qtbot.keyClick(focus, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.tick > 3, timeout=PATIENCE)


def test_a_message_is_answered_and_dismissed_by_keys_alone(window: MainWindow, qtbot: QtBot) -> None:
    window.activateWindow()
    done: list[str] = []
    for key, answers in ((Qt.Key.Key_Escape, []), (Qt.Key.Key_Return, ["yes"])):
        window.studio.warn("something to answer", (("Yes", lambda: done.append("yes")),))
        window.canvas.setFocus()
        qtbot.keyClick(window.canvas, Qt.Key.Key_F6)
        focus = QApplication.focusWidget()
        assert isinstance(focus, QPushButton)
        qtbot.keyClick(focus, key)
        assert done == answers
        assert not window.messages.isVisible()
        assert window.hasFocus()


def test_who_would_teach_without_a_behavior_is_led_to_a_new_one(window: MainWindow, qtbot: QtBot) -> None:
    window.studio.selection.select_behavior(None)
    qtbot.keyClick(window, Qt.Key.Key_T)
    answer = next(b for b in window.messages.findChildren(QPushButton) if b.text() == "New automaton…")
    qtbot.mouseClick(answer, Qt.MouseButton.LeftButton)
    (dialog,) = (d for d in window.findChildren(NewAutomatonDialog) if d.isVisible())
    dialog.reject()
    assert not window.messages.isVisible()


def test_what_can_be_done_about_a_project_is_not_offered_in_another_one(
    window: MainWindow, foraging: Project, qtbot: QtBot
) -> None:
    studio, messages = window.studio, window.messages
    studio.warn("nobody is there to be taught", (("Use one level", lambda: None),))
    studio.say("an arm came", (("Show its world", lambda: None),))
    assert messages.isVisible()
    studio.open(foraging, open_scenario(foraging), None)
    qtbot.waitUntil(lambda: not messages.isVisible(), timeout=PATIENCE)


def test_a_warning_comes_before_a_question_that_can_wait(window: MainWindow) -> None:
    studio, messages = window.studio, window.messages
    studio.say("a question", (("Yes", lambda: None),))
    studio.warn("a warning", (("Mend it", lambda: None),))
    assert messages.words.text() == "A warning"
    messages.dismiss()
    assert messages.words.text() == "A question"


def test_what_is_refused_is_told_also_while_a_warning_waits_for_an_answer(window: MainWindow) -> None:
    studio, messages = window.studio, window.messages
    studio.warn("ended without saving", (("Recover", lambda: None),))
    studio.warn("the disk is full")
    assert messages.words.text() == "The disk is full"
    studio.warn("it is still full")
    assert messages.words.text() == "It is still full"
    messages.dismiss()
    assert messages.words.text() == "Ended without saving"
