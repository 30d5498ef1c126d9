"""What stands below the tree, one thing at a time: the histogram with its cut, the prunes, the pruning confidence."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QSizePolicy,
    QStackedWidget,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ..escape import takes_escape
from .confidence_page import ConfidencePage
from .cut_page import CutPage
from .prune_page import PrunePage

if TYPE_CHECKING:
    from ..studio import Studio

HEIGHT = 112


class Tools(QWidget):
    """Buttons that each open a page, or close it again.

    Attributes:
        cut, prunes, confidence: The pages.
        buttons: By the names of the pages.

    Signals:
        opened: Another page is open, or none.
    """

    opened = Signal()

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self.cut = CutPage(studio.theme)
        self.prunes = PrunePage(studio)
        self.confidence = ConfidencePage()
        self._stack = QStackedWidget()
        self._stack.setFixedHeight(HEIGHT)
        self._stack.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self._stack.hide()
        self.buttons: dict[str, QToolButton] = {}
        row = QHBoxLayout()
        row.setContentsMargins(8, 2, 8, 2)
        row.setSpacing(4)
        for name, text, tip, page in (
            ("cut", "Histogram", "The examples at the selected node, and the cut of its test", self.cut),
            ("prunes", "Prunes", "All prunes and moved cuts, and taking them back", self.prunes),
            ("confidence", "Confidence", "How strongly trees are pruned after learning", self.confidence),
        ):
            button = QToolButton()
            button.setText(text)
            button.setCheckable(True)
            button.setToolTip(tip)
            button.setAccessibleName(text)
            button.clicked.connect(lambda _checked, name=name: self.toggle(name))
            self._stack.addWidget(page)
            self.buttons[name] = button
            row.addWidget(button)
        row.addStretch(1)
        line = QFrame()
        line.setProperty("role", "hairline")
        line.setFixedHeight(1)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(line)
        column.addWidget(self._stack)
        column.addLayout(row)  # at the bottom, so that buttons stay under the mouse whatever is open

    @property
    def page(self) -> str:
        """The page that is open; empty if none is."""
        names = list(self.buttons)
        return names[self._stack.currentIndex()] if self._stack.isVisibleTo(self) else ""

    def toggle(self, name: str) -> None:
        """Open a page, or close it if it is open."""
        self.open("" if self.page == name else name)

    def open(self, name: str) -> None:
        """Open a page, which gets the keys; none for an empty name."""
        had_keys, above = self._stack.isAncestorOf(self.window().focusWidget()), self.parentWidget()
        self._stack.setVisible(bool(name))
        if name:
            self._stack.setCurrentIndex(list(self.buttons).index(name))
        for other, button in self.buttons.items():
            button.setChecked(other == name)
        page = self._stack.currentWidget() if name else above if had_keys else None
        if page is not None:
            page.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.opened.emit()

    def count_prunes(self) -> None:
        """Say on its button how many prunes there are."""
        many = self.prunes.count
        self.buttons["prunes"].setText(f"Prunes {many}" if many else "Prunes")

    def event(self, event: QEvent) -> bool:
        """Escape closes the page."""
        closes = bool(self.page) and takes_escape(event, lambda: self.open(""))
        return closes or super().event(event)
