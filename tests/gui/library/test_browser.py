"""The library browser, as a user meets it."""

import json
from collections.abc import Iterator

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QLineEdit, QMenu
from pytestqt.qtbot import QtBot

from app.core.automaton import Nested
from app.core.edits import add_state, disable_examples, duplicate_automaton, rename_automaton, set_note
from app.editor.forms.nothing import NothingFound
from app.editor.library.delegate import USED_BY, layout
from app.editor.library.deleting import ReplaceDialog
from app.editor.library.model import FIT, MIME, ROW
from app.editor.library.panel import LibraryPanel
from app.editor.library.survey import RowKey
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from tests.gui.conftest import PATIENCE, said

CTRL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def panel(studio: Studio, qtbot: QtBot) -> Iterator[LibraryPanel]:
    panel = LibraryPanel(studio)
    qtbot.addWidget(panel)
    panel.resize(420, 700)  # room for all badges, whichever facts have come
    with qtbot.waitExposed(panel):
        panel.show()
    yield panel
    panel.hide()


def shown(panel: LibraryPanel) -> list[str]:
    """The behaviors that can be seen or unfolded, in order."""
    found = []
    for group in range(panel.shown.rowCount()):
        parent = panel.shown.index(group, 0)
        rows = range(panel.shown.rowCount(parent))
        found += [str(panel.shown.index(row, 0, parent).data()) for row in rows]
    return found


def groups(panel: LibraryPanel) -> dict[str, bool]:
    """The groups, and whether they are unfolded."""
    found = (panel.shown.index(at, 0) for at in range(panel.shown.rowCount()))
    return {str(index.data()): panel.tree.isExpanded(index) for index in found}


def spot(panel: LibraryPanel, key: RowKey) -> QPoint:
    """Where a behavior is on the screen."""
    index = panel.shown.mapFromSource(panel.model.find(key))
    panel.tree.scrollTo(index)
    return panel.tree.visualRect(index).center()


def click(panel: LibraryPanel, qtbot: QtBot, key: RowKey) -> None:
    qtbot.mouseClick(panel.tree.viewport(), Qt.MouseButton.LeftButton, pos=spot(panel, key))


FORAGE, GOTO = RowKey("agent", "forage"), RowKey("agent", "goto")


def test_groups_of_the_arm_stand_first_and_open_and_all_others_are_folded(panel: LibraryPanel) -> None:
    found = groups(panel)
    assert list(found)[:2] == ["AGENT · LEARNED", "AGENT · BASIC"]
    assert [title for title, unfolded in found.items() if unfolded] == list(found)[:2]


def test_another_arm_brings_its_types_to_the_front(panel: LibraryPanel, studio: Studio, qtbot: QtBot) -> None:
    studio.use_arm("one level, authored")
    qtbot.waitUntil(lambda: next(iter(groups(panel))).startswith("AUTHORED-AGENT"), timeout=PATIENCE)
    assert not groups(panel)["AGENT · LEARNED"]


def test_a_click_selects_the_behavior_for_all_panels(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    click(panel, qtbot, GOTO)
    assert studio.selection.behavior == BehaviorKey("agent", "goto")


def test_what_another_panel_selects_is_current_here(panel: LibraryPanel, studio: Studio) -> None:
    studio.selection.select_behavior(BehaviorKey("squad", "control-forage-2"))
    assert panel.tree.currentIndex().data() == "ControlForage2"
    assert groups(panel)["SQUAD · LEARNED"]


def test_f2_renames_in_place_as_one_undoable_edit(panel: LibraryPanel, studio: Studio, qtbot: QtBot) -> None:
    click(panel, qtbot, GOTO)
    qtbot.keyClick(panel.tree, Qt.Key.Key_F2)
    editor = panel.tree.findChild(QLineEdit)
    assert editor is not None
    editor.selectAll()
    qtbot.keyClicks(editor, "GoThere")
    qtbot.keyClick(editor, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: studio.document.project.library("agent").get("goto").name == "GoThere")
    assert studio.document.history.undo_text == "Rename Goto to GoThere"
    qtbot.waitUntil(lambda: "GoThere(X)" in shown(panel))


def test_a_name_that_is_taken_is_refused_in_words(panel: LibraryPanel, studio: Studio, qtbot: QtBot) -> None:
    click(panel, qtbot, GOTO)
    qtbot.keyClick(panel.tree, Qt.Key.Key_F2)
    editor = panel.tree.findChild(QLineEdit)
    assert editor is not None
    editor.setText("")
    qtbot.keyClicks(editor, "Wander")
    with qtbot.waitSignal(studio.said) as said:
        qtbot.keyClick(editor, Qt.Key.Key_Return)
    assert said.args is not None
    assert "already has a behavior called 'Wander'" in said.args[0].text


def test_ctrl_d_duplicates_with_all_examples(panel: LibraryPanel, studio: Studio, qtbot: QtBot) -> None:
    click(panel, qtbot, GOTO)
    qtbot.keyClick(panel.tree, Qt.Key.Key_D, CTRL)
    copied = studio.selection.behavior
    assert copied is not None
    project = studio.document.project
    assert project.library("agent").get(copied.id).name == "Goto 2"
    assert project.examples_of("agent", copied.id) == project.examples_of("agent", "goto")


def test_delete_removes_what_nobody_uses_at_once(panel: LibraryPanel, studio: Studio, qtbot: QtBot) -> None:
    click(panel, qtbot, GOTO)
    qtbot.keyClick(panel.tree, Qt.Key.Key_D, CTRL)
    copied = studio.selection.behavior
    assert copied is not None
    qtbot.waitUntil(lambda: panel.tree.currentIndex().data() == "Goto 2(X)")
    qtbot.keyClick(panel.tree, Qt.Key.Key_Delete)
    assert studio.document.automaton("agent", copied.id) is None


def test_after_deleting_the_behavior_beside_it_is_shown_and_what_went_is_said(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    for number in (1, 2, 3):
        studio.document.do(duplicate_automaton, "agent", "wander", f"Copy {number}")
    qtbot.waitUntil(lambda: "Copy 3" in shown(panel), timeout=PATIENCE)
    click(panel, qtbot, RowKey("agent", "copy-2"))
    with qtbot.waitSignal(studio.said) as said:
        qtbot.keyClick(panel.tree, Qt.Key.Key_Delete)
    assert said.args is not None
    assert said.args[0].text == "Copy 2 was deleted with 10 examples; undo brings it back"
    assert studio.selection.behavior == BehaviorKey("agent", "copy-3")
    qtbot.waitUntil(lambda: panel.tree.currentIndex().data() == "Copy 3", timeout=PATIENCE)


def test_keys_in_the_list_are_about_the_row_that_they_are_pressed_on(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    studio.document.do(duplicate_automaton, "agent", "wander", "Copy")
    qtbot.waitUntil(lambda: "Copy" in shown(panel), timeout=PATIENCE)
    click(panel, qtbot, RowKey("agent", "copy"))
    qtbot.keyClicks(panel.filter, "goto")  # hides what is shown elsewhere
    panel.tree.setFocus()
    panel.tree.setCurrentIndex(panel.shown.mapFromSource(panel.model.find(GOTO)))
    studio.selection.select_behavior(BehaviorKey("agent", "copy"))
    qtbot.keyClick(panel.tree, Qt.Key.Key_D, CTRL)
    assert [a.name for a in studio.document.project.library("agent").automata.values()].count("Goto 2") == 1
    assert studio.document.project.library("agent").by_name("Copy 2") is None


def test_what_is_named_otherwise_stays_in_sight_whatever_the_filter_says(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    qtbot.keyClicks(panel.filter, "gather")
    qtbot.keyClick(panel.filter, Qt.Key.Key_Return)
    qtbot.keyClick(panel.tree, Qt.Key.Key_F2)
    editor = panel.tree.findChild(QLineEdit)
    assert isinstance(editor, QLineEdit)
    editor.setText("Meet")
    qtbot.keyClick(editor, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: panel.tree.currentIndex().data() == "Meet(X)", timeout=PATIENCE)
    assert panel.filter.text() == ""


def test_delete_of_what_is_used_names_the_users_and_takes_a_replacement(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    click(panel, qtbot, RowKey("agent", "wander"))
    qtbot.keyClick(panel.tree, Qt.Key.Key_Delete)
    dialog = panel.findChild(ReplaceDialog)
    assert dialog is not None
    assert studio.document.automaton("agent", "wander") is not None
    assert not dialog.delete.isEnabled()
    assert dialog.focusWidget() is dialog.chooser
    qtbot.keyClicks(dialog.chooser.field, "Forward")
    qtbot.keyClick(dialog.chooser.field, Qt.Key.Key_Return)
    qtbot.mouseClick(dialog.delete, Qt.MouseButton.LeftButton)
    assert studio.document.automaton("agent", "wander") is None
    studio.undo()
    assert studio.document.automaton("agent", "wander") is not None


def test_what_would_come_to_run_itself_is_no_replacement_and_a_refusal_is_said_in_the_dialog(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    click(panel, qtbot, RowKey("agent", "goto"))
    qtbot.keyClick(panel.tree, Qt.Key.Key_Delete)
    dialog = panel.findChild(ReplaceDialog)
    assert dialog is not None
    offered = [dialog.chooser.itemText(k) for k in range(dialog.chooser.count())]
    assert "Wander" in offered
    assert not {"Forage", "GatherAt", "Goto", "ReturnWithBox"} & set(offered)
    studio.document.do(add_state, "agent", "wander", Nested("goto"))  # which makes a circle of it meanwhile
    qtbot.keyClicks(dialog.chooser.field, "Wander")
    qtbot.keyClick(dialog.chooser.field, Qt.Key.Key_Return)
    qtbot.mouseClick(dialog.delete, Qt.MouseButton.LeftButton)
    assert dialog.trouble.isVisible()
    assert "wander" in dialog.trouble.text().lower()
    assert studio.document.automaton("agent", "goto") is not None


def test_the_filter_finds_names_features_and_states(panel: LibraryPanel, qtbot: QtBot) -> None:
    qtbot.keyClicks(panel.filter, "state:grabbox")
    assert shown(panel) == ["ReturnWithBox", "ReturnWithBox"]  # taught and authored
    panel.filter.clear()
    qtbot.keyClicks(panel.filter, "feature:sees goto")
    assert "Goto(X)" not in shown(panel)
    panel.filter.clear()
    assert "Goto(X)" in shown(panel)
    assert not groups(panel)["SQUAD · LEARNED"]


def test_typing_into_the_filter_chooses_nothing_and_the_down_arrow_goes_to_what_was_found(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    studio.selection.select_behavior(BehaviorKey("agent", "forage"))
    with qtbot.assertNotEmitted(studio.selection.behavior_changed):
        qtbot.keyClicks(panel.filter, "gather")
        assert not panel.tree.currentIndex().isValid()
        qtbot.keyClicks(panel.filter, "x")  # nothing is left
        panel.filter.clear()
        assert panel.tree.currentIndex().data() == "Forage"
        qtbot.keyClicks(panel.filter, "gather")
    qtbot.keyClick(panel.filter, Qt.Key.Key_Down)
    assert panel.tree.hasFocus()
    assert studio.selection.behavior == BehaviorKey("agent", "gather-at")


def test_numbered_behaviors_stand_in_the_order_of_their_numbers(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    for number in (10, 9, 1):
        studio.document.do(duplicate_automaton, "agent", "wander", f"Copy {number}")
    qtbot.waitUntil(lambda: "Copy 9" in shown(panel), timeout=PATIENCE)
    copies = [name for name in shown(panel) if name.startswith("Copy")]
    assert list(dict.fromkeys(copies)) == ["Copy 1", "Copy 9", "Copy 10"]


def test_enter_in_the_filter_goes_to_the_first_that_is_left(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    qtbot.keyClicks(panel.filter, "gather")
    qtbot.keyClick(panel.filter, Qt.Key.Key_Return)
    assert studio.selection.behavior == BehaviorKey("agent", "gather-at")


def test_enter_in_the_filter_goes_to_the_one_of_that_name_before_others_that_hold_it(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    qtbot.keyClicks(panel.filter, "wander")
    assert shown(panel)[0] == "Forage"  # it has a state that is called so
    qtbot.keyClick(panel.filter, Qt.Key.Key_Return)
    assert studio.selection.behavior == BehaviorKey("agent", "wander")


def test_a_click_on_the_badge_lists_the_users_and_jumps(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    key = RowKey("agent", "wander")
    index = panel.shown.mapFromSource(panel.model.find(key))
    spot(panel, key)
    _, placed = layout(index.data(ROW), index.data(FIT), panel.tree.visualRect(index))
    badge = next(each for each in placed if each.badge.part == USED_BY)
    qtbot.mouseClick(panel.tree.viewport(), Qt.MouseButton.LeftButton, pos=badge.rect.center())
    menu = panel.findChild(QMenu)
    assert menu is not None
    assert [action.text() for action in menu.actions()] == ["State Wander of Forage"]
    menu.actions()[0].trigger()
    menu.close()
    assert studio.selection.behavior == BehaviorKey("agent", "forage")
    assert studio.selection.state == "wander"


def test_every_row_has_its_facts_in_words(panel: LibraryPanel, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: panel.model.find(GOTO).data(FIT) is not None, timeout=PATIENCE)
    tip = str(panel.model.find(GOTO).data(Qt.ItemDataRole.ToolTipRole))
    assert "33 examples" in tip
    assert "fits" in tip
    release = panel.model.find(RowKey("agent", name="Done"))
    assert "raises done" in str(release.data(Qt.ItemDataRole.ToolTipRole))


def test_a_behavior_is_stale_until_it_is_learned_again(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    studio.settings.learns_by_itself = False
    studio.document.do(disable_examples, "agent", "goto", ["1"])

    def stale() -> bool:
        fit = panel.model.find(GOTO).data(FIT)
        return fit is not None and fit.stale

    qtbot.waitUntil(stale, timeout=PATIENCE)
    index = panel.shown.mapFromSource(panel.model.find(GOTO))
    panel.tree.scrollTo(index)
    _, placed = layout(index.data(ROW), index.data(FIT), panel.tree.visualRect(index))
    badge = next(each for each in placed if each.badge.text == "stale")
    qtbot.mouseClick(panel.tree.viewport(), Qt.MouseButton.LeftButton, pos=badge.rect.center())
    qtbot.waitUntil(lambda: not stale(), timeout=PATIENCE)


def test_a_click_on_the_name_of_a_group_folds_and_unfolds_it(panel: LibraryPanel, qtbot: QtBot) -> None:
    for unfolded in (False, True):
        there = panel.tree.visualRect(panel.shown.index(0, 0)).center()
        qtbot.mouseClick(panel.tree.viewport(), Qt.MouseButton.LeftButton, pos=there)
        assert panel.tree.isExpanded(panel.shown.index(0, 0)) is unfolded


def test_only_the_row_that_changes_is_told(panel: LibraryPanel, studio: Studio, qtbot: QtBot) -> None:
    automata = [row.key for row in panel.model.rows if row.examples]
    qtbot.waitUntil(lambda: all(panel.model.find(key).data(FIT) for key in automata), timeout=PATIENCE)
    told: list[str] = []
    panel.model.dataChanged.connect(lambda index, *_: told.append(str(index.data())))
    panel.model.modelReset.connect(lambda: told.append("everything"))
    studio.document.do(set_note, "agent", "goto", "walks")
    qtbot.waitUntil(lambda: bool(told))
    assert set(told) == {"Goto(X)"}


def test_a_renamed_behavior_keeps_its_row_and_the_selection(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    click(panel, qtbot, GOTO)
    studio.document.do(rename_automaton, "agent", "goto", "Aim")
    qtbot.waitUntil(lambda: panel.tree.currentIndex().data() == "Aim(X)")
    assert studio.selection.behavior == BehaviorKey("agent", "goto")


def test_a_dragged_behavior_says_what_it_is(panel: LibraryPanel) -> None:
    data = panel.model.mimeData([panel.model.find(GOTO)])
    assert json.loads(bytes(data.data(MIME).data())) == {"type": "agent", "id": "goto", "name": "Goto"}
    basic = panel.model.mimeData([panel.model.find(RowKey("agent", name="Forward"))])
    assert json.loads(bytes(basic.data(MIME).data())) == {"type": "agent", "id": "", "name": "Forward"}


def test_what_is_dragged_is_not_selected(panel: LibraryPanel, studio: Studio, qtbot: QtBot) -> None:
    shown_before = studio.selection.behavior
    where = spot(panel, GOTO)
    qtbot.mousePress(panel.tree.viewport(), Qt.MouseButton.LeftButton, pos=where)
    assert studio.selection.behavior == shown_before
    panel.tree.dragged.emit()
    assert panel.tree.currentIndex().data() == "Forage"
    qtbot.mouseRelease(panel.tree.viewport(), Qt.MouseButton.LeftButton, pos=where)


def test_enter_opens_the_graph(panel: LibraryPanel, studio: Studio, qtbot: QtBot) -> None:
    click(panel, qtbot, GOTO)
    with qtbot.waitSignal(studio.show_panel) as shown_panel:
        qtbot.keyClick(panel.tree, Qt.Key.Key_Return)
    assert shown_panel.args == ["graph"]


def test_the_context_menu_offers_the_same_actions(panel: LibraryPanel) -> None:
    menu = panel.menu(panel.model.row(panel.model.find(GOTO)))
    texts = [said(action) for action in menu.actions()]
    for text in ("Rename", "Duplicate", "Delete behavior…", "Behavior settings…", "Used by (4)"):
        assert text in texts
    menu.close()


def test_a_filter_that_nothing_passes_says_so(panel: LibraryPanel, qtbot: QtBot) -> None:
    words = panel.tree.findChild(NothingFound)
    assert isinstance(words, NothingFound)
    assert words.isHidden()
    qtbot.keyClicks(panel.filter, "no such thing")
    assert words.isVisible()
    panel.filter.clear()
    assert words.isHidden()
