"""The experiments of the project in a list, and what makes, changes, copies and deletes one."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QListWidget, QListWidgetItem, QVBoxLayout, QWidget

from ...core.errors import UnderstudyError
from ...engine.experiments.keeping import delete_experiment
from ..documents.asking import Answer, Question
from ..forms.buttons import text_button
from ..icons import icon
from .builder import ExperimentBuilder

if TYPE_CHECKING:
    from .window import ExperimentsWindow

UNSAVED = "Experiments are kept in the project's folder: save the project first (Ctrl+S)."
EMPTY = "No experiments yet. “New…” makes one: arms to compare, what is varied, and how often."


class ExperimentList(QWidget):
    """Lists experiments by name; buttons act on the one that is shown.

    Signals:
        chosen: Another one is current, or none.
    """

    chosen = Signal()

    def __init__(self, window: ExperimentsWindow) -> None:
        super().__init__()
        self._window = window
        self.list = QListWidget()
        self.list.setAccessibleName("experiments")
        self.list.currentItemChanged.connect(lambda *_: self.chosen.emit())
        self.list.itemActivated.connect(lambda _: self.build(changed=True))
        self.new = text_button("New…", "Build an experiment", self.build)
        self.edit = text_button("Edit…", "Change the experiment", partial(self.build, changed=True))
        self.copy = text_button(
            "Duplicate…", "Begin another one with what this one has", partial(self.build, copied=True)
        )
        self.delete = text_button(
            "Delete", "Delete the experiment; its results stay in their file", self.ask_delete
        )
        column = QVBoxLayout(self)
        column.setContentsMargins(12, 12, 6, 12)
        column.addWidget(self.list, 1)
        for pair in ((self.new, self.edit), (self.copy, self.delete)):
            line = QHBoxLayout()
            for button in pair:
                line.addWidget(button, 1)
            column.addLayout(line)
        window.studio.theme.changed.connect(self._dress)
        self._dress()

    def _dress(self) -> None:
        self.new.setIcon(icon("plus", self._window.studio.theme))

    @property
    def current(self) -> str:
        """The name of the one that is chosen; empty if there is none."""
        item = self.list.currentItem() if self.list.count() else None
        return "" if item is None else item.text()

    def show_names(self, names: Sequence[str], wanted: str) -> None:
        """List these names; *wanted*, or else the first, is the current one."""
        self.list.blockSignals(True)
        self.list.clear()
        for name in names:
            self.list.addItem(QListWidgetItem(name))
        self.list.setCurrentRow(names.index(wanted) if wanted in names else (0 if names else -1))
        self.list.blockSignals(False)
        self.chosen.emit()

    def choose(self, name: str) -> None:
        """Make the experiment *name* the current one."""
        found = self.list.findItems(name, Qt.MatchFlag.MatchExactly)
        if found:
            self.list.setCurrentItem(found[0])

    def allow(self, *, changes: bool, deletes: bool) -> None:
        """Let the one that is shown be changed, or not while it runs; one that cannot be read can only be deleted."""
        for button in (self.edit, self.copy):
            button.setEnabled(changes)
        self.delete.setEnabled(deletes)
        self.new.setEnabled(self._window.folder is not None)

    def build(self, *_: object, changed: bool = False, copied: bool = False) -> None:
        """Ask for an experiment: a new one, this one changed, or a copy of it."""
        window = self._window
        if window.folder is None:
            window.controls.tell(UNSAVED)
            return
        base = window.study.declared if window.study is not None and (changed or copied) else None
        if (changed or copied) and base is None:
            return
        builder = ExperimentBuilder(window.studio, window.folder, base, window, copied=copied)
        builder.kept.connect(window.refresh)
        builder.open()

    def ask_delete(self) -> None:
        """Delete the experiment that is shown, if the user really wants that."""
        window = self._window
        name, study, folder = self.current, window.study, window.folder
        if not name or folder is None:
            return

        def delete() -> None:
            try:
                delete_experiment(folder, name)
            except UnderstudyError as error:
                window.controls.tell(str(error))
            window.study = None
            window.refresh()

        stays = f" What was found stays in {study.path.name}." if study and study.path.exists() else ""
        Question(
            window,
            window.studio.theme,
            "Delete the experiment?",
            f"The file of {name!r} is deleted.{stays}",
            (Answer("Delete", delete), Answer("Keep it")),
        ).ask()
