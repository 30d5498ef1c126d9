"""The examples of the automaton that is shown."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QItemSelection, QItemSelectionModel, QModelIndex, QPoint, Qt, QTimer, Signal
from PySide6.QtWidgets import QInputDialog, QLabel, QMenu, QStackedLayout, QVBoxLayout, QWidget

from ...core.amounts import counted
from ...core.edits import disable_examples, enable_examples, relabel_examples, weight_examples
from ...core.remembered import Remembered
from ...engine.snapshots import Mode
from ...engine.turns import AFTER_EDITS
from ...engine.worker import Worker
from ..forms.nothing import NothingFound
from ..icons import icon
from ..row_spans import selected_rows, spans
from ..soon import Soon
from .delegates import HEAVIEST
from .filters import FilterBar
from .model import Column, ExamplesModel, Subject, same_behavior, states_of
from .rows import example_rows
from .table import ExamplesTable
from .verdicts import Judged, Matter, Verdict, judge

if TYPE_CHECKING:
    from ...core.examples import Example
    from ..studio import Studio

_ICONS = {
    Verdict.CONFLICT: ("swap-horizontal-bold", "teach"),
    Verdict.OUTVOTED: ("alert-outline", "accent"),
    Verdict.LEFT_OUT: ("minus-circle-outline", "dim"),
    Verdict.AGREES: ("check", "good"),
    Verdict.OFF: ("circle-off-outline", "dim"),
    Verdict.UNKNOWN: ("help", "dim"),
    Verdict.UNTOLD: ("help", "dim"),
}
#: Milliseconds without another change before examples are judged: ten thousand take a while, and what is shown goes first.
PATIENCE = 120
NOTHING_FOUND = "No example passes the filters. Show all takes them away."
NOBODY = "Choose a behavior in the library, or make one there, to see what it was shown."
EMPTY = "No examples yet. Choose an agent, press Teach, and pick what it is to do: each pick is an example."
TAUGHT = "No examples yet. Pick in the panel Teach what it is to do: each pick is an example."


class ExamplesPanel(QWidget):
    """A table of examples that can be filtered, sorted, relabeled, weighted, and switched off.

    Signals:
        title_changed: How many there are.
    """

    title_changed = Signal(str)
    _judged = Signal()

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self.model = ExamplesModel()
        self.filters = FilterBar(self.model)
        self.table = ExamplesTable(self.model)
        self._worker = Worker(
            AFTER_EDITS.taken(judge), lambda matter, _: Judged(matter, {}), self._judged.emit, "judge"
        )
        self._empty = QLabel(NOBODY)
        self._empty.setProperty("role", "empty")
        self._empty.setWordWrap(True)
        self._empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._lay_out()
        NothingFound(self.table, NOTHING_FOUND, lambda: not self.filters.is_open)
        self._shown: tuple[object, object] = (None, None)
        self._cursor = "", 0  # an example and a column
        self._matter: Matter | None = None
        self._chosen_kinds = Remembered[str, set[bool]]()
        self._selecting = False
        self._closed = False
        self._connect()
        studio.actions.add(example_rows(self))
        studio.closing.connect(self._close)
        self._dress()
        self.refresh()

    def _lay_out(self) -> None:
        full = QWidget()
        column = QVBoxLayout(full)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.filters)
        column.addWidget(self.table, 1)
        self._pages = QStackedLayout(self)
        self._pages.addWidget(self._empty)
        self._pages.addWidget(full)
        self.setFocusProxy(self.table)

    def _connect(self) -> None:
        studio = self._studio
        self._soon = Soon(self, self.refresh)
        self._judge_soon = QTimer(self, interval=PATIENCE, singleShot=True)
        self._judge_soon.timeout.connect(self._judge)
        for signal in (studio.document.project_changed, studio.opened, studio.selection.behavior_changed):
            signal.connect(self._changed)
        self.table.edit_ended.connect(self._soon.ask)
        self.table.customContextMenuRequested.connect(self._menu)
        studio.selection.examples_changed.connect(self._show_selected)
        studio.theme.changed.connect(self._dress)
        studio.bridge.mode_changed.connect(self._say_what_to_do)
        self.filters.changed.connect(self._filter)
        self.model.edited.connect(self._edit)
        self._judged.connect(self._take_verdicts)
        self.table.selectionModel().selectionChanged.connect(self._selected)
        self.table.selectionModel().currentChanged.connect(self._cursor_moved)

    def _close(self) -> None:
        """Ask no more: whatever still changes while the window closes is not judged."""
        self._closed = True
        self._judge_soon.stop()
        self._worker.close()

    # --------------------------------------------------------------------------------------------- showing

    def refresh(self) -> None:
        """Show the examples that there are now, unless one is being edited: that would end it."""
        if self.table.is_editing:
            return
        subject, examples = self._subject()
        now = (None if subject is None else subject.automaton, examples)
        if now[0] is self._shown[0] and now[1] is self._shown[1]:
            return
        self._shown = now
        if not same_behavior(subject, self.model.subject):
            self.filters.forget()
        self.filters.offer(subject, examples)
        self._selecting = True
        self.model.show(subject, examples, self.filters.passes())
        self._selecting = False
        self._pages.setCurrentIndex(1 if examples else 0)
        self._say_what_to_do()
        self._say_counts()
        self._matter = None if subject is None else Matter(subject.automaton, examples)
        if not self._closed:
            self._judge_soon.start()

    def _say_what_to_do(self) -> None:
        """Where there is nothing to show, say what is to be done first."""
        if self._shown[0] is None:
            self._empty.setText(NOBODY)
        else:
            self._empty.setText(TAUGHT if self._studio.mode is Mode.TEACHING else EMPTY)

    def _changed(self) -> None:
        """Judge no more what may not be shown any more, and show soon what is."""
        self._soon.ask()
        if self._worker.busy and not self._matters():
            self._worker.give_up()
            self._judge_soon.start()  # it may be shown again by then

    def _matters(self) -> bool:
        """Whether what is judged is what there is to show."""
        (subject, examples), matter = self._subject(), self._matter
        if subject is None or matter is None:
            return False
        return matter.automaton is subject.automaton and matter.examples is examples

    def _judge(self) -> None:
        if self._matter is not None:
            self._worker.ask(self._matter)

    def _subject(self) -> tuple[Subject | None, tuple[Example, ...]]:
        document, shown = self._studio.document, self._studio.selection.behavior
        automaton = None if shown is None else document.automaton(shown.type, shown.id)
        if shown is None or automaton is None:
            return None, ()
        library = document.project.library(shown.type)
        subject = Subject(shown.type, automaton, library, document.scenario.vocabulary)
        return subject, document.project.examples_of(shown.type, shown.id)

    def _filter(self) -> None:
        self._selecting = True
        self.model.keep(self.filters.passes())
        self._selecting = False
        self._say_counts()

    def show_conflicts(self) -> None:
        """Show only examples that contradict each other, once they are judged."""
        self.refresh()
        self.filters.forget()
        self.filters.choose(self.filters.verdict, Verdict.CONFLICT)
        self._studio.show_panel.emit("examples")

    def _say_counts(self) -> None:
        """Say how many pass, and select what is selected."""
        shown, there = self.model.counts
        self.filters.count.setText(f"{shown:,} of {there:,}" if shown != there else counted(there, "example"))
        self.filters.clear.setEnabled(not self.filters.is_open)
        self.title_changed.emit(f"Examples {there:,}" if there else "Examples")
        self._show_selected()

    def _take_verdicts(self) -> None:
        for judged in self._worker.answers():
            if judged.matter is not self._matter:
                continue  # something else is shown by now, and will be judged
            self.model.judge(judged.verdicts)
            if self.filters.verdict.currentData() is not None:
                self._filter()

    def _dress(self) -> None:
        theme = self._studio.theme
        self.model.dress({v: icon(name, theme, color) for v, (name, color) in _ICONS.items()})

    # ------------------------------------------------------------------------------------------ selecting

    @property
    def chosen(self) -> tuple[str, ...]:
        """Ids of the examples that are selected."""
        return self._studio.selection.examples

    def has_chosen(self, *, on: bool) -> bool:
        """Whether any of the selected examples is learned from, or kept from it."""
        shown, chosen = self._studio.selection.behavior, self.chosen
        if shown is None or not chosen:
            return False
        there = self._studio.document.project.examples_of(shown.type, shown.id)

        def kinds() -> set[bool]:
            wanted = set(chosen)
            return {example.enabled for example in there if example.id in wanted}

        return on in self._chosen_kinds.of("", (chosen, there), kinds)

    @property
    def has_moment(self) -> bool:
        """Whether a single example is selected, and its moment is known."""
        example = self._only_chosen()
        return example is not None and example.snapshot in self._studio.document.project.moments

    def _selected(self) -> None:
        if self._selecting:
            return
        rows = selected_rows(self.table.selectionModel().selection())
        ids = [self.model.example(row).id for row in rows]
        self._selecting = True
        self._studio.selection.select_examples(ids)
        self._selecting = False
        self.show_moment()

    def _show_selected(self) -> None:
        """Select the rows of the examples that are selected."""
        if self._selecting:
            return
        selection = QItemSelection()
        end = len(Column) - 1
        rows = self.model.rows_of(self.chosen)
        for first, last in spans(rows):
            selection.select(self.model.index(first, 0), self.model.index(last, end))
        self._selecting = True
        self.table.selectionModel().select(selection, QItemSelectionModel.SelectionFlag.ClearAndSelect)
        self._selecting = False
        if rows:
            self._put_cursor(rows)

    def _put_cursor(self, rows: Sequence[int]) -> None:
        """Where it was before the rows came anew, if it is in one of *rows*; else in the first: arrow keys go on from there."""
        was, column = self._cursor
        row = self.model.row_of(was)
        at = self.model.index(row if row in rows else rows[0], column)
        self.table.selectionModel().setCurrentIndex(at, QItemSelectionModel.SelectionFlag.NoUpdate)
        self.table.scrollTo(at)

    def _cursor_moved(self, index: QModelIndex) -> None:
        if index.isValid():
            self._cursor = self.model.example(index.row()).id, index.column()

    def show_moment(self) -> None:
        """Show on the canvas the moment in which the selected example was recorded; of several or none, the present."""
        example = self._only_chosen()
        moments = self._studio.document.project.moments
        if example is None or example.snapshot not in moments:
            self._studio.moment_wanted.emit(None, "", "")
            return
        caption = f"The moment of example {example.id}"
        self._studio.attempt(
            lambda: self._studio.moment_wanted.emit(moments[example.snapshot], example.node, caption)
        )

    def _only_chosen(self) -> Example | None:
        if len(self.chosen) != 1:
            return None
        row = self.model.row_of(self.chosen[0])
        return None if row < 0 else self.model.example(row)

    def _first_chosen(self) -> Example | None:
        """The first selected example that is shown."""
        rows = self.model.rows_of(self.chosen)
        return self.model.example(rows[0]) if rows else None

    # ------------------------------------------------------------------------------------------- editing

    def _edit(self, column: int, ids: tuple[str, ...], value: object) -> None:
        """Carry out what was edited in a cell, for all selected examples if it is one of them."""
        chosen = self.chosen if ids[0] in self.chosen else ids
        if column == Column.ID:
            self._change(enable_examples if value else disable_examples, chosen)
        elif column == Column.LABEL:
            self._change(relabel_examples, chosen, value)
        elif column == Column.WEIGHT:
            self._change(weight_examples, chosen, value)

    def _change(self, edit: Callable[..., Any], ids: tuple[str, ...], *more: object) -> None:
        shown = self._studio.selection.behavior
        if shown is not None and ids:
            self._studio.document.attempt(edit, shown.type, shown.id, ids, *more)

    def switch(self, *, on: bool) -> None:
        """Learn from the selected examples again, or no longer."""
        self._change(enable_examples if on else disable_examples, self.chosen)

    def relabel(self) -> None:
        """Let the selected examples say something else."""
        subject = self.model.subject
        if subject is None or not self.chosen:
            return
        ids, names = zip(*states_of(subject), strict=True)
        first = self._first_chosen()
        now = ids.index(first.label) if first is not None and first.label in ids else 0
        name, ok = QInputDialog.getItem(
            self, "Relabel", f"{self._chosen_words('goes', 'go')} to", names, now, editable=False
        )
        if ok:
            self._change(relabel_examples, self.chosen, ids[names.index(name)])

    def weigh(self) -> None:
        """Let the selected examples count more or less."""
        first = self._first_chosen()
        now = 1.0 if first is None else first.weight
        weight, ok = QInputDialog.getDouble(
            self, "Weight", f"{self._chosen_words('counts', 'count each')} as", now, 0.0, HEAVIEST, 2
        )
        if ok:
            self._change(weight_examples, self.chosen, weight)

    def _chosen_words(self, one: str, many: str) -> str:
        """What the selected examples do: "Example 3 goes"."""
        ids = self.chosen
        return f"Example {ids[0]} {one}" if len(ids) == 1 else f"These {counted(len(ids), 'example')} {many}"

    def _menu(self, at: QPoint) -> None:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        for row in example_rows(self):
            menu.addAction(self._studio.actions[row.id])
        menu.popup(self.table.viewport().mapToGlobal(at))
