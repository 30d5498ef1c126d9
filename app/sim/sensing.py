"""What the machine senses of a world: the scenario's own functions, called as they are."""

from ..core.errors import ScenarioError
from .scenario import Scenario, World


class WorldSenses:
    """`app.core.machine.Senses` over a world."""

    def __init__(self, scenario: Scenario, world: World) -> None:
        self._scenario = scenario
        self._world = world

    def feature(self, name: str, agent: int, targets: tuple[int, ...]) -> float:
        """An agent's feature."""
        try:
            return float(self._scenario.features[name](self._world, agent, *targets))
        except Exception as error:
            raise raised(self._scenario, f"feature {name!r}", error) from error

    def group_feature(self, name: str, members: range) -> float:
        """A controller's own feature."""
        try:
            return float(self._scenario.features[name](self._world, members.start, members.stop))
        except Exception as error:
            raise raised(self._scenario, f"feature {name!r}", error) from error

    def target(self, name: str, members: range, performer: int) -> int:
        """The entity a target name means."""
        try:
            return int(self._scenario.targets[name](self._world, members.start, members.stop, performer))
        except Exception as error:
            raise raised(self._scenario, f"target {name!r}", error) from error


def raised(scenario: Scenario, where: str, error: Exception) -> ScenarioError:
    """The error for a scenario's function that raised, with what it raised and in which line."""
    trace, line = error.__traceback__, 0
    while trace is not None:
        line, trace = trace.tb_lineno, trace.tb_next
    return ScenarioError(f"scenario {scenario.name!r}, {where}, line {line}: {type(error).__name__}: {error}")
