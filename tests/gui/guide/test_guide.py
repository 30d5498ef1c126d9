"""The guided first lesson: it waits for what the user does, points at it, and can be taken up again."""

from collections.abc import Callable
from functools import partial

import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtWidgets import QAbstractButton, QPushButton
from pytestqt.qtbot import QtBot

from app.core.tree import Tree
from app.editor.guide.pupil import distances
from app.editor.guide.ring import found
from app.editor.guide.scratch import NAME, scratch_project
from app.editor.guide.steps import FORAGING, SECOND, STEPS
from app.editor.library.panel import LibraryPanel
from app.editor.library.survey import RowKey
from app.editor.window.main_window import MainWindow
from app.engine.snapshots import Mode
from tests.gui.conftest import PATIENCE


@pytest.fixture
def lesson(window: MainWindow, qtbot: QtBot) -> MainWindow:
    """The lesson has begun."""
    begin(window, qtbot)
    return window


def begin(window: MainWindow, qtbot: QtBot) -> None:
    window.studio.actions["help.lesson"].trigger()
    studio = window.studio
    qtbot.waitUntil(lambda: window.guide.isVisible() and studio.snapshot is not None, timeout=PATIENCE)


def at(window: MainWindow, qtbot: QtBot, title: str) -> None:
    """Wait until the lesson has come to a step."""
    qtbot.waitUntil(lambda: window.guide.title.text() == title, timeout=PATIENCE)


def wait_ticks(window: MainWindow, qtbot: QtBot, ticks: int) -> None:
    studio = window.studio
    assert studio.snapshot is not None
    until = studio.snapshot.tick + ticks
    qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.tick >= until, timeout=PATIENCE)


def pick(window: MainWindow, qtbot: QtBot, name: str) -> None:
    def button() -> QAbstractButton | None:
        target = found(window, f"pick:{name}")
        return target if isinstance(target, QAbstractButton) else None

    qtbot.waitUntil(lambda: button() is not None, timeout=PATIENCE)
    target = button()
    assert target is not None
    qtbot.mouseClick(target, Qt.MouseButton.LeftButton)


def ring_is_around(window: MainWindow, qtbot: QtBot) -> Callable[[], bool]:
    ring = window.guide.ring
    return lambda: ring.isVisible() and ring.target is not None


def time_stands_still(window: MainWindow) -> Callable[[], bool]:
    studio = window.studio
    return lambda: studio.snapshot is not None and studio.snapshot.speed == 0.0


def all_is_answered(window: MainWindow) -> Callable[[], bool]:
    studio, engine = window.studio, window.studio.bridge._engine
    assert engine is not None
    return lambda: studio.snapshot is not None and studio.snapshot.acknowledged >= engine._tickets


def press_next(window: MainWindow, qtbot: QtBot) -> None:
    """Say that one has seen what there was to see."""
    assert window.guide.skip.text() == "Next"
    qtbot.mouseClick(window.guide.skip, Qt.MouseButton.LeftButton)


def turn_left(window: MainWindow, qtbot: QtBot) -> None:
    """Do what the lesson says until the agent turns left, while time passes."""
    qtbot.keyClick(window, Qt.Key.Key_T)
    at(window, qtbot, "Send it ahead")
    pick(window, qtbot, "Forward")
    at(window, qtbot, "Let it walk")
    qtbot.keyClick(window, Qt.Key.Key_Space)
    at(window, qtbot, "Turn it left")
    pick(window, qtbot, "RotateLeft")
    at(window, qtbot, "And ahead again")
    wait_ticks(window, qtbot, 10)


def teach_wander(window: MainWindow, qtbot: QtBot) -> None:
    """Do what the first half of the lesson says."""
    turn_left(window, qtbot)
    pick(window, qtbot, "Forward")
    at(window, qtbot, "Turn it right")
    qtbot.waitUntil(time_stands_still(window), timeout=PATIENCE)
    pick(window, qtbot, "RotateRight")
    at(window, qtbot, "Ahead once more")
    qtbot.keyClick(window, Qt.Key.Key_Space)
    wait_ticks(window, qtbot, 10)
    pick(window, qtbot, "Forward")
    at(window, qtbot, "Test it")
    qtbot.keyClick(window, Qt.Key.Key_T, Qt.KeyboardModifier.ShiftModifier)
    at(window, qtbot, "Watch them")
    window.speed.choose(window.studio, 4.0)


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
    wait_ticks(lesson, qtbot, 1_000)
    assert guide.title.text() == "Watch them"
    press_next(lesson, qtbot)
    at(lesson, qtbot, "Now foraging")


def test_the_lesson_is_closed_by_a_button_once_it_is_over(lesson: MainWindow, qtbot: QtBot) -> None:
    guide = lesson.guide
    while guide.title.text() != "Watch them, and correct them":
        qtbot.mouseClick(guide.skip, Qt.MouseButton.LeftButton)
    press_next(lesson, qtbot)
    assert guide.title.text() == "That is all it takes"
    assert guide.skip.text() == "Close"
    qtbot.mouseClick(guide.skip, Qt.MouseButton.LeftButton)
    assert not guide.isVisible()


def test_the_card_goes_where_it_hides_nobody_who_is_selected(lesson: MainWindow, qtbot: QtBot) -> None:
    canvas, guide = lesson.canvas, lesson.guide
    lesson.resize(1280, 800)
    qtbot.waitUntil(lambda: canvas.scene is not None, timeout=PATIENCE)
    for _ in range(3):
        before = guide.geometry()
        hidden = agent_within(lesson, before)
        lesson.studio.selection.select_nodes([hidden])
        qtbot.waitUntil(partial(lambda before: guide.geometry() != before, before), timeout=PATIENCE)
        assert not guide.geometry().contains(place_of(lesson, hidden))
        assert canvas.rect().contains(guide.geometry())


def test_what_the_canvas_tells_of_who_is_under_the_mouse_lies_above_the_card(
    lesson: MainWindow, qtbot: QtBot
) -> None:
    canvas, guide = lesson.canvas, lesson.guide
    lesson.resize(1280, 800)
    qtbot.waitUntil(lambda: canvas.scene is not None, timeout=PATIENCE)
    beside = guide.geometry().adjusted(-60, 0, 0, 0)
    spots = [place_of(lesson, node) for node in agents_of(lesson)]
    spot = next(p for p in spots if beside.contains(p) and not guide.geometry().contains(p))
    qtbot.mouseMove(canvas, spot)
    qtbot.waitUntil(canvas.card.isVisible, timeout=PATIENCE)
    shared = canvas.card.geometry().intersected(guide.geometry())
    assert not shared.isEmpty()
    over = canvas.parentWidget()
    assert over is not None
    layers = over.children()
    assert layers.index(canvas.card) > layers.index(guide)


def agents_of(window: MainWindow) -> tuple[str, ...]:
    assert window.canvas.scene is not None
    return window.canvas.scene.place.agents


def place_of(window: MainWindow, node: str) -> QPoint:
    """Where a node is on the canvas."""
    scene = window.canvas.scene
    assert scene is not None
    entity = scene.entity(node)
    x, y = window.canvas.looking.camera.to_view(float(scene.x[entity]), float(scene.y[entity]))
    return QPoint(round(x), round(y))


def agent_within(window: MainWindow, card: QRect) -> str:
    """Somebody whom the card hides."""
    return next(node for node in agents_of(window) if card.contains(place_of(window, node)))


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


def near_a_box(window: MainWindow) -> str:
    """The agent nearest to a box."""
    snapshot = window.studio.snapshot
    assert snapshot is not None
    return snapshot.place.agents[int(distances(snapshot).argmin())]


def choose_in_library(window: MainWindow, qtbot: QtBot, key: RowKey) -> None:
    """Click a behavior in the library."""
    panel = window.docks["library"].widget()
    assert isinstance(panel, LibraryPanel)
    index = panel.shown.mapFromSource(panel.model.find(key))
    panel.tree.scrollTo(index)
    row = panel.tree.visualRect(index)
    spot = QPoint(row.left() + 30, row.center().y())  # on its name
    qtbot.mouseClick(panel.tree.viewport(), Qt.MouseButton.LeftButton, pos=spot)


def faster(window: MainWindow, qtbot: QtBot, speed: float) -> None:
    """Press the key for faster until it is as fast as that."""
    for _ in range(20):
        if window.speed.chosen != speed:
            qtbot.keyClick(window, Qt.Key.Key_Plus)
    assert window.speed.chosen == speed


def play_until(window: MainWindow, qtbot: QtBot, feature: str) -> None:
    """Let time pass, which stops by itself, unless it is so already."""
    if not seen_by(window, feature):
        qtbot.keyClick(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: seen_by(window, feature) and time_stands_still(window)(), timeout=PATIENCE)


def walk_on(window: MainWindow, qtbot: QtBot) -> None:
    """Have time go on although it stands still at a box, until that is out of sight."""

    def gone_or_still() -> bool:
        return not seen_by(window, "sees") or time_stands_still(window)()

    while seen_by(window, "sees"):
        tick = tick_of(window)
        qtbot.keyClick(window, Qt.Key.Key_Space)
        qtbot.waitUntil(
            partial(lambda tick: tick_of(window) > tick and gone_or_still(), tick), timeout=PATIENCE
        )


def tick_of(window: MainWindow) -> int:
    snapshot = window.studio.snapshot
    return 0 if snapshot is None else snapshot.tick


def seen_by(window: MainWindow, feature: str) -> bool:
    """Whether a feature of Forage is true for the agent that is taught."""
    studio = window.studio
    watched = None if studio.snapshot is None else studio.snapshot.watched.get(studio.teaching.node)
    return watched is not None and watched.levels[0].values.get(feature, 0.0) > 0.0


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


def press(window: MainWindow, qtbot: QtBot, key: Qt.Key) -> None:
    """Press a key that passes a tick."""
    before = tick_of(window)
    qtbot.keyClick(window, key)
    qtbot.waitUntil(lambda: tick_of(window) > before, timeout=PATIENCE)


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
