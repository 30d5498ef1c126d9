"""Slow work in threads of its own; answers come back in the window's thread."""

from collections.abc import Callable
from threading import Thread
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal

from ...core.errors import UnderstudyError


class Job:
    """Something that is being done.

    Attributes:
        dropped: Nobody waits for the answer any more.
    """

    def __init__(self, then: Callable[[Any], object], failed: Callable[[UnderstudyError], object]) -> None:
        self.then = then
        self.failed = failed
        self.dropped = False

    def drop(self) -> None:
        """Do without the answer; what is being done ends by itself."""
        self.dropped = True


class Background(QObject):
    """Does slow things without keeping the window waiting.

    Attributes:
        busy: Whether something is being done for which somebody waits.
    """

    _ended = Signal(object, object, object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs: dict[Job, Thread] = {}
        self._ended.connect(self._take, Qt.ConnectionType.QueuedConnection)

    def do(
        self,
        work: Callable[[], Any],
        then: Callable[[Any], object],
        failed: Callable[[UnderstudyError], object],
    ) -> Job:
        """Do *work* in a thread, and give its result to *then* or its error to *failed*, in this thread."""
        job = Job(then, failed)
        self._jobs[job] = Thread(target=self._work, args=(job, work), name="documents", daemon=True)
        self._jobs[job].start()
        return job

    @property
    def busy(self) -> bool:
        """Whether something is being done for which somebody waits."""
        return any(not job.dropped for job in self._jobs)

    def close(self) -> None:
        """Wait until all is done, and give no more answers."""
        for job, thread in self._jobs.items():
            job.drop()
            thread.join()
        self._jobs.clear()

    def _work(self, job: Job, work: Callable[[], Any]) -> None:
        try:
            self._end(job, work(), None)
        except UnderstudyError as error:
            self._end(job, None, error)
        except Exception as error:  # noqa: BLE001 - whatever it is, who waits has to hear of it
            self._end(job, None, UnderstudyError(f"{type(error).__name__}: {error}"))

    def _end(self, job: Job, result: object, error: UnderstudyError | None) -> None:
        try:
            self._ended.emit(job, result, error)
        except RuntimeError:  # the window is gone
            job.drop()

    def _take(self, job: Job, result: object, error: UnderstudyError | None) -> None:
        thread = self._jobs.pop(job, None)
        if thread is not None:
            thread.join()
        if job.dropped:
            return
        if error is None:
            job.then(result)
        else:
            job.failed(error)
