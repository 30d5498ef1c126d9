"""The line below the buttons of a lesson, which says less where there is less room."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QToolButton, QWidget

from .told import Told

#: What is told is left so many pixels before anything else is said in full.
TOLD = 130
GAP = 8
ICON, WORDS = Qt.ToolButtonStyle.ToolButtonIconOnly, Qt.ToolButtonStyle.ToolButtonTextBesideIcon


class LessonRow(QWidget):
    """Whose turn it is, what slots mean, what was recorded, and how often.

    Attributes:
        badge: How much was recorded, in full or in short.
    """

    def __init__(
        self,
        turn: QLabel,
        step: QToolButton,
        targets: QWidget,
        last: Told,
        mend: QToolButton,
        options: QToolButton,
    ) -> None:
        super().__init__()
        self.badge = QLabel()
        self.badge.setObjectName("badge")
        self._in_full, self._in_short = "", ""
        self._last = last
        self._buttons = mend, step
        self._widths: dict[tuple[QToolButton, str], tuple[int, int]] = {}
        self._order = turn, step, targets, last, mend, self.badge, options
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(GAP)
        layout.setSizeConstraint(QHBoxLayout.SizeConstraint.SetNoConstraint)
        for widget in self._order:
            layout.addWidget(widget, 1 if widget is last else 0)

    def count(self, in_full: str, in_short: str, tip: str) -> None:
        """Say how much was recorded, and in the tool tip what else there is to say of it."""
        self._in_full, self._in_short = in_full, in_short
        self.badge.setToolTip(tip)
        self.fit()

    def minimumSizeHint(self) -> QSize:
        """What it takes where all is said in short and nothing is told."""
        return QSize(self._needed(), super().minimumSizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Say what there is room for now."""
        super().resizeEvent(event)
        self.fit()

    def event(self, event: QEvent) -> bool:
        """Something in it takes another width."""
        if event.type() == QEvent.Type.LayoutRequest:
            self.fit()
        return super().event(event)

    def fit(self) -> None:
        """Say as much in full as there is room for, what matters most first."""
        spare = self.width() - self._needed() - TOLD
        for button in self._shown_buttons():
            icon, words = self._widths_of(button)
            fits = words - icon <= spare
            spare -= words - icon if fits else 0
            button.setToolButtonStyle(WORDS if fits else ICON)
        more = self._badge_width(self._in_full) - self._badge_width(self._in_short)
        self.badge.setText(self._in_full if more <= spare else self._in_short)

    # ------------------------------------------------------------------------------------------- inside

    def _shown_buttons(self) -> list[QToolButton]:
        return [button for button in self._buttons if button.isVisibleTo(self)]

    def _needed(self) -> int:
        """What it takes where all is said in short and nothing is told."""
        shown = [widget for widget in self._order if widget.isVisibleTo(self)]
        return sum(self._least(widget) for widget in shown) + GAP * (len(shown) - 1)

    def _least(self, widget: QWidget) -> int:
        if widget is self._last:
            return 0
        if widget is self.badge:
            return self._badge_width(self._in_short)
        if isinstance(widget, QToolButton) and widget in self._buttons:
            return self._widths_of(widget)[0]
        return max(widget.sizeHint().width(), widget.minimumWidth())

    def _badge_width(self, text: str) -> int:
        """What surrounds the words is the same whatever they are."""
        metrics = self.badge.fontMetrics()
        around = self.badge.sizeHint().width() - metrics.horizontalAdvance(self.badge.text())
        return around + metrics.horizontalAdvance(text)

    def _widths_of(self, button: QToolButton) -> tuple[int, int]:
        """What a button takes with its icon alone, and with its words; measured once, as measuring asks for another layout."""
        what = button, button.text()
        if what not in self._widths:
            button.ensurePolished()
            hints = []
            for style in (ICON, WORDS):
                button.setToolButtonStyle(style)
                hints.append(button.sizeHint().width())
            self._widths[what] = hints[0], hints[1]
        return self._widths[what]
