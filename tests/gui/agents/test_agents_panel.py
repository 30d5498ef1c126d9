"""The tree of agents and controllers, as a user meets it."""

from collections.abc import Iterator
from dataclasses import replace

import pytest
from PySide6.QtCore import QMimeData, QModelIndex, QRect, Qt
from PySide6.QtWidgets import QLineEdit
from pytestqt.qtbot import QtBot

from app.core.edits import set_hierarchy
from app.core.hierarchy import Hierarchy, Node, from_table
from app.core.project import LevelTable
from app.editor.agents.forest_model import ForestModel
from app.editor.agents.panel import AgentsPanel
from app.editor.forms.nothing import NothingFound
from app.editor.studio import Studio
from app.engine.commands import Step
from tests.gui.conftest import PATIENCE

ALT, CTRL, SHIFT = (
    Qt.KeyboardModifier.AltModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.ShiftModifier,
)


@pytest.fixture
def panel(studio: Studio, qtbot: QtBot) -> Iterator[AgentsPanel]:
    studio.use_arm("one level")
    qtbot.waitUntil(
        lambda: studio.snapshot is not None and studio.snapshot.arm == "one level", timeout=PATIENCE
    )
    panel = AgentsPanel(studio)
    qtbot.addWidget(panel)
    panel.resize(280, 500)
    with qtbot.waitExposed(panel):
        panel.show()
    yield panel
    panel.hide()


def forest(studio: Studio) -> Hierarchy:
    return studio.document.project.arm("one level").forest()


def names(panel: AgentsPanel, parent: QModelIndex | None = None) -> list[str]:
    parent = parent or QModelIndex()
    return [str(panel.model.index(row, 0, parent).data()) for row in range(panel.model.rowCount(parent))]


def click(panel: AgentsPanel, qtbot: QtBot, node: str, held: Qt.KeyboardModifier | None = None) -> None:
    index = panel.model.find(node)
    panel.tree.setExpanded(index.parent(), True)
    panel.tree.scrollTo(index)
    where = panel.tree.visualRect(index).center()
    qtbot.mouseClick(
        panel.tree.viewport(), Qt.MouseButton.LeftButton, held or Qt.KeyboardModifier.NoModifier, where
    )


def test_groups_are_folded_at_first_and_named_readably(panel: AgentsPanel) -> None:
    assert names(panel)[:2] == ["Group 1", "Group 2"]
    assert not panel.tree.isExpanded(panel.model.find("group-1"))
    assert names(panel, panel.model.find("group-2"))[0] == "Agent 6"


def test_a_click_selects_for_all_panels_and_ctrl_adds(
    panel: AgentsPanel, studio: Studio, qtbot: QtBot
) -> None:
    click(panel, qtbot, "agent-7")
    assert studio.selection.nodes == ("agent-7",)
    click(panel, qtbot, "agent-9", CTRL)
    assert set(studio.selection.nodes) == {"agent-7", "agent-9"}
    assert studio.selection.node == "agent-9"


def test_what_the_canvas_selects_is_selected_here(panel: AgentsPanel, studio: Studio) -> None:
    studio.selection.select_nodes(["agent-3", "agent-44"])
    assert set(panel.selected_ids) == {"agent-3", "agent-44"}
    assert panel.tree.isExpanded(panel.model.find("group-9"))


def test_what_a_node_does_now_is_shown(panel: AgentsPanel, studio: Studio, qtbot: QtBot) -> None:
    studio.bridge.send(Step(5))

    def does() -> bool:
        doing = panel.delegate.doing("agent-1")
        return doing is not None and doing.name != ""

    qtbot.waitUntil(does, timeout=PATIENCE)


def test_f2_names_a_node(panel: AgentsPanel, studio: Studio, qtbot: QtBot) -> None:
    click(panel, qtbot, "group-1")
    qtbot.keyClick(panel.tree, Qt.Key.Key_F2)
    editor = panel.tree.findChild(QLineEdit)
    assert editor is not None
    qtbot.keyClicks(editor, "North")
    qtbot.keyClick(editor, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: forest(studio).node("group-1").name == "North")
    assert studio.document.history.undo_text == "Rename node group-1 of arm one level to North"
    qtbot.waitUntil(lambda: names(panel)[0] == "North")


def test_the_world_keeps_its_forest_until_reset_and_says_so(
    panel: AgentsPanel, studio: Studio, qtbot: QtBot
) -> None:
    assert not panel.held.isVisible()
    click(panel, qtbot, "agent-7")
    qtbot.keyClick(panel.tree, Qt.Key.Key_Delete)
    qtbot.waitUntil(panel.held.isVisible)
    with qtbot.waitSignal(studio.bridge.place_changed, timeout=PATIENCE):
        qtbot.mouseClick(panel.reset, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not panel.held.isVisible())
    assert studio.snapshot is not None
    assert "agent-7" not in studio.snapshot.place.ids


def test_nodes_are_grouped_and_the_group_dissolved_by_keys(
    panel: AgentsPanel, studio: Studio, qtbot: QtBot
) -> None:
    click(panel, qtbot, "group-1")
    click(panel, qtbot, "group-2", SHIFT)
    qtbot.keyClick(panel.tree, Qt.Key.Key_G, CTRL)
    assert [root.id for root in forest(studio).roots][:2] == ["squad-1", "group-3"]
    assert studio.selection.nodes == ("squad-1",)
    qtbot.keyClick(panel.tree, Qt.Key.Key_G, CTRL | SHIFT)
    assert [root.id for root in forest(studio).roots][:2] == ["group-1", "group-2"]


def test_nodes_that_no_type_controls_are_not_grouped_and_it_is_said(
    panel: AgentsPanel, studio: Studio, qtbot: QtBot
) -> None:
    before = studio.document.project
    click(panel, qtbot, "group-1")
    panel.tree.setExpanded(panel.model.find("group-3"), True)
    click(panel, qtbot, "agent-11", CTRL)
    with qtbot.waitSignal(studio.said) as said:
        qtbot.keyClick(panel.tree, Qt.Key.Key_G, CTRL)
    assert said.args is not None
    assert "no node type may control agent and group" in said.args[0].text
    assert studio.document.project is before


def test_where_no_controller_is_selected_it_is_said_what_can_be_dissolved(
    panel: AgentsPanel, studio: Studio, qtbot: QtBot
) -> None:
    panel.tree.setExpanded(panel.model.find("group-3"), True)
    click(panel, qtbot, "agent-11")
    with qtbot.waitSignal(studio.said) as said:
        qtbot.keyClick(panel.tree, Qt.Key.Key_G, CTRL | SHIFT)
    assert said.args is not None
    assert said.args[0].text == "select the controller of the group that is to be dissolved"


def test_nodes_are_moved_by_keys(panel: AgentsPanel, studio: Studio, qtbot: QtBot) -> None:
    click(panel, qtbot, "agent-2")
    qtbot.keyClick(panel.tree, Qt.Key.Key_Up, ALT)
    assert [node.id for node in forest(studio).node("group-1").children][:2] == ["agent-2", "agent-1"]
    qtbot.waitUntil(lambda: panel.selected_ids == ("agent-2",))
    qtbot.keyClick(panel.tree, Qt.Key.Key_Left, ALT)
    assert forest(studio).roots[1].id == "agent-2"
    qtbot.waitUntil(lambda: panel.selected_ids == ("agent-2",))
    qtbot.keyClick(panel.tree, Qt.Key.Key_Right, ALT)
    assert forest(studio).node("group-1").children[-1].id == "agent-2"


def test_dropped_nodes_move_under_the_controller(panel: AgentsPanel, studio: Studio) -> None:
    dragged = panel.model.mimeData([panel.model.find("agent-1"), panel.model.find("agent-2")])
    under = panel.model.find("group-3")
    assert panel.model.canDropMimeData(dragged, Qt.DropAction.MoveAction, -1, -1, under)
    assert not panel.model.canDropMimeData(
        dragged, Qt.DropAction.MoveAction, -1, -1, panel.model.find("agent-9")
    )
    assert not panel.model.canDropMimeData(QMimeData(), Qt.DropAction.MoveAction, -1, -1, under)
    panel.model.dropMimeData(dragged, Qt.DropAction.MoveAction, -1, -1, under)
    assert [node.id for node in forest(studio).node("group-3").children][-2:] == ["agent-1", "agent-2"]
    assert studio.document.history.undo_text == "Move nodes in arm one level"


def test_a_controller_does_not_take_what_may_not_stand_under_it(
    panel: AgentsPanel, studio: Studio, qtbot: QtBot
) -> None:
    before = studio.document.project
    dragged = panel.model.mimeData([panel.model.find("group-1")])
    under = panel.model.find("group-3")
    assert not panel.model.canDropMimeData(dragged, Qt.DropAction.MoveAction, -1, -1, under)
    click(panel, qtbot, "group-2")
    with qtbot.waitSignal(studio.said) as said:
        qtbot.keyClick(panel.tree, Qt.Key.Key_Right, ALT)
    assert said.args is not None
    assert "'group' may not stand under 'group'; allowed: agent" in said.args[0].text
    assert studio.document.project is before


def test_a_wrong_forest_is_told_at_the_place(panel: AgentsPanel, studio: Studio, qtbot: QtBot) -> None:
    wrong = Hierarchy((Node("boss", "group", (Node("g", "group", (Node("a", "agent"),)),)),))
    studio.document.do(set_hierarchy, "one level", wrong)
    qtbot.waitUntil(lambda: "allowed under 'group': agent" in panel.trouble.text())
    assert "boss" in panel.delegate.troubled


def test_add_puts_a_node_where_the_selection_is(panel: AgentsPanel, studio: Studio, qtbot: QtBot) -> None:
    click(panel, qtbot, "group-2")
    qtbot.waitUntil(studio.actions["node.add"].isEnabled)
    studio.actions["node.add"].trigger()
    added = forest(studio).node("group-2").children[-1]
    assert added.type == "agent"
    assert studio.selection.nodes == (added.id,)


@pytest.mark.parametrize("query", ["agent 12", "12 Agent"])
def test_the_filter_keeps_what_is_found_and_enter_selects_it(
    panel: AgentsPanel, studio: Studio, qtbot: QtBot, query: str
) -> None:
    qtbot.keyClicks(panel.filter, query)
    assert names(panel) == ["Group 3"]
    assert names(panel, panel.model.find("group-3")) == ["Agent 12"]
    qtbot.keyClick(panel.filter, Qt.Key.Key_Return)
    assert studio.selection.nodes == ("agent-12",)


def test_ten_thousand_agents_are_made_only_as_they_are_looked_at() -> None:
    model = ForestModel(lambda *_: True, lambda *_: True, lambda *_: "")
    model.show(from_table([100, 100], ["group", "agent"]))
    assert model.rowCount() == 100
    assert len(model._entries) == 100
    assert model.find("agent-5050").data() == "Agent 5050"
    assert len(model._entries) == 200


def test_a_name_in_a_large_forest_does_not_lay_it_out_anew() -> None:
    model = ForestModel(lambda *_: False, lambda *_: False, lambda *_: "")
    before = from_table([3, 1000], ["group", "agent"])
    model.show(before)
    agent = model.find("agent-1500")
    told: list[tuple[QModelIndex, QModelIndex]] = []
    model.modelReset.connect(lambda: told.append((QModelIndex(), QModelIndex())))
    model.dataChanged.connect(lambda first, last, _: told.append((first, last)))
    group = before.roots[1]
    named = replace(group.children[499], name="Zoe")
    children = (*group.children[:499], named, *group.children[500:])
    model.show(Hierarchy((before.roots[0], replace(group, children=children), before.roots[2])))
    assert [first.internalId() for first, _ in told] == [agent.parent().internalId(), agent.internalId()]
    assert agent.data() == "Zoe"
    assert model.find("agent-1500") == agent
    model.show(Hierarchy(before.roots[1:]))
    assert not told[-1][0].isValid()
    assert model.rowCount() == 2


def test_another_arm_shows_another_forest(panel: AgentsPanel, studio: Studio, qtbot: QtBot) -> None:
    studio.use_arm("two levels")
    qtbot.waitUntil(lambda: names(panel) == ["Squad 1", "Squad 2"], timeout=PATIENCE)
    studio.document.do(set_hierarchy, "two levels", LevelTable((3,), ("agent",)))
    qtbot.waitUntil(lambda: names(panel) == ["Agent 1", "Agent 2", "Agent 3"])


def test_a_node_that_is_chosen_still_shows_that_it_unfolds(
    panel: AgentsPanel, studio: Studio, qtbot: QtBot
) -> None:
    click(panel, qtbot, "group-2")
    row = panel.tree.visualRect(panel.model.find("group-2"))
    picture = panel.tree.viewport().grab(QRect(0, row.top(), row.left(), row.height())).toImage()
    shades = {
        picture.pixelColor(x, y).lightness() for x in range(picture.width()) for y in range(picture.height())
    }
    assert max(shades) - min(shades) > 60  # the arrow, dark on the ground of a chosen row


def test_a_filter_that_nothing_passes_says_so(panel: AgentsPanel, qtbot: QtBot) -> None:
    words = panel.tree.findChild(NothingFound)
    assert isinstance(words, NothingFound)
    assert words.isHidden()
    qtbot.keyClicks(panel.filter, "no such thing")
    assert words.isVisible()
    panel.filter.clear()
    assert words.isHidden()
