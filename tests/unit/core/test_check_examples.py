"""What is wrong with demonstrations and examples."""

from dataclasses import replace
from typing import Any

import pytest

from app.core import edits
from app.core.automaton import START
from app.core.check import check
from app.core.examples import Example
from app.core.features import TicksInState
from app.core.library import Library, NodeType
from app.core.project import LevelTable, Pick, Project
from tests.samples import AGENT, automaton, project, state, vocabulary
from tests.unit.core.problems import errors, only, typed, with_example

# ------------------------------------------------------------------------------------ demonstrations


def shown(**fields: Any) -> Project:
    demonstration = replace(project().demonstrations[0], **fields)
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
    assert message.startswith("blind looks at nothing (its settings say, under Features, what"), (
        "it may be cut off"
    )
    assert message.endswith("so chance decides in go: go or turn")


def test_examples_belong_to_a_behavior() -> None:
    stray = replace(project(), examples={AGENT: {"gogo": (Example("1", START, "x", {}),)}})
    problem = only(stray)
    assert (problem.file, problem.where) == ("examples/agent/gogo.json", "automaton")
    assert "'agent' has no behavior with the id 'gogo'; did you mean 'goto'?" in problem.message
