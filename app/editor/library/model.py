"""The library as Qt's tree: groups, and behaviors below them. What changes is told row by row, never as a whole."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from operator import is_
from typing import Any

from PySide6.QtCore import QAbstractItemModel, QMimeData, QModelIndex, QPersistentModelIndex, QSize, Qt

from ...core.amounts import counted
from ...learner.trainer import Key
from ..row_spans import spans
from .fits import Fit, Fits
from .order import moves
from .survey import Group, Kind, Row, RowKey

#: What a dragged behavior is: JSON with ``type``, ``id`` (empty for a basic one) and ``name``.
MIME = "application/x-understudy-behavior"
#: The `Row` of an index; None for a group.
ROW = int(Qt.ItemDataRole.UserRole)
#: The `Fit` of an index, as far as it is known.
FIT = ROW + 1

HEIGHT, GROUP_HEIGHT = 26, 28
#: Flags of rows; Qt asks for them again and again.
_BASIC = (
    Qt.ItemFlag.ItemIsEnabled
    | Qt.ItemFlag.ItemIsSelectable
    | Qt.ItemFlag.ItemIsDragEnabled
    | Qt.ItemFlag.ItemNeverHasChildren
)
_AUTOMATON = _BASIC | Qt.ItemFlag.ItemIsEditable
Index = QModelIndex | QPersistentModelIndex


@dataclass(slots=True)
class _Branch:
    """A group with a number that stays its own."""

    number: int
    group: Group
    rows: list[Row] = field(default_factory=list)

    @property
    def key(self) -> tuple[str, Kind]:
        return self.group.type, self.group.kind


class LibraryModel(QAbstractItemModel):
    """The groups of a survey.

    Args:
        rename: Gives an automaton another name; whether that was possible.
    """

    def __init__(self, fits: Fits, rename: Callable[[RowKey, str], bool]) -> None:
        super().__init__()
        self._fits = fits
        self._rename = rename
        self._branches: list[_Branch] = []
        self._numbers = 0
        self._row_data: Mapping[int, Callable[[Row], Any]] = {
            Qt.ItemDataRole.DisplayRole: lambda row: row.shown,
            Qt.ItemDataRole.EditRole: lambda row: row.name,
            Qt.ItemDataRole.ToolTipRole: self._tip,
            Qt.ItemDataRole.AccessibleTextRole: lambda row: ", ".join(
                (row.shown, *facts(row, self.fit(row)))
            ),
            Qt.ItemDataRole.SizeHintRole: lambda _: QSize(0, HEIGHT),
            ROW: lambda row: row,
            FIT: self.fit,
        }
        fits.changed.connect(self._fits_changed)

    # ---------------------------------------------------------------------------------------- following

    def follow(self, groups: Sequence[Group]) -> None:
        """Show these groups from now on."""
        wanted = {(group.type, group.kind): group for group in groups}
        for at in reversed(range(len(self._branches))):
            if self._branches[at].key not in wanted:
                self.beginRemoveRows(QModelIndex(), at, at)
                del self._branches[at]
                self.endRemoveRows()
        for at, group in enumerate(groups):
            self._place(at, group)
            self._follow_rows(self._branches[at], group.rows)

    def _place(self, at: int, group: Group) -> None:
        """Let the group stand at a place."""
        key = group.type, group.kind
        found = next((k for k, branch in enumerate(self._branches) if branch.key == key), None)
        if found is None:
            self._numbers += 1
            self.beginInsertRows(QModelIndex(), at, at)
            self._branches.insert(at, _Branch(self._numbers, group))
            self.endInsertRows()
        elif found != at:
            self.beginMoveRows(QModelIndex(), found, found, QModelIndex(), at)
            self._branches.insert(at, self._branches.pop(found))
            self.endMoveRows()
        self._branches[at].group = group

    def _follow_rows(self, branch: _Branch, rows: Sequence[Row]) -> None:
        if len(rows) == len(branch.rows) and all(map(is_, rows, branch.rows)):
            return
        parent, keys = self.index(self._branches.index(branch), 0), {row.key for row in rows}
        gone = [at for at, row in enumerate(branch.rows) if row.key not in keys]
        for first, last in reversed(list(spans(gone))):
            self.beginRemoveRows(parent, first, last)
            del branch.rows[first : last + 1]
            self.endRemoveRows()
        self._order(branch, parent, rows)
        known = {row.key for row in branch.rows}
        for first, last in spans(at for at, row in enumerate(rows) if row.key not in known):
            self.beginInsertRows(parent, first, last)
            branch.rows[first:first] = rows[first : last + 1]
            self.endInsertRows()
        for at, row in enumerate(rows):
            if branch.rows[at] != row:
                branch.rows[at] = row
                self._told(self.index(at, 0, parent))

    def _order(self, branch: _Branch, parent: QModelIndex, rows: Sequence[Row]) -> None:
        """Bring what is listed in the order of *rows*, among which all of it is."""
        places = {row.key: place for place, row in enumerate(rows)}
        for at, to in moves([places[row.key] for row in branch.rows]):
            # Qt counts the row that it is put before as if the one that moves still stood where it was.
            self.beginMoveRows(parent, at, at, parent, to + (to > at))
            branch.rows.insert(to, branch.rows.pop(at))
            self.endMoveRows()

    def _fits_changed(self, keys: Iterable[Key]) -> None:
        for key in keys:
            row = self.row(index := self.find(RowKey(*key)))
            if row is not None and self.fit(row) is not None:  # otherwise its row says nothing of it
                self._told(index)

    def _told(self, index: QModelIndex) -> None:
        self.dataChanged.emit(index, index)

    # ------------------------------------------------------------------------------------------ looking

    def find(self, key: RowKey) -> QModelIndex:
        """The index of a behavior; invalid if it is not listed."""
        for place, branch in enumerate(self._branches):
            if branch.group.type == key.type:
                for at, row in enumerate(branch.rows):
                    if row.key == key:
                        return self.index(at, 0, self.index(place, 0))
        return QModelIndex()

    def group(self, index: Index) -> Group | None:
        """The group that an index is of; None for a behavior."""
        return self._branches[index.row()].group if index.isValid() and not index.internalId() else None

    def row(self, index: Index) -> Row | None:
        """The behavior that an index is of; None for a group."""
        branch = self._branch(index.internalId()) if index.isValid() else None
        return None if branch is None else branch.rows[index.row()]

    @property
    def rows(self) -> tuple[Row, ...]:
        """All behaviors, as they are listed."""
        return tuple(row for branch in self._branches for row in branch.rows)

    def _branch(self, number: int) -> _Branch | None:
        return next((branch for branch in self._branches if branch.number == number), None)

    # --------------------------------------------------------------------------------------- Qt's model

    def index(self, row: int, column: int, parent: Index = QModelIndex()) -> QModelIndex:  # noqa: B008 - an immutable value
        """Groups have the number 0, behaviors that of their group."""
        if column or row < 0 or row >= self.rowCount(parent):
            return QModelIndex()
        return self.createIndex(row, column, self._branches[parent.row()].number if parent.isValid() else 0)

    def parent(self, index: Index) -> QModelIndex:  # type: ignore[override]  # Qt's other parent() is QObject's
        """The group of a behavior."""
        branch = self._branch(index.internalId()) if index.isValid() else None
        return QModelIndex() if branch is None else self.createIndex(self._branches.index(branch), 0, 0)

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - as above
        """How many groups there are, or behaviors in one."""
        if not parent.isValid():
            return len(self._branches)
        return 0 if parent.internalId() else len(self._branches[parent.row()].rows)

    def columnCount(self, _parent: Index = QModelIndex()) -> int:  # noqa: B008 - as above
        """One: the delegate paints all that there is to say of a behavior."""
        return 1

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """What is shown of a group or a behavior."""
        row = self.row(index)
        if row is None:
            return self._group_data(self.group(index), role)
        made = self._row_data.get(role)
        return None if made is None else made(row)

    def _group_data(self, group: Group | None, role: int) -> Any:
        if group is not None and role in (
            Qt.ItemDataRole.DisplayRole,
            Qt.ItemDataRole.AccessibleTextRole,
        ):
            return group.title
        if group is not None and role == Qt.ItemDataRole.ToolTipRole:
            return _GROUP_TIPS[group.kind].format(type=group.type)
        return QSize(0, GROUP_HEIGHT) if role == Qt.ItemDataRole.SizeHintRole else None

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        """Rename an automaton."""
        row = self.row(index)
        if row is None or role != Qt.ItemDataRole.EditRole:
            return False
        return str(value).strip() == row.name or self._rename(row.key, str(value).strip())

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Groups can be folded; behaviors selected and dragged, automata also renamed."""
        row = self.row(index)
        if row is None:
            return Qt.ItemFlag.ItemIsEnabled
        return _AUTOMATON if row.is_automaton else _BASIC

    def mimeTypes(self) -> list[str]:
        """What a dragged behavior is."""
        return [MIME]

    def mimeData(self, indexes: Sequence[QModelIndex]) -> QMimeData:
        """A behavior to be dropped, e.g. into the automaton graph."""
        data = QMimeData()
        rows = [row for index in indexes if (row := self.row(index)) is not None]
        if rows:
            key = rows[0].key
            dragged = {"type": key.type, "id": key.id, "name": rows[0].name}
            data.setData(MIME, json.dumps(dragged).encode())
        return data

    def fit(self, row: Row) -> Fit | None:
        """How well a behavior fits its examples, as far as that is known."""
        return self._fits.of((row.key.type, row.key.id)) if row.examples or row.disabled else None

    def _tip(self, row: Row) -> str:
        lines = [row.shown, row.doc, *facts(row, self.fit(row))]
        if row.used_by:
            lines.append("used by " + _some([use.words for use in row.used_by]))
        if row.uses:
            lines.append("uses " + _some([use.words for use in row.uses]))
        return "\n".join(line for line in lines if line)


_GROUP_TIPS = {
    Kind.LEARNED: "Behaviors of {type!r} that are taught",
    Kind.AUTHORED: "Behaviors of {type!r} whose transitions are written by hand",
    Kind.BASIC: "What nodes of type {type!r} can do by themselves, as the scenario has it",
    Kind.DERIVED: "What controllers of type {type!r} can direct: all their subsidiaries know these",
}


def facts(row: Row, fit: Fit | None) -> tuple[str, ...]:
    """All that the badges of a row stand for, in words."""
    said = []
    if row.once:
        said.append("runs once, on entry")
    said += [f"raises {flag}" for flag in row.raises]
    if row.examples or row.disabled:
        off = f", {row.disabled} disabled" if row.disabled else ""
        said.append(f"{counted(row.examples, 'example')}{off}")
        if fit is not None:
            said.append(fit.words)
    return tuple(said)


def _some(words: Sequence[str], most: int = 6) -> str:
    more = f" and {len(words) - most} more" if len(words) > most else ""
    return ", ".join(words[:most]) + more
