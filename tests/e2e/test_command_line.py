"""The command line as a user starts it: processes, signals, pipes and exit codes."""

import io
import json
import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

from app.cli.verbs import NAMES, STUDIO
from tests.unit.cli.foraging import project, stored, taught

ROOT = Path(__file__).parents[2]


def command(*arguments: str | Path) -> list[str]:
    return [sys.executable, "-P", "-m", "app", *map(str, arguments)]


def environment(**more: str) -> dict[str, str]:
    without = {
        name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")
    }
    return {**without, "PYTHONPATH": str(ROOT), **more}


def understudy(
    *arguments: str | Path, cwd: Path | None = None, **more: str
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        command(*arguments),
        capture_output=True,
        text=True,
        env=environment(**more),
        cwd=cwd,
        timeout=3000,
        check=False,
    )


@pytest.fixture
def boxes(tmp_path: Path) -> Path:
    return stored(tmp_path / "boxes")


# ---------------------------------------------------------------------------------------------------- starting


def imported_by(*arguments: str) -> set[str]:
    """The packages and modules that a start imports."""
    code = (
        "import sys; from app.cli import main; code = main(sys.argv[1:]); "
        "print(*sys.modules, file=sys.stderr)"
    )
    started = [sys.executable, "-P", "-c", code, *arguments]
    done = subprocess.run(started, capture_output=True, text=True, env=environment(), timeout=300, check=True)
    return set(done.stderr.split())


@pytest.mark.parametrize("arguments", [["--help"], ["run", "--help"], ["--version"]])
def test_help_imports_nothing_heavy(arguments: list[str]) -> None:
    # Typer itself reads a verb's options with pydantic.
    heavy = {"numpy", "scipy", "sklearn", "numba", "networkx", "pymunk", "PySide6", "pyqtgraph"}
    assert imported_by(*arguments) & heavy == set()


def test_the_list_of_verbs_needs_no_files_of_projects() -> None:
    assert "app.core.storage" not in imported_by("--help")


def test_a_run_without_a_picture_imports_no_qt(boxes: Path) -> None:
    assert imported_by("run", str(boxes), "--ticks", "2") & {"PySide6", "pyqtgraph", "sklearn"} == set()


def test_help_names_every_verb_but_the_one_that_is_meant_without_any() -> None:
    said = understudy("--help").stdout
    assert [name for name in NAMES if f" {name} " not in said] == [STUDIO]


# --------------------------------------------------------------------------------------------------- exit codes


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["trian", "x"], "no verb 'trian' (did you mean 'train'?)"),
        (["run", "BOXES", "--runs", "0"], "it must be 1 or more, but it is 0"),
        (["run", "BOXES", "--arm", "two"], "there is no arm 'two'"),
        (["run", "BOXES", "--set", "world.boxes=-1"], "boxes must be 0 or more"),
        (["check", "."], "this is no project"),
    ],
)
def test_wrong_input_is_exit_code_2_without_a_traceback(
    arguments: Sequence[str], said: str, boxes: Path
) -> None:
    done = understudy(*(str(boxes) if word == "BOXES" else word for word in arguments), cwd=boxes.parent)
    assert done.returncode == 2
    assert said in done.stdout + done.stderr
    assert "Traceback" not in done.stderr


def test_a_damaged_project_is_refused_by_file_and_line(boxes: Path) -> None:
    file = boxes / "libraries" / "agent" / "Goto.json"
    file.write_text(file.read_text()[:100])
    done = understudy("run", boxes)
    assert done.returncode == 2
    assert "libraries/agent/Goto.json: line" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write anywhere")
def test_a_folder_without_write_permission_is_named_and_nothing_is_lost(tmp_path: Path) -> None:
    folder = stored(tmp_path / "homing", taught())
    folder.chmod(0o500)
    done = understudy("demonstrate", folder)
    folder.chmod(0o700)
    assert done.returncode == 2
    assert "permission denied" in done.stderr


# --------------------------------------------------------------------------------------- pipes, signals, processes


def test_json_on_stdout_is_all_that_is_there(boxes: Path) -> None:
    done = understudy("run", boxes, "--ticks", "30", "--runs", "2", "--jobs", "2", "--json")
    assert done.returncode == 0
    assert [run["seed"] for run in json.loads(done.stdout)["runs"]] == [1, 2]
    # A slow machine is told how far it is, and one that has never run it that it compiles; nothing else is said.
    assert all(line.startswith("understudy: ") for line in done.stderr.splitlines())


def test_a_reader_that_goes_away_gets_no_traceback(boxes: Path) -> None:
    reading, writing = os.pipe()
    os.close(reading)
    with os.fdopen(writing, "w") as pipe:
        done = subprocess.run(
            command("check", boxes),
            stdout=pipe,
            stderr=subprocess.PIPE,
            text=True,
            env=environment(),
            check=False,
        )
    assert (done.returncode, done.stderr) == (1, "")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="only Linux has a disk that is always full")
def test_output_on_a_full_disk_gets_a_message(boxes: Path) -> None:
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            command("check", boxes),
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            env=environment(),
            check=False,
        )
    assert done.returncode == 1
    assert done.stderr == "understudy: the output cannot be written: No space left on device\n"


#: The bar as it begins, and as soon as it can tell how much time is left.
BEGINNING, UNDER_WAY = re.compile(rb"Running"), re.compile(rb"\d:\d\d:\d\d")


@contextmanager
def running(boxes: Path, engine: str, **more: str) -> Iterator[tuple[subprocess.Popen[bytes], io.FileIO]]:
    """Two endless runs on a terminal of their own. The terminal ends once no process holds it any more."""
    ours, theirs = os.openpty()
    started = subprocess.Popen(
        command(
            "run", boxes, "--ticks", "30000000", "--runs", "2", "--jobs", "2", "--set", f"engine={engine}"
        ),
        stdout=subprocess.DEVNULL,
        stderr=theirs,
        env=environment(TERM="xterm", COLUMNS="80", **more),
        start_new_session=True,
    )
    os.close(theirs)
    with os.fdopen(ours, "rb", buffering=0) as terminal:
        yield started, terminal
    started.wait(timeout=300)


@pytest.mark.parametrize(
    ("engine", "moment"),
    [("compiled", UNDER_WAY), ("reference", UNDER_WAY), ("reference", BEGINNING)],
    ids=["threads", "processes", "processes as they start"],
)
def test_ctrl_c_ends_the_program_and_all_its_processes(
    engine: str, moment: re.Pattern[bytes], boxes: Path
) -> None:
    """As a terminal sends it: to the whole process group."""
    with running(boxes, engine) as (started, terminal):
        said = read_until(terminal, moment)
        os.killpg(started.pid, signal.SIGINT)
        said += read_until(terminal)
    assert started.returncode == 130
    assert b"understudy: interrupted" in said
    assert b"Traceback" not in said


@pytest.mark.parametrize("engine", ["compiled", "reference"])
def test_ctrl_c_pressed_again_and_again_ends_all_of_it_without_a_word_too_many(
    engine: str, boxes: Path
) -> None:
    with running(boxes, engine) as (started, terminal):
        said = read_until(terminal, UNDER_WAY)
        while started.returncode is None:
            with suppress(subprocess.TimeoutExpired, ProcessLookupError):
                os.killpg(started.pid, signal.SIGINT)
                started.wait(timeout=0.02)
        said += read_until(terminal)
    assert started.returncode == 130
    assert b"Traceback" not in said
    assert b"Warning" not in said
    assert said.endswith(b"interrupted\r\n")
    assert said.rindex(b"\x1b[?25h") > said.rindex(b"\x1b[?25l"), "the cursor is back"


def test_ctrl_c_while_a_kernel_is_compiled_leaves_nothing_of_it(boxes: Path, tmp_path: Path) -> None:
    with running(boxes, "compiled", XDG_CACHE_HOME=str(tmp_path / "cold")) as (started, terminal):
        said = read_until(terminal, re.compile(rb"compiling the kernel"))
        os.killpg(started.pid, signal.SIGINT)
        said += read_until(terminal)
    assert started.returncode == 130
    assert b"understudy: interrupted" in said
    assert b"Traceback" not in said
    assert [path for path in tmp_path.glob("cold/**/*") if path.is_file()] == []


def test_no_process_outlives_a_program_that_is_killed(boxes: Path) -> None:
    with running(boxes, "reference") as (started, terminal):
        read_until(terminal, UNDER_WAY)
        started.kill()
        read_until(terminal)
    assert started.returncode == -signal.SIGKILL


def read_until(terminal: io.FileIO, words: re.Pattern[bytes] | None = None) -> bytes:
    """What comes from a terminal up to *words*, or to its end."""
    said = b""
    while words is None or not words.search(said):
        try:
            more = terminal.read(4096)
        except OSError:  # Linux: nobody holds the other end any more
            break
        if not more:
            break
        said += more
    return said


# ----------------------------------------------------------------------------------------------------- no verb


def test_without_a_display_the_demonstration_ends_with_numbers_and_a_picture(tmp_path: Path) -> None:
    folder = stored(tmp_path / "homing", taught())
    done = understudy(folder, "--ticks", "50", cwd=tmp_path)
    assert done.returncode == 0
    assert "learned again from" in done.stdout
    assert "boxes" in done.stdout
    assert (tmp_path / "understudy-demonstration.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("code", "said"),
    [
        ("raise ImportError('libEGL.so.1: cannot open shared object file')", "libEGL.so.1"),
        ("import os; os.abort()", "Qt could not start"),
    ],
)
def test_where_qt_does_not_load_the_numbers_come_and_a_line_says_what_is_missing(
    code: str, said: str, tmp_path: Path
) -> None:
    (tmp_path / "broken" / "PySide6").mkdir(parents=True)
    (tmp_path / "broken" / "PySide6" / "__init__.py").write_text(code)
    folder = stored(tmp_path / "homing", taught())
    path = os.pathsep.join((str(tmp_path / "broken"), str(ROOT)))
    done = understudy(folder, "--ticks", "20", cwd=tmp_path, PYTHONPATH=path)
    assert done.returncode == 1
    assert "3 agents" in done.stdout
    assert said in done.stderr.splitlines()[-1]
    assert "understudy doctor" in done.stderr
    assert "Traceback" not in done.stderr


def test_without_a_clone_or_a_terminal_nothing_depends_on_the_current_folder(tmp_path: Path) -> None:
    (tmp_path / "app").mkdir()
    (tmp_path / "app" / "__init__.py").write_text("raise SystemExit('the wrong app')")
    assert understudy("--version", cwd=tmp_path).returncode == 0


@pytest.mark.slow
def test_with_nothing_said_the_shipped_library_is_learned_again_and_run(tmp_path: Path) -> None:
    done = understudy("--ticks", "20", cwd=tmp_path)
    assert done.returncode == 0
    assert "8 behaviors learned again from" in done.stdout
    assert [name in done.stdout for name in ("independent", "one level", "two levels")] == [True] * 3
    assert (tmp_path / "understudy-demonstration.png").exists()


def test_three_structures_run_at_once(tmp_path: Path) -> None:
    folder = stored(tmp_path / "p", project())
    done = understudy(folder, "--ticks", "2000", "--picture", tmp_path / "x.svg", cwd=tmp_path)
    assert done.returncode == 0
    assert [name in done.stdout for name in ("independent", "one level", "two levels")] == [True] * 3
    assert (tmp_path / "x.svg").read_text().count("<svg") == 1
