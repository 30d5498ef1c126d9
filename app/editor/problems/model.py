"""The problems as Qt's table: what, where, and what can be done."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt

from ..icons import icon
from .findings import Finding

if TYPE_CHECKING:
    from ..theme import Theme

HEADERS = ("Problem", "Where", "Fix")
WHAT, PLACE, FIX = range(3)
Index = QModelIndex | QPersistentModelIndex


class ProblemsModel(QAbstractTableModel):
    """The findings, one a row."""

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self.findings: tuple[Finding, ...] = ()
        theme.changed.connect(self._dress)

    def show(self, findings: tuple[Finding, ...]) -> None:
        """List these."""
        if findings != self.findings:
            self.beginResetModel()
            self.findings = findings
            self.endResetModel()

    def finding(self, index: Index) -> Finding | None:
        """The problem of a row."""
        return self.findings[index.row()] if index.isValid() else None

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - an immutable value
        """How many there are."""
        return 0 if parent.isValid() else len(self.findings)

    def columnCount(self, _parent: Index = QModelIndex()) -> int:  # noqa: B008 - as above
        """What, where, fix."""
        return len(HEADERS)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """The titles."""
        if orientation is Qt.Orientation.Horizontal and role == Qt.ItemDataRole.DisplayRole:
            return HEADERS[section]
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Words, icon and color of a problem."""
        finding = self.finding(index)
        if finding is None:
            return None
        column = index.column()
        match role:
            case Qt.ItemDataRole.DisplayRole:
                message = finding.problem.message
                return (message[:1].upper() + message[1:], finding.place, finding.fix_words)[column]
            case Qt.ItemDataRole.ToolTipRole:
                return _tip(finding, column)
            case Qt.ItemDataRole.AccessibleTextRole:
                kind = "Error" if finding.is_error else "Warning"
                return f"{kind}: {finding.problem.message}" if column == WHAT else None
            case Qt.ItemDataRole.DecorationRole if column == WHAT:
                name, color = (
                    ("alert-circle-outline", "teach") if finding.is_error else ("alert-outline", "accent")
                )
                return icon(name, self._theme, color)
            case Qt.ItemDataRole.ForegroundRole if column != WHAT:
                return self._theme.color("accent" if column == FIX else "dim")
        return None

    def _dress(self) -> None:
        if self.findings:
            last = self.index(len(self.findings) - 1, len(HEADERS) - 1)
            self.dataChanged.emit(self.index(0, 0), last)


def _tip(finding: Finding, column: int) -> str:
    if column == FIX:
        ways = [fix.text for fix in finding.fixes]
        return "Click or Ctrl+Enter: " + ", or ".join(ways) if ways else finding.fix_words
    return f"{finding.problem}\nDouble click or Enter shows the place"
