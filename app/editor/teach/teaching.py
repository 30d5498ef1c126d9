"""Who is taught what: from the user's choices to commands of the session."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ...core.automaton import Content
from ...engine.commands import Others, Pick, RunArm, ShouldNotHaveLeft, Teach, Test
from ...engine.snapshots import Mode

if TYPE_CHECKING:
    from ..studio import Studio


class Teaching(QObject):
    """Teaches the behavior that is shown to the nodes that are selected.

    Attributes:
        arguments: Ground targets for the automaton's parameters meanwhile, by parameter.
        others: What the nodes that are not taught do meanwhile.

    Signals:
        changed: Arguments, others, or the node whose turn it is are other ones now.
    """

    changed = Signal()

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self.arguments: Mapping[str, str] = {}
        self.others = Others.IDLE

    @property
    def is_teaching(self) -> bool:
        """Whether a lesson is going on, its test included."""
        return self._studio.mode in (Mode.TEACHING, Mode.LEARNING, Mode.TESTING)

    @property
    def node(self) -> str:
        """The node that a pick is for."""
        snapshot = self._studio.snapshot
        lesson = None if snapshot is None else snapshot.lesson
        if lesson is None:
            return ""
        selected = self._studio.selection.node
        return selected if selected in lesson.plan.nodes or lesson.testing else lesson.plan.nodes[0]

    def teach(self) -> None:
        """Take the selected nodes of the behavior's type into training mode for the behavior that is shown."""
        behavior = self._studio.selection.behavior
        if behavior is None:
            self._studio.warn("choose a behavior to teach in the library, or make a new one")
            return
        nodes = self._nodes(behavior.type)
        if not nodes:
            self._studio.warn(f"there is no node of type {behavior.type!r} in this arm; choose another arm")
            return
        self._studio.selection.select_nodes(nodes)
        plan = Teach(behavior.type, behavior.id, nodes, dict(self.arguments), self.others)
        self._studio.bridge.send(plan)

    def test(self) -> None:
        """Learn, then let all nodes of the type run it."""
        self._studio.bridge.send(Test())

    def stop(self) -> None:
        """End the lesson: the arm runs."""
        self._studio.bridge.send(RunArm())

    def pick(self, choice: str | Content) -> None:
        """What the node is to do from the next tick on: a state by its id, or what a new state is to hold."""
        self._studio.bridge.send(Pick(self.node, choice))

    def should_not_have_left(self) -> None:
        """The state that the node left by itself last, it should have stayed in."""
        self._studio.bridge.send(ShouldNotHaveLeft(self.node))

    def _nodes(self, type_name: str) -> tuple[str, ...]:
        snapshot = self._studio.snapshot
        if snapshot is None:
            return ()
        of_type = [node.id for node in snapshot.place.hierarchy.walk() if node.type == type_name]
        chosen = tuple(node for node in self._studio.selection.nodes if node in of_type)
        return chosen or tuple(of_type[:1])
