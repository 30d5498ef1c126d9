"""A tree panel on the foraging project."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from app.editor.tree.panel import TreePanel
from tests.gui.conftest import PATIENCE


@pytest.fixture
def panel(studio: Studio, qtbot: QtBot) -> Iterator[TreePanel]:
    """The tree of Wander in the learned Forage."""
    studio.selection.select_behavior(BehaviorKey("agent", "forage"), "wander")
    panel = TreePanel(studio)
    qtbot.addWidget(panel)
    panel.resize(560, 640)
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        panel.show()
    yield panel
    panel.hide()
