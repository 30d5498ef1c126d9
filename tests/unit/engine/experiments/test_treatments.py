"""What each setting changes, and learning anew from a part of the picks."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import pytest

from app.core.automaton import Rule
from app.core.project import Arm, LevelTable, Project
from app.core.tree import Tree
from app.engine.demonstrations import recreate
from app.engine.experiments.flat import NAME, Pulse, examples_of, flat_of, with_flat
from app.engine.experiments.learning import Lesson, behaviors_in_use, drawn, picks_of, relearned
from app.engine.experiments.plan import Settings, Treated
from app.engine.experiments.treatments import Treatments, changed
from app.sim.scenarios.foraging import scenario
from tests.samples import AGENT
from tests.unit.cli.foraging import taught
from tests.unit.engine.experiments.small import boxes, experiment


def arm_with(**settings: Any) -> Arm:
    return changed(boxes(), "one level", settings)[1]


def rules(project: Project, name: str = "Wander") -> Sequence[Rule]:
    found = project.library(AGENT).by_name(name)
    assert found is not None
    return found.rules


def test_sizes_and_top_change_the_arm() -> None:
    assert arm_with(sizes=(3, 4)).hierarchy == LevelTable((3, 4), ("group", "agent"))
    assert arm_with(top="Forage").top == "Forage"
    assert arm_with(world="two sizes").world == "two sizes"


def test_a_rule_gets_another_probability_and_all_else_stays() -> None:
    before, (after, _) = boxes(), changed(boxes(), "independent", {"rule.agent/Wander/2": 0.5})
    assert rules(after)[1] == replace(rules(before)[1], probability=0.5)
    assert (rules(after)[0], *rules(after)[2:]) == (rules(before)[0], *rules(before)[2:])
    assert after.library("group") == before.library("group")


def test_a_behavior_can_be_another_inside_under_its_own_name() -> None:
    project, _ = changed(boxes(), "independent", {"use.agent/Wander": "agent/Forage"})
    assert rules(project) == rules(boxes(), "Forage")


def test_rules_are_changed_before_behaviors_that_use_them() -> None:
    settings: Settings = {"use.agent/Forage": "agent/Wander", "rule.agent/Wander/2": 0.25}
    project, _ = changed(boxes(), "independent", settings)
    assert rules(project, "Forage")[1].probability == 0.25


def test_runs_of_a_cell_share_a_treatment_unless_they_learn() -> None:
    plan = experiment()
    treatments = Treatments(boxes(), scenario, plan)
    cell = plan.cells()[0]
    assert treatments.of(cell, 0) is treatments.of(cell, 1)
    assert treatments.of(cell, 0).treatment.parameters["pullers"] == 1


# --------------------------------------------------------------------------------------------- learning anew


@pytest.fixture(scope="module")
def homing() -> Project:
    """A project with examples, learned from a demonstration of four picks."""
    return recreate(taught(), scenario)


def test_only_behaviors_that_the_arm_can_run_are_learned_anew(homing: Project) -> None:
    keys = behaviors_in_use(homing, scenario.vocabulary, homing.arms[0])
    assert keys == ((AGENT, "Goto"), (AGENT, "Home"))
    assert len(picks_of(homing, keys)) == 4


def test_draws_depend_on_the_run_and_smaller_ones_are_part_of_larger_ones() -> None:
    picks = [(AGENT, "Goto", number) for number in range(30)]
    assert drawn(picks, 5, 1, 0) == drawn(picks, 5, 1, 0)
    assert drawn(picks, 5, 1, 0) < drawn(picks, 9, 1, 0)
    assert len({drawn(picks, 5, 1, run) for run in range(20)}) > 15
    assert drawn(picks, None, 1, 0) == set(picks) == drawn(picks, 99, 1, 0)


def models(project: Project) -> Any:
    return project.library(AGENT).automata["Goto"].learned


def test_all_picks_give_what_was_learned_before(homing: Project) -> None:
    again = relearned(homing, scenario.vocabulary, homing.arms[0], Lesson(), 1, 0)
    assert models(again.project) == models(homing)
    assert (again.picks, again.examples) == (4, len(homing.examples_of(AGENT, "Goto")))


def test_fewer_picks_give_fewer_examples(homing: Project) -> None:
    again = relearned(homing, scenario.vocabulary, homing.arms[0], Lesson(picks=2), 1, 0)
    assert again.picks == 2
    assert 2 <= again.examples <= 4
    assert len(again.project.examples_of(AGENT, "Goto")) == again.examples


def test_another_classifier_learns_instead(homing: Project) -> None:
    lesson = Lesson("forest", (("trees", 3.0),))
    again = relearned(homing, scenario.vocabulary, homing.arms[0], lesson, 1, 0)
    assert any(
        len(model.trees) == 3 for model in models(again.project).values() if not isinstance(model, Tree)
    )


def test_what_was_learned_from_is_counted_for_each_run(homing: Project) -> None:
    arms = (Treated("a", "independent", {"engine": "reference", "learner.picks": 3}),)
    plan = experiment(arms=arms)
    counts = Treatments(homing, scenario, plan).of(plan.cells()[0], 1).counts
    assert counts["picks"] == 3.0
    assert counts["examples"] >= 3.0


# -------------------------------------------------------------------------------------- one flat automaton


def test_every_change_of_basic_behavior_is_a_pick() -> None:
    behaviors = scenario.vocabulary.behaviors
    basics = {name: behaviors[name] for name in ("Forward", "GrabBox", "ReleaseBoxAndFinish")}
    seen = {"sees": 1.0}
    done = ["Forward", "Forward", "Done", "GrabBox", "ReleaseBoxAndFinish", "Forward"]
    pulses = [Pulse("d", "agent-1", tick, name, seen) for tick, name in enumerate(done)]
    found = [
        (e.source, e.label, e.values["ticks"], e.continuation, e.pick) for e in examples_of(pulses, basics)
    ]
    assert found == [
        ("start", "forward", 0.0, False, 1),
        ("forward", "forward", 0.0, True, 1),
        ("forward", "grab-box", 3.0, False, 2),
        ("grab-box", "release-box-and-finish", 1.0, False, 3),
        ("start", "forward", 0.0, False, 4),
        ("forward", "forward", 0.0, True, 4),
    ]


def test_the_flat_automaton_is_taught_by_the_same_demonstrations() -> None:
    project = taught()
    flat = flat_of(project, scenario, project.arms[0])
    assert [state.id for state in flat.automaton.states] == ["start", "forward", "rotate-left"]
    assert [use.id for use in flat.automaton.features] == [
        "direction-to-deposit",
        "distance-to-deposit",
        "ticks",
    ]
    assert [example.tick for example in flat.examples if not example.continuation] == [0, 40, 90, 120]
    assert all(example.values["distance-to-deposit"] > 0 for example in flat.examples)


def test_the_flat_automaton_sees_what_the_behaviors_of_the_hierarchy_saw(homing: Project) -> None:
    flat = flat_of(taught(), scenario, homing.arms[0])
    theirs = {(e.tick, e.continuation): e.values for e in homing.examples_of(AGENT, "Goto")}
    for example in flat.examples:
        values = theirs[example.tick, example.continuation]
        assert example.values["distance-to-deposit"] == values["distance"]
        assert example.values["direction-to-deposit"] == values["direction"]


def test_the_flat_automaton_runs_in_the_place_of_the_hierarchy() -> None:
    project, arm = with_flat(taught(), taught().arms[0], flat_of(taught(), scenario, taught().arms[0]))
    assert arm.top == NAME
    learned = relearned(project, scenario.vocabulary, arm, Lesson(), 1, 0)
    assert learned.picks == 4
    assert learned.project.library(AGENT).automata["flat"].learned
