"""What the tests of storage work on: a project with everything in it, and a folder that holds it."""

import os
from pathlib import Path

import pytest

from app.core.project import Project
from app.core.storage import save
from tests.unit.core.storage import every_kind


@pytest.fixture(autouse=True)
def no_waiting_for_the_disk(monkeypatch: pytest.MonkeyPatch) -> None:
    """Saves as usual, but leaves it to the system when things reach the disk: hundreds of saves are tried."""
    monkeypatch.setattr(os, "fsync", lambda _handle: None)


@pytest.fixture
def project() -> Project:
    return every_kind.project()


@pytest.fixture
def folder(tmp_path: Path, project: Project) -> Path:
    save(project, tmp_path / "project")
    return tmp_path / "project"
