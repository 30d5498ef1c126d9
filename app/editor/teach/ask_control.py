"""The tool bar's "Ask me below 60%": a switch, the probability, and how far from all examples."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QDoubleSpinBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QMenu,
    QSpinBox,
    QToolButton,
    QWidget,
    QWidgetAction,
)

from ..forms.buttons import opens
from ..number_box import roomy
from .asking import BELOW, BEYOND

if TYPE_CHECKING:
    from ..studio import Studio


class AskControl(QWidget):
    """When to ask."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._asking = studio.teaching.asking
        self.switch = QToolButton()
        self.switch.setDefaultAction(studio.actions["teach.ask"])
        self.switch.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
        self.below = roomy(QSpinBox(minimum=1, maximum=100, suffix="%", value=round(100 * BELOW)))
        self.below.setPrefix("below ")
        self.below.setFixedWidth(112)
        self.below.setToolTip("Ask where the most probable next state is less probable than this")
        self.below.setAccessibleName("Ask below this probability")
        self.more = QToolButton()
        self.more.setText("⋯")
        self.more.setToolTip("What to ask about: how sure, and how far from all examples")
        self.more.setAccessibleName("What to ask about")
        self.more.setProperty("flat", "true")
        self.more.setStyleSheet("QToolButton::menu-indicator { image: none; }")
        opens(self.more, self._menu())
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        for widget in (self.switch, self.below, self.more):
            layout.addWidget(widget)
        self.below.valueChanged.connect(self._changed)
        self._asking.changed.connect(self.refresh)
        studio.changed.connect(self.refresh)
        studio.opened.connect(self._begin)
        self.refresh()

    def _menu(self) -> QMenu:
        menu, page = QMenu(self), QWidget()
        self.unsure = QCheckBox("when it is not sure")
        self.unsure.setToolTip("Ask below the probability in the tool bar")
        self.unsure.setChecked(True)
        self.unknown = QCheckBox("farther from all examples than")
        self.unknown.setToolTip("Ask where what it sees is like no example of the state that it is in")
        self.beyond = roomy(QDoubleSpinBox(minimum=0.01, maximum=10.0, singleStep=0.05, value=BEYOND))
        self.beyond.setAccessibleName("Ask beyond this distance from all examples")
        self.beyond.setToolTip("1 is as far apart as the examples are in one feature")
        grid = QGridLayout(page)
        caption = QLabel("Ask before a selected node goes on")
        caption.setProperty("role", "caption")
        grid.addWidget(caption, 0, 0, 1, 2)
        grid.addWidget(self.unsure, 1, 0, 1, 2)
        grid.addWidget(self.unknown, 2, 0)
        grid.addWidget(self.beyond, 2, 1)
        for box in (self.unsure, self.unknown):
            box.toggled.connect(self._changed)
        self.beyond.valueChanged.connect(self._changed)
        action = QWidgetAction(menu)
        action.setDefaultWidget(page)
        menu.addAction(action)
        return menu

    def _changed(self) -> None:
        below = self.below.value() / 100 if self.unsure.isChecked() else None
        beyond = self.beyond.value() if self.unknown.isChecked() else None
        self._asking.set(on=self._asking.on, below=below, beyond=beyond)

    def _begin(self) -> None:
        """Another project is open: what was set for the one before is not offered in it."""
        with QSignalBlocker(self.below), QSignalBlocker(self.beyond):
            self.below.setValue(round(100 * BELOW))
            self.beyond.setValue(BEYOND)
        self.refresh()

    def refresh(self) -> None:
        """Show how it is set."""
        asking = self._asking
        for widget in (self.below, self.beyond, self.unsure, self.unknown):
            widget.blockSignals(True)
        self.unsure.setChecked(asking.below is not None)
        self.unknown.setChecked(asking.beyond is not None)
        if asking.below is not None:
            self.below.setValue(round(100 * asking.below))
        if asking.beyond is not None:
            self.beyond.setValue(asking.beyond)
        for widget in (self.below, self.beyond, self.unsure, self.unknown):
            widget.blockSignals(False)
        self.below.setEnabled(asking.on and asking.below is not None)
        self.beyond.setEnabled(asking.beyond is not None)
