"""What the machine senses of a world: the scenario's own functions, called as they are, and their answers checked."""

from collections.abc import Callable
from functools import cache
from typing import Any

from ..core.errors import ScenarioError
from ..core.machine import Senses
from ..core.vocabulary import NO_ENTITY
from .failure import broke, failed
from .ranges import allowed, closed_range
from .scenario import Scenario, World


class WorldSenses:
    """`app.core.machine.Senses` over a world.

    Every method raises a `ScenarioError` that names the function if the scenario's function raises or answers with what
    it cannot mean.
    """

    def __init__(self, scenario: Scenario, world: World) -> None:
        self._scenario = scenario
        self._world = world
        self._entities = range(NO_ENTITY, len(world.x))
        declared = scenario.vocabulary.features
        self._features = {n: (f, *closed_range(declared[n])) for n, f in scenario.features.items()}

    def feature(self, name: str, agent: int, targets: tuple[int, ...]) -> float:
        """An agent's feature."""
        function, low, high = self._features[name]
        try:
            value = function(self._world, agent, *targets)
            if low <= value <= high:  # not so for NaN
                return float(value)
        except Exception as error:
            raise failed(self._scenario.name, f"feature {name!r}", function, error) from error
        raise self._bad_value(name, function, value, f"agent {agent}")

    def group_feature(self, name: str, members: range) -> float:
        """A controller's own feature."""
        function, low, high = self._features[name]
        try:
            value = function(self._world, members.start, members.stop)
            if low <= value <= high:
                return float(value)
        except Exception as error:
            raise failed(self._scenario.name, f"feature {name!r}", function, error) from error
        raise self._bad_value(name, function, value, f"agents {members.start} to {members.stop - 1}")

    def target(self, name: str, members: range, performer: int) -> int:
        """The entity a target name means."""
        function = self._scenario.targets[name]
        try:
            entity = function(self._world, members.start, members.stop, performer)
            if entity in self._entities:
                return int(entity)
        except Exception as error:
            raise failed(self._scenario.name, f"target {name!r}", function, error) from error
        how = f"it gave {entity!r} for agent {performer}; allowed: {NO_ENTITY} to {self._entities[-1]}"
        raise broke(self._scenario.name, f"target {name!r}", function, how)

    def _bad_value(self, name: str, function: Callable[..., Any], value: object, whose: str) -> ScenarioError:
        wanted = allowed(self._scenario.vocabulary.features[name])
        how = f"it gave {value!r} for {whose}; allowed: {wanted}"
        return broke(self._scenario.name, f"feature {name!r}", function, how)


class KeptSenses:
    """`app.core.machine.Senses` for one look at a moment: what was sensed once is not worked out again.

    Features that look for something in a large world take long, and a look asks for many of them several times.
    """

    def __init__(self, senses: Senses) -> None:
        """Keep what *senses* say, for as long as the world is as it is."""
        self.feature = cache(senses.feature)
        self.group_feature = cache(senses.group_feature)
        self.target = cache(senses.target)
