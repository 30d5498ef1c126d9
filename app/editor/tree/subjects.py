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
    from ...core.features import FeatureUse
    from ..selection import BehaviorKey
    from ..studio import Studio


class Subjects:
    """Makes the subject of the state that is selected; examples become arrays once for the state that is shown."""

    def __init__(self, studio: Studio) -> None:
        self._studio = studio
        self._reaching: Remembered[str, Reaching] = Remembered()

    def made_of(self) -> tuple[object, ...]:
        """What a subject is made of, its place first: where all of it is the same, so is the subject."""
        key, automaton = self._selected()
        if key is None or automaton is None:
            return ("",)
        project = self._studio.document.project
        state, examples = self._studio.selection.state, project.examples_of(key.type, key.id)
        return key, state, automaton, project.library(key.type), examples

    def trees(self) -> int:
        """How many trees there are to choose from; 1 where there is no forest."""
        model = self._model()
        return len(model.trees) if isinstance(model, Forest) else 1

    def selected(self, which: int) -> Subject | None:
        """The state that is selected; None if there is none.

        Args:
            which: The tree of a forest, counted from 1.
        """
        document, state = self._studio.document, self._studio.selection.state
        key, automaton = self._selected()
        if key is None or automaton is None or not automaton.has_state(state):
            return None
        model = self._model()
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
            self._examples(automaton.features, document.project.examples_of(key.type, key.id), state),
            state_colors(automaton, key.type, self._studio.colors, self._studio.theme),
        )

    def _selected(self) -> tuple[BehaviorKey | None, Automaton | None]:
        key = self._studio.selection.behavior
        return key, None if key is None else self._studio.document.automaton(key.type, key.id)

    def _model(self) -> Model | None:
        automaton = self._selected()[1]
        return None if automaton is None else automaton.learned.get(self._studio.selection.state)

    def _examples(
        self, features: tuple[FeatureUse, ...], examples: tuple[Example, ...], state: str
    ) -> Reaching:
        self._reaching.keep({state})
        return self._reaching.of(
            state, (features, examples), lambda: Reaching(examples, state, [use.id for use in features])
        )
