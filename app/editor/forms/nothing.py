"""Words in a list that a filter has left empty."""

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractItemView, QLabel, QVBoxLayout


class NothingFound(QLabel):
    """Says, in the middle of a view, that nothing passes its filter; it is there only then."""

    def __init__(self, view: QAbstractItemView, words: str, is_filtered: Callable[[], bool]) -> None:
        """Watch a view.

        Args:
            view: Has its model already.
            is_filtered: Whether there may be rows that a filter hides.
        """
        super().__init__(words)
        self._view, self._is_filtered = view, is_filtered
        self.setProperty("role", "empty")
        self.setWordWrap(True)
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setContentsMargins(10, 8, 10, 8)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        QVBoxLayout(view.viewport()).addWidget(self)
        model = view.model()
        for signal in (model.modelReset, model.rowsInserted, model.rowsRemoved, model.layoutChanged):
            signal.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """Be there if no row is left."""
        self.setVisible(self._is_filtered() and not self._view.model().rowCount())
