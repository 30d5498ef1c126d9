"""The timeline: what was picked, what agents did and what was counted, tick by tick; a click goes there."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QShowEvent
from PySide6.QtWidgets import QFrame, QLabel, QScrollArea, QStackedLayout, QVBoxLayout, QWidget

from ...core.hierarchy import Node
from ...core.wording import node_words, state_words
from ...engine.commands import GoTo, Pause
from ...engine.snapshots import Mode, Moved, Picked, TakenBack
from ...sim.doing import BehaviorRef
from ..diagram.label_colors import state_colors
from ..palette import BASIC
from ..selection import BehaviorKey
from ..soon import Later
from .past import Doing, Past
from .strip import PickDot, Shown, Strip

if TYPE_CHECKING:
    from ...engine.snapshots import Snapshot
    from ..studio import Studio

#: Milliseconds between two drawings.
REDRAW = 100
#: So many nodes have a row of their own.
MOST_NODES = 6
EMPTY = "Let time pass (Space) to see what was picked and done, and when; a click goes back there."


class TimelinePanel(QWidget):
    """The run on a line; see `Strip`."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self.past = Past()
        self._picks: dict[tuple[str, ...], PickDot] = {}  # by where the first of their examples is
        self._standing: tuple[PickDot, ...] | None = None  # those that were not taken back, once looked up
        self._looks: dict[Doing, tuple[str, QColor]] = {}
        self.strip = Strip(studio.theme, self.past, self._look)
        self._lay_out()
        self._live = Later(self, self.redraw, REDRAW)
        bridge = studio.bridge
        bridge.snapshot_changed.connect(self._take)
        bridge.event_came.connect(self._event_came)
        bridge.place_changed.connect(self._another_world)
        studio.opened.connect(self._another_world)
        studio.document.history_changed.connect(self._history_changed)
        for signal in (studio.selection.nodes_changed, studio.colors.changed):
            signal.connect(self._live.ask)
        self.strip.tick_wanted.connect(self.go_to)
        self.strip.pick_chosen.connect(self._choose)
        if studio.snapshot is not None:
            self.past.take(studio.snapshot)

    def _lay_out(self) -> None:
        scroll = QScrollArea()
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        held = QWidget()
        column = QVBoxLayout(held)
        column.setContentsMargins(0, 4, 0, 0)
        column.addWidget(self.strip)
        column.addStretch(1)
        scroll.setWidget(held)
        empty = QLabel(EMPTY)
        empty.setProperty("role", "empty")
        empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        empty.setWordWrap(True)
        self._pages = QStackedLayout(self)
        self._pages.addWidget(empty)
        self._pages.addWidget(scroll)
        self.setFocusProxy(self.strip)

    # --------------------------------------------------------------------------------------------- the run

    def _take(self, snapshot: Snapshot) -> None:
        before = self.past.version
        self.past.take(snapshot)
        if self.past.version != before:
            self._picks = {at: dot for at, dot in self._picks.items() if dot.tick <= snapshot.tick}
            self._standing = None
        if self.isVisible():
            self._live.ask()

    def _event_came(self, event: object) -> None:
        snapshot = self._studio.snapshot
        self._standing = None
        if isinstance(event, Moved) and snapshot is not None:
            self.past.move(snapshot.tick)
        elif isinstance(event, Picked) and event.recorded.examples:
            dot = self._dot(event)
            self._picks.pop((*dot.key, dot.examples[0]), None)  # one that was taken back had the same ids
            self._picks[*dot.key, dot.examples[0]] = dot
            self._live.ask()
        elif isinstance(event, TakenBack):
            self._live.ask()

    def _history_changed(self) -> None:
        self._standing = None
        snapshot = self._studio.snapshot
        if snapshot is not None:
            self.past.moved_back(snapshot.tick)
        self._live.ask()

    def _another_world(self) -> None:
        self.past.clear()
        self._picks.clear()
        self._standing = None
        self._live.ask()

    def _dot(self, picked: Picked) -> PickDot:
        recorded = picked.recorded
        first = recorded.examples[0]
        automaton = self._studio.document.automaton(recorded.type, recorded.automaton)
        library = self._studio.document.project.library(recorded.type)
        source, label = (
            state if automaton is None else state_words(automaton, state, library)
            for state in (first.source, first.label)
        )
        words = f"tick {first.tick:,}: {node_words(Node(first.node, ''))} was to go from {source} to {label}"
        return PickDot(recorded, words)

    def _looked_whether_standing(self) -> tuple[PickDot, ...]:
        """The picks that have not been taken back."""
        project = self._studio.document.project
        dots = self._picks.values()
        there = {
            key: {example.id: example for example in project.examples_of(*key)}
            for key in {dot.key for dot in dots}
        }
        return tuple(dot for dot in dots if dot.recorded_it(there[dot.key].get(dot.examples[0])))

    # ------------------------------------------------------------------------------------------ looking, going

    def showEvent(self, event: QShowEvent) -> None:
        """Draw what came while nobody looked."""
        super().showEvent(event)
        self._live.ask()

    def redraw(self) -> None:
        """Draw the run as far as it is known now."""
        snapshot = self._studio.snapshot
        has_run = snapshot is not None and len(self.past.points) > 1
        self._pages.setCurrentIndex(int(has_run))
        if snapshot is None or not has_run or not self.isVisible():
            return
        self._looks.clear()  # names and colors may be others by now
        measures = list(snapshot.measures)
        ends = self.past.points[0].tick, self.past.points[-1].tick
        if self._standing is None:
            self._standing = self._looked_whether_standing()
        self.strip.show_now(
            Shown(
                snapshot.tick,
                snapshot.earliest if snapshot.mode is Mode.RUNNING else None,
                self._nodes(snapshot),
                tuple(dot for dot in self._standing if ends[0] <= dot.tick <= ends[1]),
                measures[0] if measures else "",
            )
        )

    def _nodes(self, snapshot: Snapshot) -> tuple[tuple[str, str], ...]:
        chosen = [node for node in self._studio.selection.nodes if node in snapshot.doing.rows]
        wanted = chosen or sorted(snapshot.taught)
        hierarchy = snapshot.place.hierarchy
        return tuple((node, node_words(hierarchy.node(node))) for node in wanted[-MOST_NODES:])

    def go_to(self, tick: int) -> None:
        """Show the world as it was before a tick, or will be."""
        snapshot = self._studio.snapshot
        if snapshot is None or tick == snapshot.tick:
            return
        if snapshot.mode is not Mode.RUNNING:
            self._studio.say("in a lesson or a test, time only goes on; end it (Esc) to go back in the run")
        elif tick < snapshot.earliest:
            self._studio.say(f"this run can be gone back in to tick {snapshot.earliest:,}")
        else:
            self._studio.bridge.send(Pause())
            self._studio.bridge.send(GoTo(tick))

    def _choose(self, dot: PickDot) -> None:
        """Show the examples that a pick recorded."""
        selection = self._studio.selection
        selection.select_behavior(BehaviorKey(*dot.key))
        selection.select_examples(dot.examples)

    def _look(self, doing: Doing) -> tuple[str, QColor]:
        """What is done in words, and its color."""
        if doing not in self._looks:
            self._looks[doing] = self._looked_up(doing)
        return self._looks[doing]

    def _looked_up(self, doing: Doing) -> tuple[str, QColor]:
        studio = self._studio
        if isinstance(doing, BehaviorRef):
            colors = studio.colors
            color = colors.color(doing.type, doing.id) if doing.id else colors.of_name(doing.name)
            return doing.name, color
        automaton = studio.document.automaton(doing.type, doing.automaton)
        if automaton is None:
            return doing.state, QColor(BASIC)
        colors_of = state_colors(automaton, doing.type, studio.colors, studio.theme)
        words = state_words(automaton, doing.state, studio.document.project.library(doing.type))
        return words, colors_of.get(doing.state, QColor(BASIC))
