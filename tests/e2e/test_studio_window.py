"""``./run`` as a user starts it: on a real screen, with real keys and clicks, looked at from outside."""

import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtGui import QColor, QImage

from app.editor.palette import LIGHT

ROOT = Path(__file__).parents[2]
NEEDED = ("Xvfb", "xdotool")
#: Seconds that anything may take on a busy machine.
PATIENCE = 300.0

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(
        any(shutil.which(program) is None for program in NEEDED),
        reason=f"needs {', '.join(NEEDED)}: apt-get install xvfb xdotool",
    ),
]

#: Takes a picture of the screen, in a process of its own: Qt is on another platform in this one.
PICTURE = """
import sys
from PySide6.QtGui import QGuiApplication
application = QGuiApplication([])
application.primaryScreen().grabWindow(0).save(sys.argv[1])
"""


class Screen:
    """A screen of its own, and hands on it."""

    def __init__(self, display: str, folder: Path) -> None:
        self.environment = {**os.environ, "DISPLAY": display, "QT_QPA_PLATFORM": "xcb"}
        self.environment |= {
            "XDG_CONFIG_HOME": str(folder / "config"),
            "XDG_STATE_HOME": str(folder / "state"),
        }
        self.environment.pop("WAYLAND_DISPLAY", None)
        self._folder = folder

    def do(self, *arguments: str) -> str:
        """What `xdotool` says; empty where it finds nothing."""
        done = subprocess.run(
            ["xdotool", *arguments],
            env=self.environment,
            capture_output=True,
            text=True,
            timeout=PATIENCE,
            check=False,
        )
        return done.stdout.strip()

    def wait_for(self, ready: Callable[[], bool]) -> None:
        """Look again and again until something is so; there is no other process to shake hands with."""
        end = time.monotonic() + PATIENCE
        while not ready():
            assert time.monotonic() < end, "the window did not get there in time"

    def title(self) -> str:
        """The title of the studio's window; empty before there is one."""
        found = self.do("search", "--onlyvisible", "--name", "Understudy").split()
        return self.do("getwindowname", found[-1]) if found else ""

    def picture(self) -> QImage:
        """What the screen shows."""
        path = self._folder / "screen.png"
        subprocess.run(
            [sys.executable, "-c", PICTURE, str(path)], env=self.environment, timeout=PATIENCE, check=True
        )
        return QImage(str(path))


@pytest.fixture
def screen(tmp_path: Path) -> Iterator[Screen]:
    """An X server without a screen, started for this test."""
    read, write = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write), "-screen", "0", "1440x900x24", "-nolisten", "tcp"],
        pass_fds=[write],
        stderr=subprocess.DEVNULL,
    )
    os.close(write)
    try:
        with os.fdopen(read) as number:
            yield Screen(f":{number.readline().strip()}", tmp_path)
    finally:
        server.terminate()
        server.wait()


def colors(picture: QImage) -> dict[str, int]:
    """How often each color is met, on a grid of points."""
    counts: dict[str, int] = {}
    for x in range(0, picture.width(), 4):
        for y in range(0, picture.height(), 4):
            name = picture.pixelColor(x, y).name()
            counts[name] = counts.get(name, 0) + 1
    return counts


def share(picture: QImage, *names: str) -> float:
    """The share of a picture that has one of these colors."""
    counts = colors(picture)
    return sum(counts.get(QColor(name).name(), 0) for name in names) / sum(counts.values())


def test_run_opens_the_studio_on_the_foraging_project_and_it_answers_keys_and_clicks(screen: Screen) -> None:
    studio = subprocess.Popen(
        [str(ROOT / "run")], env=screen.environment, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    try:
        screen.wait_for(lambda: "Box foraging" in screen.title())
        seen: list[QImage] = []

        def is_there() -> bool:
            seen.append(screen.picture())
            return is_whole(seen[-1])

        screen.wait_for(is_there)
        # The window takes the keys once it was clicked.
        screen.do("mousemove", "720", "300", "click", "1")
        screen.wait_for(lambda: "Understudy" in screen.do("getwindowfocus", "getwindowname"))
        screen.do("key", "space")
        screen.wait_for(lambda: _differs(seen[-1], screen.picture()))
        screen.do("key", "ctrl+k")
        screen.do("type", "--delay", "30", "quit")
        screen.do("key", "Return")
        screen.wait_for(lambda: studio.poll() is not None)
        assert studio.returncode == 0
    finally:
        if studio.poll() is None:
            os.killpg(studio.pid, signal.SIGKILL)
        assert studio.stderr is not None
        said = studio.stderr.read()
        studio.stderr.close()
        studio.wait()
    assert "Traceback" not in said


def is_whole(picture: QImage) -> bool:
    """Whether the world and all around it is painted: agents, boxes, words; not an empty page."""
    ours = share(picture, LIGHT.background, LIGHT.panel, LIGHT.raised, LIGHT.canvas)
    return share(picture, LIGHT.canvas) > 0.05 and ours > 0.5 and len(colors(picture)) > 20


def _differs(one: QImage, other: QImage) -> bool:
    """Whether agents have moved: many points of the canvas have another color."""
    points = [(x, y) for x in range(350, 1000, 2) for y in range(120, 560, 2)]
    return sum(one.pixel(x, y) != other.pixel(x, y) for x, y in points) > 20
