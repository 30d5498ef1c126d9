"""The window's frame: docks, menus from the table, undo, arms."""

import pytest
from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QApplication, QDialog, QLabel, QMenu, QPushButton, QTabBar, QToolButton
from pytestqt.qtbot import QtBot

from app import __version__
from app.core.automaton import START
from app.core.edits import add_automaton, disable_examples, note_project, rename_automaton
from app.core.project import Project
from app.editor.actions import MENUS
from app.editor.documents.asking import Question
from app.editor.focus_frame import FocusFrame
from app.editor.graph.view import GraphView
from app.editor.preferences.dialog import Preferences
from app.editor.room import FRAME, resize_within
from app.editor.selection import BehaviorKey
from app.editor.settings import Settings
from app.editor.studio import Studio
from app.editor.theme import Theme
from app.editor.window.docks import DOCKS
from app.editor.window.main_window import SIZE, MainWindow
from app.editor.window.status_bar import StatusBar
from app.editor.window.toolbar import Toolbar
from app.engine.scenarios import open_scenario
from app.engine.snapshots import Mode
from tests.gui.conftest import PATIENCE, said


def test_every_action_has_a_text_and_a_tip_and_is_in_a_menu_that_exists(window: MainWindow) -> None:
    for row in window.studio.actions.rows.values():
        assert row.text, row.id
        assert row.tip, f"{row.id} has no tip"
        assert row.menu in ("", *MENUS), row.id
        assert row.icon or row.checked, f"{row.id} has no icon, and no mark either"
        assert not row.icon or not window.studio.actions[row.id].icon().pixmap(16).isNull(), row.id


def test_every_action_is_in_a_menu_or_on_a_button(window: MainWindow) -> None:
    buttons = window.findChildren(QToolButton)
    pressed = {action.objectName() for button in buttons for action in button.actions()}
    for row in window.studio.actions.rows.values():
        assert row.menu or row.id in pressed, f"{row.id} is found by nobody who does not know its name"


def test_no_menu_is_higher_than_what_a_low_screen_has_below_the_menu_bar(window: MainWindow) -> None:
    menus = [menu for menu in window.menuBar().findChildren(QMenu) if not menu.isEmpty()]
    assert len(menus) > len(MENUS)
    for menu in menus:
        assert menu.sizeHint().height() < 720, menu.title()


def test_every_action_of_a_menu_is_found_in_it_or_in_one_that_opens_from_it(window: MainWindow) -> None:
    bar = {said(action): action.menu() for action in window.menuBar().actions()}
    for row in window.studio.actions.rows.values():
        if row.menu:
            menu = bar[row.menu]
            assert isinstance(menu, QMenu)
            found = [menu, *menu.findChildren(QMenu)]
            assert any(window.studio.actions[row.id] in each.actions() for each in found), row.id


def test_no_two_actions_have_the_same_shortcut(window: MainWindow) -> None:
    keys: dict[str, str] = {}
    for action_id in window.studio.actions.rows:
        shortcut = window.studio.actions.keys_of(action_id)
        if shortcut:
            assert shortcut not in keys, f"{action_id} and {keys[shortcut]} both have {shortcut}"
            keys[shortcut] = action_id


@pytest.mark.parametrize("panel", [row.id for row in DOCKS])
def test_every_panel_can_be_hidden_and_brought_back(window: MainWindow, panel: str) -> None:
    dock = window.docks[panel]
    dock.hide()
    window.studio.actions[f"view.{panel}"].trigger()
    assert not dock.isHidden()


def test_space_lets_time_pass_and_stops_it(window: MainWindow, qtbot: QtBot) -> None:
    studio = window.studio
    qtbot.keyClick(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.tick > 3, timeout=PATIENCE)
    qtbot.keyClick(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.speed == 0.0, timeout=PATIENCE)


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


def test_an_edit_is_undone_and_redone_by_keys_that_come_right_after_it(
    window: MainWindow, qtbot: QtBot
) -> None:
    document = window.studio.document
    before = document.project
    document.do(note_project, "another note")
    after = document.project
    assert window.isWindowModified()
    qtbot.keyClick(window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert document.project is before
    assert not window.isWindowModified()
    both = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
    qtbot.keyClick(window, Qt.Key.Key_Z, both)
    assert document.project is after


def test_another_arm_is_begun_from_the_tool_bar(window: MainWindow, qtbot: QtBot, studio: Studio) -> None:
    arms = window.toolbar.arm
    with qtbot.waitSignal(studio.bridge.place_changed, timeout=PATIENCE):
        arms.setFocus()
        qtbot.keyClick(arms, Qt.Key.Key_Down)
    assert studio.arm is not None
    assert studio.arm.name == "one level"


def test_a_seed_that_is_none_is_refused_in_words(window: MainWindow, qtbot: QtBot) -> None:
    window.toolbar.seed.setText("")
    qtbot.keyClicks(window.toolbar.seed, "minus one")
    with qtbot.waitSignal(window.messages.shown) as shown:
        qtbot.keyClick(window.toolbar.seed, Qt.Key.Key_Return)
    assert shown.args is not None
    assert "a seed is a whole number" in shown.args[0]


def test_a_world_of_rigid_bodies_is_begun_from_the_menu(
    window: MainWindow, qtbot: QtBot, studio: Studio
) -> None:
    qtbot.waitUntil(studio.actions["run.rigid"].isEnabled, timeout=PATIENCE)
    with qtbot.waitSignal(studio.bridge.place_changed, timeout=PATIENCE):
        studio.actions["run.rigid"].trigger()
    assert studio.snapshot is not None
    assert studio.snapshot.place.physics == "rigid"
    assert studio.actions["run.rigid"].isChecked()


@pytest.mark.parametrize(("height", "shared"), [(800, True), (900, False)])
def test_in_a_low_window_the_automaton_and_its_tree_share_a_place(
    window: MainWindow, studio: Studio, qtbot: QtBot, height: int, *, shared: bool
) -> None:
    window.resize(1280, height)
    studio.actions["view.standard"].trigger()
    graph, tree = window.docks["graph"], window.docks["tree"]
    assert (tree in window.tabifiedDockWidgets(graph)) is shared
    qtbot.waitUntil(lambda: graph.isVisible() and not graph.visibleRegion().isEmpty(), timeout=PATIENCE)
    assert tree.visibleRegion().isEmpty() is shared
    window.show_panel("tree")
    qtbot.waitUntil(lambda: not tree.visibleRegion().isEmpty(), timeout=PATIENCE)


def test_a_tab_says_what_it_is_however_long_names_are(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    window.resize(1280, 800)
    studio.actions["view.standard"].trigger()
    name = "A behavior that somebody has given a name of many words"
    studio.selection.select_behavior(BehaviorKey("agent", studio.document.do(add_automaton, "agent", name)))
    graph, tree = window.docks["graph"], window.docks["tree"]
    qtbot.waitUntil(lambda: graph.windowTitle().startswith("Automaton · A behavior"), timeout=PATIENCE)
    assert graph.windowTitle().endswith("…")
    assert tree.windowTitle() == "Decision tree"
    graph.setFloating(True)
    qtbot.waitUntil(lambda: graph.windowTitle() == f"Automaton · {name}", timeout=PATIENCE)


def test_a_view_is_framed_while_keys_go_there_because_of_keys(window: MainWindow, qtbot: QtBot) -> None:
    window.activateWindow()
    view = window.docks["graph"].findChild(GraphView)
    assert view is not None
    frame = view.findChild(FocusFrame)
    assert frame is not None
    assert not frame.isVisible()
    window.show_panel("graph")
    qtbot.waitUntil(frame.isVisible, timeout=PATIENCE)
    assert frame.geometry() == view.rect()
    window.show_panel("library")
    qtbot.waitUntil(lambda: not frame.isVisible(), timeout=PATIENCE)
    view.setFocus(Qt.FocusReason.MouseFocusReason)
    assert not frame.isVisible()


def test_a_view_is_framed_again_when_escape_leads_back_to_it_from_a_form(
    window: MainWindow, qtbot: QtBot
) -> None:
    window.activateWindow()
    window.studio.selection.select_behavior(BehaviorKey("agent", "wander"), "forward")
    window.show_panel("graph")
    view = window.docks["graph"].findChild(GraphView)
    assert view is not None
    frame = view.findChild(FocusFrame)
    assert frame is not None
    qtbot.waitUntil(window.studio.actions["graph.edit"].isEnabled)
    qtbot.keyClick(view, Qt.Key.Key_F2)
    qtbot.waitUntil(lambda: not view.hasFocus() and not frame.isVisible())
    focus = QApplication.focusWidget()
    assert focus is not None
    qtbot.keyClick(focus, Qt.Key.Key_Escape)
    assert view.hasFocus()
    assert frame.isVisible()
    qtbot.keyClick(view, Qt.Key.Key_F10)
    qtbot.keyClick(QApplication.activePopupWidget(), Qt.Key.Key_Escape)
    qtbot.keyClick(window.menuBar(), Qt.Key.Key_Escape)
    assert view.hasFocus()
    assert frame.isVisible()


def test_what_a_lesson_took_of_the_window_goes_back_after_it(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    examples = window.docks["examples"]
    qtbot.waitUntil(lambda: examples.height() > 150, timeout=PATIENCE)
    before = examples.height()
    studio.selection.select_nodes(("agent-1",))
    studio.teaching.teach()
    qtbot.waitUntil(lambda: studio.mode is Mode.TEACHING, timeout=PATIENCE)
    qtbot.waitUntil(lambda: examples.height() < before, timeout=PATIENCE)
    studio.teaching.stop()
    qtbot.waitUntil(lambda: examples.height() >= before - 20, timeout=PATIENCE)


def test_where_there_is_room_the_tool_bar_says_what_undo_would_undo(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    undo, arm = window.toolbar.undo, window.toolbar.arm

    def has_words() -> bool:
        return undo.toolButtonStyle() is Qt.ToolButtonStyle.ToolButtonTextBesideIcon

    studio.document.do(note_project, "a note")
    window.resize(1900, 1000)
    qtbot.waitUntil(has_words)
    assert said(undo.defaultAction()).startswith("Undo: ")
    assert undo.text().startswith("Undo: ")
    assert arm.isVisible()
    studio.actions["edit.undo"].trigger()
    assert undo.text() == "Undo"
    just_enough = window.toolbar.sizeHint().width()
    window.resize(just_enough, 1000)
    qtbot.waitUntil(lambda: window.toolbar.width() == just_enough and has_words())
    window.toolbar.seed.setText("1234567890")
    assert not has_words(), "a longer seed needs the room"
    assert arm.isVisible()
    window.resize(1280, 800)
    qtbot.waitUntil(lambda: not has_words() and arm.isVisible())


def test_a_layout_from_before_there_was_some_panel_is_not_taken_up(
    qapp: QApplication, window: MainWindow, qtbot: QtBot, settings: Settings, foraging: Project
) -> None:
    window.removeDockWidget(window.docks["timeline"])
    settings.keep("state", window.saveState(len(DOCKS) - 1))
    studio = Studio(Theme(qapp, settings.theme), settings)
    later = MainWindow(studio)
    qtbot.addWidget(later)
    later.show()
    studio.open(foraging, open_scenario(foraging), None, saved=True)
    beside = later.tabifiedDockWidgets(later.docks["examples"])
    assert later.docks["timeline"] in beside
    later.hide()
    studio.shut_down()


def test_the_standard_layout_leaves_no_tabs_of_another_one(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    def tabs_on_the_window() -> list[str]:
        bars = [bar for bar in window.findChildren(QTabBar) if bar.parent() is window and bar.isVisible()]
        seen = [bar for bar in bars if window.rect().intersects(bar.geometry())]
        return sorted(bar.tabText(k).split(" ")[0] for bar in seen for k in range(bar.count()))

    window.docks["graph"].setFloating(True)
    for _ in range(2):
        studio.actions["view.standard"].trigger()
    qtbot.waitUntil(
        lambda: tabs_on_the_window() == ["Examples", "Plots", "Problems", "Timeline"], timeout=PATIENCE
    )
    assert not window.docks["graph"].isFloating()


def test_help_tells_the_version_and_all_keys(window: MainWindow, studio: Studio, qtbot: QtBot) -> None:
    studio.actions["help.about"].trigger()
    about = window.findChild(Question)
    assert about is not None
    assert about.details is not None
    assert f"Understudy {__version__}" in about.details.toPlainText()
    with qtbot.waitSignal(about.destroyed, timeout=PATIENCE):
        qtbot.keyClick(about, Qt.Key.Key_Escape)
    studio.actions["help.keys"].trigger()
    preferences = window.findChild(Preferences)
    assert preferences is not None
    assert preferences.keys.isVisible()
    preferences.close()


def test_opening_another_project_leaves_window_and_panels_where_they_are(
    window: MainWindow, studio: Studio, foraging: Project
) -> None:
    window.resize(1300, 820)
    window.docks["examples"].hide()
    size = window.size()
    studio.open(foraging, open_scenario(foraging), None, saved=False)
    assert window.size() == size
    assert window.docks["examples"].isHidden()


def test_the_status_bar_counts_what_the_world_counts(window: MainWindow, qtbot: QtBot) -> None:
    measures = window.statusBar().findChildren(QLabel)
    qtbot.waitUntil(lambda: any("boxes 0" in label.text() for label in measures), timeout=PATIENCE)


def test_a_window_that_comes_later_says_tick_and_seed_at_once(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    bar, tools = StatusBar(studio), Toolbar(studio, window.speed)
    for part in (bar, tools):
        qtbot.addWidget(part)
    assert (bar.tick.text(), tools.seed.text()) == ("tick 0", "1")


def test_how_well_a_behavior_fits_is_said_of_what_it_is_now_also_while_the_library_is_hidden(
    window: MainWindow, qtbot: QtBot
) -> None:
    studio, bar = window.studio, window.statusBar()
    assert isinstance(bar, StatusBar)
    studio.selection.select_behavior(BehaviorKey("agent", "wander"))
    qtbot.waitUntil(lambda: bar.fit.text() == "Wander fits 90% of 10 examples", timeout=PATIENCE)
    window.hide_panel("library")
    studio.document.do(disable_examples, "agent", "wander", ["1"])
    qtbot.waitUntil(lambda: bar.fit.text() == "Wander fits 89% of 9 examples", timeout=PATIENCE)
    studio.document.do(rename_automaton, "agent", "wander", "Roam")
    qtbot.waitUntil(lambda: bar.fit.text() == "Roam fits 89% of 9 examples", timeout=PATIENCE)


def test_the_status_bar_says_how_fast_time_passes_what_was_learned_and_what_is_saved(
    window: MainWindow, foraging: Project, qtbot: QtBot
) -> None:
    bar = window.statusBar()
    assert isinstance(bar, StatusBar)
    qtbot.waitUntil(lambda: (bar.tick.text(), bar.rate.text()) == ("tick 0", "paused"), timeout=PATIENCE)
    assert bar.saved.text() == "saved"
    qtbot.keyClick(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: bar.rate.text().endswith(" ticks/s"), timeout=PATIENCE)
    qtbot.keyClick(window, Qt.Key.Key_Space)
    window.studio.document.do(disable_examples, "agent", "wander", ["1"])
    qtbot.waitUntil(lambda: bar.learner.text().startswith("learned "), timeout=PATIENCE)
    window.studio.selection.select_behavior(BehaviorKey("agent", "forage"))
    qtbot.waitUntil(lambda: bar.fit.text() == "Forage fits all 10 examples", timeout=PATIENCE)
    window.studio.selection.select_behavior(
        BehaviorKey("agent", "wander")
    )  # two of its examples contradict each other
    qtbot.waitUntil(lambda: bar.fit.text() == "Wander fits 89% of 9 examples", timeout=PATIENCE)
    assert bar.saved.text() == "unsaved changes"
    window.studio.open(foraging, open_scenario(foraging), None, saved=False)
    qtbot.waitUntil(lambda: bar.learner.text() == "", timeout=PATIENCE)  # that was another project


@pytest.mark.parametrize("mode", ["before a lesson", "in a lesson"])
def test_names_of_any_length_leave_the_window_as_narrow_as_the_user_made_it(
    window: MainWindow, qtbot: QtBot, mode: str
) -> None:
    studio = window.studio
    window.resize(1280, 800)
    name = "A behavior that somebody has given a name of many words, which " * 3
    behavior = studio.document.do(add_automaton, "agent", name.strip())
    studio.selection.select_behavior(BehaviorKey("agent", behavior))
    studio.selection.select_nodes(("agent-1",))
    if mode == "in a lesson":
        window.show_panel("plots")
        studio.actions["run.step"].trigger()
        studio.teaching.teach()
        qtbot.waitUntil(lambda: studio.mode is Mode.TEACHING, timeout=PATIENCE)
    panel = window.docks["graph"]
    qtbot.waitUntil(lambda: panel.windowTitle().startswith("Automaton · A behavior"), timeout=PATIENCE)
    QApplication.processEvents()
    assert window.minimumSizeHint().width() <= 1280
    assert window.width() == 1280


def test_selecting_an_agent_shows_how_the_state_decides_that_it_is_in(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    qtbot.keyClick(window, Qt.Key.Key_Period)
    qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.tick == 1, timeout=PATIENCE)
    studio.selection.select_nodes(("agent-1",))
    qtbot.waitUntil(lambda: studio.selection.state != START, timeout=PATIENCE)
    chosen = studio.selection.state
    studio.selection.select_nodes(("agent-2",))  # a state that is shown stays
    qtbot.waitUntil(lambda: studio.snapshot is not None and "agent-2" in studio.snapshot.watched)
    assert studio.selection.state == chosen


def test_a_panel_that_floated_elsewhere_is_back_in_its_place(window: MainWindow, qtbot: QtBot) -> None:
    dock = window.docks["graph"]
    place = dock.geometry()
    dock.setFloating(True)
    dock.move(300, 200)
    QApplication.processEvents()
    dock.setFloating(False)
    qtbot.waitUntil(lambda: dock.geometry().topLeft() == place.topLeft(), timeout=PATIENCE)


def test_the_field_of_the_seed_takes_no_more_room_than_the_seed(window: MainWindow, qtbot: QtBot) -> None:
    seed = window.toolbar.seed
    few = seed.width()
    seed.setFocus()
    seed.selectAll()
    qtbot.keyClicks(seed, "1234567890")
    qtbot.waitUntil(lambda: seed.width() > few)
    assert seed.width() >= seed.fontMetrics().horizontalAdvance("1234567890")
    seed.selectAll()
    qtbot.keyClicks(seed, "7")
    qtbot.waitUntil(lambda: seed.width() == few)


def test_a_world_that_departs_from_its_arm_says_how_until_the_arm_is_chosen_again(
    window: MainWindow, qtbot: QtBot
) -> None:
    bar = window.statusBar()
    assert isinstance(bar, StatusBar)
    window.studio.use_arm("independent", {"world.boxes": 20})
    qtbot.waitUntil(lambda: bar.scenario.text() == "foraging · kinematic · boxes 20", timeout=PATIENCE)
    assert "Choosing the arm again begins its own world" in bar.scenario.toolTip()
    window.toolbar.arm.setFocus()
    qtbot.keyClick(window.toolbar.arm, Qt.Key.Key_Down)
    qtbot.keyClick(window.toolbar.arm, Qt.Key.Key_Up)
    qtbot.waitUntil(lambda: bar.scenario.text() == "foraging · kinematic", timeout=PATIENCE)


def test_what_the_tool_bar_has_no_room_for_opens_at_its_end(window: MainWindow, qtbot: QtBot) -> None:
    window.resize(window.minimumSizeHint().width(), 800)
    tools = window.findChild(Toolbar)
    assert tools is not None
    more = tools.findChild(QToolButton, "qt_toolbar_ext_button")
    assert isinstance(more, QToolButton)
    qtbot.waitUntil(more.isVisible)
    assert not tools.arm.isVisible()
    assert not more.icon().isNull()
    assert more.toolTip() == "What there is no room for"
    window.resize(1440, 900)
    qtbot.waitUntil(lambda: not more.isVisible())
    assert tools.arm.isVisible()


def test_the_first_window_and_dialogs_are_no_larger_than_the_screen(
    empty_studio: Studio, qtbot: QtBot
) -> None:
    window = MainWindow(empty_studio)
    qtbot.addWidget(window)
    window.take_place()
    room = window.screen().availableSize()
    assert room.width() < SIZE.width()
    assert window.size() == SIZE.boundedTo(room)
    assert window.isMaximized()
    dialog = QDialog(window)
    resize_within(dialog, 2 * room.width(), 100)
    assert dialog.size() == QSize(room.width() - FRAME.width(), 100)
