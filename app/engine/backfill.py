"""Features added after demonstrating: their values are read from the moments that the examples were recorded in."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

from ..core.actor import Actor, Run
from ..core.automaton import Automaton
from ..core.edits.examples import set_values
from ..core.errors import UnderstudyError
from ..core.examples import Example, Moment
from ..core.features import FlagUp, TicksInState
from ..core.hierarchy import Hierarchy
from ..core.project import Project
from ..sim.engine import Start
from ..sim.reference import ReferenceEngine
from ..sim.scenario import Scenario
from .moments import FOREST, forest_hash
from .plan import some
from .recording import Values, on_entry, seen


@dataclass(frozen=True, slots=True)
class Filled:
    """What came of it.

    Attributes:
        project: With the values that could be read.
        missed: Example id -> why its moment does not tell all that the example lacks.
        found: Example id -> the values that could be read.
    """

    project: Project
    missed: Mapping[str, str]
    found: Mapping[str, Values] = field(default_factory=dict)


def fill_values(
    project: Project,
    scenario: Scenario,
    type_name: str,
    automaton_id: str,
    cancelled: Callable[[], bool] = lambda: False,
) -> Filled:
    """Give every example the values of the automaton's features that it lacks, as far as its moment tells them.

    Args:
        cancelled: Asked between examples; if it returns true, the others are left as they are.
    """
    automaton = project.library(type_name).get(automaton_id)
    moments = _Moments(project, scenario)
    found: dict[str, Values] = {}
    missed: dict[str, str] = {}
    for example in project.examples_of(type_name, automaton_id):
        if cancelled():
            break
        values: dict[str, float] = {}
        for use in automaton.features:
            if use.id not in example.values:
                try:
                    values |= moments.values(replace(automaton, features=(use,)), example)
                except UnderstudyError as error:
                    missed[example.id] = str(error)
        if values:
            found[example.id] = values
    return Filled(set_values(project, type_name, automaton_id, found) if found else project, missed, found)


class _Moments:
    """Worlds as they were; the last one is kept, since the examples of a pick share theirs."""

    def __init__(self, project: Project, scenario: Scenario) -> None:
        self._project = project
        self._scenario = scenario
        self._kept: tuple[str, ReferenceEngine] | None = None

    def values(self, automaton: Automaton, example: Example) -> Values:
        """The automaton's features as they were when *example* was recorded."""
        engine = self._engine(example)
        actor = engine.machine.actors.get(example.node)
        run = _run_of(actor, automaton)
        if actor is None or run is None:
            raise UnderstudyError(
                f"example {example.id}: {example.node!r} does not run {automaton.name!r} in its moment"
            )
        if not example.continuation:
            _refuse_lost_place(automaton, example, run)
            return seen(engine.machine, engine.senses, actor, run, automaton)
        if not automaton.has_state(example.label):
            raise UnderstudyError(f"example {example.id}: its state {example.label!r} is gone")
        values = seen(engine.machine, engine.senses, actor, run, automaton)
        return on_entry(engine.machine, actor, automaton, automaton.state(example.label), values)

    def _engine(self, example: Example) -> ReferenceEngine:
        if self._kept is None or self._kept[0] != example.snapshot:
            moment = self._project.moments.get(example.snapshot)
            if moment is None:
                raise UnderstudyError(f"example {example.id}: the moment it was recorded in is not stored")
            self._kept = example.snapshot, engine_at(self._project, self._scenario, moment)
        return self._kept[1]


def _refuse_lost_place(automaton: Automaton, example: Example, run: Run) -> None:
    """Flags and ticks in a state that is gone, or holds something else now, cannot be told any more."""
    untold = [use.shown for use in automaton.features if isinstance(use.source, FlagUp | TicksInState)]
    if run.state != example.source and untold:
        raise UnderstudyError(
            f"example {example.id}: the state {example.source!r} is gone or holds something else now, so its moment does "
            f"not tell: {some(untold)}"
        )


def engine_at(project: Project, scenario: Scenario, moment: Moment) -> ReferenceEngine:
    """A world as it was in *moment*, with every node doing what it did.

    Raises:
        UnderstudyError: The moment is of another scenario or forest, or no longer fits it.
    """
    if moment.scenario != scenario.name:
        raise UnderstudyError(f"the moment is of scenario {moment.scenario!r}, not {scenario.name!r}")
    types = project.types_with(scenario.vocabulary)
    settled = scenario.settle(moment.parameters)
    engine = ReferenceEngine(Start(scenario, settled, _forest(project, moment), types, seed=0))
    engine.restore(moment.world, moment.machine)
    return engine


def _forest(project: Project, moment: Moment) -> Hierarchy:
    """The forest that the moment was taken of: its arm's, or that of an arm with the very same one."""
    wanted = moment.machine.get(FOREST)
    for arm in sorted(project.arms, key=lambda arm: arm.name != moment.arm):
        forest = arm.forest()
        if forest_hash(forest) == wanted:
            return forest
    raise UnderstudyError(f"the moment is of arm {moment.arm!r}, whose nodes are others now")


def _run_of(actor: Actor | None, automaton: Automaton) -> Run | None:
    run = None if actor is None else actor.run
    is_it = run is not None and isinstance(run.behavior, Automaton) and run.behavior.id == automaton.id
    return run if is_it else None
