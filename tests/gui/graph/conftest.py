"""A graph panel on the foraging project."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from app.core.edits import add_automaton
from app.editor.graph.panel import GraphPanel
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from tests.gui.graph.author import Author


@pytest.fixture
def panel(studio: Studio, qtbot: QtBot) -> Iterator[GraphPanel]:
    studio.selection.select_behavior(BehaviorKey("agent", "forage"))
    panel = GraphPanel(studio)
    qtbot.addWidget(panel)
    panel.resize(700, 600)
    with qtbot.waitExposed(panel):
        panel.show()
    Author(panel, qtbot).settle()
    yield panel
    panel.hide()


@pytest.fixture
def author(panel: GraphPanel, qtbot: QtBot) -> Author:
    """A hand on it."""
    return Author(panel, qtbot)


@pytest.fixture
def blank(studio: Studio, author: Author) -> BehaviorKey:
    """An automaton without states, shown."""
    made = studio.document.do(add_automaton, "authored-agent", "Mine", ("X",))
    key = BehaviorKey("authored-agent", made)
    author.show(key)
    return key
