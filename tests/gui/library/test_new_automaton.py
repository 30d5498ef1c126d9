"""Making a new behavior in one dialog."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QDialogButtonBox
from pytestqt.qtbot import QtBot

from app.core.automaton import Basic, Nested, RaiseFlag, State
from app.core.edits import note_project
from app.core.features import Ground, Parameter, Sense
from app.editor.library.new_automaton import NewAutomatonDialog
from app.editor.library.panel import LibraryPanel
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from tests.gui.conftest import PATIENCE
from tests.gui.library.hand import choose


@pytest.fixture
def dialog(studio: Studio, qtbot: QtBot) -> Iterator[NewAutomatonDialog]:
    panel = LibraryPanel(studio)
    qtbot.addWidget(panel)
    panel.show()
    studio.actions["behavior.new"].trigger()
    dialog = panel.findChild(NewAutomatonDialog)
    assert dialog is not None
    yield dialog
    panel.hide()


def name_it(dialog: NewAutomatonDialog, qtbot: QtBot, name: str) -> None:
    dialog.general.name.selectAll()
    qtbot.keyClicks(dialog.general.name, name)


def choose_type(dialog: NewAutomatonDialog, qtbot: QtBot, place: int) -> None:
    types = dialog.general.types
    types.setFocus()
    qtbot.keyClick(types, Qt.Key.Key_Down)
    view = types.view()
    qtbot.waitUntil(view.isVisible, timeout=PATIENCE)
    for _ in range(place):
        qtbot.keyClick(view, Qt.Key.Key_Down)
    qtbot.keyClick(view, Qt.Key.Key_Return)


def press_ok(dialog: NewAutomatonDialog, qtbot: QtBot) -> None:
    button = dialog.buttons.button(QDialogButtonBox.StandardButton.Ok)
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def test_all_of_a_behavior_is_made_as_one_step(
    dialog: NewAutomatonDialog, studio: Studio, qtbot: QtBot
) -> None:
    before = studio.document.project
    name_it(dialog, qtbot, "Approach")
    qtbot.mouseClick(dialog.general.add, Qt.MouseButton.LeftButton)
    dialog.tabs.setCurrentWidget(dialog.states)
    for text in ("Forward", "Goto(X)", "raise arrived"):
        choose(dialog.states.new, qtbot, text)
    dialog.states.states.choose("goto")
    box = dialog.states.slots.boxes["X"]
    box.setFocus()
    qtbot.keyClick(box, Qt.Key.Key_Down)  # the first is the parameter
    dialog.tabs.setCurrentWidget(dialog.features)
    choose(dialog.features.new.what, qtbot, "DistanceTo(target)")
    assert not dialog.features.add.isEnabled()
    assert "Choose what 'target' is" in dialog.features.missing.text()
    target = dialog.features.new.slots.boxes["target"]
    target.setFocus()
    qtbot.keyClick(target, Qt.Key.Key_Down)
    qtbot.keyClick(target, Qt.Key.Key_Down)  # the first target after the parameter
    qtbot.mouseClick(dialog.features.add, Qt.MouseButton.LeftButton)
    assert studio.document.project is before
    press_ok(dialog, qtbot)

    made = studio.document.project.library("agent").by_name("Approach")
    assert made is not None
    assert made.parameters == ("X",)
    assert [state.content for state in made.states[1:]] == [
        Basic("Forward"),
        Nested("goto", {"X": Parameter("X")}),
        RaiseFlag("arrived"),
    ]
    source = made.features[0].source
    assert isinstance(source, Sense)
    assert isinstance(source.bindings["target"], Ground)
    assert studio.selection.behavior == BehaviorKey("agent", made.id)
    assert studio.document.history.undo_text == "Add behavior Approach"
    studio.undo()
    assert studio.document.project is before


def test_a_name_that_is_taken_is_said_beside_the_field_and_nothing_is_made(
    dialog: NewAutomatonDialog, studio: Studio, qtbot: QtBot
) -> None:
    before = studio.document.project
    name_it(dialog, qtbot, "Wander")
    assert "already has a behavior called 'Wander'" in dialog.general.name_trouble.text()
    press_ok(dialog, qtbot)
    assert dialog.isVisible()
    assert studio.document.project is before


def test_cancel_leaves_nothing_behind(dialog: NewAutomatonDialog, studio: Studio, qtbot: QtBot) -> None:
    before = studio.document.project
    dialog.tabs.setCurrentWidget(dialog.states)
    choose(dialog.states.new, qtbot, "Forward")
    qtbot.keyClick(dialog, Qt.Key.Key_Escape)
    assert studio.document.project is before


def test_what_happened_to_the_project_meanwhile_is_kept(
    dialog: NewAutomatonDialog, studio: Studio, qtbot: QtBot
) -> None:
    name_it(dialog, qtbot, "Look")
    dialog.tabs.setCurrentWidget(dialog.states)
    choose(dialog.states.new, qtbot, "RotateLeft")
    studio.document.do(note_project, "taught meanwhile")
    press_ok(dialog, qtbot)
    made = studio.document.project.library("agent").by_name("Look")
    assert made is not None
    assert made.states[1].content == Basic("RotateLeft")
    assert studio.document.project.note == "taught meanwhile"


def test_a_controller_is_made_from_what_its_subsidiaries_can_do(
    dialog: NewAutomatonDialog, studio: Studio, qtbot: QtBot
) -> None:
    choose_type(dialog, qtbot, 1)
    name_it(dialog, qtbot, "Lead")
    dialog.tabs.setCurrentWidget(dialog.states)
    choose(dialog.states.new, qtbot, "Forage")
    dialog.tabs.setCurrentWidget(dialog.features)
    choose(dialog.features.new.what, qtbot, "agents' IAmAttachedToABox")
    qtbot.mouseClick(dialog.features.add, Qt.MouseButton.LeftButton)
    press_ok(dialog, qtbot)
    made = studio.document.project.library("group").by_name("Lead")
    assert made is not None
    assert made.states[1].content == Basic("Forage")
    assert made.features[0].shown == "any IAmAttachedToABox"


def test_after_adding_by_keys_the_next_one_can_be_typed(dialog: NewAutomatonDialog, qtbot: QtBot) -> None:
    qtbot.waitUntil(dialog.isActiveWindow, timeout=PATIENCE)
    dialog.tabs.setCurrentWidget(dialog.features)
    page = dialog.features
    choose(page.new.what, qtbot, "DistanceTo(target)")
    target = page.new.slots.boxes["target"]
    qtbot.keyClick(target, Qt.Key.Key_Down)
    page.add.setFocus(Qt.FocusReason.TabFocusReason)
    qtbot.keyClick(page.add, Qt.Key.Key_Return)
    assert page.new.what.field.hasFocus()
    assert page.features.list.count() == 1
    dialog.tabs.setCurrentWidget(dialog.states)
    dialog.states.new.field.setFocus()
    qtbot.keyClicks(dialog.states.new.field, "raise arrived")
    dialog.states.add.setFocus(Qt.FocusReason.TabFocusReason)
    qtbot.keyClick(dialog.states.add, Qt.Key.Key_Return)
    assert dialog.states.new.field.hasFocus()
    assert dialog.states.states.list.count() == 2


def test_a_feature_chosen_but_not_added_is_added_with_the_behavior(
    dialog: NewAutomatonDialog, studio: Studio, qtbot: QtBot
) -> None:
    name_it(dialog, qtbot, "Approach")
    dialog.tabs.setCurrentWidget(dialog.features)
    choose(dialog.features.new.what, qtbot, "ICanSeeABox")
    press_ok(dialog, qtbot)
    made = studio.document.project.library("agent").by_name("Approach")
    assert made is not None
    assert [use.source for use in made.features] == [Sense("ICanSeeABox")]


def test_a_feature_that_lacks_its_target_is_not_dropped_silently(
    dialog: NewAutomatonDialog, studio: Studio, qtbot: QtBot
) -> None:
    dialog.tabs.setCurrentWidget(dialog.features)
    choose(dialog.features.new.what, qtbot, "DistanceTo(target)")
    dialog.tabs.setCurrentWidget(dialog.general)
    press_ok(dialog, qtbot)
    assert dialog.isVisible()
    assert dialog.tabs.currentWidget() is dialog.features
    assert "Choose what 'target' is" in dialog.features.missing.text()


def test_a_click_into_an_empty_chooser_shows_all_choices(dialog: NewAutomatonDialog, qtbot: QtBot) -> None:
    dialog.tabs.setCurrentWidget(dialog.features)
    chooser = dialog.features.new.what
    qtbot.mouseClick(chooser.field, Qt.MouseButton.LeftButton)
    completer = chooser.completer()
    popup = None if completer is None else completer.popup()
    assert popup is not None
    assert popup.isVisible()
    assert popup.model().rowCount() == chooser.count()
    popup.hide()


def test_a_new_behavior_is_for_the_controller_that_is_selected(studio: Studio, qtbot: QtBot) -> None:
    studio.use_arm("one level")
    qtbot.waitUntil(
        lambda: studio.snapshot is not None and studio.snapshot.arm == "one level", timeout=PATIENCE
    )
    panel = LibraryPanel(studio)
    qtbot.addWidget(panel)
    panel.show()
    for node, kind in (("group-2", "group"), ("agent-2", "agent")):
        studio.selection.select_nodes([node])
        studio.actions["behavior.new"].trigger()
        (dialog,) = (d for d in panel.findChildren(NewAutomatonDialog) if d.isVisible())
        assert dialog.general.types.currentText() == kind
        dialog.reject()
    panel.hide()


def test_enter_adds_a_feature_as_it_adds_a_state(dialog: NewAutomatonDialog, qtbot: QtBot) -> None:
    dialog.tabs.setCurrentWidget(dialog.features)
    choose(dialog.features.new.what, qtbot, "ICanSeeABox")
    assert dialog.draft.automaton is not None
    assert [use.shown for use in dialog.draft.automaton.features] == ["ICanSeeABox"]
    assert dialog.features.new.what.currentText() == ""


def test_enter_on_what_is_offered_chooses_it_so_that_its_bindings_can_be_seen_first(
    dialog: NewAutomatonDialog, qtbot: QtBot
) -> None:
    dialog.tabs.setCurrentWidget(dialog.features)
    chooser = dialog.features.new.what
    chooser.field.setFocus()
    qtbot.keyClicks(chooser.field, "ICanSee")
    popup = QApplication.activePopupWidget()
    assert popup is not None
    qtbot.keyClick(popup, Qt.Key.Key_Down)
    qtbot.keyClick(popup, Qt.Key.Key_Return)
    assert dialog.draft.automaton is not None
    assert (chooser.currentText(), dialog.draft.automaton.features) == ("ICanSeeABox", ())
    qtbot.keyClick(chooser.field, Qt.Key.Key_Return)
    assert [use.shown for use in dialog.draft.automaton.features] == ["ICanSeeABox"]


def test_enter_and_tab_go_from_what_a_feature_looks_at_to_what_that_leaves_open(
    dialog: NewAutomatonDialog, qtbot: QtBot
) -> None:
    dialog.tabs.setCurrentWidget(dialog.features)
    form = dialog.features.new
    choose(form.what, qtbot, "DistanceTo(target)")
    target = form.slots.boxes["target"]
    qtbot.waitUntil(target.isVisible)
    assert dialog.focusWidget() is target
    form.what.setFocus()
    qtbot.keyClick(form.what.field, Qt.Key.Key_Tab)
    assert dialog.focusWidget() is target


def test_enter_adds_the_feature_once_its_target_is_chosen(dialog: NewAutomatonDialog, qtbot: QtBot) -> None:
    dialog.tabs.setCurrentWidget(dialog.features)
    form = dialog.features.new
    choose(form.what, qtbot, "DistanceTo(target)")
    target = form.slots.boxes["target"]
    first = target.itemText(0)
    qtbot.waitUntil(target.hasFocus)
    qtbot.keyClick(target, Qt.Key.Key_Return)
    assert dialog.draft.automaton is not None
    assert not dialog.draft.automaton.features  # nothing is chosen yet
    qtbot.keyClick(target, Qt.Key.Key_Down)
    qtbot.keyClick(target, Qt.Key.Key_Return)
    assert [use.shown for use in dialog.draft.automaton.features] == [f"DistanceTo({first})"]
    assert form.what.field.hasFocus()  # for the next one


def test_any_node_type_is_chosen_by_keys(dialog: NewAutomatonDialog, qtbot: QtBot) -> None:
    wanted = dialog.general.types.itemText(2)
    choose_type(dialog, qtbot, 2)
    assert dialog.draft.type == wanted


def test_what_is_summed_up_decides_how_it_can_be(dialog: NewAutomatonDialog, qtbot: QtBot) -> None:
    choose_type(dialog, qtbot, 1)
    dialog.tabs.setCurrentWidget(dialog.features)
    form = dialog.features.new

    def offered() -> list[str]:
        return [form.operation.itemText(k) for k in range(form.operation.count())]

    choose(form.what, qtbot, "agents' IAmAttachedToABox")
    assert offered() == ["somebody", "everybody", "how many"]
    assert dialog.focusWidget() is form.over  # Enter goes on to what is left to choose
    choose(form.what, qtbot, "agents' DistanceTo(target)")
    assert offered() == ["mean", "least", "greatest"]


def test_enter_takes_the_only_name_that_what_was_typed_is_a_part_of(
    dialog: NewAutomatonDialog, qtbot: QtBot
) -> None:
    dialog.tabs.setCurrentWidget(dialog.states)
    for typed in ("goto", "rotate", "raise f"):  # one name; two of them; a flag of the user's own
        choose(dialog.states.new, qtbot, typed)
    assert dialog.draft.automaton is not None
    assert dialog.draft.automaton.states[1:] == (
        State("goto", Nested("goto")),
        State("f", RaiseFlag("f")),
    )
