"""What stands at an edge of the graph."""

import pytest

from app.editor.graph.labels import label_of
from app.export.graph import Edge, Way, WayKind

RULE = Way(WayKind.RULE, (), "sees a box", 1.0, order=2, id="2")
LEARNED = Way(WayKind.LEAF, (), "sees a box", 1.0, support=1.0, total=3.0)


@pytest.mark.parametrize(
    ("edge", "how"),
    [
        (Edge("a", "b", (RULE,)), "rule 2"),
        (Edge("a", "b", (RULE, LEARNED), support=1.0), "rule 2 · 1 example"),
        (Edge("a", "b", (RULE, LEARNED), support=7.0), "rule 2 · 7 examples"),
        (Edge("a", "b", (LEARNED, LEARNED), support=1.0), "1 example"),
        (Edge("a", "b", (LEARNED,), support=1.0), "1 of 3 · p 1.0"),
    ],
)
def test_an_edge_says_in_its_second_line_what_speaks_for_it(edge: Edge, how: str) -> None:
    assert label_of(edge).how == how
