"""The states of a behavior: what each holds, with its bindings, name and note."""

from __future__ import annotations

from PySide6.QtWidgets import QFormLayout, QHBoxLayout, QLineEdit, QPushButton, QVBoxLayout, QWidget

from ...core.automaton import START, Automaton, Basic, Content, Nested, RaiseFlag, State
from ...core.edits import (
    add_state,
    bind_state,
    move_state,
    note_state,
    remove_state,
    rename_state,
    set_content,
)
from ...core.features import Binding
from ...core.library import known_flags
from ...core.naming import shown_content, shown_state
from ...core.vocabulary import FINISHED
from ..forms.buttons import stand_back
from ..forms.choosing import Choice, Chooser
from ..forms.ordered_list import Item, OrderedList
from ..forms.parts import Complaint, caption, side_by_side
from ..forms.slot_form import SlotForm
from .editing import Editing


def choices(editing: Editing) -> list[Choice]:
    """All that a state can hold: other behaviors of the library, basic ones, flags."""
    scope = editing.scope
    if scope is None:
        return []
    above = scope.library.all_users(editing.id) | {editing.id}
    automata = sorted(scope.library.automata.values(), key=lambda a: a.name.casefold())
    found = [
        Choice(_called(a), Nested(a.id), a.note or "an automaton of the library")
        for a in automata
        if a.id not in above
    ]
    basics = scope.vocabulary.behaviors.values()
    found += [Choice(_called(basic), Basic(basic.name), basic.doc) for basic in basics]
    flags = [flag for flag in known_flags(scope.library, scope.vocabulary) if flag != FINISHED]
    return found + [
        Choice(f"raise {flag}", RaiseFlag(flag), f"Raises the flag {flag!r} and goes to Start")
        for flag in flags
    ]


def _called(behavior: object) -> str:
    name, parameters = getattr(behavior, "name", ""), getattr(behavior, "parameters", ())
    return f"{name}({', '.join(parameters)})" if parameters else str(name)


def slots_of(editing: Editing, content: Content) -> tuple[str, ...]:
    """The slots of what a state holds."""
    scope = editing.scope
    if scope is None:
        return ()
    match content:
        case Nested(held) if held in scope.library.automata:
            return scope.library.automata[held].parameters
        case Basic(name) if name in scope.vocabulary.behaviors:
            return scope.vocabulary.behaviors[name].parameters
    return ()


class StatesPage(QWidget):
    """The list of states, and the one that is chosen in full."""

    def __init__(self, editing: Editing) -> None:
        super().__init__()
        self._editing = editing
        theme = editing.studio.theme
        self.states = OrderedList("States", theme)
        self.states.chosen.connect(lambda _: self._show_chosen())
        self.states.moved.connect(lambda key, to: self._say(editing.do(move_state, key, to)))
        self.states.removed.connect(lambda key: self._say(editing.do(remove_state, key)))
        self.add = QPushButton("Add state")
        self.new = Chooser(
            "Behavior of a new state", "behavior or flag to add", lambda text: _flag_named(text) is not None
        )
        self.new.chosen.connect(lambda _: self._ready())
        self.new.field.textChanged.connect(lambda _: self._ready())
        self.new.entered.connect(self._add)
        self.add.setToolTip("Add a state that holds this; type “raise” and a name for a flag of your own")
        stand_back(self.add)
        self.add.setEnabled(False)
        self.add.clicked.connect(self._pressed)
        self.trouble = Complaint(theme)
        self.content = Chooser("What the state holds", "what the state holds")
        self.content.chosen.connect(self._content_chosen)
        self.slots = SlotForm()
        self.slots.bound.connect(self._bound)
        self.name = QLineEdit()
        self.name.setAccessibleName("Name of the state")
        self.name.setToolTip("Another name for the state; without one it is called as what it holds")
        self.name.editingFinished.connect(self._named)
        self.note = QLineEdit()
        self.note.setAccessibleName("Note on the state")
        self.note.setToolTip("What the state is for")
        self.note.editingFinished.connect(self._noted)
        self.detail = QWidget()
        self.start = caption(
            "Start idles. Every behavior begins here, and returns here when it raises a flag."
        )
        self._lay_out()
        editing.changed.connect(self.refresh)
        self.refresh()

    def settle(self) -> bool:
        """Add what was chosen but not added yet; whether nothing is left half done."""
        self._add()
        return not self.new.currentText().strip()

    def _lay_out(self) -> None:
        form = QFormLayout(self.detail)
        form.setContentsMargins(0, 0, 0, 0)
        form.addRow("Holds", self.content)
        form.addRow("", self.slots)
        form.addRow("Name", self.name)
        form.addRow("Note", self.note)
        adding = QHBoxLayout()
        adding.addWidget(self.new, 1)
        adding.addWidget(self.add)
        left = QVBoxLayout()
        left.addWidget(self.states, 1)
        right = QVBoxLayout()
        right.addWidget(self.start)
        right.addWidget(self.detail)
        right.addStretch(1)
        column = QVBoxLayout(self)
        column.addLayout(side_by_side(left, right), 1)
        column.addLayout(adding)
        column.addWidget(self.trouble)

    @property
    def _automaton(self) -> Automaton | None:
        return self._editing.automaton

    @property
    def _state(self) -> State | None:
        automaton, chosen = self._automaton, self.states.current
        return automaton.state(chosen) if automaton is not None and automaton.has_state(chosen) else None

    def refresh(self, chosen: str = "") -> None:
        """Show the states as they are now."""
        automaton, scope = self._automaton, self._editing.scope
        if automaton is None or scope is None:
            return
        shown = [
            Item(s.id, shown_state(automaton, s.id, scope.library), s.note, fixed=s.id == START)
            for s in automaton.states
        ]
        typed = self.new.currentText()
        self.new.offer(choices(self._editing))
        self.new.setEditText(typed)
        self.states.show_items(shown, chosen)

    def _show_chosen(self) -> None:
        state, automaton, scope = self._state, self._automaton, self._editing.scope
        held = state is not None and state.id != START
        self.detail.setVisible(held)
        self.start.setVisible(not held)
        if state is None or automaton is None or scope is None or not held:
            return
        content = state.content
        offered = choices(self._editing)
        if all(choice.value != _plain(content) for choice in offered):
            offered.append(Choice(shown_content(_plain(content), scope.library), _plain(content)))
        self.content.offer(offered, _plain(content))
        bindings = content.bindings if isinstance(content, Basic | Nested) else {}
        self.slots.show_slots(
            slots_of(self._editing, content), bindings, automaton.parameters, scope.vocabulary.targets
        )
        for field, text in ((self.name, state.name), (self.note, state.note)):
            if field.text() != text and not field.hasFocus():
                field.setText(text)
        self.name.setPlaceholderText(shown_content(content, scope.library))

    # ----------------------------------------------------------------------------------------- changing

    def _new_content(self) -> Content | None:
        choice = self.new.choice
        if choice is not None:
            return choice.value  # type: ignore[return-value]  # `choices` offers contents
        return _flag_named(self.new.currentText())

    def _ready(self) -> None:
        self.add.setEnabled(self._new_content() is not None)

    def _pressed(self) -> None:
        self.new.field.setFocus()  # for the next one: the button has nothing to add then
        self._add()

    def _add(self) -> None:
        content = self._new_content()
        if content is None:
            return
        before = {state.id for state in self._automaton.states} if self._automaton else set()
        if not self._say(self._editing.do(add_state, content)) and self._automaton is not None:
            self.new.show_value(None)
            new = next((s.id for s in self._automaton.states if s.id not in before), "")
            self.refresh(new)

    def _content_chosen(self, choice: Choice | None) -> None:
        state = self._state
        if choice is None or state is None or choice.value == _plain(state.content):
            return
        content = choice.value
        if isinstance(content, Basic | Nested) and isinstance(state.content, Basic | Nested):
            slots = slots_of(self._editing, content)
            kept = {slot: bound for slot, bound in state.content.bindings.items() if slot in slots}
            content = type(content)(_held(content), kept)
        self._say(self._editing.do(set_content, state.id, content))

    def _bound(self, slot: str, binding: Binding) -> None:
        state = self._state
        if state is not None:
            self._say(self._editing.do(bind_state, state.id, slot, binding))

    def _named(self) -> None:
        state = self._state
        if state is not None and self.name.text().strip() != state.name:
            self._say(self._editing.do(rename_state, state.id, self.name.text().strip()))

    def _noted(self) -> None:
        state = self._state
        if state is not None and self.note.text() != state.note:
            self._say(self._editing.do(note_state, state.id, self.note.text()))

    def _say(self, message: str) -> str:
        self.trouble.say(message)
        return message


def _flag_named(text: str) -> RaiseFlag | None:
    """What raises the flag of these words, which begin with "raise"."""
    words = text.split(maxsplit=1)
    named = len(words) == 2 and words[0].casefold() == "raise"
    return RaiseFlag(words[1].strip()) if named else None


def _plain(content: Content) -> Content:
    """What a state holds, without its bindings."""
    return type(content)(_held(content)) if isinstance(content, Basic | Nested) else content


def _held(content: Basic | Nested) -> str:
    return content.behavior if isinstance(content, Basic) else content.automaton
