"""The form below the graph: of the state or the transition that is selected."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtWidgets import (
    QApplication,
    QFrame,
    QHBoxLayout,
    QLabel,
    QScrollArea,
    QStackedWidget,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ...export.graph import Edge, WayKind, way_words
from ..escape import takes_escape
from .rule_form import Place, RuleBlock, RuleForm
from .scene import GraphScene
from .scoping import Scoping
from .state_form import StateForm

if TYPE_CHECKING:
    from ..studio import Studio

HIGHEST, LOWEST = 230, 150
MOST_TOLD = 3
#: Pixels that are seen above and below what has the keys.
AROUND = 8


class FormStrip(QFrame):
    """Shows the form of what is selected, while it is open.

    Attributes:
        rules, state: The two forms.

    Signals:
        closed: The user is done with it: why the keys go elsewhere.
    """

    closed = Signal(Qt.FocusReason)

    def __init__(self, studio: Studio, scoping: Scoping) -> None:
        super().__init__()
        self.rules = RuleForm(studio, scoping)
        self.state = StateForm(studio, scoping)
        self._stack = QStackedWidget()
        for form in (self.rules, self.state):
            self._stack.addWidget(FormArea(form))
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        line = QFrame()
        line.setProperty("role", "hairline")
        line.setFixedHeight(1)
        column.addWidget(line)
        column.addLayout(self._head())
        column.addWidget(self._stack)
        self.setMaximumHeight(HIGHEST)
        self.setMinimumHeight(LOWEST)
        self.hide()

    def _head(self) -> QHBoxLayout:
        """What the form is about, and what closes it: they stay while the form is scrolled."""
        self._title = QLabel()
        self._title.setProperty("role", "title")
        close = QToolButton()
        close.setText("✕")
        close.setProperty("flat", "true")
        close.setToolTip("Close the form (Esc)")
        close.setAccessibleName("Close the form")
        close.clicked.connect(lambda: self.closed.emit(Qt.FocusReason.OtherFocusReason))
        head = QHBoxLayout()
        head.setContentsMargins(10, 2, 10, 0)
        head.addWidget(self._title, 1)
        head.addWidget(close)
        return head

    def show_selected(self, scene: GraphScene) -> bool:
        """Show the form of what is selected; whether anything is."""
        edge, path = scene.edge, scene.current
        if edge is not None:
            level = scene.levels[edge[0]]
            self.show_edge((level.type, level.automaton.id, *edge[1:]), level.edges.get(edge[1:]))
        elif path is not None:
            key, state = scene.key_of(path)
            self.show_state((key.type, key.id, state))
        return edge is not None or path is not None

    def show_edge(self, place: Place, edge: Edge | None) -> None:
        """Show the rules between two states, and what was learned."""
        ways = [way for way in (edge.ways if edge is not None else ()) if way.kind is not WayKind.RULE]
        told = "; ".join(way_words(way) for way in ways[:MOST_TOLD])
        more = len(ways) - MOST_TOLD + (edge.more if edge is not None else 0)
        learned = f"Learned: {told}{f'; and {more} more' if more > 0 else ''}." if told else ""
        self.rules.show_place(place, learned)
        self._title.setText(self.rules.title)
        self._stack.setCurrentIndex(0)

    def show_state(self, place: tuple[str, str, str]) -> None:
        """Show a state."""
        self.state.show_place(place)
        self._title.setText(self.state.title)
        self._stack.setCurrentIndex(1)

    def focus_first(self) -> None:
        """Put the keyboard into the form."""
        if self._stack.currentIndex() == 1:
            self.state.first.setFocus(Qt.FocusReason.OtherFocusReason)
            return
        form: QWidget = self.rules.blocks[-1] if self.rules.blocks else self.rules
        fields = [child for child in form.findChildren(QWidget) if _takes_keys(child)]
        if isinstance(form, RuleBlock) and not form.rows:
            fields = [form.add]
        if fields:
            fields[0].setFocus(Qt.FocusReason.OtherFocusReason)

    def event(self, event: QEvent) -> bool:
        """Escape closes the form, and nothing else."""
        reason = Qt.FocusReason.ShortcutFocusReason
        return takes_escape(event, lambda: self.closed.emit(reason)) or super().event(event)


class FormArea(QScrollArea):
    """A form that may be higher than the place for it: what has the keys is in sight, however they came there."""

    def __init__(self, form: QWidget) -> None:
        super().__init__()
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setWidget(form)
        self._form = form
        form.installEventFilter(self)
        QApplication.instance().focusChanged.connect(self._keys_moved)  # type: ignore[union-attr]  # there is one

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """The form was laid out anew."""
        taken = super().eventFilter(watched, event)
        if event.type() in (QEvent.Type.LayoutRequest, QEvent.Type.Resize):
            self._keys_moved()
        return taken

    def _keys_moved(self, _before: QWidget | None = None, _now: QWidget | None = None) -> None:
        focus = QApplication.focusWidget()
        if focus is not None and self._form.isAncestorOf(focus):
            middle = focus.mapTo(self._form, focus.rect().center())
            self.ensureVisible(middle.x(), middle.y(), 0, focus.height() // 2 + AROUND)


def _takes_keys(child: QWidget) -> bool:
    tabbed = child.focusPolicy() & Qt.FocusPolicy.TabFocus
    return bool(tabbed) and child.isVisible() and child.isEnabled() and not isinstance(child, QToolButton)
