"""A scenario that fails stops the world and keeps the project; a reset goes on."""

from dataclasses import replace

import pytest

from app.core.automaton import Basic, Nested
from app.core.edits import add_feature, add_state, replace_rule
from app.core.errors import UnderstudyError
from app.core.features import Sense
from app.core.project import Project, Value
from app.engine.commands import Pause, Pick, Play, Reset, Step, UndoPick, UseArm
from app.engine.session import Session
from app.engine.snapshots import Refused, Snapshot
from app.sim.scenario import FeatureKind, Scenario, World
from tests.corridor import corridor, project
from tests.driver import UNCOMPILED, Driver
from tests.samples import automaton, state


def broken(tick: int = 3) -> Session:
    """A session whose world breaks in a tick, in a lesson."""
    settings: dict[str, Value] = {"world.breaks": tick, **UNCOMPILED}
    session = Driver().teach("agent-1", "Shuttle").session
    session.send(UseArm("alone", settings))
    return session


def told(session: Session) -> list[str]:
    return [event.message for event in session.events() if isinstance(event, Refused)]


def test_a_scenario_that_raises_stops_the_world_and_names_function_and_line() -> None:
    session = broken()
    session.send(Play())
    snapshot = session.advance(10)
    (message,) = told(session)
    assert snapshot.failure.startswith("scenario 'corridor', after_tick, go_wrong in corridor.py, line ")
    assert message == f"{snapshot.failure}. The world stands still; reset it to go on."
    assert "ZeroDivisionError" in message
    assert (snapshot.speed, session.playing) == (0.0, False)


def test_a_failed_world_stands_still() -> None:
    session = broken()
    tick = session.advance(10).tick
    assert session.advance(10).tick == tick
    assert len(told(session)) == 1


@pytest.mark.parametrize("command", [Play(), Play(None), Step()])
def test_time_cannot_go_on_in_a_failed_world(command: Play | Step) -> None:
    session = broken()
    session.advance(10)
    told(session)
    session.send(command)
    (message,) = told(session)
    assert message.startswith("the world stands still: scenario 'corridor'")
    assert message.endswith("Reset it to go on")
    session.send(Pause())
    assert told(session) == []


def test_a_failure_keeps_the_project_and_all_that_was_taught() -> None:
    driver = Driver(breaks=3).teach("agent-1", "Shuttle").pick("up").advance(2).pick("down")
    before = driver.session.project
    driver.session.advance(5)
    assert driver.session.project is before
    driver.session.events()
    assert driver.undo().taught == ["start>up", "up>up+"]


def test_a_reset_goes_on_and_forgets_the_failure() -> None:
    session = broken()
    session.advance(10)
    session.send(Reset())
    assert session.snapshot().failure == ""
    assert session.advance(3).tick == 3
    assert session.advance(5).failure != ""


def test_another_arm_goes_on_and_forgets_the_failure() -> None:
    session = broken()
    session.advance(10)
    session.send(UseArm("groups", UNCOMPILED))
    assert session.advance(10).failure == ""


def test_a_world_that_cannot_be_shown_stops_and_the_last_one_that_could_is_shown() -> None:
    driver = Driver(spoils=3)
    snapshot = driver.session.advance(3)
    assert snapshot.failure == ""
    snapshot = driver.session.advance(1)
    assert "column 'x' holds finite numbers, but entry 0 is inf" in snapshot.failure
    assert snapshot.world["x"] == (3.0, 13.0, 50.0)
    assert len(told(driver.session)) == 1
    assert driver.session.snapshot().failure == snapshot.failure
    assert told(driver.session) == []


def test_a_pick_in_a_world_that_cannot_be_kept_is_refused() -> None:
    plain = automaton("Plain", state("up", "Up"))
    driver = Driver(project(plain), spoils=2).teach("agent-1", "Plain").advance(2)
    driver.session.pass_ticks(1)
    driver.session.send(Pick("agent-1", "up"))
    assert "column 'x' holds finite numbers" in told(driver.session)[0]
    assert driver.session.project.examples_of("agent", "Plain") == ()


def test_a_world_whose_reset_fails_is_refused_and_the_old_one_goes_on() -> None:
    made = Scenario("fragile", "Fragile", corridor.parameters, corridor.kinds)

    @made.behavior("Up")
    def up(world: World, me: int) -> None:
        """Do nothing."""

    @made.reset
    def reset(world: World) -> None:
        """Break for seed 13."""
        world.x[0] = 1.0 / (world.clock[0] - 13)

    driver = Driver(_with_top("Up"), scenario=made).advance(2)
    assert "ZeroDivisionError" in driver.refused(Reset(13))
    assert driver.advance().snapshot.tick == 3


def _with_top(top: str) -> Project:
    made = project()
    return replace(made, arms=(replace(made.arms[0], top=top),))


def test_a_feature_that_fails_during_a_pick_refuses_the_pick() -> None:
    made = Scenario("fragile", "Fragile", corridor.parameters, corridor.kinds)

    @made.feature("Place", FeatureKind.CONTINUOUS)
    def place(world: World, me: int) -> float:
        """Fail from tick 2 on."""
        return 1.0 / float(max(0, 2 - world.clock[2]))

    @made.behavior("Up")
    def up(world: World, me: int) -> None:
        """Do nothing."""

    @made.reset
    def reset(world: World) -> None:
        """Nothing to put anywhere."""

    driver = Driver(scenario=made).teach("agent-1", "Shuttle").pick("up").advance(2)
    assert "feature 'Place', place in " in driver.refused(Pick("agent-1", "up"))
    assert driver.advance().snapshot.failure == ""
    assert driver.undo().taught == []


def test_a_binding_that_is_found_open_in_a_tick_stops_the_world() -> None:
    held, _ = add_state(project(), "agent", "Signal", Basic("Toward"), "go")
    rules = held.library("agent").get("Signal").rules
    held = replace_rule(held, "agent", "Signal", rules[0].id, target="go")
    driver = Driver(held).teach("agent-1", "Shuttle").pick("signal")
    driver.session.advance(2)
    assert "'target' of state 'go' of 'Signal' is open" in driver.session.snapshot().failure


def test_a_feature_that_the_scenario_lacks_refuses_the_pick() -> None:
    held, _ = add_feature(project(), "agent", "Shuttle", Sense("Weather"))
    driver = Driver(held).teach("agent-1", "Shuttle")
    assert "there is no feature 'Weather'" in driver.refused(Pick("agent-1", Nested("Signal")))
    driver.refused(UndoPick())


def test_a_session_whose_world_cannot_be_shown_is_not_begun() -> None:
    made = Scenario("nowhere", "Nowhere", corridor.parameters, corridor.kinds)

    @made.reset
    def reset(world: World) -> None:
        """Put an agent nowhere."""
        world.x[0] = 1e308 * 10.0

    with pytest.raises(UnderstudyError, match="finite numbers"):
        Session(_with_top(""), made, "alone", settings=UNCOMPILED)


def test_an_engine_that_fails_for_reasons_of_its_own_can_be_stopped_with_words() -> None:
    session = Driver().session
    session.fail("RuntimeError: out of luck")
    snapshot: Snapshot = session.advance(5)
    assert (snapshot.tick, snapshot.failure) == (0, "RuntimeError: out of luck")
