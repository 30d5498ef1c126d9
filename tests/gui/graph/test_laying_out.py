"""Graphviz works in a process of its own, and the window goes on without it if it must."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QProcess
from pytestqt.qtbot import QtBot

from app.editor.graph.arrangement import Request, at_once
from app.editor.graph.laying_out import LayingOut
from app.editor.graph.level import MOST_LABELED
from app.editor.graph.panel import GraphPanel
from app.editor.studio import Studio
from app.engine.scenarios import open_scenario
from tests.gui.conftest import PATIENCE
from tests.gui.graph.author import Author
from tests.gui.graph.large import KEY, large

REQUEST = Request((("start", 80.0, 36.0), ("a", 80.0, 36.0)), (("start", "a", 60.0, 28.0),))
OTHER = Request((("start", 90.0, 36.0), ("b", 80.0, 36.0)), ())


@pytest.fixture
def laying_out() -> Iterator[LayingOut]:
    found = LayingOut()
    yield found
    found.close()


def process_of(laying_out: LayingOut) -> QProcess:
    return laying_out.findChildren(QProcess)[-1]


def test_an_arrangement_comes_by_itself_and_is_kept(laying_out: LayingOut, qtbot: QtBot) -> None:
    with qtbot.waitSignal(laying_out.arranged, timeout=PATIENCE) as came:
        laying_out.ask(REQUEST)
    assert came.args == [REQUEST]
    known = laying_out.known(REQUEST)
    assert known is not None
    assert known.places["start"][1] < known.places["a"][1]
    assert set(known.runs) == {("start", "a")}
    assert laying_out.is_idle


def test_what_nobody_looks_at_any_more_is_not_arranged(laying_out: LayingOut, qtbot: QtBot) -> None:
    laying_out.ask(REQUEST)
    laying_out.ask(OTHER)
    laying_out.forget_waiting()
    qtbot.waitUntil(lambda: laying_out.is_idle, timeout=PATIENCE)
    assert laying_out.known(REQUEST) is not None
    assert laying_out.known(OTHER) is None


def test_without_graphviz_states_stand_in_rows_and_the_user_is_told_once(
    laying_out: LayingOut, qtbot: QtBot
) -> None:
    told: list[str] = []
    laying_out.told.connect(told.append)
    for request in (REQUEST, OTHER):
        laying_out.warm_up()
        laying_out.ask(request)
        with qtbot.waitSignal(laying_out.arranged, timeout=PATIENCE):
            process_of(laying_out).kill()
        assert laying_out.known(request) == at_once(request)
    assert len(told) == 1
    assert "states stand in rows" in told[0]


def test_its_process_ends_with_the_studio(panel: GraphPanel, studio: Studio) -> None:
    process = process_of(panel.laying_out)
    assert process.state() is not QProcess.ProcessState.NotRunning
    studio.shut_down()
    assert process.state() is QProcess.ProcessState.NotRunning


def test_an_automaton_of_40_states_and_120_edges_is_drawn_without_labels_in_the_way(
    panel: GraphPanel, studio: Studio, author: Author
) -> None:
    project = large()
    studio.open(project, open_scenario(project), None, saved=False)
    author.show(KEY)
    assert (len(panel.scene.states), len(panel.scene.edges)) == (40, 120)
    assert len(panel.scene.edges) > MOST_LABELED
    assert not panel.scene.levels[()].is_labeled
