"""Learning again what edits have made stale, beside the window: values first, then models, one problem never in the way."""

from dataclasses import replace
from threading import Event
from typing import Any

import pytest

from app.core.automaton import START, Settings
from app.core.edits import (
    add_feature,
    disable_examples,
    drop_feature,
    enable_examples,
    relabel_examples,
    rename_arm,
    set_hierarchy,
    set_settings,
    set_values,
)
from app.core.features import Ground, Parameter, Sense
from app.core.project import LevelTable, Project
from app.engine import relearning
from app.engine.backfill import fill_values
from app.engine.relearning import RelearnAnswer, Relearner
from app.learner.builder import LearningCancelled
from app.learner.trainer import apply, is_stale, learn
from app.sim.scenario import Scenario
from tests.corridor import corridor
from tests.driver import Driver
from tests.samples import AGENT, GROUP

PATIENCE = 60.0
SHUTTLE = (AGENT, "Shuttle")
LEAD = (GROUP, "Lead")


def taught() -> Project:
    """Shuttle with a few examples, Lead with one; nothing learned yet."""
    driver = Driver().teach("agent-1", "Shuttle").pick("up").advance(4).pick("down").advance(2)
    driver = Driver(driver.project, "groups").teach("group-1", "Lead").pick("up").advance(2)
    return driver.project


def learned() -> Project:
    made = taught()
    return apply(made, learn(made, corridor.vocabulary))


def relearn(project: Project, scenario: Scenario) -> RelearnAnswer:
    """What comes of learning what is stale, waited for."""
    ready = Event()
    relearner = Relearner(ready.set)
    try:
        relearner.ask(0, project, scenario)
        assert ready.wait(PATIENCE)
        (answer,) = relearner.answers()
        return answer
    finally:
        relearner.close()


def used(project: Project, answer: RelearnAnswer) -> Project:
    """The project as its owner makes it of an answer."""
    for where, values in answer.filled.items():
        project = set_values(project, *where, values)
    return apply(project, answer.learned)


def test_what_is_stale_is_learned_and_nothing_else() -> None:
    made = learned()
    assert not relearn(made, corridor).changes
    edited = relabel_examples(made, *SHUTTLE, ["1"], "down")
    answer = relearn(edited, corridor)
    assert list(answer.learned.automata) == [SHUTTLE]
    assert answer.problems == ()
    assert not is_stale(used(edited, answer), *SHUTTLE)


def test_what_was_never_learned_is_learned_types_in_their_order() -> None:
    assert list(relearn(taught(), corridor).learned.automata) == [SHUTTLE, LEAD]


def test_a_changed_setting_is_learned_from() -> None:
    edited = set_settings(learned(), *SHUTTLE, Settings(pruning_confidence=0.25))
    assert list(relearn(edited, corridor).learned.automata) == [SHUTTLE]


def test_a_feature_added_later_is_filled_in_and_learned_from_in_one_go() -> None:
    edited, lamp = add_feature(learned(), *SHUTTLE, Sense("DistanceTo", {"target": Ground("lamp")}))
    answer = relearn(edited, corridor)
    examples = edited.examples_of(*SHUTTLE)
    assert {i: list(values) for i, values in answer.filled[SHUTTLE].items()} == {
        e.id: [lamp] for e in examples
    }
    made = used(edited, answer)
    assert all(lamp in example.values for example in made.examples_of(*SHUTTLE))
    assert not is_stale(made, *SHUTTLE)
    assert not relearn(made, corridor).changes


def test_a_feature_dropped_makes_the_rest_learned_again() -> None:
    edited = drop_feature(learned(), *SHUTTLE, "place")
    assert list(relearn(edited, corridor).learned.automata) == [SHUTTLE]


def test_values_that_cannot_be_read_are_told_once_a_reason_and_the_others_are_learned_from() -> None:
    made = replace(learned(), moments={})
    edited, _ = add_feature(made, *SHUTTLE, Sense("Coin"))
    answer = relearn(edited, corridor)
    assert answer.problems == (
        "Shuttle: examples 1, 2, 3, 4 cannot be learned from: the moment it was recorded in is not stored",
    )
    assert answer.learned.automata[SHUTTLE].models == {}


def test_why_values_cannot_be_read_is_told_in_full() -> None:
    edited, _ = add_feature(learned(), *SHUTTLE, Sense("DistanceTo", {"target": Parameter("X")}))
    (problem,) = relearn(edited, corridor).problems
    assert "'X'" in problem
    assert "1, 2, 3, 4 cannot be learned from: 'target' of feature 'DistanceTo(X)'" in problem


def test_disabled_examples_are_filled_in_too_and_not_complained_of() -> None:
    made = disable_examples(replace(learned(), moments={}), *SHUTTLE, ["1", "2", "3", "4"])
    edited, _ = add_feature(made, *SHUTTLE, Sense("Coin"))
    assert relearn(edited, corridor).problems == ()


def test_with_all_examples_disabled_there_are_no_models_left_and_with_them_they_come_back() -> None:
    made = learned()
    ids = [example.id for example in made.examples_of(*SHUTTLE)]
    without = disable_examples(made, *SHUTTLE, ids)
    without = used(without, relearn(without, corridor))
    assert without.library(AGENT).get("Shuttle").learned == {}
    again = enable_examples(without, *SHUTTLE, ids)
    again = used(again, relearn(again, corridor))
    assert again.library(AGENT).get("Shuttle") == made.library(AGENT).get("Shuttle")


def test_an_automaton_that_cannot_be_learned_does_not_keep_the_others_from_it() -> None:
    edited = set_settings(taught(), *SHUTTLE, Settings(classifier="knn", options={"neighbors": -1.0}))
    answer = relearn(edited, corridor)
    assert list(answer.learned.automata) == [LEAD]
    assert len(answer.problems) == 1
    assert "neighbors" in answer.problems[0]


# --------------------------------------------------------------------------------------------- in the thread


class Bell:
    """Rings when an answer has come."""

    def __init__(self) -> None:
        self._rang = Event()

    def __call__(self) -> None:
        self._rang.set()

    def answers(self, relearner: Relearner) -> list[RelearnAnswer]:
        """The answers, once there are any; a question that was given up rings as well."""
        while not (answers := relearner.answers()):
            assert self._rang.wait(PATIENCE)
            self._rang.clear()
        return answers


def test_an_answer_carries_its_revision_and_comes_once() -> None:
    bell = Bell()
    relearner = Relearner(bell)
    relearner.ask(7, taught(), corridor)
    assert relearner.busy
    (answer,) = bell.answers(relearner)
    assert (answer.revision, list(answer.learned.automata)) == (7, [SHUTTLE, LEAD])
    assert (relearner.answers(), relearner.busy) == ([], False)
    assert relearner.progress == (1.0, "")
    relearner.close()


def test_an_earlier_question_is_given_up_and_the_thread_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    begun, given_up = Event(), Event()

    def slow(*args: Any) -> object:
        if args[0].name != "slow":
            return learn(*args)
        begun.set()
        cancelled = args[-1]
        while not cancelled():
            given_up.wait(0.001)
        given_up.set()
        raise LearningCancelled

    monkeypatch.setattr(relearning, "learn", slow)
    bell = Bell()
    relearner = Relearner(bell)
    relearner.ask(1, replace(taught(), name="slow"), corridor)
    assert begun.wait(PATIENCE)
    relearner.ask(2, taught(), corridor)
    assert [answer.revision for answer in bell.answers(relearner)] == [2]
    assert given_up.is_set()
    relearner.ask(3, replace(taught(), name="slow"), corridor)
    relearner.close()


def test_what_nobody_foresaw_is_an_answer_too(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*_: object) -> object:
        raise ZeroDivisionError("oh")

    monkeypatch.setattr(relearning, "learn", broken)
    bell = Bell()
    relearner = Relearner(bell)
    relearner.ask(1, taught(), corridor)
    (answer,) = bell.answers(relearner)
    assert answer.problems == ("learning failed: ZeroDivisionError: oh",)
    relearner.close()


def test_values_that_could_not_be_read_are_not_looked_for_again_until_something_changes(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    tries: list[str] = []
    fill = fill_values

    def counting(*args: Any) -> object:
        tries.append("")
        return fill(*args)

    monkeypatch.setattr(relearning, "fill_values", counting)
    bell = Bell()
    relearner = Relearner(bell)
    edited, _ = add_feature(replace(learned(), moments={}), *SHUTTLE, Sense("Coin"))
    problems = []
    for project in (
        edited,
        set_settings(edited, *SHUTTLE, Settings("cart")),
        rename_arm(edited, "squads", "all"),
    ):
        relearner.ask(1, project, corridor)
        problems.append(bell.answers(relearner)[0].problems)
    assert len(tries) == 2
    assert problems[0] == problems[1] == problems[2] != ()
    relearner.close()


def test_a_forest_that_is_another_now_is_told() -> None:
    edited, _ = add_feature(learned(), *SHUTTLE, Sense("Coin"))
    edited = set_hierarchy(edited, "alone", LevelTable((3,), (AGENT,)))
    (problem,) = relearn(edited, corridor).problems
    assert problem.endswith("the moment is of arm 'alone', whose nodes are others now")
    assert START in edited.library(AGENT).get("Shuttle").learned
