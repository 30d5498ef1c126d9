"""Edits of states, and copying them with their transitions."""

import pytest

from app.core import edits
from app.core.automaton import START, Basic, Nested, RaiseFlag, Refit, Rule, Start, State
from app.core.check import check
from app.core.conditions import Condition, Equals
from app.core.errors import EditError
from app.core.features import Ground, Parameter
from app.core.project import Project
from app.core.tree import Branch, Leaf, Tree
from tests.samples import AGENT, GROUP, project, vocabulary, when


def states(changed: Project, automaton_id: str) -> list[str]:
    return [state.id for state in changed.library(AGENT).get(automaton_id).states]


def test_a_new_state_comes_last_with_an_id_made_from_what_it_holds() -> None:
    changed, basic = edits.add_state(project(), AGENT, "wander", Basic("GrabBox"))
    changed, nested = edits.add_state(changed, AGENT, "wander", Nested("goto", {"target": Ground("deposit")}))
    changed, flag = edits.add_state(changed, AGENT, "wander", RaiseFlag("lost"))
    changed, named = edits.add_state(changed, AGENT, "wander", Basic("Forward"), "Go On")
    assert (basic, nested, flag, named) == ("grab-box", "goto", "lost", "go-on")
    assert states(changed, "wander")[-4:] == ["grab-box", "goto", "lost", "go-on"]


def test_two_states_may_hold_the_same_behavior() -> None:
    changed, first = edits.add_state(
        project(), AGENT, "wander", Nested("goto", {"target": Ground("deposit")})
    )
    changed, second = edits.add_state(
        changed, AGENT, "wander", Nested("goto", {"target": Ground("nearest-box")})
    )
    assert (first, second) == ("goto", "goto-2")


def test_an_automaton_cannot_come_to_hold_itself() -> None:
    with pytest.raises(EditError, match="recursion is not permitted, but"):
        edits.add_state(project(), AGENT, "goto", Nested("forage"))
    with pytest.raises(EditError, match="goto holds goto"):
        edits.set_content(project(), AGENT, "goto", "left", Nested("goto"))


def test_a_state_cannot_hold_what_is_not_there() -> None:
    with pytest.raises(EditError, match="no behavior with the id 'gogo'"):
        edits.add_state(project(), AGENT, "wander", Nested("gogo"))
    with pytest.raises(EditError, match="one Start only"):
        edits.add_state(project(), AGENT, "wander", Start())
    with pytest.raises(EditError, match="a flag needs a name"):
        edits.add_state(project(), AGENT, "wander", RaiseFlag(" "))


def test_removing_a_state_takes_its_rules_along() -> None:
    changed = edits.remove_state(project(), AGENT, "forage", "approach")
    assert [rule.id for rule in changed.library(AGENT).get("forage").rules] == ["1", "5"]


def test_removing_a_state_disables_examples_that_mention_it_and_keeps_them() -> None:
    changed = edits.remove_state(project(), AGENT, "goto", "left")
    assert [(e.id, e.enabled) for e in changed.examples_of(AGENT, "goto")] == [
        ("1", True),
        ("2", True),
        ("3", False),
        ("4", False),
        ("5", False),
    ]
    assert changed.moments == project().moments


def test_removing_a_state_forgets_models_that_lead_to_it_and_prunes_that_forbid_only_it() -> None:
    before, _ = edits.add_prune(project(), AGENT, "goto", "forward", ["left", "done"])
    before, _ = edits.add_prune(before, AGENT, "goto", "forward", ["left"])
    goto = edits.remove_state(before, AGENT, "goto", "left").library(AGENT).get("goto")
    assert (goto.learned, goto.learned_from) == ({}, "")
    assert [(prune.id, prune.forbidden) for prune in goto.prunes] == [("2", frozenset({"done"}))]


def test_removing_a_state_keeps_models_that_do_not_know_it() -> None:
    before, new = edits.add_state(project(), AGENT, "goto", Basic("RotateRight"))
    before = edits.set_learned(
        before, AGENT, "goto", {**before.library(AGENT).get("goto").learned, new: Refit("k")}, "f"
    )
    goto = edits.remove_state(before, AGENT, "goto", new).library(AGENT).get("goto")
    assert goto.learned == project().library(AGENT).get("goto").learned


def test_the_id_of_a_removed_state_is_not_given_out_while_examples_or_demonstrations_mention_it() -> None:
    changed = edits.remove_state(project(), AGENT, "goto", "left")
    changed, new = edits.add_state(changed, AGENT, "goto", Basic("RotateLeft"), "left")
    assert new == "left-2"
    assert (
        edits.add_state(
            edits.without_examples(changed, AGENT, "goto"), AGENT, "goto", Basic("Forward"), "left"
        )[1]
        == "left-3"
    )


def test_demonstrations_remember_what_a_removed_state_was() -> None:
    before = project()
    left = before.library(AGENT).get("goto").state("left")
    assert before.demonstrations[0].mentions("left")
    changed = edits.remove_state(before, AGENT, "goto", "left")
    assert changed.demonstrations[0].removed == (left,)
    changed = edits.remove_state(changed, AGENT, "forage", "approach")
    assert changed.demonstrations[0].removed == (left,)  # it taught another behavior


def test_examples_of_a_removed_state_cannot_be_enabled() -> None:
    changed = edits.remove_state(project(), AGENT, "goto", "left")
    with pytest.raises(EditError, match="goto has no state 'left'"):
        edits.enable_examples(changed, AGENT, "goto", ["3"])


def test_start_stays() -> None:
    for act in (
        lambda: edits.remove_state(project(), AGENT, "goto", START),
        lambda: edits.set_content(project(), AGENT, "goto", START, Basic("Forward")),
        lambda: edits.move_state(project(), AGENT, "goto", START, 2),
        lambda: edits.bind_state(project(), AGENT, "goto", START, "target", None),
    ):
        with pytest.raises(EditError):
            act()


def test_states_are_renamed_noted_and_moved() -> None:
    changed = edits.rename_state(project(), AGENT, "goto", "left", "turn")
    changed = edits.note_state(changed, AGENT, "goto", "left", "to the left")
    changed = edits.move_state(changed, AGENT, "goto", "left", 0)
    goto = changed.library(AGENT).get("goto")
    assert goto.states[1] == State("left", Basic("RotateLeft"), "turn", "to the left")
    assert goto.states[0].id == START


def test_a_slot_is_bound_and_opened_again() -> None:
    opened = edits.bind_state(project(), AGENT, "forage", "approach", "target", None)
    assert opened.library(AGENT).get("forage").state("approach").content == Nested("goto")
    assert edits.bind_state(opened, AGENT, "forage", "approach", "target", Ground("nearest-box")) == project()


def test_an_unknown_state_is_named_with_those_there_are() -> None:
    with pytest.raises(
        EditError, match=r"goto has no state 'lef'; there are: 'start' \(Start\), 'forward' \(forward\)"
    ):
        edits.rename_state(project(), AGENT, "goto", "lef", "x")


# ----------------------------------------------------------------------------------------------- copying


def test_states_are_copied_into_another_automaton_with_rules_between_them_and_features_tested() -> None:
    before, into = edits.add_automaton(project(), AGENT, "hunt")
    changed, copies = edits.copy_states(
        before, (AGENT, "forage"), [START, "wander", "approach"], (AGENT, into)
    )
    hunt = changed.library(AGENT).get(into)
    assert copies == {"wander": "wander", "approach": "approach"}
    assert [(rule.source, rule.target) for rule in hunt.rules] == [
        (START, "wander"),
        ("wander", "approach"),
        ("approach", "wander"),
    ]
    assert [use.shown for use in hunt.features] == ["SeesABox", "Ground"]
    assert not [p for p in check(changed, vocabulary()) if p.severity == "error"]


def test_features_that_the_other_automaton_has_already_are_used() -> None:
    before, into = edits.add_automaton(project(), AGENT, "hunt")
    sees = before.library(AGENT).get("forage").feature("sees").source
    before, feature = edits.add_feature(before, AGENT, into, sees, "box in sight")
    changed, _ = edits.copy_states(before, (AGENT, "forage"), ["wander", "approach"], (AGENT, into))
    guards = [rule.guard for rule in changed.library(AGENT).get(into).rules]
    assert when(Equals(feature, 0.0)) in guards


def test_duplicates_in_the_same_automaton_leave_as_the_originals_do() -> None:
    changed, copies = edits.copy_states(project(), (AGENT, "forage"), ["approach"], (AGENT, "forage"))
    new = copies["approach"]
    forage = changed.library(AGENT).get("forage")
    assert new == "approach-2"
    assert [(rule.id, rule.target) for rule in forage.rules_of(new)] == [("6", "fetch"), ("7", "wander")]
    assert forage.rules_of("wander") == project().library(AGENT).get("forage").rules_of("wander")


def test_what_a_tree_learned_comes_along_as_rules_that_do_the_same_once() -> None:
    root = Branch(Equals("sees", 1.0), Leaf((0.0, 3.0)), Leaf((4.0, 0.0)), (4.0, 3.0))
    tree = Tree(("wander", "approach"), root)
    before = edits.remove_rules_of(project(), AGENT, "forage", "wander")
    before = edits.set_learned(before, AGENT, "forage", {"wander": tree}, "")
    before, into = edits.add_automaton(before, AGENT, "hunt")
    for learned in (before, edits.author_learned(before, AGENT, "forage", "wander")):
        changed, _ = edits.copy_states(learned, (AGENT, "forage"), ["wander", "approach"], (AGENT, into))
        hunt = changed.library(AGENT).get(into)
        sees = hunt.features[0].id
        assert [(rule.guard, rule.target) for rule in hunt.rules_of("wander")] == [
            (when(Equals(sees, 1.0)), "approach"),
            ((Condition(Equals(sees, 1.0), wanted=False),), "wander"),
        ]
        assert not hunt.learned
        assert changed.library(AGENT).get("forage") == learned.library(AGENT).get("forage")


def test_copied_rules_of_start_lead_to_the_copies() -> None:
    changed, copies = edits.copy_states(project(), (AGENT, "forage"), [START, "wander"], (AGENT, "forage"))
    leaving = changed.library(AGENT).get("forage").rules_of(START)
    assert [rule.target for rule in leaving] == ["wander", copies["wander"]]


def test_states_cannot_be_copied_where_their_behavior_is_not() -> None:
    with pytest.raises(EditError, match="no behavior with the id 'wander'"):
        edits.copy_states(project(), (AGENT, "forage"), ["wander"], (GROUP, "control"))
    with pytest.raises(EditError, match="recursion is not permitted"):
        edits.copy_states(project(), (AGENT, "forage"), ["approach"], (AGENT, "goto"))


def test_a_copy_bound_to_a_parameter_that_its_new_automaton_lacks_is_told_by_the_check() -> None:
    held = Nested("goto", {"target": Parameter("where")})
    before = edits.set_parameters(project(), AGENT, "fetch", ["where"])
    before = edits.set_content(before, AGENT, "fetch", "home", held)
    changed, _ = edits.copy_states(before, (AGENT, "fetch"), ["home"], (AGENT, "forage"))
    messages = [p.message for p in check(changed, vocabulary()) if p.severity == "error"]
    assert any("bound to parameter 'where', which forage lacks" in message for message in messages)


def test_rules_keep_guard_and_probability_when_copied() -> None:
    changed, copies = edits.copy_states(project(), (AGENT, "wander"), ["forward", "left"], (AGENT, "wander"))
    rules = changed.library(AGENT).get("wander").rules
    assert Rule("6", copies["forward"], (), copies["left"], 0.05) in rules
    assert Rule("7", copies["forward"], (), "right", 0.05) in rules
