"""Pages that are made when somebody turns to them."""

from collections.abc import Callable, Mapping
from typing import TypeVar

from PySide6.QtWidgets import QTabWidget, QWidget

Page = TypeVar("Page", bound=QWidget)


class LatePages(QTabWidget):
    """Tabs whose pages are made when they are turned to or asked for first: a dialog is there once its first page is."""

    def __init__(self) -> None:
        super().__init__()
        self.setDocumentMode(True)
        self._makers: dict[str, Callable[[], QWidget]] = {}
        self._made: dict[str, QWidget] = {}
        self.currentChanged.connect(self._turned)

    def offer(self, makers: Mapping[str, Callable[[], QWidget]]) -> None:
        """Begin with these pages, each by its title, the first in front; those of before are gone."""
        before = [page for k in range(self.count()) if (page := self.widget(k)) is not None]
        self._makers, self._made = {}, {}
        self.clear()
        for page in before:
            page.deleteLater()
        self._makers = dict(makers)
        for title in makers:
            self.addTab(QWidget(), title)

    def page(self, title: str, kind: type[Page]) -> Page:
        """The page of a title, which is one of a kind; it is made if it was not yet."""
        page = self._made[title] if title in self._made else self._make(title)
        assert isinstance(page, kind)
        return page

    def made(self, kind: type[Page]) -> list[Page]:
        """The pages of a kind that were made so far."""
        return [page for page in self._made.values() if isinstance(page, kind)]

    def turn_to(self, title: str) -> None:
        """Show a page."""
        if title in self._makers:
            self.setCurrentIndex(list(self._makers).index(title))

    def _turned(self, at: int) -> None:
        titles = list(self._makers)
        if 0 <= at < len(titles) and titles[at] not in self._made:
            self._make(titles[at])

    def _make(self, title: str) -> QWidget:
        page = self._made[title] = self._makers[title]()
        at, current = list(self._makers).index(title), self.currentIndex()
        holder = self.widget(at)
        was_blocked = self.blockSignals(True)
        self.insertTab(at, page, title)
        if at == current:
            self.setCurrentIndex(at)
        self.removeTab(at + 1)
        self.blockSignals(was_blocked)
        if holder is not None:
            holder.deleteLater()
        return page
