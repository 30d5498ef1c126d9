"""Buttons in rows: those that must be there, and as many of those that may be there as there is room for."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from functools import lru_cache
from itertools import pairwise

from PySide6.QtCore import QRect, QSize, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QScrollArea, QSizePolicy, QWidget

GAP = 6
#: So many rows are shown; the others are scrolled to.
MOST_ROWS, ROW = 3, 40
#: What may be there makes no more rows than these.
EXTRA_ROWS = 2
#: Width and height of a button, and whether it must be there; left, top, width and height.
Button = tuple[int, int, bool]
Rect = tuple[int, int, int, int]


class ButtonFlow(QWidget):
    """Places widgets from left to right, in as many rows as it takes.

    Signals:
        arranged: They may take another height.
    """

    arranged = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._order: tuple[QWidget, ...] = ()
        self._needed: frozenset[QWidget] = frozenset()
        self._arranged: object = None
        policy = QSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)

    def hold(self, order: Sequence[QWidget], extra: Collection[QWidget] = ()) -> None:
        """Hold these in this order; of *extra* among them, as many of the first as there is room for."""
        self._order, self._needed = tuple(order), frozenset(order) - frozenset(extra)
        for widget in order:
            widget.setParent(self)
        for before, after in pairwise(order):
            QWidget.setTabOrder(before, after)
        self._arranged = None
        self.arrange()

    def arrange(self) -> None:
        """Place all anew if their sizes, or the width that they have, have changed."""
        arranged = self.width(), self._order, [widget.sizeHint() for widget in self._order]
        if arranged == self._arranged:
            return
        self._arranged = arranged
        self._place()
        self.updateGeometry()
        self.arranged.emit()

    def hasHeightForWidth(self) -> bool:
        """Narrower is higher."""
        return True

    def heightForWidth(self, width: int) -> int:
        """The rows that it takes."""
        placed = self._placed(width)
        return max((rect.bottom() + 1 for rect in placed.values()), default=0)

    def sizeHint(self) -> QSize:
        """One row, if there is room."""
        return QSize(400, self.heightForWidth(self.width() or 400))

    def minimumSizeHint(self) -> QSize:
        """The widest button, and the rows as it is now."""
        widest = max((widget.sizeHint().width() for widget in self._needed), default=0)
        return QSize(widest, self.heightForWidth(max(self.width(), widest)))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Place all anew."""
        super().resizeEvent(event)
        self.arrange()

    def _place(self) -> None:
        placed = self._placed(self.width())
        for widget in self._order:
            if widget in placed:
                widget.setGeometry(placed[widget])
            widget.setVisible(widget in placed)

    def _placed(self, width: int) -> dict[QWidget, QRect]:
        sizes = (widget.sizeHint().expandedTo(widget.minimumSize()) for widget in self._order)
        buttons = tuple(
            (*size.toTuple(), widget in self._needed) for size, widget in zip(sizes, self._order, strict=True)
        )
        rects = rows_of(buttons, width)
        return {widget: QRect(*rect) for widget, rect in zip(self._order, rects, strict=True) if rect}


@lru_cache(maxsize=64)  # layouts ask again and again
def rows_of(buttons: tuple[Button, ...], width: int) -> tuple[Rect | None, ...]:
    """Where buttons are in rows of a width; None for what there is no room for."""
    needed = frozenset(k for k, (*_, is_needed) in enumerate(buttons) if is_needed)
    lowest = max(_top_of_last(buttons, needed, width), (EXTRA_ROWS - 1) * (ROW + GAP))
    shown = set(needed)
    for k in range(len(buttons)):
        if k not in shown:
            if _top_of_last(buttons, {*shown, k}, width) > lowest:
                break
            shown.add(k)
    return _in_rows(buttons, shown, width)


def _top_of_last(buttons: Sequence[Button], shown: Collection[int], width: int) -> int:
    """The top of the lowest row that these take."""
    return max((rect[1] for rect in _in_rows(buttons, shown, width) if rect), default=0)


def _in_rows(buttons: Sequence[Button], shown: Collection[int], width: int) -> tuple[Rect | None, ...]:
    found: list[Rect | None] = []
    x = y = row = 0
    for k, (wide, high, _) in enumerate(buttons):
        if k not in shown:
            found.append(None)
            continue
        if x and x + wide > width:
            x, y, row = 0, y + row + GAP, 0
        found.append((x, y, wide, high))
        x, row = x + wide + GAP, max(row, high)
    return tuple(found)


class Rows(QScrollArea):
    """As high as its rows of buttons, up to some; more are scrolled to."""

    def __init__(self, flow: ButtonFlow) -> None:
        super().__init__()
        self._flow = flow
        self.setWidget(flow)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.viewport().setAutoFillBackground(False)
        flow.setAutoFillBackground(False)
        self.setStyleSheet("QScrollArea { background: transparent; }")
        flow.arranged.connect(self.fit)
        self.fit()

    def fit(self) -> None:
        """Take the height that the rows need."""
        needed = self._flow.heightForWidth(max(1, self._flow.width()))
        self.setFixedHeight(min(max(needed, ROW), MOST_ROWS * (ROW + GAP) - GAP))
