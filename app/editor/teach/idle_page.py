"""Before a lesson: what would be taught to whom, and what is missing for it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLabel, QLineEdit, QPushButton, QVBoxLayout, QWidget

from ...core.amounts import counted
from .pupils import members
from .target_row import TargetRow

if TYPE_CHECKING:
    from ...engine.snapshots import Snapshot
    from ..selection import BehaviorKey
    from ..studio import Studio

MOST_NAMED = 3
#: Pixels of the field for the name of the demonstration, at least and at most.
NAME = (120, 180)
FILED = "the examples of a lesson are kept together under this name; the panel Examples can show them alone"


class IdlePage(QWidget):
    """Says what Teach would do now."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        self.teach = QPushButton("Teach")
        self.teach.setDefault(False)
        self.teach.clicked.connect(studio.actions["teach.teach"].trigger)
        studio.teaching.choosing.changed.connect(self._make_room)  # before the row takes it
        self.targets = TargetRow(studio)
        self.filed = QLineEdit(placeholderText="demonstration")
        self.filed.setAccessibleName("Name of the demonstration")
        self.filed.setMinimumWidth(NAME[0])
        self.filed.setMaximumWidth(NAME[1])
        self.filed.editingFinished.connect(self._file)
        self.keep = QCheckBox("keep")
        self.keep.setAccessibleName("Keep the lesson as a demonstration")
        self.keep.toggled.connect(lambda on: studio.teaching.keeping.set_on(on=on))
        filed = QLabel("demonstration")
        filed.setProperty("role", "caption")
        self._filing = filed, self.filed, self.keep
        self._lay_out()
        for signal in (studio.changed, studio.teaching.changed):
            signal.connect(self.refresh)
        self.refresh()

    def _lay_out(self) -> None:
        first, second = QHBoxLayout(), QHBoxLayout()
        first.setSpacing(16)
        first.addWidget(self.words, 1)
        first.addWidget(self.teach, 0, Qt.AlignmentFlag.AlignTop)
        second.addWidget(self.targets)
        second.addStretch(1)
        for widget in self._filing:
            second.addWidget(widget, int(widget is self.filed))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 4, 0, 0)
        layout.setSpacing(8)
        layout.addLayout(first)
        layout.addLayout(second)
        layout.addStretch(1)

    def refresh(self) -> None:
        """Say it anew."""
        teaching = self._studio.teaching
        if teaching.lesson is not None:
            return
        self.words.setText(self._words())
        keys = self._studio.actions["teach.teach"].shortcut().toString()
        self.teach.setText(f"Teach   {keys}" if keys else "Teach")
        self.teach.setToolTip(self._studio.actions["teach.teach"].toolTip())
        self.teach.setEnabled(self._studio.snapshot is not None and teaching.key is not None)
        self._make_room()
        self.filed.setPlaceholderText(teaching.filed_under)
        self.filed.setToolTip(
            f"{teaching.filed_under}: {FILED}" if teaching.filed_under else FILED.capitalize()
        )
        self._show_keeping()
        if not self.filed.hasFocus():
            self.filed.setText(teaching.demonstration)

    def _make_room(self) -> None:
        """Hide what is not needed: while a target is chosen the window would become wider, and nothing else needs a name."""
        teaching = self._studio.teaching
        for widget in self._filing:
            widget.setVisible(teaching.key is not None and not teaching.choosing.is_busy)

    def _show_keeping(self) -> None:
        """Whether the next lesson would be kept, and why it could not be."""
        keeping = self._studio.teaching.keeping
        why = keeping.obstacle
        with QSignalBlocker(self.keep):
            self.keep.setChecked(keeping.on and not why)
        self.keep.setEnabled(not why)
        tip = self._studio.actions.rows["teach.keep"].tip
        self.keep.setToolTip(f"The lesson could not be kept as a demonstration: {why}" if why else tip)

    def _words(self) -> str:
        studio, teaching = self._studio, self._studio.teaching
        key, automaton, snapshot = teaching.key, teaching.automaton, studio.snapshot
        if not studio.is_open or (snapshot is None and studio.arm is None):
            return "This project has no arm yet: make one in the panel Agents, then behaviors can be taught to its agents."
        if key is None or automaton is None:
            return "Choose a behavior to teach in the library, or make a new one there."
        if snapshot is None:
            return "The world is being made…"
        nodes = teaching.nodes
        if not nodes:
            return f"{automaton.name} is for nodes of type {key.type}, but there is none in this arm. Teach offers arms that have one."
        named = ", ".join(snapshot.place.called(node) for node in nodes[:MOST_NAMED])
        more = f" and {len(nodes) - MOST_NAMED} more" if len(nodes) > MOST_NAMED else ""
        known = len(studio.document.project.examples_of(key.type, key.id))
        had = f" {automaton.name} has {counted(known, 'example')}." if known else ""
        open_ = " and ".join(teaching.open)
        first = f" First choose what {open_} is." if open_ else ""
        return f"Teach {automaton.name} to {named}{more}.{first}{had} {self._others(snapshot, key)}"

    def _others(self, snapshot: Snapshot, key: BehaviorKey) -> str:
        """How others are taught, such as a node that is selected but runs no behavior of this type."""
        node_id = self._studio.selection.node
        if node_id not in snapshot.place.rows or node_id in members(snapshot.place.hierarchy, key.type):
            return "Others can be selected in the world."
        of = snapshot.place.hierarchy.node(node_id).type
        return f"For {snapshot.place.called(node_id)} choose a behavior of type {of} in the library, or make one."

    def _file(self) -> None:
        self._studio.teaching.set_demonstration(self.filed.text())
