"""What stands above the tree: whose decisions it shows, which tree of a forest, and whether it follows."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QSpinBox, QToolButton, QWidget

from ..number_box import roomy

if TYPE_CHECKING:
    from ..actions import Actions
    from .subject import Subject


class Header(QWidget):
    """Chooses what the tree shows.

    Attributes:
        states: The states of the automaton.
        which: Chooses a tree of a forest.
        follow: Turns the tree with the selected node, or not.

    Signals:
        chosen: A state, by its id.
    """

    chosen = Signal(str)

    def __init__(self, actions: Actions) -> None:
        super().__init__()
        self._actions = actions
        self._listed: tuple[object, object] = (None, None)  # the automaton and the library that states are of
        self.states = QComboBox()
        self.states.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.states.setMinimumContentsLength(8)
        self.states.setAccessibleName("State whose decisions are shown")
        self.states.setToolTip("The state whose decisions are shown")
        self.states.activated.connect(lambda place: self.chosen.emit(self.states.itemData(place)))
        self.which = roomy(QSpinBox())
        self.which.setPrefix("tree ")
        self.which.setAccessibleName("Tree of the forest")
        self.which.setToolTip("Which tree of the forest is shown")
        self.which.hide()  # until there is one: the panel begins no wider than it has to
        self.follow = self._button("tree.follow")
        self.follow.setProperty("flat", "false")  # whether it is on has to be seen
        self.follow.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.follow.defaultAction().setIconText("Follow")
        row = QHBoxLayout(self)
        row.setContentsMargins(8, 4, 8, 0)
        row.addWidget(QLabel("from"))
        row.addWidget(self.states, 1)
        for widget in (self.which, self.follow, self._button("tree.fit")):
            row.addWidget(widget)

    def _button(self, action: str) -> QToolButton:
        button = QToolButton()
        button.setProperty("flat", "true")
        button.setDefaultAction(self._actions[action])
        button.setAccessibleName(self._actions.rows[action].text)
        return button

    @property
    def is_choosing(self) -> bool:
        """Whether the list of states is open."""
        return self.states.view().isVisible()

    def offer_trees(self, many: int) -> None:
        """Let one of so many trees be chosen."""
        with QSignalBlocker(self.which):
            self.which.setRange(1, many)

    def show_subject(self, subject: Subject | None, state: str) -> None:
        """Show which state the tree is of, and offer the others."""
        with QSignalBlocker(self.states):
            if subject is None:
                self.states.clear()
            elif self._listed[0] is not subject.automaton or self._listed[1] is not subject.library:
                self.states.clear()
                for each in subject.automaton.states:
                    self.states.addItem(subject.name(each.id), each.id)
            self._listed = (None, None) if subject is None else (subject.automaton, subject.library)
            self.states.setCurrentIndex(self.states.findData(state))
        self.states.setEnabled(subject is not None)
        self.which.setVisible(subject is not None and subject.trees > 1)
