"""Which nodes snapshots explain: one place gathers what everybody wants, and tells the engine."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import QObject

from ..engine.commands import Watch
from .bridge import Bridge
from .soon import Soon


class Watching(QObject):
    """Has `Snapshot.watched` hold the nodes that anybody has asked for."""

    def __init__(self, bridge: Bridge) -> None:
        super().__init__()
        self._bridge = bridge
        self._wanted: dict[str, tuple[str, ...]] = {}
        self._sent: tuple[str, ...] = ()
        self._soon = Soon(self, self._send)

    @property
    def nodes(self) -> tuple[str, ...]:
        """All nodes that are wanted, each once."""
        return tuple(dict.fromkeys(node for nodes in self._wanted.values() for node in nodes if node))

    def want(self, owner: str, nodes: Iterable[str]) -> None:
        """From now on *owner* needs these nodes, instead of those that it asked for before."""
        self._wanted[owner] = tuple(nodes)
        self._soon.ask()

    def begin(self) -> None:
        """Tell a session that has just begun."""
        self._sent = ()
        self._send()

    def _send(self) -> None:
        if self._bridge.is_open and self.nodes != self._sent:
            self._sent = self.nodes
            self._bridge.send(Watch(self._sent))
