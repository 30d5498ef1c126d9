"""How long the window could not answer: a timer that beats in its thread, and how late each beat came."""

from collections.abc import Sequence
from math import ceil
from time import perf_counter

from PySide6.QtCore import QObject, Qt, QTimer

#: Milliseconds between two beats.
BEAT = 5


class Heartbeat(QObject):
    """Beats until it is stopped.

    Attributes:
        late: By how many seconds each beat came too late.
    """

    def __init__(self) -> None:
        super().__init__()
        self.late: list[float] = []
        self._timer = QTimer(self, interval=BEAT, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._beat)
        self.last = perf_counter()
        self._timer.start()

    def _beat(self) -> None:
        now = perf_counter()
        self.late.append(max(0.0, now - self.last - BEAT / 1000.0))
        self.last = now

    def stop(self) -> None:
        """Beat no more."""
        self._timer.stop()


def percentile(values: Sequence[float], share: float) -> float:
    """The least of the values that *share* of all do not exceed (nearest rank)."""
    return sorted(values)[max(0, ceil(share * len(values)) - 1)]
