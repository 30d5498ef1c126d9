"""The examples table as a user handles it."""

import pytest
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtWidgets import QApplication, QComboBox, QDoubleSpinBox, QInputDialog, QLabel, QMenu
from pytestqt.qtbot import QtBot

from app.core.edits import add_automaton, disable_examples, relabel_examples, set_values, weight_examples
from app.core.examples import Example
from app.editor.examples.model import Column, ExamplesModel, Index
from app.editor.examples.panel import ExamplesPanel
from app.editor.examples.verdicts import Verdict
from app.editor.forms.nothing import NothingFound
from app.editor.library.delegate import CONFLICTS, layout
from app.editor.library.model import FIT, ROW
from app.editor.library.panel import LibraryPanel
from app.editor.library.survey import RowKey
from app.editor.selection import BehaviorKey
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE
from tests.patient_bot import have_done_what_is_due

WANDER = BehaviorKey("agent", "wander")


@pytest.fixture
def panel(window: MainWindow, qtbot: QtBot) -> ExamplesPanel:
    """The panel with the examples of Wander, judged."""
    window.studio.selection.select_behavior(WANDER)
    panel = window.docks["examples"].widget()
    assert isinstance(panel, ExamplesPanel)
    qtbot.waitUntil(
        lambda: panel.model.subject is not None and panel.model.subject.automaton.id == WANDER.id,
        timeout=PATIENCE,
    )
    qtbot.waitUntil(
        lambda: panel.model.verdict(panel.model.example(0)) is not Verdict.UNKNOWN, timeout=PATIENCE
    )
    return panel


def examples(window: MainWindow) -> tuple[Example, ...]:
    return window.studio.document.project.examples_of(WANDER.type, WANDER.id)


def place(panel: ExamplesPanel, row: int, column: Column) -> QPoint:
    return panel.table.visualRect(panel.model.index(row, column)).center()


def click(qtbot: QtBot, panel: ExamplesPanel, row: int, column: Column = Column.WORDS) -> None:
    qtbot.mouseClick(panel.table.viewport(), Qt.MouseButton.LeftButton, pos=place(panel, row, column))


def double_click(qtbot: QtBot, panel: ExamplesPanel, row: int, column: Column) -> None:
    at, left = place(panel, row, column), Qt.MouseButton.LeftButton
    qtbot.mouseClick(panel.table.viewport(), left, pos=at)
    qtbot.mouseDClick(panel.table.viewport(), left, pos=at)


def test_where_there_are_none_it_is_said_what_to_do_first(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    studio = window.studio

    def said() -> str:
        shown = [label.text() for label in panel.findChildren(QLabel) if label.isVisibleTo(window)]
        return next((text for text in shown if text.endswith(".")), "")

    studio.selection.select_behavior(None)
    qtbot.waitUntil(lambda: said().startswith("Choose a behavior in the library"), timeout=PATIENCE)
    new = studio.document.do(add_automaton, "agent", "Dance")
    studio.selection.select_behavior(BehaviorKey("agent", new))
    qtbot.waitUntil(lambda: said().startswith("No examples yet. Choose an agent, press"), timeout=PATIENCE)
    studio.actions["teach.teach"].trigger()
    qtbot.waitUntil(lambda: said().startswith("No examples yet. Pick in the panel Teach"), timeout=PATIENCE)


def test_each_example_is_told_in_words(panel: ExamplesPanel) -> None:
    words = [panel.model.index(row, Column.WORDS).data() for row in range(panel.model.rowCount())]
    assert all(words)
    assert panel.model.index(0, Column.SOURCE).data() == "Start"


def test_what_subsidiaries_sense_is_told_in_words_too(window: MainWindow, panel: ExamplesPanel) -> None:
    window.studio.selection.select_behavior(BehaviorKey("group", "control-forage"))
    have_done_what_is_due()
    rows = range(panel.model.rowCount())
    words = [panel.model.index(row, Column.WORDS).data() for row in rows]
    assert "nobody is attached to a box" in words
    assert not any("SomeoneIsAttachedToABox" in told for told in words)


def test_who_an_example_is_of_is_called_as_elsewhere(panel: ExamplesPanel) -> None:
    node = panel.model.example(0).node
    assert node.startswith("agent-")
    words = f"Agent {node.removeprefix('agent-')}"
    assert panel.model.index(0, Column.NODE).data() == words
    assert panel.filters.node.findText(words) > 0


def test_a_click_selects_an_example_and_asks_for_its_moment(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    with qtbot.waitSignal(window.studio.moment_wanted, timeout=PATIENCE) as wanted:
        click(qtbot, panel, 0)
    example = panel.model.example(0)
    assert window.studio.selection.examples == (example.id,)
    assert wanted.args is not None
    assert wanted.args[0] == window.studio.document.project.moments[example.snapshot]
    assert wanted.args[1:] == [example.node, f"The moment of example {example.id}"]


def test_the_context_menu_offers_what_can_be_done_and_keeps_nobody_waiting(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    click(qtbot, panel, 0)
    qtbot.waitUntil(window.studio.actions["examples.disable"].isEnabled)
    panel.table.customContextMenuRequested.emit(place(panel, 0, Column.WORDS))
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    entry = next(action for action in menu.actions() if action.objectName() == "examples.disable")
    qtbot.mouseClick(menu, Qt.MouseButton.LeftButton, pos=menu.actionGeometry(entry).center())
    assert not examples(window)[0].enabled


def test_a_tick_box_switches_an_example_off_and_undo_brings_it_back(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    left = panel.table.visualRect(panel.model.index(0, Column.ID))
    box = QPoint(left.left() + 12, left.center().y())
    qtbot.mouseClick(panel.table.viewport(), Qt.MouseButton.LeftButton, pos=box)
    qtbot.waitUntil(lambda: not panel.model.example(0).enabled, timeout=PATIENCE)
    assert not examples(window)[0].enabled
    qtbot.keyClick(window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    qtbot.waitUntil(lambda: panel.model.example(0).enabled, timeout=PATIENCE)


def test_a_switched_off_example_is_learned_without_in_the_background(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    document = window.studio.document
    before = document.project.library("agent").automata["wander"].learned_from
    click(qtbot, panel, 0)
    qtbot.waitUntil(window.studio.actions["examples.disable"].isEnabled)
    window.studio.actions["examples.disable"].trigger()
    qtbot.waitUntil(
        lambda: document.project.library("agent").automata["wander"].learned_from != before, timeout=PATIENCE
    )
    window.studio.undo()
    assert document.project.library("agent").automata["wander"].learned_from == before


def test_a_label_is_chosen_from_the_states_there_are(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    double_click(qtbot, panel, 0, Column.LABEL)
    box = panel.table.viewport().findChild(QComboBox)
    assert isinstance(box, QComboBox)
    before = box.currentData()
    qtbot.waitUntil(box.view().isVisible, timeout=PATIENCE)
    qtbot.keyClick(box.view(), Qt.Key.Key_Down)
    qtbot.keyClick(box.view(), Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: examples(window)[0].label != before, timeout=PATIENCE)


def test_a_weight_is_typed(window: MainWindow, panel: ExamplesPanel, qtbot: QtBot) -> None:
    double_click(qtbot, panel, 0, Column.WEIGHT)
    box = panel.table.viewport().findChild(QDoubleSpinBox)
    assert isinstance(box, QDoubleSpinBox)
    box.selectAll()
    qtbot.keyClicks(box, "3")
    qtbot.keyClick(box, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: examples(window)[0].weight == 3.0, timeout=PATIENCE)


def test_who_types_a_weight_of_nothing_is_told_how_an_example_is_left_out(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    double_click(qtbot, panel, 0, Column.WEIGHT)
    box = panel.table.viewport().findChild(QDoubleSpinBox)
    assert isinstance(box, QDoubleSpinBox)
    box.selectAll()
    qtbot.keyClicks(box, "0")
    with qtbot.waitSignal(window.messages.shown, timeout=PATIENCE) as shown:
        qtbot.keyClick(box, Qt.Key.Key_Return)
    assert shown.args is not None
    assert "To leave an example out, disable it" in shown.args[0]
    assert examples(window)[0].weight == 1.0


def test_what_is_learned_meanwhile_does_not_end_typing(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    double_click(qtbot, panel, 0, Column.WEIGHT)
    box = panel.table.viewport().findChild(QDoubleSpinBox)
    assert isinstance(box, QDoubleSpinBox)
    other = examples(window)[1].id
    window.studio.document.do(disable_examples, WANDER.type, WANDER.id, [other])
    have_done_what_is_due()
    box.selectAll()
    qtbot.keyClicks(box, "3")
    qtbot.keyClick(box, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: examples(window)[0].weight == 3.0, timeout=PATIENCE)
    qtbot.waitUntil(lambda: not panel.model.example(panel.model.row_of(other)).enabled, timeout=PATIENCE)


def test_filters_narrow_the_table_and_are_cleared_at_once(panel: ExamplesPanel, qtbot: QtBot) -> None:
    everything = panel.model.counts[0]
    source = panel.filters.source
    source.setFocus()
    qtbot.keyClick(source, Qt.Key.Key_Down)
    source.activated.emit(source.currentIndex())
    shown = [panel.model.example(row).source for row in range(panel.model.rowCount())]
    assert set(shown) == {source.currentData()}
    assert len(shown) < everything
    qtbot.mouseClick(panel.filters.clear, Qt.MouseButton.LeftButton)
    assert panel.model.counts[0] == everything


def test_filters_that_no_example_passes_say_so(panel: ExamplesPanel, qtbot: QtBot) -> None:
    words = panel.table.findChild(NothingFound)
    assert isinstance(words, NothingFound)
    panel.filters.choose(panel.filters.source, panel.model.example(0).source)
    panel.filters.choose(panel.filters.label, panel.model.example(0).label)
    assert words.isHidden()
    panel.filters.choose(panel.filters.verdict, Verdict.LEFT_OUT)
    assert words.isVisible()
    qtbot.mouseClick(panel.filters.clear, Qt.MouseButton.LeftButton)
    assert words.isHidden()


def test_a_conflict_is_marked_and_can_be_filtered_for(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    document = window.studio.document
    first, second = [e for e in examples(window) if e.source == "forward"][:2]
    document.do(set_values, "agent", "wander", {second.id: dict(first.values)})
    document.do(relabel_examples, "agent", "wander", [first.id], "forward")
    document.do(relabel_examples, "agent", "wander", [second.id], "rotate-left")
    qtbot.waitUntil(
        lambda: panel.model.verdict(examples(window)[int(first.id) - 1]) is Verdict.CONFLICT, timeout=PATIENCE
    )
    panel.filters.choose(panel.filters.verdict, Verdict.CONFLICT)
    shown = {panel.model.example(row).id for row in range(panel.model.rowCount())}
    assert {first.id, second.id} <= shown


def test_sorting_by_what_was_learned_puts_the_worst_first(panel: ExamplesPanel) -> None:
    panel.table.sortByColumn(Column.VERDICT, Qt.SortOrder.AscendingOrder)
    order = list(Verdict)
    places = [order.index(panel.model.verdict(panel.model.example(r))) for r in range(panel.model.rowCount())]
    assert places == sorted(places)


def test_examples_selected_elsewhere_are_selected_in_the_table(
    window: MainWindow, panel: ExamplesPanel
) -> None:
    ids = tuple(e.id for e in examples(window)[1:3])
    window.studio.selection.select_examples(ids)
    rows = {index.row() for index in panel.table.selectionModel().selectedRows()}
    assert {panel.model.example(row).id for row in rows} == set(ids)


def test_without_examples_the_panel_says_how_to_make_some(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    window.studio.selection.select_behavior(BehaviorKey("authored-agent", "wander"))
    qtbot.waitUntil(lambda: panel.model.counts[1] == 0, timeout=PATIENCE)
    assert panel._empty.isVisibleTo(panel)
    assert "press Teach" in panel._empty.text()


def test_all_are_selected_as_one_range_and_painting_asks_those_that_are_seen_only(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of ten thousand, anything else takes seconds."""
    qtbot.keyClick(panel.table, Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    chosen = [example.id for example in examples(window)]
    assert sorted(window.studio.selection.examples) == sorted(chosen)
    window.studio.document.do(disable_examples, WANDER.type, WANDER.id, chosen)
    qtbot.waitUntil(
        lambda: not any(panel.model.example(row).enabled for row in range(len(chosen))), timeout=PATIENCE
    )
    assert panel.table.selectionModel().selection().size() == 1
    seen = panel.table.rowAt(panel.table.viewport().height() - 1)
    assert 0 <= seen < len(chosen) - 1
    asked: set[int] = set()

    def flags(index: Index) -> Qt.ItemFlag:
        asked.add(index.row())
        return ExamplesModel.flags(panel.model, index)

    monkeypatch.setattr(panel.model, "flags", flags)
    panel.table.grab()
    assert asked
    assert max(asked) <= seen + 1


def test_arrow_keys_go_on_from_where_they_were_after_an_edit(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    click(qtbot, panel, 3)
    window.studio.document.do(disable_examples, WANDER.type, WANDER.id, panel.chosen)
    qtbot.waitUntil(lambda: not panel.model.example(3).enabled, timeout=PATIENCE)
    qtbot.keyClick(panel.table, Qt.Key.Key_Down)
    assert window.studio.selection.examples == (panel.model.example(4).id,)
    window.studio.selection.select_examples([panel.model.example(6).id])  # as the tree does
    qtbot.waitUntil(lambda: panel.table.currentIndex().row() == 6, timeout=PATIENCE)
    qtbot.keyClick(panel.table, Qt.Key.Key_Up)
    assert window.studio.selection.examples == (panel.model.example(5).id,)


def test_the_weight_of_an_example_is_seen_without_scrolling_in_a_small_window(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    window.resize(1280, 800)
    qtbot.waitUntil(lambda: window.width() == 1280)
    have_done_what_is_due()
    seen = panel.table.visualRect(panel.model.index(0, Column.WEIGHT))
    assert panel.table.viewport().rect().contains(seen)


def test_dialogs_for_labels_and_weights_begin_with_what_the_example_says(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    first = panel.model.example(2)
    window.studio.document.do(weight_examples, WANDER.type, WANDER.id, [first.id], 2.5)
    panel.refresh()
    click(qtbot, panel, 2)
    qtbot.waitUntil(window.studio.actions["examples.relabel"].isEnabled)
    seen: list[object] = []
    said: list[str] = []

    def look() -> None:
        dialog = QApplication.activeModalWidget()
        assert isinstance(dialog, QInputDialog)
        seen.append(dialog.textValue() or dialog.doubleValue())
        said.append(dialog.labelText())
        assert dialog.width() >= 300  # its title was cut off
        dialog.reject()

    for action in ("examples.relabel", "examples.weigh"):
        QTimer.singleShot(0, look)
        window.studio.actions[action].trigger()
    assert seen == [panel.model.index(2, Column.LABEL).data(), 2.5]
    assert said == [f"Example {first.id} goes to", f"Example {first.id} counts as"]


def test_a_click_on_the_badge_in_the_library_shows_the_examples_that_contradict_each_other(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    window.studio.selection.select_behavior(BehaviorKey("agent", "forage"))
    library = window.docks["library"].widget()
    assert isinstance(library, LibraryPanel)
    index = library.shown.mapFromSource(library.model.find(RowKey(WANDER.type, WANDER.id)))
    qtbot.waitUntil(lambda: index.data(FIT) is not None and index.data(FIT).conflicts > 0, timeout=PATIENCE)
    _, placed = layout(index.data(ROW), index.data(FIT), library.tree.visualRect(index))
    badge = next(each for each in placed if each.badge.part == CONFLICTS)
    qtbot.mouseClick(library.tree.viewport(), Qt.MouseButton.LeftButton, pos=badge.rect.center())
    assert window.studio.selection.behavior == WANDER
    conflicts = index.data(FIT).conflicts
    qtbot.waitUntil(lambda: panel.model.counts == (conflicts, len(examples(window))), timeout=PATIENCE)
    shown = [panel.model.verdict(panel.model.example(row)) for row in range(conflicts)]
    assert set(shown) == {Verdict.CONFLICT}


def test_filters_stay_with_their_behavior_alone(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    panel.filters.choose(panel.filters.label, "forward")
    shown = panel.model.counts[0]
    window.studio.document.do(disable_examples, WANDER.type, WANDER.id, [examples(window)[0].id])
    have_done_what_is_due()
    assert panel.model.counts[0] == shown < panel.model.counts[1]
    window.studio.selection.select_behavior(BehaviorKey("agent", "forage"))
    qtbot.waitUntil(lambda: panel.model.counts == (10, 10), timeout=PATIENCE)
    assert panel.filters.is_open
