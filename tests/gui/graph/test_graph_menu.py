"""What is in the menu Behavior > Automaton, chosen from there, as whoever does not know the keys does."""

import pytest
from PySide6.QtCore import QPointF, Qt

from app.editor.graph.panel import GraphPanel
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from tests.gui.graph.author import Author

AUTHORED = BehaviorKey("authored-agent", "forage")


def test_a_second_rule_between_the_same_states_is_added(author: Author, studio: Studio) -> None:
    author.show(AUTHORED)
    before = studio.document.project
    edge = next(key for key, item in author.panel.scene.edges.items() if item.edge.rules)
    rules = len(author.panel.scene.edges[edge].edge.rules)
    author.click_edge(edge[1], edge[2])
    author.trigger("graph.add_rule")
    assert len(author.panel.scene.edges[edge].edge.rules) == rules + 1
    studio.undo()
    assert studio.document.project is before


@pytest.mark.parametrize("ways", [("graph.copy", "graph.paste"), ("graph.duplicate",)])
def test_states_are_copied(author: Author, studio: Studio, ways: tuple[str, ...]) -> None:
    author.show(AUTHORED)
    states = set(author.panel.scene.states)
    author.click(author.named("Wander"))
    for way in ways:
        author.trigger(way)
    (new,) = set(author.panel.scene.states) - states
    assert author.panel.scene.current == new
    author.trigger("graph.remove")
    assert set(author.panel.scene.states) == states


def test_a_state_is_entered_and_one_that_was_moved_is_arranged_again(
    author: Author, panel: GraphPanel, studio: Studio
) -> None:
    path = author.named("Wander")
    first = panel.scene.states[path].pos()
    author.drag(author.at(path), author.at(path, QPointF(80.0, 40.0)))
    assert panel.scene.states[path].pos() != first
    author.trigger("graph.arrange")
    author.qtbot.waitUntil(lambda: panel.scene.states[path].pos() == first)
    author.click(path)
    author.trigger("graph.enter")
    assert studio.selection.behavior == BehaviorKey("agent", "wander")
    author.key(Qt.Key.Key_Backspace)
    assert studio.selection.behavior == BehaviorKey("agent", "forage")
