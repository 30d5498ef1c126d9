"""A project that version 1 wrote loads for ever, and is not rewritten without need."""

import json
import shutil
from pathlib import Path

import pytest

from app.core.storage import SCHEMA_VERSION, load, save
from tests.unit.core.storage import every_kind
from tests.unit.core.storage.folders import contents

GOLDEN = Path(__file__).parents[3] / "golden"


def test_every_version_has_a_golden_project() -> None:
    versions = [
        json.loads(path.read_text())["schema_version"]
        for path in sorted(GOLDEN.glob("project-v*/project.json"))
    ]
    assert versions == list(range(1, SCHEMA_VERSION + 1))


@pytest.mark.parametrize("folder", sorted(GOLDEN.glob("project-v*")), ids=lambda folder: folder.name)
def test_a_golden_project_loads_as_what_it_was(folder: Path) -> None:
    assert load(folder) == every_kind.project()


def test_the_newest_golden_project_is_saved_byte_for_byte(tmp_path: Path) -> None:
    newest = GOLDEN / f"project-v{SCHEMA_VERSION}"
    save(load(newest), tmp_path / "loaded")
    assert contents(tmp_path / "loaded") == contents(newest)
    save(every_kind.project(), tmp_path / "made")
    assert contents(tmp_path / "made") == contents(newest)


def test_an_upgrade_leaves_nothing_of_the_old_form(tmp_path: Path) -> None:
    """Whatever the version was, what is saved over it is all in the newest form."""
    for folder in sorted(GOLDEN.glob("project-v*")):
        copy = tmp_path / folder.name
        shutil.copytree(folder, copy)
        before = load(copy)
        save(before, copy, before)
        assert contents(copy) == contents(GOLDEN / f"project-v{SCHEMA_VERSION}")
