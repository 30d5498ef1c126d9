"""The decision tree says how a state decides, and where the selected node is in it."""

from dataclasses import replace
from math import ceil

import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QHelpEvent
from PySide6.QtWidgets import QApplication, QToolTip
from pytestqt.qtbot import QtBot

from app.core.automaton import START, Basic, Refit
from app.core.conditions import Equals
from app.core.edits import add_state, set_learned
from app.core.tree import Branch, Forest, Leaf, Tree
from app.editor.diagram.view import READABLE
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from app.editor.tree.node_item import NodeWords
from app.editor.tree.panel import TreePanel
from app.editor.tree.shape import ROOT, Knot
from app.editor.tree.subject import Subject
from app.engine.commands import Step
from tests.gui.conftest import PATIENCE

LEFT = Qt.MouseButton.LeftButton
FORAGE = "agent", "forage"


def at(panel: TreePanel, key: int) -> QPoint:
    return panel.view.mapFromScene(panel.scene.nodes[key].scenePos())


def learned(studio: Studio, model: object) -> None:
    studio.settings.learns_by_itself = False
    automaton = studio.document.automaton(*FORAGE)
    assert automaton is not None
    models = {**automaton.learned, "wander": model}
    studio.document.do(set_learned, *FORAGE, models, automaton.learned_from)


def test_tests_and_leaves_are_told_in_words(panel: TreePanel) -> None:
    assert panel.subject is not None
    words = {key: panel.subject.words(item.knot) for key, item in panel.scene.nodes.items()}
    assert (words[1].title, words[1].under) == ("sees a box?", "5 examples")
    assert (words[2].title, words[2].under) == ("Wander", "3 examples · p 1.0")
    assert (words[3].title, words[3].under) == ("ReturnWithBox", "2 examples · p 1.0")


def test_another_state_is_shown_when_it_is_selected(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        studio.selection.select_state("return-with-box")
    assert panel.subject is not None
    assert panel.subject.words(panel.scene.nodes[1].knot).title == "done?"


def test_when_the_state_that_is_shown_goes_start_is_shown(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    state = studio.document.do(add_state, *FORAGE, Basic("Forward"))
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        studio.selection.select_state(state)
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        studio.undo()
    assert studio.selection.state == START
    assert panel.subject is not None
    assert panel.subject.state == START


def test_clicking_a_node_selects_the_examples_that_reach_it(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    qtbot.mouseClick(panel.view.viewport(), LEFT, pos=at(panel, 3))
    chosen = [e for e in studio.document.project.examples_of(*FORAGE) if e.id in studio.selection.examples]
    assert len(chosen) == 2
    assert {example.label for example in chosen} == {"return-with-box"}


def test_arrow_keys_walk_the_tree(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    qtbot.mouseClick(panel.view.viewport(), LEFT, pos=at(panel, 1))
    qtbot.keyClick(panel.view, Qt.Key.Key_Down)
    assert panel.scene.chosen == 2
    qtbot.keyClick(panel.view, Qt.Key.Key_Right)
    assert panel.scene.chosen == 3
    qtbot.keyClick(panel.view, Qt.Key.Key_Up)
    assert panel.scene.chosen == 1


def test_enter_hides_what_is_below_a_node_and_shows_it_again(panel: TreePanel, qtbot: QtBot) -> None:
    qtbot.mouseClick(panel.view.viewport(), LEFT, pos=at(panel, 1))
    qtbot.keyClick(panel.view, Qt.Key.Key_Return)
    assert set(panel.scene.nodes) == {1}
    assert panel.scene.nodes[1].knot.hidden == 1
    qtbot.keyClick(panel.view, Qt.Key.Key_Return)
    assert set(panel.scene.nodes) == {1, 2, 3}


def test_the_path_of_the_selected_node_is_lit(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    assert studio.snapshot is not None
    studio.selection.select_nodes(studio.snapshot.place.agents[:1])
    studio.bridge.send(Step())
    qtbot.waitUntil(lambda: panel.scene.is_lit(1), timeout=PATIENCE)
    assert panel.scene.is_lit(2) is not panel.scene.is_lit(3)


def test_rules_are_listed_in_order_above_the_tree(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        studio.selection.select_behavior(BehaviorKey("authored-agent", "goto"), "forward")
    shown = [panel.rules.item(row).text() for row in range(panel.rules.count())]
    assert len(shown) == 5
    assert shown[-1] == "5.  otherwise → RotateRight"


def test_all_rules_of_a_state_that_learned_nothing_are_seen_without_scrolling(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        studio.selection.select_behavior(BehaviorKey("authored-agent", "goto"), "forward")
    assert panel.rules.count() == 5
    last = panel.rules.visualItemRect(panel.rules.item(4))
    assert panel.rules.viewport().rect().contains(last)


def test_rules_are_tried_earlier_by_alt_and_an_arrow_key_and_removed_by_delete(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    key = BehaviorKey("authored-agent", "goto")
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        studio.selection.select_behavior(key, "forward")
    panel.rules.setCurrentRow(2)
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        qtbot.keyClick(panel.rules, Qt.Key.Key_Up, Qt.KeyboardModifier.AltModifier)
    assert rule_targets(studio, key) == ["done", "forward", "done", "rotate-left", "rotate-right"]
    assert panel.rules.currentRow() == 1
    qtbot.keyClick(panel.rules, Qt.Key.Key_Delete)
    assert rule_targets(studio, key) == ["done", "done", "rotate-left", "rotate-right"]
    assert len(studio.document.history.steps) == 2


def rule_targets(studio: Studio, key: BehaviorKey) -> list[str]:
    automaton = studio.document.automaton(key.type, key.id)
    assert automaton is not None
    return [rule.target for rule in automaton.rules_of("forward")]


def test_of_a_forest_one_tree_is_chosen(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    automaton = studio.document.automaton(*FORAGE)
    assert automaton is not None
    tree, other = automaton.learned["wander"], automaton.learned["return-with-box"]
    assert isinstance(tree, Tree)
    assert isinstance(other, Tree)
    other = replace(other, labels=tree.labels)
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        learned(studio, Forest(tree.labels, (tree, other)))
    assert panel.header.which.isVisible()
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        qtbot.keyClick(panel.header.which, Qt.Key.Key_Up)
    assert panel.subject is not None
    assert panel.subject.tree is other


def full(depth: int) -> Leaf | Branch:
    """A tree that tests something on every level."""
    if depth == 0:
        return Leaf((3.0, 1.0))
    below = full(depth - 1)
    size = 2.0 ** (depth - 1)
    return Branch(test=Equals("sees", 1.0), yes=below, no=below, counts=(6.0 * size, 2.0 * size))


def large(panel: TreePanel, studio: Studio, qtbot: QtBot, depth: int) -> None:
    """Show such a tree, all of it open."""
    automaton = studio.document.automaton(*FORAGE)
    assert automaton is not None
    tree = automaton.learned["wander"]
    assert isinstance(tree, Tree)
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        learned(studio, Tree(tree.labels, full(depth)))
    for level in range(depth):
        for key in range(2**level, 2 ** (level + 1)):
            if 2 * key not in panel.scene.nodes:
                panel.view.setFocus()
                panel.choose(key)
                qtbot.keyClick(panel.view, Qt.Key.Key_Return)
    assert len(panel.scene.nodes) == 2 ** (depth + 1) - 1


def test_of_a_large_tree_what_is_in_sight_is_written(
    panel: TreePanel, studio: Studio, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[int] = []
    words = Subject.words

    def counted(subject: Subject, knot: Knot) -> NodeWords:
        told.append(knot.key)
        return words(subject, knot)

    monkeypatch.setattr(Subject, "words", counted)
    large(panel, studio, qtbot, depth=7)
    panel.grab()
    assert ROOT in told
    assert len(set(told)) < len(panel.scene.nodes) / 2


def test_a_node_seen_from_afar_says_under_the_mouse_what_it_is(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    large(panel, studio, qtbot, depth=6)
    panel.view.fit_whole()
    panel.grab()
    place = panel.view.mapFromScene(panel.scene.nodes[37].scenePos())
    hover = QHelpEvent(QEvent.Type.ToolTip, place, panel.view.viewport().mapToGlobal(place))
    QApplication.sendEvent(panel.view.viewport(), hover)
    assert "Wander 6, ReturnWithBox 2" in QToolTip.text()
    QToolTip.hideText()


def test_a_tree_that_just_fits_in_is_not_scrolled(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    large(panel, studio, qtbot, depth=2)
    view = panel.view
    beside = panel.width() - view.maximumViewportSize().width()
    panel.resize(beside + ceil(view.contents().width() * READABLE) + 2, panel.height())
    qtbot.waitUntil(
        lambda: view.scale_now == pytest.approx(READABLE) and not view.horizontalScrollBar().isVisible()
    )


def test_a_model_without_a_tree_says_so(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        learned(studio, Refit("knn"))
    assert "has no tree" in panel.message


def test_buttons_stay_under_the_mouse_whatever_they_open(panel: TreePanel, qtbot: QtBot) -> None:
    button = panel.tools.buttons["cut"]
    before = button.mapToGlobal(button.rect().center())
    for page in ("cut", ""):
        qtbot.mouseClick(button, LEFT)
        assert panel.tools.page == page
        panel.grab()  # has it laid out
        assert button.mapToGlobal(button.rect().center()) == before


def test_a_state_that_has_learned_nothing_names_those_that_have(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    automaton = studio.document.automaton(*FORAGE)
    assert automaton is not None
    studio.settings.learns_by_itself = False
    models = {state: model for state, model in automaton.learned.items() if state != START}
    studio.document.do(set_learned, *FORAGE, models, automaton.learned_from)
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        studio.selection.select_state(START)
    assert panel._message.text().endswith("choose above: Wander, ReturnWithBox.")


def test_without_a_behavior_no_state_can_be_chosen(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    assert panel.header.states.isEnabled()
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        studio.selection.select_behavior(None)
    assert not panel.header.states.isEnabled()
