"""A field at the top of a long menu that leaves the entries which hold what is typed."""

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction, QKeyEvent
from PySide6.QtWidgets import QApplication, QLineEdit, QMenu, QWidgetAction

from ..letters import unmarked

#: A menu of more entries than this is searched rather than read.
MOST_READ = 24
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
        self._entries = [entry for entry in menu.actions() if not entry.isSeparator() and entry is not always]
        self._sections = [entry for entry in menu.actions() if entry.isSeparator()]
        self.field = QLineEdit(placeholderText="Find")
        self.field.setAccessibleName(tip)
        self.field.setToolTip(tip)
        self.field.textChanged.connect(self._find)
        self.field.installEventFilter(self)
        holder = QWidgetAction(menu)
        holder.setDefaultWidget(self.field)
        menu.insertAction(menu.actions()[0], holder)
        menu.ensurePolished()  # without which the next line would change nothing
        menu.setStyleSheet("QMenu { menu-scrollable: 1; }")  # rather than columns across the screen
        menu.aboutToShow.connect(self._begin)

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

    def _find(self, text: str) -> None:
        wanted = text.strip().casefold()
        for action in self._entries:
            action.setVisible(wanted in unmarked(action.text()).casefold())
        for section in self._sections:
            section.setVisible(not wanted)
        first = next((action for action in self._entries if action.isVisible()), None)
        if wanted and first is not None:
            self._menu.setActiveAction(first)


def let_find(menu: QMenu, tip: str, always: QAction) -> None:
    """Let a menu be searched if it is too long to be read."""
    if len(menu.actions()) > MOST_READ:
        Finder(menu, tip, always)
