"""What the tree panel shows of what is selected."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...core.remembered import Remembered
from ...core.tree import Forest, Tree
from ..diagram.label_colors import state_colors
from .reaching import Reaching
from .subject import Subject

if TYPE_CHECKING:
    from ...core.automaton import Automaton, Model
    from ...core.examples import Example
    from ..selection import BehaviorKey
    from ..studio import Studio


class Subjects:
    """Makes subjects of the states of the behavior that is selected; the examples of each become arrays once."""

    def __init__(self, studio: Studio) -> None:
        self._studio = studio
        self._reaching: Remembered[str, Reaching] = Remembered()

    def made_of(self, state: str) -> tuple[object, ...]:
        """What the subject of a state is made of, its place first: where all of it is the same, so is the subject."""
        key, automaton = self._selected()
        if key is None or automaton is None:
            return ("",)
        project = self._studio.document.project
        return key, state, automaton, project.library(key.type), project.examples_of(key.type, key.id)

    def trees(self, state: str) -> int:
        """How many trees there are to choose from; 1 where there is no forest."""
        model = self._model(state)
        return len(model.trees) if isinstance(model, Forest) else 1

    def of(self, state: str, which: int) -> Subject | None:
        """The subject of a state of the behavior that is selected; None if there is none.

        Args:
            which: The tree of a forest, counted from 1.
        """
        document = self._studio.document
        key, automaton = self._selected()
        if key is None or automaton is None or not automaton.has_state(state):
            return None
        model = self._model(state)
        if isinstance(model, Forest):
            tree: Tree | None = model.trees[which - 1]
        else:
            tree = model if isinstance(model, Tree) else None
        return Subject(
            key.type,
            automaton,
            state,
            document.project.library(key.type),
            document.scenario.vocabulary,
            tree,
            self._examples(automaton, document.project.examples_of(key.type, key.id), state),
            state_colors(automaton, key.type, self._studio.colors, self._studio.theme),
        )

    def _selected(self) -> tuple[BehaviorKey | None, Automaton | None]:
        key = self._studio.selection.behavior
        return key, None if key is None else self._studio.document.automaton(key.type, key.id)

    def _model(self, state: str) -> Model | None:
        automaton = self._selected()[1]
        return None if automaton is None else automaton.learned.get(state)

    def _examples(self, automaton: Automaton, examples: tuple[Example, ...], state: str) -> Reaching:
        features = automaton.features
        self._reaching.keep({each.id for each in automaton.states})
        return self._reaching.of(
            state, (features, examples), lambda: Reaching(examples, state, [use.id for use in features])
        )
