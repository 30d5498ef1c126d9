"""Commands have tickets; what cannot be obeyed changes nothing and says what is allowed."""

from dataclasses import FrozenInstanceError, replace
from math import inf, nan

import pytest

from app.core.automaton import START, Basic, Nested, RaiseFlag
from app.core.edits import add_state
from app.core.errors import EditError, ParameterError, SessionError
from app.core.features import Parameter
from app.core.project import Project
from app.engine.commands import (
    Command,
    GoTo,
    MoveEntities,
    Pause,
    Pick,
    Play,
    Reset,
    RunArm,
    ShouldNotHaveLeft,
    Step,
    StopAt,
    Teach,
    UndoPick,
    UseArm,
    UseProject,
)
from app.engine.commands import Test as LearnAndTest
from app.engine.session import Session
from app.engine.snapshots import Mode, Refused
from tests.corridor import corridor, project, to
from tests.driver import UNCOMPILED, Driver


def teaching() -> Driver:
    return Driver().teach("agent-1", "Shuttle").pick("up").advance(2)


# ------------------------------------------------------------------------------------------ tickets and snapshots


def test_every_command_has_a_ticket_and_snapshots_echo_the_last() -> None:
    session = Driver().session
    assert [session.send(Pause()) for _ in range(3)] == [1, 2, 3]
    assert session.send(Play(-1.0)) == 4  # also one that is refused
    assert session.snapshot().acknowledged == session.acknowledged == 4


def test_commands_and_snapshots_are_frozen() -> None:
    driver = teaching()
    snapshot = driver.snapshot
    with pytest.raises(FrozenInstanceError):
        snapshot.tick = 7  # type: ignore[misc]  # that is tried
    with pytest.raises(FrozenInstanceError):
        Pick("agent-1", "up").node = "agent-2"  # type: ignore[misc]  # that, too
    driver.advance(3).pick("down").advance()
    assert (snapshot.tick, snapshot.world["x"][0], snapshot.nodes["agent-1"].basic) == (2, 2.0, "Up")


def test_a_snapshot_shows_the_world_the_nodes_and_the_measures() -> None:
    snapshot = Driver(seed=5).advance(3).snapshot
    assert (snapshot.tick, snapshot.seed, snapshot.arm, snapshot.mode) == (3, 5, "alone", Mode.RUNNING)
    assert snapshot.world["x"] == (3.0, 13.0, 50.0)
    assert snapshot.nodes["agent-1"].path == (("Stroll", "up"),)
    assert dict(snapshot.measures) == {"steps": 6.0}


# ------------------------------------------------------------------------------------------------ refused commands


@pytest.mark.parametrize(
    ("command", "message"),
    [
        (Pick("agent-9", "up"), "'agent-9' is not taught or tested now; pick for one of: agent-1"),
        (Pick("agent-2", "up"), "'agent-2' is not taught or tested now; pick for one of: agent-1"),
        (Pick("agent-1", "fly"), "Shuttle has no state 'fly'; there are: 'start' "),
        (Pick("agent-1", Basic("Fly")), "'agent' has no basic behavior 'Fly'; there are: Down, Jump, "),
        (Pick("agent-1", Basic("Toward")), "'target' of Toward is open: pick a target, or a parameter"),
        (Pick("agent-1", Basic("Up", to("lamp"))), "Up has no parameter 'target'; it has: none"),
        (Pick("agent-1", Nested("Dance")), "has no behavior with the id 'Dance'"),
        (Pick("agent-1", Nested("Shuttle")), "recursion is not permitted, but Shuttle holds Shuttle"),
        (Pick("agent-1", RaiseFlag(" ")), "a flag needs a name"),
        (
            Pick("agent-1", Basic("Toward", {"target": Parameter("goal")})),
            "'goal', which has no target now; parameters are: none",
        ),
        (ShouldNotHaveLeft("agent-1"), "Agent 1 has left no state by itself since the test began"),
        (ShouldNotHaveLeft("agent-2"), "'agent-2' is not taught or tested now"),
        (Teach("agent", "Shuttle", ()), "choose at least one agent or controller to teach"),
        (
            Teach("agent", "Shuttle", ("agent-1", "agent-7")),
            "there is no node 'agent-7' in this world; there",
        ),
        (Teach("group", "Lead", ("agent-1",)), "'agent-1' is of type 'agent', but 'group' is being taught"),
        (Teach("agent", "Dance", ("agent-1",)), "there is no behavior with the id 'Dance'; there are: Seek,"),
        (Teach("agent", "Seek", ("agent-1",)), "while teaching, 'target' is open; choose one of: lamp, the"),
        (
            Teach("agent", "Seek", ("agent-1",), {"target": "sun"}),
            "while teaching, 'target' is 'sun'; choose",
        ),
        (
            Teach("agent", "Seek", ("agent-1",), {"target": "first of mine"}),
            "'target' is 'first of mine'; choose",
        ),
        (
            Teach("agent", "Shuttle", ("agent-1",), {"x": "lamp"}),
            "'Shuttle' has no parameter 'x'; there are:",
        ),
        (Play(0.0), "the speed is 0.0; allowed: above 0"),
        (Play(-2.0), "the speed is -2.0; allowed: above 0"),
        (Play(nan), "the speed is nan; allowed: above 0"),
        (Play(inf), "the speed is inf; allowed: above 0"),
        (Step(0), "a step is of 1 tick or more, but it is 0"),
        (Step(-5), "a step is of 1 tick or more, but it is -5"),
        (MoveEntities({99: (0.0, 0.0)}), "there is no entity 99; there are: agent 0 to 1, lamp 2 to 2"),
        (MoveEntities({0: (nan, 0.0)}), "an entity cannot be put at (nan, 0.0)"),
        (UseArm("desert"), "there is no arm 'desert'; there are: 'alone', 'groups', 'squads'"),
        (UseArm("alone", {"world.depth": 3}), "'depth'"),
        (UseArm("alone", {"depth": 3}), "there is no setting 'depth'"),
        (Reset(-1), "a seed is a whole number from 0 to 9,223,372,036,854,775,807, but this one is -1"),
        (UseProject(project(), applied=7), "7 edits are said to be applied; allowed: 0 to 1"),
    ],
    ids=str,
)
def test_what_cannot_be_obeyed_changes_nothing_and_says_what_is_allowed(
    command: Command, message: str
) -> None:
    assert message in teaching().refused(command)


@pytest.mark.parametrize(
    "command", [Pick("agent-1", "up"), ShouldNotHaveLeft("agent-1"), UndoPick(), LearnAndTest()]
)
def test_nothing_can_be_picked_mended_undone_or_tested_when_nothing_is_taught(command: Command) -> None:
    assert Driver().refused(command).startswith("nothing is being taught; choose a behavior and an agent")


def test_a_pick_that_is_refused_does_not_replace_the_one_that_waits() -> None:
    driver = teaching().pick("down")
    driver.refused(Pick("agent-1", "fly"))
    driver.refused(ShouldNotHaveLeft("agent-1"))
    assert driver.taught == ["start>up", "up>up+", "up>down", "down>down+"]
    assert driver.does(2) == ["Down", "Down"]


def test_something_else_than_a_command_is_refused() -> None:
    assert Driver().refused("jump") == "str is not a command"  # type: ignore[arg-type]  # that is tried


def test_a_state_whose_target_is_open_cannot_be_picked() -> None:
    open_state, _ = add_state(project(), "agent", "Shuttle", Basic("Toward"), "go")
    driver = Driver(open_state).teach("agent-1", "Shuttle")
    assert "'target' of state 'go' of 'Shuttle' is open" in driver.refused(Pick("agent-1", "go"))


def test_a_nested_behavior_whose_target_is_open_cannot_be_picked() -> None:
    open_state, _ = add_state(project(), "agent", "Shuttle", Nested("Seek"), "go")
    driver = Driver(open_state).teach("agent-1", "Shuttle")
    assert "'target' of state 'go' of 'Shuttle' is open" in driver.refused(Pick("agent-1", "go"))


@pytest.mark.parametrize("top", ["Dance", "Seek"])
def test_an_arm_whose_roots_cannot_begin_is_refused_and_the_old_one_goes_on(top: str) -> None:
    made = project()
    broken = replace(made.arms[1], name="broken", top=top)
    driver = Driver(replace(made, arms=(*made.arms, broken))).teach("agent-1", "Shuttle").pick("up").advance()
    assert top in driver.refused(UseArm("broken"))
    assert driver.advance().place() == 2.0


def test_running_an_arm_whose_top_is_gone_is_refused_and_the_lesson_goes_on() -> None:
    driver = teaching().edit(lambda made: replace(made, arms=(replace(made.arms[0], top="Dance"),)))
    assert "'Dance'" in driver.refused(RunArm())
    assert driver.mode is Mode.TEACHING


def test_a_session_needs_an_arm_that_can_run() -> None:
    with pytest.raises(EditError, match="there is no arm 'desert'"):
        Session(project(), corridor, "desert", settings=UNCOMPILED)
    with pytest.raises(SessionError, match="has no 'Dance'"):
        Session(_with_top("Dance"), corridor, "alone", settings=UNCOMPILED)
    with pytest.raises(ParameterError, match="seed"):
        Session(project(), corridor, "alone", -1, settings=UNCOMPILED)


def _with_top(top: str) -> Project:
    made = project()
    return replace(made, arms=(replace(made.arms[0], top=top),))


# ------------------------------------------------------------------------------------------------ time and worlds


def test_a_session_begins_paused_with_the_arm_running() -> None:
    driver = Driver()
    assert (driver.session.speed, driver.session.playing, driver.mode) == (0.0, False, Mode.RUNNING)
    assert driver.advance(2).place() == 2.0


def test_a_step_that_has_not_passed_yet_does_not_turn_the_next_play_into_a_pause() -> None:
    session = Driver().session
    session.send(Step(1))
    assert (session.playing, session.snapshot().speed) == (True, 0.0)
    session.send(Step(1))
    assert session.snapshot().speed == 1.0  # two can be stopped between


def test_play_step_and_pause() -> None:
    session = Driver().session
    session.send(Play(2.0))
    assert (session.playing, session.snapshot().speed) == (True, 2.0)
    session.send(Step(3))
    session.send(Step(2))
    assert (session.speed, session.due, session.playing) == (0.0, 5, True)
    session.advance(4)
    assert (session.due, session.playing) == (1, True)
    session.advance(1)
    assert (session.due, session.playing, session.snapshot().speed) == (0, False, 0.0)
    session.send(Step(3))
    session.send(Play(None))
    assert (session.due, session.speed) == (0, None)
    session.send(Pause())
    assert not session.playing


def test_running_an_arm_ends_the_lesson() -> None:
    driver = teaching().run()
    assert (driver.mode, driver.state()) == (Mode.RUNNING, START)
    assert driver.advance(2).view().path == (("Stroll", "up"),)


def test_running_an_arm_without_a_top_behavior_lets_its_roots_idle() -> None:
    driver = Driver(_with_top("")).teach("agent-1", "Shuttle").pick("up").advance().run().advance(3)
    assert (driver.view().behavior, driver.place()) == ("", 1.0)


def test_another_arm_begins_at_once_with_its_own_nodes() -> None:
    driver = teaching().send(UseArm("groups", UNCOMPILED)).advance(2)
    assert (driver.snapshot.arm, driver.snapshot.tick, driver.mode) == ("groups", 2, Mode.RUNNING)
    assert set(driver.snapshot.nodes) == {"group-1", "group-2", "agent-1", "agent-2", "agent-3", "agent-4"}


def test_nodes_of_the_arm_before_cannot_be_taught_any_more() -> None:
    driver = Driver(arm="groups").teach("agent-4", "Shuttle").send(UseArm("alone", UNCOMPILED))
    assert "nothing is being taught" in driver.refused(Pick("agent-4", "up"))
    assert "no node 'agent-4'" in driver.refused(Teach("agent", "Shuttle", ("agent-4",)))


def test_reset_begins_the_world_again_with_the_same_seed_or_another() -> None:
    driver = Driver(length=40.0).advance(5).reset()
    assert (driver.snapshot.tick, driver.snapshot.seed, driver.place()) == (0, 1, 0.0)
    driver.reset(9)
    assert driver.snapshot.seed == 9
    assert driver.advance(60).place() < 40.0  # the settings still hold: it has turned at 40


def test_a_lesson_goes_on_in_the_world_that_begins_again() -> None:
    driver = teaching().reset()
    assert (driver.mode, driver.state(), driver.view().taught) == (Mode.TEACHING, START, True)
    assert driver.advance(2).place(2) == 10.0
    driver.pick("down").undo().undo()
    assert driver.taught == []


def test_a_test_goes_on_in_the_world_that_begins_again() -> None:
    driver = teaching().test().advance(3).reset()
    assert driver.mode is Mode.TESTING
    assert driver.does(2, "agent-2") == ["Up", "Up"]


def test_reset_while_it_learns_begins_the_test_in_the_new_world() -> None:
    driver = teaching()
    driver.session.send(LearnAndTest())
    driver.session.send(Reset())
    assert driver.mode is Mode.LEARNING
    driver.session.settle()
    assert driver.listen().mode is Mode.TESTING
    assert (driver.snapshot.tick, driver.advance().state("agent-2")) == (0, "up")


def test_an_entity_can_be_moved() -> None:
    driver = teaching().send(MoveEntities({1: (42.0, 0.0)}))
    assert driver.place(2) == 42.0


def test_a_refusal_carries_the_ticket_of_its_command() -> None:
    session = Driver().session
    tickets = [session.send(Step(0)), session.send(Pause()), session.send(UndoPick())]
    assert [e.ticket for e in session.events() if isinstance(e, Refused)] == [tickets[0], tickets[2]]


def test_time_stops_before_a_tick_at_any_speed_and_however_many_ticks_are_dealt_out() -> None:
    for speed in (1.0, 16.0, None):
        session = Driver().session
        session.send(Play(speed))
        session.send(StopAt(7))
        assert session.snapshot().stops_at == 7
        session.advance(5)
        assert (session.tick, session.playing) == (5, True)
        session.advance(100)
        snapshot = session.snapshot()
        assert (session.tick, session.playing, snapshot.speed, snapshot.stops_at) == (7, False, 0.0, None)
        session.send(Play(speed))
        session.advance(5)
        assert session.tick == 12


def test_time_stops_on_the_way_to_a_tick_too() -> None:
    session = Driver().session
    session.send(GoTo(9))
    session.send(StopAt(4))
    session.advance(100)
    assert (session.tick, session.playing) == (4, False)


def test_time_stops_now_where_the_tick_is_over() -> None:
    session = Driver().session
    session.send(Play())
    session.advance(5)
    session.send(StopAt(3))
    assert (session.tick, session.playing) == (5, False)


def test_another_speed_leaves_the_stop_alone_and_anything_else_forgets_it() -> None:
    session = Driver().session
    for command in (StopAt(None), Pause(), Step(2), GoTo(9), Reset()):
        session.send(Play())
        session.send(StopAt(session.tick + 4))
        session.send(Play(2.0))
        assert session.snapshot().stops_at == session.tick + 4
        session.send(command)
        assert session.snapshot().stops_at is None
