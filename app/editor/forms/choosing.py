"""Choosing one of many by typing words of its name."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from PySide6.QtCore import (
    QAbstractItemModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSortFilterProxyModel,
    Qt,
    Signal,
)
from PySide6.QtGui import QFocusEvent, QMouseEvent, QStandardItemModel
from PySide6.QtWidgets import QAbstractItemView, QComboBox, QCompleter, QLineEdit

from ..searching import has_words, words_in
from .word_list import WordList


@dataclass(frozen=True, slots=True)
class Choice:
    """Something to choose.

    Attributes:
        value: What it stands for.
        tip: What it is, in words.
    """

    name: str
    value: object
    tip: str = ""


class _Field(QLineEdit):
    """The first click into it, and any while it is empty, shows all that can be chosen; what one types is instead."""

    def __init__(self) -> None:
        super().__init__()
        self._clicked_into = False

    def focusInEvent(self, event: QFocusEvent) -> None:
        """See above."""
        super().focusInEvent(event)
        self._clicked_into = event.reason() == Qt.FocusReason.MouseFocusReason

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """See above."""
        super().mouseReleaseEvent(event)
        if self._clicked_into or not self.text():
            self._clicked_into = False
            self.selectAll()
            completer = self.completer()
            completer.setCompletionPrefix("")
            completer.complete()


class _Left(QSortFilterProxyModel):
    """The choices in whose names all words are that were typed."""

    words: tuple[str, ...] = ()

    def use(self, words: tuple[str, ...]) -> None:
        """Leave those with these words."""
        self.beginFilterChange()
        self.words = words
        self.endFilterChange()

    def filterAcceptsRow(self, row: int, parent: QModelIndex | QPersistentModelIndex) -> bool:
        """Whether a choice is left."""
        return not self.words or has_words(self.words, str(self.sourceModel().index(row, 0, parent).data()))


class _Completer(QCompleter):
    """Offers what is left by all words that were typed, in any order, as all searches of the window do."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._left, self._nothing = _Left(self), QStandardItemModel(self)
        self.setModel(self._left)

    def offer(self, choices: QAbstractItemModel | None) -> None:
        """Offer these; none while they change, since the field's words come and go in their midst."""
        self._left.setSourceModel(self._nothing if choices is None else choices)

    def splitPath(self, path: str) -> list[str]:
        """What Qt is to look for in what is left: nothing more."""
        self._left.use(words_in(path))
        return [""]


class Chooser(WordList):
    """A list of choices that can be opened, or narrowed by typing words of a name; Enter takes the only one left.

    Args:
        name: What it is called to those who do not see it.
        hint: What stands in it while nothing is chosen.
        is_new: Whether what was typed names something of the user's own, which is not to become one of the choices.

    Attributes:
        field: Where one types.

    Signals:
        chosen: By the user: the `Choice`, or None while what stands in the field names nothing.
        entered: Enter was pressed, and not to choose one of those that are offered.
    """

    chosen = Signal(object)
    entered = Signal()

    def __init__(self, name: str, hint: str, is_new: Callable[[str], bool] = lambda _: False) -> None:
        super().__init__()
        self._choices: tuple[Choice, ...] = ()
        self._is_new = is_new
        self.setAccessibleName(name)
        self.field: QLineEdit = _Field()
        self.setEditable(True)
        self.setLineEdit(self.field)
        self.setInsertPolicy(QComboBox.InsertPolicy.NoInsert)
        self.setMaxVisibleItems(16)
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(12)
        self.field.setPlaceholderText(hint)
        self._completer = completer = _Completer(self)
        self.setCompleter(completer)
        completer.setCompletionMode(QCompleter.CompletionMode.PopupCompletion)
        completer.setCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
        completer.setMaxVisibleItems(self.maxVisibleItems())
        popup = completer.popup()
        assert popup is not None
        popup.setObjectName("completions")
        self._popup: QAbstractItemView = popup
        self.activated.connect(self._activated)
        completer.activated.connect(self._completed)
        self.field.editingFinished.connect(self._typed)
        self.field.returnPressed.connect(self._return_pressed)
        self._shown = -1

    def offer(self, choices: Iterable[Choice], chosen: object = None) -> None:
        """Offer these; the one with the value *chosen* is shown, or none."""
        offered = tuple(choices)
        if offered != self._choices:
            self._choices = offered
            self._completer.offer(None)
            self.clear()
            for at, choice in enumerate(offered):
                self.addItem(choice.name)
                self.setItemData(at, choice.tip, Qt.ItemDataRole.ToolTipRole)
            self._completer.offer(self.model())
        self.show_value(chosen)

    def show_value(self, value: object) -> None:
        """Show the choice with this value, without telling anybody."""
        at = next((k for k, choice in enumerate(self._choices) if choice.value == value), -1)
        self.setCurrentIndex(at)
        self._shown = at
        if at < 0:
            self.setEditText("")
        tip = self._choices[at].tip if at >= 0 else ""
        self.setToolTip(tip or self.field.placeholderText())

    @property
    def choice(self) -> Choice | None:
        """What is chosen: what the field names."""
        text = self.currentText().strip().casefold()
        found = [choice for choice in self._choices if choice.name.casefold() == text]
        return found[0] if found else None

    def _completed(self, _text: object) -> None:
        self._typed()

    def _return_pressed(self) -> None:
        lit = self._popup.isVisible() and self._popup.currentIndex().isValid()
        if not lit:  # otherwise that is what Enter chooses
            self._take_the_only_one()
            self.entered.emit()

    def _take_the_only_one(self) -> None:
        text = self.currentText().strip()
        if not text or self.choice is not None or self._is_new(text):
            return
        left = [choice.name for choice in self._choices if has_words(words_in(text), choice.name)]
        if len(left) == 1:
            self.setEditText(left[0])
            self._typed()

    def _typed(self) -> None:
        choice = self.choice
        self._activated(-1 if choice is None else self._choices.index(choice))

    def _activated(self, at: int) -> None:
        if at == self._shown:
            return
        self._shown = at
        if at >= 0 and self.currentIndex() != at:
            self.setCurrentIndex(at)
        self.setToolTip((self._choices[at].tip if at >= 0 else "") or self.field.placeholderText())
        self.chosen.emit(self._choices[at] if at >= 0 else None)
