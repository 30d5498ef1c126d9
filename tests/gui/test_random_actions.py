"""Whatever a user does by chance can be taken back, down to the last byte, and the window lives on."""

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from app.core.project import Project
from app.core.storage import save
from app.editor.window.main_window import MainWindow
from tests.gui.random_user import RandomUser
from tests.gui.teach.hand import Hand

ACTS = 70


@pytest.mark.parametrize("seed", range(6))
def test_undoing_random_actions_brings_the_same_project_back(
    window: MainWindow, qtbot: QtBot, tmp_path: Path, seed: int
) -> None:
    user = RandomUser(window, qtbot, seed)
    user.settle()
    before = user.studio.document.project
    saved = files_of(before, tmp_path / "before")
    for _ in range(ACTS):
        user.act_once()
    undo_all(user)
    told = "\n".join(user.did)
    assert user.studio.document.project == before, told
    assert files_of(user.studio.document.project, tmp_path / "after") == saved, told
    assert not user.errors, told
    assert window.isVisible()
    assert not user.snapshot.failure, told


def undo_all(user: Hand) -> None:
    """Press Ctrl+Z until there is nothing left to undo; each time takes back one step."""
    history = user.studio.document.history
    while history.can_undo:
        steps = len(history.steps)
        user.undo()
        assert len(history.steps) < steps, history.undo_text


def files_of(project: Project, folder: Path) -> dict[str, bytes]:
    """What a project looks like on disk."""
    save(project, folder)
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
