"""The scene: an item for each state and edge that is shown, found by where it is."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from PySide6.QtCore import QPointF, QRectF, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QGraphicsItem, QGraphicsScene

from ...core.automaton import Basic
from ...engine.snapshots import Snapshot, StateRef
from ...export.graph import GraphState
from ..behavior_colors import BehaviorColors
from ..selection import BehaviorKey
from ..theme import Theme
from .arrangement import Point
from .edge_item import EdgeItem
from .labels import tip_of
from .level import Drawn
from .live import Crowd, active_states, crowd
from .state_item import Path, StateItem

#: An edge: the path of its level, source and target.
EdgeKey = tuple[Path, str, str]


class GraphScene(QGraphicsScene):
    """Shows an automaton with what is open in it.

    Attributes:
        states, edges: The items by where they are.
        levels: All automata that are shown, by the path of the state that holds them.

    Signals:
        marked: Other states or another edge are selected.
    """

    marked = Signal()

    def __init__(self, theme: Theme, colors: BehaviorColors) -> None:
        super().__init__()
        self._theme, self._colors = theme, colors
        self.states: dict[Path, StateItem] = {}
        self.edges: dict[EdgeKey, EdgeItem] = {}
        self.levels: dict[Path, Drawn] = {}
        self.selected: tuple[Path, ...] = ()
        self.edge: EdgeKey | None = None
        self._is_dressed = False  # in the colors that are in force

    # -------------------------------------------------------------------------------------------- building

    def undress(self) -> None:
        """Everything is to have other colors."""
        self._is_dressed = False

    def goes_on_as(self, drawn: Drawn | None) -> bool:
        """Whether it shows all of that already; it goes on with that, which may have been worked out from something else."""
        root = self.levels.get(())
        if root is None or drawn is None or not self._is_dressed or not root.looks_like(drawn):
            return False
        self._keep(drawn)
        return True

    def _keep(self, drawn: Drawn) -> None:
        self.levels[drawn.path] = drawn
        for inner in drawn.inner.values():
            self._keep(inner)

    def build(self, drawn: Drawn | None) -> None:
        """Show this; what was selected stays so, as far as it is still there."""
        self.clear()
        self.states, self.edges, self.levels = {}, {}, {}
        self._is_dressed = True
        if drawn is not None:
            self._add_level(drawn, None)
        self.mark([path for path in self.selected if path in self.states], self.edge)

    def _add_level(self, drawn: Drawn, parent: QGraphicsItem | None) -> None:
        self.levels[drawn.path] = drawn
        names = {state.id: state.name for state in drawn.graph.states}
        middle = QPointF(0, 0)
        if parent is not None:
            outer = self.levels[drawn.path[:-1]]
            middle = QPointF(*outer.offset(drawn.path[-1]))
        for edge in drawn.graph.edges:
            key = edge.source, edge.target
            item = EdgeItem(drawn.path, edge, drawn.labels[key], self._theme, labeled=drawn.is_labeled)
            item.place(drawn.runs[key])
            item.say(tip_of(edge, drawn.automaton, (names[edge.source], names[edge.target])))
            self._put(item, parent, middle)
            self.edges[drawn.path, edge.source, edge.target] = item
        for state in drawn.graph.states:
            path = (*drawn.path, state.id)
            color = self._color(drawn.type, state)
            inner = drawn.inner.get(state.id)
            item_of = StateItem(
                path, state, drawn.sizes[state.id], color, self._theme, is_open=inner is not None
            )
            self._put(item_of, parent, middle + QPointF(*drawn.places[state.id]))
            self.states[path] = item_of
            if inner is not None:
                self._add_level(inner, item_of)

    def _color(self, type_name: str, state: GraphState) -> QColor:
        """A state's color: its behavior's; what a controller directs has the color of the automata of that name."""
        if isinstance(state.content, Basic):
            return self._colors.of_name(state.content.behavior)
        return self._colors.color(type_name, state.nested)

    def _put(self, item: QGraphicsItem, parent: QGraphicsItem | None, at: QPointF) -> None:
        if parent is None:
            self.addItem(item)
        else:
            item.setParentItem(parent)
        item.setPos(at)

    @property
    def is_settled(self) -> bool:
        """Whether no state will stand elsewhere once Graphviz has arranged all that is shown."""
        return all(level.is_settled for level in self.levels.values())

    def contents(self) -> QRectF:
        """The box around all that is shown."""
        root = self.levels.get(())
        if root is None:
            return QRectF()
        (left, top), (right, bottom) = root.corners
        return QRectF(left, top, right - left, bottom - top).adjusted(-8, -8, 8, 8)

    # ------------------------------------------------------------------------------------------- selecting

    def mark(self, states: Iterable[Path], edge: EdgeKey | None = None) -> None:
        """Select these states, the last one first of all, or an edge."""
        chosen = tuple(dict.fromkeys(path for path in states if path in self.states))
        kept = edge if edge in self.edges else None
        changed = (chosen, kept) != (self.selected, self.edge)
        self.selected, self.edge = chosen, kept
        for path, item in self.states.items():
            shown = bool(chosen) and path == chosen[-1]
            item.dress(replace(item.look, selected=path in chosen, shown=shown))
        for key, line in self.edges.items():
            line.choose(chosen=key == kept)
        if changed:
            self.marked.emit()

    def turn(self, by: int) -> None:
        """Select the next or the previous transition that leaves the state that is selected."""
        source = self.deciding
        if source is None:
            return
        leaving = [key for key in self.edges if (*key[0], key[1]) == source]
        if leaving:
            place = leaving.index(self.edge) + by if self.edge in leaving else min(by, 0)
            self.mark((), leaving[place % len(leaving)])

    @property
    def current(self) -> Path | None:
        """The state that was selected last."""
        return self.selected[-1] if self.selected else None

    @property
    def deciding(self) -> Path | None:
        """The state whose decisions are shown: that one, or the one that the selected transition leaves."""
        return self.current if self.edge is None else (*self.edge[0], self.edge[1])

    @property
    def level_for_new(self) -> Drawn | None:
        """The automaton that a new state comes into: the one of what is selected, or the one that is shown."""
        path = self.deciding or ()
        return self.levels.get(path[:-1]) or self.levels.get(())

    def key_of(self, path: Path) -> tuple[BehaviorKey, str]:
        """The automaton that a state is of, and its id there."""
        level = self.levels[path[:-1]]
        return BehaviorKey(level.type, level.automaton.id), path[-1]

    def find(self, type_name: str, automaton: str, state: str) -> Path | None:
        """Where a state is shown, the outermost place first."""
        for path, level in self.levels.items():
            if (level.type, level.automaton.id) == (type_name, automaton) and (*path, state) in self.states:
                return (*path, state)
        return None

    def state_at(self, at: QPointF) -> StateItem | None:
        """The innermost state at a place of the scene."""
        found = [item for item in self.items(at) if isinstance(item, StateItem)]
        boxes = [item for item in found if item.box.contains(item.mapFromScene(at))]
        return max(boxes or found, key=lambda item: len(item.path), default=None)

    def level_at(self, at: QPointF) -> tuple[Drawn | None, Point]:
        """The automaton whose ground is at a place of the scene, and that place as it is for its states while closed."""
        item = self.state_at(at)
        path: Path = ()
        if item is not None:
            path = item.path if item.is_open else item.path[:-1]
        level = self.levels.get(path)
        if level is None:
            return None, (0.0, 0.0)
        inside = self.states[path].mapFromScene(at) if path else at
        place: Point = (inside - self._home(path)).toTuple()
        return level, place

    def edge_at(self, at: QPointF) -> EdgeKey | None:
        """The edge at a place of the scene, of several the one on top."""
        for item in self.items(at):
            if isinstance(item, EdgeItem):
                return (item.level, item.edge.source, item.edge.target)
        return None

    # -------------------------------------------------------------------------------------------- dragging

    def drag(self, path: Path, by: Point) -> None:
        """Show a state elsewhere, with its edges; the project does not know of it yet."""
        level = self.levels[path[:-1]]
        places = dict(level.places)
        x, y = places[path[-1]]
        places[path[-1]] = x + by[0], y + by[1]
        home = self._home(path[:-1])
        self.states[path].setPos(home + QPointF(*places[path[-1]]))
        for (source, target), run in level.rerouted(places, path[-1]).items():
            self.edges[path[:-1], source, target].place(run)

    def settle(self) -> None:
        """Show everything where the project has it."""
        for path, item in self.states.items():
            at = self.levels[path[:-1]].places[path[-1]]
            item.setPos(self._home(path[:-1]) + QPointF(*at))
        for (path, source, target), line in self.edges.items():
            line.place(self.levels[path].runs[source, target])

    def _home(self, level: Path) -> QPointF:
        """Where (0, 0) of a level is, in the item that it lies in."""
        return QPointF(*self.levels[level[:-1]].offset(level[-1])) if level else QPointF(0, 0)

    # ------------------------------------------------------------------------------------------------- live

    def follow(self, snapshot: Snapshot | None, path: tuple[StateRef, ...]) -> None:
        """Show who is where; only what differs is painted again.

        Args:
            path: The states that the selected node is in, outermost first.
        """
        for level in self.levels.values():
            here = active_states(path, self.levels[()].type, self.levels[()].automaton.id)
            depth = len(level.path)
            active = here[depth] if len(here) > depth and here[:depth] == level.path else ""
            now = crowd(snapshot, level.type, level.automaton.id)
            for state in level.graph.states:
                self._show(self.states[*level.path, state.id], now, active=state.id == active)

    def _show(self, item: StateItem, now: Crowd, *, active: bool) -> None:
        state = item.state.id
        count, share = now.counts.get(state, 0), round(now.share(state), 3)
        look = item.look
        if (look.count, look.share, look.active) != (count, share, active):
            item.dress(replace(look, count=count, share=share, active=active))

    def show_problems(self, found: Mapping[Path, str], edges: Mapping[EdgeKey, str]) -> None:
        """Put badges where something is wrong."""
        for path, item in self.states.items():
            item.dress(replace(item.look, problem=found.get(path, "")))
        for key, line in self.edges.items():
            if line.problem != edges.get(key, ""):
                line.problem = edges.get(key, "")
                line.update()

    def around(self) -> Iterator[tuple[Path, QPointF]]:
        """The middles of all states, in the scene."""
        for path, item in self.states.items():
            yield path, item.scenePos()
