"""What every test shares: Qt without a screen, markers by folder, and no thread left behind."""

import gc
import os
import signal
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from hypothesis import HealthCheck, settings

if TYPE_CHECKING:
    from PySide6.QtWidgets import QApplication

    from tests.patient_bot import PatientBot

# Before anything imports Qt.
os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

# A shell ignores Ctrl-C for what it starts in the background, and so would all that the tests interrupt.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# Seconds that a thread gets to end by itself once the test that started it is over.
GRACE = 20.0

# Objects that have to be there before garbage is looked for between two tests.
GARBAGE = 20_000

FOLDER_MARKERS = {"gui": pytest.mark.gui, "bench": pytest.mark.bench}

# The same examples every time, so that no run fails by chance; new ones for who looks for what nobody has thought of yet,
# by NEW_EXAMPLES=1. Both say how to repeat a failure, and neither minds how slow a machine is.
_any_pace = settings(print_blob=True, deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("same", _any_pace, derandomize=True)
settings.register_profile("new", _any_pace)
settings.load_profile("new" if os.environ.get("NEW_EXAMPLES") else "same")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    tests = Path(__file__).parent
    for item in items:
        marker = FOLDER_MARKERS.get(item.path.relative_to(tests).parts[0])
        if marker is not None:
            item.add_marker(marker)


def pytest_sessionstart() -> None:
    # Python would look for garbage in any thread, and end Qt's objects there; see `app.editor.garbage`.
    gc.disable()


@pytest.hookimpl(trylast=True)
def pytest_runtest_teardown() -> None:
    if gc.get_count()[0] > GARBAGE:
        gc.collect(1)


def _our_threads() -> set[threading.Thread]:
    """Threads that Python code started: those of Qt and numba only pass through and are theirs to end."""
    # The standard library names no public class for a thread that was started elsewhere.
    foreign = threading._DummyThread
    return {thread for thread in threading.enumerate() if not isinstance(thread, foreign)}


@pytest.fixture(autouse=True)
def no_thread_left_behind() -> Iterator[None]:
    """Fails a test after which a thread still runs that was not there before."""
    before = _our_threads()
    yield
    end = time.monotonic() + GRACE
    for thread in _our_threads() - before:
        thread.join(max(0.0, end - time.monotonic()))
    left = sorted(thread.name for thread in _our_threads() - before)
    if left:
        pytest.fail(f"threads left behind: {', '.join(left)}")


@pytest.fixture
def qtbot(qapp: "QApplication", request: pytest.FixtureRequest) -> "PatientBot":
    """Instead of pytest-qt's: it gives a slow machine time, and the window a moment before each key and click."""
    from tests.patient_bot import PatientBot

    return PatientBot(request)
