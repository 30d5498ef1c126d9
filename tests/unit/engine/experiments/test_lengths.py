"""Results of runs of another length are found by the names of their files."""

from pathlib import Path

from app.engine.experiments.lengths import ENDING, other_lengths, results_stem


def test_the_lengths_of_an_experiment_are_found_and_none_of_another(tmp_path: Path) -> None:
    for name, ticks in (("a.b", None), ("a.b", 2000), ("a.b", 200), ("axb", 300), ("a.b-c", 400)):
        (tmp_path / f"{results_stem(name, ticks)}{ENDING}").touch()
    (tmp_path / f"{results_stem('a.b', 500)}.md").touch()
    assert other_lengths("a.b", tmp_path) == [200, 2000]
    assert other_lengths("a.b-c", tmp_path) == [400]


def test_where_there_is_no_folder_there_are_none(tmp_path: Path) -> None:
    assert other_lengths("figure3", tmp_path / "nowhere") == []
