"""Editing labels and weights in the table: only what is allowed can be chosen."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QAbstractItemModel, QModelIndex, QPersistentModelIndex, Qt, QTimer
from PySide6.QtWidgets import QComboBox, QDoubleSpinBox, QStyledItemDelegate, QStyleOptionViewItem, QWidget

from ..forms.word_list import WordList
from ..number_box import RealBox, roomy
from .model import states_of

if TYPE_CHECKING:
    from .model import ExamplesModel

Index = QModelIndex | QPersistentModelIndex
HEAVIEST = 1_000_000.0


class LabelDelegate(QStyledItemDelegate):
    """A choice among the automaton's states."""

    def __init__(self, model: ExamplesModel, parent: QWidget) -> None:
        super().__init__(parent)
        self._model = model

    def createEditor(self, parent: QWidget, _option: QStyleOptionViewItem, _index: Index) -> QWidget:
        """The states to choose from."""
        box = WordList(parent)
        if self._model.subject is not None:
            for state_id, name in states_of(self._model.subject):
                box.addItem(name, state_id)
        box.activated.connect(lambda _: self._chosen(box))
        return box

    def _chosen(self, box: QComboBox) -> None:
        self.commitData.emit(box)
        self.closeEditor.emit(box)

    def setEditorData(self, editor: QWidget, index: Index) -> None:
        """Begin with what it says now."""
        assert isinstance(editor, QComboBox)
        editor.setCurrentIndex(editor.findData(index.data(Qt.ItemDataRole.EditRole)))
        QTimer.singleShot(0, editor, editor.showPopup)  # nobody edits a label without choosing one

    def setModelData(self, editor: QWidget, model: QAbstractItemModel, index: Index) -> None:
        """Relabel."""
        assert isinstance(editor, QComboBox)
        if editor.currentData() is not None:
            model.setData(index, editor.currentData())


class WeightDelegate(QStyledItemDelegate):
    """A number; 0 can be typed, so that whoever does is told how an example is left out."""

    def createEditor(self, parent: QWidget, _option: QStyleOptionViewItem, _index: Index) -> QWidget:
        """A number to type."""
        box = roomy(RealBox(parent))
        box.setRange(0.0, HEAVIEST)
        box.setDecimals(2)
        box.setFrame(False)
        return box

    def setEditorData(self, editor: QWidget, index: Index) -> None:
        """Begin with what it is now."""
        assert isinstance(editor, QDoubleSpinBox)
        editor.setValue(float(index.data(Qt.ItemDataRole.EditRole)))

    def setModelData(self, editor: QWidget, model: QAbstractItemModel, index: Index) -> None:
        """Weight it."""
        assert isinstance(editor, QDoubleSpinBox)
        editor.interpretText()
        model.setData(index, editor.value())
