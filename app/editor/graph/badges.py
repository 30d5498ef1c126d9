"""Marks states and edges of the graph at which something is wrong, and says what in their tool tips."""

from collections.abc import Mapping, Sequence

from ...core.check.problem import Problem
from ..document import Document
from .level import Drawn
from .problems import Spot, problems_of, spots, worst
from .scene import EdgeKey, GraphScene
from .scoping import Scoping
from .state_item import Path


class Badges:
    """Checks the automata that are shown, each again only when it has changed."""

    def __init__(self, document: Document, scoping: Scoping, scene: GraphScene) -> None:
        self._document, self._scoping, self._scene = document, scoping, scene
        self._checked: dict[Path, tuple[tuple[object, ...], Mapping[Spot, list[Problem]]]] = {}

    def show(self) -> None:
        """Mark what is wrong now."""
        states: dict[Path, list[Problem]] = {}
        edges: dict[EdgeKey, list[Problem]] = {}
        for path, level in self._scene.levels.items():
            for spot, found in self._problems(level).items():
                if len(spot) == 1:
                    states[*path, spot[0]] = found
                else:
                    edges[path, spot[0], spot[-1]] = found
        for state, box in self._scene.states.items():
            box.say_problem(_told(states.get(state, ())))
        for edge, line in self._scene.edges.items():
            line.say_problem(_told(edges.get(edge, ())))
        self._scene.show_problems(
            {state: worst(found) for state, found in states.items()},
            {edge: worst(found) for edge, found in edges.items()},
        )

    def fixes(self) -> list[Problem]:
        """The problems of what is selected that one click can mend."""
        edge, path = self._scene.edge, self._scene.current
        where: tuple[Path, Spot] | None = None
        if edge is not None:
            where = edge[0], edge[1:]
        elif path is not None:
            where = path[:-1], (path[-1],)
        if where is None or where[0] not in self._scene.levels:
            return []
        found = self._problems(self._scene.levels[where[0]]).get(where[1], [])
        return [problem for problem in found if problem.mend is not None]

    def _problems(self, level: Drawn) -> Mapping[Spot, list[Problem]]:
        scope = self._scoping.scope(level.type)
        if scope is None:
            return {}
        examples = self._document.project.examples_of(level.type, level.automaton.id)
        made_of = scope, level.automaton, examples
        kept = self._checked.get(level.path)
        if kept is None or not all(a is b for a, b in zip(kept[0], made_of, strict=True)):
            found = problems_of(scope, level.automaton, examples)
            kept = self._checked[level.path] = made_of, spots(level.automaton, found)
        return kept[1]


def _told(problems: Sequence[Problem]) -> str:
    return "\n".join(problem.message for problem in problems)
