"""The slots of a behavior or feature, each bound to what exists."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QComboBox, QFormLayout, QWidget

from ...core.features import Binding, Ground, Parameter
from ...core.vocabulary import Target
from .tab_order import tab_through
from .word_list import WordList


class BoxForm(QWidget):
    """Boxes to choose from, which leave Enter to it.

    Signals:
        entered: Enter was pressed in one of them.
    """

    entered = Signal()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Ctrl+Enter and the like are for the window."""
        is_plain = not event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and is_plain:
            self.entered.emit()
        else:
            super().keyPressEvent(event)


class SlotForm(BoxForm):
    """The slots of what a state holds or a feature senses, each bound to what exists.

    Signals:
        bound: The user bound a slot: its name and the binding.
    """

    bound = Signal(str, object)

    def __init__(self) -> None:
        super().__init__()
        self._form = QFormLayout(self)
        self._form.setContentsMargins(0, 0, 0, 0)
        self.boxes: dict[str, QComboBox] = {}
        self._shown: object = None

    def show_slots(
        self,
        slots: Sequence[str],
        bindings: Mapping[str, Binding],
        parameters: Sequence[str],
        targets: Mapping[str, Target],
    ) -> None:
        """Show the slots with their bindings, and what they can be bound to."""
        offered = tuple(slots), tuple(parameters), tuple(targets)
        if offered != self._shown:
            self._shown = offered
            while self._form.rowCount():
                self._form.removeRow(0)
            self.boxes = {slot: self._box(slot, parameters, targets) for slot in slots}
            for slot, box in self.boxes.items():
                self._form.addRow(f"{slot} is", box)
            tab_through(self, self.boxes.values())
        for slot, box in self.boxes.items():
            place = next((k for k in range(box.count()) if box.itemData(k) == bindings.get(slot)), -1)
            box.setCurrentIndex(place)
        self.setVisible(bool(slots))

    def _box(self, slot: str, parameters: Sequence[str], targets: Mapping[str, Target]) -> QComboBox:
        box = WordList()
        box.setAccessibleName(f"What {slot} is")
        box.setToolTip(f"What {slot!r} stands for: a target of the world, or a parameter of the behavior")
        box.setPlaceholderText("choose a target")
        for name in parameters:
            box.addItem(f"parameter {name}", Parameter(name))
        for name, target in targets.items():
            box.addItem(name, Ground(name))
            box.setItemData(box.count() - 1, target.doc, Qt.ItemDataRole.ToolTipRole)
        box.activated.connect(lambda _, slot=slot, box=box: self.bound.emit(slot, box.currentData()))
        return box
