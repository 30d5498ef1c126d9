"""Turns the tree to the state that the selected node is in, as long as nobody reads another one."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ...core.wording import node_words
from ..soon import Later

if TYPE_CHECKING:
    from ..studio import Studio

FLAG = "tree_follows"
#: Milliseconds between two turns: nobody reads a tree faster.
TURN = 250


class Following(QObject):
    """Off at first, since a tree that somebody reads must not turn away; whatever is chosen by hand switches it off.

    Attributes:
        on: Whether the tree follows.
        state: The state that is followed; empty where the selected node does not run what is shown.
        words: Why nothing is followed, though it is on; empty otherwise.

    Signals:
        changed: One of these is another.
    """

    changed = Signal()

    def __init__(self, studio: Studio, may_turn: Callable[[], bool]) -> None:
        """Follow in *studio*, as long as *may_turn* says that nobody looks or has a hand in between."""
        super().__init__()
        self._studio, self._may_turn = studio, may_turn
        self.on = studio.settings.flag(FLAG)
        self.state = self.words = ""
        self._soon = Later(self, self._look, TURN)
        studio.bridge.snapshot_changed.connect(self.ask)
        for signal in (studio.selection.nodes_changed, studio.selection.behavior_changed):
            signal.connect(self.hurry)

    def ask(self, _snapshot: object = None) -> None:
        """Look where the node is, soon."""
        if self.on and self._may_turn():
            self._soon.ask()

    def hurry(self) -> None:
        """Look as soon as possible: somebody else is selected."""
        if self.on and self._may_turn():
            self._soon.hurry()

    @property
    def is_due(self) -> bool:
        """Whether the node may be in another state than is known here."""
        return self._soon.is_due

    def rest(self) -> None:
        """Nobody looks."""
        self._soon.forget()

    def switch(self, *, on: bool) -> None:
        """Follow, or stay with the state that is shown."""
        if on == self.on:
            return
        self.on = on
        self._studio.settings.set_flag(FLAG, on=on)
        if on:
            self._find()
        else:
            self._soon.forget()
            shown, self.state, self.words = self.state, "", ""
            if shown:
                self._studio.selection.show_state(shown)
        self.changed.emit()

    def stop(self) -> None:
        """Something else was chosen by hand: show that, whatever was followed."""
        self.state = ""
        self.switch(on=False)

    def _missing(self) -> str:
        """What is missing for there to be a state."""
        studio = self._studio
        shown, node, snapshot = studio.selection.behavior, studio.selection.node, studio.snapshot
        if shown is None or snapshot is None:
            return ""
        if not node:
            return "Select an agent to follow it"
        automaton = studio.document.automaton(shown.type, shown.id)
        if automaton is None or node not in snapshot.watched:
            return ""
        return f"{node_words(snapshot.place.hierarchy.node(node))} does not run {automaton.name} now"

    def _look(self) -> None:
        if self.on and self._may_turn() and self._find():
            self.changed.emit()

    def _find(self) -> bool:
        """Whether the node is in another state than before."""
        before = self.state, self.words
        self.state = self._state_now()
        self.words = "" if self.state else self._missing()
        return before != (self.state, self.words)

    def _state_now(self) -> str:
        shown, snapshot = self._studio.selection.behavior, self._studio.snapshot
        watched = None if snapshot is None else snapshot.watched.get(self._studio.selection.node)
        if watched is None or shown is None:
            return ""
        levels = (each for each in watched.levels if (each.type, each.automaton) == (shown.type, shown.id))
        return next((level.state for level in levels), "")
