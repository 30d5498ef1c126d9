from dataclasses import replace

import pytest

from app.cli.naming import all_behaviors, named_behaviors
from app.core.errors import LibraryError
from tests.unit.cli.foraging import project


def test_a_bare_name_means_the_behavior_of_whatever_type_has_it() -> None:
    assert named_behaviors(project(), ["Goto", "ControlForage"]) == [
        ("agent", "Goto"),
        ("group", "ControlForage"),
    ]


def test_a_type_can_be_named_too() -> None:
    assert named_behaviors(project(), ["agent/Wander"]) == [("agent", "Wander")]


def test_a_bare_name_means_those_that_something_can_be_done_with_if_there_are_any() -> None:
    made = project()
    libraries = {**made.libraries, "group": made.library("agent")}
    both = replace(made, libraries=libraries)
    assert named_behaviors(both, ["Goto"]) == [("agent", "Goto"), ("group", "Goto")]
    assert named_behaviors(both, ["Goto"], {("group", "Goto")}) == [("group", "Goto")]
    assert named_behaviors(both, ["agent/Goto"], {("group", "Goto")}) == [("agent", "Goto")]


def test_a_behavior_that_is_named_twice_is_taken_once() -> None:
    assert named_behaviors(project(), ["Goto", "agent/Goto"]) == [("agent", "Goto")]


def test_an_unknown_behavior_is_answered_with_a_near_one() -> None:
    with pytest.raises(
        LibraryError, match=r"no behavior 'Wonder' \(did you mean 'agent/Wander'\?\); there are: agent/"
    ):
        named_behaviors(project(), ["Wonder"])


def test_behaviors_come_after_what_they_hold_and_controllers_last() -> None:
    names = list(all_behaviors(project()))
    assert names.index("agent/Goto") < names.index("agent/ReturnWithBox") < names.index("agent/Forage")
    assert names[-2:] == ["group/ControlForage", "squad/ControlForage2"]
