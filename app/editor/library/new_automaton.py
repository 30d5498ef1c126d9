"""The dialog that makes a new behavior: all of it at once, kept on OK as one step."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QDialogButtonBox, QVBoxLayout, QWidget

from ...core.edits import add_automaton, describe, rename_automaton
from ...core.errors import UnderstudyError
from ...core.naming import fresh_name
from ..forms.parts import Complaint
from ..selection import BehaviorKey
from .editing import DraftEditing
from .features_page import FeaturesPage
from .pages_dialog import PagesDialog
from .states_page import StatesPage

if TYPE_CHECKING:
    from ..studio import Studio

UNNAMED = "Behavior"


def new_automaton(studio: Studio, parent: QWidget, type_name: str = "") -> None:
    """Ask for a new behavior, of the selected controller's type or of the one that is shown, unless one is named."""
    types = [node_type.name for node_type in studio.document.project.types]
    if not types:
        studio.warn(
            "a behavior belongs to a node type, and this project has none; add one in Arms and worlds"
        )
        return
    wanted = type_name or _usual_type(studio)
    NewAutomatonDialog(studio, wanted if wanted in types else types[0], parent).open()


def _usual_type(studio: Studio) -> str:
    """Whom a new behavior is probably for: the controller that is selected, else who has the behavior that is shown."""
    snapshot, node_id, shown = studio.snapshot, studio.selection.node, studio.selection.behavior
    if snapshot is not None and node_id in snapshot.place.rows and node_id not in snapshot.place.agents:
        return snapshot.place.hierarchy.node(node_id).type
    return "" if shown is None else shown.type


class NewAutomatonDialog(PagesDialog):
    """Name, parameters, states, features and learner of a behavior to come.

    Attributes:
        buttons: OK makes it.
    """

    def __init__(self, studio: Studio, type_name: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("new-automaton")
        self.setWindowTitle("New automaton")
        self._studio = studio
        self.trouble = Complaint(studio.theme)
        self.buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        self.buttons.button(QDialogButtonBox.StandardButton.Ok).setText("Make it")
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        column = QVBoxLayout(self)
        column.addWidget(self.tabs, 1)
        column.addWidget(self.trouble)
        column.addWidget(self.buttons)
        self._begin(type_name, "")

    def _begin(self, type_name: str, name: str) -> None:
        """Begin a draft in the library of a type."""
        project = self._studio.document.project
        taken = {automaton.name for automaton in project.library(type_name).automata.values()}
        begin = partial(add_automaton, type_name=type_name, name=name or fresh_name(taken, UNNAMED))
        self.draft = DraftEditing(self._studio, begin, type_name)
        types = tuple(node_type.name for node_type in project.types)
        self._offer(self.draft, types)
        self.general.type_chosen.connect(self._retype)
        self.general.name.selectAll()
        self.general.name.setFocus()

    def _retype(self, type_name: str) -> None:
        """Another type has other behaviors and features: all but the name begins anew."""
        automaton = self.draft.automaton
        name = self.general.name.text().strip() or (automaton.name if automaton else "")
        taken = self._studio.document.project.library(type_name).by_name(name) is not None
        self._begin(type_name, "" if taken else name)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter makes the behavior from its name on; elsewhere it ends what is typed. Ctrl+Enter does from anywhere."""
        if event.key() not in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            super().keyPressEvent(event)
        elif self.general.name.hasFocus() or event.modifiers() == Qt.KeyboardModifier.ControlModifier:
            self.accept()

    def accept(self) -> None:
        """Make the behavior, as one step, and show it; what was chosen on a page but not added yet is added."""
        document, name = self._studio.document, self.general.name.text().strip()
        automaton = self.draft.automaton
        if automaton is not None and name != automaton.name:
            problem = self.draft.do(rename_automaton, name)
            self.general.name_trouble.say(problem)
            if problem:
                self.tabs.setCurrentWidget(self.general)
                return
        adding: list[StatesPage | FeaturesPage] = [*self.tabs.made(StatesPage), *self.tabs.made(FeaturesPage)]
        for page in adding:
            if not page.settle():
                self.tabs.setCurrentWidget(page)
                return
        try:
            project = self.draft.kept(document.project)
        except UnderstudyError as error:
            self.trouble.say(f"the project has changed meanwhile: {error}")
            return
        document.push(describe(add_automaton, document.project, self.draft.type, name), project)
        self._studio.selection.select_behavior(BehaviorKey(self.draft.type, self.draft.id))
        super().accept()
