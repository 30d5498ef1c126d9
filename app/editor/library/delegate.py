"""How a behavior looks in the library: color, name, badges, and on the right who uses it and its examples."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import (
    QAbstractItemModel,
    QEvent,
    QModelIndex,
    QPersistentModelIndex,
    QPoint,
    QRect,
    Qt,
    Signal,
)
from PySide6.QtGui import QColor, QFontMetrics, QHelpEvent, QMouseEvent, QPainter
from PySide6.QtWidgets import (
    QAbstractItemView,
    QLineEdit,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QToolTip,
    QWidget,
)

from ...core.amounts import counted
from ..theme import CAPTION, chosen_ground, hovered_ground, text_font
from .fits import Fit
from .model import FIT, ROW
from .survey import Row

if TYPE_CHECKING:
    from ..studio import Studio

Index = QModelIndex | QPersistentModelIndex
SWATCH, GAP, PAD = 10, 8, 7
USED_BY, USES, CONFLICTS, STALE = "used by", "uses", "conflicts", "stale"


@dataclass(frozen=True, slots=True)
class Badge:
    """A small fact.

    Attributes:
        color: Name of the palette's color of its text.
        boxed: Whether a line goes around it.
        part: What a click on it shows or mends; empty where a click means the row.
    """

    text: str
    tip: str
    color: str = "dim"
    boxed: bool = True
    part: str = ""


def badges(row: Row, fit: Fit | None) -> Iterator[Badge]:
    """The badges beside the name, the most urgent first."""
    if fit is not None and fit.stale:
        yield Badge("stale", "Changed since it was learned; click to learn it again", "accent", part=STALE)
    if fit is not None and fit.conflicts:
        tip = f"{fit.conflicts} examples contradict each other: equal features, another label; click to see them"
        yield Badge(f"{fit.conflicts} in conflict", tip, "accent", part=CONFLICTS)
    if fit is not None and fit.share is not None and fit.share < 1.0 and not fit.stale:
        yield Badge(f"fits {fit.share:.0%}", fit.words)
    if fit is not None and fit.problem:
        yield Badge("cannot be learned", fit.problem, "teach")
    if row.once:
        yield Badge("once", "Runs once, when its state is entered")
    for flag in row.raises if not row.is_automaton else ():
        yield Badge(f"raises {flag}", f"Raises the flag {flag!r} on the automaton that holds it")


def counts(row: Row) -> Iterator[Badge]:
    """The number of examples, at the right."""
    if row.examples or row.disabled:
        many = counted(row.examples, "example")
        yield Badge(f"{row.examples:,}", f"{many}, {row.disabled:,} disabled", boxed=False)


def links(row: Row) -> Iterator[Badge]:
    """From right to left: what the behavior uses, and who uses it."""
    if row.uses:
        names = ", ".join(use.words for use in row.uses[:8])
        yield Badge(f"↓{len(row.uses)}", f"Uses {names}: click to choose one", boxed=False, part=USES)
    if row.used_by:
        names = ", ".join(use.words for use in row.used_by[:8])
        tip = f"Used by {names}: click to choose one"
        yield Badge(f"↑{len(row.used_by)}", tip, boxed=False, part=USED_BY)


@dataclass(frozen=True, slots=True)
class Placed:
    """A badge at its place."""

    badge: Badge
    rect: QRect


def layout(row: Row, fit: Fit | None, rect: QRect) -> tuple[QRect, list[Placed]]:
    """Where the name stands, and the badges for which there is room; the name goes first."""
    metrics = QFontMetrics(text_font())
    small = QFontMetrics(text_font(CAPTION))
    left = rect.left() + SWATCH + 2 * GAP
    name = metrics.horizontalAdvance(row.shown) + 4
    at, end, placed = left + name + GAP, rect.right() - GAP, list[Placed]()
    for badge in (*counts(row), *badges(row, fit), *links(row)):
        width = small.horizontalAdvance(badge.text) + (2 * PAD if badge.boxed else 0)
        if at + width > end:
            continue
        if badge.boxed:
            placed.append(Placed(badge, _slot(rect, at, width)))
            at += width + 4
        else:
            placed.append(Placed(badge, _slot(rect, end - width, width)))
            end -= width + GAP
    return QRect(left, rect.top(), max(24, min(name, end - left)), rect.height()), placed


def _slot(rect: QRect, left: int, width: int) -> QRect:
    return QRect(left, rect.top() + (rect.height() - 18) // 2, width, 18)


class BehaviorDelegate(QStyledItemDelegate):
    """Paints the rows of the library.

    Signals:
        linked: A badge that shows something was clicked: its row, its part, and where.
    """

    linked = Signal(object, str, QPoint)

    def __init__(self, studio: Studio, view: QAbstractItemView) -> None:
        super().__init__(view)
        self._studio = studio
        self._view = view

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        """A group's title, or a behavior."""
        row = index.data(ROW)
        painter.save()
        if row is None:
            self._paint_group(painter, option.rect, str(index.data()))
        else:
            selected = bool(option.state & QStyle.StateFlag.State_Selected)
            hovered = bool(option.state & QStyle.StateFlag.State_MouseOver)
            self._paint_row(painter, option.rect, row, index.data(FIT), selected=selected, hovered=hovered)
        painter.restore()

    def _paint_group(self, painter: QPainter, rect: QRect, title: str) -> None:
        painter.setFont(text_font(CAPTION))
        painter.setPen(self._studio.theme.color("dim"))
        painter.drawText(rect.adjusted(2, 0, 0, 0), Qt.AlignmentFlag.AlignVCenter, title)

    def _paint_row(
        self, painter: QPainter, rect: QRect, row: Row, fit: Fit | None, *, selected: bool, hovered: bool
    ) -> None:
        colors = self._studio.theme.palette
        whole = QRect(0, rect.top(), self._view.viewport().width(), rect.height())
        if selected or hovered:
            painter.fillRect(whole, chosen_ground(colors) if selected else hovered_ground(colors))
        self._paint_swatch(painter, rect, self._studio.colors.color(row.key.type, row.key.id))
        name, placed = layout(row, fit, rect)
        painter.setFont(text_font())
        painter.setPen(QColor(colors.text))
        elided = painter.fontMetrics().elidedText(row.shown, Qt.TextElideMode.ElideRight, name.width())
        painter.drawText(name, Qt.AlignmentFlag.AlignVCenter, elided)
        painter.setFont(text_font(CAPTION))
        for each in placed:
            self._paint_badge(painter, each, selected=selected)

    def _paint_swatch(self, painter: QPainter, rect: QRect, color: QColor) -> None:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(color)
        top = rect.top() + (rect.height() - SWATCH) // 2
        painter.drawRoundedRect(QRect(rect.left() + GAP // 2, top, SWATCH, SWATCH), 3, 3)
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def _paint_badge(self, painter: QPainter, placed: Placed, *, selected: bool) -> None:
        theme = self._studio.theme
        if placed.badge.boxed:
            line = "hairline" if placed.badge.color == "dim" else placed.badge.color
            painter.setPen(theme.color(line))
            painter.drawRoundedRect(placed.rect.adjusted(0, 0, -1, -1), 9, 9)
        urgent = placed.badge.color != "dim"
        painter.setPen(theme.color("text" if selected and urgent else placed.badge.color))
        painter.drawText(placed.rect, Qt.AlignmentFlag.AlignCenter, placed.badge.text)

    # -------------------------------------------------------------------------------------- mouse, editing

    def editorEvent(
        self, event: QEvent, model: QAbstractItemModel, option: QStyleOptionViewItem, index: Index
    ) -> bool:
        """A click on a badge shows what it counts."""
        if isinstance(event, QMouseEvent) and event.type() == QEvent.Type.MouseButtonRelease:
            found = self._at(event.position().toPoint(), option.rect, index)
            if found is not None and found.badge.part:
                spot = self._view.viewport().mapToGlobal(found.rect.bottomLeft())
                self.linked.emit(index.data(ROW), found.badge.part, spot)
                return True
        return super().editorEvent(event, model, option, index)

    def _at(self, spot: QPoint, rect: QRect, index: Index) -> Placed | None:
        row = index.data(ROW)
        if row is None:
            return None
        _, placed = layout(row, index.data(FIT), rect)
        return next((each for each in placed if each.rect.contains(spot)), None)

    def helpEvent(
        self, event: QHelpEvent, view: QAbstractItemView, option: QStyleOptionViewItem, index: Index
    ) -> bool:
        """A badge says what it means."""
        found = self._at(event.pos(), option.rect, index) if index.isValid() else None
        if found is None:
            return super().helpEvent(event, view, option, index)
        QToolTip.showText(event.globalPos(), found.badge.tip, view)
        return True

    def createEditor(self, parent: QWidget, _option: QStyleOptionViewItem, _index: Index) -> QWidget:
        """A field for the name."""
        editor = QLineEdit(parent)
        editor.setAccessibleName("Name of the behavior")
        return editor

    def setEditorData(self, editor: QWidget, index: Index) -> None:
        """The name at first; what is typed later stays, though facts of the row change meanwhile."""
        if isinstance(editor, QLineEdit) and not editor.property("filled"):
            editor.setProperty("filled", True)
            editor.setText(str(index.data(Qt.ItemDataRole.EditRole)))

    def updateEditorGeometry(self, editor: QWidget, option: QStyleOptionViewItem, _index: Index) -> None:
        """From the name to the end of the row."""
        left = option.rect.left() + SWATCH + 2 * GAP - 9
        editor.setGeometry(
            left, option.rect.top(), self._view.viewport().width() - left - 4, option.rect.height()
        )
