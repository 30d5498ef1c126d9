"""A test of fifty foragers, watched for what they leave, passes in real time on the plain engine."""

from pathlib import Path
from time import process_time

import pytest

from app.core.storage import load
from app.engine.commands import Teach
from app.engine.commands import Test as LearnAndTest
from app.engine.session import Session
from app.engine.snapshots import Mode
from app.sim.scenarios import shipped

FORAGING = Path(__file__).parents[2] / "projects" / "foraging"
TICKS = 120


@pytest.mark.parametrize("automaton", ["goto", "forage"])
def test_a_test_of_fifty_agents_passes_sixty_ticks_a_second(automaton: str) -> None:
    project = load(FORAGING)
    session = Session(project, shipped("foraging"), "independent", settings={"engine": "reference"})
    parameters = project.library("agent").get(automaton).parameters
    session.send(Teach("agent", automaton, ("agent-1",), dict.fromkeys(parameters, "deposit")))
    session.send(LearnAndTest())
    assert session.advance(5).mode is Mode.TESTING
    began = process_time()
    session.pass_ticks(TICKS)
    rate = TICKS / (process_time() - began)
    print(f"{automaton}: {rate:.0f} ticks a second")
    assert rate >= 60.0
