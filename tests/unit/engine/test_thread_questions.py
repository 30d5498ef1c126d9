"""In the background, too, a test stops to ask, and a run is gone back and forth in."""

from collections.abc import Iterator

import pytest

from app.engine.commands import AskMe, GoTo, LetGo, Pick, Play, Teach
from app.engine.commands import Test as LearnAndTest
from app.engine.session import Session
from app.engine.snapshots import Asked
from app.engine.thread import EngineThread
from tests.corridor import corridor, project
from tests.driver import UNCOMPILED
from tests.samples import AGENT


@pytest.fixture
def engine() -> Iterator[EngineThread]:
    thread = EngineThread(lambda _: Session(project(), corridor, "alone", settings=UNCOMPILED))
    yield thread
    thread.close()


def test_a_run_is_gone_to_a_tick_and_stands_there(engine: EngineThread) -> None:
    engine.send(Play(None))
    engine.wait_for(lambda s: s.tick > 300)
    for tick in (120, 2_000, 7):
        ticket = engine.send(GoTo(tick))
        there = engine.wait_for(lambda s, t=ticket: s.acknowledged >= t and s.going_to is None)  # type: ignore[misc]  # mypy gives no type to lambdas with defaults
        assert (there.tick, there.speed) == (tick, 0.0)


def test_a_journey_is_ended_by_play(engine: EngineThread) -> None:
    engine.send(GoTo(10**9))
    engine.wait_for(lambda s: s.going_to == 10**9 and s.tick > 100)
    ticket = engine.send(Play(1.0))
    assert engine.wait_for(lambda s: s.acknowledged >= ticket).going_to is None


def test_a_test_stops_to_ask_and_goes_on_with_the_answer(engine: EngineThread) -> None:
    engine.send(Teach(AGENT, "Shuttle", ("agent-1",)))
    engine.send(Pick("agent-1", "up"))
    engine.send(Play(None))
    engine.wait_for(lambda s: s.tick > 20)
    engine.send(LearnAndTest())
    engine.send(AskMe(("agent-1", "agent-2"), None, 0.5))
    asked = engine.wait_for(lambda s: s.asked is not None)
    assert asked.asked is not None
    assert asked.speed == 0.0
    assert asked.asked in [event for event in engine.events() if isinstance(event, Asked)]
    ticket = engine.send(LetGo())
    other = engine.wait_for(lambda s: s.acknowledged >= ticket and s.asked is not None)
    assert other.asked is not None
    assert other.asked.node == "agent-2"
    engine.send(AskMe())
    assert engine.wait_for(lambda s: s.tick > other.tick).speed is None
