"""Starting the studio: the application, its theme, its window, and the project to begin with."""

import logging
import sys
from collections import deque
from collections.abc import Callable, Sequence
from functools import partial
from importlib import import_module
from pathlib import Path
from threading import Thread

from PySide6.QtCore import QMessageLogContext, QTimer, QtMsgType, qInstallMessageHandler
from PySide6.QtWidgets import QApplication

from ..core.project import Project
from ..engine.commands import GoTo, Reset
from ..sim.scenario import Scenario
from .garbage import Garbage
from .left_boxes import tell_left_boxes
from .settings import Settings
from .size import use_size
from .soon import Later
from .studio import Studio
from .theme import Theme
from .told_to_end import ToldToEnd
from .unforeseen import Unforeseen
from .window.main_window import MainWindow

#: Seconds after which a thread that computes lets the window have its turn. Qt gives its turn away at nearly every call, so
#: what is painted by fifty calls waits fifty times as long while another thread runs Python; Python's own is 0.005.
SWITCH = 0.00025
#: What takes long to import and is not needed at once, and after how many milliseconds it is imported all the same.
LATER, AHEAD = (".plots.lines_view", ".experiments.window"), 2_000
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
    chosen = Settings(settings, state)
    use_size(chosen.size_percent)
    application = make_application()
    window = make_window(application, chosen)
    runs = RunWindows(application, window)
    told = ToldToEnd()
    told.came.connect(lambda: close_when_told(window))
    unforeseen = Unforeseen()
    unforeseen.came.connect(window.studio.warn)
    window.show()
    window.studio.opened.connect(window.guide.offer)
    if project is not None:
        window.files.open(project, trust=trust)
    window.files.offer_left_over(project)
    code = application.exec()
    runs.close()
    unforeseen.close()
    told.close()
    return code


def close_when_told(window: MainWindow) -> None:
    """Close, as if the user did; what is unsaved is kept first, since who tells may not wait until the user has answered.

    What is being asked already is left: otherwise the window would stay until somebody has answered that.
    """
    window.files.autosaving.keep()
    window.files.unask()
    window.close()


class RunWindows:
    """Windows in which runs of experiments are looked at, as projects of their own."""

    def __init__(self, application: QApplication, window: MainWindow) -> None:
        self._application = application
        self._window = window
        self._open: list[MainWindow] = []
        self._begun: deque[tuple[MainWindow, Callable[[], None]]] = (
            deque()
        )  # with what comes once they are whole
        self._more = Later(window, self._build)
        window.studio.window_wanted.connect(self.open)
        window.closed.connect(self.close)

    def open(self, project: Project, scenario: Scenario, arm: str, seed: int, tick: int) -> None:
        """Show a project in a window of its own, its arm's world at a tick."""
        window = _bare_window(self._application, self._window.studio.settings, at_once=False)
        self._begun.append((window, partial(self._show, window, project, scenario, arm, seed, tick)))
        self._more.ask()

    def _build(self) -> None:
        """A part at a time, so that the window that asked for another goes on."""
        window, show = self._begun[0]
        if not window.build_more():
            self._begun.popleft()
            show()
        if self._begun:
            self._more.ask()

    def _show(
        self, window: MainWindow, project: Project, scenario: Scenario, arm: str, seed: int, tick: int
    ) -> None:
        window.take_place()
        self._open.append(window)
        window.closed.connect(partial(self._closed, window))
        window.show()

        def begin() -> None:
            window.studio.open(project, scenario, None, saved=True, arm=arm)
            window.studio.bridge.send(Reset(seed))
            window.studio.bridge.send(GoTo(tick))

        QTimer.singleShot(0, window, begin)

    def _closed(self, window: MainWindow) -> None:
        """Nobody looks at it again, but each change of the theme would style it."""
        if window in self._open:
            self._open.remove(window)
        window.deleteLater()

    def close(self) -> None:
        """Close all of them; those that are being built come no more."""
        self._more.forget()
        while self._begun:
            unfinished, _ = self._begun.popleft()
            unfinished.studio.shut_down()
            unfinished.deleteLater()
        for window in list(self._open):
            window.close()
        self._open.clear()


def make_application() -> QApplication:
    """The application, with threads that take turns often enough for a window."""
    sys.setswitchinterval(SWITCH)
    qInstallMessageHandler(_log)
    application = QApplication.instance() or QApplication(["understudy"])
    assert isinstance(application, QApplication)
    Garbage(application)
    application.setApplicationName("understudy")
    application.setApplicationDisplayName("Understudy")
    tell_left_boxes(application)
    return application


def make_window(application: QApplication, settings: Settings) -> MainWindow:
    """A window with a studio of its own, showing the welcome page."""
    window = _bare_window(application, settings, at_once=True)
    window.take_place()
    QTimer.singleShot(AHEAD, window, _import_later_things)
    return window


def _bare_window(application: QApplication, settings: Settings, *, at_once: bool) -> MainWindow:
    return MainWindow(Studio(Theme(application, settings.theme), settings), at_once=at_once)


def _import_later_things() -> None:
    """In a thread, so that the window is not held up now, nor when a panel is looked at first.

    The program waits for its end: a thread that is cut off in the middle of Qt's code ends a program badly.
    """
    Thread(target=_import_all, args=(LATER,), name="ahead").start()


def _import_all(modules: Sequence[str]) -> None:
    for module in modules:
        import_module(module, __package__)


def _log(kind: QtMsgType, context: QMessageLogContext, message: str) -> None:
    """What Qt has to say goes to the log."""
    logging.getLogger("qt").log(_LEVELS[kind], "%s (%s)", message, context.category)
