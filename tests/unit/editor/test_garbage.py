"""What is thrown away in cycles is ended in the window's thread, however busy others are."""

import gc
import threading
import weakref
from collections.abc import Iterator

import pytest
from PySide6.QtCore import QObject
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.editor.garbage import YOUNG, Garbage


class Part:
    """Refers to itself."""

    def __init__(self) -> None:
        self.whole = self


@pytest.fixture
def garbage(qapp: QApplication) -> Iterator[None]:
    was_on = gc.isenabled()
    gc.enable()
    owner = QObject()
    Garbage(owner)
    yield
    if not was_on:
        gc.disable()


@pytest.mark.usefixtures("garbage")
def test_no_other_thread_ends_what_was_thrown_away(qtbot: QtBot) -> None:
    ended: list[threading.Thread] = []
    weakref.finalize(Part(), lambda: ended.append(threading.current_thread()))
    kept: list[Part] = []
    busy = threading.Thread(target=lambda: kept.extend(Part() for _ in range(20 * YOUNG)))
    busy.start()
    busy.join()
    assert ended == []
    qtbot.waitUntil(lambda: bool(ended))
    assert ended == [threading.main_thread()]
