"""Asks Graphviz, in its process, for arrangements; they are kept by what was to be arranged."""

import json
import os
import sys
from collections import OrderedDict
from dataclasses import asdict
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, QProcess, QProcessEnvironment, QTimer, Signal

from .arrangement import Arrangement, Request, at_once, from_dot

#: Milliseconds that Graphviz may think about one level; then its process is ended.
PATIENCE = 8_000
#: So many arrangements are kept.
MOST_KEPT = 256
MODULE = __name__.rpartition(".")[0] + ".dot"


class LayingOut(QObject):
    """Arranges levels in the background, one after the other.

    Signals:
        arranged: The arrangement of a request is known now.
        told: Graphviz cannot be used; the message says why. Told once.
    """

    arranged = Signal(object)
    told = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._known: OrderedDict[Request, Arrangement] = OrderedDict()
        self._waiting: list[Request] = []
        self._asked: Request | None = None
        self._number = 0
        self._process: QProcess | None = None
        self._trouble = ""
        self._patience = QTimer(self, interval=PATIENCE, singleShot=True)
        self._patience.timeout.connect(self._give_up)
        application = QCoreApplication.instance()
        if application is not None:
            application.aboutToQuit.connect(self.close)

    @property
    def is_idle(self) -> bool:
        """Whether nothing is being arranged."""
        return self._asked is None and not self._waiting

    def known(self, request: Request) -> Arrangement | None:
        """The arrangement of a request, if it is known."""
        return self._known.get(request)

    def ask(self, request: Request) -> None:
        """Have something arranged, before all that still waits."""
        if request in self._known or request == self._asked:
            return
        self._waiting = [other for other in self._waiting if other != request] + [request]
        self._next()

    def forget_waiting(self) -> None:
        """Nobody looks any more at what still waits."""
        self._waiting = []

    def warm_up(self) -> None:
        """Start the process before it is needed."""
        if self._process is None:
            self._start()

    def close(self) -> None:
        """End the process."""
        self._waiting, self._asked = [], None
        self._patience.stop()
        self._end()

    # ------------------------------------------------------------------------------------------- the process

    def _start(self) -> None:
        process = QProcess(self)
        environment = QProcessEnvironment.systemEnvironment()
        paths = [entry or str(Path.cwd()) for entry in sys.path]
        environment.insert("PYTHONPATH", os.pathsep.join(paths))
        process.setProcessEnvironment(environment)
        process.readyReadStandardOutput.connect(self._read)
        process.finished.connect(self._ended)
        process.errorOccurred.connect(self._failed)
        self._process = process
        process.start(sys.executable, ["-m", MODULE])

    def _end(self) -> None:
        process, self._process = self._process, None
        if process is not None:
            process.finished.disconnect(self._ended)
            process.errorOccurred.disconnect(self._failed)
            process.readyReadStandardOutput.disconnect(self._read)
            process.closeWriteChannel()
            process.kill()
            process.waitForFinished(2_000)
            process.deleteLater()

    def _next(self) -> None:
        if self._asked is not None or not self._waiting:
            return
        self._asked = request = self._waiting.pop()
        self._number += 1
        self.warm_up()
        assert self._process is not None
        line = json.dumps({"number": self._number, **asdict(request)})
        self._process.write(line.encode() + b"\n")
        self._patience.start()

    def _read(self) -> None:
        while self._process is not None and self._process.canReadLine():
            answer = json.loads(bytes(self._process.readLine().data()))
            if self._asked is None or answer["number"] != self._number:
                continue
            if "problem" in answer:
                self._without(f"Graphviz could not arrange the automaton: {answer['problem']}")
            else:
                self._take(from_dot(self._asked, answer))

    def _take(self, arrangement: Arrangement) -> None:
        request, self._asked = self._asked, None
        self._patience.stop()
        assert request is not None
        self._known[request] = arrangement
        while len(self._known) > MOST_KEPT:
            self._known.popitem(last=False)
        self.arranged.emit(request)
        self._next()

    # ----------------------------------------------------------------------------------------- without it

    def _give_up(self) -> None:
        self._end()
        self._without(
            f"Graphviz took more than {PATIENCE // 1000} s; states stand in rows, move them by hand"
        )

    def _ended(self) -> None:
        self._end()
        if self._asked is not None:
            self._without("Graphviz ended unexpectedly; states stand in rows")

    def _failed(self, error: QProcess.ProcessError) -> None:
        if error is QProcess.ProcessError.FailedToStart:
            self._end()
            if self._asked is not None:
                self._without("Graphviz could not be started; states stand in rows")

    def _without(self, trouble: str) -> None:
        if not self._trouble:
            self._trouble = trouble
            self.told.emit(trouble)
        if self._asked is not None:
            self._take(at_once(self._asked))
