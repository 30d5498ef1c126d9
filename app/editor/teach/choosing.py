"""Targets that are to be chosen, from a menu or by a click in the world: for what is taught, or for what is added to it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ...core.automaton import Basic, Nested
from ...core.features import Binding, Ground, Parameter
from .choices import Choice

if TYPE_CHECKING:
    from ..studio import Studio
    from .teaching import Teaching


class Choosing(QObject):
    """What is still to be bound before a lesson or a new state can begin.

    Attributes:
        adding: The behavior that is to become a state once all its slots are bound; None if there is none.
        bindings: What its slots are bound to so far.
        wanted: The slot that the user is asked to choose in the world now; empty if there is none.

    Signals:
        changed: One of them is another.
        several: A click could mean several targets: the slot, and their names.
    """

    changed = Signal()
    several = Signal(str, object)

    def __init__(self, studio: Studio, teaching: Teaching) -> None:
        super().__init__()
        self._studio = studio
        self._teaching = teaching
        self.adding: Choice | None = None
        self.bindings: dict[str, Binding] = {}
        self.wanted = ""

    @property
    def is_busy(self) -> bool:
        """Whether something is being chosen."""
        return self.adding is not None or self.wanted != ""

    @property
    def slots(self) -> tuple[str, ...]:
        """What can be bound now: the slots of what is added, or else the parameters of what is taught."""
        if self.adding is not None:
            return self.adding.slots
        automaton = self._teaching.automaton
        return () if automaton is None else automaton.parameters

    def bound(self, slot: str) -> Binding | None:
        """What a slot is bound to, if it is."""
        if self.adding is not None:
            return self.bindings.get(slot)
        target = self._teaching.arguments.get(slot)
        return None if target is None else Ground(target)

    def options(self) -> tuple[Binding, ...]:
        """All that a slot can be bound to: parameters of the automaton for a new state, then targets."""
        key, automaton = self._teaching.key, self._teaching.automaton
        if key is None or automaton is None:
            return ()
        targets = [Ground(name) for name in self._studio.document.vocabulary(key.type).targets]
        own = [Parameter(name) for name in automaton.parameters] if self.adding is not None else []
        return (*own, *targets)

    def meanings(self) -> Mapping[str, int]:
        """Which entity each target is to the node now, -1 for nobody; empty while that is not known."""
        snapshot = self._studio.snapshot
        watched = None if snapshot is None else snapshot.watched.get(self._teaching.node)
        return {} if watched is None else watched.targets

    # ----------------------------------------------------------------------------------------- choosing

    def add(self, choice: Choice) -> None:
        """Begin to bind the slots of a behavior that is to become a state; it is picked once all are bound."""
        self._end_asking()
        self.adding, self.bindings = choice, {}
        self._ask_for_next(choice)

    def _ask_for_next(self, choice: Choice) -> None:
        """A click in the world can say at once what the first open slot is; the menus say it as well."""
        if open_slots := [slot for slot in choice.slots if slot not in self.bindings]:
            self.ask_for(open_slots[0])
        else:
            self.changed.emit()

    def bind(self, slot: str, binding: Binding) -> None:
        """Bind a slot."""
        self._end_asking()
        if self.adding is not None:
            self.bindings[slot] = binding
            self._pick_if_bound(self.adding)
            if self.adding is not None:
                self._ask_for_next(self.adding)
        elif isinstance(binding, Ground):
            self._teaching.set_argument(slot, binding.target)
        self.changed.emit()

    def _pick_if_bound(self, choice: Choice) -> None:
        content = choice.content
        if set(choice.slots) <= self.bindings.keys() and isinstance(content, Basic | Nested):
            bound = replace(content, bindings={slot: self.bindings[slot] for slot in choice.slots})
            self.adding, self.bindings = None, {}
            self._teaching.pick(bound)

    def ask_for(self, slot: str) -> None:
        """Ask the user to click what *slot* is to be."""
        self.wanted = slot
        of = self.adding.name if self.adding is not None else getattr(self._teaching.automaton, "name", "")
        self._teaching.choose_requested.emit(f"click what {slot} of {of} is to be, or press Enter for a list")
        self.changed.emit()

    def entity_chosen(self, entity: int) -> None:
        """The user has clicked something in the world: whatever means it now is chosen."""
        slot, place = self.wanted, None if self._studio.snapshot is None else self._studio.snapshot.place
        if not slot or place is None:
            return
        meanings = self.meanings()
        names = [name for name, meant in meanings.items() if meant == entity and entity >= 0]
        if len(names) == 1:
            self.bind(slot, Ground(names[0]))
        elif names:
            self._end_asking()
            self.several.emit(slot, tuple(names))
        else:
            who = place.called(self._teaching.node)
            self._studio.warn(_nobody_means(place.entity_called(entity), who, meanings))
            self.ask_for(slot)

    def cancel(self) -> None:
        """Choose nothing after all."""
        if self.is_busy:
            self._end_asking()
            self.adding, self.bindings = None, {}
            self.changed.emit()

    def _end_asking(self) -> None:
        if self.wanted:
            self.wanted = ""
            self._teaching.choose_ended.emit()


def _nobody_means(what: str, who: str, meanings: Mapping[str, int]) -> str:
    if not meanings:
        return "select the node that is taught first, so that it is known what it can mean by a click"
    there = ", ".join(meanings)
    return f"{who} has no target that is {what} now; click something else, or choose from the menu: {there}"
