"""The Tab key in forms whose parts come and go: Qt appends what is made later to the end of the window."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractSpinBox, QComboBox, QWidget


def tab_through(form: QWidget, parts: Iterable[QWidget]) -> None:
    """Let Tab go through *parts* of a form in this order, from what comes before the form on."""
    before = _field_before(form)
    if before is None:
        return
    for part in parts:
        for field in _fields(part):
            QWidget.setTabOrder(before, field)
            before = field


def _field_before(form: QWidget) -> QWidget | None:
    """What Tab comes from; None where nothing else in the window takes keys."""
    before = form.previousInFocusChain()
    while before is not None and before is not form:
        if _is_field(before) and not form.isAncestorOf(before):
            return before
        before = before.previousInFocusChain()
    return None


def _fields(part: QWidget) -> Iterator[QWidget]:
    """What takes keys in a part, in the order in which it was put in; what pops up is a window by itself."""
    inside = (child for child in part.findChildren(QWidget) if child.window() is part.window())
    yield from (field for field in (part, *inside) if _is_field(field))


def _is_field(widget: QWidget) -> bool:
    """Whether Tab stops here; boxes are one field, whatever they consist of."""
    tabbed = bool(widget.focusPolicy() & Qt.FocusPolicy.TabFocus) and widget.focusProxy() is None
    above = widget.parentWidget()
    return tabbed and not widget.isWindow() and not isinstance(above, QAbstractSpinBox | QComboBox)
