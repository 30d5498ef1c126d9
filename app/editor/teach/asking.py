"""Ask me: in a test the run stops before a node does what it is not sure of, and the user's answer is an example."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ...core.wording import state_words
from ...engine.commands import AskMe, LetGo
from ...engine.snapshots import Asked
from .pupils import members

if TYPE_CHECKING:
    from ..studio import Studio
    from .teaching import Teaching

#: Asked below this probability, and beyond this distance from all examples, until the user says otherwise.
BELOW, BEYOND = 0.6, 0.5


class Asking(QObject):
    """When the user wants to be asked, and about whom: in this project, another one begins without.

    Attributes:
        on: Whether to ask at all.
        below: Ask where the most probable next state has a probability below this; None does not for that reason.
        beyond: Ask where what a node sees is farther than this from every example; None does not for that reason.

    Signals:
        changed: One of them is another, or there is another question.
    """

    changed = Signal()

    def __init__(self, studio: Studio, teaching: Teaching) -> None:
        super().__init__()
        self._studio = studio
        self._teaching = teaching
        self.on = False
        self.below: float | None = BELOW
        self.beyond: float | None = None
        studio.opened.connect(self._opened)
        self._chosen: tuple[str, ...] = ()
        self._selecting = False
        self._sent = AskMe()
        self._shown: Asked | None = None
        studio.selection.nodes_changed.connect(self._selected)
        studio.bridge.place_changed.connect(self._begun)
        studio.bridge.mode_changed.connect(self._send)
        studio.bridge.event_came.connect(self._event_came)
        studio.bridge.snapshot_changed.connect(self._snapshot_changed)

    @property
    def asked(self) -> Asked | None:
        """The question that waits for an answer."""
        return None if self._studio.snapshot is None else self._studio.snapshot.asked

    def set(self, *, on: bool, below: float | None, beyond: float | None) -> None:
        """Ask so from now on."""
        self.on, self.below, self.beyond = on, below, beyond
        self._send()
        self.changed.emit()
        self._studio.touch()

    def toggle(self) -> None:
        """Ask, or do not."""
        self.set(on=not self.on, below=self.below, beyond=self.beyond)

    def let_go(self) -> None:
        """It may decide by itself."""
        self._studio.bridge.send(LetGo())

    def words(self, asked: Asked) -> str:
        """The question, to be read."""
        studio = self._studio
        automaton = studio.document.automaton(asked.type, asked.automaton)
        who = studio.snapshot.place.called(asked.node) if studio.snapshot else asked.node
        if automaton is None:
            return f"{who} is not sure. What should it do?"
        library = studio.document.project.library(asked.type)
        shares = ", ".join(
            f"{state_words(automaton, state, library)} {100 * share:.0f}%" for state, share in asked.outcome
        )
        if self.below is not None and asked.confidence < self.below:
            return f"{who} is not sure: {shares}. What should it do?"
        return f"{who} has seen nothing like this; it would do: {shares}. What should it do?"

    # ------------------------------------------------------------------------------------------- inside

    def _nodes(self) -> tuple[str, ...]:
        """The selected nodes that are tested, or else those that were taught."""
        lesson, snapshot = self._teaching.lesson, self._studio.snapshot
        if lesson is None or snapshot is None:
            return self._chosen
        forest = snapshot.place.hierarchy
        of_type = members(forest, lesson.plan.type)
        return tuple(node for node in self._chosen if node in of_type) or lesson.plan.nodes

    def _send(self) -> None:
        wanted = AskMe(self._nodes(), self.below, self.beyond) if self.on else AskMe()
        if wanted != self._sent:
            self._sent = wanted
            self._studio.bridge.send(wanted)

    def _opened(self) -> None:
        """It was wished for in another project, where nobody sees it any more."""
        self._chosen = ()
        self.set(on=False, below=BELOW, beyond=None)

    def _begun(self) -> None:
        """Another world does not know what was asked for in the one before."""
        self._sent = AskMe()
        self._send()

    def _selected(self) -> None:
        if not self._selecting:
            self._chosen = self._studio.selection.nodes
            self._send()

    def _event_came(self, event: object) -> None:
        if isinstance(event, Asked):
            self._selecting = True  # the one that asks does not become the only one that is asked about
            self._studio.selection.select_nodes((event.node,))
            self._selecting = False
            self._studio.show_panel.emit("teach")
            self._teaching.follow_requested.emit(event.node)

    def _snapshot_changed(self, _snapshot: object) -> None:
        if self.asked is not self._shown:
            self._shown = self.asked
            self.changed.emit()
            self._studio.touch()
