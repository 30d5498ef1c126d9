"""Changing everything about a behavior later, live."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QLineEdit, QStyle, QStyleOptionFrame
from pytestqt.qtbot import QtBot

from app.core.automaton import Automaton, Basic, Nested, Sampling
from app.core.edits import delete_automaton
from app.core.features import Ground, Operation, Over, Statistic
from app.editor.library.panel import LibraryPanel
from app.editor.library.settings_dialog import BehaviorDialog, behavior_settings
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from tests.gui.conftest import PATIENCE
from tests.gui.library.hand import choose

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def panel(studio: Studio, qtbot: QtBot) -> Iterator[LibraryPanel]:
    panel = LibraryPanel(studio)
    qtbot.addWidget(panel)
    panel.show()
    yield panel
    panel.hide()


@pytest.fixture
def dialog(panel: LibraryPanel, studio: Studio) -> BehaviorDialog:
    return opened(panel, studio, BehaviorKey("agent", "goto"))


def opened(panel: LibraryPanel, studio: Studio, key: BehaviorKey) -> BehaviorDialog:
    dialog = behavior_settings(studio, panel, behavior=key)
    assert dialog is not None
    return dialog


def goto(studio: Studio) -> Automaton:
    automaton = studio.document.automaton("agent", "goto")
    assert automaton is not None
    return automaton


def test_a_name_is_changed_by_enter(dialog: BehaviorDialog, studio: Studio, qtbot: QtBot) -> None:
    dialog.general.name.selectAll()
    qtbot.keyClicks(dialog.general.name, "Approach")
    qtbot.keyClick(dialog.general.name, Qt.Key.Key_Return)
    assert goto(studio).name == "Approach"
    assert dialog.windowTitle() == "Approach – behavior settings"


def test_parameters_are_added_renamed_and_removed(
    dialog: BehaviorDialog, studio: Studio, qtbot: QtBot
) -> None:
    qtbot.mouseClick(dialog.general.add, LEFT)
    assert goto(studio).parameters == ("X", "X2")
    editor = dialog.general.parameters.list.focusWidget()
    assert editor is not None
    qtbot.keyClicks(editor, "speed")
    qtbot.keyClick(editor, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: goto(studio).parameters == ("X", "speed"))
    dialog.general.parameters.choose("speed")
    qtbot.keyClick(dialog.general.parameters.list, Qt.Key.Key_Up, Qt.KeyboardModifier.AltModifier)
    assert goto(studio).parameters == ("speed", "X")
    qtbot.keyClick(dialog.general.parameters.list, Qt.Key.Key_Delete)
    assert goto(studio).parameters == ("X",)
    assert studio.document.history.undo_text == "Set the parameters of Goto"


def test_a_parameter_in_use_is_not_removed_and_the_users_are_named(
    dialog: BehaviorDialog, studio: Studio, qtbot: QtBot
) -> None:
    dialog.general.parameters.choose("X")
    qtbot.keyClick(dialog.general.parameters.list, Qt.Key.Key_Delete)
    assert goto(studio).parameters == ("X",)
    assert "is used by feature" in dialog.general.parameter_trouble.text()


def test_typing_a_note_is_one_step(dialog: BehaviorDialog, studio: Studio, qtbot: QtBot) -> None:
    before = len(studio.document.history.steps)
    qtbot.keyClicks(dialog.general.note, "walks there")
    assert goto(studio).note.startswith("walks there")
    assert len(studio.document.history.steps) == before + 1


def test_states_are_added_named_moved_and_removed(
    dialog: BehaviorDialog, studio: Studio, qtbot: QtBot
) -> None:
    page = dialog.states
    dialog.tabs.setCurrentWidget(page)
    choose(page.new, qtbot, "Wander")
    made = goto(studio).states[-1]
    assert made.content == Nested("wander")
    assert page.states.current == made.id
    qtbot.keyClicks(page.name, "look around")
    qtbot.keyClick(page.name, Qt.Key.Key_Return)
    assert goto(studio).state(made.id).name == "look around"
    qtbot.keyClick(page.states.list, Qt.Key.Key_Up, Qt.KeyboardModifier.AltModifier)
    assert goto(studio).states[-2].id == made.id
    qtbot.keyClick(page.states.list, Qt.Key.Key_Delete)
    assert not goto(studio).has_state(made.id)


def test_a_behavior_cannot_hold_who_holds_it(dialog: BehaviorDialog, qtbot: QtBot) -> None:
    offered = [dialog.states.new.itemText(k) for k in range(dialog.states.new.count())]
    assert "Forage" not in offered
    assert "Goto(X)" not in offered


def test_a_state_can_hold_something_else(dialog: BehaviorDialog, studio: Studio, qtbot: QtBot) -> None:
    state = next(s for s in goto(studio).states if s.content == Basic("Forward"))
    dialog.states.states.choose(state.id)
    choose(dialog.states.content, qtbot, "RotateLeft")
    assert goto(studio).state(state.id).content == Basic("RotateLeft")


def test_a_feature_added_after_demonstrating_is_measured_in_stored_moments(
    dialog: BehaviorDialog, studio: Studio, qtbot: QtBot
) -> None:
    page = dialog.features
    dialog.tabs.setCurrentWidget(page)
    choose(page.new.what, qtbot, "DistanceTo(target)")
    box = page.new.slots.boxes["target"]
    box.setFocus()
    wanted = next(k for k in range(box.count()) if box.itemText(k) == "nearest visible box")
    for _ in range(wanted + 1):
        qtbot.keyClick(box, Qt.Key.Key_Down)
    qtbot.mouseClick(page.add, LEFT)
    made = goto(studio).features[-1]
    assert page.features.current == made.id

    def measured() -> bool:
        return all(made.id in e.values for e in studio.document.project.examples_of("agent", "goto"))

    qtbot.waitUntil(measured, timeout=PATIENCE)
    assert studio.document.history.undo_text == "Add a feature to Goto"


def test_a_feature_is_bound_to_another_target(dialog: BehaviorDialog, studio: Studio, qtbot: QtBot) -> None:
    page = dialog.features
    use = goto(studio).features[0]
    page.features.choose(use.id)
    box = next(iter(page.source.slots.boxes.values()))
    box.setFocus()
    qtbot.keyClick(box, Qt.Key.Key_Down)
    source = goto(studio).features[0].source
    assert source != use.source
    assert isinstance(next(iter(getattr(source, "bindings").values())), Ground)  # noqa: B009 - of any source


def test_a_statistic_is_chosen_by_operation_and_by_whom(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    dialog = opened(panel, studio, BehaviorKey("group", "control-forage"))
    page = dialog.features
    page.features.choose("attached")
    page.source.operation.setFocus()
    qtbot.keyClick(page.source.operation, Qt.Key.Key_Down)
    qtbot.keyClick(page.source.operation, Qt.Key.Key_Down)
    page.source.over.setFocus()
    qtbot.keyClick(page.source.over, Qt.Key.Key_Down)
    automaton = studio.document.automaton("group", "control-forage")
    assert automaton is not None
    source = automaton.feature("attached").source
    assert isinstance(source, Statistic)
    assert (source.operation, source.over) == (Operation.COUNT, Over.SUBSIDIARIES)


def test_learner_settings_are_changed_and_a_slide_is_one_step(
    dialog: BehaviorDialog, studio: Studio, qtbot: QtBot
) -> None:
    page = dialog.learner
    dialog.tabs.setCurrentWidget(page)
    page.sampling.setFocus()
    qtbot.keyClick(page.sampling, Qt.Key.Key_Down)
    assert goto(studio).settings.sampling is Sampling.ARGMAX
    page.pruning.setFocus()
    qtbot.keyClick(page.pruning, Qt.Key.Key_Space)
    assert goto(studio).settings.pruning_confidence == 0.25
    before = len(studio.document.history.steps)
    middle = page.confidence.rect().center()
    qtbot.mousePress(page.confidence, LEFT, pos=middle)
    for step in range(1, 5):
        qtbot.mouseMove(page.confidence, middle + type(middle)(8 * step, 0))
    qtbot.mouseRelease(page.confidence, LEFT, pos=middle + type(middle)(32, 0))
    assert goto(studio).settings.pruning_confidence != 0.25
    assert len(studio.document.history.steps) == before + 1
    page.classifier.setFocus()
    qtbot.keyClick(page.classifier, Qt.Key.Key_Down)
    assert goto(studio).settings.classifier == "cart"


def test_what_is_on_or_off_is_a_box_to_tick_not_a_number(
    dialog: BehaviorDialog, studio: Studio, qtbot: QtBot
) -> None:
    dialog.tabs.setCurrentWidget(dialog.learner)
    box = dialog.learner.fields["gain_ratio"]
    assert isinstance(box, QCheckBox)
    assert (box.text(), box.isChecked()) == ("Choose by gain ratio, not by gain", True)
    box.setFocus()
    for value in (0.0, 1.0):
        qtbot.keyClick(box, Qt.Key.Key_Space)
        assert goto(studio).settings.options["gain_ratio"] == value
    studio.undo()
    assert not box.isChecked()


def test_how_well_it_learns_is_estimated_in_the_background(dialog: BehaviorDialog, qtbot: QtBot) -> None:
    dialog.tabs.setCurrentWidget(dialog.learner)
    qtbot.waitUntil(lambda: "of those held out" in dialog.learner.accuracy.text(), timeout=PATIENCE)


def test_the_dialog_says_when_its_behavior_is_gone_and_goes_on_after_undo(
    panel: LibraryPanel, studio: Studio, qtbot: QtBot
) -> None:
    dialog = opened(panel, studio, BehaviorKey("agent", "goto"))
    studio.document.do(delete_automaton, "agent", "goto", replacement="wander")
    assert dialog.gone.isVisible()
    studio.undo()
    assert not dialog.gone.isVisible()


def test_a_name_that_is_typed_in_a_list_is_not_cut(dialog: BehaviorDialog, qtbot: QtBot) -> None:
    qtbot.mouseClick(dialog.general.add, LEFT)
    field = dialog.general.parameters.list.findChild(QLineEdit)
    assert isinstance(field, QLineEdit)
    option = QStyleOptionFrame()
    field.initStyleOption(option)
    room = field.style().subElementRect(QStyle.SubElement.SE_LineEditContents, option, field)
    assert room.height() >= field.fontMetrics().height()
