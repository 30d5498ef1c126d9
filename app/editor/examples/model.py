"""The examples of one automaton as a table: words are made only for rows that are looked at."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import IntEnum
from functools import cache
from operator import attrgetter
from typing import Any

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt, Signal

from ...core.automaton import Automaton
from ...core.examples import Example
from ...core.hierarchy import Node
from ...core.library import Library
from ...core.vocabulary import Vocabulary
from ...core.wording import example_words, node_words, reading_words, state_words
from .verdicts import MEANINGS, Verdict

Index = QModelIndex | QPersistentModelIndex
Role = Qt.ItemDataRole


class Column(IntEnum):
    """The columns, in order: what says and changes what is learned comes first."""

    ID = 0
    SOURCE = 1
    LABEL = 2
    WORDS = 3
    VERDICT = 4
    WEIGHT = 5
    NODE = 6
    TICK = 7
    DEMONSTRATION = 8


HEADERS: Mapping[Column, tuple[str, str]] = {
    Column.ID: ("Example", "Ticked: it is learned from"),
    Column.SOURCE: ("In", "The state that the node was in"),
    Column.LABEL: ("Goes to", "What it was to do next; double-click to relabel"),
    Column.WORDS: ("Because", "What the features said that decide here"),
    Column.NODE: ("Node", "Who was taught"),
    Column.TICK: ("Tick", "When"),
    Column.DEMONSTRATION: ("Demonstration", "Where it came from"),
    Column.WEIGHT: ("Weight", "How many examples it counts as; double-click to change"),
    Column.VERDICT: ("Learned", "Whether what was learned agrees"),
}


#: Columns that show what an example says of itself.
_PLAIN: Mapping[Column, Callable[[Example], str]] = {
    Column.ID: lambda example: example.id,
    Column.NODE: lambda example: node_called(example.node),
    Column.TICK: lambda example: f"{example.tick:,}",
    Column.DEMONSTRATION: lambda example: example.demonstration or "–",
    Column.WEIGHT: lambda example: f"{example.weight:g}",
}


@dataclass(frozen=True, slots=True)
class Subject:
    """The automaton whose examples are shown, with what it takes to put them into words."""

    type: str
    automaton: Automaton
    library: Library
    vocabulary: Vocabulary


def node_called(node_id: str) -> str:
    """What the user calls who an example is of, as far as its id tells: it may be in no arm any more."""
    return node_words(Node(node_id, "")) if node_id else "–"


def everything(_example: Example) -> bool:
    """What passes where nothing is filtered."""
    return True


def _counted(example: Example) -> int:
    """Ids that are numbers in their order; thousands of numbers are compared sooner than texts."""
    return int(example.id)


def _spelled(example: Example) -> tuple[int, str]:
    return len(example.id), example.id


class ExamplesModel(QAbstractTableModel):
    """Rows are examples that pass the filter, in the order that was asked for.

    Signals:
        edited: The user edits examples: column, ids, and the new value.
    """

    edited = Signal(int, object, object)

    def __init__(self) -> None:
        super().__init__()
        self.subject: Subject | None = None
        self._all: tuple[Example, ...] = ()
        self._shown: list[Example] = []
        self._places: dict[str, int] = {}
        self._verdicts: Mapping[str, Verdict] = {}
        self._passes: Callable[[Example], bool] = everything
        self._order: tuple[Column, bool] = (Column.ID, False)
        self._icons: Mapping[Verdict, Any] = {}

    # ------------------------------------------------------------------------------------------- what is shown

    def show(
        self,
        subject: Subject | None,
        examples: tuple[Example, ...],
        passes: Callable[[Example], bool] | None = None,
    ) -> None:
        """Show these examples of *subject*.

        Args:
            passes: Show only those that pass; by what `keep` was told last, if it is not given.
        """
        if not same_behavior(subject, self.subject):
            self._verdicts = {}  # those are on others with the same ids
        self.subject = subject
        self._all = examples
        self._passes = passes or self._passes
        self._arrange()

    def judge(self, verdicts: Mapping[str, Verdict]) -> None:
        """Show what became of the examples."""
        self._verdicts = verdicts
        if self._order[0] is Column.VERDICT:
            self._arrange()
        elif self._shown:
            last = len(self._shown) - 1
            self.dataChanged.emit(self.index(0, Column.VERDICT), self.index(last, Column.VERDICT))

    def keep(self, passes: Callable[[Example], bool]) -> None:
        """Show only examples that pass."""
        self._passes = passes
        self._arrange()

    def dress(self, icons: Mapping[Verdict, Any]) -> None:
        """Show these icons beside verdicts."""
        self._icons = icons

    def example(self, row: int) -> Example:
        """The example of a row."""
        return self._shown[row]

    def row_of(self, example_id: str) -> int:
        """The row of an example; -1 if it is not shown."""
        return self._places.get(example_id, -1)

    def rows_of(self, example_ids: Iterable[str]) -> list[int]:
        """The rows of those examples that are shown."""
        places = self._places
        return [places[example_id] for example_id in example_ids if example_id in places]

    def verdict(self, example: Example) -> Verdict:
        """What became of an example."""
        return self._verdicts.get(example.id, Verdict.UNKNOWN)

    @property
    def counts(self) -> tuple[int, int]:
        """How many examples are shown, and how many there are."""
        return len(self._shown), len(self._all)

    def _arrange(self) -> None:
        self.beginResetModel()
        passes = self._passes
        self._shown = list(self._all if passes is everything else filter(passes, self._all))
        column, falling = self._order
        self._shown.sort(key=self._key(column), reverse=falling)
        self._places = {example.id: row for row, example in enumerate(self._shown)}
        self.endResetModel()

    def _key(self, column: Column) -> Callable[[Example], Any]:
        shown = cache(self._state)  # of thousands of examples, few differ in their states
        match column:
            case Column.SOURCE:
                return lambda example: (shown(example.source), shown(example.label))
            case Column.LABEL | Column.WORDS:
                return lambda example: (shown(example.label), shown(example.source))
            case Column.NODE:
                return lambda example: (len(example.node), example.node)
            case Column.TICK:
                return lambda example: (example.demonstration, example.tick)
            case Column.DEMONSTRATION:
                return lambda example: example.demonstration
            case Column.WEIGHT:
                return lambda example: example.weight
            case Column.VERDICT:
                order = {verdict: place for place, verdict in enumerate(Verdict)}
                return lambda example: order[self.verdict(example)]
            case _:
                return _counted if all(map(str.isdecimal, map(attrgetter("id"), self._shown))) else _spelled

    def _state(self, state_id: str) -> str:
        assert self.subject is not None
        automaton = self.subject.automaton
        if not automaton.has_state(state_id):
            return f"{state_id} (gone)"
        return state_words(automaton, state_id, self.subject.library)

    # --------------------------------------------------------------------------------------------- for the view

    def rowCount(self, parent: Index | None = None) -> int:
        """How many examples are shown."""
        return 0 if parent is not None and parent.isValid() else len(self._shown)

    def columnCount(self, _parent: Index | None = None) -> int:
        """How many columns there are."""
        return len(Column)

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = Role.DisplayRole) -> Any:
        """Titles and what they mean."""
        if orientation is not Qt.Orientation.Horizontal:
            return None
        title, tip = HEADERS[Column(section)]
        return {Role.DisplayRole: title, Role.ToolTipRole: tip}.get(Role(role))

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Whether an example is learned from can be ticked; its label and weight can be edited."""
        flags = super().flags(index)
        if index.column() == Column.ID:
            flags |= Qt.ItemFlag.ItemIsUserCheckable
        if index.column() in (Column.LABEL, Column.WEIGHT):
            flags |= Qt.ItemFlag.ItemIsEditable
        return flags

    def data(self, index: Index, role: int = Role.DisplayRole) -> Any:
        """What a cell shows."""
        if not index.isValid() or self.subject is None:
            return None
        example, column = self._shown[index.row()], Column(index.column())
        match role:
            case Role.DisplayRole:
                return self._text(example, column)
            case Role.EditRole:
                return example.label if column is Column.LABEL else example.weight
            case Role.ToolTipRole:
                return self._tip(example, column)
            case Role.CheckStateRole if column is Column.ID:
                return Qt.CheckState.Checked if example.enabled else Qt.CheckState.Unchecked
            case Role.DecorationRole if column is Column.VERDICT:
                return self._icons.get(self.verdict(example))
            case Role.UserRole:
                return example
        return None

    def setData(self, index: Index, value: Any, role: int = Role.EditRole) -> bool:
        """Ask for an edit; the table changes when the project has."""
        column = Column(index.column())
        example = self._shown[index.row()]
        if role == Role.CheckStateRole and column is Column.ID:
            self.edited.emit(column, (example.id,), Qt.CheckState(value) is Qt.CheckState.Checked)
            return True
        if role == Role.EditRole and value != self.data(index, Role.EditRole):
            self.edited.emit(column, (example.id,), value)
            return True
        return False

    def sort(self, column: int, order: Qt.SortOrder = Qt.SortOrder.AscendingOrder) -> None:
        """Put the rows into another order."""
        self._order = Column(max(column, 0)), order is Qt.SortOrder.DescendingOrder
        self._arrange()

    def _text(self, example: Example, column: Column) -> str:
        match column:
            case Column.SOURCE:
                return self._state(example.source)
            case Column.LABEL:
                return self._state(example.label)
            case Column.WORDS:
                return self._words(example)
            case Column.VERDICT:
                return str(self.verdict(example))
        return _PLAIN[column](example)

    def _words(self, example: Example) -> str:
        """The reasons alone: both states have columns of their own."""
        assert self.subject is not None
        subject = self.subject
        words = example_words(example, subject.automaton, subject.library, subject.vocabulary)
        return words.partition(" when ")[2] or "always"

    def _tip(self, example: Example, column: Column) -> str:
        assert self.subject is not None
        if column is Column.VERDICT:
            return MEANINGS[self.verdict(example)]
        automaton, vocabulary = self.subject.automaton, self.subject.vocabulary
        told = [
            f"{use.shown}: {reading_words(use, example.values[use.id], vocabulary)}"
            for use in automaton.features
            if use.id in example.values
        ]
        kind = "it goes on doing what was just picked" if example.continuation else "a pick"
        return "\n".join([f"example {example.id}, {kind}", *told])


def same_behavior(one: Subject | None, other: Subject | None) -> bool:
    """Whether both are about one behavior, though it may have changed in between."""
    if one is None or other is None:
        return one is other
    return (one.type, one.automaton.id) == (other.type, other.automaton.id)


def states_of(subject: Subject) -> Sequence[tuple[str, str]]:
    """Ids and names of the states that an example can go to."""
    automaton = subject.automaton
    return [(state.id, state_words(automaton, state.id, subject.library)) for state in automaton.states[1:]]
