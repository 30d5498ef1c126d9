"""What is wrong with types and arms; names of files, and how much work a check is."""

from dataclasses import replace

import pytest

from app.core.check import PROJECT_FILE, Problem, automaton_file, check, demonstration_file, examples_file
from app.core.features import Ground
from app.core.hierarchy import Hierarchy, Node
from app.core.library import Library, NodeType
from app.core.project import Arm, LevelTable
from app.core.storage import layout, migrations
from tests.samples import AGENT, GROUP, SQUAD, nested, project, state, vocabulary
from tests.unit.core.problems import AGENTS, armed, errors, only, typed
from tests.work import calls


def test_a_project_has_types_with_different_names() -> None:
    assert "there are no node types" in only(typed()).message
    assert only(typed(NodeType(AGENT), NodeType(AGENT))).where == "types[1].name"


def test_subsidiaries_exist_and_are_below() -> None:
    problem = only(typed(NodeType(AGENT), NodeType(GROUP, 1, (AGENT, "robot"))))
    assert (problem.file, problem.where) == ("project.json", "types[1].subsidiaries[1]")
    assert (
        "there is no node type 'robot' to stand under 'group'; there are: 'agent', 'group'" in problem.message
    )


def test_a_cycle_of_types_is_spelled_out_and_nothing_else_breaks_on_it() -> None:
    looped = replace(
        project(), types=(NodeType(AGENT), NodeType(GROUP, 1, (AGENT, SQUAD)), NodeType(SQUAD, 2, (GROUP,)))
    )
    found = [problem.message for problem in errors(looped) if problem.where.startswith("types")]
    assert found == [
        "a type cannot stand below itself, but group controls squad controls group",
        "a type cannot stand below itself, but squad controls group controls squad",
    ]


@pytest.mark.parametrize(
    ("node_type", "message"),
    [
        (
            NodeType(GROUP, 2, (AGENT,)),
            "'group' has level 2, but the highest below it, 'agent', has level 0, so it must be 1",
        ),
        (NodeType(GROUP, 1), "'group' has level 1, but it has no subsidiaries, so it must be 0"),
        (NodeType(GROUP, 0, (AGENT,)), "'group' has level 0, but the highest below it"),
    ],
)
def test_a_level_is_one_more_than_the_highest_below(node_type: NodeType, message: str) -> None:
    problem = only(typed(NodeType(AGENT), node_type))
    assert message in problem.message
    assert problem.mend is not None
    assert check(problem.mend(typed(NodeType(AGENT), node_type)), vocabulary()) == ()


def test_libraries_and_examples_belong_to_types() -> None:
    stray = replace(project(), libraries={**project().libraries, "robot": Library()}, examples={"robots": {}})
    assert {(p.file, p.message.split(";")[0]) for p in errors(stray)} == {
        ("libraries/robot", "there is no node type 'robot'"),
        ("examples/robots", "there is no node type 'robots'"),
    }


def test_an_arm_starts_with_a_behavior_of_its_roots() -> None:
    problem = only(armed(Arm("a", AGENTS, "foraging")))
    assert (problem.file, problem.where) == ("project.json", "arms[3].top")
    assert (
        "arm 'a' starts with 'foraging', which 'agent' cannot do; did you mean 'forage'?" in problem.message
    )


def test_an_arm_cannot_start_with_an_open_behavior() -> None:
    problem = only(armed(Arm("a", AGENTS, "goto")))
    assert "'target' of goto is open in arm 'a': nobody above 'agent' binds it" in problem.message
    assert "'forage'" in problem.message.split("there are")[1]
    assert "'goto'" not in problem.message.split("there are")[1]


def test_an_arm_can_start_with_what_a_controller_only_directs() -> None:
    assert errors(armed(Arm("a", LevelTable((1, 2), (GROUP, AGENT)), "forage"))) == []


def test_the_world_of_an_arm_exists_and_names_of_arms_differ() -> None:
    problem = only(armed(Arm("a", AGENTS, "forage", world="hart")))
    assert problem.where == "arms[3].world"
    assert "names the world 'hart'; did you mean 'hard'?" in problem.message
    assert only(armed(Arm("independent", AGENTS, "forage"))).where == "arms[3].name"
    assert "the arm has no name" in only(armed(Arm("", AGENTS, "forage"))).message


@pytest.mark.parametrize(
    ("hierarchy", "message"),
    [
        (LevelTable((3, 2), (AGENT,)), "level sizes"),
        (LevelTable((0,), (AGENT,)), "level size"),
        (LevelTable((), ()), "level"),
        (LevelTable((2,), ("robot",)), "its type 'robot' does not exist"),
        (LevelTable((2,), (GROUP,)), "is a type of controllers, but it has no subsidiaries"),
        (LevelTable((1, 2), (SQUAD, AGENT)), "'agent-1' is of type 'agent'; allowed under 'squad': group"),
        (Hierarchy(()), "the hierarchy is empty"),
        (Hierarchy((Node("a", AGENT), Node("a", AGENT))), "the node id 'a' stands twice"),
    ],
)
def test_a_forest_follows_the_types(hierarchy: Hierarchy | LevelTable, message: str) -> None:
    found = [
        p for p in errors(armed(Arm("a", hierarchy, "forage"))) if p.where.startswith("arms[3].hierarchy")
    ]
    assert len(found) == 1
    assert message in found[0].message
    assert "arm 'a'" in found[0].message


def test_a_node_that_is_written_out_is_named() -> None:
    problem = errors(armed(Arm("a", Hierarchy((Node("x", "robot"), Node("y", AGENT))), "forage")))[0]
    assert problem.where == "arms[3].hierarchy, node 'x'"


def test_files_are_named_as_storage_names_them() -> None:
    for path, stored in (
        (PROJECT_FILE, migrations.PROJECT_FILE),
        (automaton_file("a", "b"), layout.automaton_file("a", "b")),
        (examples_file("a", "b"), layout.examples_file("a", "b")),
        (demonstration_file("a"), layout.demonstration_file("a")),
    ):
        assert path == stored


#: Of functions in Python, for a project as large as any that is in use.
MOST_CALLS = 200_000


def test_a_large_project_is_checked_at_once() -> None:
    """200 behaviors and 10,000 agents: so few calls take some 20 ms, and ten times as long on a slow machine."""
    automata = dict(project().library(AGENT).automata)
    for number in range(200):
        held = (
            nested("next", f"b{number - 1}")
            if number
            else state("next", "Face", {"target": Ground("deposit")})
        )
        automata[f"b{number}"] = replace(
            automata["wander"], id=f"b{number}", name=f"b{number}", states=(*automata["wander"].states, held)
        )
    large = replace(
        armed(Arm("many", LevelTable((10_000,), (AGENT,)), "forage")),
        libraries={AGENT: Library(automata), GROUP: project().library(GROUP)},
    )
    found: list[Problem] = []
    assert calls(lambda: found.extend(check(large, vocabulary()))) < MOST_CALLS
    assert len(found) == 200  # each has a state that is never entered
