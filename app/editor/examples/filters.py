"""Which examples are shown: by state, label, node, demonstration, and what became of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from operator import attrgetter
from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QPushButton, QSizePolicy, QWidget

from ...core.wording import state_words
from ..forms.word_list import WordList
from .model import everything, node_called
from .verdicts import Verdict

if TYPE_CHECKING:
    from ...core.examples import Example
    from .model import ExamplesModel, Subject

#: Pixels that a box is wide at least, and that it needs beside its words.
LEAST, FRAME = 68, 42


class FilterBar(QWidget):
    """A row of boxes, each of which narrows the table.

    Signals:
        changed: Another choice was made.
    """

    changed = Signal()

    def __init__(self, model: ExamplesModel) -> None:
        super().__init__()
        self._model = model
        layout = QHBoxLayout(self)
        layout.setContentsMargins(8, 4, 8, 4)
        layout.setSpacing(6)
        self.source = self._box(layout, "in", "Only examples of nodes that were in this state")
        self.label = self._box(layout, "goes to", "Only examples that say so")
        self.node = self._box(layout, "node", "Only examples of this node")
        self.demonstration = self._box(layout, "from", "Only examples of this demonstration")
        self.verdict = self._box(layout, "learned", "Only examples of which this is true")
        self.clear = QPushButton("Show all")
        self.clear.setToolTip("Filter nothing")
        self.clear.clicked.connect(self.reset)
        self.count = QLabel()
        self.count.setProperty("role", "caption")
        layout.addWidget(self.clear)
        layout.addStretch(1)
        layout.addWidget(self.count)
        _fill(self.verdict, [(str(v), v) for v in Verdict])

    @property
    def boxes(self) -> tuple[QComboBox, ...]:
        """All boxes."""
        return self.source, self.label, self.node, self.demonstration, self.verdict

    @property
    def is_open(self) -> bool:
        """Whether everything passes."""
        return all(box.currentData() is None for box in self.boxes)

    def reset(self) -> None:
        """Let everything pass."""
        self.forget()
        self.changed.emit()

    def forget(self) -> None:
        """Let everything pass, since something else is to be filtered; nobody is told."""
        for box in self.boxes:
            box.setCurrentIndex(0)

    def offer(self, subject: Subject | None, examples: tuple[Example, ...]) -> None:
        """Offer what there is to choose from; choices that still make sense stay."""
        if subject is None:
            for box in self.boxes[:-1]:
                _fill(box, [])
            return
        automaton = subject.automaton

        def name(state_id: str) -> str:
            return (
                state_words(automaton, state_id, subject.library)
                if automaton.has_state(state_id)
                else state_id
            )

        _fill(self.source, [(name(state), state) for state in _distinct(map(attrgetter("source"), examples))])
        _fill(self.label, [(name(state), state) for state in _distinct(map(attrgetter("label"), examples))])
        nodes = sorted(_distinct(map(attrgetter("node"), examples)), key=lambda node: (len(node), node))
        _fill(self.node, [(node_called(node), node) for node in nodes])
        taught = sorted(_distinct(map(attrgetter("demonstration"), examples)))
        _fill(self.demonstration, [(d or "no name", d) for d in taught])

    def choose(self, box: QComboBox, value: object) -> None:
        """Narrow the table by one value."""
        box.setCurrentIndex(max(0, box.findData(value)))
        self.changed.emit()

    def passes(self) -> Callable[[Example], bool]:
        """The test that examples have to pass."""
        if self.is_open:
            return everything
        source, label, node, demonstration, verdict = (box.currentData() for box in self.boxes)
        model = self._model

        def test(example: Example) -> bool:
            return (
                source in (None, example.source)
                and label in (None, example.label)
                and node in (None, example.node)
                and demonstration in (None, example.demonstration)
                and (verdict is None or model.verdict(example) == verdict)
            )

        return test

    def _box(self, layout: QHBoxLayout, caption: str, tip: str) -> QComboBox:
        box = WordList()
        box.setToolTip(tip)
        box.setAccessibleName(f"filter: {caption}")
        box.setMinimumContentsLength(1)
        box.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        box.setMinimumWidth(max(LEAST, box.fontMetrics().horizontalAdvance(caption) + FRAME))
        box.setMaximumWidth(150)
        box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        box.addItem(caption[:1].upper() + caption[1:], None)  # that filters nothing: as the column is called
        box.activated.connect(lambda _: self.changed.emit())
        layout.addWidget(box, len(caption) + 5)  # longer captions get more of what room there is
        return box


def _fill(box: QComboBox, entries: Iterable[tuple[str, object]]) -> None:
    """Other entries; the one chosen stays chosen if it is still there."""
    entries = list(entries)
    there = [(box.itemText(k), box.itemData(k)) for k in range(1, box.count())]
    if entries == there:
        return
    chosen, anything = box.currentData(), box.itemText(0)
    box.clear()
    box.addItem(anything, None)
    for text, value in entries:
        box.addItem(text, value)
    box.setCurrentIndex(max(0, box.findData(chosen)) if chosen is not None else 0)


def _distinct(values: Iterable[str]) -> list[str]:
    return list(dict.fromkeys(values))
