"""What a feature is made of, chosen only from what exists: the senses, flags, time, and statistics over those below."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from enum import Enum

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QFormLayout, QVBoxLayout, QWidget

from ...core.automaton import Automaton
from ...core.check.scope import Scope
from ...core.features import (
    Binding,
    FlagUp,
    Operation,
    Over,
    Sense,
    Source,
    Statistic,
    TicksInState,
    describe,
)
from ...core.vocabulary import STANDARD_FLAGS, Feature, FeatureKind
from ..forms.choosing import Choice, Chooser
from ..forms.slot_form import BoxForm, SlotForm
from ..forms.word_list import WordList

#: How a controller sums up, in words.
OPERATIONS: Mapping[Operation, tuple[str, str]] = {
    Operation.ANY: ("somebody", "True if it is true of at least one"),
    Operation.ALL: ("everybody", "True if it is true of all of them"),
    Operation.COUNT: ("how many", "The number of those of whom it is true"),
    Operation.MEAN: ("mean", "The mean of their values"),
    Operation.MIN: ("least", "The least of their values"),
    Operation.MAX: ("greatest", "The greatest of their values"),
}
#: What says something of facts, and of measures.
COUNTING = (Operation.ANY, Operation.ALL, Operation.COUNT)
MEASURING = (Operation.MEAN, Operation.MIN, Operation.MAX)
OVERS: Mapping[Over, tuple[str, str]] = {
    Over.AGENTS: ("all agents below", "However deep they stand"),
    Over.SUBSIDIARIES: ("direct subsidiaries", "Only those right below the controller"),
}


class Sort(Enum):
    """What sort of feature it is."""

    SENSE = "sense"
    STATISTIC = "statistic"


class SourceForm(QWidget):
    """A form for a feature's source.

    Attributes:
        what: What is looked at.
        operation, over: For statistics.

    Signals:
        changed: The user chose something else.
        entered: Enter was pressed in what is chosen after what is looked at.
    """

    changed = Signal()
    entered = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._scope: Scope | None = None
        self._bindings: dict[str, Binding] = {}
        self._parameters: tuple[str, ...] = ()
        self.what = Chooser("What the feature looks at", "what to look at")
        self.what.chosen.connect(self._what_chosen)
        self.operation = _box("How it is summed up", OPERATIONS)
        self.over = _box("Over whom it is summed up", OVERS)
        for box in (self.operation, self.over):
            box.activated.connect(lambda _: self.changed.emit())
        self.slots = SlotForm()
        self.slots.bound.connect(self._bound)
        self._statistic = BoxForm()
        for boxes in (self._statistic, self.slots):
            boxes.entered.connect(self.entered)
        form = QFormLayout(self._statistic)
        form.setContentsMargins(0, 0, 0, 0)
        form.addRow("Of", self.over)
        form.addRow("Sum up as", self.operation)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.what)
        column.addWidget(self._statistic)
        column.addWidget(self.slots)

    def offer(self, scope: Scope, automaton: Automaton, source: Source | None) -> None:
        """Offer what exists in a scope for an automaton; show *source*."""
        self._scope, self._parameters = scope, automaton.parameters
        self._bindings = dict(_bindings(source))
        offered = list(sources(scope, automaton))
        plain = None if source is None else _plain(source)
        if plain is not None and all(choice.value != plain for choice in offered):
            offered.append(Choice(describe(source) if source else "", plain))
        self.what.offer(offered, plain)
        if isinstance(source, Statistic):
            self._offer_operations(source.operation)
            self.over.setCurrentIndex(list(OVERS).index(source.over))
        self._show_parts()

    @property
    def source(self) -> Source | None:
        """What is chosen; None while something is missing."""
        return None if self.missing else self._made()

    @property
    def missing(self) -> str:
        """What is still to be chosen, in words; empty if nothing is."""
        choice = self.what.choice
        if choice is None:
            return "choose what to look at"
        lacking = [slot for slot in self._slots() if slot not in self._bindings]
        return f"choose what {lacking[0]!r} is" if lacking else ""

    def _made(self) -> Source | None:
        choice = self.what.choice
        if choice is None:
            return None
        sort, inner = _value(choice)
        bound = {slot: self._bindings[slot] for slot in self._slots() if slot in self._bindings}
        source = Sense(inner.feature, bound) if isinstance(inner, Sense) else inner
        if sort is Sort.SENSE:
            return source
        assert isinstance(source, Sense | FlagUp)
        return Statistic(Operation(self.operation.currentData()), source, Over(self.over.currentData()))

    def _slots(self) -> tuple[str, ...]:
        choice = self.what.choice
        feature = None if choice is None else self._feature(choice)
        return () if feature is None else feature.parameters

    def _feature(self, choice: Choice) -> Feature | None:
        sort, inner = _value(choice)
        if self._scope is None or not isinstance(inner, Sense):
            return None
        known = self._scope.vocabulary if sort is Sort.SENSE else self._scope.statistics
        return known.features.get(inner.feature)

    def go_on(self) -> bool:
        """Let the keys go to what is to be chosen after what is looked at; whether there is anything."""
        choice = self.what.choice
        self._show_choice()
        parts: list[QWidget] = list(self.slots.boxes.values())
        if choice is not None and _value(choice)[0] is Sort.STATISTIC:
            parts.insert(0, self.over)
        if parts:
            parts[0].setFocus(Qt.FocusReason.TabFocusReason)
        return bool(parts)

    def _show_choice(self) -> None:
        self._offer_operations()
        self._show_parts()

    def _what_chosen(self, choice: Choice | None) -> None:
        self._show_choice()
        if choice is not None:
            self.changed.emit()

    def _offer_operations(self, chosen: Operation | None = None) -> None:
        """Offer the operations that fit what is summed up, and *chosen* if it is another."""
        choice = self.what.choice
        feature = None if choice is None else self._feature(choice)
        is_fact = feature is None or feature.kind is FeatureKind.BOOLEAN  # flags are facts as well
        fitting = list(COUNTING if is_fact else MEASURING)
        fitting += [chosen] if chosen is not None and chosen not in fitting else []
        if fitting != [self.operation.itemData(k) for k in range(self.operation.count())]:
            _fill(self.operation, {operation: OPERATIONS[operation] for operation in fitting})
        if chosen is not None:
            self.operation.setCurrentIndex(fitting.index(chosen))

    def _show_parts(self) -> None:
        choice, scope = self.what.choice, self._scope
        self._statistic.setVisible(choice is not None and _value(choice)[0] is Sort.STATISTIC)
        if scope is not None:
            self.slots.show_slots(self._slots(), self._bindings, self._parameters, scope.vocabulary.targets)

    def _bound(self, slot: str, binding: Binding) -> None:
        self._bindings[slot] = binding
        self.changed.emit()


def sources(scope: Scope, automaton: Automaton) -> Iterator[Choice]:
    """All that an automaton can look at, without bindings."""
    for name, feature in scope.vocabulary.features.items():
        yield Choice(_called(feature), (Sort.SENSE, Sense(name)), _tip(feature))
    held = [scope.raised.get(nested, frozenset()) for nested in automaton.nested()]
    for flag in sorted(frozenset().union(*held, STANDARD_FLAGS[:1])):
        tip = f"Whether the behavior of the current state has raised the flag {flag!r}"
        yield Choice(f"flag {flag}", (Sort.SENSE, FlagUp(flag)), tip)
    yield Choice("TicksInState", (Sort.SENSE, TicksInState()), "Ticks since the current state was entered")
    if scope.type.level:
        for name, feature in scope.statistics.features.items():
            tip = f"Summed up over those below: {_tip(feature)}"
            yield Choice(f"agents' {_called(feature)}", (Sort.STATISTIC, Sense(name)), tip)
        for flag in sorted(frozenset().union(*scope.shown.values())):
            tip = f"Summed up over those below: whether the flag {flag!r} is up"
            yield Choice(f"subsidiaries' flag {flag}", (Sort.STATISTIC, FlagUp(flag)), tip)


def _called(feature: Feature) -> str:
    return f"{feature.name}({', '.join(feature.parameters)})" if feature.parameters else feature.name


def _tip(feature: Feature) -> str:
    unit = f", in {feature.unit}" if feature.unit else ""
    return f"{feature.doc} ({feature.kind}{unit})"


def _value(choice: Choice) -> tuple[Sort, Source]:
    return choice.value  # type: ignore[return-value]  # `sources` offers these pairs


def _plain(source: Source) -> tuple[Sort, Source]:
    """A source as `sources` offers it: without bindings."""
    if isinstance(source, Statistic):
        return Sort.STATISTIC, _plain(source.of)[1]
    return Sort.SENSE, Sense(source.feature) if isinstance(source, Sense) else source


def _bindings(source: Source | None) -> Mapping[str, Binding]:
    match source:
        case Sense(_, bindings) | Statistic(_, Sense(_, bindings)):
            return bindings
    return {}


def _box(
    name: str, entries: Mapping[Operation, tuple[str, str]] | Mapping[Over, tuple[str, str]]
) -> QComboBox:
    box = WordList()
    box.setAccessibleName(name)
    box.setToolTip(name)
    _fill(box, entries)
    return box


def _fill(
    box: QComboBox, entries: Mapping[Operation, tuple[str, str]] | Mapping[Over, tuple[str, str]]
) -> None:
    box.clear()
    for value, (words, tip) in entries.items():
        box.addItem(words, value)
        box.setItemData(box.count() - 1, tip, Qt.ItemDataRole.ToolTipRole)
