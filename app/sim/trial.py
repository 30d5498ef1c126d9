"""Whether a scenario's functions keep their promises, found by trying them out in a small world.

What reading cannot show (`app.sim.portable`): a feature that writes, a behavior that writes what is another's or whose
outcome depends on the order of acting, a negative index, state that is kept outside of the columns.
"""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from ..core.chance import draw
from ..core.errors import ScenarioError
from ..core.hierarchy import Hierarchy, from_table
from ..core.project import Value
from ..core.vocabulary import NO_ENTITY, Feature
from .columns import Per
from .failure import broke, failed
from .ranges import allowed, is_value
from .scenario import Scenario, World
from .sensing import WorldSenses
from .world import KEY, TICK, FrozenWorld, begin, empty_world, freeze, thaw

#: Five agents, in two groups of different sizes.
EVERYONE = range(5)


def faults(scenario: Scenario, parameters: Mapping[str, Value] | None = None, ticks: int = 60) -> list[str]:
    """What is found wrong first, or nothing.

    Args:
        parameters: Those that differ from the defaults.
    """
    settled = scenario.settle(parameters or {})
    try:
        once, again = (_Trial(scenario, settled).run(ticks) for _ in range(2))
        if changed := _changed(once, again):
            raise ScenarioError(
                f"scenario {scenario.name!r}: column {changed[0][0]!r} is not the same when a run is repeated; all state "
                "has to be in columns, and all chance has to come from uniform"
            )
    except ScenarioError as error:
        return [str(error)]
    return []


class _Column(list[float]):
    """A column that refuses what a compiled one would silently answer with something else."""

    def __getitem__(self, index: Any) -> Any:
        return super().__getitem__(_refused(index))

    def __setitem__(self, index: Any, value: Any) -> None:
        super().__setitem__(_refused(index), value)


def _refused(index: Any) -> Any:
    if not isinstance(index, slice) and index < 0:
        raise IndexError(f"the index is {index}; allowed: 0 and up")
    return index


class _Trial:
    def __init__(self, scenario: Scenario, parameters: Mapping[str, Value]) -> None:
        self._scenario = scenario
        world = empty_world(scenario, parameters, _forest())
        self._world: World = world._replace(
            **{column.name: _Column(getattr(world, column.name)) for column in scenario.columns}
        )
        begin(self._world, scenario, seed=1)
        self._senses = WorldSenses(scenario, self._world)

    def run(self, ticks: int) -> FrozenWorld:
        """Pass ticks in which all agents do anything."""
        for _ in range(ticks):
            self._sense()
            self._act()
            for name in ("resolve", "kinematics", "after_tick"):
                if name in self._scenario.stages:
                    self._call(name, self._scenario.stages[name])
            self._world.clock[TICK] += 1
            freeze(self._world, self._scenario)  # refuses what a column cannot hold
        return self._seen()

    def _sense(self) -> None:
        """Ask for everything."""
        for name, meaning in self._scenario.targets.items():
            with self._unchanged(f"target {name!r}", meaning):
                for agent in EVERYONE:
                    self._senses.target(name, EVERYONE, agent)
        for name, function in self._scenario.features.items():
            feature, what = self._scenario.vocabulary.features[name], f"feature {name!r}"
            with self._unchanged(what, function):
                for value in self._values(feature):
                    if not is_value(feature, value):
                        raise broke(
                            self._scenario.name,
                            what,
                            function,
                            f"it gave {value!r}; allowed: {allowed(feature)}",
                        )

    @contextmanager
    def _unchanged(self, what: str, function: Callable[..., Any]) -> Iterator[None]:
        """Refuse that the world changes meanwhile."""
        before = self._seen()
        yield
        if changed := _changed(before, self._seen()):
            how = f"it writes {changed[0][0]!r}, but only behaviors and stages write"
            raise broke(self._scenario.name, what, function, how)

    def _values(self, feature: Feature) -> Iterator[float]:
        """What everyone sees, of every target that means somebody."""
        if feature.whose == "group":
            yield from (self._senses.group_feature(feature.name, members) for members in (EVERYONE, range(3)))
            return
        for agent in EVERYONE:
            for targets in self._targets(agent, len(feature.parameters)):
                yield self._senses.feature(feature.name, agent, targets)

    def _targets(self, agent: int, parameters: int) -> list[tuple[int, ...]]:
        """For every target that means somebody, as many of it as there are parameters."""
        if parameters == 0:
            return [()]
        found = (self._senses.target(name, EVERYONE, agent) for name in self._scenario.targets)
        return [(entity,) * parameters for entity in found if entity != NO_ENTITY]

    def _act(self) -> None:
        """Let every agent do something, in both orders."""
        for agent in EVERYONE:
            self._world.drive[agent] = self._world.turn[agent] = 0.0
        acts = [act for agent in EVERYONE if (act := self._chosen(agent)) is not None]
        before = self._seen()
        for act in reversed(acts):
            self._perform(*act)
        backward = self._seen()
        thaw(self._world, before, self._scenario)
        for act in acts:
            self._perform(*act)
        if changed := _changed(backward, self._seen()):
            raise ScenarioError(
                f"scenario {self._scenario.name!r}: column {changed[0][0]!r} depends on the order in which agents act; one "
                f"of these behaviors reads what another writes: {', '.join(sorted({act[1] for act in acts}))}"
            )

    def _chosen(self, agent: int) -> tuple[int, str, tuple[int, ...]] | None:
        clock, behaviors = self._world.clock, tuple(self._scenario.vocabulary.behaviors.values())
        if not behaviors:
            return None
        behavior = behaviors[int(draw(clock[KEY], clock[TICK], agent, 0) * len(behaviors))]
        targets = self._targets(agent, len(behavior.parameters))
        return (agent, behavior.name, targets[clock[TICK] % len(targets)]) if targets else None

    def _perform(self, agent: int, name: str, targets: tuple[int, ...]) -> None:
        function = self._scenario.behaviors[name]
        before = self._seen()
        self._call(f"behavior {name!r}", function, agent, *targets)
        per_entity = {column.name for column in self._scenario.columns if column.per is Per.ENTITY}
        for column, entry in _changed(before, self._seen()):
            if entry != agent or column not in per_entity:
                how = f"it writes entry {entry} of {column!r}, but agent {agent} acts; a behavior writes its agent's own entries"
                raise broke(self._scenario.name, f"behavior {name!r}", function, how)

    def _call(self, what: str, function: Callable[..., Any], *arguments: int) -> None:
        try:
            function(self._world, *arguments)
        except Exception as error:
            raise failed(self._scenario.name, what, function, error) from error

    def _seen(self) -> FrozenWorld:
        """A copy of the world as it is, whatever the columns hold."""
        names = ("clock", *(column.name for column in self._scenario.columns))
        return {name: tuple(getattr(self._world, name)) for name in names}


def _forest() -> Hierarchy:
    trio, pair = from_table((1, 3), ("trio", "agent")).roots, from_table((1, 2), ("pair", "other")).roots
    return Hierarchy((*trio, *pair))


def _changed(before: FrozenWorld, after: FrozenWorld) -> list[tuple[str, int]]:
    """Column and entry of all that differs."""
    return [
        (name, entry)
        for name, values in before.items()
        if values != after[name]
        for entry, (old, new) in enumerate(zip(values, after[name], strict=True))
        if old != new
    ]
