"""How a test waits for a laboratory, which has no signal, since whoever draws polls."""

import time
from collections.abc import Callable

from app.engine.experiments.laboratory import Laboratory, Look
from app.engine.experiments.process import LaboratoryProcess

#: Seconds; a process has to start on a machine that may be busy.
PATIENCE = 120.0


def until(laboratory: Laboratory | LaboratoryProcess, ready: Callable[[Look], bool]) -> Look:
    """The first look that is ready."""
    end = time.monotonic() + PATIENCE
    while not ready(laboratory.newest):
        assert time.monotonic() < end, laboratory.newest
        laboratory._thread.join(0.01)
    return laboratory.newest
