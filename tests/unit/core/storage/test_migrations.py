"""Older projects are brought up one version at a time."""

import json
from pathlib import Path

import pytest

from app.core.project import Project
from app.core.storage import FilesError, load, migrations, save, saving
from app.core.storage.migrations import Documents, VersionError, migrated


def documents(version: object) -> Documents:
    return {"project.json": {"schema_version": version}, "libraries/agent/a.json": {"steps": ["made"]}}


def adding(step: str) -> migrations.Migration:
    def migrate(found: Documents) -> Documents:
        automaton = found["libraries/agent/a.json"]
        return {**found, "libraries/agent/a.json": {"steps": [*automaton["steps"], step]}}

    return migrate


REGISTRY = {1: adding("1 to 2"), 2: adding("2 to 3"), 3: adding("3 to 4")}


@pytest.mark.parametrize(
    ("version", "steps"),
    [(1, ["1 to 2", "2 to 3", "3 to 4"]), (2, ["2 to 3", "3 to 4"]), (4, [])],
)
def test_each_version_is_brought_on_step_by_step(version: int, steps: list[str]) -> None:
    found = migrated(documents(version), REGISTRY, current=4)
    assert found["libraries/agent/a.json"]["steps"] == ["made", *steps]
    assert found["project.json"]["schema_version"] == 4


def test_a_newer_version_is_refused_with_both_numbers_and_advice() -> None:
    with pytest.raises(
        VersionError, match="its schema version is 9, and this one reads versions up to 4; update"
    ):
        migrated(documents(9), REGISTRY, current=4)


def test_a_version_that_nothing_leads_on_from_is_refused() -> None:
    with pytest.raises(VersionError, match="nothing here can bring schema version 1 to version 2"):
        migrated(documents(1), {2: adding("2 to 3")}, current=3)


def test_documents_too_damaged_to_be_migrated_are_refused() -> None:
    damaged = {**documents(1), "libraries/agent/a.json": {}}
    with pytest.raises(VersionError, match="cannot be brought from schema version 1 to 2: KeyError: 'steps'"):
        migrated(damaged, REGISTRY, current=4)


@pytest.mark.parametrize("version", [0, -1, True, "1", None, 1.0])
def test_what_is_no_version_is_refused(version: object) -> None:
    with pytest.raises(VersionError, match="must be a whole number from 1 to"):
        migrated(documents(version))


def test_every_shipped_version_has_a_migration() -> None:
    assert sorted(migrations.MIGRATIONS) == list(range(1, migrations.SCHEMA_VERSION))


def upgrade(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the schema have gone on to version 2, in which notes were called remarks before."""

    def migrate(found: Documents) -> Documents:
        project = dict(found["project.json"])
        project["note"] = project.pop("remark", "")
        return {**found, "project.json": project}

    monkeypatch.setattr(migrations, "MIGRATIONS", {1: migrate})
    for module in (migrations, saving):
        monkeypatch.setattr(module, "SCHEMA_VERSION", 2)


def test_a_project_of_an_older_version_loads_and_is_saved_in_the_new_one_as_a_whole(
    folder: Path, project: Project, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = folder / "project.json"
    document = json.loads(path.read_text())
    document["remark"] = document.pop("note")
    path.write_text(json.dumps(document))
    wander = folder / "libraries/agent/wander.json"
    # As an older version might have laid it out.
    wander.write_text(json.dumps(json.loads(wander.read_text())))
    upgrade(monkeypatch)
    loaded = load(folder)
    assert loaded == project
    save(loaded, folder, loaded)
    assert json.loads(path.read_text())["schema_version"] == 2
    assert wander.read_text().startswith('{\n  "id"')
    assert load(folder) == project


def test_an_older_understudy_opens_no_newer_project(
    folder: Path, project: Project, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as newer:
        upgrade(newer)
        save(project, folder)
    (folder / "libraries/agent/wander.json").write_text('{"form": "unheard of"}')
    with pytest.raises(FilesError) as caught:
        load(folder)
    [problem] = caught.value.problems
    assert (problem.file, problem.where) == ("project.json", "schema_version")
