"""A session gives the same whichever engine steps its world; lessons and free runs may alternate."""

from dataclasses import replace

import pytest

from app.core.library import Library
from app.core.project import Arm, LevelTable, Project, Value
from app.engine import keyframes
from app.engine.commands import (
    AskMe,
    GoTo,
    LetGo,
    MoveEntities,
    Others,
    Pick,
    Reset,
    RunArm,
    ShouldNotHaveLeft,
    Step,
    Teach,
    UndoPick,
    UseArm,
)
from app.engine.commands import Test as LearnAndTest
from app.engine.session import Session
from app.engine.snapshots import Asked, Snapshot
from app.sim.scenarios.foraging import scenario
from tests.foragers import control_forage, forage, goto, release, return_with_box, wander
from tests.samples import AGENT, GROUP, TYPES


def foragers() -> Project:
    agents = (
        wander(),
        goto(),
        return_with_box(),
        forage(),
        release(),
        replace(wander(), id="w", name="W", rules=()),
    )
    return Project(
        "Foragers",
        "foraging",
        TYPES,
        libraries={
            AGENT: Library({a.id: a for a in agents}),
            GROUP: Library({a.id: a for a in (control_forage(),)}),
        },
        arms=(
            Arm("alone", LevelTable((6,), (AGENT,)), "Forage"),
            Arm("groups", LevelTable((2, 3), (GROUP, AGENT)), "ControlForage"),
        ),
    )


def hand(engine: str) -> tuple[Project, list[Snapshot]]:
    """Runs, teaches, tests and corrects in turn."""
    settings: dict[str, Value] = {"engine": engine, "world.pullers": 2}
    session = Session(foragers(), scenario, "alone", 5, settings=settings)
    seen = [session.advance(150), session.advance(1)]
    session.send(Teach(AGENT, "w", ("agent-2",), others=Others.RUN))
    for choice, ticks in (("forward", 9), ("left", 20), ("forward", 3), ("right", 4)):
        session.send(Pick("agent-2", choice))
        seen.append(session.advance(ticks))
    session.send(UndoPick())
    session.send(LearnAndTest())
    seen.append(session.advance(40))
    session.send(ShouldNotHaveLeft("agent-1"))
    session.send(Pick("agent-3", "left"))
    seen.append(session.advance(7))
    session.send(RunArm())
    session.send(MoveEntities({0: (50.0, 60.0)}))
    seen += [session.advance(60) for _ in range(3)]
    session.send(Reset(9))
    session.send(Step(3))
    seen.append(session.advance(90))
    session.send(UseArm("groups", settings))
    seen += [session.advance(200), session.advance(2)]
    return session.project, seen


@pytest.mark.slow
def test_a_session_gives_the_same_with_the_compiled_engine_as_with_the_reference() -> None:
    project, seen = hand("reference")
    compiled, as_compiled = hand("compiled")
    assert compiled == project
    for mine, theirs in zip(seen, as_compiled, strict=True):
        assert mine == theirs
    assert len(project.examples_of(AGENT, "w")) >= 6


@pytest.mark.slow
@pytest.mark.parametrize("physics", ["kinematic", "rigid"])
def test_the_past_of_a_compiled_run_is_gone_back_in_exactly(
    physics: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(keyframes, "SPACING", 100)
    monkeypatch.setattr(keyframes, "COMPILED", 2)
    settings: dict[str, Value] = {"engine": "compiled", "world.pullers": 2, "physics": physics}
    session = Session(foragers(), scenario, "groups", 5, settings=settings)
    seen = {0: session.snapshot()}
    for tick in range(50, 801, 50):
        if tick == 450:
            session.send(MoveEntities({0: (50.0, 60.0)}))
        seen[tick] = session.advance(50)
    for tick in (50, 750, 400, 450, 500, 100, 800, 0, 650):
        session.send(GoTo(tick))
        if session.due:
            session.advance(1_000)
        there = session.snapshot()
        if tick == 400:  # the move comes before this tick passes
            assert there.columns["x"][0] == 50.0
        else:
            assert replace(there, acknowledged=0) == replace(seen[tick], acknowledged=0)


def asked(engine: str, ask: AskMe) -> tuple[list[str], Snapshot]:
    """What a test of a taught behavior asks, all of it let go, and what it comes to."""
    session = Session(foragers(), scenario, "alone", 5, settings={"engine": engine})
    session.send(Teach(AGENT, "w", ("agent-2",)))
    for choice, ticks in (("forward", 9), ("left", 20), ("forward", 3), ("right", 4)):
        session.send(Pick("agent-2", choice))
        session.advance(ticks)
    session.send(LearnAndTest())
    session.send(ask)
    goal = session.tick + 200
    session.events()
    while session.tick < goal:
        session.send(LetGo())
        session.advance(goal - session.tick)
    reasons = [event.reason for event in session.events() if isinstance(event, Asked)]
    return reasons, replace(session.snapshot(), acknowledged=0, revision=0)


@pytest.mark.slow
def test_asking_asks_the_same_in_the_compiled_engine_and_makes_no_difference_to_what_comes() -> None:
    everybody = tuple(f"agent-{number}" for number in range(1, 7))
    reasons, end = asked("compiled", AskMe(everybody, 0.9, 0.1))
    assert (reasons, end) == asked("reference", AskMe(everybody, 0.9, 0.1))
    assert len(reasons) >= 6
    assert asked("compiled", AskMe()) == ([], end)
