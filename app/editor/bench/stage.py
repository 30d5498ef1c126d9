"""A real window off screen, for figures that need one: opened, waited for, and acted on."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter, thread_time

from PySide6.QtCore import QEvent, QEventLoop, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication

from ...core.errors import UnderstudyError
from ...core.project import LevelTable, Project
from ...engine.scenarios import open_scenario
from ...engine.snapshots import Snapshot
from ..application import make_application, make_window
from ..documents.held import Held
from ..settings import Settings
from ..studio import Studio
from ..theme import ThemeMode

#: Seconds that something may take before the figure is given up.
PATIENCE = 120.0
#: Work has ended once nothing has taken longer than the first for as long as the second, in seconds.
SHORT, QUIET = 0.002, 0.03
_ALL = QEventLoop.ProcessEventsFlag.AllEvents
_MORE = QEventLoop.ProcessEventsFlag.WaitForMoreEvents


class StageError(UnderstudyError):
    """The window did not do what was to be measured; the message says what."""


class Stage:
    """A window that is measured."""

    def __init__(self, home: Path) -> None:
        """Show an empty window.

        Args:
            home: A folder for its settings and for what it keeps.
        """
        self.application = make_application()
        settings = Settings(home / "settings.ini", home / "state")
        settings.theme = ThemeMode.DARK
        self.home = home
        self.window = make_window(self.application, settings)
        self.window.show()

    @property
    def studio(self) -> Studio:
        """What the window shows."""
        return self.window.studio

    @property
    def snapshot(self) -> Snapshot:
        """The newest."""
        snapshot = self.studio.snapshot
        assert snapshot is not None
        return snapshot

    def open(self, project: Project, arm: str = "") -> None:
        """Show a project that no folder holds, with its compiled kernel."""
        self.window.files.show(Held(), project, open_scenario(project), saved=False, arm=arm)
        self.wait(lambda: self.studio.snapshot is not None and self.snapshot.engine == "compiled", "open")
        self.settle()

    def close(self) -> None:
        """End all that runs, and what is being autosaved: the folder that it is kept in goes."""
        self.window.files.shut_down()
        self.studio.shut_down()
        self.window.hide()

    # -------------------------------------------------------------------------------------------- waiting

    def turn(self) -> None:
        """Let the window work once; wait until there is something to do."""
        self.application.processEvents(_ALL | _MORE)

    def wait(self, ready: Callable[[], object], what: str) -> None:
        """Let the window work until it is so.

        Raises:
            StageError: It never was.
        """
        end = perf_counter() + PATIENCE
        while not ready():
            if perf_counter() > end:
                raise StageError(f"the window did not get to {what!r} in {PATIENCE:.0f} s")
            self.turn()

    def run(self, seconds: float) -> None:
        """Let the window work for so long."""
        end = perf_counter() + seconds
        while perf_counter() < end:
            self.turn()

    def settle(self) -> float:
        """Let the window work until nothing is left to do; returns how long that took, in seconds."""
        began = busy = perf_counter()
        while perf_counter() - busy < QUIET:
            worked = thread_time()  # being kept waiting by other programs is no work
            self.application.processEvents(_ALL)
            if thread_time() - worked > SHORT:
                busy = perf_counter()
        return busy - began

    def seconds_of(self, act: Callable[[], object]) -> float:
        """How long it takes until all that an act leads to in the window can be seen."""
        began = perf_counter()
        act()
        acted = perf_counter() - began
        return acted + self.settle()

    def press(self, key: Qt.Key, modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
        """Press a key in the window."""
        target = QApplication.focusWidget() or self.window
        text = chr(key) if modifiers == Qt.KeyboardModifier.NoModifier and key < 128 else ""
        for kind in (QEvent.Type.KeyPress, QEvent.Type.KeyRelease):
            self.application.postEvent(target, QKeyEvent(kind, key, modifiers, text))


@contextmanager
def stage() -> Iterator[Stage]:
    """A window with a home of its own, for as long as it is needed."""
    with TemporaryDirectory() as home:
        shown = Stage(Path(home))
        try:
            yield shown
        finally:
            shown.close()


def crowded(project: Project, agents: int) -> Project:
    """*project* with one more arm, "crowd", of so many agents that forage on their own, in a world that has room."""
    first = project.arms[0]
    side = 200.0 * (agents / 50) ** 0.5
    world = {**project.worlds.get(first.world, {}), "boxes": agents // 5, "width": side, "height": side}
    arm = replace(
        first, name="crowd", hierarchy=LevelTable((agents,), ("agent",)), world="crowd", parameters={}
    )
    return replace(project, arms=(*project.arms, arm), worlds={**project.worlds, "crowd": world})
