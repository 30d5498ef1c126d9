"""The problems panel, as a user meets it."""

from collections.abc import Iterator
from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMenu
from pytestqt.qtbot import QtBot

from app.core.automaton import Basic, Nested
from app.core.edits import add_state, bind_state, disable_examples, rename_state, replace_arm
from app.core.features import Ground
from app.editor.problems.model import FIX, PLACE, WHAT
from app.editor.problems.panel import ProblemsPanel
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from tests.gui.conftest import PATIENCE

WHERE = ("agent", "return-with-box")


@pytest.fixture
def panel(studio: Studio, qtbot: QtBot) -> Iterator[ProblemsPanel]:
    studio.settings.learns_by_itself = False
    panel = ProblemsPanel(studio)
    qtbot.addWidget(panel)
    panel.resize(760, 240)
    with qtbot.waitExposed(panel):
        panel.show()
    yield panel
    panel.hide()


def texts(panel: ProblemsPanel) -> list[str]:
    return [str(panel.model.index(row, WHAT).data()) for row in range(panel.model.rowCount())]


def add_idle_state(studio: Studio, panel: ProblemsPanel, qtbot: QtBot) -> str:
    state = studio.document.do(add_state, *WHERE, Basic("Forward"))
    qtbot.waitUntil(lambda: any("never entered" in text for text in texts(panel)), timeout=PATIENCE)
    return str(state)


def open_slot(studio: Studio, panel: ProblemsPanel, qtbot: QtBot) -> str:
    automaton = studio.document.project.library(WHERE[0]).get(WHERE[1])
    state = next(s for s in automaton.states if s.content == Nested("goto", {"X": Ground("deposit")}))
    studio.document.do(bind_state, *WHERE, state.id, "X", None)
    qtbot.waitUntil(lambda: any("is open" in text for text in texts(panel)), timeout=PATIENCE)
    return state.id


def click(panel: ProblemsPanel, qtbot: QtBot, column: int, row: int = 0) -> None:
    where = panel.list.visualRect(panel.model.index(row, column)).center()
    qtbot.mouseClick(panel.list.viewport(), Qt.MouseButton.LeftButton, pos=where)


def test_a_sound_project_says_so(panel: ProblemsPanel) -> None:
    assert panel.empty.isVisible()
    assert not panel.list.isVisible()


def test_a_problem_appears_as_it_arises_and_is_counted_in_the_title(
    panel: ProblemsPanel, studio: Studio, qtbot: QtBot
) -> None:
    with qtbot.waitSignal(panel.title_changed, timeout=PATIENCE) as title:
        studio.document.do(add_state, *WHERE, Basic("Forward"))
    assert title.args == ["Problems 1"]
    assert panel.model.index(0, PLACE).data() == "ReturnWithBox, Forward"
    studio.undo()
    qtbot.waitUntil(panel.empty.isVisible, timeout=PATIENCE)


def test_one_click_removes_a_state_that_is_never_entered(
    panel: ProblemsPanel, studio: Studio, qtbot: QtBot
) -> None:
    before = studio.document.project
    state = add_idle_state(studio, panel, qtbot)
    assert panel.model.index(0, FIX).data() == "Remove the state"
    click(panel, qtbot, FIX)
    assert not studio.document.project.library(WHERE[0]).get(WHERE[1]).has_state(state)
    assert studio.document.history.undo_text == "Remove the state"
    assert studio.document.project.library("agent").get("goto") is before.library("agent").get("goto")
    qtbot.waitUntil(panel.empty.isVisible, timeout=PATIENCE)


def test_an_open_binding_offers_what_it_can_be_bound_to(
    panel: ProblemsPanel, studio: Studio, qtbot: QtBot
) -> None:
    state = open_slot(studio, panel, qtbot)
    panel.list.setFocus()
    qtbot.keyClick(panel.list, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    menu = panel.findChild(QMenu)
    assert menu is not None
    wanted = next(action for action in menu.actions() if action.text() == "Bind 'X' to deposit")
    wanted.trigger()
    menu.close()
    content = studio.document.project.library(WHERE[0]).get(WHERE[1]).state(state).content
    assert content == Nested("goto", {"X": Ground("deposit")})


def test_enter_and_double_click_show_the_place(panel: ProblemsPanel, studio: Studio, qtbot: QtBot) -> None:
    state = add_idle_state(studio, panel, qtbot)
    with qtbot.waitSignal(studio.show_panel) as shown:
        qtbot.keyClick(panel.list, Qt.Key.Key_Return)
    assert shown.args == ["graph"]
    assert studio.selection.behavior == BehaviorKey(*WHERE)
    assert studio.selection.state == state
    studio.selection.select_behavior(BehaviorKey("agent", "goto"))
    spot = panel.list.visualRect(panel.model.index(0, WHAT)).center()
    qtbot.mouseClick(panel.list.viewport(), Qt.MouseButton.LeftButton, pos=spot)
    qtbot.mouseDClick(panel.list.viewport(), Qt.MouseButton.LeftButton, pos=spot)
    assert studio.selection.behavior == BehaviorKey(*WHERE)


def test_errors_stand_before_warnings(panel: ProblemsPanel, studio: Studio, qtbot: QtBot) -> None:
    add_idle_state(studio, panel, qtbot)
    open_slot(studio, panel, qtbot)
    assert [finding.is_error for finding in panel.model.findings] == [True, False]


def test_what_is_stale_is_learned_again_with_one_click(
    panel: ProblemsPanel, studio: Studio, qtbot: QtBot
) -> None:
    studio.document.do(disable_examples, "agent", "goto", ["1"])
    qtbot.waitUntil(
        lambda: any("changed since it was learned" in text for text in texts(panel)), timeout=PATIENCE
    )
    row = next(k for k, text in enumerate(texts(panel)) if "changed since" in text)
    click(panel, qtbot, FIX, row)
    qtbot.waitUntil(lambda: not any("changed since" in text for text in texts(panel)), timeout=PATIENCE)


def test_an_arm_that_names_nothing_is_told_with_what_it_can_start_with(
    panel: ProblemsPanel, studio: Studio, qtbot: QtBot
) -> None:
    arm = studio.document.project.arm("independent")
    studio.document.do(replace_arm, arm.name, replace(arm, top="Forge"))
    qtbot.waitUntil(lambda: any("'Forge'" in text for text in texts(panel)), timeout=PATIENCE)
    ways = [action.text() for action in panel.menu().actions()]
    assert ways[0] == "Start with Forage"
    assert ways[-1] == "Show the place"


def test_f8_goes_through_the_problems(panel: ProblemsPanel, studio: Studio, qtbot: QtBot) -> None:
    add_idle_state(studio, panel, qtbot)
    open_slot(studio, panel, qtbot)
    studio.actions.refresh()
    studio.actions["problems.next"].trigger()
    first = panel.list.currentIndex().row()
    studio.actions["problems.next"].trigger()
    assert panel.list.currentIndex().row() != first


def test_a_fix_whose_place_is_gone_meanwhile_is_refused_in_words(
    panel: ProblemsPanel, studio: Studio, qtbot: QtBot
) -> None:
    add_idle_state(studio, panel, qtbot)
    fix = panel.model.findings[0].fixes[0]
    panel.mend(fix)
    with qtbot.waitSignal(studio.said) as said:
        panel.mend(fix)
    assert said.args is not None
    assert "could not be done" in said.args[0].text


def test_what_is_wrong_can_be_read_in_a_small_window(
    studio: Studio, panel: ProblemsPanel, qtbot: QtBot
) -> None:
    panel.resize(620, 200)
    state = add_idle_state(studio, panel, qtbot)
    row = next(k for k, text in enumerate(texts(panel)) if "never entered" in text)
    columns = {column: panel.list.columnWidth(column) for column in (WHAT, PLACE, FIX)}
    for column in (PLACE, FIX):
        assert columns[column] >= panel.list.sizeHintForColumn(column)
    assert columns[WHAT] > columns[PLACE] + columns[FIX]
    studio.document.do(rename_state, *WHERE, state, "a state with a name that is long enough to be cut")
    qtbot.waitUntil(lambda: "cut" in panel.model.index(row, PLACE).data(), timeout=PATIENCE)
    assert panel.list.columnWidth(PLACE) < panel.list.sizeHintForColumn(PLACE)
    panel.resize(1900, 200)
    qtbot.waitUntil(lambda: panel.list.columnWidth(PLACE) >= panel.list.sizeHintForColumn(PLACE))
    assert panel.model.index(row, FIX).data() == "Remove the state"
