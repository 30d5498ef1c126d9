"""Edits of examples: what a pick records, its reverse, and corrections by hand."""

from collections.abc import Iterator, Mapping
from dataclasses import replace

import pytest

from app.core import edits
from app.core.automaton import START, Basic, Nested, RaiseFlag, Start, State
from app.core.edits import Recorded
from app.core.errors import EditError
from app.core.examples import Example, Moment
from app.core.features import Ground
from app.core.project import Project
from tests.samples import AGENT, GROUP, moment, project, vocabulary

VALUES = {"distance": 5.0, "direction": 0.5}
RIGHT = State("rotate-right", Basic("RotateRight"))


def pick(label: str, *, state: State | None = None, snapshot: str = "m2") -> Recorded:
    went = Example("", "forward", label, VALUES, snapshot=snapshot, pick=4)
    stays = replace(went, source=label, continuation=True)
    return Recorded(AGENT, "goto", (went, stays), {snapshot: moment()}, state)


def ids(changed: Project) -> list[str]:
    return [example.id for example in changed.examples_of(AGENT, "goto")]


def test_a_pick_adds_its_examples_with_numbers_counting_up_and_its_moment() -> None:
    changed = edits.record_pick(project(), pick("left"))
    assert ids(changed) == ["1", "2", "3", "4", "5", "6", "7"]
    assert set(changed.moments) == {"m1", "m2"}
    assert edits.next_pick(project(), AGENT, "goto") == 4
    assert edits.next_pick(changed, AGENT, "goto") == 5
    assert edits.next_pick(project(), AGENT, "wander") == 1


def test_an_id_that_is_free_is_kept_and_one_that_is_taken_is_not() -> None:
    examples = (Example("9", START, "left", VALUES, pick=4), Example("2", START, "left", VALUES, pick=4))
    changed = edits.record_pick(project(), Recorded(AGENT, "goto", examples))
    assert ids(changed)[-2:] == ["9", "10"]


def test_a_pick_of_what_the_automaton_lacks_adds_the_state() -> None:
    changed = edits.record_pick(project(), pick("rotate-right", state=RIGHT))
    assert changed.library(AGENT).get("goto").states[-1] == RIGHT


def test_taking_back_a_pick_is_the_reverse() -> None:
    recorded = pick("rotate-right", state=RIGHT)
    assert edits.take_back_pick(edits.record_pick(project(), recorded), recorded) == project()
    nothing = Recorded(AGENT, "goto")
    assert edits.record_pick(project(), nothing) == project()
    assert edits.take_back_pick(project(), nothing) == project()


def test_the_first_pick_of_an_automaton_can_be_taken_back() -> None:
    example = Example("", START, "forward", {}, pick=1)
    recorded = Recorded(AGENT, "wander", (example,))
    assert edits.take_back_pick(edits.record_pick(project(), recorded), recorded) == project()


def test_a_state_that_something_else_uses_stays_when_its_pick_is_taken_back() -> None:
    recorded = pick("rotate-right", state=RIGHT)
    used = edits.record_pick(project(), recorded)
    by_rule, _ = edits.add_rule(used, AGENT, "goto", "left", "rotate-right")
    by_prune, _ = edits.add_prune(used, AGENT, "goto", "left", ["rotate-right"])
    by_example = edits.record_pick(
        used, replace(pick("rotate-right"), examples=(Example("", START, RIGHT.id, VALUES, pick=5),))
    )
    for changed in (by_rule, by_prune, by_example):
        assert edits.take_back_pick(changed, recorded).library(AGENT).get("goto").has_state(RIGHT.id)


def test_a_moment_that_another_example_refers_to_stays() -> None:
    recorded = pick("left", snapshot="m1")
    assert set(edits.take_back_pick(edits.record_pick(project(), recorded), recorded).moments) == {"m1"}


def test_what_cannot_be_learned_from_is_not_recorded() -> None:
    with pytest.raises(EditError, match="feature 'distance' of an example of goto is inf"):
        edits.record_pick(
            project(), Recorded(AGENT, "goto", (Example("", START, "left", {"distance": float("inf")}),))
        )
    with pytest.raises(EditError, match="goto has no state 'gone'"):
        edits.record_pick(project(), Recorded(AGENT, "goto", (Example("", START, "gone", VALUES),)))


def test_a_state_that_a_pick_adds_must_be_possible() -> None:
    taken = replace(RIGHT, id="left")
    with pytest.raises(EditError, match="already has another state with the id 'left'"):
        edits.record_pick(project(), Recorded(AGENT, "goto", state=taken))
    with pytest.raises(EditError, match="recursion is not permitted"):
        edits.record_pick(project(), Recorded(AGENT, "goto", state=State("x", Nested("forage"))))
    with pytest.raises(EditError, match="one Start only"):
        edits.record_pick(project(), Recorded(AGENT, "goto", state=State("x", Start())))
    there = State("left", Basic("RotateLeft"))
    assert edits.record_pick(project(), Recorded(AGENT, "goto", state=there)) == project()


def test_stored_moments_are_not_looked_at() -> None:
    """Moments from disk are made when they are looked at; recording and taking back must not make them all."""

    class Untouchable(Mapping[str, Moment]):
        def __getitem__(self, key: str) -> Moment:
            raise AssertionError(f"{key} was looked at")

        def __iter__(self) -> Iterator[str]:
            return iter(["m1"])

        def __len__(self) -> int:
            return 1

        def __contains__(self, key: object) -> bool:
            return key == "m1"

    stored = Untouchable()
    before = replace(project(), moments=stored)
    first, second = (
        pick("left"),
        replace(
            pick("left", snapshot="m3"), examples=(Example("", START, "left", VALUES, pick=5, snapshot="m3"),)
        ),
    )
    changed = edits.record_pick(edits.record_pick(before, first), second)
    assert set(changed.moments) == {"m1", "m2", "m3"}
    assert changed.moments["m3"] == moment()
    back = edits.take_back_pick(changed, second)
    assert set(back.moments) == {"m1", "m2"}
    assert edits.take_back_pick(back, first).moments is stored


# --------------------------------------------------------------------------------------------- by hand


class Ids(list[str]):
    """Ids that nobody may look through for each example: of ten thousand, that takes most of a second."""

    def __contains__(self, _id: object) -> bool:
        raise AssertionError("looked through")


def test_thousands_of_examples_are_changed_without_looking_through_the_list_for_each() -> None:
    some = Ids(ids(project()))
    changed = edits.disable_examples(project(), AGENT, "goto", some)
    assert edits.enable_examples(changed, AGENT, "goto", some) == project()
    edits.relabel_examples(project(), AGENT, "goto", some, "left")
    edits.weight_examples(project(), AGENT, "goto", some, 2.0)


def test_examples_are_disabled_and_enabled_again() -> None:
    changed = edits.disable_examples(project(), AGENT, "goto", ["1", "3"])
    assert [e.enabled for e in changed.examples_of(AGENT, "goto")] == [False, True, False, True, True]
    assert edits.enable_examples(changed, AGENT, "goto", ["1", "3"]) == project()


def test_a_relabeled_continuation_is_none_any_more() -> None:
    changed = edits.relabel_examples(project(), AGENT, "goto", ["2", "3"], "left")
    first, second = changed.examples_of(AGENT, "goto")[1:3]
    assert (first.label, first.continuation, second.label) == ("left", False, "left")
    with pytest.raises(EditError, match="goto has no state 'gone'"):
        edits.relabel_examples(project(), AGENT, "goto", ["2"], "gone")


def test_a_weight_is_a_finite_number_above_0() -> None:
    assert (
        edits.weight_examples(project(), AGENT, "goto", ["2"], 3.0).examples_of(AGENT, "goto")[1].weight
        == 3.0
    )
    for weight in (0.0, -1.0, float("inf"), float("nan")):
        with pytest.raises(EditError, match="allowed: above 0"):
            edits.weight_examples(project(), AGENT, "goto", ["2"], weight)


def test_examples_that_are_not_there_are_named() -> None:
    with pytest.raises(EditError, match="goto has no example 7, 8; it has 5 examples"):
        edits.disable_examples(project(), AGENT, "goto", ["1", "8", "7"])


def test_examples_are_replaced_as_a_whole() -> None:
    new = (
        Example("", START, "left", VALUES, snapshot="m9", pick=1),
        Example("", "left", "left", VALUES, pick=1),
    )
    changed = edits.replace_examples(project(), AGENT, "goto", new, {"m9": moment()})
    assert ids(changed) == ["1", "2"]
    assert set(changed.moments) == {"m9"}
    forgotten = edits.without_examples(project(), AGENT, "goto")
    assert (forgotten.examples, forgotten.moments) == ({}, {})


# ---------------------------------------------------------------------------------------------- picking


def test_a_pick_by_content_means_the_first_state_that_holds_just_that() -> None:
    box, deposit = (Nested("goto", {"target": Ground(target)}) for target in ("nearest-box", "deposit"))
    approach = project().library(AGENT).get("forage").state("approach")
    assert edits.state_for(project(), vocabulary(), AGENT, "forage", box) == (approach, None)
    assert edits.state_for(project(), vocabulary(), AGENT, "forage", "approach") == (approach, None)
    new = State("goto", deposit)
    assert edits.state_for(project(), vocabulary(), AGENT, "forage", deposit) == (new, new)
    flag = State("lost", RaiseFlag("lost"))
    assert edits.state_for(project(), vocabulary(), AGENT, "forage", RaiseFlag("lost")) == (flag, flag)


def test_a_controller_picks_what_its_subsidiaries_can_do() -> None:
    wander = Basic("wander")
    state, added = edits.state_for(project(), vocabulary(), GROUP, "control", wander)
    assert state == added == State("wander", wander)


def test_what_cannot_be_picked_is_refused() -> None:
    for choice, message in (
        ("gone", "goto has no state 'gone'"),
        (Basic("Fly"), "'agent' has no basic behavior 'Fly'; there are: Done, Face"),
        (Basic("Face"), "'target' of Face is open: pick a target, or a parameter of goto"),
        (Basic("Forward", {"target": Ground("deposit")}), "Forward has no parameter 'target'; it has: none"),
        (Nested("forage"), "recursion is not permitted"),
        (Nested("gogo"), "no behavior with the id 'gogo'"),
    ):
        with pytest.raises(EditError, match=message):
            edits.state_for(project(), vocabulary(), AGENT, "goto", choice)
