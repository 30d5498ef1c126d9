"""Everything about a behavior that can be changed later: a window that stays open beside the work."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from ..forms.buttons import closing
from ..selection import BehaviorKey
from .editing import LiveEditing
from .pages_dialog import GENERAL, PagesDialog

if TYPE_CHECKING:
    from ..studio import Studio


def behavior_settings(
    studio: Studio, parent: QWidget, page: str = "", field: str = "", behavior: BehaviorKey | None = None
) -> BehaviorDialog | None:
    """Open the settings of a behavior, or of the one that is shown; bring them to the front if they are open.

    Args:
        page: One of the pages' names to begin with.
        field: ``note`` to go on typing there.
    """
    wanted = behavior or studio.selection.behavior
    if wanted is None:
        return None
    dialogs = parent.window().findChildren(BehaviorDialog)
    dialog = next((d for d in dialogs if d.behavior == wanted), None) or BehaviorDialog(
        studio, wanted, parent.window()
    )
    dialog.show()
    dialog.raise_()
    dialog.activateWindow()
    dialog.turn_to(page)
    if field == "note":
        dialog.turn_to(GENERAL)
        dialog.general.note.setFocus()
    return dialog


class BehaviorDialog(PagesDialog):
    """The settings of one behavior; every change is done at once and can be undone.

    Attributes:
        behavior: Which one.
    """

    def __init__(self, studio: Studio, behavior: BehaviorKey, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("behavior-settings")
        self.behavior = behavior
        self._studio = studio
        self._editing = LiveEditing(studio, behavior.type, behavior.id)
        self._editing.setParent(self)
        self._offer(self._editing)
        self.gone = QLabel("This behavior is gone; undo brings it back.")
        self.gone.setProperty("role", "empty")
        column = QVBoxLayout(self)
        column.addWidget(self.tabs, 1)
        column.addWidget(self.gone)
        column.addWidget(closing(self))
        self._editing.changed.connect(self._refresh)
        studio.opened.connect(self.close)
        studio.closing.connect(self.close)
        self._refresh()

    def _refresh(self) -> None:
        automaton = self._editing.automaton
        self.gone.setVisible(automaton is None)
        self.tabs.setEnabled(automaton is not None)
        name = self.behavior.id if automaton is None else automaton.name
        self.setWindowTitle(f"{name} – behavior settings")
