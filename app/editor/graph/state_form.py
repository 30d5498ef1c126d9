"""Name, note, bindings, flag, and the order of the rules of a state in a small form."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QComboBox, QFormLayout, QLineEdit, QVBoxLayout, QWidget

from ...core.automaton import START, Automaton, RaiseFlag, State
from ...core.edits import bind_state, note_state, order_rules, remove_rule, rename_state, set_content
from ...core.edits.bindings import bindings_of
from ...core.wording import content_words, rule_words, state_words
from ..forms.list_choice import ListChoice
from ..forms.ordered_list import Item, OrderedList
from ..forms.parts import caption
from ..forms.tab_order import tab_through
from . import offers
from .scoping import Scoping

if TYPE_CHECKING:
    from ..studio import Studio

OPEN = "(open)"
RULES = "Rules, tried in this order:"
#: Pixels that the list of rules is high.
RULES_HEIGHT = 84


class StateForm(QWidget):
    """Shows and changes one state.

    Attributes:
        place: Type, automaton and state; None while nothing is shown.
        title: What the state holds, in words.
        name, note, flag: Fields.
        slots: The choice of each slot's binding.
        rules: Those that leave the state, in order.
    """

    def __init__(self, studio: Studio, scoping: Scoping) -> None:
        super().__init__()
        self._studio, self._scoping = studio, scoping
        self.place: tuple[str, str, str] | None = None
        self._shown: object = None
        self.title = ""
        self.name = self._field("Name of the state", "shows what it does")
        self.note = self._field("Note on the state", "what you want to remember of it")
        self.flag = self._field("Name of the flag", "done")
        self.name.editingFinished.connect(lambda: self._edit(rename_state, self.name, "name"))
        self.note.editingFinished.connect(lambda: self._edit(note_state, self.note, "note"))
        self.flag.editingFinished.connect(self._flag_named)
        self.slots: dict[str, QComboBox] = {}
        self._rows = QFormLayout()
        self._rows.setHorizontalSpacing(8)
        self._order = caption(RULES)
        self.rules = OrderedList("Rules of the state", studio.theme)
        self.rules.list.setFixedHeight(RULES_HEIGHT)
        self.rules.moved.connect(self._reorder)
        self.rules.removed.connect(self._remove_rule)
        column = QVBoxLayout(self)
        column.setContentsMargins(10, 4, 10, 8)
        column.addLayout(self._rows)
        column.addWidget(self._order)
        column.addWidget(self.rules)
        column.addStretch(1)

    def _field(self, name: str, hint: str) -> QLineEdit:
        field = QLineEdit(self)
        field.setAccessibleName(name)
        field.setPlaceholderText(hint)
        field.setToolTip(name)
        return field

    @property
    def first(self) -> QWidget:
        """Where to begin: what is open yet, or else the name."""
        return next((box for box in self.slots.values() if box.currentData() is None), self.name)

    def show_place(self, place: tuple[str, str, str] | None) -> None:
        """Show a state, or none."""
        automaton = None if place is None else self._scoping.automaton(*place[:2])
        if place is None or automaton is None or not automaton.has_state(place[2]):
            self.place, self._shown = None, None
            return
        state = automaton.state(place[2])
        scope = self._scoping.scope(place[0])
        choices = [] if scope is None else offers.bindings(scope, automaton)
        slots = () if scope is None else offers.slots_of(state.content, scope)
        bound = tuple(bindings_of(state.content).items())
        form = place, type(state.content), bound, tuple(name for name, _ in choices), slots
        self.title = content_words(state.content, self._studio.document.project.library(place[0]))
        if form != self._shown:
            self.place, self._shown = place, form
            self._fill(state, slots, choices)
        self._update(state)
        self._show_rules(automaton, state)

    def _fill(self, state: State, slots: tuple[str, ...], choices: list[offers.Choice]) -> None:
        for field in (self.name, self.note, self.flag):
            field.setParent(self)
            field.hide()
        while self._rows.rowCount():
            taken = self._rows.takeRow(0)
            for item in (taken.labelItem, taken.fieldItem):
                widget = item.widget()
                if widget is not None and widget not in (self.name, self.note, self.flag):
                    widget.hide()
                    widget.deleteLater()
        self.slots = {}
        if state.id != START:
            for slot in slots:
                self._rows.addRow(slot, self._slot(slot, state, choices))
            if isinstance(state.content, RaiseFlag):
                self._put("Flag", self.flag)
        self._put("Name", self.name)
        self._put("Note", self.note)
        tab_through(self, [*self.slots.values(), self.flag, self.name, self.note, self.rules])

    def _update(self, state: State) -> None:
        """What stands in the fields; not in the one that is being typed into."""
        flag = state.content.flag if isinstance(state.content, RaiseFlag) else ""
        for field, text in ((self.name, state.name), (self.note, state.note), (self.flag, flag)):
            if field.text() != text and not (field.hasFocus() and field.isModified()):
                field.setText(text)

    def _show_rules(self, automaton: Automaton, state: State) -> None:
        assert self.place is not None
        library = self._studio.document.project.library(self.place[0])
        vocabulary = self._studio.document.scenario.vocabulary
        shown = [
            Item(rule.id, f"{order}.  {words} → {state_words(automaton, rule.target, library)}", words)
            for order, rule in enumerate(automaton.rules_of(state.id), 1)
            for words in [rule_words(rule, automaton, vocabulary)]
        ]
        self.rules.show_items(shown)
        self.rules.setVisible(bool(shown))
        self._order.setVisible(bool(shown))

    def _put(self, label: str, field: QLineEdit) -> None:
        field.show()
        self._rows.addRow(label, field)

    def _slot(self, slot: str, state: State, choices: list[offers.Choice]) -> QComboBox:
        box = ListChoice()
        box.setAccessibleName(f"What {slot} is")
        box.setToolTip(f"What {slot} stands for in this state")
        bound = bindings_of(state.content).get(slot)
        box.addItem(OPEN, None)
        for name, binding in choices:
            box.addItem(name, binding)
        place = next((k for k, (_, binding) in enumerate(choices, 1) if binding == bound), 0)
        if bound is not None and place == 0:
            box.addItem(f"{bound} (missing)", bound)
            place = box.count() - 1
        box.setCurrentIndex(place)
        box.activated.connect(lambda at: self._bind(slot, box.itemData(at)))
        self.slots[slot] = box
        return box

    # -------------------------------------------------------------------------------------------- changing

    def _state(self) -> State | None:
        automaton = None if self.place is None else self._scoping.automaton(*self.place[:2])
        if self.place is None or automaton is None or not automaton.has_state(self.place[2]):
            return None
        return automaton.state(self.place[2])

    def _edit(self, edit: Callable[..., object], field: QLineEdit, name: str) -> None:
        state = self._state()
        if state is not None and self.place is not None and field.text() != getattr(state, name):
            self._studio.document.attempt(edit, *self.place, field.text())

    def _flag_named(self) -> None:
        state = self._state()
        if state is None or self.place is None or not isinstance(state.content, RaiseFlag):
            return
        if self.flag.text() != state.content.flag and not self._studio.document.attempt(
            set_content, *self.place, RaiseFlag(self.flag.text())
        ):
            self.flag.setText(state.content.flag)

    def _reorder(self, rule: str, to: int) -> None:
        """Try a rule earlier or later; the keys stay on it."""
        if self.place is None:
            return
        automaton = self._scoping.automaton(*self.place[:2])
        order = [] if automaton is None else [other.id for other in automaton.rules_of(self.place[2])]
        order.insert(to, order.pop(order.index(rule)))
        self._studio.document.attempt(order_rules, *self.place, order)

    def _remove_rule(self, rule: str) -> None:
        if self.place is not None:
            self._studio.document.attempt(remove_rule, *self.place[:2], rule)

    def _bind(self, slot: str, binding: object) -> None:
        if self.place is not None:
            self._studio.document.attempt(bind_state, *self.place, slot, binding)
