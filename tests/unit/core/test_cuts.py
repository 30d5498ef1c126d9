"""A cut that the user moved stands whatever is learned, and moves nothing but the boundary."""

from dataclasses import replace

import pytest

from app.core.automaton import Cut
from app.core.conditions import AtMost, Condition, Equals, InArc
from app.core.cuts import stands, with_cuts
from app.core.edits import drop_feature, move_cut, remove_cut, remove_state
from app.core.errors import EditError
from app.core.project import Project
from app.core.storage import load, save
from app.core.tree import Branch, Leaf, Tree
from app.learner.trainer import apply, is_stale, learn
from tests.samples import AGENT, goto, project, vocabulary

GOTO = AGENT, "goto"
FAR = (Condition(AtMost("distance", 2.0), wanted=False),)


def tree_of(changed: Project, state: str = "forward") -> Tree:
    tree = changed.library(AGENT).get("goto").learned[state]
    assert isinstance(tree, Tree)
    return tree


def moved_a_bit(test: AtMost | Equals | InArc) -> AtMost | InArc:
    assert not isinstance(test, Equals)
    if isinstance(test, AtMost):
        return replace(test, threshold=test.threshold + 1.0)
    return replace(test, start=test.start - 0.1)


def test_a_moved_cut_changes_one_test_and_no_count() -> None:
    changed, number = move_cut(project(), *GOTO, "forward", FAR, InArc("direction", -1.0, 1.0))
    before, after = tree_of(project()), tree_of(changed)
    assert isinstance(after.root, Branch)
    assert isinstance(before.root, Branch)
    assert after.root.test == before.root.test
    assert isinstance(after.root.no, Branch)
    assert replace(after.root.no, test=InArc("direction", -0.5, 0.5)) == before.root.no
    assert changed.library(AGENT).get("goto").cuts == (
        Cut(number, "forward", FAR, InArc("direction", -1.0, 1.0)),
    )


def test_moving_it_again_changes_the_same_cut() -> None:
    changed, first = move_cut(project(), *GOTO, "forward", (), AtMost("distance", 3.0))
    changed, second = move_cut(changed, *GOTO, "forward", (), AtMost("distance", 4.0))
    assert first == second
    assert [cut.test for cut in changed.library(AGENT).get("goto").cuts] == [AtMost("distance", 4.0)]


def test_a_cut_is_found_by_features_and_outcomes_not_by_numbers() -> None:
    cut = Cut("1", "forward", FAR, InArc("direction", -1.0, 1.0))
    shifted = with_cuts(tree_of(project()), [Cut("2", "forward", (), AtMost("distance", 77.0))])
    assert stands(shifted, cut)
    assert not stands(Tree(shifted.labels, Leaf((1.0, 0.0, 0.0))), cut)
    assert with_cuts(Tree(shifted.labels, Leaf((1.0, 0.0, 0.0))), [cut]).root == Leaf((1.0, 0.0, 0.0))


def test_a_cut_survives_learning_and_learning_takes_it_back_once_it_is_gone() -> None:
    learned = apply(project(), learn(project(), vocabulary(), [GOTO]))
    tree = tree_of(learned)
    assert isinstance(tree.root, Branch)
    mine = moved_a_bit(tree.root.test)
    moved, number = move_cut(learned, *GOTO, "forward", (), mine)
    assert is_stale(moved, *GOTO)
    again = apply(moved, learn(moved, vocabulary(), [GOTO]))
    root = tree_of(again).root
    assert isinstance(root, Branch)
    assert root.test == mine
    assert not is_stale(again, *GOTO)
    back = remove_cut(again, *GOTO, number)
    assert is_stale(back, *GOTO)
    assert tree_of(apply(back, learn(back, vocabulary(), [GOTO]))) == tree


def test_what_a_project_learned_before_there_were_cuts_is_not_stale() -> None:
    assert goto().cuts == ()
    learned = apply(project(), learn(project(), vocabulary(), [GOTO]))
    assert not is_stale(learned, *GOTO)


def test_only_cuts_that_are_there_can_be_moved() -> None:
    with pytest.raises(EditError, match="does not test 'direction' there"):
        move_cut(project(), *GOTO, "forward", (), InArc("direction", 0.0, 1.0))
    with pytest.raises(EditError, match="has no tree"):
        move_cut(project(), *GOTO, "done", (), AtMost("distance", 1.0))
    with pytest.raises(EditError, match="no cut that could be moved"):
        move_cut(project(), *GOTO, "forward", (), Equals("distance", 1.0))


def test_cuts_go_with_their_state_and_their_feature() -> None:
    changed, _ = move_cut(project(), *GOTO, "forward", FAR, InArc("direction", -1.0, 1.0))
    assert remove_state(changed, *GOTO, "forward").library(AGENT).get("goto").cuts == ()
    assert drop_feature(changed, *GOTO, "direction", force=True).library(AGENT).get("goto").cuts == ()


def test_cuts_are_kept_on_disk(tmp_path_factory: pytest.TempPathFactory) -> None:
    plain = replace(project(), examples={}, moments={})
    changed, _ = move_cut(plain, *GOTO, "forward", FAR, InArc("direction", -1.0, 1.0))
    folder = tmp_path_factory.mktemp("cuts")
    save(changed, folder)
    assert load(folder) == changed
