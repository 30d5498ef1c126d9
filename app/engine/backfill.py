"""Features added after demonstrating: their values are read from the moments that the examples were recorded in."""

from collections.abc import Mapping
from dataclasses import dataclass

from ..core.actor import Actor, Run
from ..core.automaton import Automaton
from ..core.edits.examples import set_values
from ..core.errors import UnderstudyError
from ..core.examples import Example, Moment
from ..core.project import Project
from ..sim.engine import Start
from ..sim.reference import ReferenceEngine
from ..sim.scenario import Scenario
from .recording import Values, on_entry, seen


@dataclass(frozen=True, slots=True)
class Filled:
    """What came of it.

    Attributes:
        project: With the values that could be read.
        missed: Example id -> why its moment does not tell.
    """

    project: Project
    missed: Mapping[str, str]


def fill_values(project: Project, scenario: Scenario, type_name: str, automaton_id: str) -> Filled:
    """Give every example the values of the automaton's features that it lacks."""
    automaton = project.library(type_name).get(automaton_id)
    wanted = [use.id for use in automaton.features]
    found: dict[str, Values] = {}
    missed: dict[str, str] = {}
    for example in project.examples_of(type_name, automaton_id):
        lacking = [feature_id for feature_id in wanted if feature_id not in example.values]
        if lacking:
            try:
                values = read_values(project, scenario, automaton, example)
            except UnderstudyError as error:
                missed[example.id] = str(error)
            else:
                found[example.id] = {feature_id: values[feature_id] for feature_id in lacking}
    return Filled(set_values(project, type_name, automaton_id, found) if found else project, missed)


def read_values(project: Project, scenario: Scenario, automaton: Automaton, example: Example) -> Values:
    """All of the automaton's features as they were when *example* was recorded.

    Raises:
        UnderstudyError: The moment is not stored, or no longer fits the project.
    """
    moment = project.moments.get(example.snapshot)
    if moment is None:
        raise UnderstudyError(f"example {example.id}: the moment it was recorded in is not stored")
    engine = engine_at(project, scenario, moment)
    actor = engine.machine.actors.get(example.node)
    run = _run_of(actor, automaton)
    if actor is None or run is None:
        raise UnderstudyError(
            f"example {example.id}: {example.node!r} does not run {automaton.name!r} in its moment"
        )
    values = seen(engine.machine, engine.senses, actor, run, automaton)
    if not example.continuation:
        return values
    return on_entry(engine.machine, actor, automaton, automaton.state(example.label), values)


def engine_at(project: Project, scenario: Scenario, moment: Moment) -> ReferenceEngine:
    """A world as it was in *moment*, with every node doing what it did.

    Raises:
        UnderstudyError: The moment is of another scenario or arm, or no longer fits it.
    """
    if moment.scenario != scenario.name:
        raise UnderstudyError(f"the moment is of scenario {moment.scenario!r}, not {scenario.name!r}")
    forest = project.arm(moment.arm).forest()
    types = project.types_with(scenario.vocabulary)
    engine = ReferenceEngine(Start(scenario, scenario.settle(moment.parameters), forest, types, seed=0))
    engine.restore(moment.world, moment.machine)
    return engine


def _run_of(actor: Actor | None, automaton: Automaton) -> Run | None:
    run = None if actor is None else actor.run
    is_it = run is not None and isinstance(run.behavior, Automaton) and run.behavior.id == automaton.id
    return run if is_it else None
