"""States in the clipboard: where they were copied from, and which; copies are made from the project when pasted."""

import json
from dataclasses import dataclass

from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication

STATES_MIME = "application/x-understudy-states"


@dataclass(frozen=True, slots=True)
class CopiedStates:
    """States of an automaton, by ids."""

    type: str
    automaton: str
    states: tuple[str, ...]


def put(copied: CopiedStates, names: str) -> None:
    """Put states into the clipboard, with their *names* for programs that only read text."""
    data = QMimeData()
    content = {"type": copied.type, "automaton": copied.automaton, "states": list(copied.states)}
    data.setData(STATES_MIME, json.dumps(content).encode())
    data.setText(names)
    QGuiApplication.clipboard().setMimeData(data)


def there() -> CopiedStates | None:
    """The states in the clipboard, if it holds any."""
    data = QGuiApplication.clipboard().mimeData()
    if not data.hasFormat(STATES_MIME):
        return None
    try:
        content = json.loads(bytes(data.data(STATES_MIME).data()))
        return CopiedStates(
            str(content["type"]), str(content["automaton"]), tuple(map(str, content["states"]))
        )
    except (ValueError, KeyError, TypeError):
        return None
