"""The contract is not foraging's alone: another scenario runs through the same engine."""

import pytest

from app.core.automaton import START, Rule
from app.core.conditions import AtMost, Condition
from app.core.errors import ParameterError, ScenarioError
from app.core.features import FeatureUse, Ground, Operation, Sense, Statistic
from app.core.hierarchy import from_table
from app.core.library import Library, NodeType, Types
from app.sim.engine import Start
from app.sim.reference import ReferenceEngine
from tests.chase import scenario as chase
from tests.samples import automaton, state, when

TYPES = (NodeType("hound"), NodeType("hunter", 1, ("hound",)))

#: Runs after the nearest hare, and shouts where it is near.
HUNT = automaton(
    "Hunt",
    state("run", "Approach", {"target": Ground("nearest hare")}),
    state("shout", "Shout"),
    features=(
        FeatureUse("gap", Sense("Gap", {"a": Ground("nearest hare"), "b": Ground("home")})),
        FeatureUse("third", Sense("Third")),
    ),
    rules=(
        Rule("1", START, (Condition(AtMost("gap", 98.0)),), "run"),
        Rule("2", "run", (Condition(AtMost("gap", 1.0)),), "shout"),
    ),
)
COMMAND = automaton(
    "Command",
    state("hunt", "Hunt"),
    state("home", "Approach", {"target": Ground("home")}),
    features=(FeatureUse("left", Statistic(Operation.MAX, Sense("Third"))),),
    rules=(
        Rule("1", START, (), "hunt"),
        Rule("2", "hunt", when(AtMost("left", 0.0)), "home"),
    ),
)


def engine(top: str = "Command", **parameters: float | str | bool) -> ReferenceEngine:
    libraries = {"hound": Library({"Hunt": HUNT}), "hunter": Library({"Command": COMMAND})}
    forest = from_table((2, 3), ("hunter", "hound"))
    types = Types(TYPES, libraries, chase.vocabulary)
    return ReferenceEngine(Start(chase, chase.settle(parameters), forest, types, seed=3, top=top))


def test_controllers_and_agents_of_any_name_run_in_it() -> None:
    running, states = engine(), set()
    for _ in range(200):
        running.step()
        runs = [running.machine.actors[name].run for name in ("hunter-1", "hunter-2")]
        states |= {run.state for run in runs if run is not None}
    assert states == {"hunt", "home"}
    assert running.measures()["caught"] > 0
    assert running.progressed > 0


@pytest.mark.parametrize(("pace", "paced"), [("walk", 1.0), ("run", 2.0)])
def test_a_choice_reaches_its_functions(pace: str, paced: float) -> None:
    running = engine("Hunt", pace=pace)
    running.step(1)
    assert {abs(drive) for drive in running.world.drive[:6]} == {paced}


def test_a_boolean_reaches_its_functions() -> None:
    running = engine(tired=True)
    running.step(100)
    assert running.measures()["caught"] == 0


def test_a_target_without_referent_gives_the_default_and_idles_behaviors() -> None:
    running = engine(hares=0)
    before = running.frozen_world()["x"]
    running.step(5)
    assert running.frozen_world()["x"] == before


def test_its_entities_are_moved_without_a_rule_of_its_own() -> None:
    running = engine()
    running.move(0, 12.5, 3.0)
    assert (running.world.x[0], running.world.y[0]) == (12.5, 3.0)


def test_its_kinds_follow_the_agents() -> None:
    assert engine(hares=4).spans() == {"agent": range(6), "hare": range(6, 10), "home": range(10, 11)}


def test_its_rule_across_parameters_is_heeded() -> None:
    with pytest.raises(ParameterError, match=r"reach must be below 5\.0, the length of the line"):
        chase.settle({"length": 5.0, "reach": 5.0})


def test_an_entity_that_is_not_there_cannot_be_moved() -> None:
    with pytest.raises(
        ScenarioError, match="there is no entity 11; there are: agent 0 to 5, hare 6 to 9, home 10 to 10"
    ):
        engine(hares=4).move(11, 0.0, 0.0)


@pytest.mark.parametrize("place", [(float("nan"), 0.0), (0.0, float("inf"))])
def test_nothing_is_moved_to_nowhere(place: tuple[float, float]) -> None:
    with pytest.raises(ScenarioError, match="allowed: finite numbers"):
        engine().move(0, *place)
