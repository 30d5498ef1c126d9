"""A test of fifty foragers, watched for what they leave, passes in real time on the plain engine."""

from pathlib import Path

import pytest

from app.core.storage import load
from app.engine.commands import Teach
from app.engine.commands import Test as LearnAndTest
from app.engine.session import Session
from app.engine.snapshots import Mode
from app.sim.scenarios import shipped
from tests.work import calls

FORAGING = Path(__file__).parents[2] / "projects" / "foraging"
TICKS = 120
#: As many as the slowest machine in use passes; most pass ten times as many.
CALLS_A_SECOND = 1_000_000


@pytest.mark.parametrize("automaton", ["goto", "forage"])
def test_a_test_of_fifty_agents_passes_sixty_ticks_a_second(automaton: str) -> None:
    project = load(FORAGING)
    session = Session(project, shipped("foraging"), "independent", settings={"engine": "reference"})
    parameters = project.library("agent").get(automaton).parameters
    session.send(Teach("agent", automaton, ("agent-1",), dict.fromkeys(parameters, "deposit")))
    session.send(LearnAndTest())
    assert session.advance(5).mode is Mode.TESTING
    a_tick = calls(lambda: session.pass_ticks(TICKS)) / TICKS
    print(f"{automaton}: {a_tick:.0f} calls a tick")
    assert 60.0 * a_tick <= CALLS_A_SECOND
