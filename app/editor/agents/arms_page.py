"""The arms: what the roots do, in which world, with which forest and parameters."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from PySide6.QtWidgets import QFormLayout, QLineEdit, QTabWidget, QVBoxLayout, QWidget

from ...core.edits import add_arm, add_type, delete_arm, move_arm, rename_arm, replace_arm, set_hierarchy
from ...core.edits.calls import root_types
from ...core.errors import UnderstudyError
from ...core.naming import fresh_name
from ...core.project import Arm, LevelTable, Value
from ..forms.buttons import text_button
from ..forms.choosing import Choice, Chooser
from ..forms.ordered_list import Item, OrderedList
from ..forms.parameter_form import ParameterForm
from ..forms.parts import Complaint, side_by_side
from ..forms.word_list import WordList
from .level_table import LevelTableForm

if TYPE_CHECKING:
    from ..studio import Studio

PROJECT_WORLD = "the project's"
#: How many agents a new arm has.
FEW = 10

#: What controllers are often called, from the lowest level up.
USUAL_TYPES = ("group", "squad", "platoon", "company", "battalion")


class ArmsPage(QWidget):
    """The list of arms, and the one that is chosen in full.

    Attributes:
        arms: The list.
        top, world, note: What the roots start with, where, and why.
        parts: Turns between the two that follow.
        table: The quick way to make a forest.
        parameters: What differs from the world.
    """

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        theme = studio.theme
        self.arms = OrderedList("Arms", theme, editable=True)
        self.arms.chosen.connect(lambda _: self._show_chosen())
        self.arms.moved.connect(lambda name, to: self._do(move_arm, name, to))
        self.arms.removed.connect(lambda name: self._do(delete_arm, name))
        self.arms.renamed.connect(self._rename)
        self.add = text_button("Add arm", "A new arm: ten agents of the first type", self._add)
        self.copy = text_button("Duplicate", "A copy of the arm that is chosen", self._copy)
        self.use = text_button("Show its world", "Begin this arm's world in the canvas", self._use)
        self.top = Chooser("What the roots start with", "what the roots start with")
        self.top.chosen.connect(self._top_chosen)
        self.world = WordList()
        self.world.setAccessibleName("World")
        self.world.setToolTip("A named set of parameters; the arm's own parameters come on top of it")
        self.world.activated.connect(lambda _: self._change(world=self.world.currentData()))
        self.note = QLineEdit()
        self.note.setAccessibleName("Note on the arm")
        self.note.setToolTip("What the arm is for")
        self.note.editingFinished.connect(self._noted)
        self.table = LevelTableForm(theme)
        self.table.wanted.connect(self._table_wanted)
        self.table.type_wanted.connect(self._type_wanted)
        self.parameters = ParameterForm(theme)
        self.parameters.changed.connect(self._set_parameter)
        self.parameters.settled.connect(studio.document.end_gesture)
        self.trouble = Complaint(theme)
        self.detail, self.parts = QWidget(), QTabWidget()
        self._shown = ""
        self._lay_out()
        studio.document.project_changed.connect(self.refresh)
        self.refresh()

    def _lay_out(self) -> None:
        form = QFormLayout()
        form.addRow("Starts with", self.top)
        form.addRow("World", self.world)
        form.addRow("Note", self.note)
        self.parts.setDocumentMode(True)
        self.parts.addTab(self.table, "Forest")
        self.parts.addTab(self.parameters, "Parameters of this arm")
        right = QVBoxLayout(self.detail)
        right.setContentsMargins(0, 0, 0, 0)
        right.addLayout(form)
        right.addWidget(self.parts, 1)
        left = QVBoxLayout()
        left.setSpacing(8)  # rather than that of the columns
        left.addWidget(self.arms, 1)
        for button in (self.add, self.copy, self.use):
            left.addWidget(button)
        column = QVBoxLayout(self)
        column.addLayout(side_by_side(left, self.detail, shares=(2, 3)), 1)
        column.addWidget(self.trouble)

    # ------------------------------------------------------------------------------------------ showing

    @property
    def _arm(self) -> Arm | None:
        return next((a for a in self._studio.document.project.arms if a.name == self.arms.current), None)

    def refresh(self, *_: object) -> None:
        """Show the arms as they are now."""
        self.trouble.say("")  # what it said was about the project as it was
        shown = self._studio.arm
        wanted = self.arms.current or ("" if shown is None else shown.name)
        items = [Item(a.name, a.name, a.note) for a in self._studio.document.project.arms]
        self.arms.show_items(items, wanted)

    def settle(self) -> None:
        """Make the forest of the table: who turns to something else may have thought that it is."""
        draft, name = self.table.draft, self._shown
        if draft is not None and any(arm.name == name for arm in self._studio.document.project.arms):
            self.table.forget()
            self._do(set_hierarchy, name, draft)

    def _show_chosen(self) -> None:
        if self._shown != self.arms.current:
            self.settle()
            self._shown = self.arms.current
        arm, document = self._arm, self._studio.document
        self.detail.setVisible(arm is not None)
        self.copy.setEnabled(arm is not None)
        self.use.setEnabled(arm is not None)
        if arm is None:
            return
        self.top.offer(self._tops(arm), arm.top)
        if self.top.choice is None:
            self.top.setEditText(arm.top)
        self.world.clear()
        self.world.addItem(PROJECT_WORLD, "")
        for name in document.project.worlds:
            if name:
                self.world.addItem(name, name)
        self.world.setCurrentIndex(self.world.findData(arm.world))
        if not self.note.hasFocus():
            self.note.setText(arm.note)
        self.table.show_forest(arm.hierarchy, document.project.types)
        self.parameters.show_parameters(
            document.scenario.parameter_fields(), arm.parameters, self._elsewhere(arm)
        )

    def _tops(self, arm: Arm) -> list[Choice]:
        """The behaviors without parameters that all root types have."""
        types = self._studio.document.types
        try:
            repertoires = [types.repertoire(name) for name in sorted(root_types(arm))]
        except UnderstudyError:
            return []
        first, *others = repertoires or [{}]
        return [
            Choice(name, name, getattr(behavior, "doc", "") or getattr(behavior, "note", ""))
            for name, behavior in first.items()
            if not behavior.parameters and all(name in other for other in others)
        ]

    def _elsewhere(self, arm: Arm) -> dict[str, Value]:
        worlds = self._studio.document.project.worlds
        return {**worlds.get("", {}), **(worlds.get(arm.world, {}) if arm.world else {})}

    # ----------------------------------------------------------------------------------------- changing

    def _do(self, edit: Callable[..., Any], *args: Any, gesture: str = "") -> bool:
        return self.trouble.attempt(self._studio.document, edit, *args, gesture=gesture)

    def _change(self, gesture: str = "", **fields: object) -> None:
        arm = self._arm
        if arm is not None:
            changed = replace(arm, **fields)  # type: ignore[arg-type]  # by the names of its fields
            if changed != arm:
                self._do(replace_arm, arm.name, changed, gesture=gesture)

    def _rename(self, old: str, new: str) -> None:
        if self._do(rename_arm, old, new.strip()):
            self.arms.choose(new.strip())

    def _add(self) -> None:
        project = self._studio.document.project
        if not project.types:
            self.trouble.say("an arm needs a node type; add one under Node types")
            return
        name = fresh_name([arm.name for arm in project.arms], "arm")
        first = project.types[0].name
        if self._do(add_arm, Arm(name, LevelTable((FEW,), (first,)), self._usual_top(first))):
            self.arms.edit(name)

    def _usual_top(self, type_name: str) -> str:
        """What roots of a type start with in another arm, or else a behavior of theirs, rather a composed one."""
        document = self._studio.document
        usual = [arm.top for arm in document.project.arms if root_types(arm) == {type_name}]
        composed = [automaton.name for automaton in document.project.library(type_name).automata.values()]
        known = document.types.repertoire(type_name)
        return next((top for top in (*usual, *composed, *known) if top in known), "")

    def _copy(self) -> None:
        arm = self._arm
        if arm is not None:
            name = fresh_name([a.name for a in self._studio.document.project.arms], arm.name)
            if self._do(add_arm, replace(arm, name=name)):
                self.arms.edit(name)

    def _use(self) -> None:
        arm = self._arm
        if arm is not None:
            self.settle()
            self._studio.use_arm(arm.name)

    def _top_chosen(self, choice: Choice | None) -> None:
        if choice is not None:
            self._change(top=choice.value)
        elif self._arm is not None and self.top.currentText().strip() != self._arm.top:
            self.trouble.say(f"the roots of this arm cannot start with {self.top.currentText().strip()!r}")

    def _noted(self) -> None:
        self._change(note=self.note.text())

    def _table_wanted(self, table: LevelTable) -> None:
        arm = self._arm
        if arm is not None:
            self._do(set_hierarchy, arm.name, table)

    def _type_wanted(self, below: str) -> None:
        """A type of controllers over another, called as such a level often is until the user has a better name."""
        types = self._studio.document.project.types
        level = next((t.level for t in types if t.name == below), 0)
        usual = USUAL_TYPES[level] if level < len(USUAL_TYPES) else f"level-{level + 1}"
        self._do(add_type, fresh_name([t.name for t in types], usual).replace(" ", "-"), (below,))

    def _set_parameter(self, name: str, value: Value | None) -> None:
        arm = self._arm
        if arm is None:
            return
        parameters = {key: known for key, known in arm.parameters.items() if key != name}
        if value is not None:
            parameters[name] = value
        try:
            self._studio.document.scenario.settle({**self._elsewhere(arm), **parameters})
        except UnderstudyError as error:
            self.trouble.say(str(error))
            self._show_chosen()
            return
        self._change(gesture=f"{name} of arm {arm.name}", parameters=parameters)
