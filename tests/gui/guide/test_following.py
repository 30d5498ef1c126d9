"""Who does what the lesson says has taught wandering and foraging; it stops time and waits where that helps."""

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.core.tree import Tree
from app.editor.guide.scratch import NAME
from app.editor.guide.steps import SECOND
from app.editor.library.survey import RowKey
from app.editor.window.main_window import MainWindow
from app.engine.snapshots import Mode
from tests.gui.conftest import PATIENCE
from tests.gui.guide.newcomer import (
    all_is_answered,
    at,
    begin,
    choose_in_library,
    faster,
    near_a_box,
    pick,
    play_until,
    press,
    press_next,
    ring_is_around,
    seen_by,
    teach_wander,
    time_stands_still,
    turn_left,
    wait_ticks,
    walk_on,
)


def test_wander_is_taught_by_doing_what_the_lesson_says(lesson: MainWindow, qtbot: QtBot) -> None:
    window = lesson
    assert window.studio.document.project.name == NAME
    assert window.studio.document.folder is None
    qtbot.waitUntil(ring_is_around(window, qtbot), timeout=PATIENCE)
    teach_wander(window, qtbot)
    assert window.studio.mode is Mode.TESTING
    press_next(window, qtbot)
    at(window, qtbot, "Now foraging")
    choose_in_library(window, qtbot, RowKey("agent", "forage"))
    at(window, qtbot, "Take an agent in hand")


def test_who_goes_ahead_of_the_lesson_is_not_told_to_do_it_again(lesson: MainWindow, qtbot: QtBot) -> None:
    qtbot.keyClick(lesson, Qt.Key.Key_T)
    at(lesson, qtbot, "Send it ahead")
    pick(lesson, qtbot, "Forward")
    at(lesson, qtbot, "Let it walk")
    press(lesson, qtbot, Qt.Key.Key_Period)
    pick(lesson, qtbot, "RotateLeft")
    at(lesson, qtbot, "And ahead again")


def test_time_stops_where_either_turn_is_fine_so_that_agents_turn_by_chance(
    lesson: MainWindow, qtbot: QtBot
) -> None:
    teach_wander(lesson, qtbot)
    document = lesson.studio.document
    turns = {
        example.label: example.values["ticks"]
        for example in document.project.examples_of("agent", "wander")
        if example.source == "forward" and example.label != "forward"
    }
    assert turns["rotate-left"] == turns["rotate-right"]
    wander = document.project.library("agent").automata["wander"]
    tree = wander.learned["forward"]
    assert isinstance(tree, Tree)
    outcome = dict(
        zip(tree.labels, tree.decide({"ticks": turns["rotate-left"]}.__getitem__).probabilities, strict=True)
    )
    assert outcome["rotate-left"] == outcome["rotate-right"] == 0.5


@pytest.mark.parametrize("way", ["picks early", "skips the step", "leaves the lesson"])
def test_time_does_not_stop_later_for_who_goes_on_before_it_has_stopped(
    lesson: MainWindow, qtbot: QtBot, way: str
) -> None:
    def stops() -> bool:
        return lesson.studio.snapshot is not None and lesson.studio.snapshot.stops_at is not None

    lesson.studio.settings.learns_by_itself = False  # nothing else makes the engine tell how it stands
    turn_left(lesson, qtbot)
    qtbot.keyClick(lesson, Qt.Key.Key_Space)
    qtbot.waitUntil(time_stands_still(lesson), timeout=PATIENCE)
    pick(lesson, qtbot, "Forward")
    at(lesson, qtbot, "Turn it right")
    qtbot.keyClick(lesson, Qt.Key.Key_Period)
    qtbot.waitUntil(stops, timeout=PATIENCE)
    qtbot.waitUntil(all_is_answered(lesson), timeout=PATIENCE)
    if way == "picks early":
        pick(lesson, qtbot, "RotateRight")
    else:
        button = lesson.guide.skip if way == "skips the step" else lesson.guide.close_button
        qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not stops(), timeout=PATIENCE)


def test_foraging_is_taught_by_doing_what_the_lesson_says_and_boxes_come_in(
    window: MainWindow, qtbot: QtBot
) -> None:
    studio = window.studio
    window.resize(1280, 800)
    studio.settings.lesson_step = SECOND
    begin(window, qtbot)
    choose_in_library(window, qtbot, RowKey("agent", "wander"))  # Forage may be chosen already
    choose_in_library(window, qtbot, RowKey("agent", "forage"))
    at(window, qtbot, "Take an agent in hand")
    studio.selection.select_nodes([near_a_box(window)])
    qtbot.waitUntil(lambda: studio.selection.node != near_a_box(window), timeout=PATIENCE)
    qtbot.keyClick(window, Qt.Key.Key_T)
    at(window, qtbot, "Let it search")
    faster(window, qtbot, 8.0)
    pick(window, qtbot, "Wander")
    at(window, qtbot, "When it finds a box")
    play_until(window, qtbot, "sees")
    pick(window, qtbot, "ReturnWithBox")
    at(window, qtbot, "And off again")
    play_until(window, qtbot, "done")
    pick(window, qtbot, "Wander")
    at(window, qtbot, "Test it")
    qtbot.keyClick(window, Qt.Key.Key_T, Qt.KeyboardModifier.ShiftModifier)
    at(window, qtbot, "Watch them, and correct them")
    qtbot.keyClick(window, Qt.Key.Key_Space)
    qtbot.waitUntil(
        lambda: studio.snapshot is not None and studio.snapshot.measures["boxes"] > 3, timeout=PATIENCE
    )
    press_next(window, qtbot)
    at(window, qtbot, "That is all it takes")
    labels: dict[tuple[object, ...], set[str]] = {}
    for example in studio.document.project.examples_of("agent", "forage"):
        labels.setdefault((example.source, *sorted(example.values.items())), set()).add(example.label)
    assert all(len(found) == 1 for found in labels.values()), "nothing contradicts anything"
    card, legend = window.guide.geometry(), window.canvas.on_top.legend.geometry()
    assert not card.intersects(legend)


def test_what_is_to_be_watched_stays_until_it_was_read_however_fast_time_passes(
    lesson: MainWindow, qtbot: QtBot
) -> None:
    guide = lesson.guide
    while guide.title.text() != "Watch them":
        qtbot.mouseClick(guide.skip, Qt.MouseButton.LeftButton)
    qtbot.keyClick(lesson, Qt.Key.Key_Space)
    faster(lesson, qtbot, 8.0)
    wait_ticks(lesson, qtbot, 450)
    assert guide.title.text() == "Watch them"
    press_next(lesson, qtbot)
    at(lesson, qtbot, "Now foraging")


def test_who_begins_what_comes_next_has_seen_what_was_to_be_watched(lesson: MainWindow, qtbot: QtBot) -> None:
    guide = lesson.guide
    while guide.title.text() != "Watch them":
        qtbot.mouseClick(guide.skip, Qt.MouseButton.LeftButton)
    choose_in_library(lesson, qtbot, RowKey("agent", "forage"))
    at(lesson, qtbot, "Take an agent in hand")
    qtbot.mouseClick(guide.back, Qt.MouseButton.LeftButton)
    assert "so already" in guide.words.text()
    qtbot.keyClick(lesson, Qt.Key.Key_T)
    at(lesson, qtbot, "Let it search")
    qtbot.mouseClick(guide.back, Qt.MouseButton.LeftButton)
    assert "so already" in guide.words.text()
    pick(lesson, qtbot, "Wander")
    at(lesson, qtbot, "When it finds a box")


def test_who_lets_time_go_on_at_a_box_is_stopped_again_at_the_next(window: MainWindow, qtbot: QtBot) -> None:
    studio = window.studio
    studio.settings.lesson_step = SECOND
    begin(window, qtbot)
    choose_in_library(window, qtbot, RowKey("agent", "wander"))
    choose_in_library(window, qtbot, RowKey("agent", "forage"))
    at(window, qtbot, "Take an agent in hand")
    qtbot.keyClick(window, Qt.Key.Key_T)
    at(window, qtbot, "Let it search")
    faster(window, qtbot, 8.0)
    pick(window, qtbot, "Wander")
    at(window, qtbot, "When it finds a box")
    play_until(window, qtbot, "sees")
    walk_on(window, qtbot)
    qtbot.waitUntil(lambda: seen_by(window, "sees") and time_stands_still(window)(), timeout=PATIENCE)


def test_what_a_step_asks_for_may_be_so_already_which_is_said_and_goes_on_by_next(
    window: MainWindow, qtbot: QtBot
) -> None:
    guide, studio = window.guide, window.studio
    studio.settings.lesson_step = SECOND
    begin(window, qtbot)
    assert guide.title.text() == "Now foraging"
    assert "That is so already: press Next." in guide.words.text()
    assert not guide.ring.isVisible()
    press(window, qtbot, Qt.Key.Key_Period)  # a tick tells nothing new of it
    assert guide.title.text() == "Now foraging"
    choose_in_library(window, qtbot, RowKey("agent", "wander"))
    qtbot.waitUntil(lambda: guide.skip.text() == "Skip", timeout=PATIENCE)
    assert "so already" not in guide.words.text()
    choose_in_library(window, qtbot, RowKey("agent", "forage"))
    at(window, qtbot, "Take an agent in hand")
    qtbot.mouseClick(guide.back, Qt.MouseButton.LeftButton)
    press_next(window, qtbot)
    assert guide.title.text() == "Take an agent in hand"
