"""How an entry of the command palette looks: its name with the letters found, what it is, and its keys."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRect, QSize, Qt
from PySide6.QtGui import QFontMetrics, QPainter
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem, QWidget

from ..theme import CAPTION, Theme, chosen_ground, text_font
from .matching import places

if TYPE_CHECKING:
    from .palette import EntryModel

HEIGHT, MARGIN, KIND = 32, 12, 84


class EntryDelegate(QStyledItemDelegate):
    """Paints entries.

    Attributes:
        height: Pixels that one takes.
    """

    height = HEIGHT

    def __init__(self, theme: Theme, model: EntryModel, parent: QWidget) -> None:
        super().__init__(parent)
        self._theme = theme
        self._model = model

    def sizeHint(
        self,
        option: QStyleOptionViewItem,  # noqa: ARG002 - Qt gives it
        index: QModelIndex | QPersistentModelIndex,  # noqa: ARG002 - as above
    ) -> QSize:
        """All are equally high."""
        return QSize(100, HEIGHT)

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        """Name, detail, keys, kind from left to right."""
        entry = self._model.entries[index.row()]
        rect: QRect = option.rect
        state: QStyle.StateFlag = option.state
        theme = self._theme
        if state & QStyle.StateFlag.State_Selected:
            painter.save()
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(chosen_ground(theme.palette))
            painter.drawRoundedRect(rect.adjusted(0, 1, 0, -1), 6, 6)
            painter.restore()
        right = rect.right() - MARGIN
        right = self._caption(painter, rect, right, entry.kind, least=KIND)
        if entry.keys:
            right = self._keys(painter, rect, right, entry.keys)
        usable = bool(index.flags() & Qt.ItemFlag.ItemIsEnabled)
        left = self._name(painter, rect, entry.text, usable=usable)
        room = QRect(left + 10, rect.top(), max(0, right - left - 20), rect.height())
        painter.setFont(text_font(CAPTION))
        painter.setPen(theme.color("dim"))
        metrics = QFontMetrics(painter.font())
        detail = metrics.elidedText(entry.detail, Qt.TextElideMode.ElideRight, room.width())
        painter.drawText(room, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft, detail)

    def _caption(self, painter: QPainter, rect: QRect, right: int, text: str, least: int = 0) -> int:
        painter.setFont(text_font(CAPTION))
        painter.setPen(self._theme.color("dim"))
        width = max(least, QFontMetrics(painter.font()).horizontalAdvance(text))
        room = QRect(right - width, rect.top(), width, rect.height())
        painter.drawText(room, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignRight, text)
        return right - width - 8

    def _keys(self, painter: QPainter, rect: QRect, right: int, keys: str) -> int:
        painter.setFont(text_font(CAPTION))
        width = QFontMetrics(painter.font()).horizontalAdvance(keys) + 12
        box = QRect(right - width, rect.center().y() - 9, width, 19)
        painter.setPen(self._theme.color("hairline"))
        painter.setBrush(self._theme.color("raised"))
        painter.drawRoundedRect(box, 5, 5)
        painter.setPen(self._theme.color("dim"))
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, keys)
        return right - width - 8

    def _name(self, painter: QPainter, rect: QRect, text: str, *, usable: bool) -> int:
        """The name, what was typed in the accent color; where it ends."""
        found = set(places(self._model.words, text))
        left = rect.left() + MARGIN
        base, bold = text_font(), text_font(bold=True)
        for at, letter in enumerate(text):
            lit = at in found
            painter.setFont(bold if lit else base)
            painter.setPen(self._theme.color("accent" if lit else "text" if usable else "dim"))
            width = painter.fontMetrics().horizontalAdvance(letter)
            painter.drawText(
                QRect(left, rect.top(), width + 2, rect.height()),
                Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft,
                letter,
            )
            left += width
        return left
