"""Copying states: with their transitions, into other automata and node types."""

from itertools import combinations

import pytest
from PySide6.QtCore import QPoint, QRectF, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QPushButton
from pytestqt.qtbot import QtBot

from app.core.automaton import Basic, Nested
from app.core.check import check
from app.core.edits import add_automaton, add_state, duplicate_automaton
from app.core.features import Ground
from app.editor.graph.editing import ELSEWHERE, LEARNED_COPIED, NOTHING_COPIED
from app.editor.graph.panel import GraphPanel
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from app.editor.window.main_window import MainWindow
from tests.gui.graph.author import CTRL, Author, automaton

AUTHORED = BehaviorKey("authored-agent", "forage")


def test_states_are_duplicated_with_their_transitions(author: Author) -> None:
    author.show(AUTHORED)
    author.click(author.named("Wander"))
    author.click(("return-with-box",), keys=CTRL)
    author.key(Qt.Key.Key_D, CTRL)
    found = automaton(author)
    assert len(found.states) == 5
    assert len(found.rules) == 5
    assert len(author.panel.scene.selected) == 2


@pytest.mark.parametrize("by_hand", [False, True])
def test_duplicates_cover_no_state(author: Author, by_hand: bool) -> None:
    if by_hand:
        place = author.at(author.named("Wander"))
        author.drag(place, place + QPoint(12, 0))
    author.click(author.named("Wander"))
    author.click(("return-with-box",), keys=CTRL)
    author.key(Qt.Key.Key_D, CTRL)
    level = author.panel.scene.levels[()]
    assert len(level.places) == 5
    boxes = [
        QRectF(x - width / 2, y - height / 2, width, height)
        for state, (x, y) in level.places.items()
        for width, height in [level.sizes[state]]
    ]
    assert not [(a, b) for a, b in combinations(boxes, 2) if a.intersects(b)]


def test_states_are_copied_into_another_automaton(author: Author, blank: BehaviorKey) -> None:
    author.show(AUTHORED)
    author.click(author.named("Wander"))
    author.click(("return-with-box",), keys=CTRL)
    author.key(Qt.Key.Key_C, CTRL)
    author.show(blank)
    author.key(Qt.Key.Key_V, CTRL)
    found = automaton(author)
    assert [state.content for state in found.states[1:]] == [Nested("wander"), Nested("return-with-box")]
    assert [(rule.source, rule.target) for rule in found.rules] == [
        ("wander", "return-with-box"),
        ("return-with-box", "wander"),
    ]


def test_copies_are_in_sight_once_they_are_arranged(author: Author) -> None:
    author.panel.resize(390, 380)
    author.click(author.named("Wander"))
    author.key(Qt.Key.Key_C, CTRL)
    author.show(BehaviorKey("agent", "return-with-box"))
    author.key(Qt.Key.Key_V, CTRL)
    (copy,) = author.panel.scene.selected
    box = author.panel.scene.states[copy]
    seen = author.panel.view.mapFromScene(box.mapRectToScene(box.box)).boundingRect()
    assert author.panel.view.viewport().rect().contains(seen)


def test_what_copied_states_learned_comes_along_as_rules(author: Author, studio: Studio) -> None:
    top = studio.document.do(add_automaton, "agent", "Top")
    author.click(author.named("Wander"))
    author.click(("return-with-box",), keys=CTRL)
    author.key(Qt.Key.Key_C, CTRL)
    author.show(BehaviorKey("agent", top))
    with author.qtbot.waitSignal(studio.said) as said:
        author.key(Qt.Key.Key_V, CTRL)
    assert said.args is not None
    assert said.args[0].text == LEARNED_COPIED
    shown = {key[1:]: item.edge.rules[0].words for key, item in author.panel.scene.edges.items()}
    assert shown["wander", "return-with-box"] == "sees a box"
    assert shown["return-with-box", "wander"] == "done"


def test_states_of_an_automaton_that_is_gone_are_pasted_as_they_were(
    author: Author, studio: Studio, blank: BehaviorKey
) -> None:
    gone = studio.document.do(add_automaton, "agent", "Gone")
    studio.document.do(add_state, "agent", gone, Basic("Forward"))
    author.show(BehaviorKey("agent", gone))
    author.click(author.named("Forward"))
    author.key(Qt.Key.Key_C, CTRL)
    studio.undo()
    studio.undo()
    author.show(blank)
    author.key(Qt.Key.Key_V, CTRL)
    assert [state.content for state in automaton(author).states[1:]] == [Basic("Forward")]
    assert studio.document.automaton("agent", gone) is None


def test_states_copied_to_another_node_type_bring_along_what_that_lacks(
    author: Author, blank: BehaviorKey, studio: Studio
) -> None:
    stroll = studio.document.do(duplicate_automaton, "agent", "wander", "Stroll")
    top = studio.document.do(add_automaton, "agent", "Top")
    for held in ("forage", stroll):
        studio.document.do(add_state, "agent", top, Nested(held))
    author.show(BehaviorKey("agent", top))
    author.click(("forage",))
    author.click(("stroll",), keys=CTRL)
    author.key(Qt.Key.Key_C, CTRL)
    author.show(blank)
    with author.qtbot.waitSignal(studio.said) as said:
        author.key(Qt.Key.Key_V, CTRL)
    assert said.args is not None
    assert said.args[0].text == "Stroll came along to authored-agent, since the states hold it"
    assert [state.content for state in automaton(author).states[1:]] == [Nested("forage"), Nested("stroll")]
    assert len(studio.document.project.examples_of("authored-agent", "stroll")) == 10
    studio.undo()
    assert studio.document.automaton("authored-agent", "stroll") is None


def test_states_that_were_removed_since_are_pasted_as_they_were(author: Author, blank: BehaviorKey) -> None:
    author.show(AUTHORED)
    author.click(author.named("Wander"))
    author.click(("return-with-box",), keys=CTRL)
    author.key(Qt.Key.Key_C, CTRL)
    author.key(Qt.Key.Key_Delete)
    assert [state.id for state in automaton(author).states] == ["start"]
    author.show(blank)
    author.key(Qt.Key.Key_V, CTRL)
    found = automaton(author)
    assert [state.content for state in found.states[1:]] == [Nested("wander"), Nested("return-with-box")]
    assert len(found.rules) == 2
    library = author.panel.studio.document.project.library("authored-agent")
    assert len({one.name for one in library.automata.values()}) == len(library.automata)


def test_states_of_another_project_are_not_taken_for_those_of_this_one(
    author: Author, studio: Studio
) -> None:
    author.click(author.named("Wander"))
    author.key(Qt.Key.Key_C, CTRL)
    studio.open(studio.document.project, studio.document.scenario, None)
    author.show(AUTHORED)
    before = automaton(author)
    with author.qtbot.waitSignal(studio.said) as said:
        author.key(Qt.Key.Key_V, CTRL)
    assert said.args is not None
    assert said.args[0].text == ELSEWHERE
    assert automaton(author) is before


def test_what_looks_through_a_parameter_stays_behind_where_there_is_none_and_what_was_learned_there_stays(
    author: Author, studio: Studio
) -> None:
    author.show(BehaviorKey("agent", "goto"))
    author.click(author.named("Forward"))
    author.key(Qt.Key.Key_C, CTRL)
    taught = BehaviorKey("agent", "return-with-box")
    author.show(taught)
    before = automaton(author)
    with author.qtbot.waitSignal(studio.said) as said:
        author.key(Qt.Key.Key_V, CTRL)
    assert said.args is not None
    words = "transitions that look at DistanceTo(X) or DirectionTo(X) did not: ReturnWithBox cannot see that"
    assert words in said.args[0].text
    after = automaton(author)
    assert (len(after.states), after.features) == (len(before.states) + 1, before.features)
    assert not [
        p
        for p in check(studio.document.project, studio.document.scenario.vocabulary)
        if "example" in p.message
    ]


def test_what_the_other_node_type_cannot_see_stays_behind_and_it_is_said(
    author: Author, studio: Studio
) -> None:
    group = BehaviorKey("group", studio.document.do(add_automaton, "group", "Lead"))
    author.click(author.named("Wander"))
    author.click(("return-with-box",), keys=CTRL)
    author.key(Qt.Key.Key_C, CTRL)
    author.show(group)
    with author.qtbot.waitSignal(studio.said) as said:
        author.key(Qt.Key.Key_V, CTRL)
    assert said.args is not None
    words = "transitions that look at ICanSeeABox did not: Lead cannot see that"
    assert said.args[0].text == f"{LEARNED_COPIED}; {words}"
    found = studio.document.automaton("group", group.id)
    assert found is not None
    assert [use.shown for use in found.features] == ["done"]


@pytest.fixture
def lacking(window: MainWindow, qtbot: QtBot) -> Author:
    """A state that is bound to the parameter X was copied into Forage, which has none."""
    panel = window.docks["graph"].widget()
    assert isinstance(panel, GraphPanel)
    author = Author(panel, qtbot)
    author.show(BehaviorKey("agent", "gather-at"))
    author.click(("goto",))
    author.key(Qt.Key.Key_C, CTRL)
    author.show(BehaviorKey("agent", "forage"))
    author.key(Qt.Key.Key_V, CTRL)
    return author


def test_what_copied_states_are_bound_to_and_nobody_gives_them_is_told_and_added_by_a_click(
    lacking: Author, window: MainWindow, studio: Studio
) -> None:
    messages = window.messages
    assert "Goto(X) is bound to the parameter 'X', which Forage lacks: add it" in messages.words.text()
    before = studio.document.project
    add = next(button for button in messages.findChildren(QPushButton) if button.text() == "Add 'X'")
    lacking.qtbot.mouseClick(add, Qt.MouseButton.LeftButton)
    assert automaton(lacking).parameters == ("X",)
    assert not messages.isVisible()
    studio.undo()
    assert studio.document.project is before


def test_what_copied_states_are_bound_to_can_be_chosen_from_the_notice(
    lacking: Author, window: MainWindow, studio: Studio
) -> None:
    bind = next(b for b in window.messages.findChildren(QPushButton) if b.text() == "Bind it…")
    lacking.qtbot.mouseClick(bind, Qt.MouseButton.LeftButton)
    lacking.qtbot.waitUntil(lacking.panel.form.isVisible)
    lacking.choose(lacking.panel.form.state.slots["X"], "deposit")
    assert automaton(lacking).states[-1].content == Nested("goto", {"X": Ground("deposit")})


def test_the_notice_goes_once_the_copies_are_taken_back(
    lacking: Author, window: MainWindow, studio: Studio
) -> None:
    assert window.messages.isVisible()
    studio.undo()
    lacking.qtbot.waitUntil(lambda: not window.messages.isVisible())


def test_pasting_is_offered_while_copied_states_are_in_the_clipboard_and_else_says_why_not(
    author: Author, studio: Studio
) -> None:
    QGuiApplication.clipboard().setText("words")
    author.show(AUTHORED)
    paste = studio.actions["graph.paste"]
    assert not paste.isEnabled()
    assert f"Not now: {NOTHING_COPIED}" in paste.toolTip()
    author.click(author.named("Wander"))
    author.key(Qt.Key.Key_C, CTRL)
    assert paste.isEnabled()
    assert "Not now" not in paste.toolTip()
    QGuiApplication.clipboard().setText("words")
    assert not paste.isEnabled()


def test_start_is_not_offered_for_copying_and_its_key_says_why(author: Author, studio: Studio) -> None:
    said: list[str] = []
    studio.said.connect(lambda message: said.append(message.text))
    author.show(AUTHORED)
    author.click(("start",))
    assert not studio.actions["graph.copy"].isEnabled()
    author.key(Qt.Key.Key_C, CTRL)
    assert any("Start is in every automaton" in text for text in said)
