"""The dialog that exports: what, and where to."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from ...core.amounts import counted
from ...core.check import refuse
from ...core.errors import StorageError, UnderstudyError
from ...core.naming import slug
from ...core.project import Project
from ...core.storage import file_is_there
from ...engine.scenarios import OWN_CODE, brings_code
from ...export.bundle import bundle_of_arm, bundle_of_behavior
from ...export.library_file import FILE_ENDING, Exported, write
from ...sim.scenario import Scenario
from ..actions import ActionRow, when_open
from ..documents.asking import Answer, Question
from ..documents.background import Background
from ..documents.choosing import choose_file
from ..forms.parts import Complaint, caption
from ..forms.word_list import WordList
from ..room import resize_within
from ..selection import BehaviorKey
from .command import command

if TYPE_CHECKING:
    from ..studio import Studio

#: What can be exported: the name of an arm, or a behavior.
What = str | BehaviorKey


def export_bundle(
    project: Project,
    scenario: Scenario,
    folder: Path | None,
    what: What,
    path: Path,
    *,
    examples: bool = False,
) -> Project:
    """Export *what* into the file at *path*, with all its *examples* or without; returns what is in it.

    Raises:
        UnderstudyError: It cannot run as it is, or the file cannot be written.
    """
    if isinstance(what, BehaviorKey):
        bundle = bundle_of_behavior(project, scenario, what.type, what.id, examples=examples)
    else:
        bundle = bundle_of_arm(project, scenario, what, examples=examples)
    if bundle.arms:
        refuse(bundle, scenario.vocabulary, bundle.arms[0].name)
    write(Exported(bundle, _code(project, folder)), path)
    return bundle


def _code(project: Project, folder: Path | None) -> str:
    """The text of the project's own scenario, if it brings one."""
    if not brings_code(project):
        return ""
    path = (folder or Path()) / OWN_CODE
    try:
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise StorageError(f"{path}: cannot be read: {error.strerror or error}") from error


class ExportDialog(QDialog):
    """Asks what is to be exported, and where to.

    Attributes:
        what: The arms and behaviors to choose from.
        path: The file.
        examples: Whether all examples go into it as well.
    """

    def __init__(self, studio: Studio, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setObjectName("export")
        self.setWindowTitle("Export")
        self._studio = studio
        self._background = Background(self)
        self._replaced: Path | None = None
        self.what = WordList()
        self.what.setAccessibleName("what is exported")
        for words, what in self._offers():
            self.what.addItem(words, what)
        self.path = QLineEdit()
        self.path.setAccessibleName("file")
        self.browse = QPushButton("Browse…")
        self.browse.setToolTip("Choose the file")
        self.browse.clicked.connect(self._browse)
        self.examples = QCheckBox("With all examples, so that it can be taught further elsewhere")
        self.examples.setToolTip(
            "The moments they were recorded in stay behind: features that are added later lack their values"
        )
        self.trouble = Complaint(studio.theme)
        self.buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        self.buttons.button(QDialogButtonBox.StandardButton.Ok).setText("Export")
        self.buttons.accepted.connect(self.export)
        self.buttons.rejected.connect(self.reject)
        self.what.currentIndexChanged.connect(lambda _: self._propose())
        self.path.textChanged.connect(lambda _: self.trouble.say(""))  # it was about another file
        self.finished.connect(lambda _: self._background.close())
        self._lay_out()
        self._propose()

    def _lay_out(self) -> None:
        line = QHBoxLayout()
        line.addWidget(self.path, 1)
        line.addWidget(self.browse)
        form = QFormLayout()
        form.addRow("What", self.what)
        form.addRow("File", line)
        form.addRow("", self.examples)
        column = QVBoxLayout(self)
        column.addWidget(
            caption(
                "One JSON file with all that is needed and no more: an arm with its controllers, agents and world, or a "
                "behavior with what it uses. It runs in a terminal to the same results, without the project, by the "
                "command that is told then; File > Import behaviors… brings it into another project."
            )
        )
        column.addLayout(form)
        column.addWidget(self.trouble)
        column.addStretch(1)
        column.addWidget(self.buttons)
        resize_within(self, 560, 240)

    def _offers(self) -> list[tuple[str, What]]:
        """The arm that is shown first, then the behavior that is, then all others."""
        studio = self._studio
        project, shown, current = studio.document.project, studio.selection.behavior, studio.arm
        arms = sorted(project.arms, key=lambda arm: current is None or arm.name != current.name)
        offers: list[tuple[str, What]] = [(f"Arm: {arm.name}", arm.name) for arm in arms]
        behaviors = [
            (f"Behavior: {automaton.name} ({node_type.name})", BehaviorKey(node_type.name, automaton.id))
            for node_type in project.types
            for automaton in project.library(node_type.name).automata.values()
        ]
        return offers + sorted(behaviors, key=lambda offer: offer[1] != shown)

    def _propose(self) -> None:
        """Propose a file named after what is exported."""
        what = self.what.currentData()
        name = what.id if isinstance(what, BehaviorKey) else slug(str(what or "export"))
        folder = Path(self.path.text()).parent if self.path.text() else self._folder()
        self.path.setText(str(folder / f"{name}{FILE_ENDING}"))

    def _folder(self) -> Path:
        project = self._studio.document.folder
        return Path.home() if project is None else project.parent

    def _browse(self) -> None:
        proposed = Path(self.path.text())
        choose_file(self, "Export to", proposed, "JSON (*.json)", self._choose)

    def _choose(self, path: Path) -> None:
        self._replaced = path  # who chose a file that is there has been asked already
        self.path.setText(str(path))

    # ------------------------------------------------------------------------------------------- exporting

    def export(self) -> None:
        """Write the file, unless something keeps it from running."""
        document, what, path = self._studio.document, self.what.currentData(), Path(self.path.text().strip())
        if what is None:
            self.trouble.say("there is no arm and no behavior to export yet")
            return
        if path.suffix != FILE_ENDING or path.name == "project.json":
            self.trouble.say(
                f"the file has to end with {FILE_ENDING} and is not called project.json, but this is {path.name!r}"
            )
            return
        project, scenario, folder = document.project, document.scenario, document.folder
        if file_is_there(path) and path != self._replaced:
            self._ask_for(path)
            return
        examples = self.examples.isChecked()
        self.buttons.setEnabled(False)
        self._background.do(
            lambda: export_bundle(project, scenario, folder, what, path, examples=examples),
            lambda bundle: self._done(bundle, path),
            self._failed,
        )

    def _ask_for(self, path: Path) -> None:
        """Ask whether a file that is there is to be replaced."""

        def replaced() -> None:
            self._replaced = path
            self.export()

        text = f"{path} is there already. What is in it would be gone."
        answers = Answer("Replace", replaced), Answer("Cancel")
        Question(self, self._studio.theme, "Replace the file?", text, answers).ask()

    def _done(self, bundle: Project, path: Path) -> None:
        count = sum(len(library.automata) for library in bundle.libraries.values())
        told = f"{path}: {counted(count, 'behavior')}"
        if bundle.arms:
            runs = command("run", str(path))
            copy = "Copy the command", partial(QGuiApplication.clipboard().setText, runs)
            self._studio.say(f"{told}. In a terminal, this runs it: {runs}", (copy,))
        else:
            self._studio.say(told)
        self.accept()

    def _failed(self, error: UnderstudyError) -> None:
        self.buttons.setEnabled(True)
        self.trouble.say(str(error))


def export_rows(parent: QWidget) -> tuple[ActionRow, ...]:
    """The action of the File menu."""
    return (
        ActionRow(
            "file.export",
            "Export…",
            "File",
            lambda studio: ExportDialog(studio, parent).open(),
            "save",
            "Ctrl+Alt+E",
            "Write an arm or a behavior into one file that runs without the project",
            "export",
            when_open,
        ),
    )
