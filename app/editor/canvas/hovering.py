"""Who is under the mouse, and the card that tells about it."""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, Signal

from .frame import Frame
from .hits import controller_at, entity_at
from .overlays import Card
from .words import entity_words, node_words

if TYPE_CHECKING:
    from ..studio import Studio


class Covers(QObject):
    """Notices when the mouse goes onto something that lies over the canvas, of which the canvas itself hears nothing.

    Signals:
        entered: It has.
    """

    entered = Signal()

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Tell of the mouse; keep nothing from anybody."""
        if event.type() == QEvent.Type.Enter:
            self.entered.emit()
        return False


class Hovering(QObject):
    """What the mouse points at, without pressing anything.

    Attributes:
        entity: What is there; -1 if there is none.
        node: The agent that this is, or the controller whose link or hull is there; empty if there is none.

    Signals:
        changed: It is something else.
    """

    changed = Signal()

    def __init__(self, studio: Studio, card: Card, frame: Callable[[], Frame | None]) -> None:
        super().__init__()
        self._studio = studio
        self._card = card
        self._frame = frame
        self.entity, self.node = -1, ""

    def look(self, x: float, y: float, *, is_live: bool, first: Collection[int] = ()) -> None:
        """Tell about what is at a pixel; those that come *first* come before what lies upon them."""
        frame = self._frame()
        if frame is None:
            self.nothing()
            return
        entity = entity_at(frame, x, y, first)
        node = frame.scene.node(entity) if entity >= 0 else controller_at(frame, x, y)
        self._point(entity, node, watched=is_live)
        if entity < 0 and not node:
            self._card.hide()
            return
        snapshot = self._studio.snapshot
        known = snapshot.watched.get(node) if snapshot is not None and is_live else None
        lines = (
            entity_words(self._studio, frame.scene, entity, known)
            if entity >= 0
            else node_words(self._studio, frame.scene, node, known)
        )
        self._card.tell(lines, x, y)

    def nothing(self) -> None:
        """Point at nothing."""
        self._card.hide()
        self._point(-1, "", watched=False)

    def _point(self, entity: int, node: str, *, watched: bool) -> None:
        if (entity, node) != (self.entity, self.node):
            self.entity, self.node = entity, node
            self._studio.watching.want("canvas", (node,) if node and watched else ())
            self.changed.emit()
