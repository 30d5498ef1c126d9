"""Where states stand is kept apart from what they do, and changes with them."""

from dataclasses import replace

import pytest

from app.core.edits import (
    delete_automaton,
    duplicate_automaton,
    forget_layout,
    move_states,
    remove_state,
    rename_type,
)
from app.core.errors import EditError
from app.core.project import Project
from tests.samples import AGENT, project

GOTO = AGENT, "goto"


@pytest.fixture
def placed() -> Project:
    return move_states(project(), *GOTO, {"start": (1.0, 2.0), "forward": (30.04, -5.0)})


def test_moving_states_changes_nothing_but_the_layout(placed: Project) -> None:
    assert placed.layout_of(*GOTO) == {"start": (1.0, 2.0), "forward": (30.0, -5.0)}
    assert replace(placed, layouts={}) == project()
    assert placed.libraries is not None


def test_states_that_are_not_moved_stay_where_they_are(placed: Project) -> None:
    moved = move_states(placed, *GOTO, {"forward": (0.0, 0.0)})
    assert moved.layout_of(*GOTO) == {"start": (1.0, 2.0), "forward": (0.0, 0.0)}


def test_moving_nothing_anywhere_else_gives_the_same_project(placed: Project) -> None:
    assert move_states(placed, *GOTO, {"start": (1.0, 2.0)}) is placed


def test_a_layout_that_is_forgotten_leaves_no_trace(placed: Project) -> None:
    assert forget_layout(placed, *GOTO).layouts == {}
    assert forget_layout(placed, *GOTO, ["start"]).layout_of(*GOTO) == {"forward": (30.0, -5.0)}


def test_a_state_that_is_missing_cannot_be_moved() -> None:
    with pytest.raises(EditError, match="no state 'nowhere'"):
        move_states(project(), *GOTO, {"nowhere": (0.0, 0.0)})


def test_a_state_cannot_stand_nowhere() -> None:
    with pytest.raises(EditError, match="finite"):
        move_states(project(), *GOTO, {"start": (float("nan"), 0.0)})


def test_a_removed_state_leaves_the_layout(placed: Project) -> None:
    assert remove_state(placed, *GOTO, "forward").layout_of(*GOTO) == {"start": (1.0, 2.0)}


def test_a_copy_looks_like_its_original(placed: Project) -> None:
    copied, copy = duplicate_automaton(placed, *GOTO)
    assert copied.layout_of(AGENT, copy) == placed.layout_of(*GOTO)


def test_layouts_go_with_their_type_and_their_automaton(placed: Project) -> None:
    assert rename_type(placed, AGENT, "robot").layout_of("robot", "goto") == placed.layout_of(*GOTO)
    copied, copy = duplicate_automaton(placed, *GOTO)
    assert delete_automaton(copied, AGENT, copy).layouts == placed.layouts
