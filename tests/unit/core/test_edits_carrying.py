"""States copied to another node type hold what is known there by the same name, or bring it along."""

from dataclasses import replace

import pytest

from app.core import edits
from app.core.automaton import Basic, Nested
from app.core.check import check
from app.core.errors import EditError
from app.core.features import Ground
from app.core.library import NodeType
from app.core.project import Project
from tests.samples import AGENT, GROUP, project, vocabulary

ROBOT = "robot"


def with_robots() -> tuple[Project, str]:
    """The project with another type of agents, and an automaton of that without states."""
    before = project()
    before = replace(before, types=(*before.types, NodeType(ROBOT)))
    return edits.add_automaton(before, ROBOT, "hunt")


def carried(before: Project, source: tuple[str, str], states: list[str], into: tuple[str, str]) -> Project:
    return edits.carry_states(before, vocabulary(), source, states, into)[0]


def content(changed: Project, where: tuple[str, str], state_id: str) -> object:
    return changed.library(where[0]).get(where[1]).state(state_id).content


def test_what_the_other_type_lacks_comes_along_with_its_examples_and_all_that_it_holds() -> None:
    before, hunt = with_robots()
    changed = carried(before, (AGENT, "forage"), ["approach", "fetch", "wander"], (ROBOT, hunt))
    assert content(changed, (ROBOT, hunt), "fetch") == Nested("fetch", {})
    assert set(changed.library(ROBOT).automata) == {"hunt", "goto", "fetch", "wander"}
    assert content(changed, (ROBOT, "fetch"), "home") == Nested("goto", {"target": Ground("deposit")})
    assert changed.examples_of(ROBOT, "goto") == project().examples_of(AGENT, "goto")
    original, copy = (changed.library(kind).get("goto") for kind in (AGENT, ROBOT))
    assert copy.learned == original.learned
    assert not [p for p in check(changed, vocabulary()) if p.severity == "error"]


def test_what_is_there_by_the_same_name_is_held_and_nothing_comes_along() -> None:
    before, hunt = with_robots()
    before, own = edits.add_automaton(before, ROBOT, "goto", ["target"])
    changed = carried(before, (AGENT, "forage"), ["approach"], (ROBOT, hunt))
    assert content(changed, (ROBOT, hunt), "approach") == Nested(own, {"target": Ground("nearest-box")})
    assert set(changed.library(ROBOT).automata) == {hunt, own}


def test_a_controller_directs_what_an_agent_holds_and_the_other_way_round() -> None:
    changed = carried(project(), (AGENT, "forage"), ["wander"], (GROUP, "control"))
    assert content(changed, (GROUP, "control"), "wander") == Basic("wander")
    before, top = edits.add_automaton(project(), AGENT, "top")
    changed = carried(before, (GROUP, "control"), ["search"], (AGENT, top))
    assert content(changed, (AGENT, top), "search") == Nested("forage", {})


def test_why_something_cannot_come_along_is_said_and_nothing_changes() -> None:
    before, hunt = with_robots()
    lead, into = edits.add_automaton(before, GROUP, "lead")
    lead, _ = edits.add_state(lead, GROUP, into, Nested("control"))
    with pytest.raises(EditError, match=r"control cannot come along to 'robot': it has no subsidiaries for"):
        carried(lead, (GROUP, into), ["control"], (ROBOT, hunt))
    with pytest.raises(EditError, match=r"'robot' has no behavior 'forage'; it has: "):
        carried(before, (GROUP, "control"), ["search"], (ROBOT, hunt))
    other, _ = edits.add_automaton(before, ROBOT, "goto", ["whither"])
    with pytest.raises(EditError, match="goto of 'robot' has no parameter 'target', unlike that of 'agent'"):
        carried(other, (AGENT, "forage"), ["approach"], (ROBOT, hunt))


def test_transitions_that_test_what_the_other_type_cannot_see_stay_behind_and_it_is_said_what_that_is() -> (
    None
):
    before, made = edits.add_automaton(project(), GROUP, "hand")
    held, where, into = ["wander", "approach", "fetch"], (AGENT, "forage"), (GROUP, made)
    changed = carried(before, where, held, into)
    copied = changed.library(GROUP).get(made)
    assert [use.shown for use in copied.features] == ["done"]
    assert [(rule.source, rule.target) for rule in copied.rules] == [
        ("approach", "fetch"),
        ("fetch", "wander"),
    ]
    assert edits.left_behind(before, vocabulary(), where, held, into) == ("SeesABox", "Ground")
    assert edits.left_behind(before, vocabulary(), where, held, where) == ()


def test_transitions_that_look_through_a_parameter_that_is_not_there_stay_behind() -> None:
    before, made = edits.add_automaton(project(), AGENT, "other")
    where, into = (AGENT, "goto"), (AGENT, made)
    held = [state.id for state in before.library(AGENT).get("goto").states[1:]]
    changed = carried(before, where, held, into)
    assert not changed.library(AGENT).get(made).features
    left = edits.left_behind(before, vocabulary(), where, held, into)
    assert left
    assert set(left) <= {use.shown for use in before.library(AGENT).get("goto").features}
    bound, made = edits.add_automaton(project(), AGENT, "other", ["target"])
    assert edits.left_behind(bound, vocabulary(), where, held, (AGENT, made)) == ()
    assert carried(bound, where, held, (AGENT, made)).library(AGENT).get(made).features
