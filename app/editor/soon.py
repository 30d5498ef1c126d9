"""What is done soon, once for all that asks for it: after all that is going on now, and before the next key."""

from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt

#: What is done may ask for more: a panel changes, then what is possible, then who shows that.
ROUNDS = 3
_DUE = QEvent.registerEventType()


class Soon(QObject):
    """Does something once, after all that is going on now, however often it is asked for until then.

    A timer would do it too, but keys that come fast, or while the window is busy, are all delivered before a timer's turn:
    they would find what the first of them has changed as it was before.
    """

    def __init__(self, parent: QObject, do: Callable[[], object]) -> None:
        super().__init__(parent)
        self._do = do
        self._is_due = False

    @property
    def is_due(self) -> bool:
        """Whether it was asked for and is not done yet."""
        return self._is_due

    def ask(self, *_: object) -> None:
        """Do it soon; any signal may ask for it."""
        if not self._is_due:
            self._is_due = True
            # After all else that waits to be delivered: whoever asks while that is dealt with is heard, too.
            QCoreApplication.postEvent(
                self, QEvent(QEvent.Type(_DUE)), Qt.EventPriority.LowEventPriority.value
            )

    def forget(self) -> None:
        """Do not do it after all."""
        self._is_due = False
        QCoreApplication.removePostedEvents(self, _DUE)

    def customEvent(self, _event: QEvent) -> None:
        """It is time."""
        self._is_due = False
        self._do()


def catch_up() -> None:
    """Do now all that is to be done soon."""
    for _ in range(ROUNDS):
        QCoreApplication.sendPostedEvents(None, _DUE)
