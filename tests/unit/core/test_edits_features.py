"""Edits of what an automaton looks at."""

import pytest

from app.core import edits
from app.core.automaton import START, Refit
from app.core.conditions import AtMost, Equals
from app.core.errors import EditError
from app.core.features import FeatureUse, FlagUp, Ground, Operation, Sense, Statistic, TicksInState
from app.core.project import Project
from tests.samples import AGENT, GROUP, project, when

SEES = Sense("SeesABox")
TO_BOX = Sense("DistanceTo", {"target": Ground("nearest-box")})


def goto(changed: Project) -> list[str]:
    return [use.id for use in changed.library(AGENT).get("goto").features]


def test_a_new_feature_comes_last_with_an_id_made_from_what_it_is() -> None:
    changed, sees = edits.add_feature(project(), AGENT, "goto", SEES)
    changed, flag = edits.add_feature(changed, AGENT, "goto", FlagUp("done"))
    changed, ticks = edits.add_feature(changed, AGENT, "goto", TicksInState())
    changed, named = edits.add_feature(changed, AGENT, "goto", TO_BOX, "to the box")
    assert (sees, flag, ticks, named) == ("sees-a-box", "done", "ticks-in-state", "to-the-box")
    assert goto(changed) == ["distance", "direction", sees, flag, ticks, named]


def test_a_statistic_is_called_after_what_it_sums_up() -> None:
    statistic = Statistic(Operation.MEAN, Sense("DistanceTo", {"target": Ground("deposit")}))
    assert edits.add_feature(project(), GROUP, "control", statistic)[1] == "mean-distance-to"


def test_the_same_feature_is_not_added_twice() -> None:
    with pytest.raises(EditError, match="forage already looks at SeesABox: feature 'sees'"):
        edits.add_feature(project(), AGENT, "forage", SEES)


def test_an_id_is_not_given_to_a_feature_while_examples_have_values_under_it() -> None:
    dropped = edits.drop_feature(edits.remove_prune(project(), AGENT, "goto", "1"), AGENT, "goto", "distance")
    assert edits.add_feature(dropped, AGENT, "goto", TO_BOX, "distance")[1] == "distance-2"


def test_dropping_a_feature_that_rules_or_prunes_test_is_refused_with_these_named() -> None:
    with pytest.raises(EditError, match="is tested by prune '1' of state 'left'"):
        edits.drop_feature(project(), AGENT, "goto", "distance")
    with pytest.raises(
        EditError, match="is tested by rule '2' of state 'wander', rule '4' of state 'approach'"
    ):
        edits.drop_feature(project(), AGENT, "forage", "sees")


def test_dropping_a_feature_by_force_removes_the_rules_and_prunes_that_test_it() -> None:
    changed = edits.drop_feature(project(), AGENT, "forage", "sees", force=True)
    assert [rule.id for rule in changed.library(AGENT).get("forage").rules] == ["1", "3", "5"]
    assert (
        edits.drop_feature(project(), AGENT, "goto", "distance", force=True).library(AGENT).get("goto").prunes
        == ()
    )


def test_dropping_a_feature_forgets_the_models_that_test_it_and_no_others() -> None:
    changed, ticks = edits.add_feature(project(), AGENT, "goto", TicksInState())
    assert edits.drop_feature(changed, AGENT, "goto", ticks) == project()
    changed = edits.drop_feature(project(), AGENT, "goto", "direction")
    automaton = changed.library(AGENT).get("goto")
    assert (automaton.learned, automaton.learned_from) == ({}, "")
    assert changed.examples is not None
    assert changed.examples_of(AGENT, "goto") == project().examples_of(AGENT, "goto")


def test_a_model_without_a_table_form_may_look_at_everything() -> None:
    refit = edits.set_learned(project(), AGENT, "wander", {START: Refit("knn")}, "x")
    refit, ticks = edits.add_feature(refit, AGENT, "wander", TicksInState())
    assert edits.drop_feature(refit, AGENT, "wander", ticks).library(AGENT).get("wander").learned == {}


def test_rebinding_a_feature_keeps_rules_and_forgets_values_and_models() -> None:
    changed = edits.rebind_feature(project(), AGENT, "goto", "distance", TO_BOX)
    automaton = changed.library(AGENT).get("goto")
    assert automaton.feature("distance") == FeatureUse("distance", TO_BOX)
    assert automaton.learned == {}
    assert automaton.prunes == project().library(AGENT).get("goto").prunes
    assert all(set(e.values) == {"direction"} for e in changed.examples_of(AGENT, "goto"))


def test_rebinding_a_feature_to_what_it_is_changes_nothing() -> None:
    before = project()
    source = before.library(AGENT).get("goto").feature("distance").source
    assert edits.rebind_feature(before, AGENT, "goto", "distance", source) is before


def test_values_of_a_feature_added_later_are_put_in() -> None:
    changed, sees = edits.add_feature(project(), AGENT, "goto", SEES)
    changed = edits.set_values(changed, AGENT, "goto", {"1": {sees: 1.0}, "2": {sees: 0.0}})
    first, second, third, *_ = changed.examples_of(AGENT, "goto")
    assert (first.values[sees], second.values[sees], sees in third.values) == (1.0, 0.0, False)
    assert first.values["distance"] == 40.0
    with pytest.raises(EditError, match="feature 'sees-a-box' of example '1' is nan"):
        edits.set_values(changed, AGENT, "goto", {"1": {sees: float("nan")}})


def test_features_are_renamed_and_moved() -> None:
    changed = edits.rename_feature(project(), AGENT, "goto", "direction", "bearing")
    changed = edits.move_feature(changed, AGENT, "goto", "direction", 0)
    assert goto(changed) == ["direction", "distance"]
    assert changed.library(AGENT).get("goto").feature("direction").shown == "bearing"


def test_an_unknown_feature_is_named_with_those_there_are() -> None:
    with pytest.raises(
        EditError, match=r"goto has no feature 'far'; there are: 'distance' \(DistanceTo\(target\)\)"
    ):
        edits.rename_feature(project(), AGENT, "goto", "far", "x")
    with pytest.raises(EditError, match="goto has no feature 'far'"):
        edits.add_rule(project(), AGENT, "goto", "left", "forward", when(AtMost("far", 1.0)))
    with pytest.raises(EditError, match="goto has no feature 'far'"):
        edits.add_prune(project(), AGENT, "goto", "left", ["forward"], when(Equals("far", 1.0)))
