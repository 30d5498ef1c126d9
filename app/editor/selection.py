"""What the user looks at: nodes in the world, a behavior, one of its states, examples."""

from collections.abc import Iterable
from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal

from ..core.automaton import START


@dataclass(frozen=True, slots=True)
class BehaviorKey:
    """An automaton of a type's library."""

    type: str
    id: str


class Selection(QObject):
    """What is selected; panels show it and change it, and hear of every change.

    Attributes:
        nodes: Ids of agents and controllers in the order of selecting; the last is the one that panels show.
        behavior: The automaton that graph, tree, examples and teach panel show.
        state: The state of that automaton whose decisions are shown; Start unless another was chosen.
        goal: Where the transition leads that is selected, which leaves that state; empty if none is.
        examples: Ids of examples of that automaton.

    Signals:
        nodes_changed, behavior_changed, state_changed, goal_changed, examples_changed: It is another one now.
        state_chosen: Somebody wants to see the decisions of a state, which may be the one that is shown already.
    """

    nodes_changed = Signal()
    behavior_changed = Signal()
    state_changed = Signal()
    state_chosen = Signal()
    goal_changed = Signal()
    examples_changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.nodes: tuple[str, ...] = ()
        self.behavior: BehaviorKey | None = None
        self.state = START
        self.goal = ""
        self.examples: tuple[str, ...] = ()

    @property
    def node(self) -> str:
        """The node that panels show; empty if none is selected."""
        return self.nodes[-1] if self.nodes else ""

    def select_nodes(self, nodes: Iterable[str]) -> None:
        """Select these nodes, and no others."""
        chosen = tuple(dict.fromkeys(nodes))
        if chosen != self.nodes:
            self.nodes = chosen
            self.nodes_changed.emit()

    def toggle_node(self, node: str) -> None:
        """Add a node to the selection, or take it out."""
        rest = [other for other in self.nodes if other != node]
        self.select_nodes(rest if node in self.nodes else [*rest, node])

    def select_behavior(self, behavior: BehaviorKey | None, state: str = "") -> None:
        """Show another automaton, or another state of it; Start where none is named."""
        if behavior != self.behavior:
            self.behavior, self.state = behavior, state or START
            self.select_examples(())
            self.select_goal("")
            self.behavior_changed.emit()
            self.state_changed.emit()
        else:
            self.show_state(state or START)
        if state:
            self.state_chosen.emit()

    def select_state(self, state: str) -> None:
        """Show the decisions of another state of the same automaton, since somebody wants to see them."""
        self.show_state(state)
        self.state_chosen.emit()

    def show_state(self, state: str) -> None:
        """The same where nobody has asked for it, as when the one that was shown is gone."""
        if state != self.state:
            self.state = state
            self.select_goal("")
            self.state_changed.emit()

    def select_goal(self, goal: str) -> None:
        """Select the transition from the state that is shown to this one; none if it is empty."""
        if goal != self.goal:
            self.goal = goal
            self.goal_changed.emit()

    def select_examples(self, examples: Iterable[str]) -> None:
        """Select these examples of the automaton shown."""
        chosen = tuple(dict.fromkeys(examples))
        if chosen != self.examples:
            self.examples = chosen
            self.examples_changed.emit()
