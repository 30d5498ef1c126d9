"""Results on disk: what is kept, and what is refused."""

import sqlite3
from pathlib import Path

import numpy as np
import pytest

from app.engine.experiments.store import Results, ResultsError, Row
from tests.unit.engine.experiments.small import row

OURS = {"ticks": "60", "arms and factors": "abc"}


def filled(path: Path, count: int = 3) -> Path:
    with Results.open(path, OURS) as results:
        for run in range(count):
            results.add(row(0, run, {"boxes": float(run), "weight": 5.0 * run}))
    return path


def refusal(path: Path, of: dict[str, str] = OURS) -> str:
    with pytest.raises(ResultsError) as caught, Results.open(path, of) as results:
        list(results.rows(0, 10))
    return str(caught.value)


def test_a_row_comes_back_as_it_was(tmp_path: Path) -> None:
    made = Row(3, 7, 99, {"boxes": 0.1, "weight": 2.0}, True, np.array([[0.0, 0.1], [0.0, 2.0]]), 50, 0.25)
    with Results.open(tmp_path / "deep" / "r.sqlite", OURS) as results:
        results.add(made)
    with Results.open(tmp_path / "deep" / "r.sqlite", OURS) as results:
        (found,) = results.rows(3, 8)
        assert results.has(3, 7)
        assert not results.has(3, 6)
    assert found.curves.reshape(2, -1).tolist() == made.curves.tolist()
    assert (found.seed, found.measures, found.stalled) == (99, made.measures, True)
    assert (found.agent_ticks, found.seconds) == (50, 0.25)


def test_only_runs_and_cells_that_are_asked_for_count(tmp_path: Path) -> None:
    with Results.open(filled(tmp_path / "r.sqlite"), OURS) as results:
        assert (results.count(1, 3), results.count(1, 2), results.count(0, 3)) == (3, 2, 0)
        assert [found.run for found in results.rows(0, 2)] == [0, 1]
        assert (results.most(1), results.most(0)) == (3, 0)


def test_results_of_another_experiment_are_refused_with_what_differs_and_what_to_do(tmp_path: Path) -> None:
    said = refusal(filled(tmp_path / "r.sqlite"), {**OURS, "ticks": "70"})
    assert (
        "r.sqlite: these are results of another experiment; what differs: ticks; move the file away" in said
    )
    assert "--out" in said


def test_a_part_that_is_new_differs_too(tmp_path: Path) -> None:
    assert "what differs: worlds" in refusal(filled(tmp_path / "r.sqlite"), {**OURS, "worlds": "x"})


def test_a_refusal_changes_nothing(tmp_path: Path) -> None:
    path = filled(tmp_path / "r.sqlite")
    before = path.read_bytes()
    refusal(path, {})
    assert path.read_bytes() == before


@pytest.mark.parametrize("content", [b"no database at all, but long enough to look like one" * 9, b"x" * 40])
def test_a_file_that_is_no_database_is_damaged(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "r.sqlite").write_bytes(content)
    assert "r.sqlite: the file is damaged (" in refusal(tmp_path / "r.sqlite")


def test_a_file_cut_short_is_damaged(tmp_path: Path) -> None:
    path = filled(tmp_path / "r.sqlite", 200)
    path.write_bytes(path.read_bytes()[:-8192])
    assert "the file is damaged (" in refusal(path)


def test_a_page_overwritten_is_damaged(tmp_path: Path) -> None:
    path = filled(tmp_path / "r.sqlite", 200)
    content = bytearray(path.read_bytes())
    content[8192:16384] = b"\xa5" * 8192
    path.write_bytes(bytes(content))
    assert "the file is damaged (" in refusal(path)


def test_a_row_that_does_not_hold_numbers_is_damaged(tmp_path: Path) -> None:
    path = filled(tmp_path / "r.sqlite")
    connection = sqlite3.connect(path)
    with connection:
        connection.execute("UPDATE runs SET measures = '{' WHERE run = 1")
    connection.close()
    assert "damaged (cell 0, run 1: " in refusal(path)


def test_another_programs_database_is_left_alone(tmp_path: Path) -> None:
    connection = sqlite3.connect(tmp_path / "r.sqlite")
    connection.execute("CREATE TABLE precious (id)")
    connection.close()
    assert "this is no results file of an experiment" in refusal(tmp_path / "r.sqlite")


def test_results_of_a_newer_program_are_refused(tmp_path: Path) -> None:
    path = filled(tmp_path / "r.sqlite")
    connection = sqlite3.connect(path)
    with connection:
        connection.execute("UPDATE about SET value = '2' WHERE part = 'version'")
    connection.close()
    assert "it is of version 2, but this program reads 1" in refusal(path)


def test_two_programs_do_not_write_the_same_results(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    connect = sqlite3.connect
    monkeypatch.setattr(sqlite3, "connect", lambda path, **more: connect(path, timeout=0.0, **more))
    with Results.open(tmp_path / "r.sqlite", OURS):
        assert "another program is writing to it" in refusal(tmp_path / "r.sqlite")


def fill(results: Results) -> None:
    for run in range(1000):
        results.add(row(0, run, {"boxes": 1.0}))


def test_a_disk_that_fills_up_keeps_what_was_written(tmp_path: Path) -> None:
    path = tmp_path / "r.sqlite"
    with Results.open(path, OURS) as results:
        results._connection.execute("PRAGMA max_page_count = 12")
        with pytest.raises(ResultsError, match="the disk is full; all finished runs are kept: make room"):
            fill(results)
    with Results.open(path, OURS) as results:
        kept = results.count(1, 1000)
        assert 0 < kept < 1000
        assert [found.run for found in results.rows(0, 1000)] == list(range(kept))


def test_a_place_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    assert "file/r.sqlite: cannot be written: " in refusal(tmp_path / "file" / "r.sqlite")
    (tmp_path / "folder").mkdir()
    assert "folder: cannot be written: unable to open database file" in refusal(tmp_path / "folder")
