"""The guided first lesson is offered, left, taken up again and put away; its steps and its project are sound."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton
from pytestqt.qtbot import QtBot

from app.editor.guide.scratch import scratch_project
from app.editor.guide.steps import FORAGING, SECOND, STEPS
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE
from tests.gui.guide.newcomer import at, begin, faster


def test_a_user_who_is_new_is_offered_the_lesson_once(window: MainWindow, qtbot: QtBot) -> None:
    window.guide.offer()
    begin_it = next(b for b in window.messages.findChildren(QPushButton) if b.text() == "Begin it")
    qtbot.mouseClick(begin_it, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(window.guide.isVisible, timeout=PATIENCE)
    window.guide.offer()
    assert not window.messages.isVisible()


def test_who_skips_the_first_half_gets_the_wander_that_the_second_needs(
    lesson: MainWindow, qtbot: QtBot
) -> None:
    document = lesson.studio.document
    for _ in range(SECOND):
        qtbot.mouseClick(lesson.guide.skip, Qt.MouseButton.LeftButton)
    at(lesson, qtbot, "Now foraging")
    qtbot.waitUntil(lambda: bool(document.project.library("agent").get("wander").learned), timeout=PATIENCE)
    assert document.project.examples_of("agent", "wander")
    assert document.history.undo_text == "Put in a Wander that was taught"


def test_the_lesson_is_left_and_taken_up_again(lesson: MainWindow, qtbot: QtBot) -> None:
    window = lesson
    qtbot.mouseClick(window.guide.skip, Qt.MouseButton.LeftButton)
    qtbot.mouseClick(window.guide.close_button, Qt.MouseButton.LeftButton)
    assert not window.guide.isVisible()
    assert not window.guide.ring.isVisible()
    begin(window, qtbot)
    assert window.guide.step == 1
    assert window.studio.settings.lesson_step == 1


def test_taken_up_in_its_second_half_in_another_session_wander_is_there(
    window: MainWindow, qtbot: QtBot
) -> None:
    window.studio.settings.lesson_step = SECOND + 2
    begin(window, qtbot)
    assert window.guide.step == SECOND
    assert window.guide.title.text() == FORAGING[0].title
    assert window.studio.document.project.library("agent").automata["wander"].learned


def test_the_lesson_begins_at_a_pace_that_can_be_followed_and_keeps_to_what_is_chosen_in_it(
    window: MainWindow, qtbot: QtBot
) -> None:
    faster(window, qtbot, 64.0)
    begin(window, qtbot)
    qtbot.waitUntil(lambda: window.toolbar.speed_words.text() == "1×", timeout=PATIENCE)
    faster(window, qtbot, 4.0)
    qtbot.mouseClick(window.guide.close_button, Qt.MouseButton.LeftButton)
    begin(window, qtbot)
    assert window.speed.chosen == 4.0


def test_another_project_puts_the_lesson_away(lesson: MainWindow, qtbot: QtBot, foraging: object) -> None:
    studio = lesson.studio
    studio.close_project()
    assert not lesson.guide.isVisible()


def test_every_step_points_at_something_or_at_nothing_on_purpose() -> None:
    for step in STEPS:
        assert step.points_at.partition(":")[0] in ("action", "pick", "panel", "canvas")


@pytest.mark.parametrize("taught", [False, True])
def test_the_lessons_project_is_sound(taught: bool) -> None:
    from app.core.check import check

    project, scenario = scratch_project(wander_is_taught=taught)
    assert [p.message for p in check(project, scenario.vocabulary) if p.severity == "error"] == []
