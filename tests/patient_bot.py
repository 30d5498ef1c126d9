"""Mouse and keys at the pace of a person, on a machine that may be slow."""
# ruff: noqa: N802 - pytest-qt's names

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from app.editor.soon import catch_up

#: Milliseconds that a test waits at most; a busy machine is slow.
PATIENCE = 20_000


class PatientBot(QtBot):
    """Waits long enough, and has all that is due done before it presses anything.

    Nobody can press a key or a button between what has just happened and what the window does about it at once, so a test
    that did would tell of nothing that a user sees. Moving and letting go are left alone: a drag is one thing.
    """

    # -------------------------------------------------------------------------------------------- patience

    def waitUntil(self, callback: Callable[[], bool | None], *, timeout: int = PATIENCE) -> None:
        super().waitUntil(callback, timeout=timeout)

    def waitSignal(self, signal: Any, *, timeout: int = PATIENCE, **kwargs: Any) -> Any:
        return super().waitSignal(signal, timeout=timeout, **kwargs)

    def waitSignals(self, signals: Any, *, timeout: int = PATIENCE, **kwargs: Any) -> Any:
        return super().waitSignals(signals, timeout=timeout, **kwargs)

    def waitExposed(self, widget: QWidget, *, timeout: int = PATIENCE) -> Any:
        return super().waitExposed(widget, timeout=timeout)

    # ------------------------------------------------------------------------------------- a person's pace

    @staticmethod
    def keyClick(*args: Any, **kwargs: Any) -> None:
        catch_up()
        QtBot.keyClick(*args, **kwargs)

    @staticmethod
    def keyClicks(*args: Any, **kwargs: Any) -> None:
        catch_up()
        QtBot.keyClicks(*args, **kwargs)

    @staticmethod
    def keyPress(*args: Any, **kwargs: Any) -> None:
        catch_up()
        QtBot.keyPress(*args, **kwargs)

    @staticmethod
    def mouseClick(*args: Any, **kwargs: Any) -> None:
        catch_up()
        QtBot.mouseClick(*args, **kwargs)

    @staticmethod
    def mouseDClick(*args: Any, **kwargs: Any) -> None:
        catch_up()
        QtBot.mouseDClick(*args, **kwargs)

    @staticmethod
    def mousePress(*args: Any, **kwargs: Any) -> None:
        catch_up()
        QtBot.mousePress(*args, **kwargs)


def have_done_what_is_due() -> None:
    """Deliver all events that wait, and do what was put off."""
    QCoreApplication.processEvents()
    catch_up()
