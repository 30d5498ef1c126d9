"""A field at the top of a long menu that leaves the entries which hold what is typed."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction, QKeyEvent
from PySide6.QtWidgets import QApplication, QLineEdit, QMenu, QWidgetAction

from ..letters import unmarked
from ..searching import has_words, words_in

#: A menu of more entries than this is searched rather than read.
MOST_READ = 24
#: Of each part of it so many are shown before something is typed, and so many of what is found: Qt's menus neither scroll
#: nor keep to the screen once entries have come or gone.
MOST_OF_PART, MOST_FOUND = 8, 16
#: What the menu does with a key, though the field has it.
_FOR_THE_MENU = (
    Qt.Key.Key_Up,
    Qt.Key.Key_Down,
    Qt.Key.Key_Return,
    Qt.Key.Key_Enter,
    Qt.Key.Key_Escape,
)


class Finder(QObject):
    """Lets what is typed while a menu is open choose among its entries.

    Attributes:
        field: Stands above the entries.
    """

    def __init__(self, menu: QMenu, tip: str, always: QAction) -> None:
        """Watch a menu that has all its entries; *always* is left whatever is typed."""
        super().__init__(menu)
        self._menu = menu
        self._parts = _parts(menu.actions(), always)
        self.field = QLineEdit(placeholderText="Find")
        self.field.setAccessibleName(tip)
        self.field.setToolTip(tip)
        self.field.textChanged.connect(self._find)
        self.field.installEventFilter(self)
        holder = QWidgetAction(menu)
        holder.setDefaultWidget(self.field)
        menu.insertAction(menu.actions()[0], holder)
        self._rest = [self._told_last(part) for part in self._parts]
        menu.ensurePolished()  # without which the next line would change nothing
        menu.setStyleSheet("QMenu { menu-scrollable: 1; }")  # rather than columns, on a screen that is low
        menu.aboutToShow.connect(self._begin)
        self._find("")
        menu.setMinimumWidth(menu.sizeHint().width())  # so that it stays beside what it was opened from

    def eventFilter(self, _field: QObject, event: QEvent) -> bool:
        """Keys that move and choose are the menu's."""
        if (
            isinstance(event, QKeyEvent)
            and event.type() is QEvent.Type.KeyPress
            and event.key() in _FOR_THE_MENU
        ):
            QApplication.sendEvent(self._menu, event)
            return True
        return False

    def _begin(self) -> None:
        self.field.clear()
        self.field.setFocus(Qt.FocusReason.PopupFocusReason)

    def _told_last(self, part: list[QAction]) -> QAction:
        """An entry behind a part that says how many are not shown."""
        following = self._menu.actions()[self._menu.actions().index(part[-1]) + 1]
        told = QAction(self._menu)
        told.setEnabled(False)
        self._menu.insertAction(following, told)
        return told

    def _find(self, text: str) -> None:
        wanted, room = words_in(text), MOST_FOUND
        first: QAction | None = None
        for (section, *entries), rest in zip(self._parts, self._rest, strict=True):
            section.setVisible(not wanted)
            found = [entry for entry in entries if has_words(wanted, unmarked(entry.text()))]
            shown = found[: room if wanted else MOST_OF_PART]
            for entry in entries:
                entry.setVisible(entry in shown)
            left = len(found) - len(shown)
            rest.setText(f"{left} more: type {'on ' if wanted else ''}to find them")
            rest.setVisible(left > 0)
            room -= len(shown)
            first = first or next(iter(shown), None)
        if wanted and first is not None:
            self._menu.setActiveAction(first)


def _parts(entries: Sequence[QAction], always: QAction) -> list[list[QAction]]:
    """The parts of a menu: each a title and what stands below it."""
    parts: list[list[QAction]] = []
    for entry in entries:
        if entry.isSeparator():
            parts.append([entry])
        elif entry is not always:
            parts[-1].append(entry)
    return [part for part in parts if len(part) > 1]


def let_find(menu: QMenu, tip: str, always: QAction) -> None:
    """Let a menu be searched if it is too long to be read."""
    if len(menu.actions()) > MOST_READ:
        Finder(menu, tip, always)
