"""The inspector says what a node does and why, and leads to what decided."""

from collections.abc import Iterator
from functools import partial

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QTextCursor
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from app.editor.inspector.panel import EMPTY, InspectorPanel
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from app.editor.window.main_window import MainWindow
from app.engine.commands import Pause, Play, Step, Teach
from app.engine.snapshots import Mode

LEFT = Qt.MouseButton.LeftButton
NONE, CONTROL = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def panel(window: MainWindow) -> InspectorPanel:
    panel = window.docks["inspector"].widget()
    assert isinstance(panel, InspectorPanel)
    return panel


@pytest.fixture
def reader(panel: InspectorPanel, studio: Studio, qtbot: QtBot) -> "Reader":
    return Reader(panel, studio, qtbot)


class Reader:
    """Reads what the panel says, and clicks what is underlined."""

    def __init__(self, panel: InspectorPanel, studio: Studio, qtbot: QtBot) -> None:
        self.panel = panel
        self.studio = studio
        self.qtbot = qtbot

    @property
    def text(self) -> str:
        return self.panel.text.toPlainText()

    def look_at(self, node: str) -> None:
        """Select a node, and wait until the panel tells of it."""
        name = "group 1" if node.startswith("group") else f"agent {int(node.split('-')[1])}"
        self.studio.selection.select_nodes((node,))
        self.qtbot.waitUntil(lambda: name in self.text.splitlines()[0].lower() if self.text else False)

    def pass_ticks(self, ticks: int) -> None:
        """Let time pass, and wait until it has."""
        bridge = self.studio.bridge
        assert bridge.snapshot is not None
        until = bridge.snapshot.tick + ticks
        bridge.send(Step(ticks))
        self.qtbot.waitUntil(lambda: bridge.snapshot is not None and bridge.snapshot.tick == until)

    def links(self) -> Iterator[tuple[str, QPoint]]:
        """What is underlined, and where that is."""
        document, cursor = self.panel.text.document(), QTextCursor(self.panel.text.document())
        texts: dict[str, str] = {}
        places: dict[str, QPoint] = {}
        for position in range(1, document.characterCount()):
            cursor.setPosition(position)
            href = cursor.charFormat().anchorHref()
            if href:
                texts[href] = texts.get(href, "") + document.characterAt(position - 1)
                places.setdefault(href, self.panel.text.cursorRect(cursor).center())
        yield from ((texts[href].strip(), places[href]) for href in texts)

    def click(self, words: str) -> None:
        """Click the underlined words."""
        at = next(at for text, at in self.links() if text == words)
        bar = self.panel.text.verticalScrollBar()
        hidden = max(0, at.y() - self.panel.text.viewport().height() + 20)
        bar.setValue(bar.value() + hidden)
        at = next(at for text, at in self.links() if text == words)
        self.qtbot.mouseClick(self.panel.text.viewport(), LEFT, pos=at)


def test_where_nobody_is_selected_it_says_what_to_do(panel: InspectorPanel, studio: Studio) -> None:
    assert not studio.selection.nodes
    (told,) = [label for label in panel.findChildren(QLabel) if label.isVisibleTo(panel)]
    assert told.text() == EMPTY


def test_it_asks_why_and_answers_with_the_examples_that_agree(reader: Reader) -> None:
    reader.pass_ticks(40)
    reader.look_at("agent-1")
    assert reader.text.startswith("Why is agent 1 in ")
    assert "example" in reader.text
    assert "ICanSeeABox" in reader.text


def test_another_node_is_told_of_as_soon_as_it_is_selected(reader: Reader) -> None:
    reader.look_at("agent-1")
    reader.look_at("agent-7")
    reader.studio.selection.select_nodes(())
    reader.qtbot.waitUntil(lambda: not reader.panel.text.isVisibleTo(reader.panel))


def test_what_is_told_goes_on_with_the_world(reader: Reader) -> None:
    reader.look_at("agent-1")
    before = reader.text
    reader.studio.bridge.send(Play(1.0))
    reader.qtbot.waitUntil(lambda: reader.text != before)
    reader.studio.bridge.send(Pause())


def test_the_examples_that_decide_are_shown_by_a_click_or_by_ctrl_e(
    reader: Reader, window: MainWindow
) -> None:
    selection = reader.studio.selection
    reader.pass_ticks(40)
    reader.look_at("agent-1")
    reader.click(next(text for text, _ in reader.links() if text in ("Show it", "Show them")))
    by_click = selection.examples
    assert by_click
    selection.select_examples(())
    reader.qtbot.waitUntil(reader.studio.actions["behavior.show_examples"].isEnabled)
    reader.qtbot.keyClick(window, Qt.Key.Key_E, CONTROL)
    assert selection.examples
    assert window.docks["examples"].widget().isVisible()


def test_why_not_something_else_is_answered(reader: Reader) -> None:
    reader.pass_ticks(40)
    reader.look_at("agent-1")
    question = next(text for text, _ in reader.links() if text.startswith("Why not"))
    before = reader.text
    reader.click(question)
    assert len(reader.text) > len(before)


def test_it_is_not_asked_why_what_comes_next_does_not(reader: Reader) -> None:
    reader.look_at("agent-1")
    assert "Forage goes from Start to Wander" in reader.text
    assert [text for text, _ in reader.links() if text.startswith("Why not")] == ["Why not ReturnWithBox?"]


def test_a_target_that_is_one_thing_is_told_once(reader: Reader) -> None:
    plan = Teach("agent", "goto", ("agent-1",), {"X": "deposit"})
    reader.studio.bridge.send(plan)
    reader.look_at("agent-1")
    reader.qtbot.waitUntil(lambda: "DistanceTo(X)" in reader.text)
    assert "X\ndeposit\n\nDistanceTo(X)\n" in reader.text  # and nothing beside it


def test_a_click_on_an_automaton_shows_it(reader: Reader) -> None:
    reader.studio.selection.select_behavior(None)
    reader.look_at("agent-1")
    reader.click(next(text for text, _ in reader.links() if text.startswith("Forage:")))
    shown = reader.studio.selection.behavior
    assert shown is not None
    assert shown.id == "forage"


def test_who_should_not_have_left_is_corrected_from_there(reader: Reader, window: MainWindow) -> None:
    studio = reader.studio
    reader.look_at("agent-1")
    studio.selection.select_behavior(BehaviorKey("agent", "forage"))
    for modifier, mode in ((NONE, Mode.TEACHING), (Qt.KeyboardModifier.ShiftModifier, Mode.TESTING)):
        reader.qtbot.keyClick(window, Qt.Key.Key_T, modifier)
        reader.qtbot.waitUntil(partial(lambda mode: studio.mode is mode, mode))
    for _ in range(100):
        if studio.teaching.state == "return-with-box":
            break
        reader.pass_ticks(50)
    reader.qtbot.waitUntil(lambda: "It should have stayed" in reader.text)
    before = len(studio.document.project.examples_of("agent", "forage"))
    reader.click("It should have stayed")
    reader.qtbot.waitUntil(lambda: len(studio.document.project.examples_of("agent", "forage")) > before)
