"""An experiment in a process of its own, for windows.

Python runs one thread at a time. Starting a world, measuring, keeping and summing up are Python, so that runs in threads of
the window's process would keep it waiting some hundred times a second; in another process they do not, and it steps back
where the window wants the cores.
"""

import pickle
import subprocess
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from threading import Lock, Thread
from typing import IO

from ...core.errors import UnderstudyError
from ...core.project import Project
from ...sim.scenario import Scenario
from ..children import environment, python
from ..interrupts import deaf_processes
from .laboratory import Look, Stage
from .order import Order, Told, Word, heard, tell
from .plan import Experiment
from .store import Row

_CHILD = f"{__package__}.run_laboratory"


class LaboratoryProcess:
    """Has one experiment carried out. Finished runs are kept, however it ends; results are those of a `Laboratory`.

    Attributes:
        experiment: What is carried out.
        rows: All runs that are kept, without their curves, as they came; only ever added to.
    """

    def __init__(
        self, project: Project, scenario: Scenario, experiment: Experiment, path: Path, jobs: int
    ) -> None:
        """Begin, or go on where the results in *path* end."""
        self.experiment = experiment
        self._order: Callable[[], Order] = lambda: Order.of(project, scenario, experiment, path, jobs)
        self.rows: list[Row] = []
        self._newest = Look(Stage.BEGINNING)
        self._lock = Lock()
        self._process: subprocess.Popen[bytes] | None = None
        self._unsaid: list[Word] | None = []  # until the order is given; None from then on
        self._paused = False
        self._closed = False
        self._thread = Thread(target=self._work, name="laboratory", daemon=True)
        self._thread.start()

    # ---------------------------------------------------------------------------- from any other thread

    @property
    def newest(self) -> Look:
        """How it stands."""
        return self._newest

    def pause(self) -> None:
        """Let all worlds stand still."""
        self._hold(Word.PAUSE)

    def resume(self) -> None:
        """Go on."""
        self._hold(Word.RESUME)

    def cancel(self) -> None:
        """Give up the runs that are being made; finished ones are kept."""
        with self._lock:
            self._say(Word.CANCEL)

    def close(self) -> None:
        """End at once, whatever is being made."""
        with self._lock:
            self._closed = True
            if self._process is not None:
                self._process.kill()
        self._thread.join()

    def _hold(self, word: Word) -> None:
        with self._lock:
            self._paused = word is Word.PAUSE
            self._newest = self._as_asked(self._newest)
            self._say(word)

    def _as_asked(self, look: Look) -> Look:
        """The process may not have heard yet what the user asked for."""
        if look.is_over:
            return look
        if self._paused:
            return replace(look, stage=Stage.PAUSED)
        return replace(look, stage=Stage.RUNNING) if look.stage is Stage.PAUSED else look

    def _say(self, word: Word) -> None:
        if self._unsaid is not None:
            self._unsaid.append(word)
        elif self._process is not None and self._process.stdin is not None:
            _say(self._process.stdin, word)

    # ------------------------------------------------------------------------------------- in its thread

    def _work(self) -> None:
        try:
            self._carry_out()
        except UnderstudyError as error:
            self._fail(str(error))
        except Exception as error:  # noqa: BLE001 - whatever it is, whoever looks has to hear of it
            self._fail(f"{type(error).__name__}: {error}")

    def _carry_out(self) -> None:
        process = self._started()
        if process is None:
            return
        assert process.stdin is not None
        assert process.stdout is not None
        try:
            with suppress(
                OSError, EOFError, pickle.UnpicklingError
            ):  # it has ended, which its exit code tells
                self._give(process.stdin)
                self._follow(process.stdout)
        finally:
            self._let_go(process)
        if not self._newest.is_over:
            self._fail(_ENDED.format(code=process.returncode))

    def _started(self) -> subprocess.Popen[bytes] | None:
        """The process, unless it is not wanted any more."""
        with self._lock:
            if self._closed:
                return None
            with deaf_processes():  # the window decides what Ctrl-C means, also while it starts
                self._process = subprocess.Popen(
                    python(_CHILD), stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment()
                )
            return self._process

    def _give(self, orders: IO[bytes]) -> None:
        """Give the order, and say what was asked for meanwhile."""
        tell(orders, self._order())
        with self._lock:
            for word in self._unsaid or ():
                _say(orders, word)
            self._unsaid = None

    def _follow(self, looks: IO[bytes]) -> None:
        """Take over every look until it is over."""
        while not self._newest.is_over:
            told: Told = heard(looks)
            self.rows += told.rows
            with self._lock:
                found = self._newest.found if told.as_before else told.look.found
                self._newest = self._as_asked(replace(told.look, found=found))

    def _let_go(self, process: subprocess.Popen[bytes]) -> None:
        """Wait for its end, which comes by itself where the last look has."""
        if not self._newest.is_over:
            process.kill()
        for pipe in (process.stdin, process.stdout):
            assert pipe is not None
            with suppress(OSError):  # a word that came too late waits in it, and nobody reads it any more
                pipe.close()
        process.wait()

    def _fail(self, notice: str) -> None:
        with self._lock:
            self._newest = replace(self._newest, stage=Stage.FAILED, notice=notice)


_ENDED = (
    "the process that made the runs ended all of a sudden (exit code {code}); was there too little memory? "
    "Finished runs are kept, and Run goes on with the others"
)


def _say(orders: IO[bytes], word: Word) -> None:
    with suppress(OSError, ValueError):  # it has ended, and who follows it hears of that
        tell(orders, word)
