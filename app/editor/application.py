"""Starting the studio: the application, its theme, its window, and the project to begin with."""

import logging
import signal
import sys
from pathlib import Path

from PySide6.QtCore import QMessageLogContext, QtMsgType, qInstallMessageHandler
from PySide6.QtWidgets import QApplication

from .settings import Settings
from .studio import Studio
from .theme import Theme
from .window.main_window import MainWindow

#: Seconds after which a thread that computes lets the window have its turn; Python's own is five times as long.
SWITCH = 0.001
_LEVELS = {
    QtMsgType.QtDebugMsg: logging.DEBUG,
    QtMsgType.QtInfoMsg: logging.INFO,
    QtMsgType.QtWarningMsg: logging.WARNING,
    QtMsgType.QtCriticalMsg: logging.ERROR,
    QtMsgType.QtFatalMsg: logging.CRITICAL,
}


def run(project: Path | None, settings: Path, state: Path | None = None, *, trust: bool = False) -> int:
    """Open the studio, with *project* if one is given, and stay until the user closes it.

    Args:
        settings, state: See `Settings`.
        trust: Run the code that the project carries without asking.

    Returns:
        The exit code.
    """
    sys.setswitchinterval(SWITCH)
    qInstallMessageHandler(_log)
    application = QApplication.instance() or QApplication(["understudy"])
    assert isinstance(application, QApplication)
    application.setApplicationName("understudy")
    application.setApplicationDisplayName("Understudy")
    window = make_window(application, Settings(settings, state))
    signal.signal(signal.SIGINT, lambda *_: window.close())
    signal.signal(signal.SIGTERM, lambda *_: window.close())
    window.show()
    if project is not None:
        window.files.open(project, trust=trust)
    window.files.offer_left_over(project)
    return application.exec()


def make_window(application: QApplication, settings: Settings) -> MainWindow:
    """A window with a studio of its own, showing the welcome page."""
    return MainWindow(Studio(Theme(application, settings.theme), settings))


def _log(kind: QtMsgType, context: QMessageLogContext, message: str) -> None:
    """What Qt has to say goes to the log."""
    logging.getLogger("qt").log(_LEVELS[kind], "%s (%s)", message, context.category)
