"""No verb: the demonstration in numbers."""

from dataclasses import replace
from pathlib import Path

import pytest

from app.cli import main
from app.cli.opening import Opened
from app.cli.places import display, shipped_project
from app.cli.studio import rows, story, teach
from app.core.errors import StorageError
from app.core.storage import load
from app.editor.drawing.figures import Figure
from app.engine.runs import Curve, RunResult
from app.sim.scenarios.foraging import scenario as foraging
from tests.unit.cli.foraging import ARMS, project, stored, taught


@pytest.fixture(autouse=True)
def no_display(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[tuple[Figure, Path]]:
    """Figures and where they were to go; the current folder is an empty one."""
    figures: list[tuple[Figure, Path]] = []
    monkeypatch.setattr("app.cli.run.draw", lambda figure, path, **_: figures.append((figure, path)))
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    return figures


def result(boxes: float) -> RunResult:
    measures = {"boxes": boxes, "weight": 5 * boxes}
    return RunResult(1, 10, measures, boxes == 0.0, Curve((0,), dict.fromkeys(measures, (0.0,))), {})


def test_without_a_display_the_demonstration_runs_and_ends_with_numbers_and_a_picture(
    no_display: None,
    drawn: list[tuple[Figure, Path]],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    folder = stored(tmp_path / "homing", taught())
    assert main([str(folder), "--ticks", "20"]) == 0
    out, err = capsys.readouterr()
    assert "there is no display for a window" in err
    assert "1 behavior learned again from" in out
    assert "independent   3 agents" in out
    assert "one run of 20 ticks each (seed 1)" in out
    assert "picture: understudy-demonstration.png" in err
    ((figure, path),) = drawn
    assert path == Path("understudy-demonstration.png")
    assert figure.title == "Box foraging with 3 agents"


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> list[tuple[Path, bool]]:
    """What the window was opened on, and whether its code is trusted; there is a display."""
    opened: list[tuple[Path, bool]] = []

    def run(folder: Path, _settings: Path, _state: Path, *, trust: bool) -> int:
        opened.append((folder, trust))
        return 0

    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setattr("app.editor.application.run", run)
    return opened


def test_with_a_display_the_window_opens_on_the_foraging_project(opened: list[tuple[Path, bool]]) -> None:
    assert main([]) == 0
    assert opened == [(shipped_project("foraging"), False)]


@pytest.mark.parametrize("file", ["", "project.json"])
def test_a_path_opens_the_window_on_another_project(
    opened: list[tuple[Path, bool]], tmp_path: Path, file: str
) -> None:
    folder = stored(tmp_path / "p", project(ARMS[:1]))
    assert main([str(folder / file), "--trust"]) == 0
    assert opened == [(folder, True)]


def test_no_window_opens_on_what_is_no_project(
    opened: list[tuple[Path, bool]], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([str(tmp_path / "nowhere")]) == 2
    assert "there is no such folder" in capsys.readouterr().err
    assert opened == []


def test_headless_means_no_window_although_there_is_a_display(
    opened: list[tuple[Path, bool]], drawn: list[tuple[Figure, Path]], tmp_path: Path
) -> None:
    assert main([str(stored(tmp_path / "homing", taught())), "--headless", "--ticks", "2"]) == 0
    assert opened == []
    assert len(drawn) == 1


def test_the_stored_project_stays_as_it_is(drawn: list[tuple[Figure, Path]], tmp_path: Path) -> None:
    folder = stored(tmp_path / "homing", taught())
    before = {file: file.read_bytes() for file in folder.rglob("*") if file.is_file()}
    main([str(folder), "--ticks", "2"])
    assert {file: file.read_bytes() for file in folder.rglob("*") if file.is_file()} == before


def test_at_most_the_first_three_arms_are_shown(
    drawn: list[tuple[Figure, Path]], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arms = (*ARMS, replace(ARMS[0], name="a fourth"))
    main([str(stored(tmp_path / "p", project(arms))), "--ticks", "2"])
    out = capsys.readouterr().out
    assert "two levels" in out
    assert "a fourth" not in out
    assert [world.title for world in drawn[0][0].worlds] == ["independent", "one level", "two levels"]


def test_a_picture_goes_where_the_user_wants_it(drawn: list[tuple[Figure, Path]], tmp_path: Path) -> None:
    main([str(stored(tmp_path / "p", project(ARMS[:1]))), "--ticks", "2", "--picture", "x.svg"])
    assert drawn[0][1] == Path("x.svg")


def test_where_nothing_can_be_written_the_picture_goes_to_a_temporary_folder(
    drawn: list[tuple[Figure, Path]],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    folder = stored(tmp_path / "p", project(ARMS[:1]))
    monkeypatch.setattr("app.cli.studio.writable", lambda _: False)
    assert main([str(folder), "--ticks", "2"]) == 0
    path = drawn[0][1]
    assert path.is_absolute()
    assert str(path.parent) in capsys.readouterr().err
    path.parent.rmdir()


def test_learning_again_from_the_same_demonstrations_gives_just_what_is_stored(tmp_path: Path) -> None:
    folder = stored(tmp_path / "homing", taught())
    first = teach(Opened(folder, load(folder), foraging))
    assert not first.same
    again = teach(first.opened)
    assert again.same
    assert "just what is stored" in story(again)
    assert again.examples > 0


def test_a_project_without_demonstrations_runs_as_it_is_stored(tmp_path: Path) -> None:
    taught_so = teach(Opened(tmp_path, project(), foraging))
    assert taught_so.opened.project == project()
    assert "no demonstrations to learn from" in story(taught_so)


def test_arms_are_a_table() -> None:
    assert rows([(ARMS[0], result(3.0)), (ARMS[1], result(0.0))]) == [
        ["independent", "10 agents", "3", "15", ""],
        ["one level", "10 agents, 2 controllers", "0", "0", "yes"],
    ]


@pytest.mark.parametrize(
    ("environment", "screen"),
    [({}, ""), ({"DISPLAY": ":1"}, ":1"), ({"WAYLAND_DISPLAY": "wayland-0", "DISPLAY": ":1"}, "wayland-0")],
)
def test_a_display_is_known_by_its_variable(
    environment: dict[str, str], screen: str, no_display: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert display() == screen


def test_a_shipped_project_that_is_missing_is_named_with_its_places() -> None:
    with pytest.raises(StorageError, match=r"'no-such' is missing; looked for it in .*projects.no-such and "):
        shipped_project("no-such")


def test_a_project_without_arms_has_nothing_to_show(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([str(stored(tmp_path / "p", project(())))]) == 2
    assert "has no arms" in capsys.readouterr().err
