"""What each parameter means: from a menu, or by a click in the world."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QCursor
from PySide6.QtWidgets import QHBoxLayout, QLabel, QMenu, QToolButton, QWidget

from ...core.features import Binding, Ground
from ..forms.buttons import opens
from ..icons import icon
from ..letters import plain

if TYPE_CHECKING:
    from ..studio import Studio
    from .choosing import Choosing

#: Pixels of a parameter's name; a longer one would make the window wider.
LONGEST = 72


class TargetRow(QWidget):
    """A line of slots: "X is [nearest visible box]  or click it"."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._choosing: Choosing = studio.teaching.choosing
        self._layout = QHBoxLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._layout.setSpacing(6)
        self._shown: tuple[object, ...] = ()
        self._asks = False
        self.menus: dict[str, QToolButton] = {}
        self.clicks: dict[str, QToolButton] = {}
        self.cancel: QToolButton | None = None
        self._choosing.changed.connect(self.refresh)
        self._choosing.several.connect(self._offer)
        studio.teaching.choose_requested.connect(self._ask)
        studio.teaching.changed.connect(self.refresh)
        studio.document.project_changed.connect(self.refresh)
        studio.opened.connect(self.refresh)
        studio.selection.behavior_changed.connect(self.refresh)
        studio.theme.changed.connect(self._rebuild)
        self.refresh()

    def _ask(self) -> None:
        """What a slot is to be is asked for: by keys as well, once the row shows it."""
        self._asks = True

    def refresh(self) -> None:
        """Show the slots that there are, if they are others now."""
        choosing = self._choosing
        name = "" if choosing.adding is None else choosing.adding.name
        slots = tuple((slot, choosing.bound(slot)) for slot in choosing.slots)
        shown = (name, tuple((slot, _words(b)) for slot, b in slots), choosing.wanted)
        if shown != self._shown:
            self._shown = shown
            self._rebuild()
        if self._asks and choosing.wanted:
            self.menus[choosing.wanted].setFocus(Qt.FocusReason.TabFocusReason)  # Enter opens the list
            self._asks = False

    def _rebuild(self) -> None:
        had_keys = self.window().focusWidget() in self.findChildren(QWidget)  # also while a menu has them
        self._build()
        if had_keys:
            self.window().setFocus()  # rather than a field, which would take keys that are shortcuts

    def _build(self) -> None:
        while (item := self._layout.takeAt(0)) is not None:
            widget = item.widget()
            if widget is not None:
                widget.hide()
                widget.deleteLater()
        self.menus, self.clicks, self.cancel = {}, {}, None
        choosing = self._choosing
        if choosing.adding is not None:
            self._layout.addWidget(_cut(QLabel(), f"New state {choosing.adding.name}", ":", 2 * LONGEST))
        for slot in choosing.slots:
            self._add_slot(slot)
        if choosing.is_busy:
            self.cancel = self._flat("Cancel", "Choose nothing (Esc)")
            self.cancel.clicked.connect(choosing.cancel)
            self._layout.addWidget(self.cancel)
        self.setVisible(bool(choosing.slots))

    def _add_slot(self, slot: str) -> None:
        caption = QLabel()
        caption.setProperty("role", "caption")
        self._layout.addWidget(_cut(caption, slot, " is", LONGEST))
        bound = self._choosing.bound(slot)
        button = QToolButton()
        button.setText(plain(_words(bound)) or "choose…")
        button.setAccessibleName(f"What {slot} is")
        button.setToolTip(f"Choose what {slot} is from all targets")
        menu = QMenu(button)
        menu.setToolTipsVisible(True)
        menu.aboutToShow.connect(lambda: self._fill(menu, slot))
        opens(button, menu)
        self.menus[slot] = button
        self._layout.addWidget(button)
        if self._choosing.wanted == slot:
            now = QLabel("or click it now…")
            now.setProperty("role", "caption")
            self._layout.addWidget(now)
            return
        # Several stand beside each other, in few words.
        told = "or click it" if len(self._choosing.slots) == 1 and bound is None else ""
        click = self._flat(told, f"Choose what {slot} is by a click on it")
        click.setAccessibleName(f"Click what {slot} is")
        click.setIcon(icon("crosshairs-gps", self._studio.theme, "dim"))
        click.clicked.connect(lambda: self._choosing.ask_for(slot))
        self.clicks[slot] = click
        self._layout.addWidget(click)

    def _flat(self, text: str, tip: str) -> QToolButton:
        button = QToolButton()
        button.setText(text)
        button.setToolTip(tip)
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        button.setProperty("flat", "true")
        return button

    def _fill(self, menu: QMenu, slot: str) -> None:
        menu.clear()
        for binding in self._choosing.options():
            menu.addAction(self._option(menu, slot, binding))

    def _option(self, menu: QMenu, slot: str, binding: Binding) -> QAction:
        words = _words(binding)
        action = QAction(plain(words), menu)
        action.setObjectName(words)
        snapshot, meanings = self._studio.snapshot, self._choosing.meanings()
        if isinstance(binding, Ground) and snapshot is not None and binding.target in meanings:
            entity = meanings[binding.target]
            now = "none now" if entity < 0 else snapshot.place.entity_called(entity)
            action.setText(plain(words if now == words else f"{words}   ({now})"))
        if isinstance(binding, Ground) and self._studio.teaching.key is not None:
            vocabulary = self._studio.document.vocabulary(self._studio.teaching.key.type)
            action.setToolTip(vocabulary.targets[binding.target].doc)
        action.setCheckable(True)
        action.setChecked(binding == self._choosing.bound(slot))
        action.triggered.connect(lambda: self._choosing.bind(slot, binding))
        return action

    def _offer(self, slot: str, names: tuple[str, ...]) -> None:
        """A click means several targets: which of them?"""
        menu = QMenu(self)
        for name in names:
            menu.addAction(self._option(menu, slot, Ground(name)))
        menu.aboutToHide.connect(menu.deleteLater)
        menu.popup(QCursor.pos())


def _words(binding: Binding | None) -> str:
    if binding is None:
        return ""
    return binding.target if isinstance(binding, Ground) else f"{binding.name} (its own parameter)"


def _cut(label: QLabel, name: str, after: str, room: int) -> QLabel:
    """Say a name with no more than so many pixels of it; all of it is in the tool tip."""
    label.ensurePolished()
    label.setText(label.fontMetrics().elidedText(name, Qt.TextElideMode.ElideRight, room) + after)
    label.setToolTip(name)
    return label
