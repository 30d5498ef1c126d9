"""What a new project is to be like: scenario, name, folder, and the first arm."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QDialog, QHBoxLayout, QLabel, QLineEdit, QSpinBox, QWidget

from ...core.errors import UnderstudyError
from ...core.project import Project
from ...engine.fresh import AGENTS, MOST_AGENTS, fresh_project
from ...sim.scenarios import names, shipped
from ..number_box import roomy
from .forms import Form, PlaceEdit, folder_problem, usable_name

if TYPE_CHECKING:
    from ..studio import Studio

MOST_GROUPS, GROUP_SIZE = 1000, 5


@dataclass(frozen=True, slots=True)
class Order:
    """A project to be made."""

    name: str
    scenario: str
    folder: Path
    agents: int
    groups: int

    def project(self) -> Project:
        """The project."""
        return fresh_project(self.name, shipped(self.scenario), self.agents, self.groups)


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
        self.scenario = QComboBox()
        for name in names():
            self.scenario.addItem(shipped(name).title, name)
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
            self.order.project()
        except UnderstudyError as error:
            return str(error)
        return folder_problem(self.place.folder)

    def _check(self) -> None:
        self.about.setText(shipped(self.scenario.currentData()).doc)
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
