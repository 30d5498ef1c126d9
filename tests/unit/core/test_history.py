"""Undo and redo, what is saved, and what the undo menu says."""

import inspect
import re
import string

import pytest

from app.core import edits
from app.core.automaton import START, Basic
from app.core.edits import SENTENCES, Recorded, describe
from app.core.errors import EditError
from app.core.examples import Example
from app.core.history import Edit, History
from tests.samples import AGENT, project


def begun() -> History:
    return History(project())


def saved(history: History) -> bool:
    return history.is_saved


def test_undo_brings_back_the_very_same_value_and_redo_the_last() -> None:
    history = begun()
    first = history.project
    history.do(edits.rename_state, AGENT, "goto", "left", "turn")
    second = history.project
    history.do(edits.remove_state, AGENT, "goto", "left")
    third = history.project
    assert history.undo() == Edit("Remove state turn from goto", second, third)
    history.undo()
    assert history.project is first
    history.redo()
    history.redo()
    assert history.project is third


def test_a_new_step_ends_what_could_be_redone() -> None:
    history = begun()
    history.do(edits.note_project, "one")
    history.undo()
    history.do(edits.note_project, "two")
    assert not history.can_redo
    assert history.project.note == "two"


def test_the_menu_says_what_would_be_undone_and_redone() -> None:
    history = begun()
    assert (history.undo_text, history.redo_text) == ("", "")
    assert (history.can_undo, history.can_redo) == (False, False)
    history.do(edits.rename_state, AGENT, "goto", "left", "turn")
    assert history.undo_text == "Rename state left of goto to turn"
    history.undo()
    assert (history.undo_text, history.redo_text) == ("", "Rename state left of goto to turn")


def test_nothing_to_undo_or_redo_is_said() -> None:
    with pytest.raises(EditError, match="nothing to undo"):
        begun().undo()
    with pytest.raises(EditError, match="nothing to redo"):
        begun().redo()


def test_an_edit_that_changes_nothing_is_no_step() -> None:
    history = begun()
    history.do(edits.rename_automaton, AGENT, "goto", "goto")
    history.push("Nothing", history.project)
    assert not history.can_undo


def test_an_edit_that_is_refused_leaves_the_history_as_it_was() -> None:
    history = begun()
    with pytest.raises(EditError):
        history.do(edits.remove_state, AGENT, "goto", START)
    assert not history.can_undo
    assert history.project == project()


def test_an_edit_that_makes_something_gives_its_id() -> None:
    assert begun().do(edits.add_state, AGENT, "goto", Basic("Forward")) == "forward-2"
    assert begun().do(edits.note_project, "x") is None


# ------------------------------------------------------------------------------------------- gestures


def test_the_steps_of_one_gesture_are_one() -> None:
    history = begun()
    before = history.project
    for weight in (2.0, 3.0, 4.0):
        history.do(edits.weight_examples, AGENT, "goto", ["1"], weight, gesture="weight 1")
    assert len(history.steps) == 1
    history.undo()
    assert history.project is before
    history.redo()
    assert history.project.examples_of(AGENT, "goto")[0].weight == 4.0


def test_a_gesture_ends_when_something_comes_between() -> None:
    history = begun()
    history.do(edits.note_project, "a", gesture="note")
    history.end_gesture()
    history.do(edits.note_project, "b", gesture="note")
    history.do(edits.note_project, "c", gesture="other")
    history.do(edits.note_project, "d")
    history.do(edits.note_project, "e", gesture="other")
    assert [edit.after.note for edit in history.steps] == ["a", "b", "c", "d", "e"]
    history.undo()
    history.do(edits.note_project, "f", gesture="other")
    assert len(history.steps) == 5


def test_a_gesture_does_not_run_over_what_was_saved() -> None:
    history = begun()
    history.do(edits.note_project, "a", gesture="note")
    history.mark_saved()
    history.do(edits.note_project, "b", gesture="note")
    history.undo()
    assert saved(history)


# ---------------------------------------------------------------------------------------------- saved


def test_the_project_is_saved_where_it_is_the_value_that_was_saved() -> None:
    history = begun()
    assert saved(history)
    history.do(edits.note_project, "a")
    assert not saved(history)
    history.undo()
    assert saved(history)
    history.redo()
    history.mark_saved()
    history.undo()
    assert not saved(history)
    history.redo()
    assert saved(history)


def test_what_was_saved_may_be_older_than_what_there_is() -> None:
    history = begun()
    history.do(edits.note_project, "a")
    older = history.project
    history.do(edits.note_project, "b")
    history.mark_saved(older)
    assert not saved(history)
    history.undo()
    assert saved(history)
    history.mark_unsaved()
    assert not saved(history)


# ---------------------------------------------------------------------------------------------- limits


def test_all_steps_are_kept_unless_a_limit_is_set() -> None:
    history = History(project(), longest=2)
    for note in "abc":
        history.do(edits.note_project, note)
    assert [edit.after.note for edit in history.steps] == ["b", "c"]
    with pytest.raises(EditError, match="1 step or more"):
        History(project(), longest=0)


def test_what_follows_from_a_step_is_undone_with_it() -> None:
    history = begun()
    before = history.project
    history.do(edits.disable_examples, AGENT, "goto", ["1"])
    history.amend(lambda now: edits.set_learned(now, AGENT, "goto", {}, "new"))
    assert len(history.steps) == 1
    assert history.project.library(AGENT).get("goto").learned_from == "new"
    history.undo()
    assert history.project is before
    history.redo()
    assert history.project.library(AGENT).get("goto").learned_from == "new"
    history.amend(lambda now: now)


# ------------------------------------------------------------------------------------------- sentences


def test_every_edit_has_a_sentence_and_is_offered() -> None:
    for edit in SENTENCES:
        assert getattr(edits, edit.__name__) is edit
        assert edit.__name__ in edits.__all__


@pytest.mark.parametrize("edit", SENTENCES, ids=lambda edit: edit.__name__)
def test_a_sentence_names_arguments_of_its_edit(edit: object) -> None:
    assert callable(edit)
    parameters = inspect.signature(edit).parameters
    assert next(iter(parameters)) == "project"
    for _, name, _, _ in string.Formatter().parse(SENTENCES[edit]):
        if name is not None:
            assert re.split(r"\W", name)[0] in parameters
    assert SENTENCES[edit][0].isupper()


def test_sentences_show_names_and_not_ids() -> None:
    named = edits.rename_automaton(project(), AGENT, "goto", "Go To")
    named = edits.rename_state(named, AGENT, "goto", "left", "turn")
    assert describe(edits.remove_state, named, AGENT, "goto", "left") == "Remove state turn from Go To"
    assert (
        describe(edits.add_state, named, AGENT, "goto", content=Basic("Forward"))
        == "Add state Forward to Go To"
    )
    assert (
        describe(edits.drop_feature, named, AGENT, "goto", "distance")
        == "Drop feature DistanceTo(target) of Go To"
    )
    recorded = Recorded(AGENT, "goto", (Example("", "forward", "left", {}),))
    assert describe(edits.record_pick, named, recorded) == "Pick turn in Go To"
    added = Recorded(
        AGENT,
        "goto",
        state=edits.add_state(named, AGENT, "goto", Basic("GrabBox"))[0]
        .library(AGENT)
        .get("goto")
        .states[-1],
    )
    assert describe(edits.take_back_pick, named, added) == "Take back GrabBox in Go To"
    assert describe(edits.record_pick, named, Recorded(AGENT, "gone", recorded.examples)) == "Pick left"


def test_a_step_with_a_mark_is_kept_though_the_project_stays_the_same() -> None:
    history = begun()
    before = history.project
    history.push("Move agent-1", before, mark="moved")
    assert history.last is not None
    assert (history.last.text, history.last.mark, history.is_saved) == ("Move agent-1", "moved", True)
    assert history.undo().mark == "moved"
    assert history.next is not None
    assert history.next.mark == "moved"
