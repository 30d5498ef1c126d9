import pytest

from app.core.errors import HierarchyError
from app.core.hierarchy import Hierarchy, Node, from_table, problems
from app.core.library import NodeType
from tests.fakes import agents, inner
from tests.samples import GROUP, SQUAD, TYPES

KNOWN = {node_type.name: node_type for node_type in TYPES}
#: A squad over a group and, directly, an agent; then an agent alone; then a group.
IRREGULAR = Hierarchy(
    (
        inner("s", SQUAD, inner("g", GROUP, *agents("a", "b")), *agents("c")),
        *agents("d"),
        inner("h", GROUP, *agents("e")),
    )
)


def test_a_table_of_level_sizes_makes_a_regular_forest() -> None:
    forest = from_table([2, 5, 5], ["squad", "group", "agent"])
    assert [root.id for root in forest.roots] == ["squad-1", "squad-2"]
    assert len(forest.agents()) == 50
    assert [len(node.children) for node in forest.controllers()] == [5] * 12
    assert forest.agents()[25].id == "agent-26"
    assert forest.parents()["agent-26"] == "group-6"
    assert problems(forest, KNOWN) == []


def test_a_table_of_one_level_makes_agents_on_their_own() -> None:
    forest = from_table([3], ["agent"])
    assert [(node.id, node.level) for node in forest.agents()] == [
        ("agent-1", 0),
        ("agent-2", 0),
        ("agent-3", 0),
    ]
    assert forest.controllers() == ()


def test_the_same_type_on_two_levels_still_gets_different_ids() -> None:
    ids = [node.id for node in from_table([2, 2, 1], ["group", "group", "agent"]).walk()]
    assert len(ids) == len(set(ids)) == 10


@pytest.mark.parametrize(
    ("sizes", "types", "message"),
    [
        ([], [], "0 level sizes and 0 types; allowed: one type a level"),
        ([2, 5], ["agent"], "2 level sizes and 1 types"),
        ([2, 0], ["group", "agent"], "a level size must be 1 or more, but one is 0"),
        ([-3], ["agent"], "but one is -3"),
    ],
)
def test_a_table_that_makes_no_forest_is_refused(sizes: list[int], types: list[str], message: str) -> None:
    with pytest.raises(HierarchyError, match=message):
        from_table(sizes, types)


def test_a_level_is_one_more_than_the_highest_childs() -> None:
    assert [(node.id, node.level) for node in IRREGULAR.walk()] == [
        ("s", 2), ("g", 1), ("a", 0), ("b", 0), ("c", 0), ("d", 0), ("h", 1), ("e", 0),
    ]  # fmt: skip


def test_agents_are_numbered_as_a_walk_meets_them_so_that_a_controllers_are_consecutive() -> None:
    assert [node.id for node in IRREGULAR.agents()] == ["a", "b", "c", "d", "e"]


def test_controllers_come_highest_level_first() -> None:
    assert [node.id for node in IRREGULAR.controllers()] == ["s", "g", "h"]
    later = Hierarchy((inner("h", GROUP, *agents("e")), *IRREGULAR.roots[:1]))
    assert [node.id for node in later.controllers()] == ["s", "h", "g"]


def test_parents_and_nodes_are_found_by_id() -> None:
    assert IRREGULAR.parents() == {"g": "s", "a": "g", "b": "g", "c": "s", "e": "h"}
    assert IRREGULAR.node("g").children == agents("a", "b")
    with pytest.raises(HierarchyError, match="there is no node 'z'"):
        IRREGULAR.node("z")


@pytest.mark.parametrize(
    ("forest", "node", "message"),
    [
        (Hierarchy(()), "", "the hierarchy is empty; it needs at least one agent"),
        (Hierarchy(agents("a", "a")), "a", "the node id 'a' stands twice"),
        (
            Hierarchy((Node("a", "robot"),)),
            "a",
            "its type 'robot' does not exist; there are: agent, group, squad",
        ),
        (
            Hierarchy((inner("a", "agent", *agents("b")),)),
            "a",
            "'agent' is a type of agents, but it has 1 subsid",
        ),
        (Hierarchy((Node("g", GROUP),)), "g", "'group' is a type of controllers, but it has no subsidiaries"),
        (IRREGULAR, "s", "'c' is of type 'agent'; allowed under 'squad': group"),
    ],
)
def test_problems_name_the_node_and_what_is_allowed(forest: Hierarchy, node: str, message: str) -> None:
    [(where, found)] = problems(forest, KNOWN)
    assert where == node
    assert found.startswith(message)


def test_a_forest_can_be_as_irregular_as_its_types_allow() -> None:
    mixed = {**KNOWN, SQUAD: NodeType(SQUAD, 2, (GROUP, "agent"))}
    assert problems(IRREGULAR, mixed) == []


def test_a_forest_of_any_depth_is_walked_parents_first() -> None:
    node = Node("0", "agent")
    for number in range(1, 3_000):
        node = Node(str(number), "group", (node,))
    assert [int(found.id) for found in Hierarchy((node,)).walk()] == list(reversed(range(3_000)))
