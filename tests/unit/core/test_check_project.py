"""What is wrong with types, arms, demonstrations and examples; and refusing to run."""

import re
from dataclasses import replace

import pytest

from app.core import edits
from app.core.automaton import START
from app.core.check import (
    PROJECT_FILE,
    Problem,
    automaton_file,
    check,
    demonstration_file,
    examples_file,
    refuse,
)
from app.core.errors import (
    BindingError,
    EditError,
    ExampleError,
    HierarchyError,
    LibraryError,
    UnderstudyError,
)
from app.core.examples import Example
from app.core.features import Ground, TicksInState
from app.core.hierarchy import Hierarchy, Node
from app.core.library import Library, NodeType
from app.core.project import Arm, Demonstration, LevelTable, Pick, Project
from app.core.storage import layout, migrations
from tests.samples import AGENT, GROUP, SQUAD, automaton, nested, project, state, vocabulary
from tests.work import calls


def errors(changed: Project) -> list[Problem]:
    return [problem for problem in check(changed, vocabulary()) if problem.severity == "error"]


def only(changed: Project, severity: str = "error") -> Problem:
    found = [problem for problem in check(changed, vocabulary()) if problem.severity == severity]
    assert len(found) == 1, [str(problem) for problem in found]
    return found[0]


# --------------------------------------------------------------------------------------------- types


def typed(*types: NodeType) -> Project:
    return replace(project(), types=types, arms=(), demonstrations=(), libraries={}, examples={})


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


# ---------------------------------------------------------------------------------------------- arms


def armed(arm: Arm) -> Project:
    return replace(project(), arms=(*project().arms, arm))


AGENTS = LevelTable((3,), (AGENT,))


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


# ------------------------------------------------------------------------------------ demonstrations


def shown(**fields: object) -> Project:
    demonstration = replace(project().demonstrations[0], **fields)  # type: ignore[arg-type]
    return replace(project(), demonstrations=(demonstration,))


@pytest.mark.parametrize(
    ("fields", "where", "message"),
    [
        ({"type": "robot"}, "type", "there is no node type 'robot'"),
        (
            {"automaton": "gogo"},
            "automaton",
            "'agent' has no behavior with the id 'gogo'; did you mean 'goto'?",
        ),
        (
            {"arm": "alone"},
            "arm",
            "there is no arm 'alone'; there are: 'independent', 'one level', 'two levels'",
        ),
        ({"others": "sleep"}, "others", "the others can 'idle' or 'run', but not 'sleep'"),
        ({"arguments": {}}, "arguments", "'target' of goto is open while it is taught"),
        (
            {"arguments": {"target": "deposit", "x": "deposit"}},
            "arguments.x",
            "goto has no parameter 'x'; it has: 'target'",
        ),
        (
            {"arguments": {"target": "closest-attached-agent"}},
            "arguments.target",
            "'agent' cannot bind the target",
        ),
        (
            {"picks": (Pick(0, "agent-9", "left"),)},
            "picks[0].node",
            "has no node 'agent-9'; nodes of type 'agent' are: 'agent-1'",
        ),
        ({"picks": (Pick(0, "", "left"),)}, "picks[0].node", "has no node ''"),
        (
            {"picks": (Pick(0, "agent-1", "gone"),)},
            "picks[0].state",
            "goto has no state 'gone'; did you mean 'done'?",
        ),
        (
            {"picks": (Pick(0, "agent-1", "", "jump"),)},
            "picks[0].act",
            "'jump' is nothing that a hand can do",
        ),
        (
            {"picks": (Pick(0, "", act="move", entity=3),)},
            "picks[0].act",
            "a move needs the entity that is moved, and x and y",
        ),
        (
            {"picks": (Pick(9, "agent-1", "left"), Pick(8, "agent-1", "left"))},
            "picks[1].tick",
            "but 8 comes after 9",
        ),
        (
            {"picks": (Pick(301, "agent-1", "left"),)},
            "picks[0].tick",
            "goes on for 300 ticks, but a pick is at tick 301",
        ),
        ({"picks": (Pick(-1, "agent-1", "left"),)}, "picks[0].tick", "a pick is at tick -1"),
        (
            {"picks": (Pick(0, "group-1", "left"),), "arm": "one level"},
            "picks[0].node",
            "'group-1' is of type 'group', but 'agent' is taught",
        ),
    ],
)
def test_a_demonstration_can_be_played(fields: dict[str, object], where: str, message: str) -> None:
    found = [p for p in errors(shown(**fields)) if p.where == where]
    assert [p.file for p in found] == ["demonstrations/goto-1.json"] * len(found)
    assert message in found[0].message


def test_acts_without_a_node_or_state_are_fine() -> None:
    acts = (
        Pick(0, "agent-1", "left"),
        Pick(0, "", "", "undo"),
        Pick(5, "", "", "test"),
        Pick(9, "agent-1", "", "should not have left"),
    )
    assert errors(shown(picks=acts)) == []


def test_demonstrations_have_different_ids_and_broken_arms_do_not_stop_the_check() -> None:
    twice = replace(project(), demonstrations=project().demonstrations * 2)
    assert only(twice).message == "the demonstration 'goto-1' stands twice"
    broken = edits.set_hierarchy(project(), "independent", LevelTable((), ()))
    assert any(p.where == "arms[0].hierarchy" for p in errors(broken))


# ------------------------------------------------------------------------------------------ examples


def with_example(**fields: object) -> Project:
    first, *others = project().examples_of(AGENT, "goto")
    return replace(project(), examples={AGENT: {"goto": (replace(first, **fields), *others)}})  # type: ignore[arg-type]


@pytest.mark.parametrize("value", [float("nan"), float("inf"), float("-inf")])
def test_values_of_examples_are_finite(value: float) -> None:
    broken = with_example(values={"distance": value, "direction": 0.0})
    problem = only(broken)
    assert (problem.file, problem.where) == ("examples/agent/goto.json", "examples[0].values.distance")
    assert (
        f"example '1' of goto: feature 'distance' is {value}; it must be a finite number" in problem.message
    )
    assert problem.fix == "disable the example"
    assert problem.mend is not None
    assert check(problem.mend(broken), vocabulary()) == ()


@pytest.mark.parametrize("weight", [0.0, -1.0, float("nan")])
def test_weights_of_examples_are_above_0(weight: float) -> None:
    assert only(with_example(weight=weight)).where == "examples[0].weight"


def test_an_example_of_a_state_that_is_gone_is_pointed_out_unless_it_is_disabled() -> None:
    problem = only(with_example(label="gone"), "warning")
    assert "state 'gone' does not exist, so nothing is learned from this" in problem.message
    assert check(with_example(label="gone", enabled=False), vocabulary()) == ()


def test_nothing_is_learned_to_start_or_from_a_state_that_raises_a_flag() -> None:
    assert only(with_example(label=START)).where == "examples[0].label"
    assert only(with_example(source="done")).where == "examples[0].source"


def test_examples_without_a_value_are_counted_with_those_whose_moment_is_stored() -> None:
    changed, _ = edits.add_feature(project(), AGENT, "goto", TicksInState(), "ticks")
    first, *others = changed.examples_of(AGENT, "goto")
    changed = replace(changed, examples={AGENT: {"goto": (replace(first, snapshot=""), *others)}})
    problem = only(changed, "warning")
    assert problem.where == "examples"
    assert problem.message == (
        "5 of 5 examples of goto have no value of feature 'ticks', so nothing is learned from them; it can be measured "
        "in the stored moments of 4 of them"
    )


def test_what_was_taught_to_choose_but_looks_at_nothing_is_told() -> None:
    blind = replace(automaton("blind", state("go", "Forward"), state("turn", "Turn")), features=())

    def warned(*pairs: tuple[str, str]) -> list[str]:
        examples = tuple(Example(str(n), source, label, {}) for n, (source, label) in enumerate(pairs))
        libraries = {AGENT: Library({"blind": blind})}
        changed = typed(NodeType(AGENT))
        changed = replace(changed, libraries=libraries, examples={AGENT: {"blind": examples}})
        return [p.message for p in check(changed, vocabulary()) if "looks at nothing" in p.message]

    assert not warned((START, "go"), ("go", "go"))
    (message,) = warned((START, "go"), ("go", "go"), ("go", "turn"))
    assert message.startswith("blind looks at nothing, so chance decides in go: go or turn;")


def test_examples_belong_to_a_behavior() -> None:
    stray = replace(project(), examples={AGENT: {"gogo": (Example("1", START, "x", {}),)}})
    problem = only(stray)
    assert (problem.file, problem.where) == ("examples/agent/gogo.json", "automaton")
    assert "'agent' has no behavior with the id 'gogo'; did you mean 'goto'?" in problem.message


# -------------------------------------------------------------------------------------------- refuse


def broken() -> Project:
    """The sample with an open binding in a behavior that only the first arm runs, and a second arm without its top."""
    opened = edits.bind_state(project(), AGENT, "forage", "approach", "target", None)
    return edits.add_arm(opened, Arm("nothing", AGENTS, "gone"))


def test_a_sound_project_is_not_refused() -> None:
    refuse(project(), vocabulary())
    warned = edits.add_automaton(project(), AGENT, "new")[0]
    assert check(warned, vocabulary())
    refuse(warned, vocabulary())


def test_one_error_is_raised_as_what_it_is() -> None:
    opened = edits.bind_state(project(), AGENT, "forage", "approach", "target", None)
    with pytest.raises(
        BindingError, match=r"libraries/agent/forage\.json: states\[2\].*'target' of goto is open"
    ):
        refuse(opened, vocabulary())
    with pytest.raises(LibraryError):
        refuse(armed(Arm("a", AGENTS, "gone")), vocabulary())
    with pytest.raises(HierarchyError):
        refuse(armed(Arm("a", LevelTable((0,), (AGENT,)), "forage")), vocabulary())
    with pytest.raises(ExampleError):
        refuse(with_example(weight=-1.0), vocabulary())


def test_several_errors_are_listed_together() -> None:
    with pytest.raises(UnderstudyError, match=re.compile("2 problems .*arms.3..top.*forage.json", re.DOTALL)):
        refuse(broken(), vocabulary())


def test_an_arm_is_refused_only_for_what_concerns_it() -> None:
    with pytest.raises(BindingError):
        refuse(broken(), vocabulary(), arm="independent")
    with pytest.raises(LibraryError, match="'gone'"):
        refuse(broken(), vocabulary(), arm="nothing")
    with pytest.raises(BindingError):  # its agents forage too, since their controllers direct them to
        refuse(broken(), vocabulary(), arm="two levels")
    wandering = edits.add_arm(broken(), Arm("w", AGENTS, "wander"))
    refuse(wandering, vocabulary(), arm="w")
    with pytest.raises(BindingError):
        refuse(wandering, vocabulary(), arm="w", taught=[(AGENT, "forage")])
    with pytest.raises(EditError, match="there is no arm 'x'"):
        refuse(project(), vocabulary(), arm="x")


def test_examples_and_demonstrations_do_not_keep_an_arm_from_running() -> None:
    changed = replace(
        with_example(weight=-1.0), demonstrations=(Demonstration("d", "x", "x", "x", 1, (), 1),)
    )
    refuse(changed, vocabulary(), arm="independent")
    with pytest.raises(UnderstudyError):
        refuse(changed, vocabulary())


def test_a_cycle_that_an_arm_would_run_into_refuses_it() -> None:
    looped = edits.add_automaton(project(), AGENT, "loop")[0]
    library = {**looped.library(AGENT).automata, "loop": automaton("loop", nested("again", "loop"))}
    looped = replace(looped, libraries={**looped.libraries, AGENT: Library(library)})
    refuse(looped, vocabulary(), arm="independent")
    looped = edits.add_arm(looped, Arm("l", AGENTS, "loop"))
    with pytest.raises(LibraryError, match="recursion is not permitted, but loop holds loop"):
        refuse(looped, vocabulary(), arm="l")


def test_many_errors_are_counted() -> None:
    arms = tuple(Arm(f"a{n}", AGENTS, "gone") for n in range(30))
    with pytest.raises(LibraryError, match="and 10 more; `understudy check` lists all"):
        refuse(replace(project(), arms=arms, demonstrations=()), vocabulary())


def test_files_are_named_as_storage_names_them() -> None:
    for path, stored in (
        (PROJECT_FILE, migrations.PROJECT_FILE),
        (automaton_file("a", "b"), layout.automaton_file("a", "b")),
        (examples_file("a", "b"), layout.examples_file("a", "b")),
        (demonstration_file("a"), layout.demonstration_file("a")),
    ):
        assert path == stored


# --------------------------------------------------------------------------------------------- speed

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
