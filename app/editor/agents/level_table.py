"""A forest made quickly: how many nodes of which type stand on each level, from the roots down."""

from __future__ import annotations

from collections.abc import Sequence
from math import prod
from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QGridLayout, QHBoxLayout, QSpinBox, QVBoxLayout, QWidget

from ...core.amounts import counted
from ...core.errors import HierarchyError
from ...core.hierarchy import Hierarchy, Node, from_table, problems
from ...core.library import NodeType
from ...core.project import LevelTable
from ..forms.buttons import text_button
from ..forms.parts import Complaint, caption
from ..forms.word_list import WordList
from ..number_box import roomy

if TYPE_CHECKING:
    from ..theme import Theme

#: More agents than this are no forest that anybody waits for.
MOST_AGENTS = 100_000


class LevelTableForm(QWidget):
    """The table, which becomes the arm's forest only when the user says so.

    Attributes:
        sizes, types: The fields of each level, from the roots down.
        above, below: Add and take away a level.
        use: Makes the forest.

    Signals:
        wanted: The user wants this `LevelTable`.
        type_wanted: The user wants a new node type, over the one of this name.
    """

    wanted = Signal(object)
    type_wanted = Signal(str)

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._types: tuple[NodeType, ...] = ()
        self._forest: Hierarchy | LevelTable | None = None
        self._begins = ""
        self.sizes: list[QSpinBox] = []
        self.types: list[QComboBox] = []
        self.words = caption("")
        self.trouble = Complaint(theme)
        self._grid = QGridLayout()
        self._grid.setColumnStretch(2, 1)
        self.above = text_button(
            "Add a level",
            "Another level of controllers above the roots, of a new node type if none may stand there",
            self._grow,
        )
        self.below = text_button("Take a level away", "The roots' level goes", self._shrink)
        self.use = text_button("Make this forest", "Put this forest in the place of the arm's own", self._use)
        row = QHBoxLayout()
        for button in (self.above, self.below, self.use):
            row.addWidget(button)
        row.addStretch(1)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 8, 0, 0)
        column.addLayout(row)  # above the levels: it stays under the mouse while they grow
        column.addWidget(self.words)
        column.addLayout(self._grid)
        column.addWidget(self.trouble)
        column.addWidget(caption("Move, group and name single nodes in the Agents panel."))
        column.addStretch(1)

    def show_forest(self, forest: Hierarchy | LevelTable, types: tuple[NodeType, ...]) -> None:
        """Show a forest as a table, as far as it is regular."""
        if forest == self._forest:
            self._use_types(types)
            return
        self._forest, self._types = forest, types
        table = forest if isinstance(forest, LevelTable) else as_table(forest)
        by_hand = not isinstance(forest, LevelTable)
        self._begins = (
            "This forest was changed by hand; the table makes a new one" if by_hand else "From the roots down"
        )
        if table is None:
            first = types[0].name if types else ""
            table = LevelTable(
                (sum(1 for _ in Hierarchy.agents(forest)) if isinstance(forest, Hierarchy) else 1,), (first,)
            )
        self._build(table.sizes, table.types)

    @property
    def _agents(self) -> int:
        """How many agents the table makes."""
        return prod(size.value() for size in self.sizes)

    def _use_types(self, types: tuple[NodeType, ...]) -> None:
        """Offer other types; what the fields say stays as far as there are those types."""
        if types != self._types:
            table, self._types = self.table, types
            self._build(table.sizes, table.types)

    @property
    def table(self) -> LevelTable:
        """What the fields say."""
        sizes = tuple(size.value() for size in self.sizes)
        return LevelTable(sizes, tuple(kind.currentText() for kind in self.types))

    # ------------------------------------------------------------------------------------------ building

    def _build(self, sizes: Sequence[int], types: Sequence[str]) -> None:
        while (item := self._grid.takeAt(0)) is not None:
            widget = item.widget()
            if widget is not None:
                widget.hide()
                widget.deleteLater()
        self.sizes, self.types = [], []
        for level, (size, kind) in enumerate(zip(sizes, types, strict=False)):
            self._grid.addWidget(self._size(level, size), level, 0)
            self._grid.addWidget(self._type(level, kind), level, 1)
        self._changed()

    def _size(self, level: int, size: int) -> QSpinBox:
        box = roomy(QSpinBox())
        box.setRange(1, MOST_AGENTS)
        box.setValue(size)
        box.setAccessibleName(f"Nodes on level {level + 1} from above")
        box.setToolTip("How many roots" if level == 0 else "How many under each node of the level above")
        box.setSuffix("" if level == 0 else " each")
        box.valueChanged.connect(self._changed)
        self.sizes.append(box)
        return box

    def _type(self, level: int, kind: str) -> QComboBox:
        box = WordList()
        box.addItems([node_type.name for node_type in self._types])
        box.setAccessibleName(f"Type of level {level + 1} from above")
        box.setToolTip("The node type of this level")
        box.setCurrentText(kind)
        box.currentTextChanged.connect(self._changed)
        self.types.append(box)
        return box

    def _changed(self, *_: object) -> None:
        trouble = self._problem()
        self.trouble.say(trouble)
        is_other = self.table != self._forest
        self.use.setEnabled(not trouble and is_other)
        draft = ", not made yet" if is_other and isinstance(self._forest, LevelTable) else ""
        self.words.setText(f"{self._begins}: {counted(self._agents, 'agent')}{draft}")
        self.below.setEnabled(len(self.sizes) > 1)
        self.above.setEnabled(bool(self.types))

    def _problem(self) -> str:
        """What is wrong with the table, in words; one branch is enough to tell."""
        table = self.table
        if self._agents > MOST_AGENTS:
            return f"that would be {self._agents:,} agents; allowed are {MOST_AGENTS:,}"
        try:
            outline = from_table([1] * len(table.sizes), table.types)
        except HierarchyError as error:
            return str(error)
        found = problems(outline, {node_type.name: node_type for node_type in self._types})
        return found[0][1] if found else ""

    def _grow(self) -> None:
        top = self.types[0].currentText()
        if self._over(top) is None:
            self.type_wanted.emit(top)
        over = self._over(top)
        if over is not None:
            table = self.table
            self._build((1, *table.sizes), (over, *table.types))

    def _over(self, top: str) -> str | None:
        """The first type that may stand over another."""
        return next((t.name for t in self._types if top in t.subsidiaries), None)

    def _shrink(self) -> None:
        table = self.table
        self._build(table.sizes[1:], table.types[1:])

    @property
    def draft(self) -> LevelTable | None:
        """What the user has changed and could have, but has not made yet; what was made by hand is not replaced so."""
        by_hand = not isinstance(self._forest, LevelTable)
        return None if by_hand or not self.use.isEnabled() else self.table

    def forget(self) -> None:
        """The draft is made, or not wanted."""
        self._forest = None
        self.use.setEnabled(False)

    def _use(self) -> None:
        self.wanted.emit(self.table)


def as_table(forest: Hierarchy) -> LevelTable | None:
    """The table of a regular forest; None if it is not regular."""
    sizes, types = [], []
    nodes: tuple[Node, ...] = forest.roots
    groups = [nodes]
    while nodes:
        if len({len(group) for group in groups}) != 1 or len({node.type for node in nodes}) != 1:
            return None
        sizes.append(len(groups[0]))
        types.append(nodes[0].type)
        if len({bool(node.children) for node in nodes}) != 1:
            return None
        groups = [node.children for node in nodes if node.children]
        nodes = tuple(node for group in groups for node in group)
    return LevelTable(tuple(sizes), tuple(types)) if sizes else None
