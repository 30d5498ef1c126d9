"""The table of all actions with their shortcuts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import (
    QHBoxLayout,
    QHeaderView,
    QKeySequenceEdit,
    QLabel,
    QLineEdit,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from ..actions import MENUS
from ..forms.buttons import text_button
from ..forms.parts import caption
from ..searching import has_words, words_in

if TYPE_CHECKING:
    from ..actions import ActionRow
    from ..studio import Studio

NAME, KEYS, MENU = range(3)


class KeysEdit(QKeySequenceEdit):
    """Takes all keys but Escape, which leaves it as everywhere.

    Signals:
        left: Escape was pressed.
    """

    left = Signal()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """See above."""
        if event.key() == Qt.Key.Key_Escape and event.modifiers() == Qt.KeyboardModifier.NoModifier:
            self.left.emit()
        else:
            super().keyPressEvent(event)


class KeysPage(QWidget):
    """Shows the shortcut of every action, and changes that of the one selected.

    Attributes:
        table: A row an action.
        whose: Says which action's keys are changed.
        edit: Takes the keys that are pressed.
        conflict: Who has these keys already.
    """

    changed = Signal()

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._ids: list[str] = []
        self.filter = QLineEdit()
        self.filter.setPlaceholderText("Filter actions")
        self.filter.setAccessibleName("Filter actions")
        self.filter.setClearButtonEnabled(True)
        self.filter.textChanged.connect(self._filter)
        self.table = self._table()
        self.whose = caption("")
        self.edit = KeysEdit()
        self.edit.setMaximumSequenceLength(1)
        self.edit.setAccessibleName("Shortcut")
        self.edit.setToolTip("Click here and press the keys that the action is to have")
        self.edit.editingFinished.connect(self._take)
        self.edit.left.connect(self.table.setFocus)
        self.none = text_button("No keys", "Let the action have no shortcut", lambda: self._set(""))
        self.reset = text_button("Standard", "Give the action its own shortcut back", self._reset)
        self.reset_all = text_button(
            "Reset all", "Give all actions their own shortcuts back", self._reset_all
        )
        self.conflict = QLabel()
        self.conflict.setWordWrap(True)
        self.conflict.setMinimumHeight(self.conflict.fontMetrics().lineSpacing() * 2)
        self._build()
        studio.settings.changed.connect(self._setting_changed)
        self.fill()

    def _table(self) -> QTableWidget:
        table = QTableWidget(0, 3)
        table.setHorizontalHeaderLabels(["Action", "Keys", "Menu"])
        table.verticalHeader().hide()
        table.setShowGrid(False)
        table.setSelectionBehavior(QTableWidget.SelectionBehavior.SelectRows)
        table.setSelectionMode(QTableWidget.SelectionMode.SingleSelection)
        table.setEditTriggers(QTableWidget.EditTrigger.NoEditTriggers)
        table.setTabKeyNavigation(False)
        table.setAccessibleName("Actions")
        head = table.horizontalHeader()
        head.setSectionResizeMode(NAME, QHeaderView.ResizeMode.Stretch)
        head.setSectionResizeMode(KEYS, QHeaderView.ResizeMode.ResizeToContents)
        head.setSectionResizeMode(MENU, QHeaderView.ResizeMode.ResizeToContents)
        head.setHighlightSections(False)
        head.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        table.currentCellChanged.connect(self._selected)
        return table

    def _build(self) -> None:
        row = QHBoxLayout()
        row.setSpacing(8)
        row.addWidget(self.edit, 1)
        for button in (self.none, self.reset, self.reset_all):
            row.addWidget(button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 12, 0, 0)
        layout.setSpacing(8)
        layout.addWidget(self.filter)
        layout.addWidget(self.table, 1)
        layout.addWidget(self.whose)
        layout.addLayout(row)
        layout.addWidget(self.conflict)

    # ---------------------------------------------------------------------------------------------- showing

    def fill(self) -> None:
        """Show all actions with the keys in force."""
        actions = self._studio.actions
        chosen = self.action
        self._ids = sorted(actions.rows, key=lambda name: _place(actions.rows[name]))
        self.table.blockSignals(True)
        self.table.setRowCount(len(self._ids))
        for at, action_id in enumerate(self._ids):
            row = actions.rows[action_id]
            keys = QKeySequence(actions.keys_of(action_id)).toString(QKeySequence.SequenceFormat.NativeText)
            for column, text in ((NAME, row.text.rstrip("…")), (KEYS, keys), (MENU, row.menu)):
                item = QTableWidgetItem(text)
                item.setToolTip(row.tip)
                if column == KEYS and action_id in self._studio.settings.keys:
                    font = item.font()
                    font.setBold(True)
                    item.setFont(font)
                self.table.setItem(at, column, item)
        self.table.blockSignals(False)
        self.select(chosen or self._ids[0])
        self._filter(self.filter.text())

    def select(self, action_id: str) -> None:
        """Show this action's keys for changing."""
        if action_id in self._ids:
            self.table.setCurrentCell(self._ids.index(action_id), NAME)
            self._selected()

    @property
    def action(self) -> str:
        """The action that is selected and in sight; empty if none is."""
        at = self.table.currentRow()
        is_seen = 0 <= at < len(self._ids) and not self.table.isRowHidden(at)
        return self._ids[at] if is_seen else ""

    def _filter(self, text: str) -> None:
        """Show the actions that have these words; nobody changes the keys of one that is out of sight."""
        wanted = words_in(text)
        for at in range(self.table.rowCount()):
            cells = (self.table.item(at, column) for column in (NAME, KEYS, MENU))
            texts = [cell.text() for cell in cells if cell is not None]
            self.table.setRowHidden(at, not has_words(wanted, *texts))
        if not self.action:
            shown = (at for at in range(self.table.rowCount()) if not self.table.isRowHidden(at))
            self.table.setCurrentCell(next(shown, -1), NAME)
        self._selected()

    def _selected(self) -> None:
        action, settings = self.action, self._studio.settings
        for part in (self.edit, self.none):
            part.setEnabled(bool(action))
        if action:
            self.whose.setText(f"Keys of {self._studio.actions.rows[action].text.rstrip('…')}")
            self.edit.setKeySequence(QKeySequence(self._studio.actions.keys_of(action)))
        else:
            self.whose.setText("No action has these words in its name, keys or menu.")
            self.edit.clear()
        self.reset.setEnabled(action in settings.keys)
        self.reset_all.setEnabled(bool(settings.keys))
        self.conflict.clear()

    def _setting_changed(self, name: str) -> None:
        if name == "keys":
            self.fill()

    # --------------------------------------------------------------------------------------------- changing

    def _take(self) -> None:
        self._set(self.edit.keySequence().toString(QKeySequence.SequenceFormat.PortableText))

    def _set(self, keys: str) -> None:
        """Give the selected action these keys, unless another has them."""
        action, actions = self.action, self._studio.actions
        if not action or keys == actions.keys_of(action):
            return
        holder = self.holder(keys) if keys else ""
        if holder and holder != action:
            shown = QKeySequence(keys).toString(QKeySequence.SequenceFormat.NativeText)
            name = actions.rows[holder].text.rstrip("…")
            self.edit.setKeySequence(QKeySequence(actions.keys_of(action)))
            self.conflict.setText(f"{shown} is taken by {name}; give that other keys, or none, first.")
            return
        if menu := self._menu(keys):
            self.edit.setKeySequence(QKeySequence(actions.keys_of(action)))
            self.conflict.setText(f"{keys} opens the menu {menu}; press other keys.")
            return
        own = actions.rows[action].keys
        self._studio.settings.set_key(action, None if keys == own else keys)

    def _menu(self, keys: str) -> str:
        """The menu that these keys open; empty if they open none."""
        letter = keys.removeprefix("Alt+").lower()
        return self._studio.actions.menu_letters().get(letter, "") if keys.startswith("Alt+") else ""

    def holder(self, keys: str) -> str:
        """The action that has these keys; empty if none has."""
        wanted = QKeySequence(keys)
        actions = self._studio.actions
        return next((name for name in actions.rows if QKeySequence(actions.keys_of(name)) == wanted), "")

    def _reset(self) -> None:
        own = self._studio.actions.rows[self.action].keys if self.action else ""
        holder = self.holder(own) if own else ""
        if holder and holder != self.action:
            name = self._studio.actions.rows[holder].text.rstrip("…")
            self.conflict.setText(f"{own} is taken by {name}; give that other keys, or none, first.")
        elif self.action:
            self._studio.settings.set_key(self.action, None)

    def _reset_all(self) -> None:
        for action in list(self._studio.settings.keys):
            self._studio.settings.set_key(action, None)


def _place(row: ActionRow) -> tuple[bool, int, str]:
    """In the order of the menus, those that are in none at the end."""
    return not row.menu, MENUS.index(row.menu) if row.menu else 0, row.text
