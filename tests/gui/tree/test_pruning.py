"""What was learned is pruned by hand: leaves, subtrees, labels, weak transitions, cuts; all can be taken back."""

import pytest
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from app.core.automaton import Automaton
from app.core.conditions import AtMost, InArc
from app.core.tree import Branch, Tree
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from app.editor.tree.panel import TreePanel
from tests.gui.conftest import PATIENCE

LEFT = Qt.MouseButton.LeftButton
FORAGE, GOTO = BehaviorKey("agent", "forage"), BehaviorKey("agent", "goto")


def automaton(studio: Studio, key: BehaviorKey) -> Automaton:
    found = studio.document.automaton(key.type, key.id)
    assert found is not None
    return found


def tree_of(studio: Studio, key: BehaviorKey, state: str) -> Tree:
    tree = automaton(studio, key).learned[state]
    assert isinstance(tree, Tree)
    return tree


def click(panel: TreePanel, qtbot: QtBot, key: int) -> None:
    qtbot.mouseClick(panel.view.viewport(), LEFT, pos=place(panel, key))


def place(panel: TreePanel, key: int) -> QPoint:
    return panel.view.mapFromScene(panel.scene.nodes[key].scenePos())


def show(panel: TreePanel, studio: Studio, qtbot: QtBot, key: BehaviorKey, state: str) -> None:
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        studio.selection.select_behavior(key, state)


def learned_again(studio: Studio, qtbot: QtBot, key: BehaviorKey) -> None:
    """Learn all from the examples, and wait for it."""
    studio.relearning.learn()
    qtbot.waitUntil(lambda: not studio.relearning.busy, timeout=PATIENCE)
    assert automaton(studio, key).learned


def test_a_leaf_is_pruned_by_delete_and_the_prune_is_kept_by_learning(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    click(panel, qtbot, 3)
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        qtbot.keyClick(panel.view, Qt.Key.Key_Delete)
    (prune,) = automaton(studio, FORAGE).prunes
    assert prune.forbidden == {"return-with-box"}
    assert panel.subject is not None
    assert panel.subject.words(panel.scene.nodes[3].knot).under == "2 examples · pruned"
    learned_again(studio, qtbot, FORAGE)
    assert automaton(studio, FORAGE).prunes == (prune,)
    studio.undo()
    assert automaton(studio, FORAGE).prunes == ()


def test_where_all_stay_there_is_nothing_to_prune(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    click(panel, qtbot, 2)
    with qtbot.waitSignal(studio.said, timeout=PATIENCE) as said:
        qtbot.keyClick(panel.view, Qt.Key.Key_Delete)
    assert "no transition to prune" in said.args[0].text
    assert not studio.document.history.can_undo


def test_one_label_of_a_subtree_is_pruned_by_the_context_menu(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    show(panel, studio, qtbot, GOTO, "forward")
    click(panel, qtbot, 1)
    panel.view.menu_wanted.emit(panel.view.mapToGlobal(place(panel, 1)))
    menu = panel.menu
    assert menu is not None
    action = next(a for a in menu.actions() if a.text() == "Never to RotateLeft here")
    qtbot.mouseClick(menu, LEFT, pos=menu.actionGeometry(action).center())
    (prune,) = automaton(studio, GOTO).prunes
    assert (prune.source, prune.guard) == ("forward", ())
    assert prune.forbidden == {"rotate-left"}


def test_a_subtree_is_pruned_and_taken_back_from_the_menu(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    show(panel, studio, qtbot, GOTO, "forward")
    before = studio.document.project
    inner = next(
        key for key, node in panel.scene.nodes.items() if isinstance(node.knot.node, Branch) and key > 1
    )
    click(panel, qtbot, inner)
    qtbot.waitUntil(studio.actions["tree.prune"].isEnabled)
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        studio.actions["tree.prune"].trigger()
    (prune,) = automaton(studio, GOTO).prunes
    assert prune.guard
    assert "forward" not in prune.forbidden
    qtbot.waitUntil(studio.actions["tree.take_back"].isEnabled)
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        studio.actions["tree.take_back"].trigger()
    assert automaton(studio, GOTO).prunes == ()
    studio.undo()
    studio.undo()
    assert studio.document.project is before


def test_prunes_are_listed_and_taken_back_there(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    click(panel, qtbot, 3)
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        qtbot.keyClick(panel.view, Qt.Key.Key_Delete)
    button = panel.tools.buttons["prunes"]
    assert button.text() == "Prunes 1"
    qtbot.mouseClick(button, LEFT)
    assert panel.tools.prunes.listed.item(0).text() == "Wander: never to ReturnWithBox when sees a box"
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        qtbot.mouseClick(panel.tools.prunes.back, LEFT)
    assert automaton(studio, FORAGE).prunes == ()
    assert button.text() == "Prunes"


def test_delete_takes_back_in_the_list(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    click(panel, qtbot, 3)
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        qtbot.keyClick(panel.view, Qt.Key.Key_Delete)
    panel.tools.open("prunes")
    qtbot.keyClick(panel.tools.prunes.listed, Qt.Key.Key_Delete)
    assert automaton(studio, FORAGE).prunes == ()


def test_enter_in_the_list_shows_the_state_that_a_prune_is_about(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    click(panel, qtbot, 3)
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        qtbot.keyClick(panel.view, Qt.Key.Key_Delete)
    studio.selection.select_state("return-with-box")
    panel.tools.open("prunes")
    qtbot.keyClick(panel.tools.prunes.listed, Qt.Key.Key_Return)
    assert studio.selection.state == "wander"


def test_weak_transitions_are_pruned_together_as_one_step(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    panel.tools.open("prunes")
    page = panel.tools.prunes
    page.support.setFocus()
    page.support.selectAll()
    qtbot.keyClicks(page.support, "3")
    qtbot.mouseClick(page.weak, LEFT)
    assert len(automaton(studio, FORAGE).prunes) == 3
    studio.undo()
    assert automaton(studio, FORAGE).prunes == ()


def test_a_cut_is_dragged_on_the_histogram_and_stands_whatever_is_learned(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    show(panel, studio, qtbot, GOTO, "forward")
    click(panel, qtbot, 2)
    panel.tools.open("cut")
    cut = panel.tools.cut
    (before,) = cut.ends
    start = QPoint(round(cut.x_of(before)), 50)
    qtbot.mousePress(cut, LEFT, pos=start)
    qtbot.mouseMove(cut, start + QPoint(60, 0))
    assert automaton(studio, GOTO).cuts == ()
    qtbot.mouseRelease(cut, LEFT, pos=start + QPoint(60, 0))
    (kept,) = automaton(studio, GOTO).cuts
    assert isinstance(kept.test, AtMost)
    assert kept.test.threshold > before
    assert studio.document.history.undo_text == "Move a cut of state Forward of Goto"
    learned_again(studio, qtbot, GOTO)
    root = tree_of(studio, GOTO, "forward").root
    assert isinstance(root, Branch)
    assert isinstance(root.no, Branch)
    assert root.no.test == kept.test
    studio.undo()
    assert automaton(studio, GOTO).cuts == ()


def test_an_arc_has_two_cuts_that_arrow_keys_move(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    show(panel, studio, qtbot, GOTO, "forward")
    click(panel, qtbot, 1)
    panel.tools.open("cut")
    start, end = panel.tools.cut.ends
    qtbot.keyClick(panel.tools.cut, Qt.Key.Key_Left)
    (kept,) = automaton(studio, GOTO).cuts
    assert isinstance(kept.test, InArc)
    assert kept.test.start < start
    qtbot.keyClick(panel.tools.cut, Qt.Key.Key_Down)
    qtbot.keyClick(panel.tools.cut, Qt.Key.Key_Right)
    (kept,) = automaton(studio, GOTO).cuts
    assert isinstance(kept.test, InArc)
    assert kept.test.end > end


def test_escape_puts_a_dragged_cut_back(panel: TreePanel, studio: Studio, qtbot: QtBot) -> None:
    show(panel, studio, qtbot, GOTO, "forward")
    click(panel, qtbot, 2)
    panel.tools.open("cut")
    cut = panel.tools.cut
    before = cut.ends
    start = QPoint(round(cut.x_of(before[0])), 50)
    qtbot.mousePress(cut, LEFT, pos=start)
    qtbot.mouseMove(cut, start + QPoint(40, 0))
    with qtbot.waitSignal(panel.refreshed, timeout=PATIENCE):
        qtbot.keyClick(cut, Qt.Key.Key_Escape)
    assert cut.ends == before
    assert not studio.document.history.can_undo


def test_the_pruning_confidence_is_previewed_while_it_is_dragged_and_kept_on_release(
    panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    show(panel, studio, qtbot, GOTO, "forward")
    nodes = len(panel.scene.nodes)
    panel.tools.open("confidence")
    slider = panel.tools.confidence.slider
    slider.setSliderDown(True)
    slider.setSliderPosition(3)
    slider.setSliderPosition(1)
    qtbot.waitUntil(lambda: len(panel.scene.nodes) < nodes, timeout=PATIENCE)
    assert not studio.document.history.can_undo
    slider.setSliderDown(False)
    assert automaton(studio, GOTO).settings.pruning_confidence == 0.01
    assert len(studio.document.history.steps) == 1
    assert len(panel.scene.nodes) < nodes
    before = tree_of(studio, GOTO, "forward")
    qtbot.waitUntil(lambda: tree_of(studio, GOTO, "forward") != before, timeout=PATIENCE)
    qtbot.waitUntil(lambda: panel.previewing.tree is None, timeout=PATIENCE)
    assert len(panel.scene.nodes) < nodes


@pytest.mark.parametrize("page", ["cut", "prunes", "confidence"])
def test_pages_below_the_tree_open_by_their_actions_and_close_by_escape(
    page: str, panel: TreePanel, studio: Studio, qtbot: QtBot
) -> None:
    action = studio.actions["tree.histogram" if page == "cut" else f"tree.{page}"]
    qtbot.waitUntil(action.isEnabled, timeout=PATIENCE)
    action.trigger()
    assert panel.tools.page == page
    assert panel.tools.isAncestorOf(panel.focusWidget())
    qtbot.keyClick(panel.focusWidget(), Qt.Key.Key_Escape)
    assert panel.tools.page == ""
    assert panel.focusWidget() is panel.view
