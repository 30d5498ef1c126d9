"""Compiling a scenario's kernel beside a session, in a process of its own, so that nobody has to wait for it.

numba holds the interpreter for some ten seconds while it compiles. So a session begins with the reference engine and
goes on with the compiled one as soon as there is a kernel, with the same results tick by tick.
"""

import subprocess
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from shutil import rmtree
from tempfile import mkdtemp
from threading import Lock, Thread

from ..core.errors import UncompilableError, UnderstudyError
from ..core.machine import Leaving
from ..sim.engine import Engine
from ..sim.engines import AUTO, REFERENCE, Notice, refuse_uncompilable
from ..sim.physics import in_physics
from ..sim.reference import ReferenceEngine
from ..sim.scenario import Scenario
from .children import environment, python
from .interrupts import deaf_processes
from .runs import Treatment, start_engine
from .scenarios import whereabouts

#: What a session says while it waits for a kernel.
COMPILING = "the engine is compiled, once; until then time passes more slowly"
#: Seconds between two looks at whether whoever waits for a kernel still wants it.
GLANCE = 0.1
_CHILD = f"{__package__}.compile_kernel"


def compile_ahead(
    scenario: Scenario,
    physics: str,
    notice: Notice,
    cancelled: Callable[[], bool],
    folder: Path | None = None,
) -> None:
    """Have the kernel kept before worlds are started, which then have no more to do than to load it.

    Compiling in this process could not be ended half-way. What cannot be compiled is left to who starts a world, and says so.

    Args:
        notice: Told in a few words what takes long.
        cancelled: Looked at while it goes on; it ends at once when nobody waits any more.
        folder: As in `KernelCompiler`.
    """
    wanted = in_physics(scenario, physics)
    try:
        refuse_uncompilable(wanted)
    except UncompilableError:
        return
    from ..sim.kernel import ahead  # noqa: PLC0415 - numba takes half a second to import

    if ahead.is_kept(wanted, ahead.writable(folder)):
        return
    notice(f"compiling the kernel of {scenario.name!r}, once")
    compilation = _Compilation(wanted, physics, lambda: None, folder)
    try:
        while not compilation.ends_within(GLANCE) and not cancelled():
            pass
    finally:
        compilation.close()


class KernelCompiler:
    """Starts engines, and brings the kernels that they need into this process, each once, in threads of its own."""

    def __init__(self, ready: Callable[[], None] = lambda: None, folder: Path | None = None) -> None:
        """Begin nothing yet.

        Args:
            ready: Called from a thread when something has changed about a kernel; it must only wake somebody up.
            folder: Where compiled kernels are kept; the user's cache folder by default.
        """
        self._ready = ready
        self._folder = folder
        self._wanted: dict[Scenario, _Compilation] = {}

    def start(
        self, of: Treatment, seed: int, leaving: Leaving | None = None, *, idle: bool = False
    ) -> Engine:
        """As `start_engine` does, but with the reference engine for as long as the kernel is not there."""
        if of.engine != AUTO:
            return start_engine(of, seed, leaving, idle=idle)
        engine = start_engine(replace(of, engine=REFERENCE), seed, leaving, idle=idle)
        scenario = engine.start.scenario
        if scenario not in self._wanted:
            self._wanted[scenario] = _Compilation(scenario, of.physics, self._ready, self._folder)
        return self.compiled(engine)

    def compiled(self, engine: Engine) -> Engine:
        """The compiled engine with *engine*'s world and nodes, or *engine* itself if that was not to be compiled.

        Also *engine* itself as long as the kernel is not there; what it says as its obstacle tells why.
        """
        wanted = self._wanted.get(engine.start.scenario)
        if wanted is None or not isinstance(engine, ReferenceEngine):
            return engine
        if wanted.done and not wanted.problem:
            from ..sim.kernel import KernelEngine  # noqa: PLC0415 - numba has been imported by now

            engine.obstacle = ""
            return KernelEngine(engine.start, folder=self._folder, over=engine)
        engine.obstacle = (
            f"{wanted.problem}; it runs uncompiled, which is slower" if wanted.done else wanted.notice
        )
        return engine

    def close(self) -> None:
        """End what is being compiled, and wait until nothing of it is left."""
        for wanted in self._wanted.values():
            wanted.close()


class _Compilation:
    """Getting one kernel.

    Attributes:
        done: It is there, or cannot be.
        problem: Why it cannot be.
        notice: What is going on, if that takes long; nothing where it is but loaded.
    """

    def __init__(
        self, scenario: Scenario, physics: str, ready: Callable[[], None], folder: Path | None
    ) -> None:
        self.done = False
        self.problem = ""
        self.notice = ""
        self._scenario = scenario
        self._physics = physics
        self._ready = ready
        self._folder = folder
        self._lock = Lock()
        self._stop = False
        self._process: subprocess.Popen[str] | None = None
        self._thread = Thread(target=self._work, name="compiler", daemon=True)
        self._thread.start()

    def ends_within(self, seconds: float) -> bool:
        """Wait for so long at most; whether it has come to its end."""
        self._thread.join(seconds)
        return not self._thread.is_alive()

    def close(self) -> None:
        """End the process and the thread."""
        with self._lock:
            self._stop = True
            if self._process is not None:
                self._process.kill()
        self._thread.join()

    def _work(self) -> None:
        try:
            self._get()
        except Exception as error:  # noqa: BLE001 - whatever it is, ticks can pass uncompiled
            known = isinstance(error, UnderstudyError)
            self.problem = (
                str(error) if known else f"the kernel cannot be compiled: {type(error).__name__}: {error}"
            )
        self.done = True
        self._ready()

    def _get(self) -> None:
        scenario = self._scenario
        refuse_uncompilable(scenario)
        from ..sim.kernel import ahead  # noqa: PLC0415 - numba takes half a second to import

        folder = ahead.writable(self._folder)
        if not ahead.is_kept(scenario, folder):
            self._compile(folder)
        if not self._stop:
            ahead.load(scenario, folder)

    def _compile(self, folder: Path) -> None:
        """Compile in another process and in a folder of its own, so that what is half done is in nobody's way."""
        from ..sim.kernel import ahead  # noqa: PLC0415 - as above

        self.notice = COMPILING
        self._ready()
        where = whereabouts(self._scenario)
        room = Path(mkdtemp(dir=folder, prefix="compiling-"))
        try:
            self._run(python(_CHILD, *where, self._physics, str(room)))
            if not self._stop:
                ahead.move(room, folder)
                if not ahead.is_kept(self._scenario, folder):
                    raise UncompilableError(
                        f"{where[-1]} has changed since it was opened; open the project again"
                    )
        finally:
            rmtree(room, ignore_errors=True)

    def _run(self, command: list[str]) -> None:
        """Run a process to its end.

        Raises:
            UncompilableError: It failed, and nobody has ended it.
        """
        with self._lock:
            if self._stop:
                return
            with deaf_processes():  # what Ctrl-C means, this program decides
                process = self._process = subprocess.Popen(
                    command,
                    stdin=subprocess.PIPE,  # once this program is gone it is at its end, and the process ends, too
                    stdout=subprocess.DEVNULL,
                    stderr=subprocess.PIPE,
                    text=True,
                    env=environment(),
                )
        assert process.stdin is not None
        assert process.stderr is not None
        with process.stdin, process.stderr:
            said = process.stderr.read().strip().splitlines()
            code = process.wait()
        if code != 0 and not self._stop:
            raise UncompilableError(
                f"the kernel could not be compiled: {said[-1] if said else f'exit code {code}'}"
            )
