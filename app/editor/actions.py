"""Everything the user can do, as one table: each row gives menu, shortcut, tip, icon, and when it is possible.

Panels add rows of their own; menus, tool bar and command palette are all made from the same ones.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject
from PySide6.QtGui import QAction, QKeySequence

from .icons import icon
from .letters import letters_of, marked

if TYPE_CHECKING:
    from .studio import Studio

#: Menus in the order in which they stand.
MENUS = ("File", "Edit", "View", "Behavior", "Teach", "Run", "Experiment", "Help")
#: Groups of a menu that open from it, under these words: a menu with all of their rows would be higher than a low screen.
SUBMENUS = {
    ("Edit", "forest"): "Agents and controllers",
    ("View", "panels"): "Panels",
    ("Behavior", "graph"): "Automaton",
    ("Behavior", "states"): "Automaton",
    ("Behavior", "tree"): "Decision tree",
    ("Behavior", "examples"): "Examples",
}


@dataclass(frozen=True, slots=True)
class When:
    """When something is possible.

    Attributes:
        holds: Whether it is now.
        first: What has to be done before it is, or why it cannot be: the tip says so while it is not.
    """

    holds: Callable[[Studio], bool]
    first: str | Callable[[Studio], str]

    def __call__(self, studio: Studio) -> bool:
        """Whether it is possible now."""
        return self.holds(studio)

    def why_not(self, studio: Studio) -> str:
        """Why it is not possible, as of now."""
        return self.first if isinstance(self.first, str) else self.first(studio)


def needs(first: str | Callable[[Studio], str]) -> Callable[[Callable[[Studio], bool]], When]:
    """Make a condition of a function, with what has to be done *first* where it does not hold."""
    return lambda holds: When(holds, first)


@needs("")
def always(_studio: Studio) -> bool:
    """Possible at any time."""
    return True


@needs("open a project first")
def when_open(studio: Studio) -> bool:
    """Possible while a project is open."""
    return studio.is_open


@needs("open a project, and choose an arm of it")
def when_there(studio: Studio) -> bool:
    """Possible while there is a world."""
    return studio.snapshot is not None


@dataclass(frozen=True, slots=True)
class ActionRow:
    """One thing that the user can do.

    Attributes:
        id: Stable, such as ``run.play``: settings keep shortcuts by it.
        text: What menu and palette say; an ellipsis where a dialog asks for more.
        menu: One of `MENUS`; empty where it is only on a button or in a context menu. It is in the palette anyway.
        group: Rows of one menu with another group are parted by a line, or open by themselves (`SUBMENUS`).
        keys: Shortcut, such as ``Ctrl+K``.
        tip: A sentence for tool tips and the status bar.
        icon: Name in the icon family.
        enabled: Whether it is possible now, and why not.
        checked: For a switch: whether it is on now.
        says: For a text that changes: what it says now.
    """

    id: str
    text: str
    menu: str
    do: Callable[[Studio], object]
    group: str = ""
    keys: str = ""
    tip: str = ""
    icon: str = ""
    enabled: When = always
    checked: Callable[[Studio], bool] | None = None
    says: Callable[[Studio], str] | None = None


class _Action(QAction):
    """Qt's action of a row.

    Attributes:
        by_keys: While it is carried out: whether its shortcut was pressed, rather than it was chosen somewhere.
    """

    by_keys = False

    def event(self, event: QEvent) -> bool:
        """Be carried out by a shortcut, among others."""
        if event.type() is not QEvent.Type.Shortcut:
            return super().event(event)
        self.by_keys = True
        try:
            return super().event(event)
        finally:
            self.by_keys = False


class Actions(QObject):
    """The actions of the window by id."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._rows: dict[str, ActionRow] = {}
        self._actions: dict[str, _Action] = {}
        self._letters: dict[str, str] = {}

    @property
    def rows(self) -> Mapping[str, ActionRow]:
        """All rows by id, in the order in which they were added."""
        return self._rows

    def __getitem__(self, action_id: str) -> QAction:
        """Qt's action of a row."""
        return self._actions[action_id]

    def is_by_keys(self, action_id: str) -> bool:
        """Whether an action is carried out just now because its shortcut was pressed."""
        return self._actions[action_id].by_keys

    def add(self, rows: Iterable[ActionRow]) -> None:
        """Add rows; their ids must be new."""
        for row in rows:
            if row.id in self._rows:
                raise ValueError(f"there are two actions {row.id!r}")
            self._rows[row.id] = row
            self._actions[row.id] = self._made(row)

    def clear(self) -> None:
        """Forget all rows: the window that they were for is gone."""
        self._rows.clear()
        self._actions.clear()
        self._letters.clear()

    def text_of(self, action_id: str) -> str:
        """What an action says now, without the mark of its letter, which `QAction.text` has."""
        row = self._rows[action_id]
        return row.text if row.says is None else row.says(self._studio)

    def use_letters(self, letters: Mapping[str, str]) -> None:
        """Let these actions have these letters in the menus."""
        self._letters.update(letters)
        for action_id in letters:
            self._say(self._rows[action_id], self._actions[action_id])

    def menu_letters(self) -> Mapping[str, str]:
        """The menu that each letter opens with Alt: none that an action has in this way."""
        keys = (self.keys_of(action_id) for action_id in self._rows)
        taken = [key[-1] for key in keys if key.startswith("Alt+") and len(key) == len("Alt+F")]
        return {letter: menu for menu, letter in zip(MENUS, letters_of(MENUS, taken), strict=True)}

    def keys_of(self, action_id: str) -> str:
        """The shortcut in force: the user's, or the row's own."""
        return self._studio.settings.keys.get(action_id, self._rows[action_id].keys)

    def do(self, action_id: str) -> None:
        """Carry out an action as things are now, or tell why that is not possible: for keys that a panel takes itself."""
        self.refresh_some([action_id])
        if self._actions[action_id].isEnabled():
            self._actions[action_id].trigger()
        else:
            self._studio.warn(self.why_not(action_id))

    def why_not(self, action_id: str) -> str:
        """Why an action is not possible; empty if it is."""
        possible = self._actions[action_id].isEnabled()
        return "" if possible else self._rows[action_id].enabled.why_not(self._studio)

    def _made(self, row: ActionRow) -> _Action:
        action = _Action(self)
        action.setObjectName(row.id)
        action.setCheckable(row.checked is not None)
        action.setShortcut(QKeySequence(self.keys_of(row.id)))
        action.triggered.connect(lambda: self._run(row))
        self._dress(row, action)
        self._say(row, action)
        self._refresh(row, action)
        return action

    def _run(self, row: ActionRow) -> None:
        row.do(self._studio)
        self.refresh()

    def dress(self) -> None:
        """Icons anew, after the theme changed."""
        for action_id, row in self._rows.items():
            self._dress(row, self._actions[action_id])

    def take_keys(self) -> None:
        """Shortcuts anew, after the keys changed."""
        for action_id, row in self._rows.items():
            action = self._actions[action_id]
            action.setShortcut(QKeySequence(self.keys_of(action_id)))
            self._tell_keys(row, action)

    def _dress(self, row: ActionRow, action: QAction) -> None:
        if row.icon:
            action.setIcon(icon(row.icon, self._studio.theme))

    def _tell_keys(self, row: ActionRow, action: QAction) -> None:
        keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        tip, text = row.tip or row.text.rstrip("…"), self.text_of(row.id)
        tip = f"{tip} ({keys})" if keys else tip
        why_not = "" if action.isEnabled() else f"Not now: {row.enabled.why_not(self._studio)}"
        action.setToolTip("\n".join(filter(None, ("" if text == row.text else text, tip, why_not))))

    def refresh(self) -> None:
        """Texts, checks, and what is possible, as things are now."""
        self.refresh_some(self._rows)

    def refresh_some(self, action_ids: Iterable[str]) -> None:
        """Some of them; those that no panel has added are left out."""
        for action_id in action_ids:
            if action_id in self._rows:
                self._refresh(self._rows[action_id], self._actions[action_id])

    def _refresh(self, row: ActionRow, action: QAction) -> None:
        studio, was_possible = self._studio, action.isEnabled()
        action.setEnabled(row.enabled(studio))
        if row.checked is not None:
            action.setChecked(row.checked(studio))
        if row.says is not None:
            self._say(row, action)
        elif was_possible is not action.isEnabled() or (
            callable(row.enabled.first) and not action.isEnabled()
        ):
            self._tell_keys(row, action)

    def _say(self, row: ActionRow, action: QAction) -> None:
        action.setText(marked(self.text_of(row.id), self._letters.get(row.id, "")))
        self._tell_keys(row, action)
