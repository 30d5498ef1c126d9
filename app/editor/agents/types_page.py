"""The node types: which kinds of agents and controllers there are, and who may stand under whom."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QListWidget, QListWidgetItem, QPushButton, QVBoxLayout, QWidget

from ...core.edits import add_type, delete_type, rename_type, set_subsidiaries
from ...core.library import NodeType
from ...core.naming import fresh_name
from ..forms.buttons import stand_back
from ..forms.ordered_list import Item, OrderedList
from ..forms.parts import Complaint, caption, framed, side_by_side

if TYPE_CHECKING:
    from ..studio import Studio


class TypesPage(QWidget):
    """The list of types; of the chosen one its level, its library, and who may stand under it.

    Attributes:
        types: The list.
        below: The types that may stand under the chosen one, checked.
    """

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._filling = False
        self.types = OrderedList("Node types", studio.theme, editable=True, movable=False)
        self.types.chosen.connect(lambda _: self._show_chosen())
        self.types.removed.connect(lambda name: self._do(delete_type, name))
        self.types.renamed.connect(self._rename)
        self.add = QPushButton("Add node type")
        self.add.setToolTip(
            "A new type with a library of its own; check who stands under it to make it a controller"
        )
        stand_back(self.add)
        self.add.clicked.connect(self._add)
        self.facts = QLabel()
        self.facts.setWordWrap(True)
        self.below = QListWidget()
        self.below.setAccessibleName("Who may stand under it")
        self.below.setToolTip("Space checks a type")
        self.below.itemChanged.connect(self._checked)
        framed(self.below, studio.theme)
        self.trouble = Complaint(studio.theme)
        self._lay_out()
        studio.document.project_changed.connect(self.refresh)
        self.refresh()

    def _lay_out(self) -> None:
        left, right = QVBoxLayout(), QVBoxLayout()
        for part in (left, right):
            part.setSpacing(8)  # rather than that of the columns
        left.addWidget(self.types, 1)
        left.addWidget(self.add)
        right.addWidget(self.facts)
        right.addWidget(caption("WHO MAY STAND UNDER IT"))
        right.addWidget(self.below, 1)
        right.addWidget(
            caption(
                "A type without any is one of agents. Controllers direct what all types under them can do."
            )
        )
        column = QVBoxLayout(self)
        column.addLayout(side_by_side(left, right, shares=(2, 3)), 1)
        column.addWidget(self.trouble)

    @property
    def _type(self) -> NodeType | None:
        types = self._studio.document.project.types
        return next((t for t in types if t.name == self.types.current), None)

    def refresh(self, *_: object) -> None:
        """Show the types as they are now."""
        self.trouble.say("")  # what it said was about the project as it was
        types = self._studio.document.project.types
        self.types.show_items(Item(t.name, t.name, f"level {t.level}; F2 renames it") for t in types)

    def _show_chosen(self) -> None:
        chosen, project = self._type, self._studio.document.project
        self.below.setVisible(chosen is not None)
        if chosen is None:
            self.facts.setText("There are no node types yet.")
            return
        names = [automaton.name for automaton in project.library(chosen.name).automata.values()]
        kind = "agents" if chosen.level == 0 else f"controllers of level {chosen.level}"
        library = ", ".join(names[:8]) + (f" and {len(names) - 8} more" if len(names) > 8 else "")
        self.facts.setText(
            f"Nodes of type {chosen.name!r} are {kind}. Its library: {library or 'nothing yet'}."
        )
        self._filling = True
        shown = [self.below.item(k).text() for k in range(self.below.count())]
        wanted = [t.name for t in project.types if t.name != chosen.name]
        if shown != wanted:
            self.below.clear()
            self.below.addItems(wanted)
        for k, name in enumerate(wanted):
            item = self.below.item(k)
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            on = name in chosen.subsidiaries
            item.setCheckState(Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)
        self._filling = False

    def _checked(self, item: QListWidgetItem) -> None:
        chosen = self._type
        if self._filling or chosen is None:
            return
        below = [name for name in chosen.subsidiaries if name != item.text()]
        if item.checkState() == Qt.CheckState.Checked:
            below.append(item.text())
        if not self._do(set_subsidiaries, chosen.name, below):
            self._show_chosen()

    def _add(self) -> None:
        names = [t.name for t in self._studio.document.project.types]
        name = fresh_name(names, "type").replace(" ", "-")
        if self._do(add_type, name):
            self.types.edit(name)

    def _rename(self, old: str, new: str) -> None:
        if self._do(rename_type, old, new.strip()):
            self.types.choose(new.strip())

    def _do(self, edit: Callable[..., Any], *args: Any) -> bool:
        return self.trouble.attempt(self._studio.document, edit, *args)
