"""Arms, worlds and node types, changed live."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialogButtonBox, QDoubleSpinBox, QSpinBox, QWidget
from pytestqt.qtbot import QtBot

from app.core.hierarchy import Hierarchy, Node
from app.core.project import LevelTable, Project
from app.editor.agents.arms_dialog import ArmsDialog, arms_and_worlds
from app.editor.agents.level_table import as_table
from app.editor.agents.panel import AgentsPanel
from app.editor.studio import Studio
from tests.gui.conftest import PATIENCE

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def dialog(studio: Studio, qtbot: QtBot) -> Iterator[ArmsDialog]:
    panel = AgentsPanel(studio)
    qtbot.addWidget(panel)
    panel.show()
    dialog = arms_and_worlds(studio, panel)
    with qtbot.waitExposed(dialog):
        pass  # it has shown itself
    yield dialog
    panel.hide()


def type_over(owner: QWidget, qtbot: QtBot, text: str) -> None:
    editor = owner.focusWidget()
    assert editor is not None
    qtbot.keyClicks(editor, text)
    qtbot.keyClick(editor, Qt.Key.Key_Return)


def set_number(box: QWidget, qtbot: QtBot, text: str) -> None:
    assert isinstance(box, QSpinBox)
    box.setFocus()
    box.selectAll()
    qtbot.keyClicks(box, text)
    qtbot.keyClick(box, Qt.Key.Key_Return)


def test_an_arm_is_added_named_and_its_world_shown(dialog: ArmsDialog, studio: Studio, qtbot: QtBot) -> None:
    page = dialog.arms
    qtbot.mouseClick(page.add, LEFT)
    type_over(page.arms.list, qtbot, "mine")
    qtbot.waitUntil(lambda: studio.document.project.arms[-1].name == "mine")
    page.arms.choose("mine")
    page.top.field.setFocus()
    page.top.field.selectAll()
    qtbot.keyClicks(page.top.field, "Wander")
    qtbot.keyClick(page.top.field, Qt.Key.Key_Return)
    assert studio.document.project.arm("mine").top == "Wander"
    qtbot.mouseClick(page.use, LEFT)
    qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.arm == "mine", timeout=PATIENCE)


def test_a_click_on_what_the_roots_start_with_shows_all_that_it_can_be(
    dialog: ArmsDialog, studio: Studio, qtbot: QtBot
) -> None:
    page = dialog.arms
    page.arms.choose("independent")
    field, completer = page.top.field, page.top.completer()
    assert completer is not None
    popup = completer.popup()
    assert popup is not None
    dialog.activateWindow()
    qtbot.waitUntil(dialog.isActiveWindow, timeout=PATIENCE)
    qtbot.mouseClick(field, LEFT)
    qtbot.waitUntil(popup.isVisible, timeout=PATIENCE)
    model = popup.model()
    assert {model.index(row, 0).data() for row in range(model.rowCount())} >= {"Forage", "Wander", "Forward"}
    qtbot.keyClicks(field, "Wand")
    qtbot.keyClick(popup, Qt.Key.Key_Down)
    qtbot.keyClick(popup, Qt.Key.Key_Return)
    assert studio.document.project.arm("independent").top == "Wander"


def test_a_new_arm_starts_with_what_others_start_with(
    dialog: ArmsDialog, studio: Studio, qtbot: QtBot
) -> None:
    qtbot.mouseClick(dialog.arms.add, LEFT)
    assert studio.document.project.arms[-1].top == studio.document.project.arms[0].top == "Forage"


def test_a_forest_is_made_from_a_level_table(dialog: ArmsDialog, studio: Studio, qtbot: QtBot) -> None:
    page = dialog.arms
    page.arms.choose("independent")
    assert not page.table.use.isEnabled()
    qtbot.mouseClick(page.table.above, LEFT)
    set_number(page.table.sizes[0], qtbot, "3")
    set_number(page.table.sizes[1], qtbot, "4")
    qtbot.mouseClick(page.table.use, LEFT)
    assert studio.document.project.arm("independent").hierarchy == LevelTable((3, 4), ("group", "agent"))
    assert studio.document.history.undo_text == "Change the hierarchy of arm independent"


def test_the_world_of_an_arm_has_the_forest_that_its_table_shows(
    dialog: ArmsDialog, studio: Studio, qtbot: QtBot
) -> None:
    page = dialog.arms
    page.arms.choose("independent")
    set_number(page.table.sizes[0], qtbot, "9")
    assert page.table.words.text() == "From the roots down: 9 agents, not made yet"
    qtbot.mouseClick(page.use, LEFT)
    assert studio.document.project.arm("independent").hierarchy == LevelTable((9,), ("agent",))
    assert page.table.words.text() == "From the roots down: 9 agents"
    qtbot.waitUntil(
        lambda: studio.snapshot is not None and "agent-10" not in studio.snapshot.place.ids, timeout=PATIENCE
    )


def test_a_table_that_was_changed_is_made_when_the_dialog_is_closed(
    dialog: ArmsDialog, studio: Studio, qtbot: QtBot
) -> None:
    page = dialog.arms
    page.arms.choose("independent")
    qtbot.mouseClick(page.table.above, LEFT)
    set_number(page.table.sizes[0], qtbot, "3")
    (box,) = dialog.findChildren(QDialogButtonBox)
    qtbot.mouseClick(box.button(QDialogButtonBox.StandardButton.Close), LEFT)
    assert studio.document.project.arm("independent").hierarchy == LevelTable((3, 50), ("group", "agent"))
    studio.undo()
    assert studio.document.project.arm("independent").hierarchy == LevelTable((50,), ("agent",))


def test_a_table_that_was_changed_is_made_when_another_arm_is_chosen_and_of_that_arm_alone(
    dialog: ArmsDialog, studio: Studio, qtbot: QtBot
) -> None:
    page = dialog.arms
    page.arms.choose("independent")
    qtbot.mouseClick(page.copy, LEFT)
    copy = studio.document.project.arms[-1].name
    set_number(page.table.sizes[0], qtbot, "7")
    page.arms.choose("independent")
    assert studio.document.project.arm(copy).hierarchy == LevelTable((7,), ("agent",))
    assert studio.document.project.arm("independent").hierarchy == LevelTable((50,), ("agent",))
    assert page.table.sizes[0].value() == 50


def test_what_was_begun_for_another_project_is_not_made_in_this_one(
    dialog: ArmsDialog, studio: Studio, qtbot: QtBot, foraging: Project
) -> None:
    dialog.arms.arms.choose("independent")
    set_number(dialog.arms.table.sizes[0], qtbot, "7")
    studio.open(foraging, studio.document.scenario, None)
    assert not dialog.isVisible()
    assert studio.document.project is foraging


def test_levels_are_added_by_clicks_at_one_place_also_above_all_known_types(
    dialog: ArmsDialog, studio: Studio, qtbot: QtBot
) -> None:
    page = dialog.arms
    page.arms.choose("independent")
    place = page.table.above.mapToGlobal(page.table.above.rect().center())
    for _ in range(4):
        qtbot.mouseClick(page.table.above, LEFT, pos=page.table.above.mapFromGlobal(place))
        page.table.grab()  # lays it out
    kinds = ("company", "platoon", "squad", "group", "agent")
    assert page.table.table == LevelTable((1, 1, 1, 1, 50), kinds)
    for size in page.table.sizes:
        set_number(size, qtbot, "2")
    qtbot.mouseClick(page.table.use, LEFT)
    assert studio.document.project.arm("independent").hierarchy == LevelTable((2,) * 5, kinds)
    assert [t.level for t in studio.document.project.types if t.name in kinds[:2]] == [3, 4]
    assert studio.document.history.undo_text == "Change the hierarchy of arm independent"


def test_a_table_that_cannot_be_is_refused_beside_it(
    dialog: ArmsDialog, studio: Studio, qtbot: QtBot
) -> None:
    page = dialog.arms
    page.arms.choose("one level")
    page.table.types[0].setFocus()
    qtbot.keyClick(page.table.types[0], Qt.Key.Key_Down)  # a squad right above agents
    assert "allowed under 'squad': group" in page.table.trouble.text()
    assert not page.table.use.isEnabled()


def test_a_parameter_of_an_arm_is_set_with_its_range_and_taken_back(
    dialog: ArmsDialog, studio: Studio, qtbot: QtBot
) -> None:
    page = dialog.arms
    page.arms.choose("independent")
    page.parts.setCurrentWidget(page.parameters)
    editor = page.parameters.editor("boxes")
    assert "by default" in editor.toolTip()
    set_number(editor, qtbot, "4")
    assert studio.document.project.arm("independent").parameters == {"boxes": 4}
    qtbot.mouseClick(page.parameters.clear_button("boxes"), LEFT)
    assert studio.document.project.arm("independent").parameters == {}


def test_an_arm_that_demonstrations_took_place_in_is_not_deleted(
    dialog: ArmsDialog, studio: Studio, qtbot: QtBot
) -> None:
    page = dialog.arms
    page.arms.choose("independent")
    qtbot.keyClick(page.arms.list, Qt.Key.Key_Delete)
    assert "is used by demonstration" in page.trouble.text()
    page.arms.choose("two levels, authored")
    qtbot.keyClick(page.arms.list, Qt.Key.Key_Delete)
    assert "two levels, authored" not in [arm.name for arm in studio.document.project.arms]


def test_worlds_are_added_set_and_deleted_unless_an_arm_names_them(
    dialog: ArmsDialog, studio: Studio, qtbot: QtBot
) -> None:
    page = dialog.worlds
    dialog.tabs.setCurrentWidget(page)
    qtbot.mouseClick(page.add, LEFT)
    type_over(page.worlds.list, qtbot, "crowded")
    qtbot.waitUntil(lambda: "crowded" in studio.document.project.worlds)
    set_number(page.parameters.editor("boxes"), qtbot, "40")
    assert studio.document.project.worlds["crowded"] == {"boxes": 40}
    dialog.arms.arms.choose("independent")
    place = dialog.arms.world.findData("crowded")
    dialog.tabs.setCurrentWidget(dialog.arms)
    dialog.arms.world.setFocus()
    for _ in range(place - dialog.arms.world.currentIndex()):
        qtbot.keyClick(dialog.arms.world, Qt.Key.Key_Down)
    assert studio.document.project.arm("independent").world == "crowded"
    dialog.tabs.setCurrentWidget(page)
    page.worlds.choose("crowded")
    qtbot.keyClick(page.worlds.list, Qt.Key.Key_Delete)
    assert "is used by arm 'independent'" in page.trouble.text()
    studio.undo()
    assert not page.trouble.isVisible()  # it is not any more


def test_values_that_do_not_go_together_are_refused_in_words(
    dialog: ArmsDialog, studio: Studio, qtbot: QtBot
) -> None:
    before = studio.document.project
    page = dialog.arms
    page.arms.choose("independent")
    page._set_parameter("boxes", "many")
    assert "Boxes takes a whole number" in page.trouble.text()
    assert studio.document.project is before


def test_a_type_is_added_and_becomes_a_controller(dialog: ArmsDialog, studio: Studio, qtbot: QtBot) -> None:
    page = dialog.types
    dialog.tabs.setCurrentWidget(page)
    qtbot.mouseClick(page.add, LEFT)
    type_over(page.types.list, qtbot, "platoon")
    qtbot.waitUntil(lambda: studio.document.project.types[-1].name == "platoon")
    page.types.choose("platoon")
    at = next(k for k in range(page.below.count()) if page.below.item(k).text() == "squad")
    page.below.setCurrentRow(at)
    page.below.setFocus()
    qtbot.keyClick(page.below, Qt.Key.Key_Space)
    made = studio.document.project.types[-1]
    assert (made.subsidiaries, made.level) == (("squad",), 3)
    page.types.choose("squad")
    at = next(k for k in range(page.below.count()) if page.below.item(k).text() == "platoon")
    page.below.setCurrentRow(at)
    qtbot.keyClick(page.below, Qt.Key.Key_Space)
    assert "cannot stand below itself" in page.trouble.text()


def test_a_regular_forest_is_shown_as_a_table_and_another_is_not() -> None:
    table = LevelTable((2, 3), ("group", "agent"))
    from app.core.hierarchy import from_table

    assert as_table(from_table(table.sizes, table.types)) == table
    uneven = Hierarchy((Node("g", "group", (Node("a", "agent"),)), Node("b", "agent")))
    assert as_table(uneven) is None


def test_parameters_are_shown_with_as_few_digits_as_say_them(dialog: ArmsDialog) -> None:
    dialog.tabs.setCurrentWidget(dialog.worlds)
    shown = [dialog.worlds.parameters.editor(name) for name in ("width", "step")]
    assert [box.text() for box in shown if isinstance(box, QDoubleSpinBox)] == ["200", "0.1"]
