"""Name, parameters and note of a behavior."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from ...core.edits import rename_automaton, rename_parameter, set_note, set_parameters
from ...core.naming import fresh_name
from ..forms.buttons import stand_back
from ..forms.list_choice import ListChoice
from ..forms.ordered_list import Item, OrderedList
from ..forms.parts import Complaint, caption, framed
from .editing import Editing

FIRST_PARAMETER = "X"


EMPTY = "None: most behaviors need none. One that goes somewhere leaves open where, as Goto(X) does."


class GeneralPage(QWidget):
    """The form.

    Signals:
        type_chosen: The user wants the behavior in another type's library; only in a draft.
    """

    type_chosen = Signal(str)

    def __init__(self, editing: Editing, types: tuple[str, ...] = ()) -> None:
        """A form.

        Args:
            types: The node types to choose from; none where the behavior exists already.
        """
        super().__init__()
        self._editing = editing
        theme = editing.studio.theme
        self.name = QLineEdit()
        self.name.setObjectName("behavior-name")
        self.name.setAccessibleName("Name of the behavior")
        self.name.setToolTip("What the behavior is called; its users follow when it changes")
        self.name_trouble = Complaint(theme)
        self.name.textEdited.connect(self._name_typed)
        self.name.editingFinished.connect(self._name_done)
        self.types = self._types(types)
        self.parameters = OrderedList("Parameters", theme, editable=True, empty=EMPTY)
        self.parameters.setMaximumHeight(130)
        self.parameters.removed.connect(self._remove)
        self.parameters.moved.connect(self._move)
        self.parameters.renamed.connect(self._rename)
        self.add = QPushButton("Add parameter")
        self.add.setToolTip("A target that whoever uses the behavior chooses, such as where to go")
        stand_back(self.add)
        self.add.clicked.connect(self._add)
        self.parameter_trouble = Complaint(theme)
        self.note = QPlainTextEdit()
        self.note.setAccessibleName("Note on the behavior")
        self.note.setToolTip("What the behavior is for; it shows in the library's tips")
        self.note.setTabChangesFocus(True)
        framed(self.note, theme)
        self.note.textChanged.connect(self._note_typed)
        self._lay_out(bool(types))
        editing.changed.connect(self.refresh)
        self.refresh()

    def _types(self, types: tuple[str, ...]) -> ListChoice:
        choice = ListChoice()
        choice.setAccessibleName("Node type")
        choice.setToolTip("Whose behavior it is: each node type has a library of its own")
        choice.addItems(types)
        choice.setCurrentText(self._editing.type)
        choice.activated.connect(lambda _: self.type_chosen.emit(choice.currentText()))
        return choice

    def _lay_out(self, choose_type: bool) -> None:  # noqa: FBT001 - a private step of the constructor
        form = QFormLayout()
        if choose_type:
            form.addRow("For", self.types)
        form.addRow("Name", _above(self.name, self.name_trouble))
        under = QHBoxLayout()
        under.addWidget(self.add)
        under.addStretch(1)
        box = QVBoxLayout()
        box.setSpacing(4)
        box.addWidget(self.parameters)
        box.addLayout(under)
        box.addWidget(self.parameter_trouble)
        box.addWidget(
            caption("Features and states can be bound to a parameter instead of a target of the world.")
        )
        form.addRow("Parameters", box)
        form.addRow("Note", self.note)
        column = QVBoxLayout(self)
        column.addLayout(form)

    def refresh(self) -> None:
        """Show the automaton as it is now."""
        automaton = self._editing.automaton
        if automaton is None:
            return
        if not self.name.hasFocus() or not self.name.isModified():
            self.name.setText(automaton.name)
        self.parameters.show_items(Item(name, name, "F2 renames it") for name in automaton.parameters)
        if self.note.toPlainText() != automaton.note:
            self.note.blockSignals(True)
            self.note.setPlainText(automaton.note)
            self.note.blockSignals(False)

    def _name_typed(self, text: str) -> None:
        self.name_trouble.say(self._editing.would(rename_automaton, text.strip()))

    def _name_done(self) -> None:
        automaton = self._editing.automaton
        if automaton is not None and self.name.text().strip() != automaton.name:
            self.name_trouble.say(self._editing.do(rename_automaton, self.name.text().strip()))
        if not self.name_trouble.text():
            self.name.setModified(False)

    def _add(self) -> None:
        automaton = self._editing.automaton
        if automaton is None:
            return
        name = fresh_name(automaton.parameters, FIRST_PARAMETER).replace(" ", "")
        if not self._say(self._editing.do(set_parameters, (*automaton.parameters, name))):
            self.parameters.edit(name)

    def _remove(self, name: str) -> None:
        automaton = self._editing.automaton
        if automaton is not None:
            self._say(self._editing.do(set_parameters, [p for p in automaton.parameters if p != name]))

    def _move(self, name: str, to: int) -> None:
        automaton = self._editing.automaton
        if automaton is not None:
            names = [other for other in automaton.parameters if other != name]
            names.insert(to, name)
            self._say(self._editing.do(set_parameters, names))

    def _rename(self, old: str, new: str) -> None:
        if not self._say(self._editing.do(rename_parameter, old, new.strip())):
            self.parameters.choose(new.strip())

    def _say(self, message: str) -> str:
        self.parameter_trouble.say(message)
        return message

    def _note_typed(self) -> None:
        self._editing.do(set_note, self.note.toPlainText(), gesture=f"note {self._editing.id}")


def _above(field: QWidget, below: QLabel) -> QVBoxLayout:
    """A field with words below it."""
    box = QVBoxLayout()
    box.setSpacing(2)
    box.addWidget(field)
    box.addWidget(below)
    return box
