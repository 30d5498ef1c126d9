"""Edits of automata as wholes."""

from dataclasses import replace

import pytest

from app.core import edits
from app.core.automaton import Basic, Nested, Settings, State
from app.core.check import check
from app.core.errors import EditError
from app.core.features import Ground, Parameter, Sense
from app.core.library import Library, NodeType
from app.core.project import Arm, LevelTable, Project
from app.core.vocabulary import BasicBehavior
from tests.samples import AGENT, GROUP, SQUAD, automaton, nested, project, state, vocabulary


def sound(changed: Project) -> bool:
    return not check(changed, vocabulary())


def content(changed: Project, type_name: str, automaton_id: str, state_id: str) -> object:
    return changed.library(type_name).get(automaton_id).state(state_id).content


def test_a_new_automaton_has_nothing_but_start() -> None:
    changed, new = edits.add_automaton(project(), AGENT, "Turn Round", ["target"])
    added = changed.library(AGENT).get(new)
    assert (new, added.name, added.parameters, len(added.states)) == (
        "turn-round",
        "Turn Round",
        ("target",),
        1,
    )


def test_ids_are_readable_and_never_taken_twice() -> None:
    changed, first = edits.add_automaton(project(), AGENT, "Goto")
    changed, second = edits.add_automaton(changed, AGENT, "GOTO")
    changed, odd = edits.add_automaton(changed, AGENT, "???")
    changed, device = edits.add_automaton(changed, AGENT, "CON")
    assert (first, second, odd, device) == ("goto-2", "goto-3", "behavior", "con-2")


def test_an_edit_shares_everything_that_it_did_not_change() -> None:
    before = project()
    after = edits.set_note(before, AGENT, "goto", "turns first")
    assert after.library(GROUP) is before.library(GROUP)
    assert after.library(AGENT).get("forage") is before.library(AGENT).get("forage")
    assert after.examples is before.examples
    assert before == project()


@pytest.mark.parametrize("name", ["", "  ", "goto"])
def test_a_name_must_be_there_and_free(name: str) -> None:
    with pytest.raises(EditError):
        edits.add_automaton(project(), AGENT, name)
    with pytest.raises(EditError):
        edits.rename_automaton(project(), AGENT, "wander", name)


def test_what_is_not_there_is_named_with_what_there_is() -> None:
    with pytest.raises(
        EditError, match=r"'agent' has no behavior with the id 'gogo'; there are: fetch, forage, goto, wander"
    ):
        edits.set_note(project(), AGENT, "gogo", "")
    with pytest.raises(EditError, match=r"no node type 'robot'; there are: agent, group, squad"):
        edits.add_automaton(project(), "robot", "New")


def test_a_rename_reaches_controllers_and_arms_and_keeps_the_id() -> None:
    changed = edits.rename_automaton(project(), AGENT, "goto", "Approach")
    changed = edits.rename_automaton(changed, AGENT, "forage", "Collect")
    assert changed.library(AGENT).get("goto").name == "Approach"
    assert content(changed, GROUP, "control", "gather") == Basic(
        "Approach", {"target": Ground("closest-attached-agent")}
    )
    assert content(changed, GROUP, "control", "search") == Basic("Collect")
    assert changed.arm("independent").top == "Collect"
    assert sound(changed)


def test_a_rename_leaves_the_very_automata_that_hold_the_behavior_by_its_id() -> None:
    before = project()
    changed = edits.rename_automaton(before, AGENT, "goto", "Approach")
    assert changed.library(AGENT).get("forage") is before.library(AGENT).get("forage")


def test_a_rename_reaches_controllers_of_controllers() -> None:
    shout = automaton("shout", state("all", "goto", {"target": Ground("deposit")}))
    with_squads = project()
    with_squads = edits.add_automaton(with_squads, SQUAD, "shout")[0]
    with_squads = edits.add_state(with_squads, SQUAD, "shout", shout.state("all").content)[0]
    changed = edits.rename_automaton(with_squads, AGENT, "goto", "Approach")
    assert content(changed, SQUAD, "shout", "goto") == Basic("Approach", {"target": Ground("deposit")})


def test_a_rename_stops_at_a_type_whose_own_behavior_has_that_name() -> None:
    changed, _ = edits.add_automaton(project(), GROUP, "wander")
    changed, squad = edits.add_automaton(changed, SQUAD, "watch")
    changed, _ = edits.add_state(changed, SQUAD, squad, Basic("wander"))
    changed = edits.rename_automaton(changed, AGENT, "wander", "Stroll")
    assert content(changed, SQUAD, squad, "wander") == Basic("wander")


def test_a_name_that_several_types_share_is_not_taken_from_their_controller() -> None:
    types = (NodeType(AGENT), NodeType("robot"), NodeType(GROUP, 1, (AGENT, "robot")))
    both = {t: Library({"wander": automaton("wander")}) for t in (AGENT, "robot")}
    lead = automaton("lead", state("wander", "wander"))
    mixed = Project("Mixed", "sample", types, libraries={**both, GROUP: Library({"lead": lead})})
    for act in (
        lambda: edits.rename_automaton(mixed, AGENT, "wander", "Stroll"),
        lambda: edits.delete_automaton(mixed, AGENT, "wander", replacement=BasicBehavior("Forward")),
        lambda: edits.set_parameters(mixed, AGENT, "wander", ["target"]),
    ):
        with pytest.raises(EditError, match=r"state wander of lead \(group\) also means"):
            act()


def test_a_duplicate_has_all_that_the_original_has() -> None:
    changed, copy = edits.duplicate_automaton(project(), AGENT, "goto")
    original, duplicate = changed.library(AGENT).get("goto"), changed.library(AGENT).get(copy)
    assert (copy, duplicate.name) == ("goto-2", "goto 2")
    assert (duplicate.states, duplicate.learned, duplicate.prunes) == (
        original.states,
        original.learned,
        original.prunes,
    )
    assert changed.examples_of(AGENT, copy) == changed.examples_of(AGENT, "goto")
    assert sound(changed)


# ------------------------------------------------------------------------------------------------ delete


def test_deleting_a_used_behavior_is_refused_with_its_users_named() -> None:
    with pytest.raises(
        EditError, match=r"state home of fetch, state approach of forage, state gather of control \(group\)"
    ):
        edits.delete_automaton(project(), AGENT, "goto")
    with pytest.raises(EditError, match="arm 'independent'"):
        edits.delete_automaton(project(), AGENT, "forage")


def test_a_replacement_takes_the_place_of_a_deleted_behavior_everywhere() -> None:
    changed, other = edits.duplicate_automaton(project(), AGENT, "goto", "walk to")
    changed = edits.delete_automaton(changed, AGENT, "goto", replacement=other)
    assert content(changed, AGENT, "forage", "approach") == Nested(other, {"target": Ground("nearest-box")})
    assert content(changed, GROUP, "control", "gather") == Basic(
        "walk to", {"target": Ground("closest-attached-agent")}
    )
    assert sound(changed)


def test_a_basic_behavior_can_replace_an_automaton_and_drops_slots_that_it_lacks() -> None:
    changed = edits.delete_automaton(project(), AGENT, "goto", replacement=BasicBehavior("Forward"))
    assert content(changed, AGENT, "forage", "approach") == Basic("Forward")
    assert content(changed, GROUP, "control", "gather") == Basic("Forward")
    changed = edits.delete_automaton(project(), AGENT, "forage", replacement="wander")
    assert changed.arm("independent").top == "wander"


def test_a_replacement_may_not_make_a_cycle_or_be_the_behavior_itself() -> None:
    with pytest.raises(EditError, match="recursion is not permitted, but forage holds forage"):
        edits.delete_automaton(project(), AGENT, "goto", replacement="forage")
    with pytest.raises(EditError, match="replaced by itself"):
        edits.delete_automaton(project(), AGENT, "goto", replacement="goto")


def test_examples_moments_and_demonstrations_go_with_their_behavior() -> None:
    changed = edits.delete_automaton(project(), AGENT, "goto", replacement=BasicBehavior("Face", ("target",)))
    assert "goto" not in changed.library(AGENT).automata
    assert (changed.examples, changed.moments, changed.demonstrations) == ({}, {}, ())


def test_the_last_behavior_of_a_type_leaves_no_empty_library() -> None:
    changed = edits.delete_automaton(project(), GROUP, "control", replacement=BasicBehavior("forage"))
    assert GROUP not in changed.libraries
    assert changed.arm("two levels").top == "forage"
    assert sound(changed)


def remembering(type_name: str, automaton_id: str, *removed: State) -> Project:
    """The project with a demonstration that knows states of an automaton which are gone."""
    before = project()
    shown = replace(
        before.demonstrations[0], type=type_name, automaton=automaton_id, arguments={}, removed=removed
    )
    return replace(before, demonstrations=(shown,))


def remembered(changed: Project) -> list[object]:
    return [removed.content for removed in changed.demonstrations[0].removed]


def test_states_that_only_demonstrations_remember_follow_the_behaviors_that_they_hold() -> None:
    gone = nested("there", "goto", {"target": Ground("deposit")})
    renamed = edits.rename_parameter(remembering(AGENT, "forage", gone), AGENT, "goto", "target", "goal")
    assert remembered(renamed) == [Nested("goto", {"goal": Ground("deposit")})]
    ordered = state("there", "goto", {"target": Ground("deposit")})
    renamed = edits.rename_automaton(remembering(GROUP, "control", ordered), AGENT, "goto", "Approach")
    assert remembered(renamed) == [Basic("Approach", {"target": Ground("deposit")})]
    replaced = edits.delete_automaton(remembering(AGENT, "forage", gone), AGENT, "goto", "wander")
    assert remembered(replaced) == [Nested("wander", {})]
    turned = state("turned", "Face", {"target": Parameter("target")})
    renamed = edits.rename_parameter(remembering(AGENT, "goto", turned), AGENT, "goto", "target", "goal")
    assert remembered(renamed) == [Basic("Face", {"target": Parameter("goal")})]


# -------------------------------------------------------------------------------------------- parameters


def test_renaming_a_parameter_renames_its_bindings_inside_and_its_slots_outside() -> None:
    changed = edits.rename_parameter(project(), AGENT, "goto", "target", "goal")
    goto = changed.library(AGENT).get("goto")
    assert goto.parameters == ("goal",)
    assert goto.feature("distance").source == Sense("DistanceTo", {"target": Parameter("goal")})
    assert content(changed, AGENT, "fetch", "home") == Nested("goto", {"goal": Ground("deposit")})
    assert content(changed, GROUP, "control", "gather") == Basic(
        "goto", {"goal": Ground("closest-attached-agent")}
    )
    assert changed.demonstrations[0].arguments == {"goal": "deposit"}
    assert sound(changed)


def test_a_used_parameter_cannot_be_dropped() -> None:
    with pytest.raises(
        EditError, match=r"is used by feature DistanceTo\(target\), feature DirectionTo\(target\)"
    ):
        edits.set_parameters(project(), AGENT, "goto", [])


def test_dropping_an_unused_parameter_drops_its_slots_outside() -> None:
    changed = edits.set_parameters(project(), AGENT, "goto", ["target", "speed"])
    changed = edits.bind_state(changed, AGENT, "fetch", "home", "speed", Ground("deposit"))
    assert edits.set_parameters(changed, AGENT, "goto", ["target"]) == project()


@pytest.mark.parametrize("parameters", [["target", "target"], ["target", " "]])
def test_parameters_have_different_names(parameters: list[str]) -> None:
    with pytest.raises(EditError):
        edits.set_parameters(project(), AGENT, "goto", parameters)


def test_renaming_a_parameter_that_is_not_there_says_which_are() -> None:
    with pytest.raises(EditError, match="goto has no parameter 'goal'; there are: 'target'"):
        edits.rename_parameter(project(), AGENT, "goto", "goal", "x")
    assert edits.rename_parameter(project(), AGENT, "goto", "target", "target") == project()


# ---------------------------------------------------------------------------------------------- settings


def test_settings_and_notes_are_set() -> None:
    settings = Settings(pruning_confidence=0.25)
    changed = edits.set_settings(project(), AGENT, "goto", settings)
    assert changed.library(AGENT).get("goto").settings == settings


@pytest.mark.parametrize("confidence", [0.0, 0.6, -1.0, float("nan")])
def test_a_pruning_confidence_lies_above_0_and_up_to_a_half(confidence: float) -> None:
    with pytest.raises(EditError, match=r"allowed: above 0 up to 0\.5"):
        edits.set_settings(project(), AGENT, "goto", Settings(pruning_confidence=confidence))


def test_an_arm_whose_roots_mean_different_behaviors_by_its_top_keeps_it() -> None:
    types = (NodeType(AGENT), NodeType("robot"), NodeType(GROUP, 1, (AGENT,)))
    both = {t: Library({"wander": automaton("wander")}) for t in (AGENT, "robot")}
    arm = Arm("a", LevelTable((2,), (AGENT,)), "wander")
    plain = Project("Two", "sample", types, libraries=both, arms=(arm,))
    assert edits.rename_automaton(plain, AGENT, "wander", "Stroll").arm("a").top == "Stroll"
    assert edits.rename_automaton(plain, "robot", "wander", "Stroll").arm("a").top == "wander"
    mixed, _ = edits.add_node(plain, "a", "robot")
    with pytest.raises(EditError, match="arm 'a' also means"):
        edits.rename_automaton(mixed, AGENT, "wander", "Stroll")
