"""The tree turns to the state of an example that is chosen, and, where the user wants it, of the selected agent."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.core.automaton import START
from app.core.conditions import Equals
from app.core.edits import disable_examples, set_learned
from app.core.tree import Branch, Leaf, Tree
from app.editor.examples.model import Column
from app.editor.examples.panel import ExamplesPanel
from app.editor.graph.panel import GraphPanel
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from app.editor.tree.panel import TreePanel
from app.editor.tree.scene import TreeScene
from app.editor.tree.subject import Subject
from app.editor.window.main_window import MainWindow
from app.engine.commands import Step
from tests.gui.conftest import PATIENCE
from tests.gui.graph.author import Author
from tests.patient_bot import have_done_what_is_due

LEFT = Qt.MouseButton.LeftButton
FORAGE = BehaviorKey("agent", "forage")


def shown(panel: TreePanel) -> str:
    return "" if panel.subject is None else panel.subject.state


def select_agent(studio: Studio) -> None:
    assert studio.snapshot is not None
    studio.selection.select_nodes(studio.snapshot.place.agents[:1])


def side_by_side(window: MainWindow) -> tuple[TreePanel, GraphPanel]:
    """The tree and the graph, both in sight."""
    tree, graph = (window.docks[name].widget() for name in ("tree", "graph"))
    assert isinstance(tree, TreePanel)
    assert isinstance(graph, GraphPanel)
    for name in ("graph", "tree"):
        window.docks[name].setFloating(True)
    return tree, graph


def follow(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    """Select an agent and follow it: before the first tick it is in Start."""
    select_agent(studio)
    qtbot.mouseClick(panel.header.follow, LEFT)
    assert panel.header.follow.isChecked()
    qtbot.waitUntil(lambda: shown(panel) == START)


def test_a_tree_stays_where_it_is_unless_it_is_to_follow(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    select_agent(studio)
    studio.bridge.send(Step())
    qtbot.waitUntil(lambda: panel.view.told.text() == "lit: Agent 1, now")
    assert not panel.header.follow.isChecked()
    assert shown(panel) == "wander"


def test_a_tree_that_follows_turns_to_the_state_of_the_selected_agent(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    follow(panel, studio, qtbot)
    studio.bridge.send(Step())
    qtbot.waitUntil(lambda: shown(panel) == "wander")
    qtbot.waitUntil(lambda: panel.scene.is_lit(1))
    assert panel.header.states.currentText() == "Wander"


def test_a_tree_that_follows_is_built_once_for_each_state(
    panel: TreePanel, studio: Studio, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    follow(panel, studio, qtbot)
    built: list[object] = []
    build = TreeScene.build

    def counted(scene: TreeScene, subject: Subject | None) -> None:
        built.append(subject)
        build(scene, subject)

    monkeypatch.setattr(TreeScene, "build", counted)
    for tick in range(1, 9):
        studio.bridge.send(Step())
        qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.tick == tick)  # noqa: B023 - called at once
    qtbot.waitUntil(lambda: shown(panel) == "wander" and not panel.following.is_due)
    have_done_what_is_due()
    assert len(built) == 1


def test_choosing_a_state_ends_following(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    follow(panel, studio, qtbot)
    panel.header.states.setFocus()
    qtbot.keyClick(panel.header.states, Qt.Key.Key_Down)
    qtbot.keyClick(panel.header.states, Qt.Key.Key_Down)
    qtbot.waitUntil(lambda: shown(panel) == "return-with-box")
    assert not panel.header.follow.isChecked()


def test_choosing_the_state_that_is_marked_in_the_graph_ends_following_too(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    tree, graph = side_by_side(window)
    studio.selection.select_behavior(FORAGE, "wander")
    qtbot.waitUntil(lambda: graph.scene.current == ("wander",) and shown(tree) == "wander")
    follow(tree, studio, qtbot)
    assert graph.scene.current == ("wander",)  # the graph stays where somebody may be at work
    place = graph.view.mapFromScene(graph.scene.states["wander",].scenePos())
    qtbot.mouseClick(graph.view.viewport(), LEFT, pos=place)
    qtbot.waitUntil(lambda: shown(tree) == "wander")
    assert not tree.header.follow.isChecked()


def test_work_on_the_tree_ends_following_where_it_is(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    follow(panel, studio, qtbot)
    place = panel.view.mapFromScene(panel.scene.nodes[1].scenePos())
    qtbot.mouseClick(panel.view.viewport(), LEFT, pos=place)
    assert not panel.header.follow.isChecked()
    assert studio.selection.state == START
    assert panel.scene.chosen == 1


def test_following_ends_where_the_rules_are_edited(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    studio.selection.select_behavior(BehaviorKey("authored-agent", "goto"), "forward")
    qtbot.waitUntil(lambda: panel.rules.count() == 5)
    qtbot.mouseClick(panel.header.follow, LEFT)
    assert panel.header.follow.isChecked()
    qtbot.mouseClick(
        panel.rules.viewport(), LEFT, pos=panel.rules.visualItemRect(panel.rules.item(0)).center()
    )
    assert not panel.header.follow.isChecked()


def test_it_is_said_whom_to_select_to_follow(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    qtbot.mouseClick(panel.header.follow, LEFT)
    qtbot.waitUntil(lambda: panel.view.told.text() == "Select an agent to follow it")
    select_agent(studio)
    studio.selection.select_behavior(BehaviorKey("agent", "let-go"))
    qtbot.waitUntil(lambda: panel.view.told.text() == "Agent 1 does not run LetGo now")


def test_whether_the_tree_follows_is_remembered(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    qtbot.mouseClick(panel.header.follow, LEFT)
    studio.actions.clear()
    later = TreePanel(studio)
    qtbot.addWidget(later)
    assert later.following.on
    assert later.header.follow.isChecked()


# ----------------------------------------------------------------------------------------------- of examples


def of_state(studio: Studio, state: str) -> list[str]:
    examples = studio.document.project.examples_of("agent", "forage")
    return [example.id for example in examples if example.source == state]


def test_an_example_that_is_chosen_shows_the_tree_of_its_state_and_where_it_ends(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    ids = of_state(studio, "return-with-box")
    label = {e.id: e.label for e in studio.document.project.examples_of("agent", "forage")}[ids[0]]
    studio.selection.select_examples(ids[:1])
    qtbot.waitUntil(lambda: shown(panel) == "return-with-box")
    assert studio.selection.state == "return-with-box"
    assert panel.subject is not None
    (end,) = (key for key in panel.scene.nodes if key != 1 and panel.scene.is_lit(key))
    assert panel.subject.words(panel.scene.nodes[end].knot).title == panel.subject.name(label)
    assert panel.view.told.text() == f"lit: example {ids[0]}"


def test_an_example_goes_before_the_agent_that_is_followed(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    follow(panel, studio, qtbot)
    studio.selection.select_examples(of_state(studio, "return-with-box")[:1])
    qtbot.waitUntil(lambda: shown(panel) == "return-with-box")
    assert not panel.header.follow.isChecked()
    studio.selection.select_examples(())
    qtbot.waitUntil(lambda: not panel.view.told.text())


def test_a_click_on_a_row_of_the_examples_shows_its_tree_and_marks_its_state_in_the_graph(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    (tree, graph), table = side_by_side(window), window.docks["examples"].widget()
    assert isinstance(table, ExamplesPanel)
    studio.selection.select_behavior(FORAGE)
    qtbot.waitUntil(lambda: shown(tree) == START and table.model.row_of(of_state(studio, "wander")[0]) >= 0)
    index = table.model.index(table.model.row_of(of_state(studio, "wander")[0]), Column.WORDS)
    table.table.scrollTo(index)
    qtbot.mouseClick(table.table.viewport(), LEFT, pos=table.table.visualRect(index).center())
    qtbot.waitUntil(lambda: shown(tree) == "wander" and tree.view.told.text().startswith("lit: example"))
    assert graph.scene.current == ("wander",)


def test_a_transition_that_is_selected_in_the_graph_lights_the_way_to_its_leaves(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    tree, graph = side_by_side(window)
    studio.selection.select_behavior(FORAGE)
    qtbot.waitUntil(lambda: graph.scene.is_settled and shown(tree) == START)
    author = Author(graph, qtbot)
    author.click_edge("wander", "return-with-box")
    qtbot.waitUntil(lambda: tree.view.told.text() == "lit: the way to ReturnWithBox")
    assert shown(tree) == "wander"
    assert [tree.scene.is_lit(key) for key in (1, 2, 3)] == [True, False, True]
    author.click(("wander",))
    qtbot.waitUntil(lambda: not tree.view.told.text())
    assert not tree.scene.is_lit(1)


def test_what_a_pick_recorded_in_two_states_shows_the_one_that_was_left(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    left, stays = of_state(studio, "wander")[0], of_state(studio, "return-with-box")[0]
    studio.selection.select_behavior(FORAGE)  # as the timeline does, which knows of no state
    studio.selection.select_examples((left, stays))
    qtbot.waitUntil(lambda: panel.view.told.text() == f"lit: example {left}")
    assert shown(panel) == "wander"


def test_who_is_followed_goes_before_examples_that_are_still_chosen(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    select_agent(studio)
    studio.bridge.send(Step())
    qtbot.waitUntil(lambda: panel.view.told.text() == "lit: Agent 1, now")
    studio.selection.select_examples(of_state(studio, "wander"))
    qtbot.waitUntil(lambda: panel.view.told.text() == "lit: 5 examples")
    qtbot.mouseClick(panel.header.follow, LEFT)
    qtbot.waitUntil(lambda: panel.view.told.text() == "lit: Agent 1, now")
    qtbot.mouseClick(panel.header.follow, LEFT)
    qtbot.waitUntil(lambda: panel.view.told.text() == "lit: 5 examples")


def test_examples_of_the_state_that_is_shown_do_not_turn_the_tree(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    studio.selection.select_examples((*of_state(studio, "return-with-box"), *of_state(studio, "wander")))
    qtbot.waitUntil(lambda: panel.view.told.text() == "lit: 5 examples")
    assert shown(panel) == "wander"
    assert all(panel.scene.is_lit(key) for key in (1, 2, 3))


def test_an_example_that_is_not_learned_from_shows_where_it_would_end(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    studio.settings.learns_by_itself = False
    first = of_state(studio, "wander")[:1]
    studio.document.do(disable_examples, "agent", "forage", first)
    studio.selection.select_examples(first)
    qtbot.waitUntil(lambda: panel.view.told.text() == f"lit: example {first[0]}")
    assert panel.scene.is_lit(1)


def test_a_leaf_below_what_is_open_is_shown_where_an_example_ends_in_it(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    studio.settings.learns_by_itself = False
    automaton = studio.document.automaton("agent", "forage")
    assert automaton is not None
    tree = automaton.learned["wander"]
    assert isinstance(tree, Tree)
    node: Leaf | Branch = Leaf((3.0, 1.0))
    for _ in range(12):
        node = Branch(test=Equals("sees", 7.0), yes=Leaf((1.0, 1.0)), no=node, counts=(4.0, 1.0))
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        models = {**automaton.learned, "wander": replace(tree, root=node)}
        studio.document.do(set_learned, "agent", "forage", models, automaton.learned_from)
    assert 2**12 not in panel.scene.nodes
    studio.selection.select_examples(of_state(studio, "wander")[:1])
    qtbot.waitUntil(lambda: 2**12 in panel.scene.nodes)
    assert panel.scene.is_lit(2**12)
    place = panel.view.mapFromScene(panel.scene.nodes[2**12].scenePos())
    assert panel.view.viewport().rect().contains(place)


def test_a_node_of_the_tree_that_is_chosen_leaves_the_agents_path_lit(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    select_agent(studio)
    studio.bridge.send(Step())
    qtbot.waitUntil(lambda: panel.view.told.text() == "lit: Agent 1, now")
    place = panel.view.mapFromScene(panel.scene.nodes[3].scenePos())
    qtbot.mouseClick(panel.view.viewport(), LEFT, pos=place)
    have_done_what_is_due()
    assert len(studio.selection.examples) == 2
    assert panel.view.told.text() == "lit: Agent 1, now"
