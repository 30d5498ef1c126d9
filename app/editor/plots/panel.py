"""Curves that grow while a world runs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QShowEvent
from PySide6.QtWidgets import (
    QComboBox,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QStackedLayout,
    QVBoxLayout,
    QWidget,
)

from ...core.wording import node_words, state_words
from ..actions import ActionRow, When, when_there
from ..diagram.label_colors import state_colors
from ..forms.word_list import WordList
from ..palette import BASIC
from ..record import Point, Record
from ..soon import Later, Soon
from .series import BehaviorShares, LineKey, Lines, MeasureOf, StateShares, Subject, rows_below

if TYPE_CHECKING:
    from ...core.hierarchy import Node
    from ...engine.snapshots import Snapshot
    from ..studio import Studio
    from .lines_view import LinesView

#: Milliseconds between two drawings.
REDRAW = 100
EMPTY = "Let time pass (Space) to see measures and shares over time."
#: More lines than this are not told apart; the largest are drawn.
MOST_LINES = 12


class PlotsPanel(QWidget):
    """Any measure, or the shares of behaviors or states, for the world or what is below the selected controller."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._record = Record()  # one of its own: cleared, it is as fine again as at the beginning
        self._lines = Lines(BehaviorShares())
        self.view: LinesView | None = None
        self.what = self._box("What is plotted", 20)
        self._below = False  # whether shares are of what is below the selected controller
        self.whom = self._box("Of whom: the world, or what is below the selected controller", 14)
        self._lay_out()
        self._live = Later(self, self.redraw, REDRAW)
        studio.bridge.snapshot_changed.connect(self._take)
        studio.bridge.place_changed.connect(self._another_world)
        studio.opened.connect(self._another_world)
        self._soon = Soon(self, self._offer)
        studio.selection.nodes_changed.connect(self._soon.ask)
        studio.selection.behavior_changed.connect(self._soon.ask)
        studio.colors.changed.connect(self._choose)
        studio.theme.changed.connect(self._choose)
        self.what.activated.connect(lambda _: self._choose())
        self.whom.activated.connect(self._choose_whom)
        studio.actions.add(plot_rows(self))
        self._offer()

    def _box(self, tip: str, letters: int) -> QComboBox:
        box = WordList()
        box.setToolTip(tip)
        box.setAccessibleName(tip)
        box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        box.setMinimumContentsLength(letters)  # names of any length would make the window wide
        return box

    def _lay_out(self) -> None:
        full, bar = QWidget(), QHBoxLayout()
        bar.setContentsMargins(8, 4, 8, 4)
        bar.setSpacing(8)
        bar.addWidget(self.what)
        bar.addWidget(self.whom)
        self.clear_button = QPushButton("Clear")
        self.clear_button.setToolTip("Forget the curves so far; the world goes on")
        self.clear_button.clicked.connect(self.clear)
        bar.addWidget(self.clear_button)
        bar.addStretch(1)
        column = QVBoxLayout(full)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addLayout(bar)
        self._room = column
        empty = QLabel(EMPTY)
        empty.setProperty("role", "empty")
        empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._pages = QStackedLayout(self)
        self._pages.addWidget(empty)
        self._pages.addWidget(full)
        self.setFocusProxy(self.what)

    # ------------------------------------------------------------------------------------------- recording

    def _take(self, snapshot: Snapshot) -> None:
        point = Point(snapshot.tick, snapshot.measures, snapshot.doing)
        if self._record.add(point) and self.isVisible():
            self._live.ask()

    def _another_world(self) -> None:
        self._record.clear()
        self._offer()
        self._live.ask()

    @property
    def has_curves(self) -> bool:
        """Whether anything is plotted."""
        return len(self._record.points) > 1

    def clear(self) -> None:
        """Forget what was seen so far."""
        self._record.clear()
        self.redraw()

    # ------------------------------------------------------------------------------------------- choosing

    def subjects(self) -> list[tuple[str, Subject]]:
        """What can be plotted, with its words."""
        document, shown = self._studio.document, self._studio.selection.behavior
        found: list[tuple[str, Subject]] = [("Behaviors of agents", BehaviorShares())]
        automaton = None if shown is None else document.automaton(shown.type, shown.id)
        if shown is not None and automaton is not None:
            found.append((f"States of {automaton.name}", StateShares(shown.type, shown.id)))
        return found + [(name.capitalize(), MeasureOf(name)) for name in document.scenario.measures]

    def group(self) -> Node | None:
        """The controller that is selected, if one is."""
        snapshot, node_id = self._studio.snapshot, self._studio.selection.node
        if snapshot is None or not node_id:
            return None
        nodes = (node for node in snapshot.place.hierarchy.walk() if node.id == node_id and node.children)
        return next(nodes, None)

    def _offer(self) -> None:
        chosen = self.what.currentIndex()
        self.what.clear()
        for words, subject in self.subjects():
            self.what.addItem(words, subject)
        self.what.setCurrentIndex(max(0, min(chosen, self.what.count() - 1)))
        group = self.group()
        self.whom.clear()
        self.whom.addItem("of the world", None)
        if group is not None:
            self.whom.addItem(f"of {node_words(group)}", group.id)
        self._choose()

    def choose(self, words: str) -> None:
        """Plot what is called so in the box."""
        self.what.setCurrentIndex(max(0, self.what.findText(words)))
        self._choose()

    def _choose_whom(self, at: int) -> None:
        self._below = at == 1
        self._choose()

    def _choose(self) -> None:
        subject = self.what.currentData()
        measures = isinstance(subject, MeasureOf)  # they are of the world
        self.whom.setEnabled(not measures)
        self.whom.setCurrentIndex(int(self._below and not measures and self.whom.count() > 1))
        group = self.group() if self.whom.currentData() else None
        self._lines = Lines(subject or BehaviorShares(), rows_below(group))
        if self.view is not None:
            self.view.clear()
        self.redraw()

    # -------------------------------------------------------------------------------------------- drawing

    def showEvent(self, event: QShowEvent) -> None:
        """Draw what came while nobody looked."""
        super().showEvent(event)
        self._live.ask()

    def redraw(self) -> None:
        """Draw the lines as they are now."""
        points = self._record.points
        self._pages.setCurrentIndex(1 if len(points) > 1 else 0)
        if not self.isVisible() or len(points) < 2:
            return
        if self.view is None:
            self.view = self._made_view()
            self._live.hurry()  # that took long enough for one turn
            return
        self._lines.follow(points, self._record.version)
        keys, view = self._largest(), self.view
        view.keep(keys)
        for key in keys:
            if key not in view.curves:
                view.begin(key, self.name(key), self._color(key), self._style(key))
            view.draw(key, *self._lines.line(key))
        share = not isinstance(self._lines.subject, MeasureOf)
        view.scale("share" if share else self.what.currentText().lower(), share=share)

    def _made_view(self) -> LinesView:
        """The plot, made when it is needed first."""
        from .lines_view import LinesView  # noqa: PLC0415 - pyqtgraph would keep the window from opening at once

        view = LinesView(self._studio.theme)
        self._room.addWidget(view.legend)  # in its own row: beside the boxes it would be cut off
        self._room.addWidget(view, 1)
        return view

    def _largest(self) -> list[LineKey]:
        keys = list(self._lines.keys)
        if len(keys) <= MOST_LINES:
            return keys
        return sorted(keys, key=lambda key: -float(self._lines.line(key)[1].sum()))[:MOST_LINES]

    def name(self, key: LineKey) -> str:
        """What a line is called."""
        document = self._studio.document
        if key[0] == "state":
            automaton = document.automaton(key[1], key[2])
            if automaton is None or not automaton.has_state(key[3]):
                return key[3]
            return state_words(automaton, key[3], document.project.library(key[1]))
        return key[-1]

    def _color(self, key: LineKey) -> QColor:
        studio = self._studio
        if key[0] == "behavior":
            return studio.colors.color(key[1], key[2])
        if key[0] == "state":
            automaton = studio.document.automaton(key[1], key[2])
            colors: Mapping[str, QColor] = (
                {} if automaton is None else state_colors(automaton, key[1], studio.colors, studio.theme)
            )
            return colors.get(key[3], QColor(BASIC))
        return studio.theme.color("accent")

    def _style(self, key: LineKey) -> Qt.PenStyle:
        """Grey lines are told apart by their dashes."""
        greys = [other for other in self._lines.keys if self._color(other) == self._color(key)]
        styles = [
            Qt.PenStyle.SolidLine,
            Qt.PenStyle.DashLine,
            Qt.PenStyle.DotLine,
            Qt.PenStyle.DashDotLine,
            Qt.PenStyle.DashDotDotLine,
        ]
        return styles[greys.index(key) % len(styles)]


def plot_rows(panel: PlotsPanel) -> tuple[ActionRow, ...]:
    """What can be done with plots."""

    def show(studio: Studio) -> None:
        studio.show_panel.emit("plots")

    return (
        ActionRow(
            "run.plot",
            "Plot over time",
            "Run",
            show,
            "plots",
            tip="Show measures and shares of behaviors over time",
            icon="chart-line",
            enabled=when_there,
        ),
        ActionRow(
            "run.clear_plot",
            "Clear the plot",
            "Run",
            lambda _: panel.clear(),
            "plots",
            tip="Forget the curves so far; the world goes on",
            icon="eraser",
            enabled=When(lambda _: panel.has_curves, "let the world go on first: nothing is plotted yet"),
        ),
    )
