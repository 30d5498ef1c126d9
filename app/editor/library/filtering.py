"""What is left of the library while something stands in its filter."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QSortFilterProxyModel

from .model import LibraryModel
from .survey import Row

#: Gives the names of a behavior's features, and those of its states.
Words = Callable[[Row], tuple[tuple[str, ...], tuple[str, ...]]]
FEATURE, STATE = "feature:", "state:"


class LibraryFilter(QSortFilterProxyModel):
    """Keeps the behaviors that have all the words of the filter, and their groups.

    A word is looked for in names, features and states; ``feature:box`` and ``state:goto`` look in these only.
    """

    def __init__(self, model: LibraryModel, words: Words) -> None:
        super().__init__()
        self._library = model
        self._words = words
        self.text = ""
        self.setRecursiveFilteringEnabled(True)
        self.setSourceModel(model)

    def use(self, text: str) -> None:
        """Filter by *text*; an empty one keeps all."""
        self.beginFilterChange()
        self.text = text.casefold().strip()
        self.endFilterChange()

    def filterAcceptsRow(self, row: int, parent: QModelIndex | QPersistentModelIndex) -> bool:
        """Whether a behavior is left; groups are if something in them is."""
        if not self.text:
            return True
        found = self._library.row(self._library.index(row, 0, parent))
        return found is not None and matches(found, self.text, self._words)


def matches(row: Row, text: str, words: Words) -> bool:
    """Whether a behavior has all the words of *text*, which is in small letters."""
    features, states = words(row)
    places = {
        FEATURE: " ".join(features).casefold(),
        STATE: " ".join(states).casefold(),
        "": " ".join((row.shown, *features, *states)).casefold(),
    }
    for word in text.split():
        prefix = next((p for p in (FEATURE, STATE) if word.startswith(p)), "")
        if word.removeprefix(prefix) not in places[prefix]:
            return False
    return True
