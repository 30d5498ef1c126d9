"""Layouts lie in files of their own, one an automaton, and come and go without touching any other file."""

from dataclasses import replace
from pathlib import Path

import pytest

from app.core.project import Project
from app.core.storage import load, save
from app.core.storage.problems import FilesError
from tests.samples import AGENT, project

FILE = "layouts/agent/goto.json"
LAYOUTS = {AGENT: {"goto": {"start": (0.0, -40.5), "forward": (120.0, 33.3)}}}


def plain() -> Project:
    return replace(project(), examples={}, moments={})


def test_a_layout_comes_back_as_it_was_saved(tmp_path: Path) -> None:
    placed = replace(plain(), layouts=LAYOUTS)
    save(placed, tmp_path)
    assert (tmp_path / FILE).is_file()
    assert load(tmp_path) == placed


def test_a_layout_that_was_forgotten_has_no_file(tmp_path: Path) -> None:
    placed = replace(plain(), layouts=LAYOUTS)
    save(placed, tmp_path)
    save(plain(), tmp_path, placed)
    assert not (tmp_path / FILE).exists()
    assert load(tmp_path) == plain()


def test_a_damaged_layout_is_named(tmp_path: Path) -> None:
    save(replace(plain(), layouts=LAYOUTS), tmp_path)
    (tmp_path / FILE).write_text('{"automaton": "goto", "states": {"start": {"x": "left", "y": 0}}}')
    with pytest.raises(FilesError, match=r"layouts/agent/goto.json: states.start.x"):
        load(tmp_path)
