"""The command palette on the screen: a line to type in, and below it what fits best."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QAbstractListModel, QEvent, QModelIndex, QObject, QPersistentModelIndex, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QFrame, QLabel, QLineEdit, QListView, QVBoxLayout, QWidget

from ..searching import words_in
from ..theme import mixed
from .catalog import Ask, Catalog, Entry
from .entry_painting import EntryDelegate

if TYPE_CHECKING:
    from ..studio import Studio

WIDTH, ROWS, TOP = 620, 11, 48
Index = QModelIndex | QPersistentModelIndex
_MOVES = {Qt.Key.Key_Down: 1, Qt.Key.Key_Up: -1, Qt.Key.Key_PageDown: ROWS, Qt.Key.Key_PageUp: -ROWS}


class EntryModel(QAbstractListModel):
    """The entries that are shown."""

    def __init__(self) -> None:
        super().__init__()
        self.entries: list[Entry] = []
        self.words: tuple[str, ...] = ()

    def show(self, words: tuple[str, ...], entries: list[Entry]) -> None:
        """Show these entries, found by *words*."""
        self.beginResetModel()
        self.words, self.entries = words, entries
        self.endResetModel()

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - Qt's own signature
        """As many as were found."""
        return 0 if parent.isValid() else len(self.entries)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        """The text of an entry; tool tip and screen reader get the rest as well."""
        entry = self.entries[index.row()]
        if role == Qt.ItemDataRole.DisplayRole:
            return entry.text
        if role in (Qt.ItemDataRole.ToolTipRole, Qt.ItemDataRole.AccessibleTextRole):
            return ", ".join(part for part in (entry.text, entry.kind, entry.detail, entry.keys) if part)
        return None

    def flags(self, index: Index) -> Qt.ItemFlag:
        """What is not possible now cannot be chosen."""
        entry = self.entries[index.row()]
        usable = entry.do is not None or entry.asks is not None
        return super().flags(index) if usable else Qt.ItemFlag.ItemIsSelectable


class Palette(QFrame):
    """Finds things by words or a few letters; Enter does them, Esc leaves.

    Attributes:
        line: Where the user types.
        list: What was found.
        problem: Why a typed value cannot be used.
    """

    def __init__(self, studio: Studio, window: QWidget, make: Callable[[], Catalog]) -> None:
        super().__init__(window)
        self._studio = studio
        self._make = make
        self._over = window
        self._catalog: Catalog | None = None
        self._ask: Ask | None = None
        self.setObjectName("palette")
        self.setAccessibleName("Command palette")
        self.line = QLineEdit()
        self.line.setAccessibleName("Search")
        self.line.setClearButtonEnabled(True)
        self.line.textChanged.connect(self._search)
        self.line.installEventFilter(self)
        self.model = EntryModel()
        self.list = QListView()
        self.list.setModel(self.model)
        self.list.setUniformItemSizes(True)
        self.list.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._delegate = EntryDelegate(studio.theme, self.model, self.list)
        self.list.setItemDelegate(self._delegate)
        self.list.clicked.connect(self._choose)
        self.problem = QLabel()
        self.problem.setWordWrap(True)
        self.problem.setContentsMargins(12, 4, 12, 8)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 8, 8, 8)
        layout.setSpacing(6)
        for widget in (self.line, self.list, self.problem):
            layout.addWidget(widget)
        studio.theme.changed.connect(self._dress)
        window.installEventFilter(self)
        self._dress()
        self.hide()

    def open(self) -> None:
        """Begin to search."""
        self._catalog = self._make()
        self._ask = None
        self.problem.hide()
        self.list.show()
        self.line.setPlaceholderText("Search actions, behaviors, agents, parameters, settings")
        self.line.clear()
        self._search("")
        self._place()
        self.show()
        self.raise_()
        self.line.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def leave(self) -> None:
        """Search no more."""
        self._catalog = None
        self.hide()
        self.window().setFocus()

    # ------------------------------------------------------------------------------------------- searching

    def _search(self, text: str) -> None:
        if self._ask is not None:
            self.problem.setVisible(False)
            return
        if self._catalog is None:
            return
        entries = self._catalog.find(text)
        self.model.show(words_in(text), entries)
        self.problem.setVisible(not entries)
        if not entries:
            self.problem.setText(
                f"Nothing is found by “{text.strip()}”. Fewer words, or fewer letters, find more."
            )
        self._select(0, 1)

    def _select(self, row: int, step: int) -> None:
        """Go to the nearest entry from *row* on that can be chosen."""
        count = self.model.rowCount()
        for away in range(count):
            at = self.model.index((row + away * step) % count)
            if self.model.flags(at) & Qt.ItemFlag.ItemIsEnabled:
                self.list.setCurrentIndex(at)
                return

    def _move(self, rows: int) -> None:
        count = self.model.rowCount()
        if count:
            here = self.list.currentIndex().row()
            there = (here + rows) % count if abs(rows) == 1 else max(0, min(here + rows, count - 1))
            self._select(there, 1 if rows > 0 else -1)

    # -------------------------------------------------------------------------------------------- choosing

    def _choose(self, index: Index) -> None:
        if not index.isValid() or not self.model.flags(index) & Qt.ItemFlag.ItemIsEnabled:
            return
        entry = self.model.entries[index.row()]
        if entry.asks is not None:
            self._begin_asking(entry.asks)
        elif entry.do is not None:
            self.leave()
            entry.do()

    def _begin_asking(self, ask: Ask) -> None:
        self._ask = ask
        self.list.hide()
        self.problem.hide()
        self.line.setPlaceholderText(ask.prompt)
        self.line.setText(ask.value)
        self.line.selectAll()
        self._tell(f"{ask.prompt}: type another value and press Enter")

    def _tell(self, text: str) -> None:
        self.problem.setText(text[:1].upper() + text[1:])
        self.problem.show()
        self._place()

    def _take(self, ask: Ask) -> None:
        problem = ask.take(self.line.text())
        if problem:
            self._tell(problem)
        else:
            self.leave()

    # ------------------------------------------------------------------------------------------------ keys

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Keys that move and choose, wherever the cursor is; the palette goes when the user looks elsewhere."""
        if watched is self.line and isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            return self._key(event)
        if watched is self.line and event.type() == QEvent.Type.ShortcutOverride:
            event.accept()  # keys are typed here, not obeyed
            return True
        if watched is self.line and event.type() == QEvent.Type.FocusOut and self.isVisible():
            self.hide()
        if watched is self.parent() and event.type() == QEvent.Type.Resize and self.isVisible():
            self._place()
        return super().eventFilter(watched, event)

    def _key(self, event: QKeyEvent) -> bool:
        key = Qt.Key(event.key())
        if key == Qt.Key.Key_Escape:
            self.leave()
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            if self._ask is not None:
                self._take(self._ask)
            else:
                self._choose(self.list.currentIndex())
        elif key in _MOVES and self._ask is None:
            self._move(_MOVES[key])
        else:
            return False
        return True

    # ------------------------------------------------------------------------------------------------ looks

    def _place(self) -> None:
        window = self._over
        width = min(WIDTH, window.width() - 32)
        rows = ROWS * self._delegate.height
        height = rows + 70 if self.list.isVisibleTo(self) else 110
        self.setGeometry((window.width() - width) // 2, TOP, width, min(height, window.height() - TOP - 16))

    def _dress(self) -> None:
        colors = self._studio.theme.palette
        edge = mixed(colors.dim, colors.panel, 0.5).name()  # it lies on panels of the same color
        self.setStyleSheet(
            f"#palette {{ background: {colors.panel}; border: 1px solid {edge}; border-radius: 9px; }}"
            "#palette QLineEdit { padding: 7px 10px; font-size: 14px; }"
        )
