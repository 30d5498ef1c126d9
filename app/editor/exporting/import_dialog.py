"""The dialog that imports: what a file would bring into the project, before it does."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QLineEdit,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from ...core.amounts import counted
from ...core.errors import EditError, UnderstudyError
from ...core.project import Arm, Project
from ...export.bundle import holds_arm
from ...export.importing import Import, bring
from ...export.library_file import MAKES_ONE, read
from ...sim.scenario import Scenario
from ..actions import ActionRow, when_open
from ..documents.background import Background, Job
from ..documents.choosing import choose_existing
from ..forms.buttons import stand_back
from ..forms.parts import Complaint, caption
from ..letters import plain
from ..room import resize_within
from ..selection import BehaviorKey

if TYPE_CHECKING:
    from ..studio import Studio

KINDS = "Exported by Understudy (*.json)"
COLUMNS = ("Behavior", "Type", "In this project")
NEW = "New; what shares its name with something else comes under a name of its own. Nothing that is here is changed."


@dataclass(frozen=True, slots=True)
class Offer:
    """What a file would bring into a project.

    Attributes:
        into: The project.
        whole: The same with the arm; a sentence where that cannot come along, None where the file has none.
    """

    into: Project
    source: Project
    behaviors: Import
    whole: Import | str | None


def offer_of(project: Project, scenario: Scenario, source: Project) -> Offer:
    """What *source* would bring into *project*.

    Raises:
        EditError: Nothing of it can come.
    """
    behaviors = bring(project, scenario, source)
    whole: Import | str | None = None
    if source.arms:
        try:
            whole = bring(project, scenario, source, with_arm=True)
        except EditError as error:
            whole = str(error)
    return Offer(project, source, behaviors, whole)


def _source(name: str) -> Project:
    """What the file of a name holds."""
    if not name:
        raise EditError(f"name the file to import: {MAKES_ONE}, and so does File > Export…")
    return read(Path(name)).project


class ImportDialog(QDialog):
    """Shows what a file would bring, and brings it as one step.

    Attributes:
        path: The file.
        table: Its behaviors, and what becomes of each.
        arm: Whether its arm comes along.
    """

    def __init__(self, studio: Studio, parent: QWidget, background: Background, path: Path) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setObjectName("import")
        self.setWindowTitle("Import")
        self._studio = studio
        self._background = background
        self._job: Job | None = None
        self._offer: Offer | None = None
        self.path = QLineEdit(str(path))
        self.path.setAccessibleName("file")
        self.path.editingFinished.connect(self._typed)
        self.browse = QPushButton("Browse…")
        self.browse.setToolTip("Choose another file")
        stand_back(self.browse)
        self.browse.clicked.connect(self._browse)
        self.table = _table()
        self.arm = QCheckBox()
        self.arm.toggled.connect(self._show)
        self.note = caption("")
        self.trouble = Complaint(studio.theme)
        self.buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        self.ok = self.buttons.button(QDialogButtonBox.StandardButton.Ok)
        self.ok.setText("Import")
        self.buttons.accepted.connect(self.bring)
        self.buttons.rejected.connect(self.reject)
        self.finished.connect(lambda _: self._drop())
        studio.document.project_changed.connect(self._look_again)
        self._lay_out()
        self._read()

    def _lay_out(self) -> None:
        line = QHBoxLayout()
        line.addWidget(QLabel("File"))
        line.addWidget(self.path, 1)
        line.addWidget(self.browse)
        column = QVBoxLayout(self)
        column.addLayout(line)
        column.addWidget(self.table, 1)
        column.addWidget(self.arm)
        column.addWidget(self.note)
        column.addWidget(self.trouble)
        column.addWidget(self.buttons)
        resize_within(self, 680, 420)

    def _browse(self) -> None:
        beside = Path(self.path.text()).parent
        choose_existing(self, "Import from", beside, KINDS, self._choose)

    def _choose(self, path: Path) -> None:
        self.path.setText(str(path))
        self._typed()

    # ---------------------------------------------------------------------------------------- looking

    def _typed(self) -> None:
        if self.path.isModified() or self._offer is None:
            self.path.setModified(False)
            self._read()

    def _read(self) -> None:
        """See what the file holds, and what that would bring."""
        name, document = self.path.text().strip(), self._studio.document
        project, scenario = document.project, document.scenario
        self._ask(lambda: offer_of(project, scenario, _source(name)))

    def _look_again(self) -> None:
        """The project has changed: what the file would bring may be something else."""
        if self._offer is not None:
            source, document = self._offer.source, self._studio.document
            project, scenario = document.project, document.scenario
            self._ask(lambda: offer_of(project, scenario, source))

    def _ask(self, work: Callable[[], Offer]) -> None:
        self._drop()
        self.ok.setEnabled(False)
        self._job = self._background.do(work, self._offered, self._failed)

    def _drop(self) -> None:
        """Wait no longer for what is being read."""
        if self._job is not None:
            self._job.drop()

    def _failed(self, error: UnderstudyError) -> None:
        self._offer = None
        self.table.setRowCount(0)
        self.arm.hide()
        self.note.clear()
        self.trouble.say(str(error))

    def _offered(self, offer: Offer) -> None:
        is_new = self._offer is None or self._offer.source is not offer.source
        self._offer = offer
        if is_new:  # who exported an arm wants it; what a behavior brings to run in is no part of it
            self.arm.setChecked(holds_arm(offer.source))
        self.arm.setVisible(offer.whole is not None)
        self.arm.setEnabled(isinstance(offer.whole, Import))
        if offer.source.arms:
            self.arm.setText(plain(_arm_words(offer.source.arms[0])))
            tip = "Its hierarchy, its world and what it starts with, as one more arm of this project"
            self.arm.setToolTip(offer.whole if isinstance(offer.whole, str) else tip)
        self._show()

    @property
    def chosen(self) -> Import | None:
        """What would be brought, with or without the arm; None before that is known."""
        offer = self._offer
        if offer is None:
            return None
        wanted = self.arm.isChecked() and isinstance(offer.whole, Import)
        return offer.whole if wanted and isinstance(offer.whole, Import) else offer.behaviors

    def _show(self) -> None:
        chosen, offer = self.chosen, self._offer
        if chosen is None or offer is None:
            return
        self.table.setRowCount(len(chosen.behaviors))
        for row, brought in enumerate(chosen.behaviors):
            for column, words in enumerate((brought.name, brought.type, brought.fate)):
                item = QTableWidgetItem(words)
                item.setToolTip(words)
                self.table.setItem(row, column, item)
        new = chosen.project is not offer.into
        self.note.setText(" ".join(_remarks(chosen)) if new else "All of it is in the project already.")
        self.trouble.say("" if not isinstance(offer.whole, str) else offer.whole)
        self.ok.setEnabled(new)

    # --------------------------------------------------------------------------------------- bringing

    def bring(self) -> None:
        """Go on with the project as it is with what was imported; one step, which can be undone."""
        chosen, offer, document = self.chosen, self._offer, self._studio.document
        if chosen is None or offer is None or offer.into is not document.project:
            return
        document.push(chosen.words, chosen.project)
        if chosen.added:
            last = chosen.added[-1]
            self._studio.selection.select_behavior(BehaviorKey(last.type, last.id))
        self._tell(chosen)
        self.accept()

    def _tell(self, chosen: Import) -> None:
        """Say what came, and offer to look at the arm."""
        here = len(chosen.behaviors) - len(chosen.added)
        words = f"imported {counted(len(chosen.added), 'new behavior')}"
        answers: tuple[tuple[str, Callable[[], object]], ...] = ()
        if chosen.arm and not chosen.arm_is_here:
            words += f" and the arm {chosen.arm!r}"
            answers = (("Show its world", partial(self._studio.use_arm, chosen.arm)),)
        if here:
            words += f"; {counted(here, 'behavior')} of the file {'was' if here == 1 else 'were'} here"
        self._studio.say(words, answers)


def _table() -> QTableWidget:
    table = QTableWidget(0, len(COLUMNS))
    table.setHorizontalHeaderLabels(list(COLUMNS))
    table.setAccessibleName("Behaviors of the file")
    table.setToolTip(NEW)
    table.verticalHeader().hide()
    table.setShowGrid(False)
    table.setSelectionBehavior(QTableWidget.SelectionBehavior.SelectRows)
    table.setEditTriggers(QTableWidget.EditTrigger.NoEditTriggers)
    table.setTabKeyNavigation(False)
    head = table.horizontalHeader()
    head.setHighlightSections(False)
    head.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
    for column in (0, 1):
        head.setSectionResizeMode(column, QHeaderView.ResizeMode.ResizeToContents)
    head.setStretchLastSection(True)
    return table


def _arm_words(arm: Arm) -> str:
    forest = arm.forest()
    agents, controllers = len(forest.agents()), len(forest.controllers())
    under = f" under {counted(controllers, 'controller')}" if controllers else ""
    return f"Also the arm “{arm.name}”: {counted(agents, 'agent')}{under}, and their world"


def _remarks(chosen: Import) -> list[str]:
    """What one should know before."""
    remarks = []
    if chosen.types:
        names = ", ".join(chosen.types)
        remarks.append(f"New node {'type' if len(chosen.types) == 1 else 'types'}: {names}.")
    if chosen.arm and chosen.arm_is_here:
        remarks.append(f"The arm “{chosen.arm}” is here already.")
    elif chosen.arm:
        remarks.append(f"The arm comes as “{chosen.arm}”.")
    if any(brought.lacks_examples for brought in chosen.added):
        remarks.append(
            "The file holds no examples: what was learned runs, but teaching such a behavior begins anew. "
            "An export with examples can be taught further."
        )
    return remarks


def ask_import(studio: Studio, parent: QWidget, background: Background) -> None:
    """Ask for a file, and show what it would bring."""
    folder = studio.document.folder
    beside = Path.home() if folder is None else folder.parent

    def show(path: Path) -> None:
        ImportDialog(studio, parent, background, path).open()

    choose_existing(parent, "Import behaviors from", beside, KINDS, show)


def import_rows(parent: QWidget, background: Background) -> tuple[ActionRow, ...]:
    """The action of the File menu; files are read in the *background*."""
    return (
        ActionRow(
            "file.import",
            "Import behaviors…",
            "File",
            lambda studio: ask_import(studio, parent, background),
            "save",
            "Ctrl+Alt+I",
            "Bring behaviors that were exported into this project, and their arm if you like",
            "import",
            when_open,
        ),
    )
