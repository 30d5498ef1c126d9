"""Edits of arms, forests, worlds, node types and demonstrations."""

from dataclasses import replace

import pytest

from app.core import edits
from app.core.check import check
from app.core.errors import EditError
from app.core.hierarchy import Hierarchy, Node
from app.core.library import NodeType
from app.core.project import Arm, LevelTable, Pick, Project
from tests.samples import AGENT, GROUP, SQUAD, project, vocabulary

ARM = "one level"


def shape(changed: Project, arm: str = ARM) -> str:
    """The forest as text: ``group-1(agent-1 agent-2)``."""

    def text(node: Node) -> str:
        below = " ".join(text(child) for child in node.children)
        return f"{node.id}({below})" if below else node.id

    return " ".join(text(root) for root in changed.arm(arm).forest().roots)


def small() -> Project:
    """The sample with two groups of two agents in its second arm."""
    return edits.set_hierarchy(project(), ARM, LevelTable((2, 2), (GROUP, AGENT)))


# ------------------------------------------------------------------------------------------------ arms


def test_arms_are_added_moved_and_deleted() -> None:
    changed = edits.add_arm(project(), Arm("big", LevelTable((100,), (AGENT,)), "wander"))
    changed = edits.move_arm(changed, "big", 0)
    assert [arm.name for arm in changed.arms] == ["big", "independent", ARM, "two levels"]
    assert edits.delete_arm(changed, "big") == project()


def test_a_renamed_arm_keeps_its_demonstrations() -> None:
    changed = edits.rename_arm(project(), "independent", "alone")
    assert changed.demonstrations[0].arm == "alone"
    assert not check(changed, vocabulary())
    assert edits.rename_arm(changed, "alone", "independent") == project()


def test_an_arm_is_replaced_under_another_name() -> None:
    arm = replace(project().arm("independent"), name="alone", top="wander")
    changed = edits.replace_arm(project(), "independent", arm)
    assert changed.arms[0] == arm
    assert changed.demonstrations[0].arm == "alone"


def test_an_arm_with_demonstrations_is_not_deleted() -> None:
    with pytest.raises(EditError, match="arm 'independent' is used by demonstration 'goto-1'"):
        edits.delete_arm(project(), "independent")


def test_names_of_arms_are_there_and_free() -> None:
    for name in ("", ARM):
        with pytest.raises(EditError):
            edits.rename_arm(project(), "independent", name)
    with pytest.raises(EditError, match="there is no arm 'none'; there are: 'independent'"):
        edits.delete_arm(project(), "none")


def test_worlds_are_set_renamed_and_deleted() -> None:
    changed = edits.set_world(project(), "easy", {"boxes": 99})
    changed = edits.rename_world(changed, "hard", "harder")
    assert changed.arm(ARM).world == "harder"
    assert set(changed.worlds) == {"", "easy", "harder"}
    assert set(edits.delete_world(changed, "easy").worlds) == {"", "harder"}
    for act in (
        lambda: edits.delete_world(changed, "harder"),
        lambda: edits.delete_world(changed, "hard"),
        lambda: edits.rename_world(changed, "", "x"),
        lambda: edits.rename_world(changed, "easy", "harder"),
    ):
        with pytest.raises(EditError):
            act()


# --------------------------------------------------------------------------------------------- forests


def test_a_table_is_written_out_with_the_same_nodes_at_the_first_edit_of_one() -> None:
    before = small().arm(ARM).forest()
    changed = edits.rename_node(small(), ARM, "group-1", "North")
    after = changed.arm(ARM).hierarchy
    assert isinstance(after, Hierarchy)
    assert [node.id for node in after.walk()] == [node.id for node in before.walk()]
    assert after.node("group-1").name == "North"


def test_a_node_is_moved_under_another_controller_to_a_place() -> None:
    changed = edits.move_nodes(small(), ARM, ["agent-1"], "group-2", 1)
    assert shape(changed) == "group-1(agent-2) group-2(agent-3 agent-1 agent-4)"
    changed = edits.move_nodes(changed, ARM, ["group-2"], "", 0)
    assert shape(changed) == "group-2(agent-3 agent-1 agent-4) group-1(agent-2)"


def test_several_nodes_are_moved_in_the_order_given() -> None:
    changed = edits.move_nodes(small(), ARM, ["agent-4", "agent-1"], "group-1", 0)
    assert shape(changed) == "group-1(agent-4 agent-1 agent-2) group-2(agent-3)"


def test_a_controller_that_loses_its_last_subsidiary_goes() -> None:
    assert (
        shape(edits.move_nodes(small(), ARM, ["agent-1", "agent-2"], "group-2"))
        == "group-2(agent-3 agent-4 agent-1 agent-2)"
    )
    changed = edits.remove_node(edits.remove_node(small(), ARM, "agent-1"), ARM, "agent-2")
    assert shape(changed) == "group-2(agent-3 agent-4)"


def test_a_controller_may_be_emptied_and_filled_in_one_move() -> None:
    assert (
        shape(edits.move_nodes(small(), ARM, ["agent-2", "agent-1"], "group-1"))
        == "group-1(agent-2 agent-1) group-2(agent-3 agent-4)"
    )


def test_a_node_cannot_come_under_itself_or_an_agent() -> None:
    with pytest.raises(EditError, match="which is itself or below it"):
        edits.move_nodes(small(), ARM, ["group-1"], "group-1")
    with pytest.raises(EditError, match="'agent-1' of arm 'one level' is an agent"):
        edits.move_nodes(small(), ARM, ["agent-2"], "agent-1")
    with pytest.raises(EditError, match="'agent-1' stands below 'group-1': name one of the two"):
        edits.move_nodes(small(), ARM, ["group-1", "agent-1"], "group-2")
    with pytest.raises(
        EditError, match="arm 'one level' has no node 'agent-9'; its roots are: group-1, group-2"
    ):
        edits.move_nodes(small(), ARM, ["agent-9"])


def test_a_new_node_is_called_after_its_type_and_a_controller_brings_its_agents() -> None:
    changed, agent = edits.add_node(small(), ARM, AGENT, "group-1")
    changed, group = edits.add_node(changed, ARM, GROUP)
    assert (agent, group) == ("agent-5", "group-3")
    assert shape(changed) == "group-1(agent-1 agent-2 agent-5) group-2(agent-3 agent-4) group-3(agent-6)"
    assert not check(changed, vocabulary())


def test_nodes_are_grouped_where_the_first_of_them_stood_and_dissolved_again() -> None:
    changed, squad = edits.group_nodes(small(), ARM, ["group-2", "group-1"], SQUAD, "All")
    assert shape(changed) == "squad-1(group-2(agent-3 agent-4) group-1(agent-1 agent-2))"
    assert changed.arm(ARM).forest().node(squad).name == "All"
    back = edits.dissolve_node(changed, ARM, squad)
    assert shape(back) == "group-2(agent-3 agent-4) group-1(agent-1 agent-2)"
    changed, _ = edits.group_nodes(edits.dissolve_node(small(), ARM, "group-1"), ARM, ["agent-2"], GROUP)
    assert shape(changed) == "agent-1 group-1(agent-2) group-2(agent-3 agent-4)"


def test_a_group_is_of_what_its_controller_may_control() -> None:
    with pytest.raises(EditError, match="'squad' cannot control 'agent-1' of type 'agent'; allowed: group"):
        edits.group_nodes(small(), ARM, ["agent-1"], SQUAD)
    with pytest.raises(EditError, match="at least one node"):
        edits.group_nodes(small(), ARM, [], GROUP)
    with pytest.raises(EditError, match="is an agent, so there is no group to dissolve"):
        edits.dissolve_node(small(), ARM, "agent-1")


def test_many_nodes_are_moved_at_once() -> None:
    large = edits.set_hierarchy(project(), ARM, LevelTable((2, 2000), (GROUP, AGENT)))
    nodes = [f"agent-{number}" for number in range(1, 2001)]
    changed = edits.move_nodes(large, ARM, nodes, "group-2")
    assert [len(root.children) for root in changed.arm(ARM).forest().roots] == [4000]


def test_a_broken_table_cannot_be_edited_node_by_node() -> None:
    broken = edits.set_hierarchy(project(), ARM, LevelTable((2,), (GROUP, AGENT)))
    with pytest.raises(EditError, match=r"cannot be edited node by node: .*1 level sizes"):
        edits.remove_node(broken, ARM, "agent-1")


# ----------------------------------------------------------------------------------------------- types


def test_levels_follow_from_who_stands_under_whom() -> None:
    changed = edits.add_type(project(), "robot")
    changed = edits.add_type(changed, "army", [SQUAD, "robot"])
    assert changed.types[-2:] == (NodeType("robot"), NodeType("army", 3, (SQUAD, "robot")))
    changed = edits.set_subsidiaries(changed, SQUAD, [AGENT])
    assert [(t.name, t.level) for t in changed.types] == [
        (AGENT, 0),
        (GROUP, 1),
        (SQUAD, 1),
        ("robot", 0),
        ("army", 2),
    ]


def test_a_type_cannot_stand_below_itself() -> None:
    with pytest.raises(EditError, match="but group controls squad controls group"):
        edits.set_subsidiaries(project(), GROUP, [SQUAD])
    with pytest.raises(EditError, match="but self controls self"):
        edits.add_type(project(), "self", ["self"])
    with pytest.raises(EditError, match="no node type 'robot'; there are: agent, group, squad"):
        edits.add_type(project(), "new", ["robot"])


def test_a_renamed_type_is_renamed_everywhere() -> None:
    written = edits.rename_node(project(), ARM, "group-1", "North")
    changed = edits.rename_type(edits.rename_type(written, AGENT, "robot"), GROUP, "team")
    assert set(changed.libraries) == {"robot", "team"}
    assert set(changed.examples) == {"robot"}
    assert {node.type for node in changed.arm(ARM).forest().walk()} == {"robot", "team"}
    assert changed.arm(ARM).forest().node("agent-1").type == "robot"
    assert changed.demonstrations[0].type == "robot"
    assert [p for p in check(changed, vocabulary()) if "goto-1" not in p.file] == []


def test_a_type_in_use_is_not_deleted() -> None:
    with pytest.raises(
        EditError, match="its behavior control, node type 'squad', arm 'one level', arm 'two levels'"
    ):
        edits.delete_type(project(), GROUP)
    assert edits.delete_type(edits.add_type(project(), "robot"), "robot") == project()


@pytest.mark.parametrize("name", ["", "a/b", "..", "con", "moments", AGENT, "Agent"])
def test_a_type_names_a_folder_of_its_own(name: str) -> None:
    with pytest.raises(EditError):
        edits.add_type(project(), name)


# --------------------------------------------------------------------------------------- demonstrations


def test_demonstrations_get_a_readable_id() -> None:
    again = project().demonstrations[0]
    changed, second = edits.add_demonstration(project(), again)
    changed, third = edits.add_demonstration(changed, replace(again, id=""))
    changed, named = edits.add_demonstration(changed, replace(again, id="By Hand"))
    assert (second, third, named) == ("goto-1-2", "goto", "By Hand")


def test_a_demonstration_names_a_file() -> None:
    with pytest.raises(
        EditError, match="'a/b' cannot name a demonstration, since it names a file: it holds '/'"
    ):
        edits.add_demonstration(project(), replace(project().demonstrations[0], id="a/b"))


def test_a_demonstration_plays_in_an_arm_and_teaches_an_automaton_that_exist() -> None:
    shown = project().demonstrations[0]
    for nowhere in (
        replace(shown, arm="gone"),
        replace(shown, automaton="gone"),
        replace(shown, type="gone"),
    ):
        with pytest.raises(EditError, match="gone"):
            edits.add_demonstration(project(), nowhere)
        with pytest.raises(EditError, match="gone"):
            edits.replace_demonstration(project(), shown.id, nowhere)


def test_demonstrations_are_replaced_moved_and_removed() -> None:
    changed, second = edits.add_demonstration(project(), project().demonstrations[0])
    changed = edits.move_demonstration(changed, second, 0)
    assert [d.id for d in changed.demonstrations] == [second, "goto-1"]
    longer = replace(changed.demonstrations[0], picks=(Pick(0, "agent-1", "left"),))
    changed = edits.replace_demonstration(changed, second, longer)
    assert changed.demonstrations[0] == longer
    assert edits.remove_demonstration(changed, second) == project()
    with pytest.raises(EditError, match="keeps its id"):
        edits.replace_demonstration(changed, second, replace(longer, id="x"))
    with pytest.raises(EditError, match="the project has no demonstration 'x'; there are: 'goto-1'"):
        edits.remove_demonstration(project(), "x")


def test_the_project_is_renamed_and_noted() -> None:
    assert edits.note_project(edits.rename_project(project(), "Mine"), "a note").name == "Mine"
    with pytest.raises(EditError, match="a project needs a name"):
        edits.rename_project(project(), " ")
