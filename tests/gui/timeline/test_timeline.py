"""The timeline as a user sees and uses it."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QColor
from pytestqt.qtbot import QtBot

from app.core.edits import note_project
from app.editor.selection import BehaviorKey
from app.editor.timeline.band import HIGH, Band, band_of
from app.editor.timeline.panel import TimelinePanel
from app.editor.timeline.strip_painting import DOT, short, step_of
from app.editor.window.main_window import MainWindow
from app.engine.commands import GoTo, MoveEntities, Pause, Pick, Play, Step, Teach
from app.engine.snapshots import Mode
from app.sim.doing import StateRef
from tests.gui.conftest import PATIENCE


@pytest.fixture
def panel(window: MainWindow, qtbot: QtBot) -> TimelinePanel:
    """The panel in front, at tick 0."""
    window.resize(1440, 900)
    window.show_panel("timeline")
    panel = window.docks["timeline"].widget()
    assert isinstance(panel, TimelinePanel)
    return panel


def passes(window: MainWindow, panel: TimelinePanel, qtbot: QtBot, ticks: int) -> None:
    """Let time pass until a tick, and wait until the panel shows it."""
    bridge, goal = window.studio.bridge, shown(window) + ticks
    bridge.send(Play(16.0))
    qtbot.waitUntil(lambda: shown(window) >= goal, timeout=PATIENCE)
    bridge.send(Pause())
    qtbot.waitUntil(lambda: snapshot_stands(window), timeout=PATIENCE)
    qtbot.waitUntil(lambda: panel.strip.shown.now == shown(window), timeout=PATIENCE)


def shown(window: MainWindow) -> int:
    snapshot = window.studio.snapshot
    assert snapshot is not None
    return snapshot.tick


def snapshot_stands(window: MainWindow) -> bool:
    snapshot = window.studio.snapshot
    return snapshot is not None and snapshot.speed == 0.0


def click(panel: TimelinePanel, qtbot: QtBot, tick: int, row: int) -> None:
    strip = panel.strip
    place = QPointF(strip.places.x_of(tick), strip.places.middle_of(row)).toPoint()
    qtbot.mouseClick(strip, Qt.MouseButton.LeftButton, pos=place)


def color_at(panel: TimelinePanel, x: float, y: float) -> QColor:
    return panel.strip.grab().toImage().pixelColor(QPoint(round(x), round(y)))


def test_what_the_selected_agent_did_is_drawn_in_the_colors_of_behaviors(
    window: MainWindow, panel: TimelinePanel, qtbot: QtBot
) -> None:
    window.studio.selection.select_nodes(["agent-3"])
    passes(window, panel, qtbot, 200)
    qtbot.waitUntil(lambda: "Agent 3" in panel.strip.rows(), timeout=PATIENCE)
    spans = panel.past.spans("agent-3")
    assert spans[0].first == panel.past.points[0].tick
    wide = max(spans, key=lambda span: span.last - span.first)
    assert isinstance(wide.doing, StateRef)
    assert (wide.doing.type, wide.doing.automaton) == ("agent", "forage")
    expected = window.studio.colors.color(
        "agent", wide.doing.state
    )  # its states are called like their behaviors
    x = panel.strip.places.x_of(wide.first) + 6
    assert color_at(panel, x, panel.strip.places.middle_of(panel.strip.rows().index("Agent 3"))) == expected
    held = {"wander": "Wander", "return-with-box": "ReturnWithBox"}
    assert f"Agent 3: {held[wide.doing.state]}" in panel.strip.words_at((wide.first + wide.last) // 2)


def test_all_agents_are_shown_by_the_shares_of_what_they_do(
    window: MainWindow, panel: TimelinePanel, qtbot: QtBot
) -> None:
    passes(window, panel, qtbot, 200)
    strip, snapshot = panel.strip, window.studio.snapshot
    assert snapshot is not None
    band = band_of(panel.past.points, (0, shown(window)), 100, panel._look, Band())
    assert band.picture is not None
    column = [band.picture.pixelColor(99, y).name() for y in range(HIGH)]
    counts = {ref.id: count for ref, count in snapshot.doing.counts().items()}
    for behavior, count in counts.items():
        drawn = column.count(window.studio.colors.color("agent", behavior).name())
        assert abs(drawn / HIGH - count / sum(counts.values())) <= 2 / HIGH
    most = max(counts, key=lambda behavior: counts[behavior])
    x, y = strip.places.x_of(shown(window)) - 6, strip.places.middle_of(1)
    assert color_at(panel, x, y) == window.studio.colors.color("agent", most)


def test_of_a_controller_it_is_said_what_it_directs(
    window: MainWindow, panel: TimelinePanel, qtbot: QtBot
) -> None:
    with qtbot.waitSignal(window.studio.bridge.place_changed, timeout=PATIENCE):
        window.studio.use_arm("one level")
    window.studio.selection.select_nodes(["group-2"])
    passes(window, panel, qtbot, 100)
    qtbot.waitUntil(lambda: "Group 2" in panel.strip.rows(), timeout=PATIENCE)
    assert "Group 2: Forage" in panel.strip.words_at(panel.past.points[1].tick)


def test_a_click_shows_the_world_as_it_was_and_what_came_then_stays_in_sight(
    window: MainWindow, panel: TimelinePanel, qtbot: QtBot
) -> None:
    passes(window, panel, qtbot, 300)
    end = panel.past.points[-1].tick
    click(panel, qtbot, 100, 2)
    qtbot.waitUntil(lambda: abs(shown(window) - 100) <= 2, timeout=PATIENCE)
    assert panel.past.points[-1].tick == end
    click(panel, qtbot, 250, 2)
    qtbot.waitUntil(lambda: abs(shown(window) - 250) <= 2, timeout=PATIENCE)


def test_what_came_then_is_forgotten_once_the_run_will_be_another_one(
    window: MainWindow, panel: TimelinePanel, qtbot: QtBot
) -> None:
    passes(window, panel, qtbot, 300)
    click(panel, qtbot, 100, 2)
    qtbot.waitUntil(lambda: abs(shown(window) - 100) <= 2, timeout=PATIENCE)
    window.studio.document.do(note_project, "something else")
    qtbot.waitUntil(lambda: panel.past.points[-1].tick <= shown(window), timeout=PATIENCE)


def test_the_arrow_keys_go_to_where_something_happened(
    window: MainWindow, panel: TimelinePanel, qtbot: QtBot
) -> None:
    window.studio.selection.select_nodes(["agent-3"])
    passes(window, panel, qtbot, 200)
    qtbot.waitUntil(lambda: "Agent 3" in panel.strip.rows(), timeout=PATIENCE)
    before = [tick for tick in panel.strip.changes() if tick < shown(window)]
    panel.strip.setFocus()
    qtbot.keyClick(panel.strip, Qt.Key.Key_Left)
    qtbot.waitUntil(lambda: shown(window) == before[-1], timeout=PATIENCE)


def test_picks_are_red_dots_until_they_are_taken_back_and_a_click_selects_what_they_recorded(
    window: MainWindow, panel: TimelinePanel, qtbot: QtBot
) -> None:
    studio = window.studio
    studio.bridge.send(Teach("agent", "forage", ("agent-1",)))
    studio.bridge.send(Pick("agent-1", "return-with-box"))
    studio.bridge.send(Pick("agent-1", "wander"))  # in the place of the one before
    studio.bridge.send(Step(60))
    qtbot.waitUntil(lambda: shown(window) == 60, timeout=PATIENCE)
    studio.bridge.send(Pick("agent-1", "return-with-box"))
    studio.bridge.send(Step(60))
    qtbot.waitUntil(lambda: len(panel.strip.shown.picks) == 2 and shown(window) == 120, timeout=PATIENCE)
    first, second = panel.strip.shown.picks
    assert second.tick == 60
    assert second.words == "tick 60: Agent 1 was to go from Wander to ReturnWithBox"
    middle = panel.strip.places.middle_of(0)
    assert color_at(panel, panel.strip.places.x_of(60) + DOT / 2, middle) == studio.theme.color("teach")
    click(panel, qtbot, 60, 0)
    assert studio.selection.behavior == BehaviorKey("agent", "forage")
    assert studio.selection.examples == second.examples
    studio.actions["edit.undo"].trigger()
    qtbot.waitUntil(lambda: panel.strip.shown.picks == (first,), timeout=PATIENCE)


def picked_once(window: MainWindow, panel: TimelinePanel, qtbot: QtBot, agent: str) -> int:
    """Begin a lesson, pick once, and let time pass; returns the tick of the pick."""
    bridge, at = window.studio.bridge, shown(window)
    bridge.send(Teach("agent", "forage", (agent,)))
    bridge.send(Step(60))
    qtbot.waitUntil(lambda: shown(window) == at + 60, timeout=PATIENCE)
    bridge.send(Pick(agent, "return-with-box"))
    bridge.send(Step(60))
    qtbot.waitUntil(lambda: panel.strip.shown.now == at + 120, timeout=PATIENCE)
    return at + 60


def test_a_hand_that_trembles_on_a_pick_does_not_go_back_in_the_run(
    window: MainWindow, panel: TimelinePanel, qtbot: QtBot
) -> None:
    strip, wanted = panel.strip, list[int]()
    tick = picked_once(window, panel, qtbot, "agent-1")
    qtbot.waitUntil(lambda: len(strip.shown.picks) == 1, timeout=PATIENCE)
    strip.tick_wanted.connect(wanted.append)
    at = QPointF(strip.places.x_of(tick), strip.places.middle_of(0)).toPoint()
    qtbot.mousePress(strip, Qt.MouseButton.LeftButton, pos=at)
    qtbot.mouseMove(strip, at + QPoint(2, 1))
    qtbot.mouseRelease(strip, Qt.MouseButton.LeftButton, pos=at + QPoint(2, 1))
    assert window.studio.selection.examples == strip.shown.picks[0].examples
    assert wanted == []


def test_a_pick_that_was_undone_does_not_come_back_with_one_whose_examples_have_the_same_ids(
    window: MainWindow, panel: TimelinePanel, qtbot: QtBot
) -> None:
    studio = window.studio
    picked_once(window, panel, qtbot, "agent-1")
    qtbot.waitUntil(lambda: len(panel.strip.shown.picks) == 1, timeout=PATIENCE)
    studio.actions["teach.stop"].trigger()
    qtbot.waitUntil(lambda: studio.mode is Mode.RUNNING, timeout=PATIENCE)
    studio.actions["edit.undo"].trigger()
    qtbot.waitUntil(lambda: panel.strip.shown.picks == (), timeout=PATIENCE)
    tick = picked_once(window, panel, qtbot, "agent-2")
    qtbot.waitUntil(lambda: bool(panel.strip.shown.picks), timeout=PATIENCE)
    assert [(dot.tick, dot.words.partition(" was")[0]) for dot in panel.strip.shown.picks] == [
        (tick, f"tick {tick}: Agent 2")
    ]


def test_what_came_stays_in_sight_at_tick_0_also_where_something_was_moved(
    window: MainWindow, panel: TimelinePanel, qtbot: QtBot
) -> None:
    bridge = window.studio.bridge
    passes(window, panel, qtbot, 50)
    with qtbot.waitSignal(bridge.event_came, timeout=PATIENCE):
        bridge.send(MoveEntities({0: (10.0, 10.0)}))
    passes(window, panel, qtbot, 50)
    end = shown(window)
    bridge.send(GoTo(0))
    qtbot.waitUntil(lambda: shown(window) == 0, timeout=PATIENCE)
    assert panel.past.points[-1].tick == end


def test_in_a_lesson_nobody_goes_back_and_that_is_said(
    window: MainWindow, panel: TimelinePanel, qtbot: QtBot
) -> None:
    studio = window.studio
    studio.bridge.send(Teach("agent", "forage", ("agent-1",)))
    studio.bridge.send(Step(40))
    qtbot.waitUntil(lambda: panel.strip.shown.now == 40, timeout=PATIENCE)
    assert studio.mode is Mode.TEACHING
    with qtbot.waitSignal(window.messages.shown, timeout=PATIENCE) as said:
        click(panel, qtbot, 10, 2)
    assert said.args is not None
    assert "time only goes on" in said.args[0]
    assert shown(window) == 40


def test_a_lesson_that_goes_on_in_a_world_that_begins_again_has_another_line(
    window: MainWindow, panel: TimelinePanel, qtbot: QtBot
) -> None:
    bridge = window.studio.bridge
    bridge.send(Teach("agent", "forage", ("agent-1",)))
    bridge.send(Step(40))
    qtbot.waitUntil(lambda: shown(window) == 40, timeout=PATIENCE)
    bridge.send(Pick("agent-1", "wander"))
    bridge.send(Step(40))
    qtbot.waitUntil(lambda: len(panel.strip.shown.picks) == 1 and shown(window) == 80, timeout=PATIENCE)
    window.studio.actions["run.reset"].trigger()
    qtbot.waitUntil(lambda: shown(window) == 0, timeout=PATIENCE)
    assert panel.past.points[-1].tick == 0
    bridge.send(Step(60))
    qtbot.waitUntil(lambda: panel.strip.shown.now == 60, timeout=PATIENCE)
    assert panel.strip.shown.picks == ()


def test_another_world_begins_another_line(window: MainWindow, panel: TimelinePanel, qtbot: QtBot) -> None:
    passes(window, panel, qtbot, 30)
    with qtbot.waitSignal(window.studio.bridge.place_changed, timeout=PATIENCE):
        window.studio.use_arm("one level")
    qtbot.waitUntil(lambda: len(panel.past.points) <= 1, timeout=PATIENCE)


def test_marks_stand_at_round_ticks_and_are_short() -> None:
    assert [step_of(length, 8) for length in (5, 9, 100, 3170, 49_000)] == [1, 2, 20, 500, 10_000]
    assert [short(tick) for tick in (0, 500, 1_500, 20_000, 2_000_000)] == ["0", "500", "1.5k", "20k", "2M"]
