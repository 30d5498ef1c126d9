"""States in the clipboard: of which project and automaton, and which; copies are made from the project when pasted."""

import atexit
import json
from dataclasses import asdict, dataclass
from functools import cache

from PySide6.QtCore import QMimeData, QObject, Signal
from PySide6.QtGui import QGuiApplication

STATES_MIME = "application/x-understudy-states"


@dataclass(frozen=True, slots=True)
class CopiedStates:
    """States of an automaton, by ids.

    Attributes:
        project: Stands for the project that is open: ids of another one would mean something else.
    """

    project: str
    type: str
    automaton: str
    states: tuple[str, ...]


class Held(QObject):
    """Which states the clipboard holds that were copied here.

    What other programs put there is never fetched before it is pasted: a slow one would hold up the window.

    Attributes:
        copied: The states, if it holds any.

    Signals:
        changed: It holds something else.
    """

    changed = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.copied: CopiedStates | None = None
        self._is_putting = False
        QGuiApplication.clipboard().dataChanged.connect(self._look)

    def put(self, copied: CopiedStates, names: str) -> None:
        """See the function of that name."""
        self._is_putting = True
        put(copied, names)
        self._is_putting = False
        self._take(copied)

    def _look(self) -> None:
        if not self._is_putting:  # some systems tell of it later: it is ours then
            self._take(there() if QGuiApplication.clipboard().ownsClipboard() else None)

    def _take(self, copied: CopiedStates | None) -> None:
        if copied != self.copied:
            self.copied = copied
            self.changed.emit()


def put(copied: CopiedStates, names: str) -> None:
    """Put states into the clipboard, with their *names* for programs that only read text."""
    data = QMimeData()
    data.setData(STATES_MIME, json.dumps(asdict(copied)).encode())
    data.setText(names)
    QGuiApplication.clipboard().setMimeData(data)
    _leave_words_at_exit()


@cache
def _leave_words_at_exit() -> None:
    """Have the clipboard let go of what Python made before Python ends: Qt would touch it after that, and crash."""
    atexit.register(_leave_words)


def _leave_words() -> None:
    if QGuiApplication.instance() is not None and there() is not None:
        clipboard = QGuiApplication.clipboard()
        clipboard.setText(clipboard.text())


def there() -> CopiedStates | None:
    """The states in the clipboard, if it holds any."""
    # There is none where nothing was ever copied.
    data: QMimeData | None = QGuiApplication.clipboard().mimeData()
    if data is None or not data.hasFormat(STATES_MIME):
        return None
    try:
        content = json.loads(bytes(data.data(STATES_MIME).data()))
        project, kind, automaton = (str(content[name]) for name in ("project", "type", "automaton"))
        return CopiedStates(project, kind, automaton, tuple(map(str, content["states"])))
    except (ValueError, KeyError, TypeError):
        return None
