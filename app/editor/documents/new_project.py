"""What a new project is to be like: scenario, name, folder, and the first arm."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QDialog, QHBoxLayout, QLabel, QLineEdit, QSpinBox, QWidget

from ...core.errors import UnderstudyError
from ...core.storage import save
from ...engine.fresh import AGENTS, MOST_AGENTS, fresh_project, refuse_numbers, save_with_code
from ...engine.scenarios import scenario_at
from ...sim.scenarios import names, shipped
from ..forms.word_list import WordList
from ..number_box import roomy
from .choosing import choose_existing
from .forms import Form, PlaceEdit, folder_problem, usable_name

if TYPE_CHECKING:
    from ..studio import Studio

MOST_GROUPS, GROUP_SIZE = 1000, 5
#: What asks for a file.
OWN = "From a file of my own…"


@dataclass(frozen=True, slots=True)
class Order:
    """A project to be made.

    Attributes:
        scenario: A shipped one, or a file of the user's own that declares one.
    """

    name: str
    scenario: str | Path
    folder: Path
    agents: int
    groups: int

    @property
    def brings_code(self) -> bool:
        """Whether the user's own file is run to make it."""
        return isinstance(self.scenario, Path)

    def make(self) -> None:
        """Make the project in its folder.

        Raises:
            UnderstudyError: That cannot be done; the file fails, for instance.
        """
        own = self.scenario if isinstance(self.scenario, Path) else None
        scenario = shipped(str(self.scenario)) if own is None else scenario_at(own)
        project = fresh_project(self.name, scenario, self.agents, self.groups)
        if own is None:
            save(project, self.folder)
        else:
            save_with_code(project, own, self.folder)


class NewProject(QDialog):
    """Asks what a new project is to be like.

    Signals:
        ordered: The user wants this `Order`.
    """

    ordered = Signal(object)

    def __init__(self, window: QWidget, studio: Studio) -> None:
        super().__init__(window)
        self.setWindowTitle("New project")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.scenario = WordList()
        for name in names():
            self.scenario.addItem(shipped(name).title, name)
        self.scenario.addItem(OWN, None)
        self._last = 0  # which scenario was chosen last
        self.about = QLabel()
        self.name = QLineEdit("My project")
        self.place = PlaceEdit(studio.settings.projects_folder, usable_name(self.name.text()))
        self.agents = _count(
            1, MOST_AGENTS, AGENTS, "Agents", "How many agents there are, or are in each group"
        )
        self.groups = _count(0, MOST_GROUPS, 0, "Groups", "Controllers, each of a group of agents of its own")
        self.groups.setSpecialValueText("no groups")
        self._grouped = False
        self.total = QLabel()
        self._build()
        for signal in (self.agents.valueChanged, self.groups.valueChanged, self.name.textChanged):
            signal.connect(self._check)
        self.place.changed.connect(self._check)
        self.scenario.currentIndexChanged.connect(self._check)
        self.scenario.activated.connect(self._scenario_chosen)
        self.name.textEdited.connect(lambda text: self.place.suggest(usable_name(text)))
        self.accepted.connect(lambda: self.ordered.emit(self.order))
        self._check()
        self.name.setFocus()
        self.name.selectAll()

    def _build(self) -> None:
        self._form = Form(self, "Create", "Make the project and open it")
        self.scenario.setAccessibleName("Scenario")
        self.scenario.setToolTip("The world that the agents live in")
        self.name.setAccessibleName("Name")
        arm = QWidget()
        layout = QHBoxLayout(arm)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(8)
        for widget in (self.groups, self.agents, self.total):
            layout.addWidget(widget)
        layout.addStretch(1)
        self._form.row("Scenario", self.scenario)
        self._form.note(self.about)
        self._form.row("Name", self.name)
        self._form.row("Folder", self.place)
        self._form.row("First arm", arm)

    @property
    def order(self) -> Order:
        """What is asked for as the form stands."""
        return Order(
            self.name.text().strip(),
            self.scenario.currentData(),
            self.place.folder,
            self.agents.value(),
            self.groups.value(),
        )

    @property
    def problem(self) -> str:
        """Why no such project can be made; empty if it can."""
        if not self.name.text().strip():
            return "the project needs a name"
        try:
            refuse_numbers(self.agents.value(), self.groups.value())
        except UnderstudyError as error:
            return str(error)
        return folder_problem(self.place.folder)

    def _scenario_chosen(self, at: int) -> None:
        """A file of the user's own is asked for; who gives none stays with what was chosen before."""
        if self.scenario.itemText(at) != OWN:
            self._last = at
            return
        self.scenario.setCurrentIndex(self._last)
        choose_existing(
            self, "Choose your scenario's file", self.place.folder.parent, "Python (*.py)", self.take
        )

    def take(self, code: Path) -> None:
        """Offer a file of the user's own as the scenario, and choose it."""
        self._last = self.scenario.count() - 1
        self.scenario.insertItem(self._last, code.name, code)
        self.scenario.setCurrentIndex(self._last)

    def _check(self) -> None:
        chosen = self.scenario.currentData()
        if isinstance(chosen, Path):
            self.about.setText(
                f"Creating the project runs {chosen}, which can do whatever you can do on this machine."
            )
        elif chosen is not None:
            self.about.setText(shipped(chosen).doc)
        if self.groups.value() and not self._grouped and self.agents.value() == AGENTS:
            self.agents.setValue(GROUP_SIZE)  # as in the paper
        self._grouped = bool(self.groups.value())
        groups, agents = self.groups.value(), self.agents.value()
        self.agents.setSuffix(" agents each" if groups else " agents")
        self.total.setText(f"{groups * agents:,} agents in all" if groups else "on their own")
        self._form.complain(self.problem)


def _count(least: int, most: int, value: int, name: str, tip: str) -> QSpinBox:
    box = roomy(QSpinBox())
    box.setRange(least, most)
    box.setValue(value)
    box.setAccessibleName(name)
    box.setToolTip(tip)
    box.setMinimumWidth(130)
    if name == "Groups":
        box.setSuffix(" groups")
    return box
