"""How transitions are drawn: wider the more examples speak for them, dashed where a rule says so, dotted where pruned."""

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.editor.graph.panel import GraphPanel
from app.editor.selection import BehaviorKey
from tests.gui.graph.author import Author

FORAGE, AUTHORED = BehaviorKey("agent", "forage"), BehaviorKey("authored-agent", "forage")


def width(panel: GraphPanel, source: str, target: str) -> float:
    return panel.scene.edges[(), source, target].pen().widthF()


def dashes(panel: GraphPanel, source: str, target: str) -> list[float]:
    pen = panel.scene.edges[(), source, target].pen()
    return [] if pen.style() is Qt.PenStyle.SolidLine else list(pen.dashPattern())


def test_what_more_examples_speak_for_is_wider(panel: GraphPanel) -> None:
    always, often = ("start", "wander"), ("wander", "wander")
    supports = [panel.scene.edges[(), *edge].edge.support for edge in (always, often)]
    assert supports == [1, 3]
    assert width(panel, *always) < width(panel, *often)
    assert dashes(panel, *often) == []


def test_rules_and_what_was_pruned_are_drawn_otherwise(panel: GraphPanel, author: Author) -> None:
    author.click_edge("wander", "return-with-box")
    author.key(Qt.Key.Key_Delete)
    pruned = dashes(panel, "wander", "return-with-box")
    assert pruned
    author.show(AUTHORED)
    ruled = next(item for item in panel.scene.edges.values() if item.edge.rules)
    assert ruled.pen().style() is not Qt.PenStyle.SolidLine
    assert list(ruled.pen().dashPattern()) != pruned


def test_the_words_of_a_loop_are_not_struck_through_by_other_edges(panel: GraphPanel, author: Author) -> None:
    author.show(BehaviorKey("agent", "wander"))
    edges = panel.scene.edges
    loop, other = edges[(), "forward", "forward"], edges[(), "rotate-right", "forward"]
    assert other.zValue() < loop.zValue() < panel.scene.states["forward",].zValue()
    author.click_edge("rotate-right", "forward")
    assert other.zValue() > loop.zValue()


@pytest.mark.parametrize("behavior", ["wander", "goto", "return-with-box", "gather-at"])
def test_edges_run_beside_the_words_of_loops(panel: GraphPanel, author: Author, behavior: str) -> None:
    author.show(BehaviorKey("agent", behavior))
    edges = panel.scene.edges
    loops = [key for key in edges if key[1] == key[2]]
    assert loops
    for loop in loops:
        words = edges[loop]._label_box().adjusted(2, 4, -2, -4)  # the letters
        for key, item in edges.items():
            through = sum(words.contains(item._path.pointAtPercent(share / 100)) for share in range(101))
            assert key == loop or through < 5, (loop, key)  # where there is no room, one may graze another


def test_edges_go_around_states_also_where_an_open_one_has_moved_them_aside(
    panel: GraphPanel, author: Author, qtbot: QtBot
) -> None:
    author.show(BehaviorKey("agent", "return-with-box"))
    closed = author.named("Goto(deposit)")
    author.click(closed, panel.scene.states[closed].expander().center())
    qtbot.waitUntil(lambda: len(panel.scene.levels) == 2)
    author.settle()
    outer = {key: item for key, item in panel.scene.edges.items() if key[0] == () and key[1] != key[2]}
    for (_, source, target), edge in outer.items():
        for path, state in panel.scene.states.items():
            if len(path) == 1 and path[0] not in (source, target):
                box = state.mapRectToScene(state.boundingRect().adjusted(6, 6, -6, -6))
                way = [edge.mapToScene(edge._path.pointAtPercent(share / 50)) for share in range(51)]
                assert not any(box.contains(point) for point in way), (source, target, path)
