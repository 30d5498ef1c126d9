"""Features added after demonstrating: their values are those that would have been recorded."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from app.core.automaton import Basic
from app.core.edits import (
    add_feature,
    disable_examples,
    drop_feature,
    move_nodes,
    remove_state,
    rename_arm,
    rename_automaton,
    set_content,
    set_hierarchy,
)
from app.core.edits.place import with_examples
from app.core.features import FlagUp, Ground, Operation, Over, Sense, Source, Statistic, TicksInState
from app.core.library import Library
from app.core.project import LevelTable, Project
from app.core.storage import load, save
from app.core.vocabulary import DONE, FINISHED
from app.engine.backfill import fill_values
from app.sim.scenario import Scenario
from tests.corridor import corridor, features, project
from tests.driver import Driver
from tests.samples import AGENT, GROUP

OF_AGENTS: dict[str, Source] = {
    "place": Sense("Place"),
    "lamp": Sense("DistanceTo", {"target": Ground("lamp")}),
    "other": Sense("DistanceTo", {"target": Ground("the other")}),
    "coin": Sense("Coin"),
    "done": FlagUp(DONE),
    "ticks": TicksInState(),
}
OF_GROUPS: dict[str, Source] = {
    "mean": Statistic(Operation.MEAN, Sense("Place")),
    "first": Statistic(Operation.MAX, Sense("DistanceTo", {"target": Ground("first of mine")})),
    "done": Statistic(Operation.COUNT, FlagUp(DONE)),
    "finished": Statistic(Operation.ALL, FlagUp(FINISHED), Over.SUBSIDIARIES),
    "end": Sense("SomeoneAtEnd"),
    "ticks": TicksInState(),
}


def having(type_name: str, automaton: str, **sources: Source) -> Project:
    """The project with an automaton that looks at these features and no others."""
    made = project()
    automata = dict(made.library(type_name).automata)
    automata[automaton] = replace(automata[automaton], features=features(**sources))
    return replace(made, libraries={**made.libraries, type_name: Library(automata)})


def agents_hand(made: Project) -> Driver:
    """All sorts of examples: transitions, continuations, stays, flags, corrections, mended departures."""
    driver = Driver(made, seed=3).advance(4).teach(("agent-1", "agent-2"), "Shuttle")
    driver.pick("up", "agent-1").advance(3).pick("signal", "agent-1").advance(6).pick(
        "up", "agent-1"
    ).advance(2)
    driver.pick("up", "agent-2").pick("up", "agent-1").advance(5).pick("down", "agent-2").advance()
    driver.pick("over", "agent-1").advance().pick("jump", "agent-1").advance().pick(
        "down", "agent-1"
    ).advance(2)
    driver.test().advance(30).pick("signal", "agent-2").advance(7)
    driver.should_not_have_left("agent-1").advance(4)
    return driver.pick("ring", "agent-1")


def groups_hand(made: Project) -> Driver:
    driver = Driver(made, "groups", seed=3).advance(4).teach("group-2", "Lead")
    driver.pick("signal").advance(7).pick("up").advance(3).pick("Leave").advance(2).pick("signal").advance(2)
    return driver.pick("Jump").advance(2).pick("down").advance(4).test().advance(3).pick("up", "group-1")


def forgotten(made: Project, type_name: str, automaton: str) -> Project:
    """The project as if its features had been added after demonstrating."""
    bare = tuple(replace(e, values={}) for e in made.examples_of(type_name, automaton))
    return with_examples(made, type_name, automaton, bare)


CASES = pytest.mark.parametrize(
    ("hand", "type_name", "automaton", "sources"),
    [(agents_hand, AGENT, "Shuttle", OF_AGENTS), (groups_hand, GROUP, "Lead", OF_GROUPS)],
    ids=["agents", "groups"],
)
Hand = Callable[[Project], Driver]


@CASES
def test_features_added_later_have_the_values_that_would_have_been_recorded(
    hand: Hand, type_name: str, automaton: str, sources: dict[str, Source]
) -> None:
    made = hand(having(type_name, automaton, **sources)).project
    recorded = made.examples_of(type_name, automaton)
    assert {e.continuation for e in recorded} == {True, False}
    assert len(recorded) >= 10
    result = fill_values(forgotten(made, type_name, automaton), corridor, type_name, automaton)
    assert result.missed == {}
    assert result.project.examples_of(type_name, automaton) == recorded


@CASES
def test_moments_from_disk_tell_the_same(
    hand: Hand, type_name: str, automaton: str, sources: dict[str, Source], tmp_path: Path
) -> None:
    made = hand(having(type_name, automaton, **sources)).project
    save(forgotten(made, type_name, automaton), tmp_path / "project")
    result = fill_values(load(tmp_path / "project"), corridor, type_name, automaton)
    assert result.missed == {}
    assert result.project.examples_of(type_name, automaton) == made.examples_of(type_name, automaton)


def taught() -> Project:
    """An agent was shown to go up and down, looking at its place alone."""
    driver = Driver(having(AGENT, "Shuttle", place=Sense("Place"))).teach("agent-2", "Shuttle")
    return driver.pick("up").advance(4).pick("down").advance(2).pick("jump").project


def values(made: Project, feature_id: str) -> list[float | None]:
    return [example.values.get(feature_id) for example in made.examples_of(AGENT, "Shuttle")]


def test_a_feature_can_be_added_without_demonstrating_again() -> None:
    made, feature_id = add_feature(taught(), AGENT, "Shuttle", OF_AGENTS["lamp"])
    assert values(made, feature_id) == [None] * 5
    result = fill_values(made, corridor, AGENT, "Shuttle")
    assert values(result.project, feature_id) == [40.0, 40.0, 36.0, 36.0, 38.0]
    assert values(result.project, "place") == [10.0, 10.0, 14.0, 14.0, 12.0]


def test_a_feature_can_be_dropped_and_its_values_are_kept() -> None:
    made = drop_feature(taught(), AGENT, "Shuttle", "place")
    assert fill_values(made, corridor, AGENT, "Shuttle").project is made
    assert values(made, "place") == [10.0, 10.0, 14.0, 14.0, 12.0]


def test_disabled_examples_get_values_too() -> None:
    made, feature_id = add_feature(taught(), AGENT, "Shuttle", OF_AGENTS["lamp"])
    made = disable_examples(made, AGENT, "Shuttle", ["1"])
    result = fill_values(made, corridor, AGENT, "Shuttle").project
    assert values(result, feature_id)[0] == 40.0
    assert not result.examples_of(AGENT, "Shuttle")[0].enabled


def test_a_renamed_behavior_and_a_renamed_arm_do_not_matter() -> None:
    made, feature_id = add_feature(taught(), AGENT, "Shuttle", OF_AGENTS["lamp"])
    made = rename_arm(rename_automaton(made, AGENT, "Shuttle", "Bus"), "alone", "solo")
    assert None not in values(fill_values(made, corridor, AGENT, "Shuttle").project, feature_id)


def test_values_that_an_example_has_are_not_measured_again() -> None:
    made, _ = add_feature(taught(), AGENT, "Shuttle", OF_AGENTS["lamp"])
    moved = replace(made.examples_of(AGENT, "Shuttle")[0], values={"place": 99.0})
    made = with_examples(made, AGENT, "Shuttle", (moved, *made.examples_of(AGENT, "Shuttle")[1:]))
    assert values(fill_values(made, corridor, AGENT, "Shuttle").project, "place")[0] == 99.0


# ---------------------------------------------------------------------------------- what moments do not tell


def missed(made: Project) -> dict[str, str]:
    made, _ = add_feature(made, AGENT, "Shuttle", OF_AGENTS["lamp"])
    return dict(fill_values(made, corridor, AGENT, "Shuttle").missed)


def test_an_example_without_a_moment_is_missed() -> None:
    made = replace(taught(), moments={})
    assert missed(made)["1"] == "example 1: the moment it was recorded in is not stored"


def test_a_moment_of_an_arm_that_has_other_nodes_now_is_missed() -> None:
    made = set_hierarchy(taught(), "alone", LevelTable((3,), (AGENT,)))
    assert missed(made)["1"] == "the moment is of arm 'alone', whose nodes are others now"


def test_a_moment_of_an_arm_whose_nodes_stand_in_another_order_now_is_missed() -> None:
    made = move_nodes(taught(), "alone", ["agent-2"], to=0)
    assert set(missed(made)) == {"1", "2", "3", "4", "5"}


def test_a_moment_of_another_scenario_is_missed() -> None:
    made, _ = add_feature(taught(), AGENT, "Shuttle", OF_AGENTS["lamp"])
    other = Scenario("desert", "A desert", corridor.parameters, corridor.kinds)
    told = fill_values(made, other, AGENT, "Shuttle").missed
    assert told["1"] == "the moment is of scenario 'corridor', not 'desert'"


def test_a_continuation_whose_state_is_gone_is_missed() -> None:
    made = remove_state(taught(), AGENT, "Shuttle", "down")
    assert missed(made) == {"4": "example 4: its state 'down' is gone"}


def test_flags_and_ticks_in_a_state_that_holds_something_else_now_are_missed_but_the_world_is_told() -> None:
    made = set_content(taught(), AGENT, "Shuttle", "up", Basic("Down"))
    made, lamp = add_feature(made, AGENT, "Shuttle", OF_AGENTS["lamp"])
    made, ticks = add_feature(made, AGENT, "Shuttle", TicksInState())
    result = fill_values(made, corridor, AGENT, "Shuttle")
    assert values(result.project, lamp) == [40.0, 40.0, 36.0, 36.0, 38.0]
    assert values(result.project, ticks) == [0.0, 0.0, None, 0.0, 2.0]
    assert set(result.missed) == {"3"}
    assert "the state 'up' is gone or holds something else now" in result.missed["3"]


def test_an_open_binding_is_missed_and_other_features_are_told() -> None:
    made, _ = add_feature(taught(), AGENT, "Shuttle", Sense("DistanceTo"), "open")
    made, lamp = add_feature(made, AGENT, "Shuttle", OF_AGENTS["lamp"])
    result = fill_values(made, corridor, AGENT, "Shuttle")
    assert None not in values(result.project, lamp)
    assert "'target' of feature 'open' of 'Shuttle' is open" in result.missed["1"]


def test_an_example_of_a_node_that_did_not_run_the_behavior_is_missed() -> None:
    made = taught()
    first, *others = made.examples_of(AGENT, "Shuttle")
    made = with_examples(made, AGENT, "Shuttle", (replace(first, node="agent-1"), *others))
    assert missed(made) == {"1": "example 1: 'agent-1' does not run 'Shuttle' in its moment"}


def test_a_parameter_means_in_the_moment_what_it_meant_then() -> None:
    driver = Driver().teach("agent-2", "Seek", target="the other").pick("Up").advance(3).pick("Down")
    made = forgotten(driver.project, AGENT, "Seek")
    result = fill_values(made, corridor, AGENT, "Seek").project
    assert [e.values["distance"] for e in result.examples_of(AGENT, "Seek")] == [10.0, 10.0, 13.0, 13.0]
