"""What is left of the library while something stands in its filter."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QSortFilterProxyModel

from ...core.naming import lowered
from ..searching import has_words, words_in
from .model import LibraryModel
from .survey import Row, RowKey, words_of

if TYPE_CHECKING:
    from ...core.project import Project
    from ..document import Document

#: Gives the names of a behavior's features, and those of its states.
Words = Callable[[Row], tuple[tuple[str, ...], tuple[str, ...]]]
FEATURE, STATE = "feature:", "state:"


class KnownWords:
    """Gives the words by which behaviors are found besides their names, looked up once in each project."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._project: Project | None = None
        self._known: dict[RowKey, tuple[tuple[str, ...], tuple[str, ...]]] = {}

    def __call__(self, row: Row) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """See `Words`."""
        key, project = row.key, self._document.project
        if self._project is not project:
            self._project, self._known = project, {}
        if key not in self._known:
            library = project.library(key.type)
            automaton = library.automata.get(key.id)
            self._known[key] = ((), ()) if automaton is None else words_of(automaton, library)
        return self._known[key]


class LibraryFilter(QSortFilterProxyModel):
    """Keeps the behaviors that have all the words of the filter, and their groups.

    A word is looked for in names, features and states; ``feature:box`` and ``state:goto`` look in these only.
    """

    def __init__(self, model: LibraryModel, words: Words) -> None:
        super().__init__()
        self._library = model
        self._words_of = words
        self.words: tuple[str, ...] = ()
        self.setRecursiveFilteringEnabled(True)
        self.setSourceModel(model)

    def use(self, text: str) -> None:
        """Filter by *text*; an empty one keeps all."""
        self.beginFilterChange()
        self.words = words_in(text)
        self.endFilterChange()

    def filterAcceptsRow(self, row: int, parent: QModelIndex | QPersistentModelIndex) -> bool:
        """Whether a behavior is left; groups are if something in them is."""
        if not self.words:
            return True
        found = self._library.row(self._library.index(row, 0, parent))
        return found is not None and matches(found, self.words, self._words_of)

    def found(self) -> Iterator[QModelIndex]:
        """The behaviors that are left, from the top."""
        for at in range(self.rowCount()):
            group = self.index(at, 0)
            yield from (self.index(row, 0, group) for row in range(self.rowCount(group)))

    def nearest(self) -> QModelIndex | None:
        """The behavior whose name is nearest to what the filter says, the first of several; None if none is left."""
        return min(self.found(), key=self._farness, default=None)

    def _farness(self, index: QModelIndex) -> int:
        row = self._library.row(self.mapToSource(index))
        name, text = "" if row is None else lowered(row.name), " ".join(self.words)
        return 0 if name == text else 1 if name.startswith(text) else 2 if has_words(self.words, name) else 3


def matches(row: Row, wanted: Sequence[str], words: Words) -> bool:
    """Whether a behavior has all the words that are *wanted*, which are in small letters."""
    features, states = words(row)
    places = {FEATURE: features, STATE: states, "": (row.shown, *features, *states)}
    looked_for: dict[str, list[str]] = {prefix: [] for prefix in places}
    for word in wanted:
        prefix = next((p for p in (FEATURE, STATE) if word.startswith(p)), "")
        looked_for[prefix].append(word.removeprefix(prefix))
    return all(has_words(looked_for[prefix], *texts) for prefix, texts in places.items())
