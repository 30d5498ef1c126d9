"""Named sets of scenario parameters, and those of the project as a whole."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from PySide6.QtWidgets import QPushButton, QVBoxLayout, QWidget

from ...core.edits import delete_world, rename_world, set_world
from ...core.errors import UnderstudyError
from ...core.naming import fresh_name
from ...core.project import Value
from ..forms.buttons import stand_back
from ..forms.ordered_list import Item, OrderedList
from ..forms.parameter_form import ParameterForm
from ..forms.parts import Complaint, caption, side_by_side

if TYPE_CHECKING:
    from ..studio import Studio

WHOLE = "the project's"
#: The key of the list's first entry, which the project's own world has, since that has no name.
WHOLE_KEY = "\0"


class WorldsPage(QWidget):
    """The list of worlds, and the parameters of the one that is chosen.

    Attributes:
        worlds: The list; the first are the project's own parameters.
        parameters: What the chosen one sets.
    """

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self.worlds = OrderedList("Worlds", studio.theme, editable=True, movable=False)
        self.worlds.chosen.connect(lambda _: self._show_chosen())
        self.worlds.removed.connect(lambda name: self._do(delete_world, name))
        self.worlds.renamed.connect(self._rename)
        self.add = QPushButton("Add world")
        self.add.setToolTip("A new set of parameters that arms can name")
        stand_back(self.add)
        self.add.clicked.connect(self._add)
        self.parameters = ParameterForm(studio.theme)
        self.parameters.changed.connect(self._set)
        self.parameters.settled.connect(studio.document.end_gesture)
        self.trouble = Complaint(studio.theme)
        left = QVBoxLayout()
        left.setSpacing(8)  # rather than that of the columns
        left.addWidget(self.worlds, 1)
        left.addWidget(self.add)
        left.addWidget(
            caption("Bold parameters are set here; the others are as in the project, or the scenario's own.")
        )
        column = QVBoxLayout(self)
        column.addLayout(side_by_side(left, self.parameters, shares=(2, 3)), 1)
        column.addWidget(self.trouble)
        studio.document.project_changed.connect(self.refresh)
        self.refresh()

    @property
    def _name(self) -> str:
        return "" if self.worlds.current == WHOLE_KEY else self.worlds.current

    def refresh(self, *_: object) -> None:
        """Show the worlds as they are now."""
        self.trouble.say("")  # what it said was about the project as it was
        names = [name for name in self._studio.document.project.worlds if name]
        first = Item(
            WHOLE_KEY, WHOLE, "What holds in every arm, unless a world or the arm says otherwise", fixed=True
        )
        self.worlds.show_items([first, *(Item(name, name, "F2 renames it") for name in names)])

    def _show_chosen(self) -> None:
        worlds = self._studio.document.project.worlds
        elsewhere = worlds.get("", {}) if self._name else {}
        fields = self._studio.document.scenario.parameter_fields()
        self.parameters.show_parameters(fields, worlds.get(self._name, {}), elsewhere)

    def _do(self, edit: Callable[..., Any], *args: Any, gesture: str = "") -> bool:
        return self.trouble.attempt(self._studio.document, edit, *args, gesture=gesture)

    def _add(self) -> None:
        name = fresh_name(self._studio.document.project.worlds, "world")
        if self._do(set_world, name, {}):
            self.worlds.edit(name)

    def _rename(self, old: str, new: str) -> None:
        if self._do(rename_world, old, new.strip()):
            self.worlds.choose(new.strip())

    def _set(self, name: str, value: Value | None) -> None:
        worlds = self._studio.document.project.worlds
        own = {key: known for key, known in worlds.get(self._name, {}).items() if key != name}
        if value is not None:
            own[name] = value
        if own == worlds.get(self._name, {}):
            self.trouble.say("")
            return
        try:
            elsewhere = worlds.get("", {}) if self._name else {}
            self._studio.document.scenario.settle({**elsewhere, **own})
        except UnderstudyError as error:
            self.trouble.say(str(error))
            self._show_chosen()
            return
        self._do(set_world, self._name, own, gesture=f"{name} of world {self._name}")
