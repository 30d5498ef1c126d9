"""Flags: traces worked out by hand."""

import pytest

from app.core.automaton import START, Automaton
from app.core.features import FeatureUse, FlagUp, Sense
from app.core.hierarchy import Hierarchy
from app.core.vocabulary import DONE, FAILED, FINISHED
from tests.fakes import DONE_UP, HOLDS, SEES, Play, agents, inner, no, one_agent, rules, types_of, yes
from tests.samples import GROUP, automaton, flag, nested, state

#: Walks until it sees a box; then it is done, in Start for the rest of the tick.
SEEK = automaton(
    "seek",
    state("walk", "Forward"),
    flag("found"),
    features=(SEES,),
    rules=rules((START, (), "walk"), ("walk", yes("sees"), "found")),
)
#: Seeks, and rests once that is done.
OUTING = automaton(
    "outing",
    nested("seek", "seek"),
    state("rest", "RotateLeft"),
    features=(DONE_UP, HOLDS),
    rules=rules((START, (), "seek"), ("seek", yes("done"), "rest"), ("rest", yes("holds"), "seek")),
)
#: Seeks, and does not care.
ENDLESS = automaton("endless", nested("seek", "seek"), features=(DONE_UP,), rules=rules((START, (), "seek")))


def test_the_parent_sees_a_flag_from_its_next_tick_on() -> None:
    play = one_agent(SEEK, OUTING, top="outing")
    play.senses.feature_is("SeesABox", 1.0, since=1)
    assert play.trace("a", 3) == ["seek/walk", "seek/start", "rest"]


def test_a_flag_stays_up_until_the_parent_changes_state_while_the_child_runs_again_from_start() -> None:
    play = one_agent(SEEK, ENDLESS, top="endless")
    play.senses.feature_is("SeesABox", 1.0, since=1)
    play.senses.feature_is("SeesABox", 0.0, since=2)
    seen = [(play.sees("a", FlagUp(DONE)), *play.does(), play.states("a")) for _ in range(5)]
    assert seen == [
        (0.0, "Forward", "seek/walk"),
        (0.0, "", "seek/start"),
        (1.0, "Forward", "seek/walk"),
        (1.0, "Forward", "seek/walk"),
        (1.0, "Forward", "seek/walk"),
    ]


def test_a_flag_falls_when_the_parent_changes_state_and_comes_back() -> None:
    play = one_agent(SEEK, OUTING, top="outing")
    play.senses.feature_is("SeesABox", 1.0, since=1)
    play.senses.feature_is("SeesABox", 0.0, since=2)
    play.senses.feature_is("IsAttached", 1.0, since=3)
    assert play.trace("a", 5) == ["seek/walk", "seek/start", "rest", "seek/walk", "seek/walk"]
    assert play.sees("a", FlagUp(DONE)) == 0.0


def test_a_flag_falls_when_the_parent_goes_to_another_state_with_the_same_behavior() -> None:
    twice = automaton(
        "twice",
        nested("first", "seek"),
        nested("second", "seek"),
        features=(DONE_UP,),
        rules=rules((START, (), "first"), ("first", yes("done"), "second"), ("second", yes("done"), "first")),
    )
    play = one_agent(SEEK, twice, top="twice")
    play.senses.feature_is("SeesABox", 1.0, since=1)
    play.senses.feature_is("SeesABox", 0.0, since=2)
    assert play.trace("a", 5) == ["first/walk", "first/start", "second/walk", "second/walk", "second/walk"]


def test_a_flag_rises_on_the_automaton_that_holds_the_state_and_no_further() -> None:
    play = one_agent(SEEK, ENDLESS, top="endless")
    play.senses.feature_is("SeesABox", 1.0, since=1)
    play.trace("a", 2)
    top = play.run("a")
    assert top.child is not None
    assert (top.flags, top.child.flags) == (set(), {DONE})


def test_flags_climb_one_level_a_tick() -> None:
    middle = automaton(
        "middle",
        nested("seek", "seek"),
        flag("passed", FAILED),
        features=(DONE_UP,),
        rules=rules((START, (), "seek"), ("seek", yes("done"), "passed")),
    )
    top = automaton(
        "top",
        nested("middle", "middle"),
        state("rest", "RotateLeft"),
        features=(FeatureUse("failed", FlagUp(FAILED)),),
        rules=rules((START, (), "middle"), ("middle", yes("failed"), "rest")),
    )
    play = one_agent(SEEK, middle, top, top="top")
    play.senses.feature_is("SeesABox", 1.0, since=1)
    assert play.trace("a", 4) == ["middle/seek/walk", "middle/seek/start", "middle/start", "rest"]


def test_several_flags_can_be_up_at_once_and_are_told_apart() -> None:
    signal = automaton(
        "signal",
        flag("red", "red"),
        flag("green", "green"),
        features=(SEES,),
        rules=rules((START, no("sees"), "red"), (START, yes("sees"), "green")),
    )
    outer = automaton("outer", nested("signal", "signal"), rules=rules((START, (), "signal")))
    play = one_agent(signal, outer, top="outer")
    play.senses.feature_is("SeesABox", 1.0, since=1)
    play.tick()
    assert [play.sees("a", FlagUp(name)) for name in ("red", "green")] == [1.0, 0.0]
    play.tick()
    assert [play.sees("a", FlagUp(name)) for name in ("red", "green")] == [1.0, 1.0]


def test_no_flag_is_up_in_start_and_under_a_basic_behavior() -> None:
    play = one_agent(OUTING, SEEK, top="outing")
    assert play.sees("a", FlagUp(DONE)) == 0.0
    play = one_agent(automaton("walk", state("on", "Forward"), rules=rules((START, (), "on"))), top="walk")
    play.tick()
    assert play.sees("a", FlagUp(DONE)) == 0.0


def test_a_top_automaton_without_a_controller_lowers_its_flags_one_tick_later() -> None:
    play = one_agent(SEEK, top="seek")
    play.senses.feature_is("SeesABox", 1.0, since=1)
    play.senses.feature_is("SeesABox", 0.0, since=2)
    shown = []
    for _ in range(4):
        play.tick()
        shown.append(play.shown("a"))
    assert shown == [set(), {DONE}, set(), set()]


def test_finished_falls_after_one_tick_where_there_is_no_controller() -> None:
    finish = automaton(
        "finish",
        state("end", "ReleaseBoxAndFinish"),
        features=(SEES,),
        rules=rules((START, no("sees"), "end")),
    )
    play = one_agent(finish, top="finish")
    play.senses.feature_is("SeesABox", 1.0, since=1)
    play.tick()
    assert play.shown("a") == {DONE, FINISHED}
    play.tick()
    assert play.shown("a") == set()


def test_a_basic_behavior_that_an_agent_runs_directly_raises_its_flag_once() -> None:
    play = one_agent(top="ReleaseBox")
    assert play.does(1) == ["ReleaseBox"]
    assert play.shown("a") == {DONE}
    assert play.does(2) == ["", ""]
    assert play.shown("a") == set()


# --------------------------------------------------------------------------------------- under a controller


def group_of_two(*automata: Automaton, group: Automaton) -> Play:
    """A group ``g`` of ``a`` and ``b`` that begins with the automaton *group*."""
    play = Play(Hierarchy((inner("g", GROUP, *agents("a", "b")),)), types_of(*automata, group=(group,)))
    play.direct("g", group.name)
    return play


def calling(then: str) -> Play:
    """A group that directs its agents to seek, and goes to state *then* when someone needs help."""
    call = automaton(
        "call",
        state("seek", "seek"),
        state("walk", "Forward"),
        nested("wait", "wait"),
        flag("over"),
        features=(FeatureUse("help", Sense("SomeoneNeedsHelp")),),
        rules=rules((START, (), "seek"), ("seek", yes("help"), then)),
    )
    play = Play(
        Hierarchy((inner("g", GROUP, *agents("a", "b")),)),
        types_of(SEEK, group=(call, automaton("wait", state("walk", "Forward")))),
    )
    play.direct("g", "call")
    play.senses.feature_is("SeesABox", 1.0, agent=0, since=1)
    play.senses.feature_is("SeesABox", 0.0, agent=0, since=2)
    play.senses.group_is("SomeoneNeedsHelp", 1.0, since=3)
    return play


def shown_by(play: Play, node_id: str, ticks: int) -> list[set[str]]:
    """Pass ticks; the flags that a node shows after each."""
    shown = []
    for _ in range(ticks):
        play.tick()
        shown.append(play.shown(node_id))
    return shown


def test_a_directed_behavior_shows_its_flag_until_the_controller_directs_anew() -> None:
    play = calling(then="walk")
    assert shown_by(play, "a", 5) == [set(), {DONE}, {DONE}, set(), set()]
    assert play.run("a").behavior.name == "Forward"


def test_the_others_in_the_group_do_not_show_the_flag() -> None:
    assert shown_by(calling(then="walk"), "b", 5) == [set()] * 5


@pytest.mark.parametrize("then", ["over", "wait"])
def test_a_directed_behavior_shows_its_flag_until_the_controller_changes_state_even_if_it_directs_nothing(
    then: str,
) -> None:
    play = calling(then)
    play.trace("a", 3)
    directed = play.run("a")
    assert play.shown("a") == {DONE}
    play.tick()
    assert play.states("g") in {START, "wait/start"}
    assert play.shown("a") == set()
    assert play.run("a") is directed
    assert play.states("a") == "walk"


def test_a_flag_raised_in_the_tick_in_which_the_controller_changes_state_stays_up() -> None:
    play = calling(then="wait")
    play.senses.feature_is("SeesABox", 1.0, agent=1, since=3)
    play.senses.feature_is("SeesABox", 0.0, agent=1, since=4)
    assert shown_by(play, "b", 5) == [set(), set(), set(), {DONE}, {DONE}]


def test_finished_stays_up_until_the_agent_is_directed_anew() -> None:
    finish = automaton("finish", state("end", "ReleaseBoxAndFinish"), rules=rules((START, (), "end")))
    call = automaton("call", state("finish", "finish"), state("walk", "Forward"), flag("over"))
    play = group_of_two(finish, group=call)
    play.tick(picks={"g": "finish"}, taught=["g"])
    assert play.shown("a") == {DONE, FINISHED}
    play.tick(picks={"g": "over"}, taught=["g"], still=["a", "b"])
    assert play.shown("a") == {FINISHED}
    play.tick(picks={"g": "walk"}, taught=["g"])
    assert play.shown("a") == set()


@pytest.mark.parametrize("name", ["ReleaseBox", "ReleaseBoxAndFinish", "Done"])
def test_derived_flag_raisers_only_direct_and_do_not_raise_the_controllers_own_flags(name: str) -> None:
    play = group_of_two(group=automaton("call", state("end", name), rules=rules((START, (), "end"))))
    assert [action.behavior for action in play.tick()] == [name, name]
    assert play.states("g") == "end"
    assert play.shown("g") == set()
    assert DONE in play.shown("a")
    assert play.tick() == []
    assert play.states("g") == "end"
