"""What the parameters of an automaton mean while it is taught."""

from __future__ import annotations

from collections.abc import Container, Mapping

from ...core.automaton import Automaton
from ...engine.snapshots import LessonView
from ..selection import BehaviorKey


class Arguments:
    """Ground targets for the parameters of automata, as far as the user has chosen them."""

    def __init__(self) -> None:
        self._chosen: dict[BehaviorKey, dict[str, str]] = {}

    def choose(self, key: BehaviorKey, parameter: str, target: str) -> None:
        """From now on *parameter* of a behavior means *target*."""
        self._chosen.setdefault(key, {})[parameter] = target

    def of(
        self, key: BehaviorKey, automaton: Automaton, lesson: LessonView | None = None
    ) -> Mapping[str, str]:
        """Those of an automaton; what a lesson that is going on was begun with comes first."""
        chosen = {**self._chosen.get(key, {}), **(lesson.plan.arguments if lesson is not None else {})}
        return {slot: chosen[slot] for slot in automaton.parameters if slot in chosen}

    def missing(self, key: BehaviorKey, automaton: Automaton, targets: Container[str]) -> tuple[str, ...]:
        """Parameters for which no target that exists was chosen."""
        chosen = self._chosen.get(key, {})
        return tuple(slot for slot in automaton.parameters if chosen.get(slot) not in targets)

    def forget(self) -> None:
        """Nothing was chosen: it is another project."""
        self._chosen.clear()
