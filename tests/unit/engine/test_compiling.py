"""Compiling beside the session: the world goes on meanwhile, moves when the kernel is there, and nothing is left behind."""

import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from subprocess import Popen
from threading import Event
from threading import enumerate as threads
from typing import Any

import pytest

from app.core.hierarchy import from_table
from app.engine import compiling
from app.engine.commands import Others, Pause, Pick, Play, Step, Teach
from app.engine.compiling import COMPILING, KernelCompiler, compile_ahead
from app.engine.runs import Treatment, treatment
from app.engine.scenarios import found_again, open_scenario, whereabouts
from app.engine.session import Session
from app.engine.thread import EngineThread
from app.sim.kernel import ahead
from tests import kernel_faults
from tests.corridor import corridor, project
from tests.driver import UNCOMPILED

#: Seconds that anything may take on a busy machine, on which importing numba takes long.
PATIENCE = 300.0


@pytest.fixture
def compiler(tmp_path: Path) -> Iterator[KernelCompiler]:
    """Compiles into a folder of its own."""
    made = KernelCompiler(folder=tmp_path)
    yield made
    made.close()


def alone() -> Treatment:
    """Corridor walkers."""
    return treatment(project(), corridor, project().arm("alone"))


def left_in(folder: Path) -> list[str]:
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


def compilers() -> list[str]:
    return [thread.name for thread in threads() if thread.name.startswith("compiler")]


@pytest.mark.slow
def test_a_world_goes_on_uncompiled_and_moves_to_the_kernel_when_it_is_there(tmp_path: Path) -> None:
    def make(wake: Callable[[], None]) -> Session:
        return Session(project(), corridor, "alone", compiler=KernelCompiler(wake, tmp_path))

    thread = EngineThread(make)
    try:
        thread.send(Play(1.0))
        snapshot = thread.wait_for(lambda s: s.notice == COMPILING)
        assert snapshot.engine == "reference"
        thread.send(Teach("agent", "Shuttle", ("agent-1",), others=Others.RUN))
        thread.send(Pick("agent-1", "up"))
        thread.wait_for(lambda s: s.tick > snapshot.tick)  # they do not wait for the kernel
        moved = thread.wait_for(lambda s: s.engine == "compiled", timeout=600.0)
        assert moved.notice == ""
        assert moved.lesson is not None
        thread.send(Pick("agent-1", "down"))
        thread.send(Pause())
        thread.send(Step(20))
        there = thread.wait_for(lambda s: s.tick >= moved.tick + 20 and s.speed == 0.0)
        assert there.nodes["agent-1"].path == (("Shuttle", "down"),)
    finally:
        thread.close()
    assert not compilers()
    assert not [name for name in left_in(tmp_path) if "compiling" in name or "tmp" in name]
    assert ahead.is_kept(corridor, tmp_path)


def test_the_world_is_the_same_as_if_it_had_been_compiled_from_the_start(
    compiler: KernelCompiler, monkeypatch: pytest.MonkeyPatch
) -> None:
    gate = Event()
    load = ahead.load
    monkeypatch.setattr(ahead, "is_kept", lambda *_: True)
    monkeypatch.setattr(ahead, "load", lambda scenario, _: gate.wait() and load(scenario, FOLDER))
    moving = Session(project(), corridor, "alone", compiler=compiler)
    whole = Session(project(), corridor, "alone", settings=UNCOMPILED)
    for session in (moving, whole):
        session.advance(30)
    waiting = moving.advance(0)
    assert (waiting.engine, waiting.notice) == ("reference", ""), "nobody is told of what takes a moment"
    gate.set()
    done(compiler)
    assert moving.advance(0).engine == "compiled"
    assert moving.advance(0) == whole.advance(0)
    assert moving.advance(100) == whole.advance(100)


#: Where kernels that tests compiled before are.
FOLDER = ahead.writable(None)


def done(compiler: KernelCompiler) -> None:
    """Wait until all that was begun is done."""
    for wanted in compiler._wanted.values():
        wanted._thread.join()


def test_closing_in_the_middle_of_compiling_leaves_nothing_behind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    running, processes = Event(), list[subprocess.Popen[str]]()

    def start(*args: Any, **kwargs: Any) -> subprocess.Popen[str]:
        processes.append(Popen(*args, **kwargs))
        running.set()
        return processes[0]

    monkeypatch.setattr(subprocess, "Popen", start)
    compiler = KernelCompiler(folder=tmp_path)
    compiler.start(alone(), 1)
    assert running.wait(PATIENCE)
    assert "compiling" in left_in(tmp_path)[0]
    compiler.close()
    assert processes[0].returncode is not None
    assert left_in(tmp_path) == []
    assert not compilers()
    compiler.close()


def test_whoever_does_not_want_to_wait_for_a_kernel_ends_compiling_at_once(tmp_path: Path) -> None:
    said: list[str] = []
    compile_ahead(corridor, "kinematic", said.append, lambda: True, tmp_path)
    assert said == ["compiling the kernel of 'corridor', once"]
    assert left_in(tmp_path) == []
    assert not compilers()


def test_what_is_kept_or_cannot_be_compiled_is_not_compiled_ahead(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    compile_ahead(kernel_faults.unportable(), "kinematic", pytest.fail, lambda: True, tmp_path)
    monkeypatch.setattr(ahead, "is_kept", lambda *_: True)
    compile_ahead(corridor, "kinematic", pytest.fail, lambda: True, tmp_path)


def test_a_process_ends_and_tidies_up_when_the_program_that_started_it_is_gone(tmp_path: Path) -> None:
    room = tmp_path / "compiling-1"
    room.mkdir()
    command = [
        sys.executable,
        "-m",
        "app.engine.compile_kernel",
        *whereabouts(corridor),
        "kinematic",
        str(room),
    ]
    process = subprocess.Popen(command, stdin=subprocess.PIPE)
    assert process.stdin is not None
    process.stdin.close()
    assert process.wait(PATIENCE) == 1
    assert left_in(tmp_path) == []


def test_a_scenario_that_cannot_be_compiled_goes_on_uncompiled_and_says_why(compiler: KernelCompiler) -> None:
    start = replace(alone(), scenario=kernel_faults.unportable())
    nobody = replace(start.arm, top="", hierarchy=from_table((2,), ("agent",)))
    engine = compiler.start(replace(start, parameters={}, arm=nobody), 1)
    done(compiler)
    assert compiler.compiled(engine) is engine
    assert "**" in engine.obstacle
    assert engine.obstacle.endswith("; it runs uncompiled, which is slower")
    engine.step(3)
    assert engine.tick == 3


def test_a_process_that_fails_is_told_with_its_last_words(
    compiler: KernelCompiler, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(compiling, "whereabouts", lambda _: ("corridor", "tests.nowhere", "nowhere.py"))
    session = Session(project(), corridor, "alone", compiler=compiler)
    done(compiler)
    snapshot = session.advance(2)
    assert snapshot.engine == "reference"
    assert (
        "the kernel could not be compiled: ModuleNotFoundError: No module named 'tests.nowhere'"
        in snapshot.notice
    )


def test_an_engine_that_was_chosen_is_used(compiler: KernelCompiler) -> None:
    session = Session(project(), corridor, "alone", settings=UNCOMPILED, compiler=compiler)
    snapshot = session.advance(1)
    assert (snapshot.engine, snapshot.notice) == ("reference", "")
    assert not compilers()


def test_another_process_finds_the_very_same_scenario(tmp_path: Path) -> None:
    shipped = open_scenario(replace(project(), scenario="foraging"))
    assert found_again(*whereabouts(shipped)) is shipped
    assert found_again(*whereabouts(corridor)) is corridor
    (tmp_path / "scenario.py").write_text(OWN)
    own = open_scenario(replace(project(), scenario="scenario.py"), tmp_path, trust=True)
    again = found_again(*whereabouts(own))
    assert again is not own
    assert ahead.path_of(again, tmp_path) == ahead.path_of(own, tmp_path)


OWN = '''
from dataclasses import dataclass
from understudy.sim.scenario import Scenario, World, quantity, uniform

@dataclass(frozen=True, slots=True)
class Parameters:
    """What can be set."""

    length: float = quantity(100.0, "units", 1.0, 1e6, doc="the line that agents live on")

scenario = Scenario("line", "On a line", Parameters)

@scenario.behavior("Up")
def up(world: World, me: int) -> None:
    """Walk on."""
    world.drive[me] = world.params.length

@scenario.reset
def reset(world: World) -> None:
    """Put all agents somewhere."""
    for agent in range(world.agents):
        world.x[agent] = uniform(world.clock, agent, 0)
'''
